/*
 * wall_touch.c -- contact points with walls: distance to planes and curved walls, nearest points of
 * triangles, removal of duplicates.
 *
 * A moving wall is treated in its own reference frame; the contact point and the normal are
 * returned in the fixed frame.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "neighbor/wall_touch.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* Points nearer than this fraction of the radius are one point: far above round-off, far below any
   overlap that matters. */
static const double same_point = 1e-7;

void dem_wall_touches_free(struct dem_wall_touches *t)
{
    dem_memory_free(t->touch);
    dem_memory_free(t->shared_first);
    dem_memory_free(t->list);
    memset(t, 0, sizeof *t);
}

int dem_wall_touches_reserve(struct dem_wall_touches *t, const struct dem_wall_search *s)
{
    t->shared = t->listed = 0;
    DEM_TRY(DEM_GROW(t->list, t->list_capacity, s->neighbors + 1));
    DEM_TRY(DEM_GROW(t->touch, t->capacity, s->neighbors + 1));
    return DEM_GROW(t->shared_first, t->shared_capacity, s->neighbors + 1);
}

void dem_wall_touches_set_rows(struct dem_wall_touches *t, const struct dem_wall_search *s,
                               const struct dem_contacts *c)
{
    for (size_t k = 0; k < s->neighbors; k++)
    {
        t->touch[k].row = DEM_ROW_NONE;
    }
    for (uint32_t r = 0; r < c->rows && s->neighbors > 0; r++)
    {
        const struct dem_pair *const q =
            c->row_pair[r] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[r]];

        if (q && q->wall)
        {
            t->touch[q->j].row = r;
        }
    }
    t->listed = 0;
    for (size_t k = 0; k < s->neighbors; k++)
    {
        if (t->touch[k].row != DEM_ROW_NONE)
        {
            t->list[t->listed++] = (uint32_t)k;
        }
        t->touch[k].distance = DBL_MAX;
        t->touch[k].drop = 0;
    }
}

/* The whole plane or curved surface of a facet. Triangles have two sides, all other shapes one. */
static inline void touch_whole(const struct dem_facet *r, const double x[3],
                               struct dem_wall_touch *t)
{
    const int flat = r->shape == DEM_SHAPE_PLANE || r->shape == DEM_SHAPE_TRIANGLES;
    double round[3];
    const double *const normal = flat ? r->normal : round;
    const double h = flat ? dem_vec_dot(r->normal, x) - r->offset : dem_facet_height(r, x, round);
    const double side = r->shape != DEM_SHAPE_TRIANGLES || h >= 0.0 ? 1.0 : -1.0;

    t->distance = side*h;
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = side*normal[k];
        t->point[k] = x[k] - h*normal[k];
    }
}

static void touch_triangles(const struct dem_wall_search *s, const struct dem_walls *w,
                            const struct dem_wall_neighbor *near, const double x[3], double radius,
                            struct dem_wall_touch *t)
{
    struct dem_wall_touch face;
    double away[3];

    t->distance = dem_wall_search_nearest(s, w, near, x, t->point);
    touch_whole(&w->facet[near->facet], x, &face);
    dem_vec_minus(face.point, t->point, away);
    if ((dem_vec_norm(away) < same_point*radius && !w->facet[near->facet].bent) ||
        t->distance == 0.0)
    {
        /* inside a facet: the plane's own normal, free of the round-off at edges */
        touch_whole(&w->facet[near->facet], x, t);
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = (x[k] - t->point[k])/t->distance;
    }
}

static void touch_facet(const struct dem_wall_search *s, const struct dem_walls *w,
                         const struct dem_wall_neighbor *near, const struct dem_particle *i,
                         struct dem_wall_touch *t)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    const int frame = w->wall[r->wall].frame;
    struct dem_wall_touch own;
    double scratch[3];
    const double *const x = dem_walls_to_frame(w, r->wall, i->x, scratch);

    if (dem_wall_neighbor_open(w, near))
    {
        touch_whole(r, x, t);
    }
    else
    {
        touch_triangles(s, w, near, x, i->radius, t);
    }
    if (frame >= 0)
    {
        own = *t;
        dem_pose_direction(&w->frame[frame].pose, own.normal, t->normal);
        dem_pose_point(&w->frame[frame].pose, own.point, t->point);
    }
}

