/*
 * wall_touch.c -- contact points with walls: distance to planes and curved walls, nearest points of
 * triangles, removal of duplicates.
 *
 * A moving wall is treated in its own reference frame; the contact point and the normal are
 * returned in the fixed frame.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_touch.h"
#include "core/error.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

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

static void touch_triangles(const struct dem_wall_search *s, const struct dem_walls *w,
                            const struct dem_wall_neighbor *near, const double x[3], double radius,
                            struct dem_wall_touch *t)
{
    double moved[3], away[3];

    t->distance = dem_wall_search_nearest(s, w, near, x, t->point, away);
    dem_facet_touch_triangles(&w->facet[near->facet], dem_wall_from_facet(w, near, x, moved), x, away,
                              radius, t);
}

/* Contact with a facet, or (whole) with its plane or surface, unbounded. */
static void touch_facet(const struct dem_wall_search *s, const struct dem_walls *w,
                         const struct dem_wall_neighbor *near, const struct dem_particle *i,
                         int whole, struct dem_wall_touch *t)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    const int frame = w->wall[r->wall].frame;
    struct dem_wall_touch own;
    double scratch[3], moved[3];
    const double *const x = dem_walls_to_frame(w, r->wall, i->x, scratch);

    if (whole || dem_wall_neighbor_open(w, near))
    {
        t->distance =
            dem_facet_touch(r, dem_wall_from_facet(w, near, x, moved), x, t->point, t->normal);
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

/* ---- several facets: facet_contacts.h -------------------------------------------------------- */

struct dem_facets_near    /* facet k: wall neighbor k of the search */
{
    const struct dem_wall_search *s;
    const struct dem_walls *w;
    const struct dem_particle *i;
};

static int dem_facets_near_whole(const struct dem_facets_near *v, size_t k)
{
    const struct dem_wall_neighbor *const near = &v->s->neighbor[k];

    return v->w->facet[near->facet].bent || dem_wall_neighbor_open(v->w, near);
}

static int dem_facets_near_lies_on(const struct dem_facets_near *v, size_t k, const double point[3],
                                   double tolerance)
{
    return fabs(dem_wall_search_distance(v->s, v->w, &v->s->neighbor[k], point)) < tolerance;
}

static void dem_facets_near_inner(const struct dem_facets_near *v, size_t k, const double at[3],
                                  double point[3])
{
    const struct dem_wall_neighbor *const near = &v->s->neighbor[k];
    const int wall = v->w->facet[near->facet].wall, frame = v->w->wall[wall].frame;
    double scratch[3], middle[3], moved[3];
    const double *const x = dem_walls_to_frame(v->w, wall, at, scratch);
    const uint32_t candidate = dem_wall_neighbor_candidate(v->s, v->w, near, x);
    const struct dem_triangle *const t = &v->w->triangle[v->s->candidate[candidate]];
    const double *const from = dem_wall_from_candidate(v->s, v->w, candidate, x, moved);

    for (int k = 0; k < 3; k++)
    {
        middle[k] = (t->corner[0][k] + t->corner[1][k] + t->corner[2][k])/3.0;
        middle[k] += from == x ? 0.0 : x[k] - from[k];
        point[k] = middle[k];
    }
    if (frame >= 0)
    {
        dem_pose_point(&v->w->frame[frame].pose, middle, point);
    }
}

static void dem_facets_near_continue(const struct dem_facets_near *v, size_t k, const double x[3],
                                     struct dem_wall_touch *touch)
{
    (void)x;
    touch_facet(v->s, v->w, &v->s->neighbor[k], v->i, 1, touch);
}

#include "walls/facet_contacts.h"

enum { AHEAD = 16 };    /* wall neighbors whose particles are prefetched */

static void prefetch_particle(const struct dem_wall_touches *t, const struct dem_wall_search *s,
                              const struct dem_particles *p, size_t k)
{
    if (k < t->listed)
    {
        __builtin_prefetch(p->record[s->neighbor[t->list[k]].particle].x);
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
            prefetch_particle(t, s, p, k + AHEAD);
            touch_facet(s, w, &s->neighbor[last], i, 0, &t->touch[last]);
            t->touch[last].drop = 0;
            touching += t->touch[last].distance < i->radius;
        }
        if (touching > 1)
        {
            const struct dem_facets_near near = {.s = s, .w = w, .i = i};

            dem_contact_drop_duplicates(&(struct dem_facet_contacts){
                .near = &near, .touch = t->touch, .first = first, .end = last + 1,
                .x = {i->x[0], i->x[1], i->x[2]}, .radius = i->radius});
            t->shared_first[t->shared++] = first;
        }
    }
}
