/*
 * wall_course.c -- walls that follow a mesh: whoever moves the mesh tells where their corners will be at the end of an advance,
 * and on the way there
 *
 *   x(t) = from + (to - from) (t - t0)/T,    v = (to - from)/T
 *
 *   from, to   corner at the begin t0 and the end of the advance                       [m]
 *   T          length of the advance                                                   [s]
 *
 * A wall that turns by the angle a within an advance is so on the chord, a^2/8 of its radius inside the circle half way.
 *
 * Inside a triangle v is linear; its gradient along the surface, with edges e_k, their rates d_k and the reciprocal vectors
 * g_k (g_i.e_j = 1 or 0, g_k.n = 0), is sum_k d_k g_k, and the surface turns with
 *
 *   w = n x n' + n (n . sum_k g_k x d_k)/2,    n' = - sum_k (d_k.n) g_k                [1/s]
 *
 * which is the angular velocity of a rigid body, and of another surface half its rotation along it.
 *
 * Regions are those of the surface as it was handed in, so contacts keep their names whatever becomes of it. A region whose
 * triangles have left their common plane is bent: contact is with its nearest triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include "state/walls.h"
#include <math.h>
#include <string.h>

/* ---- planes -------------------------------------------------------------------------------------------------- */

/* Edges from the first corner, and twice the area with its direction. */
static double spread(const struct dem_triangle *t, double edge[2][3], double normal[3])
{
    dem_vec_minus(t->corner[1], t->corner[0], edge[0]);
    dem_vec_minus(t->corner[2], t->corner[0], edge[1]);
    dem_vec_cross(edge[0], edge[1], normal);
    return dem_vec_norm(normal);
}

/* A region goes with its largest triangle; one that has shrunk to nothing leaves the plane as it was. */
static void place_plane(const struct dem_walls *w, struct dem_region *r)
{
    const struct dem_triangle *const t = &w->triangle[r->largest];
    double edge[2][3], normal[3];
    const double size = spread(t, edge, normal);

    for (int k = 0; k < 3 && size > 0.0; k++)
    {
        r->normal[k] = normal[k]/size;
    }
    r->offset = dem_vec_dot(r->normal, t->corner[0]);
    r->bent = 0;
}

static int leaves_plane(const struct dem_walls *w, const struct dem_triangle *t)
{
    const struct dem_region *const r = &w->region[t->region];
    double worst = 0.0;

    for (int k = 0; k < 3; k++)
    {
        worst = fmax(worst, fabs(dem_vec_dot(r->normal, t->corner[k]) - r->offset));
    }
    return worst > w->flatness;
}

static void place_planes(struct dem_walls *w, int all)
{
    for (int k = 0; k < w->regions; k++)
    {
        const struct dem_wall *const of = &w->wall[w->region[k].wall];

        if (of->follows && (of->goes || all))
        {
            place_plane(w, &w->region[k]);
        }
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_wall *const of = &w->wall[w->triangle[t].wall];

        if (of->follows && (of->goes || all))
        {
            w->region[w->triangle[t].region].bent |= leaves_plane(w, &w->triangle[t]);
        }
    }
}

/* ---- being told ---------------------------------------------------------------------------------------------- */

static int check_corners(const struct dem_wall *of, size_t n, const double *corners)
{
    DEM_REQUIRE(n == of->handed && of->triangles > 0, DEM_ERROR_INPUT, "wall %s is to move with %zu triangles, but it was made from %zu; a "
                "mesh may move, but not change", of->name, n, of->handed);
    for (size_t k = 0; k < 9*n; k++)
    {
        DEM_REQUIRE(isfinite(corners[k]), DEM_ERROR_NUMBER, "wall %s is to move to a corner that is not a number; look at the motion of "
                    "the mesh", of->name);
    }
    return DEM_OK;
}

