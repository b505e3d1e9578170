/*
 * mouth.c -- reading a mouth, and places in it that are even by volume or by area.
 *
 * A point even on a triangle: with a = u1, b = u2, folded where a + b > 1, x = A + a (B - A) + b (C - A); no root is needed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/mouth.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/vec.h"
#include "io/stl.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- triangles ----------------------------------------------------------------------------------------------- */

struct row                                                /* of a triangle: corners, then the fluid's velocity */
{
    double corner[9], flow[3];
};

static int by_corners(const void *a, const void *b)
{
    const struct row *const p = a, *const q = b;

    for (int k = 0; k < 9; k++)
    {
        if (p->corner[k] != q->corner[k])
        {
            return p->corner[k] < q->corner[k] ? -1 : 1;
        }
    }
    return 0;
}

static double area_of(double corner[3][3])
{
    double ab[3], ac[3], n[3];

    dem_vec_minus(corner[1], corner[0], ab);
    dem_vec_minus(corner[2], corner[0], ac);
    dem_vec_cross(ab, ac, n);
    return 0.5*dem_vec_norm(n);
}

static void fill(struct dem_mouth *m, const struct row *row)
{
    double area = 0.0;

    for (size_t t = 0; t < m->n; t++)
    {
        memcpy(m->corner[t], row[t].corner, sizeof m->corner[t]);
        memcpy(m->flow[t], row[t].flow, sizeof m->flow[t]);
        area += area_of(m->corner[t]);
        m->below[t] = area;
    }
}

int dem_mouth_take(struct dem_mouth *m, size_t n, const double *corners, const double *flow)
{
    struct row *row;

    dem_memory_free(m->corner);
    dem_memory_free(m->flow);
    dem_memory_free(m->below);
    m->n = n;
    DEM_TRY(DEM_NEW(m->corner, n + 1));
    DEM_TRY(DEM_NEW(m->flow, n + 1));
    DEM_TRY(DEM_NEW(m->below, n + 1));
    DEM_TRY(DEM_NEW(row, n + 1));
    for (size_t t = 0; t < n; t++)
    {
        memcpy(row[t].corner, corners + 9*t, sizeof row[t].corner);
        for (size_t k = 0; k < 3; k++)
        {
            row[t].flow[k] = flow ? flow[3*t + k] : 0.0;
        }
    }
    dem_sort_by(row, n, sizeof *row, by_corners);
    fill(m, row);
    dem_memory_free(row);
    return DEM_OK;
}

void dem_mouth_free(struct dem_mouth *m)
{
    dem_memory_free(m->corner);
    dem_memory_free(m->flow);
    dem_memory_free(m->below);
    memset(m, 0, sizeof *m);
}

/* ---- reading ------------------------------------------------------------------------------------------------- */

static int read_disc(struct dem_mouth *m, const struct dem_dict *disc)
{
    struct dem_vessel *const v = &m->vessel;

    m->kind = DEM_MOUTH_DISC;
    DEM_TRY(dem_dict_vector(disc, "centre", "m", v->from));
    DEM_TRY(dem_dict_vector(disc, "normal", "1", v->axis));
    DEM_TRY(dem_dict_number(disc, "radius", "m", &v->radius));
    const double size = dem_vec_norm(v->axis);

    DEM_REQUIRE(size > 0.0 && v->radius > 0.0, DEM_ERROR_INPUT, "%s: disc with a normal of length %g and a radius of %g m; give numbers above 0",
                dem_dict_where(disc), size, v->radius);
    for (int k = 0; k < 3; k++)
    {
        v->axis[k] /= size;
    }
    dem_vessel_sides(v);
    return DEM_OK;
}

static int read_surface(struct dem_mouth *m, const struct dem_dict *group, const char *where)
{
    const char *path;
    double scale, *corners;
    size_t n;

    m->kind = DEM_MOUTH_FACES;
    DEM_TRY(dem_dict_text(group, "surface", &path));
    DEM_TRY(dem_dict_number_or(group, "scale", "1", 1.0, &scale));
    DEM_REQUIRE(scale > 0.0, DEM_ERROR_INPUT, "%s: scale %g; give a number above 0", where, scale);
    DEM_TRY(dem_error_prefix(dem_stl_read(path, scale, &corners, &n), "%s: ", where));
    const int status = dem_mouth_take(m, n, corners, NULL);

    dem_memory_free(corners);
    DEM_TRY(status);
    DEM_REQUIRE(dem_mouth_area(m) > 0.0, DEM_ERROR_INPUT, "%s: the triangles of %s have no area; give a surface", where, path);
    return DEM_OK;
}

