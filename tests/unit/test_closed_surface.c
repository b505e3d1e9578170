/*
 * test_closed_surface.c -- which points are inside a closed surface of triangles.
 *
 * - The volume of a cube with a notch is exact.
 * - Points on a lattice aligned with its faces, edges and corners, and random points, are
 *   classified correctly.
 * - The answer does not depend on the order of triangles and corners.
 * - An open surface is refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "sources/closed_surface.h"

#include <string.h>

enum
{
    QUADS = 24, TRIANGLES = 2*QUADS, POINTS = 20000
};

/* cells of a 2 x 2 x 2 block; the one at (1 1 1) is cut out */
static int solid(int x, int y, int z)
{
    return x >= 0 && x < 2 && y >= 0 && y < 2 && z >= 0 && z < 2 && !(x == 1 && y == 1 && z == 1);
}

static size_t add_quad(double *to, const int at[3], int axis, int up)
{
    static const int corner[6] = {0, 1, 2, 0, 2, 3}, u[4] = {0, 1, 1, 0}, v[4] = {0, 0, 1, 1};

    for (int c = 0; c < 6; c++)
    {
        const int k = corner[up ? c : 5 - c];
        int x[3] = {at[0], at[1], at[2]};

        x[axis] += up;
        x[(axis + 1)%3] += u[k];
        x[(axis + 2)%3] += v[k];
        for (int i = 0; i < 3; i++)
        {
            *to++ = x[i];
        }
    }
    return 2;
}

/* Each face between a solid cell and an empty one. */
static size_t make(double *corners)
{
    size_t n = 0;

    for (int c = 0; c < 8; c++)
    {
        const int at[3] = {c & 1, c >> 1 & 1, c >> 2};

        for (int face = 0; face < 6 && solid(at[0], at[1], at[2]); face++)
        {
            int next[3] = {at[0], at[1], at[2]};

            next[face/2] += face%2 ? 1 : -1;
            n += solid(next[0], next[1], next[2]) ? 0 : add_quad(corners + 9*n, at, face/2, face%2);
        }
    }
    return n;
}

static int is_inside(const double x[3])
{
    return solid((int)(x[0] + 8.0) - 8, (int)(x[1] + 8.0) - 8, (int)(x[2] + 8.0) - 8);
}

static int count_wrong(const struct dem_closed_surface *s, double edge, double offset)
{
    int bad = 0;

    for (double x = -0.5 + offset; x < 2.5; x += edge)
    {
        for (double y = -0.5 + offset; y < 2.5; y += edge)
        {
            for (double z = -0.5 + offset; z < 2.5; z += edge)
            {
                const double at[3] = {x, y, z};

                bad += dem_closed_surface_contains(s, at) != is_inside(at);
            }
        }
    }
    return bad;
}

int main(void)
{
    struct dem_closed_surface a = {.what = "wall", .name = "block"}, b = a, c = a;
    double *one, *other, *open;
    int differ = 0, bad = 0;

    TAP_TRAPS;
    TAP_OK(DEM_NEW(one, 9*TRIANGLES) == DEM_OK && DEM_NEW(other, 9*TRIANGLES) == DEM_OK
               && DEM_NEW(open, 9*TRIANGLES) == DEM_OK,
           "memory is allocated");
    const size_t n = make(one);

    TAP_OK(n == TRIANGLES, "the block with a notch has %d triangles", TRIANGLES);
    for (size_t t = 0; t < n; t++)    /* backwards, from another corner */
    {
        for (int k = 0; k < 3; k++)
        {
            memcpy(other + 9*(n - 1 - t) + 3*k, one + 9*t + 3*((k + 1)%3), 3*sizeof *one);
        }
    }
    memcpy(open, one, 9*(n - 1)*sizeof *one);
    TAP_OK(dem_closed_surface_init(&a, n, one) == DEM_OK, "the surface is closed");
    TAP_OK(dem_closed_surface_init(&b, n, other) == DEM_OK, "also with triangles in reverse order");
    TAP_OK(a.volume == 7.0 && b.volume == 7.0, "its volume is 7");
    TAP_OK(count_wrong(&a, 0.25, 0.125) == 0, "points of a lattice off its edges");
    /* in planes, lines and points of the projection, but not on the surface itself: moved by less
       than a cell along each axis in turn */
    for (size_t k = 0; k < 3; k++)
    {
        for (int m = 0; m < 125; m++)
        {
            double x[3] = {0.5*(m%5), 0.5*(m/5%5), 0.5*(m/25)};

            for (size_t i = 0; i < 3; i++)
            {
                x[i] += i == k ? 0.25 : 1e-9;
            }
            bad += dem_closed_surface_contains(&a, x) != is_inside(x);
        }
    }
    TAP_OK(bad == 0, "points aligned with faces, edges and corners");
    for (uint64_t m = 0; m < POINTS; m++)
    {
        double x[3];

        for (uint64_t k = 0; k < 3; k++)
        {
            x[k] = 3.0*dem_random_unit(1, m, k, 7) - 0.5;
        }
        bad += dem_closed_surface_contains(&a, x) != is_inside(x);
        differ += dem_closed_surface_contains(&a, x) != dem_closed_surface_contains(&b, x);
    }
    TAP_OK(bad == 0, "random points");
    TAP_OK(differ == 0, "the same with triangles in another order");
    TAP_OK(dem_closed_surface_init(&c, n - 1, open) == DEM_ERROR_INPUT,
           "an open surface is refused");
    dem_closed_surface_free(&a);
    dem_closed_surface_free(&b);
    dem_closed_surface_free(&c);
    TAP_DONE;
}
