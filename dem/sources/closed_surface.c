/*
 * closed_surface.c -- volume and inertia of a closed surface of triangles, and the points inside it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/closed_surface.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sum.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

/* Rounding of the corners, far below the smallest opening that lets a sphere out. */
static const double max_gap = 1e-5;

/* Points move along the ray (-slope_x, -slope_y, 1) without changing their place across it. */
static const double slope[2] = {0.02718281828459045, 0.05772156649015329};

static void across(const double x[3], double place[2])
{
    place[0] = x[0] + slope[0]*x[2];
    place[1] = x[1] + slope[1]*x[2];
}

static int before(const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
    {
        if (a[k] < b[k] || a[k] > b[k])
        {
            return a[k] < b[k];
        }
    }
    return 0;
}

/* Six times the volume of the tetrahedron with the origin. It begins with the first corner, so that
   its rounding does not depend on which corner was given first. */
static double six_volumes(const double t[3][3])
{
    int first = before(t[1], t[0]);
    double cross[3];

    first = before(t[2], t[first]) ? 2 : first;
    dem_vec_cross(t[(first + 1)%3], t[(first + 2)%3], cross);
    return dem_vec_dot(t[first], cross);
}

static void bound(struct dem_closed_surface *s)
{
    for (int k = 0; k < 3; k++)
    {
        s->min[k] = INFINITY;
        s->max[k] = -INFINITY;
    }
    for (size_t t = 0; t < s->n; t++)
    {
        for (int c = 0; c < 9; c++)
        {
            s->min[c%3] = fmin(s->min[c%3], s->corner[t][c/3][c%3]);
            s->max[c%3] = fmax(s->max[c%3], s->corner[t][c/3][c%3]);
        }
    }
}

/* Volume. Returns the share of the area that is open: over a closed surface the areas A with their
   directions add up to 0, and the products x A to the volume times the unit tensor. The second
   finds a straight tube without ends. */
static double measure(struct dem_closed_surface *s)
{
    struct dem_sum volume = {0};
    double sum[3] = {0.0, 0.0, 0.0}, moment[3][3] = {{0.0}}, sizes = 0.0, extent = 0.0;

    for (size_t t = 0; t < s->n; t++)
    {
        const double (*const x)[3] = (const double (*)[3])s->corner[t];
        double ab[3], ac[3], area[3];

        dem_vec_minus(x[1], x[0], ab);
        dem_vec_minus(x[2], x[0], ac);
        dem_vec_cross(ab, ac, area);
        for (int k = 0; k < 3; k++)
        {
            const double centre = (x[0][k] + x[1][k] + x[2][k])/3.0 - 0.5*(s->min[k] + s->max[k]);

            extent = fmax(extent, s->max[k] - s->min[k]);
            sum[k] += area[k];
            for (int l = 0; l < 3; l++)
            {
                moment[k][l] += centre*area[l];
            }
        }
        sizes += dem_vec_norm(area);
        dem_sum_add(&volume, six_volumes(x));
    }
    dem_sum_normalise(&volume);
    s->volume = fabs(dem_sum_value(&volume))/6.0;

    double gap = sizes > 0.0 ? dem_vec_norm(sum)/sizes : 1.0;
    const double mean = (moment[0][0] + moment[1][1] + moment[2][2])/3.0;

    for (int k = 0; sizes > 0.0 && k < 9; k++)
    {
        const double closed = k%4 == 0 ? mean : 0.0;

        gap = fmax(gap, fabs(moment[k/3][k%3] - closed)/(sizes*extent));
    }
    return gap;
}

/* ---- grid ------------------------------------------------------------------------------------ */

static int cell_along(const struct dem_closed_surface *s, int k, double place)
{
    const double at = (place - s->low[k])/s->edge[k];

    return !(at > 0.0) ? 0 : at >= (double)s->cells[k] ? s->cells[k] - 1 : (int)at;
}