static int begin_to_follow(struct dem_walls *w, int wall)
{
    if (!w->course)
    {
        DEM_TRY(DEM_NEW(w->course, w->triangles));
        for (size_t t = 0; t < w->triangles; t++)
        {
            memcpy(w->course[t].from, w->triangle[t].corner, sizeof w->course[t].from);
            memcpy(w->course[t].to, w->triangle[t].corner, sizeof w->course[t].to);
        }
    }
    w->following += !w->wall[wall].follows;
    w->wall[wall].follows = 1;
    w->plain = 0;
    return DEM_OK;
}

int dem_walls_tell(struct dem_walls *w, int wall, size_t n, const double *corners)
{
    DEM_TRY(check_corners(&w->wall[wall], n, corners));
    DEM_TRY(begin_to_follow(w, wall));
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall == wall)
        {
            memcpy(w->course[t].to, corners + 9*(size_t)w->triangle[t].handed, sizeof w->course[t].to);
        }
    }
    return DEM_OK;
}

int dem_walls_place(struct dem_walls *w, int wall, size_t n, const double *corners)
{
    DEM_TRY(dem_walls_tell(w, wall, n, corners));
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall == wall)
        {
            memcpy(w->course[t].from, w->course[t].to, sizeof w->course[t].from);
            memcpy(w->triangle[t].corner, w->course[t].to, sizeof w->triangle[t].corner);
        }
    }
    place_planes(w, 1);
    return DEM_OK;
}

/* ---- on the way ---------------------------------------------------------------------------------------------- */

void dem_walls_set_off(struct dem_walls *w, double duration)
{
    w->advance = duration;
    for (int k = 0; k < w->walls; k++)
    {
        w->wall[k].way = 0.0;
    }
    for (size_t t = 0; w->following > 0 && t < w->triangles; t++)
    {
        struct dem_course *const c = &w->course[t];
        struct dem_wall *const of = &w->wall[w->triangle[t].wall];

        memcpy(c->from, w->triangle[t].corner, sizeof c->from);
        for (int k = 0; k < 3; k++)
        {
            double d[3];

            dem_vec_minus(c->to[k], c->from[k], d);
            of->way = fmax(of->way, dem_vec_norm(d));
        }
    }
    for (int k = 0; k < w->walls; k++)
    {
        w->wall[k].goes = w->wall[k].way > 0.0;
    }
}

static void place_triangles(struct dem_walls *w, double share)
{
    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_course *const c = &w->course[t];

        for (int k = 0; k < 9 && w->wall[w->triangle[t].wall].goes; k++)
        {
            const double from = c->from[k/3][k%3], to = c->to[k/3][k%3];

            w->triangle[t].corner[k/3][k%3] = share < 1.0 ? from + share*(to - from) : to;
        }
    }
    place_planes(w, 0);
}

void dem_walls_go(struct dem_walls *w, int64_t step, int64_t steps)
{
    double most = 0.0;

    for (int k = 0; k < w->walls; k++)
    {
        most = fmax(most, w->wall[k].way/(double)steps);
    }
    if (most > 0.0)
    {
        place_triangles(w, (double)step/(double)steps);
        w->stride = fmax(w->stride, most);
        w->journey += most;
        w->since[DEM_LIST_OUTER] += most;
        w->since[DEM_LIST_INNER] += most;
    }
}

void dem_walls_go_back(struct dem_walls *w)
{
    double most = 0.0;

    for (int k = 0; k < w->walls; k++)
    {
        most = fmax(most, w->wall[k].way);
    }
    if (most > 0.0)
    {
        place_triangles(w, 0.0);
        w->journey += most;
    }
}

void dem_walls_drift(const struct dem_walls *w, uint32_t triangle, const double x[3], double velocity[3], double spin[3])
{
    const struct dem_course *const c = &w->course[triangle];
    const struct dem_triangle *const t = &w->triangle[triangle];
    double edge[2][3], rate[3][3], n[3], g[2][3], away[3], turn[3] = {0.0, 0.0, 0.0}, tilt[3] = {0.0, 0.0, 0.0};
    const double size = spread(t, edge, n), over = size > 0.0 ? 1.0/size : 0.0;

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
