/*
 * sphere_union.c -- volume, centre and second moments of a union of spheres; formulas and accuracy: sphere_union.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/sphere_union.h"
#include "core/vec.h"
#include "particles/chords.h"
#include <math.h>
#include <string.h>

enum
{
    COLUMNS = 1024                    /* along x and y, at least */
};

struct spheres
{
    size_t n;
    const double (*at)[4];            /* x, y, z, radius [m] */
};

static int overlap(const struct spheres *s)
{
    int any = 0;

    for (size_t i = 0; i < s->n; i++)
    {
        for (size_t j = 0; j < i; j++)
        {
            double d[3];

            dem_vec_minus(s->at[i], s->at[j], d);
            any |= dem_vec_norm(d) < (s->at[i][3] + s->at[j][3])*(1.0 - 1e-12);
        }
    }
    return any;
}

static void add_spheres(const struct spheres *s, struct dem_union_moments *m)
{
    for (size_t i = 0; i < s->n; i++)
    {
        const double *const at = s->at[i], r = at[3], V = dem_sphere_volume(r);
        double d[3];

        dem_vec_minus(at, m->origin, d);
        m->volume += V;
        for (int a = 0; a < 3; a++)
        {
            m->first[a] += V*d[a];
            for (int b = 0; b < 3; b++)
            {
                m->second[a][b] += V*(d[a]*d[b] + (a == b ? 0.2*r*r : 0.0));
            }
        }
    }
}

/* The part of a column at (x, y) of cross-section `area` between two heights. */
static void add_part(struct dem_union_moments *m, const double at[2], double area, const double z[2])
{
    const double V = area*(z[1] - z[0]), middle = 0.5*(z[0] + z[1]);
    const double d[3] = {at[0], at[1], middle};

    m->volume += V;
    for (int a = 0; a < 3; a++)
    {
        m->first[a] += V*d[a];
        for (int b = 0; b < 3; b++)
        {
            m->second[a][b] += V*d[a]*d[b];
        }
    }
    m->second[2][2] += V*(z[1] - z[0])*(z[1] - z[0])/12.0;
}

/* The parts of a column inside the spheres. */
static void add_column(const struct spheres *s, struct dem_union_moments *m, const double at[2],
                       double area)
{
    struct dem_chords chords;

    chords.n = 0;
    for (size_t i = 0; i < s->n; i++)
    {
        const double *const c = s->at[i];
        const double x = at[0] - (c[0] - m->origin[0]), y = at[1] - (c[1] - m->origin[1]);

        dem_chords_add(&chords, c[2] - m->origin[2], c[3]*c[3] - x*x - y*y);
    }
    dem_chords_unite(&chords);
    for (int k = 0; k < chords.n; k++)
    {
        add_part(m, at, area, chords.at[k]);
    }
}

/* Largest width of a column [m]. */
static double width(const struct spheres *s)
{
    double sum[3] = {0.0, 0.0, 0.0};

    for (size_t k = 0; k < s->n; k++)
    {
        const double r = s->at[k][3];

        sum[0] += r;
        sum[1] += r*r;
        sum[2] += r*r*r;
    }
    return fmax(sqrt(sum[2]/sum[0])/150.0, sqrt(3.14159265358979324*sum[1]/8e6));
}

/* The spheres that a row of columns meets at y, in the order of where they begin, and the first and last
   column of each. */
struct row
{
    size_t n;
    double sphere[DEM_CLUMP_SPHERES][4];
    long range[DEM_CLUMP_SPHERES][2];
};

static void find_row(struct row *w, const struct spheres *s, const struct dem_union_moments *m, double y,
                     double half, double h)
{
    w->n = 0;
    for (size_t k = 0; k < s->n; k++)
    {
        const double *const c = s->at[k];
        const double d = y - (c[1] - m->origin[1]), x = c[0] - m->origin[0] + half;

        if (fabs(d) < c[3])
        {
            const double reach = sqrt(c[3]*c[3] - d*d);
            const long from = (long)fmax(0.0, floor((x - reach)/h - 0.5));
            size_t at = w->n++;

            for (; at > 0 && w->range[at - 1][0] > from; at--)
            {
                memcpy(w->range[at], w->range[at - 1], sizeof *w->range);
                memcpy(w->sphere[at], w->sphere[at - 1], sizeof *w->sphere);
            }
            w->range[at][0] = from;
            w->range[at][1] = (long)ceil((x + reach)/h - 0.5);
            memcpy(w->sphere[at], c, sizeof *w->sphere);
        }
    }
}

/* Only columns that meet a sphere, with the spheres that they may meet. */
static void add_columns(const struct spheres *s, struct dem_union_moments *m, const double half[3])
{
    const double most = width(s);
    const long n[2] = {(long)fmax(COLUMNS, ceil(2.0*half[0]/most)),
                       (long)fmax(COLUMNS, ceil(2.0*half[1]/most))};
    const double h[2] = {2.0*half[0]/(double)n[0], 2.0*half[1]/(double)n[1]};
    struct row w;

    for (long j = 0; j < n[1]; j++)
    {
        const double y = ((double)j + 0.5)*h[1] - half[1];
        struct spheres near = {.n = 0};
        size_t first = 0, end = 0;

        find_row(&w, s, m, y, half[0], h[0]);
        for (long i = w.n > 0 ? w.range[0][0] : n[0]; i < n[0]; i++)
        {
            while (end < w.n && w.range[end][0] <= i)
            {
                end++;
            }
            while (first < end && w.range[first][1] < i)
            {
                first++;
            }
            if (first == end && end == w.n)
            {
                break;
            }
            near.at = (const double (*)[4])(w.sphere + first);
            near.n = end - first;
            add_column(&near, m, (const double[2]){((double)i + 0.5)*h[0] - half[0], y}, h[0]*h[1]);
        }
    }
}

void dem_sphere_union(size_t n, const double (*sphere)[4], struct dem_union_moments *m)
{
    const struct spheres s = {n, sphere};
    double half[3];

    *m = (struct dem_union_moments){.volume = 0.0};
    for (int k = 0; k < 3; k++)
    {
        double low = INFINITY, high = -INFINITY;

        for (size_t i = 0; i < n; i++)
        {
            low = fmin(low, sphere[i][k] - sphere[i][3]);
            high = fmax(high, sphere[i][k] + sphere[i][3]);
        }
        m->origin[k] = 0.5*(low + high);
        half[k] = 0.5*(high - low);
    }
    if (overlap(&s))
    {
        add_columns(&s, m, half);
    }
    else
    {
        add_spheres(&s, m);
    }
}