static void cell_range(const struct dem_closed_surface *s, size_t t, int from[2], int to[2])
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

    for (int c = 0; c < 3; c++)
    {
        double place[2];

        across(s->corner[t][c], place);
        for (int k = 0; k < 2; k++)
        {
            low[k] = fmin(low[k], place[k]);
            high[k] = fmax(high[k], place[k]);
        }
    }
    for (int k = 0; k < 2; k++)
    {
        from[k] = cell_along(s, k, low[k]);
        to[k] = cell_along(s, k, high[k]);
    }
}

/* Count the triangles of each cell (entry NULL), or store them. */
static void visit(const struct dem_closed_surface *s, size_t *next, uint32_t *entry)
{
    for (size_t t = 0; t < s->n; t++)
    {
        int from[2], to[2];

        cell_range(s, t, from, to);
        for (int y = from[1]; y <= to[1]; y++)
        {
            for (int x = from[0]; x <= to[0]; x++)
            {
                size_t *const at = &next[(size_t)y*(size_t)s->cells[0] + (size_t)x];

                if (entry)
                {
                    entry[*at] = (uint32_t)t;
                }
                ++*at;
            }
        }
    }
}

static void size_grid(struct dem_closed_surface *s)
{
    const int cells = (int)fmin(1024.0, ceil(sqrt((double)s->n)));

    for (int k = 0; k < 2; k++)
    {
        const double a = slope[k]*s->min[2], b = slope[k]*s->max[2];
        const double high = s->max[k] + fmax(a, b);

        s->low[k] = s->min[k] + fmin(a, b);
        s->cells[k] = cells;
        s->edge[k] = high > s->low[k] ? (high - s->low[k])/cells : 1.0;
    }
}

static int make_grid(struct dem_closed_surface *s)
{
    size_t *next;

    size_grid(s);
    const size_t cells = (size_t)s->cells[0]*(size_t)s->cells[1];

    DEM_TRY(DEM_NEW(s->start, cells + 1));
    DEM_TRY(DEM_NEW(next, cells + 1));
    visit(s, next, NULL);
    for (size_t c = 0; c < cells; c++)
    {
        s->start[c + 1] = s->start[c] + next[c];
        next[c] = s->start[c];
    }
    const int status = DEM_NEW(s->entry, s->start[cells] + 1);

    if (!status)
    {
        visit(s, next, s->entry);
    }
    dem_memory_free(next);
    return status;
}

int dem_closed_surface_init(struct dem_closed_surface *s, size_t n, double *corners)
{
    s->n = n;
    s->corner = (double (*)[3][3])(void *)corners;
    bound(s);
    const double gap = measure(s);

    DEM_REQUIRE(n > 0 && n < UINT32_MAX && gap <= max_gap && s->volume > 0.0, DEM_ERROR_INPUT,
                "%s %s of %zu triangles has no inside: it is open by %.3g of its area, the limit "
                "is %g; the surface must be closed, also at periodic faces, with all triangles "
                "outward", s->what, s->name, n, gap, max_gap);
    return make_grid(s);
}

void dem_closed_surface_free(struct dem_closed_surface *s)
{
    dem_memory_free(s->corner);
    dem_memory_free(s->start);
    dem_memory_free(s->entry);
    memset(s, 0, sizeof *s);
}

int dem_closed_surface_of_wall(struct dem_closed_surface *s, const struct dem_walls *w, int wall)
{
    size_t n = 0;
    double *corners;

    DEM_TRY(DEM_NEW(corners, 9*w->triangles + 1));
    for (size_t t = 0; t < w->triangles; t++)
    {
        if (w->triangle[t].wall == wall)
        {
            memcpy(corners + 9*n++, w->triangle[t].corner, 9*sizeof *corners);
        }
    }
    s->what = "wall";
    memcpy(s->name, w->wall[wall].name, sizeof s->name);
    return dem_closed_surface_init(s, n, corners);
}

/* ---- inertia --------------------------------------------------------------------------------- */

/* Add the tetrahedron of a triangle and the centre c of the box, from which x = corner - c. With the sum S of
   the three corners x_k and V = x_1.(x_2 x x_3)/6 the integral of x is V S/4, of x x V/20 (S S + sum x_k x_k).
   Returns V. */
