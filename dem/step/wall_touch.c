/*
 * wall_touch.c -- plane distances for open nears, nearest points for the others, and the removal of doubles.
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
    memset(t, 0, sizeof *t);
}

int dem_wall_touches_fit(struct dem_wall_touches *t, const struct dem_wall_search *s)
{
    return DEM_GROW(t->touch, t->room, s->nears + 1);
}

static void touch_plane(const struct dem_region *r, const double x[3], struct dem_wall_touch *t)
{
    const double h = dem_vec_dot(r->normal, x) - r->offset;
    const double side = r->one_sided || h >= 0.0 ? 1.0 : -1.0;

    t->distance = side*h;
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = side*r->normal[k];
        t->point[k] = x[k] - h*r->normal[k];
    }
}

/* The nearest point of a list of triangles of one region. */
static double nearest_of(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                         const double x[3], double point[3])
{
    double best = DBL_MAX, here[3];

    for (uint32_t c = near->first; c < near->first + near->count; c++)
    {
        const double square = dem_triangle_nearest(&w->triangle[s->candidate[c]], x, here);

        if (square < best)
        {
            best = square;
            memcpy(point, here, sizeof here);
        }
    }
    return sqrt(best);
}

static void touch_triangles(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                            const double x[3], double radius, struct dem_wall_touch *t)
{
    struct dem_wall_touch face;
    double away[3];

    t->distance = nearest_of(s, w, near, x, t->point);
    touch_plane(&w->region[near->region], x, &face);
    dem_vec_minus(face.point, t->point, away);
    if (dem_vec_norm(away) < same_point*radius || t->distance == 0.0)
    {
        *t = face;                                        /* on the flat: the plane's own normal, free of the seams' round-off */
        return;
    }
    for (int k = 0; k < 3; k++)
    {
        t->normal[k] = (x[k] - t->point[k])/t->distance;
    }
}

/* 1 when a point lies on the region of a near. */
static int lies_on(const struct dem_wall_search *s, const struct dem_walls *w, const struct dem_wall_near *near,
                   const double point[3], double tolerance)
{
    double on[3];

    if (near->open)
    {
        const struct dem_region *const r = &w->region[near->region];

        return fabs(dem_vec_dot(r->normal, point) - r->offset) < tolerance;
    }
    return nearest_of(s, w, near, point, on) < tolerance;
}

/* 1 when region a's nearest point belongs to region b as well and b is to keep it: b is nearer (then its own nearest point
   is not on a), or both have the same nearest point and b comes first. */
static int yields(const struct dem_wall_search *s, const struct dem_walls *w, size_t a, size_t b, double tolerance,
                  const struct dem_wall_touch *touch)
{
    return touch[b].distance < touch[a].distance + tolerance && lies_on(s, w, &s->near[b], touch[a].point, tolerance)
        && (b < a || !lies_on(s, w, &s->near[a], touch[b].point, tolerance));
}

/* Marked first, dropped after: a region may yield to one that yields itself, down to the nearest of a curved surface. */
static void drop_doubles(const struct dem_wall_search *s, const struct dem_walls *w, size_t first, size_t end, double radius,
                         struct dem_wall_touch *touch)
{
    for (size_t a = first; a < end; a++)
    {
        touch[a].drop = 0;
        for (size_t b = first; b < end && !touch[a].drop && touch[a].distance < radius; b++)
        {
            touch[a].drop = b != a && yields(s, w, a, b, same_point*radius, touch);
        }
    }
    for (size_t a = first; a < end; a++)
    {
        touch[a].distance = touch[a].drop ? DBL_MAX : touch[a].distance;
    }
}

void dem_wall_touches_update(struct dem_wall_touches *t, const struct dem_wall_search *s, const struct dem_walls *w,
                             const struct dem_particles *p)
{
    size_t first = 0;

    while (first < s->nears)
    {
        const struct dem_particle *const i = &p->record[s->near[first].particle];
        size_t end = first;
        int closed = 0;

        for (; end < s->nears && s->near[end].particle == s->near[first].particle; end++)
        {
            const struct dem_wall_near *const near = &s->near[end];

            closed |= !near->open;
            if (near->open)
            {
                touch_plane(&w->region[near->region], i->x, &t->touch[end]);
            }
            else
            {
                touch_triangles(s, w, near, i->x, i->radius, &t->touch[end]);
            }
        }
        if (closed)
        {
            drop_doubles(s, w, first, end, i->radius, t->touch);
        }
        first = end;
    }
}
