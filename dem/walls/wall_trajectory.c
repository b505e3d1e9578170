/*
 * wall_trajectory.c -- walls that follow a mesh: each corner moves on a straight line during an
 * advance.
 *
 * The coupling gives the positions of the corners at the end of the advance; on the way
 *
 *   x(t) = from + (to - from) (t - t0)/T,    v = (to - from)/T
 *
 *   from, to   corner at the beginning t0 and the end of the advance                       [m]
 *   T          length of the advance                                                   [s]
 *
 * A wall that rotates by the angle a within an advance moves on the chord, at half way a^2/8 of its
 * radius inside the circle.
 *
 * Inside a triangle v is linear. Its surface gradient, with the edges e_k, their rates d_k and the
 * reciprocal vectors g_k (g_i.e_j = 1 or 0, g_k.n = 0), is sum_k d_k g_k, and the surface rotates
 * with
 *
 *   w = n x n' + n (n . sum_k g_k x d_k)/2,    n' = - sum_k (d_k.n) g_k                [1/s]
 *
 * which is the angular velocity for a rigid body; for a deforming surface the normal part is half
 * of the surface vorticity.
 *
 * The facets are kept from the surface that was given, so contacts keep their keys however the
 * surface deforms. A facet whose triangles have left their common plane is bent: contact is then
 * with the nearest triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "walls/walls.h"
#include <math.h>
#include <string.h>

/* ---- planes ---------------------------------------------------------------------------------- */

/* Edges from the first corner, and twice the area with its direction. */
static double edges_and_normal(const struct dem_triangle *t, double edge[2][3], double normal[3])
{
    dem_vec_minus(t->corner[1], t->corner[0], edge[0]);
    dem_vec_minus(t->corner[2], t->corner[0], edge[1]);
    dem_vec_cross(edge[0], edge[1], normal);
    return dem_vec_norm(normal);
}

/* The plane of a facet follows its largest triangle; when that has no area, the normal stays. */
static void update_plane(const struct dem_walls *w, struct dem_facet *r)
{
    const struct dem_triangle *const t = &w->triangle[dem_walls_find(w, r->largest)];
    double edge[2][3], normal[3];
    const double size = edges_and_normal(t, edge, normal);

    dem_walls_set_plane(w, r, t, size, normal);
    r->bent = 0;
}

static int leaves_plane(const struct dem_walls *w, const struct dem_triangle *t)
{
    const struct dem_facet *const r = &w->facet[t->facet];
    double worst = 0.0, corner[3];

    for (int k = 0; k < 3; k++)
    {
        dem_walls_place_corner(w, t, k, corner);
        worst = fmax(worst, fabs(dem_vec_dot(r->normal, corner) - r->offset));
    }
    return worst > w->flatness;
}

static void update_planes(struct dem_walls *w, int all)
{
    for (int k = 0; k < w->facets; k++)
    {
        const struct dem_wall *const of = &w->wall[w->facet[k].wall];

        if (of->follows_mesh && (of->moves || all))
        {
            update_plane(w, &w->facet[k]);
        }
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_wall *const of = &w->wall[w->triangle[t].wall];

        if (of->follows_mesh && (of->moves || all))
        {
            w->facet[w->triangle[t].facet].bent |= (uint16_t)leaves_plane(w, &w->triangle[t]);
        }
    }
}

/* ---- target positions ------------------------------------------------------------------------ */

static int check_corners(const struct dem_wall *of, size_t n, const double *corners)
{
    DEM_REQUIRE(n == of->given && of->triangles > 0, DEM_ERROR_INPUT,
                "wall %s is to move with %zu triangles, but it was made "
                "from %zu; a mesh may move, but its faces must stay the same",
                of->name, n, of->given);
    for (size_t k = 0; k < 9*n; k++)
    {
        DEM_REQUIRE(isfinite(corners[k]), DEM_ERROR_NUMBER,
                    "wall %s is to move to a corner that is not a number; check the "
                    "motion of the mesh",
                    of->name);
    }
    return DEM_OK;
}

static int begin_to_follow(struct dem_walls *w, int wall)
{
    if (!w->trajectory)
    {
        DEM_TRY(DEM_NEW(w->trajectory, w->triangles));
        for (size_t t = 0; t < w->triangles; t++)
        {
            memcpy(w->trajectory[t].from, w->triangle[t].corner, sizeof w->trajectory[t].from);
            memcpy(w->trajectory[t].to, w->triangle[t].corner, sizeof w->trajectory[t].to);
        }
    }
    w->following += !w->wall[wall].follows_mesh;
    w->wall[wall].follows_mesh = 1;
    w->all_flat_static = 0;
    return DEM_OK;
}

