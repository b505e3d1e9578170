/*
 * wall_touch.c -- heights for open nears, nearest points for the others, and the removal of doubles. A wall that moves is
 * touched in its own frame; the touch is told in the world's.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_touch.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* Points nearer than this fraction of the radius are one point: far above round-off, far below any overlap that matters. */
static const double same_point = 1e-7;

void dem_wall_touches_free(struct dem_wall_touches *t)
{
    dem_memory_free(t->touch);
    dem_memory_free(t->share);
    dem_memory_free(t->list);
    memset(t, 0, sizeof *t);
}

int dem_wall_touches_fit(struct dem_wall_touches *t, const struct dem_wall_search *s)
{
    t->shared = t->listed = 0;
    DEM_TRY(DEM_GROW(t->list, t->list_room, s->nears + 1));
    DEM_TRY(DEM_GROW(t->touch, t->room, s->nears + 1));
    return DEM_GROW(t->share, t->shared_room, s->nears + 1);
}

void dem_wall_touches_rows(struct dem_wall_touches *t, const struct dem_wall_search *s, const struct dem_contacts *c)
{
    for (size_t k = 0; k < s->nears; k++)
    {
        t->touch[k].row = DEM_ROW_NONE;
    }
    for (uint32_t r = 0; r < c->rows && s->nears > 0; r++)
    {
        const struct dem_pair *const q = c->row_pair[r] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[r]];

        if (q && q->wall)
        {
            t->touch[q->j].row = r;
        }
    }
    t->listed = 0;
    for (size_t k = 0; k < s->nears; k++)
    {
        if (t->touch[k].row != DEM_ROW_NONE)
        {
            t->list[t->listed++] = (uint32_t)k;
        }
        t->touch[k].distance = DBL_MAX;
        t->touch[k].drop = 0;
    }
}

/* Triangles have two sides, all else has one. */
static inline void touch_whole(const struct dem_region *r, const double x[3], struct dem_wall_touch *t)
{
    const int flat = r->shape == DEM_SHAPE_PLANE || r->shape == DEM_SHAPE_TRIANGLES;
    double round[3];
    const double *const normal = flat ? r->normal : round;
    const double h = flat ? dem_vec_dot(r->normal, x) - r->offset : dem_region_height(r, x, round);
    const double side = r->shape != DEM_SHAPE_TRIANGLES || h >= 0.0 ? 1.0 : -1.0;

    t->distance = side*h;
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = side*normal[k];
        t->point[k] = x[k] - h*normal[k];
    }
}

static void touch_triangles(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                            const double x[3], double radius, struct dem_wall_touch *t)
{
    struct dem_wall_touch face;
    double away[3];

    t->distance = dem_wall_search_nearest(s, w, near, x, t->point);
    touch_whole(&w->region[near->region], x, &face);
    dem_vec_minus(face.point, t->point, away);
    if ((dem_vec_norm(away) < same_point*radius && !w->region[near->region].bent) || t->distance == 0.0)
    {
        touch_whole(&w->region[near->region], x, t);      /* on the flat: the plane's own normal, free of the seams' round-off */
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = (x[k] - t->point[k])/t->distance;
    }
}

static void touch_region(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                         const struct dem_particle *i, struct dem_wall_touch *t)
{
    const struct dem_region *const r = &w->region[near->region];
    const int moving = w->wall[r->wall].moving;
    struct dem_wall_touch own;
    double room[3];
    const double *const x = dem_walls_own(w, r->wall, i->x, room);

    if (dem_wall_near_open(w, near))
    {
        touch_whole(r, x, t);
    }
    else
    {
        touch_triangles(s, w, near, x, i->radius, t);
    }
    if (moving >= 0)
    {
        own = *t;
        dem_pose_direction(&w->moving[moving].pose, own.normal, t->normal);
        dem_pose_point(&w->moving[moving].pose, own.point, t->point);
    }
}

/* 1 when a point of the world lies on the region of a near. */
static int lies_on(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                   const double point[3], double tolerance)
{
    const struct dem_region *const r = &w->region[near->region];
    double on[3], room[3], normal[3];
    const double *const x = dem_walls_own(w, r->wall, point, room);

    if (dem_wall_near_open(w, near))
    {
        return fabs(dem_region_height(r, x, normal)) < tolerance;
    }
    return dem_wall_search_nearest(s, w, near, x, on) < tolerance;
}

/* 1 when b goes before a: an order of all touches, so never two that give way to each other. */
static int goes_before(size_t b, size_t a, const struct dem_wall_touch *touch)
{
    return touch[b].distance < touch[a].distance || (touch[b].distance <= touch[a].distance && b < a);
}

static double square_apart(size_t a, size_t b, const struct dem_wall_touch *touch)
{
    double apart[3];

    dem_vec_minus(touch[a].point, touch[b].point, apart);
    return dem_vec_dot(apart, apart);
}

/* 1 when a gives way to b, which goes before it: its nearest point belongs to region b as well, or the areas of contact of both,
   circles of radius sqrt(R d) about points nearer to each other than that, are one. */
static int yields(const struct dem_wall_search *s, const struct dem_walls *w, size_t a, size_t b, double radius,
                  const struct dem_wall_touch *touch)
{
    return goes_before(b, a, touch)
        && (square_apart(a, b, touch) < radius*(radius - touch[b].distance)
            || lies_on(s, w, &s->near[b], touch[a].point, same_point*radius));
}

/* Of regions that touch in the same point the first is to have the contact: which of them goes before the others is round-off
   there, and what the contact remembers stays in one place. */
static size_t first_there(size_t of, size_t first, double tolerance, const struct dem_wall_touch *touch)
{
    size_t a = first;

    while (a < of && (touch[a].distance >= DBL_MAX || square_apart(a, of, touch) >= tolerance*tolerance))
    {
        a++;
    }
    return a;
}

/* Marked first, dropped after: a region may yield to one that yields itself, down to the nearest of a curved surface. */
static void drop_doubles(const struct dem_wall_search *s, const struct dem_walls *w, size_t first, size_t end, double radius,
                         struct dem_wall_touch *touch)
{
    for (size_t a = first; a < end; a++)
    {
        for (size_t b = first; b < end && !touch[a].drop && touch[a].distance < radius; b++)
        {
            touch[a].drop = b != a && yields(s, w, a, b, radius, touch);
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

/* Who has no row is too far away to touch or to take a contact from another, until lists are pruned again. */
void dem_wall_touches_update(struct dem_wall_touches *t, const struct dem_wall_search *s, const struct dem_walls *w,
                             const struct dem_particles *p)
{
    size_t k = 0;

    t->shared = 0;
    while (k < t->listed)
    {
        const uint32_t first = t->list[k], particle = s->near[first].particle;
        const struct dem_particle *const i = &p->record[particle];
        uint32_t last = first;
        int live = 0;

        for (; k < t->listed && s->near[t->list[k]].particle == particle; k++)
        {
            last = t->list[k];
            touch_region(s, w, &s->near[last], i, &t->touch[last]);
            t->touch[last].drop = 0;
            live += t->touch[last].distance < i->radius;
        }
        if (live > 1)
        {
            drop_doubles(s, w, first, last + 1, i->radius, t->touch);
            t->share[t->shared++] = first;
        }
    }
}
