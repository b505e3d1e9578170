/*
 * clump_form.c -- surface and projected areas of a union of spheres (formulas: clump_form.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump_form.h"
#include "core/math.h"
#include "core/vec.h"
#include "laws/effect.h"
#include "particles/chords.h"
#include <math.h>
#include <string.h>

enum
{
    LINES = 256,                  /* across all discs of a projection */
    POINTS = 20000,               /* on a sphere, for the surface; fewer where there are many */
    AROUND = 24                   /* directions of the mean A_l, in a half turn */
};

static const double pi = 3.14159265358979324;

/* ---- areas ----------------------------------------------------------------------------------- */

/* Two unit vectors across n and each other. */
static void across(const double n[3], double a[3], double b[3])
{
    const int k = fabs(n[0]) <= fabs(n[1]) && fabs(n[0]) <= fabs(n[2]) ? 0
                  : fabs(n[1]) <= fabs(n[2])                         ? 1
                                                                     : 2;
    double axis[3] = {0.0, 0.0, 0.0};

    axis[k] = 1.0;
    dem_vec_cross(n, axis, a);
    const double over = 1.0/dem_vec_norm(a);

    for (int c = 0; c < 3; c++)
    {
        a[c] *= over;
    }
    dem_vec_cross(n, a, b);
}

/* Length of the union of the chords that the discs cut from the line at height y. */
static double covered(size_t n, const double (*disc)[3], double y)
{
    struct dem_chords chords;
    double sum = 0.0, end = -INFINITY;

    chords.n = 0;
    for (size_t i = 0; i < n; i++)
    {
        const double from = y - disc[i][1];

        dem_chords_add(&chords, disc[i][0], disc[i][2]*disc[i][2] - from*from);
    }
    for (int k = 0; k < chords.n; k++)
    {
        sum += fmax(0.0, chords.at[k][1] - fmax(chords.at[k][0], end));
        end = fmax(end, chords.at[k][1]);
    }
    return sum;
}

/* A(n), n a unit vector */
static double projected(const struct dem_clump_shape *s, const double n[3])
{
    double a[3], b[3], disc[DEM_CLUMP_SPHERES][3], low = INFINITY, high = -INFINITY, sum = 0.0;

    across(n, a, b);
    for (size_t k = 0; k < s->n; k++)
    {
        const double r = s->sphere[k][3];

        disc[k][0] = dem_vec_dot(a, s->offset[k]);
        disc[k][1] = dem_vec_dot(b, s->offset[k]);
        disc[k][2] = r;
        low = fmin(low, disc[k][1] - r);
        high = fmax(high, disc[k][1] + r);
    }
    const double h = (high - low)/LINES;

    for (int k = 0; k < LINES; k++)
    {
        sum += covered(s->n, (const double (*)[3])disc, low + ((double)k + 0.5)*h);
    }
    return h*sum;
}

/* 1: the point lies in no sphere but the k-th; of spheres that coincide the first one counts */
static int exposed(const struct dem_clump_shape *s, size_t k, const double x[3])
{
    for (size_t j = 0; j < s->n; j++)
    {
        double d[3], between[3];

        dem_vec_minus(x, s->offset[j], d);
        dem_vec_minus(s->offset[k], s->offset[j], between);
        const int same = dem_vec_norm(between) == 0.0 && s->sphere[j][3] == s->sphere[k][3];

        if (j != k && (same ? j < k : dem_vec_dot(d, d) < s->sphere[j][3]*s->sphere[j][3]))
        {
            return 0;
        }
    }
    return 1;
}

/* S: points of equal area along a spiral that turns by the golden angle from one to the next */
static double surface(const struct dem_clump_shape *s)
{
    const double turn[2] = {-0.73736887807831985597, 0.67549029426152362720};
    const int points = s->n <= 16 ? POINTS : POINTS/8;
    double sum = 0.0;

    for (size_t k = 0; k < s->n; k++)
    {
        const double r = s->sphere[k][3];
        double at[2] = {1.0, 0.0};
        int count = 0;

        for (int m = 0; m < points; m++)
        {
            const double z = 1.0 - (2.0*m + 1.0)/points, around = r*sqrt(1.0 - z*z), old = at[0];
            const double x[3] = {s->offset[k][0] + around*at[0], s->offset[k][1] + around*at[1],
                                 s->offset[k][2] + r*z};

            count += exposed(s, k, x);
            at[0] = turn[0]*old - turn[1]*at[1];
            at[1] = turn[1]*old + turn[0]*at[1];
        }
        sum += 4.0*pi*r*r*count/points;
    }
    return sum;
}

/* ---- table ----------------------------------------------------------------------------------- */

/* The direction of a node. */
static void node(int face, int i, int j, double n[3])
{
    const double u = 2.0*i/DEM_CLUMP_FORM_CELLS - 1.0, v = 2.0*j/DEM_CLUMP_FORM_CELLS - 1.0,
                 over = 1.0/sqrt(1.0 + u*u + v*v);

    n[face] = over;
    n[(face + 1)%3] = u*over;
    n[(face + 2)%3] = v*over;
}