int dem_walls_set_target(struct dem_walls *w, int wall, size_t n, const double *corners)
{
    DEM_TRY(check_corners(&w->wall[wall], n, corners));
    DEM_TRY(begin_to_follow(w, wall));
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall == wall)
        {
            memcpy(w->trajectory[t].to, corners + 9*(size_t)w->triangle[t].given_index,
                   sizeof w->trajectory[t].to);
        }
    }
    return DEM_OK;
}

int dem_walls_set_corners(struct dem_walls *w, int wall, size_t n, const double *corners)
{
    DEM_TRY(dem_walls_set_target(w, wall, n, corners));
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall == wall)
        {
            memcpy(w->trajectory[t].from, w->trajectory[t].to, sizeof w->trajectory[t].from);
            memcpy(w->triangle[t].corner, w->trajectory[t].to, sizeof w->triangle[t].corner);
        }
    }
    update_planes(w, 1);
    return DEM_OK;
}

/* ---- motion within an advance ---------------------------------------------------------------- */

void dem_walls_begin_advance(struct dem_walls *w, double duration)
{
    w->advance = duration;
    for (int k = 0; k < w->walls; k++)
    {
        w->wall[k].displacement = 0.0;
    }
    for (size_t t = 0; w->following > 0 && t < w->triangles; t++)
    {
        struct dem_corner_trajectory *const c = &w->trajectory[t];
        struct dem_wall *const of = &w->wall[w->triangle[t].wall];

        memcpy(c->from, w->triangle[t].corner, sizeof c->from);
        for (int k = 0; k < 3; k++)
        {
            double d[3];

            dem_vec_minus(c->to[k], c->from[k], d);
            of->displacement = fmax(of->displacement, dem_vec_norm(d));
        }
    }
    for (int k = 0; k < w->walls; k++)
    {
        w->wall[k].moves = w->wall[k].displacement > 0.0;
    }
}

static void move_triangles(struct dem_walls *w, double fraction)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_corner_trajectory *const c = &w->trajectory[t];

        for (int k = 0; k < 9 && w->wall[w->triangle[t].wall].moves; k++)
        {
            const double from = c->from[k/3][k%3], to = c->to[k/3][k%3];

            w->triangle[t].corner[k/3][k%3] = fraction < 1.0 ? from + fraction*(to - from) : to;
        }
    }
    update_planes(w, 0);
}

void dem_walls_advance(struct dem_walls *w, int64_t step, int64_t steps)
{
    double largest = 0.0;

    for (int k = 0; k < w->walls; k++)
    {
        largest = fmax(largest, w->wall[k].displacement/(double)steps);
    }
    if (largest > 0.0)
    {
        move_triangles(w, (double)step/(double)steps);
        w->displacement = fmax(w->displacement, largest);
        w->path_length += largest;
        w->since[DEM_LIST_OUTER] += largest;
        w->since[DEM_LIST_INNER] += largest;
    }
}

void dem_walls_rewind(struct dem_walls *w)
{
    double largest = 0.0;

    for (int k = 0; k < w->walls; k++)
    {
        largest = fmax(largest, w->wall[k].displacement);
    }
    if (largest > 0.0)
    {
        move_triangles(w, 0.0);
        w->path_length += largest;
    }
}

void dem_walls_surface_motion(const struct dem_walls *w, uint32_t triangle, const double x[3],
                              double velocity[3], double spin[3])
{
    const struct dem_corner_trajectory *const c = &w->trajectory[triangle];
    const struct dem_triangle *const t = &w->triangle[triangle];
    double edge[2][3], rate[3][3], n[3], g[2][3], away[3], turn[3] = {0.0, 0.0, 0.0},
                                                           tilt[3] = {0.0, 0.0, 0.0};
    const double size = edges_and_normal(t, edge, n), over = size > 0.0 ? 1.0/size : 0.0;

    for (int k = 0; k < 9; k++)
    {
        rate[k/3][k%3] = (c->to[k/3][k%3] - c->from[k/3][k%3])/w->advance;
    }
    for (int a = 0; a < 3; a++)
    {
        n[a] *= over;
    }
    dem_vec_cross(edge[1], n, g[0]);
    dem_vec_cross(n, edge[0], g[1]);
    dem_vec_minus(x, t->corner[0], away);
    memcpy(velocity, rate[0], sizeof rate[0]);
    for (int k = 0; k < 2; k++)
    {
        double d[3], curl[3];

        dem_vec_minus(rate[k + 1], rate[0], d);
        dem_vec_cross(g[k], d, curl);
        for (int a = 0; a < 3; a++)
        {
            velocity[a] += d[a]*(over*dem_vec_dot(g[k], away));
            turn[a] += over*curl[a];
            tilt[a] -= over*dem_vec_dot(d, n)*g[k][a];
        }
    }
    dem_vec_cross(n, tilt, spin);
    const double along = 0.5*dem_vec_dot(n, turn);

    for (int a = 0; a < 3; a++)
    {
        spin[a] += along*n[a];
    }
}