static double add_tetrahedron(const double t[3][3], const double c[3], double first[3],
                              double second[3][3])
{
    double x[3][3], S[3], cross[3];

    for (int k = 0; k < 3; k++)
    {
        dem_vec_minus(t[k], c, x[k]);
    }
    dem_vec_cross(x[1], x[2], cross);
    const double volume = dem_vec_dot(x[0], cross)/6.0;

    for (int a = 0; a < 3; a++)
    {
        S[a] = x[0][a] + x[1][a] + x[2][a];
        first[a] += 0.25*volume*S[a];
    }
    for (int a = 0; a < 9; a++)
    {
        const int i = a/3, j = a%3;

        second[i][j] += volume/20.0*(S[i]*S[j] + x[0][i]*x[0][j] + x[1][i]*x[1][j] + x[2][i]*x[2][j]);
    }
    return volume;
}

void dem_closed_surface_inertia(const struct dem_closed_surface *s, double centre[3], double inertia[3][3])
{
    double c[3], first[3] = {0.0, 0.0, 0.0}, second[3][3] = {{0.0}}, volume = 0.0;

    for (int k = 0; k < 3; k++)
    {
        c[k] = 0.5*(s->min[k] + s->max[k]);
    }
    for (size_t t = 0; t < s->n; t++)
    {
        volume += add_tetrahedron((const double (*)[3])s->corner[t], c, first, second);
    }
    const double side = volume < 0.0 ? -1.0 : 1.0;    /* corners clockwise from outside */

    for (int a = 0; a < 3; a++)
    {
        centre[a] = c[a] + first[a]/volume;
        for (int b = 0; b < 3; b++)
        {
            second[a][b] = side*(second[a][b] - first[a]*first[b]/volume);
        }
    }
    const double trace = second[0][0] + second[1][1] + second[2][2];

    for (int a = 0; a < 9; a++)
    {
        inertia[a/3][a%3] = (a%4 == 0 ? trace : 0.0) - second[a/3][a%3];
    }
}

/* ---- inside ---------------------------------------------------------------------------------- */

/* Does the line from `at` towards +x cross the edge a-b, all across the ray? */
static int crosses_edge(const double a[2], const double b[2], const double at[2])
{
    const int sorted = a[0] < b[0] || (a[0] <= b[0] && a[1] < b[1]);
    const double *const p = sorted ? a : b, *const q = sorted ? b : a;

    return (p[1] > at[1]) != (q[1] > at[1])
        && at[0] < p[0] + (q[0] - p[0])*((at[1] - p[1])/(q[1] - p[1]));
}

/* Does the ray upwards from x, at `place` across it, cross the triangle? */
static int crosses(const double t[3][3], const double x[3], const double place[2])
{
    double corner[3][2], ab[3], ac[3], ax[3], n[3];
    int inside = 0;

    for (int c = 0; c < 3; c++)
    {
        across(t[c], corner[c]);
    }
    for (int c = 0; c < 3; c++)
    {
        inside ^= crosses_edge(corner[c], corner[(c + 1)%3], place);
    }
    if (!inside)
    {
        return 0;
    }
    dem_vec_minus(t[1], t[0], ab);
    dem_vec_minus(t[2], t[0], ac);
    dem_vec_minus(x, t[0], ax);
    dem_vec_cross(ab, ac, n);
    /* n.ray: the side that the ray goes to; n.ax: the side that x is on */
    return (n[2] - slope[0]*n[0] - slope[1]*n[1] > 0.0) == (dem_vec_dot(n, ax) < 0.0);
}

int dem_closed_surface_contains(const struct dem_closed_surface *s, const double x[3])
{
    double place[2];
    int odd = 0;

    for (int k = 0; k < 3; k++)
    {
        if (!(x[k] >= s->min[k] && x[k] <= s->max[k]))
        {
            return 0;
        }
    }
    across(x, place);
    const size_t cell = (size_t)cell_along(s, 1, place[1])*(size_t)s->cells[0]
                      + (size_t)cell_along(s, 0, place[0]);

    for (size_t e = s->start[cell]; e < s->start[cell + 1]; e++)
    {
        odd ^= crosses((const double (*)[3])s->corner[s->entry[e]], x, place);
    }
    return odd;
}