int dem_mouth_read(struct dem_mouth *m, const struct dem_dict *group, const char *where)
{
    const struct dem_dict *disc;
    const int boxed = dem_dict_has(group, "min") || dem_dict_has(group, "max");
    const int ways = boxed + dem_dict_has(group, "cylinder") + dem_dict_has(group, "sphere") + dem_dict_has(group, "disc")
                     + dem_dict_has(group, "surface") + dem_dict_has(group, "patch");

    memset(m, 0, sizeof *m);
    DEM_REQUIRE(ways == 1, DEM_ERROR_INPUT, "%s: %s of min and max, cylinder, sphere, disc, surface, patch; give one of them", where,
                ways ? "more than one" : "none");
    DEM_TRY(dem_dict_sub_if(group, "disc", &disc));
    if (disc)
    {
        return read_disc(m, disc);
    }
    if (dem_dict_has(group, "surface"))
    {
        return read_surface(m, group, where);
    }
    if (dem_dict_has(group, "patch"))
    {
        m->kind = DEM_MOUTH_FACES;
        return dem_dict_word(group, "patch", &m->patch);
    }
    return dem_vessel_read(&m->vessel, group);
}

/* ---- asking -------------------------------------------------------------------------------------------------- */

int dem_mouth_holds(const struct dem_mouth *m, double radius, const char *where)
{
    return m->kind == DEM_MOUTH_REGION ? dem_vessel_holds(&m->vessel, radius, where) : DEM_OK;
}

double dem_mouth_area(const struct dem_mouth *m)
{
    return m->kind == DEM_MOUTH_DISC ? pi*m->vessel.radius*m->vessel.radius : m->kind == DEM_MOUTH_FACES && m->n > 0 ? m->below[m->n - 1] : 0.0;
}

void dem_mouth_box(const struct dem_mouth *m, double min[3], double max[3])
{
    const struct dem_vessel *const v = &m->vessel;

    for (int k = 0; k < 3; k++)
    {
        const double half = m->kind == DEM_MOUTH_DISC ? v->radius*sqrt(fmax(0.0, 1.0 - v->axis[k]*v->axis[k])) : 0.0;

        min[k] = m->kind == DEM_MOUTH_REGION ? v->min[k] : v->from[k] - half;
        max[k] = m->kind == DEM_MOUTH_REGION ? v->max[k] : v->from[k] + half;
        for (size_t t = 0; t < 3*m->n; t++)
        {
            const double x = m->corner[t/3][t%3][k];

            min[k] = t > 0 ? fmin(min[k], x) : x;
            max[k] = t > 0 ? fmax(max[k], x) : x;
        }
    }
}

void dem_mouth_inward(const struct dem_mouth *m, size_t triangle, double inward[3])
{
    double ab[3], ac[3];

    inward[0] = inward[1] = inward[2] = 0.0;
    if (m->patch && triangle < m->n)
    {
        dem_vec_minus(m->corner[triangle][1], m->corner[triangle][0], ab);
        dem_vec_minus(m->corner[triangle][2], m->corner[triangle][0], ac);
        dem_vec_cross(ac, ab, inward);
        const double size = dem_vec_norm(inward);

        for (int k = 0; k < 3; k++)
        {
            inward[k] = size > 0.0 ? inward[k]/size : 0.0;
        }
    }
}

static int place_on_disc(const struct dem_vessel *v, const double u[3], double x[3])
{
    const double a = (2.0*u[0] - 1.0)*v->radius, b = (2.0*u[1] - 1.0)*v->radius;

    for (int k = 0; k < 3; k++)
    {
        x[k] = v->from[k] + a*v->side[0][k] + b*v->side[1][k];
    }
    return a*a + b*b <= v->radius*v->radius;
}

static void place_on_faces(const struct dem_mouth *m, const double u[3], double x[3], size_t *triangle)
{
    const double area = u[2]*m->below[m->n - 1], fold = u[0] + u[1] > 1.0 ? 1.0 : 0.0;
    const double a = fold > 0.0 ? 1.0 - u[0] : u[0], b = fold > 0.0 ? 1.0 - u[1] : u[1];
    size_t low = 0, high = m->n - 1;

    while (low < high)
    {
        const size_t middle = (low + high)/2;

        if (m->below[middle] > area)
        {
            high = middle;
        }
        else
        {
            low = middle + 1;
        }
    }
    for (int k = 0; k < 3; k++)
    {
        const double *const c[3] = {m->corner[low][0], m->corner[low][1], m->corner[low][2]};

        x[k] = c[0][k] + a*(c[1][k] - c[0][k]) + b*(c[2][k] - c[0][k]);
    }
    *triangle = low;
}

int dem_mouth_place(const struct dem_mouth *m, double radius, const double u[3], double x[3], size_t *triangle)
{
    *triangle = 0;
    switch (m->kind)
    {
    case DEM_MOUTH_REGION:
        return dem_vessel_place(&m->vessel, radius, u, x);
    case DEM_MOUTH_DISC:
        return place_on_disc(&m->vessel, u, x);
    default:
        if (m->n > 0)
        {
            place_on_faces(m, u, x, triangle);
        }
        return m->n > 0;
    }
}
