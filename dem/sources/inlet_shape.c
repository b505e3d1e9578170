/*
 * inlet_shape.c -- read an inlet, and draw positions on it that are uniform by volume or by area.
 *
 * A uniform point on a triangle: with a = u1, b = u2, replaced by 1 - a, 1 - b where a + b > 1, x =
 * A + a (B - A) + b (C - A). No square root is needed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/inlet_shape.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include "input/stl.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- triangles ------------------------------------------------------------------------------- */

struct triangle                                           /* corners, then the fluid's velocity */
{
    double corner[9], flow[3];
};

static int by_corners(const void *a, const void *b)
{
    const struct triangle *const p = a, *const q = b;

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

static void store(struct dem_inlet_shape *m, const struct triangle *sorted)
{
    double area = 0.0;

    for (size_t t = 0; t < m->n; t++)
    {
        memcpy(m->corner[t], sorted[t].corner, sizeof m->corner[t]);
        memcpy(m->flow[t], sorted[t].flow, sizeof m->flow[t]);
        area += area_of(m->corner[t]);
        m->cumulative_area[t] = area;
    }
}

int dem_inlet_shape_set_triangles(struct dem_inlet_shape *m, size_t n, const double *corners,
                                  const double *flow)
{
    struct triangle *list;

    dem_memory_free(m->corner);
    dem_memory_free(m->flow);
    dem_memory_free(m->cumulative_area);
    m->n = 0;
    m->corner = NULL;                                     /* an allocation that fails leaves them so */
    m->flow = NULL;
    m->cumulative_area = NULL;
    DEM_TRY(DEM_NEW(m->corner, n + 1));
    DEM_TRY(DEM_NEW(m->flow, n + 1));
    DEM_TRY(DEM_NEW(m->cumulative_area, n + 1));
    DEM_TRY(DEM_NEW(list, n + 1));
    m->n = n;
    for (size_t t = 0; t < n; t++)
    {
        memcpy(list[t].corner, corners + 9*t, sizeof list[t].corner);
        for (size_t k = 0; k < 3; k++)
        {
            list[t].flow[k] = flow ? flow[3*t + k] : 0.0;
        }
    }
    dem_sort_by(list, n, sizeof *list, by_corners);
    store(m, list);
    dem_memory_free(list);
    return DEM_OK;
}

void dem_inlet_shape_free(struct dem_inlet_shape *m)
{
    dem_memory_free(m->corner);
    dem_memory_free(m->flow);
    dem_memory_free(m->cumulative_area);
    memset(m, 0, sizeof *m);
}

/* ---- reading --------------------------------------------------------------------------------- */

static int read_disc(struct dem_inlet_shape *m, const struct dem_dict *disc)
{
    struct dem_insertion_shape *const v = &m->shape;

    m->kind = DEM_INLET_DISC;
    DEM_TRY(dem_dict_vector(disc, "centre", "m", v->from));
    DEM_TRY(dem_dict_vector(disc, "normal", "1", v->axis));
    DEM_TRY(dem_dict_number(disc, "radius", "m", &v->radius));
    const double size = dem_vec_norm(v->axis);

    DEM_REQUIRE(size > 0.0 && v->radius > 0.0, DEM_ERROR_INPUT,
                "%s: disc with a normal of length %g and a radius of %g m; give numbers above 0",
                dem_dict_where(disc), size, v->radius);
    for (int k = 0; k < 3; k++)
    {
        v->axis[k] /= size;
    }
    dem_insertion_shape_sides(v);
    return DEM_OK;
}

static int read_surface(struct dem_inlet_shape *m, const struct dem_dict *group, const char *where)
{
    const char *path;
    double scale, *corners;
    size_t n;

    m->kind = DEM_INLET_FACES;
    DEM_TRY(dem_dict_text(group, "surface", &path));
    DEM_TRY(dem_dict_number_or(group, "scale", "1", 1.0, &scale));
    DEM_REQUIRE(scale > 0.0, DEM_ERROR_INPUT, "%s: scale %g; give a number above 0", where, scale);
    DEM_TRY(dem_error_prefix(dem_stl_read(path, scale, &corners, &n), "%s: ", where));
    const int status = dem_inlet_shape_set_triangles(m, n, corners, NULL);

    dem_memory_free(corners);
    DEM_TRY(status);
    DEM_REQUIRE(dem_inlet_shape_area(m) > 0.0, DEM_ERROR_INPUT,
                "%s: the triangles of %s have no area; give a surface", where, path);
    return DEM_OK;
}

int dem_inlet_shape_read(struct dem_inlet_shape *m, const struct dem_dict *group, const char *where)
{
    const struct dem_dict *disc;
    const int boxed = dem_dict_has(group, "min") || dem_dict_has(group, "max");
    const int shapes = boxed + dem_dict_has(group, "cylinder") + dem_dict_has(group, "sphere") +
                       dem_dict_has(group, "disc") + dem_dict_has(group, "surface") +
                       dem_dict_has(group, "patch");

    memset(m, 0, sizeof *m);
    DEM_REQUIRE(shapes == 1, DEM_ERROR_INPUT,
                "%s: %s of min and max, cylinder, sphere, disc, surface, patch; give one of them",
                where, shapes ? "more than one" : "none");
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
        m->kind = DEM_INLET_FACES;
        return dem_dict_word(group, "patch", &m->patch);
    }
    return dem_insertion_shape_read(&m->shape, group);
}