/* Linear interpolation of both values along n, of any length above 0; `at`: a table `inverse`. */
DEM_MATH void interpolate(const double *at, const double n[3], double value[2])
{
    const double size[3] = {fabs(n[0]), fabs(n[1]), fabs(n[2])};
    const int first = (size[0] >= size[1]) & (size[0] >= size[2]), second = !first & (size[1] >= size[2]);
    const double across = dem_select(first, n[0], dem_select(second, n[1], n[2])),
                 next = dem_select(first, n[1], dem_select(second, n[2], n[0])),
                 last = dem_select(first, n[2], dem_select(second, n[0], n[1]));
    const double half = 0.5*DEM_CLUMP_FORM_CELLS, u = half*(next/across + 1.0), v = half*(last/across + 1.0);
    const int i = (int)u < DEM_CLUMP_FORM_CELLS ? (int)u : DEM_CLUMP_FORM_CELLS - 1,
              j = (int)v < DEM_CLUMP_FORM_CELLS ? (int)v : DEM_CLUMP_FORM_CELLS - 1;
    const double x = u - i, y = v - j;
    const int row = 2*DEM_CLUMP_FORM_NODES, low = (2 - 2*first - second)*DEM_CLUMP_FORM_NODES*row + i*row + 2*j;

    value[0] = (1.0 - x)*((1.0 - y)*at[low] + y*at[low + 2]) + x*((1.0 - y)*at[low + row] + y*at[low + row + 2]);
    value[1] = (1.0 - x)*((1.0 - y)*at[low + 1] + y*at[low + 3]) +
               x*((1.0 - y)*at[low + row + 1] + y*at[low + row + 3]);
}

/* A_l(n) over pi d^2/4, from the table of A. */
static double lengthwise_mean(const struct dem_clump_form *f, const double n[3])
{
    /* cos and sin of pi/24 */
    const double turn[2] = {0.99144486137381041114, 0.13052619222005159155};
    double a[3], b[3], at[2] = {1.0, 0.0}, sum = 0.0;

    across(n, a, b);
    for (int k = 0; k < AROUND; k++)
    {
        const double old = at[0];
        double to[3], value[2];

        for (int c = 0; c < 3; c++)
        {
            to[c] = at[0]*a[c] + at[1]*b[c];
        }
        interpolate(&f->inverse[0][0][0][0], to, value);
        sum += value[0];
        at[0] = turn[0]*old - turn[1]*at[1];
        at[1] = turn[1]*old + turn[0]*at[1];
    }
    return sum/AROUND;
}

static void fill(struct dem_clump_form *f, const struct dem_clump_shape *s, int which)
{
    const double disc = pi*f->radius*f->radius;

    for (int face = 0; face < 3; face++)
    {
        for (int i = 0; i < DEM_CLUMP_FORM_NODES; i++)
        {
            for (int j = 0; j < DEM_CLUMP_FORM_NODES; j++)
            {
                double n[3];

                node(face, i, j, n);
                f->inverse[face][i][j][which] =
                    which == 0 ? projected(s, n)/disc : 0.5*f->surface/disc - lengthwise_mean(f, n);
            }
        }
    }
}

void dem_clump_form_make(struct dem_clump_form *f, const struct dem_clump_shape *s, int areas)
{
    memset(f, 0, sizeof *f);
    f->volume = s->volume;
    f->radius = s->n == 1 ? s->sphere[0][3] : dem_pow(s->volume/(4.0/3.0*pi), 1.0/3.0);
    f->surface = s->n > 1 ? surface(s) : 4.0*pi*f->radius*f->radius;
    f->sphericity = s->n > 1 ? 4.0*pi*f->radius*f->radius/f->surface : 1.0;
    f->areas = areas && s->n > 1;
    if (f->areas)
    {
        fill(f, s, 0);
        fill(f, s, 1);
    }
}

DEM_KERNEL
static void along_rows(const double *restrict table, const int *restrict start, double n[3][DEM_BATCH_ROWS], int rows,
                       double *restrict crosswise, double *restrict lengthwise)
{
    for (int c = 0; c < rows; c++)
    {
        const double square = n[0][c]*n[0][c] + n[1][c]*n[1][c] + n[2][c]*n[2][c];
        const int known = (square > 0.0) & (square < INFINITY), has = start[c] >= 0;
        const double along[3] = {dem_select(known, n[0][c], 0.0), dem_select(known, n[1][c], 0.0),
                                 dem_select(known, n[2][c], 1.0)};
        double value[2];

        interpolate(table + (has ? start[c] : 0), along, value);
        crosswise[c] = dem_select(has, 1.0/value[0], 1.0);
        lengthwise[c] = dem_select(has, 1.0/value[1], 1.0);
    }
}

void dem_clump_forms_along(const struct dem_clump_form *form, const int *which, double n[3][DEM_BATCH_ROWS], int rows,
                           double *crosswise, double *lengthwise)
{
    int start[DEM_BATCH_ROWS];

    for (int c = 0; c < rows; c++)
    {
        start[c] = which[c] >= 0 && form[which[c]].areas ? which[c]*(int)(sizeof *form/sizeof(double)) : -1;
    }
    along_rows(&form->inverse[0][0][0][0], start, n, rows, crosswise, lengthwise);
}
