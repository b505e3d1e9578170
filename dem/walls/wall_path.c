/*
 * wall_path.c -- cut a straight path into pieces of a radius, and test each against the triangles and
 * solid cylinders and spheres around it.
 *
 * A line from a to b passes through the triangle pqr when a and b are on different sides of its
 * plane, and the volumes of the tetrahedra (a, b, p, q), (a, b, q, r) and (a, b, r, p) have one
 * sign. A volume changes its sign exactly with the order of an edge's ends, so no line slips through
 * the common edge of two triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_path.h"
#include "core/error.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* A piece reaches beyond its ends by this fraction of its length, far above round-off. */
static const double margin = 1e-6;

enum
{
    MAX_PIECES = 100000
};

/* Six times the volume of the tetrahedron (a, a + ab, p, q). */
static double volume(const double a[3], const double ab[3], const double p[3], const double q[3])
{
    double ap[3], aq[3], n[3];

    dem_vec_minus(p, a, ap);
    dem_vec_minus(q, a, aq);
    dem_vec_cross(ap, aq, n);
    return dem_vec_dot(ab, n);
}

static double height(const struct dem_triangle *t, const double x[3])
{
    double pq[3], pr[3], px[3], n[3];

    dem_vec_minus(t->corner[1], t->corner[0], pq);
    dem_vec_minus(t->corner[2], t->corner[0], pr);
    dem_vec_minus(x, t->corner[0], px);
    dem_vec_cross(pq, pr, n);
    return dem_vec_dot(px, n);
}

static int meets_triangle(const struct dem_triangle *t, const double a[3], const double b[3])
{
    double ab[3], v[3];

    if ((height(t, a) > 0.0) == (height(t, b) > 0.0))
    {
        return 0;
    }
    dem_vec_minus(b, a, ab);
    for (int k = 0; k < 3; k++)
    {
        v[k] = volume(a, ab, t->corner[k], t->corner[(k + 1)%3]);
    }
    return (v[0] >= 0.0 && v[1] >= 0.0 && v[2] >= 0.0) ||
           (v[0] <= 0.0 && v[1] <= 0.0 && v[2] <= 0.0);
}

/* Nearest approach to the axis of a cylinder or the centre of a sphere. */
static int meets_solid(const struct dem_facet *r, const double a[3], const double b[3])
{
    double ca[3], ab[3], d[3];

    dem_vec_minus(a, r->centre, ca);
    dem_vec_minus(b, a, ab);
    if (r->shape == DEM_SHAPE_CYLINDER)
    {
        const double along[2] = {dem_vec_dot(ca, r->normal), dem_vec_dot(ab, r->normal)};

        for (int k = 0; k < 3; k++)
        {
            ca[k] -= along[0]*r->normal[k];
            ab[k] -= along[1]*r->normal[k];
        }
    }
    const double square = dem_vec_dot(ab, ab),
                 t = square > 0.0 ? -dem_vec_dot(ca, ab)/square : 0.0,
                 nearest = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;

    for (int k = 0; k < 3; k++)
    {
        d[k] = ca[k] + nearest*ab[k];
    }
    return dem_vec_dot(d, d) < r->radius*r->radius;
}

/* The walls with this reference frame (-1: at rest); a and b are in the global frame. */
static int piece_passes(struct dem_wall_search *s, const struct dem_walls *w, int frame,
                        const double a[3], const double b[3], int *passes)
{
    double from[3], to[3], middle[3], along[3];

    memcpy(from, a, sizeof from);
    memcpy(to, b, sizeof to);
    if (frame >= 0)
    {
        dem_pose_to_frame(&w->frame[frame].pose, a, from);
        dem_pose_to_frame(&w->frame[frame].pose, b, to);
    }
    for (int r = 0; r < w->facets && w->facet[r].shape != DEM_SHAPE_TRIANGLES; r++)
    {
        *passes |= w->facet[r].shape != DEM_SHAPE_PLANE && w->facet[r].outside &&
                   w->wall[w->facet[r].wall].frame == frame &&
                   !w->wall[w->facet[r].wall].absent && meets_solid(&w->facet[r], from, to);
    }
    if (w->triangles > 0)
    {
        const size_t first = s->candidates;

        dem_vec_minus(to, from, along);
        for (int k = 0; k < 3; k++)
        {
            middle[k] = from[k] + 0.5*along[k];
        }
        DEM_TRY(dem_wall_search_gather(s, w, frame, middle,
                                       (0.5 + margin)*dem_vec_norm(along)));
        for (size_t c = first; c < s->candidates; c++)
        {
            double here[3], there[3];

            *passes |= !w->wall[w->triangle[s->candidate[c]].wall].absent && meets_triangle(&w->triangle[s->candidate[c]],
                                      dem_wall_from_candidate(s, w, (uint32_t)c, from, here),
                                      dem_wall_from_candidate(s, w, (uint32_t)c, to, there));
        }
        s->candidates = first;
    }
    return DEM_OK;
}

int dem_wall_path_passes(struct dem_wall_search *s, const struct dem_walls *w,
                         const struct dem_domain *domain, double radius, const double from[3],
                         const double to[3], int *passes)
{
    double along[3];

    *passes = 0;
    if (w->triangles > 0 && w->path_length > s->path_length)
    {
        DEM_TRY(dem_wall_search_prepare(s, w, s->radius));
    }
    dem_vec_minus(to, from, along);
    const double length = dem_vec_norm(along);
    const int pieces = (int)fmin(MAX_PIECES, floor(length/radius) + 1.0);

    for (int k = 0; k < pieces && !*passes && length > 0.0; k++)
    {
        struct dem_particle begin = {.radius = radius};
        double end[3];

        for (int c = 0; c < 3; c++)
        {
            begin.x[c] = from[c] + (double)k/pieces*along[c];
            end[c] = k + 1 < pieces ? from[c] + (double)(k + 1)/pieces*along[c] : to[c];
        }
        const double before[3] = {begin.x[0], begin.x[1], begin.x[2]};

        dem_domain_wrap(domain, &begin);
        for (int c = 0; c < 3; c++)
        {
            end[c] += begin.x[c] - before[c];
        }
        for (int frame = -1; frame < w->frames; frame++)
        {
            DEM_TRY(piece_passes(s, w, frame, begin.x, end, passes));
        }
    }
    return DEM_OK;
}