/* 1 when a point, in the fixed frame, lies on the facet of a wall neighbor. */
static int lies_on(const struct dem_wall_search *s, const struct dem_walls *w,
                   const struct dem_wall_neighbor *near, const double point[3], double tolerance)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    double on[3], scratch[3], normal[3];
    const double *const x = dem_walls_to_frame(w, r->wall, point, scratch);

    if (dem_wall_neighbor_open(w, near))
    {
        return fabs(dem_facet_height(r, x, normal)) < tolerance;
    }
    return dem_wall_search_nearest(s, w, near, x, on) < tolerance;
}

/* 1 when b takes precedence over a: a strict order, so that no two contacts are dropped in favour
   of each other. */
static int takes_precedence(size_t b, size_t a, const struct dem_wall_touch *touch)
{
    return touch[b].distance < touch[a].distance ||
           (touch[b].distance <= touch[a].distance && b < a);
}

static double square_apart(size_t a, size_t b, const struct dem_wall_touch *touch)
{
    double apart[3];

    dem_vec_minus(touch[a].point, touch[b].point, apart);
    return dem_vec_dot(apart, apart);
}

/* 1 when contact a duplicates b, which takes precedence: the nearest point of a belongs to facet b
   as well, or the contact areas of both, circles of radius sqrt(R d), overlap: the points are
   nearer to each other than this radius. */
static int duplicates(const struct dem_wall_search *s, const struct dem_walls *w, size_t a,
                      size_t b, double radius, const struct dem_wall_touch *touch)
{
    return takes_precedence(b, a, touch)
        && (square_apart(a, b, touch) < radius*(radius - touch[b].distance)
            || lies_on(s, w, &s->neighbor[b], touch[a].point, same_point*radius));
}

/* Of facets that touch in the same point the first gets the contact. There the order by distance
   is round-off, and the contact history has to stay with one facet. */
static size_t first_there(size_t of, size_t first, double tolerance,
                          const struct dem_wall_touch *touch)
{
    size_t a = first;

    while (a < of &&
           (touch[a].distance >= DBL_MAX || square_apart(a, of, touch) >= tolerance*tolerance))
    {
        a++;
    }
    return a;
}

/* Mark first, drop afterwards: a contact may duplicate one that is a duplicate itself, down to the
   nearest one of a curved surface. */
static void drop_duplicates(const struct dem_wall_search *s, const struct dem_walls *w,
                            size_t first, size_t end, double radius, struct dem_wall_touch *touch)
{
    for (size_t a = first; a < end; a++)
    {
        for (size_t b = first; b < end && !touch[a].drop && touch[a].distance < radius; b++)
        {
            touch[a].drop = b != a && duplicates(s, w, a, b, radius, touch);
        }
    }
    for (size_t a = first; a < end; a++)
    {
        if (!touch[a].drop && touch[a].distance < radius)
        {
            touch[a].drop = 1;
            touch[first_there(a, first, same_point*radius, touch)].drop = 0;
        }
    }
    for (size_t a = first; a < end; a++)
    {
        touch[a].distance = touch[a].drop ? DBL_MAX : touch[a].distance;
    }
}

/* A wall neighbor without a row is too far away to touch or to take over a contact, until lists are
   pruned again. */
void dem_wall_touches_update(struct dem_wall_touches *t, const struct dem_wall_search *s,
                             const struct dem_walls *w, const struct dem_particles *p)
{
    size_t k = 0;

    t->shared = 0;
    while (k < t->listed)
    {
        const uint32_t first = t->list[k], particle = s->neighbor[first].particle;
        const struct dem_particle *const i = &p->record[particle];
        uint32_t last = first;
        int touching = 0;

        for (; k < t->listed && s->neighbor[t->list[k]].particle == particle; k++)
        {
            last = t->list[k];
            touch_facet(s, w, &s->neighbor[last], i, &t->touch[last]);
            t->touch[last].drop = 0;
            touching += t->touch[last].distance < i->radius;
        }
        if (touching > 1)
        {
            drop_duplicates(s, w, first, last + 1, i->radius, t->touch);
            t->shared_first[t->shared++] = first;
        }
    }
}