/* ---- queries --------------------------------------------------------------------------------- */

int dem_inlet_shape_check(struct dem_inlet_shape *m, const struct dem_domain *d, double radius,
                          const char *where)
{
    if (m->kind != DEM_INLET_REGION)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_insertion_shape_open(&m->shape, d, where));
    return dem_insertion_shape_check_fits(&m->shape, radius, where);
}

double dem_inlet_shape_area(const struct dem_inlet_shape *m)
{
    return m->kind == DEM_INLET_DISC ? pi*m->shape.radius*m->shape.radius
           : m->kind == DEM_INLET_FACES && m->n > 0 ? m->cumulative_area[m->n - 1]
                                                    : 0.0;
}

void dem_inlet_shape_bounds(const struct dem_inlet_shape *m, double min[3], double max[3])
{
    const struct dem_insertion_shape *const v = &m->shape;

    for (int k = 0; k < 3; k++)
    {
        const double half = m->kind == DEM_INLET_DISC
                                ? v->radius*sqrt(fmax(0.0, 1.0 - v->axis[k]*v->axis[k]))
                                : 0.0;

        min[k] = m->kind == DEM_INLET_REGION ? v->min[k] : v->from[k] - half;
        max[k] = m->kind == DEM_INLET_REGION ? v->max[k] : v->from[k] + half;
        for (size_t t = 0; t < 3*m->n; t++)
        {
            const double x = m->corner[t/3][t%3][k];

            min[k] = t > 0 ? fmin(min[k], x) : x;
            max[k] = t > 0 ? fmax(max[k], x) : x;
        }
    }
}

void dem_inlet_shape_inward(const struct dem_inlet_shape *m, size_t triangle, double inward[3])
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

static int draw_on_disc(const struct dem_insertion_shape *v, const double u[3], double x[3])
{
    const double a = (2.0*u[0] - 1.0)*v->radius, b = (2.0*u[1] - 1.0)*v->radius;

    for (int k = 0; k < 3; k++)
    {
        x[k] = v->from[k] + a*v->side[0][k] + b*v->side[1][k];
    }
    return a*a + b*b <= v->radius*v->radius;
}

static void draw_on_faces(const struct dem_inlet_shape *m, const double u[3], double x[3],
                          size_t *triangle)
{
    const double area = u[2]*m->cumulative_area[m->n - 1], fold = u[0] + u[1] > 1.0 ? 1.0 : 0.0;
    const double a = fold > 0.0 ? 1.0 - u[0] : u[0], b = fold > 0.0 ? 1.0 - u[1] : u[1];
    size_t low = 0, high = m->n - 1;

    while (low < high)
    {
        const size_t middle = (low + high)/2;

        if (m->cumulative_area[middle] > area)
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

int dem_inlet_shape_draw(const struct dem_inlet_shape *m, double radius, const double u[3],
                         double x[3], size_t *triangle)
{
    *triangle = 0;
    switch (m->kind)
    {
    case DEM_INLET_REGION:
        return dem_insertion_shape_draw(&m->shape, radius, u, x);
    case DEM_INLET_DISC:
        return draw_on_disc(&m->shape, u, x);
    default:
        if (m->n > 0)
        {
            draw_on_faces(m, u, x, triangle);
        }
        return m->n > 0;
    }
}
