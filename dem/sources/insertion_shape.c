/*
 * insertion_shape.c -- read a box, cylinder or sphere; volume, points and paths inside, uniform
 * random points, projection into it.
 *
 * Random points of a circle or a ball are points of the square or cube around it, drawn again when
 * they lie outside: no sine or cosine, whose last bits depend on the library.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insertion_shape.h"
#include "core/error.h"
#include "core/vec.h"
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- reading --------------------------------------------------------------------------------- */

static int read_box(struct dem_insertion_shape *v, const struct dem_dict *group)
{
    v->kind = DEM_INSERTION_SHAPE_BOX;
    DEM_TRY(dem_dict_vector(group, "min", "m", v->min));
    return dem_dict_vector(group, "max", "m", v->max);
}

void dem_insertion_shape_sides(struct dem_insertion_shape *v)
{
    double along[3] = {0.0, 0.0, 0.0};
    int smallest = 0;

    for (int k = 1; k < 3; k++)
    {
        smallest = fabs(v->axis[k]) < fabs(v->axis[smallest]) ? k : smallest;
    }
    along[smallest] = 1.0;
    dem_vec_cross(v->axis, along, v->side[0]);
    const double size = dem_vec_norm(v->side[0]);

    for (int k = 0; k < 3; k++)
    {
        v->side[0][k] /= size;
    }
    dem_vec_cross(v->axis, v->side[0], v->side[1]);
}

static int read_cylinder(struct dem_insertion_shape *v, const struct dem_dict *dict)
{
    double to[3];

    v->kind = DEM_INSERTION_SHAPE_CYLINDER;
    DEM_TRY(dem_dict_vector(dict, "from", "m", v->from));
    DEM_TRY(dem_dict_vector(dict, "to", "m", to));
    DEM_TRY(dem_dict_number(dict, "radius", "m", &v->radius));
    for (int k = 0; k < 3; k++)
    {
        v->axis[k] = to[k] - v->from[k];
    }
    v->length = dem_vec_norm(v->axis);
    DEM_REQUIRE(v->length > 0.0 && v->radius > 0.0, DEM_ERROR_INPUT,
                "%s: length %g m, radius %g m; give from and to apart and a radius above 0",
                dem_dict_where(dict), v->length, v->radius);
    for (int k = 0; k < 3; k++)
    {
        v->axis[k] /= v->length;
        const double across = v->radius*sqrt(fmax(0.0, 1.0 - v->axis[k]*v->axis[k]));

        v->min[k] = fmin(v->from[k], to[k]) - across;
        v->max[k] = fmax(v->from[k], to[k]) + across;
    }
    dem_insertion_shape_sides(v);
    return DEM_OK;
}

static int read_sphere(struct dem_insertion_shape *v, const struct dem_dict *dict)
{
    v->kind = DEM_INSERTION_SHAPE_SPHERE;
    DEM_TRY(dem_dict_vector(dict, "centre", "m", v->from));
    DEM_TRY(dem_dict_number(dict, "radius", "m", &v->radius));
    DEM_REQUIRE(v->radius > 0.0, DEM_ERROR_INPUT, "%s: radius %g m; give a number above 0",
                dem_dict_where(dict), v->radius);
    for (int k = 0; k < 3; k++)
    {
        v->min[k] = v->from[k] - v->radius;
        v->max[k] = v->from[k] + v->radius;
    }
    return DEM_OK;
}

int dem_insertion_shape_read(struct dem_insertion_shape *v, const struct dem_dict *group)
{
    const struct dem_dict *cylinder, *sphere;

    memset(v, 0, sizeof *v);
    DEM_TRY(dem_dict_sub_if(group, "cylinder", &cylinder));
    DEM_TRY(dem_dict_sub_if(group, "sphere", &sphere));
    DEM_REQUIRE((cylinder != NULL) + (sphere != NULL)
                        + (dem_dict_has(group, "min") || dem_dict_has(group, "max"))
                    <= 1,
                DEM_ERROR_INPUT,
                "%s: more than one of min and max, cylinder, sphere; keep one region",
                dem_dict_where(group));
    return cylinder ? read_cylinder(v, cylinder)
         : sphere ? read_sphere(v, sphere)
                    : read_box(v, group);
}

/* ---- periodic faces -------------------------------------------------------------------------- */

/* of the width of the domain: positions this near to a face lie on it */
static const double on_face = 1e-9;

static int is_face(const struct dem_domain *d, int k, double x)
{
    return fmin(fabs(x - d->min[k]), fabs(x - d->max[k])) <= on_face*d->length[k];
}

int dem_insertion_shape_open(struct dem_insertion_shape *v, const struct dem_domain *d,
                             const char *where)
{
    for (int k = 0; k < 3; k++)
    {
        const double wide = v->max[k] - v->min[k];
        const int whole = wide >= d->length[k]*(1.0 - on_face);

        DEM_REQUIRE(!d->periodic[k] || wide <= d->length[k]*(1.0 + on_face), DEM_ERROR_INPUT,
                    "%s: the %s is %g m wide along %c, where the domain is periodic and %g m wide, "
                    "so it overlaps its own image; make it as wide as the domain, or less",
                    where, dem_insertion_shape_name(v), wide, "xyz"[k], d->length[k]);
        v->period[k] = d->length[k];
        for (int side = 0; side < 2 && d->periodic[k]; side++)
        {
            const int open = whole || is_face(d, k, side ? v->max[k] : v->min[k]);
            const int end = v->axis[k] > 0.0 ? side : 1 - side;

            v->open[k][side] = v->kind == DEM_INSERTION_SHAPE_BOX && open;
            v->open_end[end] |= v->kind == DEM_INSERTION_SHAPE_CYLINDER && open
                             && fabs(v->axis[k]) > 1.0 - 1e-12;
        }
    }
    return DEM_OK;
}

/* What to add to x to come to the periodic image that is nearest to the middle of the shape. */
static double image_shift(const struct dem_insertion_shape *v, int k, double x)
{
    const double middle = 0.5*(v->min[k] + v->max[k]), period = v->period[k];

    return period > 0.0 ? period*rint((middle - x)/period) : 0.0;
}

/* ---- queries --------------------------------------------------------------------------------- */

/* The distances that a sphere keeps from both sides of a box. */
static double inset(const struct dem_insertion_shape *v, int k, int side, double radius)
{
    return v->open[k][side] ? 0.0 : radius;
}

static double end_inset(const struct dem_insertion_shape *v, int end, double radius)
{
    return v->open_end[end] ? 0.0 : radius;
}

double dem_insertion_shape_volume(const struct dem_insertion_shape *v)
{
    if (v->region > 0.0)
    {
        return v->region;
    }
    switch (v->kind)
    {
    case DEM_INSERTION_SHAPE_CYLINDER:
        return pi*v->radius*v->radius*v->length;
    case DEM_INSERTION_SHAPE_SPHERE:
        return 4.0/3.0*pi*v->radius*v->radius*v->radius;
    default:
        return (v->max[0] - v->min[0])*(v->max[1] - v->min[1])*(v->max[2] - v->min[2]);
    }
}

const char *dem_insertion_shape_name(const struct dem_insertion_shape *v)
{
    return v->kind == DEM_INSERTION_SHAPE_CYLINDER ? "cylinder"
         : v->kind == DEM_INSERTION_SHAPE_SPHERE ? "sphere"
                                                   : "box";
}

int dem_insertion_shape_check_fits(const struct dem_insertion_shape *v, double radius,
                                   const char *where)
{
    const double fits = radius*(1.0 - 1e-9);    /* 0.3 - 0.2 is less than 0.1 */

    for (int k = 0; k < 3 && v->kind == DEM_INSERTION_SHAPE_BOX; k++)
    {
        DEM_REQUIRE(v->max[k] - v->min[k] >= inset(v, k, 0, fits) + inset(v, k, 1, fits),
                    DEM_ERROR_INPUT,
                    "%s: the box is %g m wide along %c, less than the diameter %g m; enlarge it",
                    where, v->max[k] - v->min[k], "xyz"[k], 2.0*radius);
    }
    DEM_REQUIRE(v->kind == DEM_INSERTION_SHAPE_BOX
                    || (v->radius >= fits
                        && (v->kind == DEM_INSERTION_SHAPE_SPHERE
                            || v->length >= end_inset(v, 0, fits) + end_inset(v, 1, fits))),
                DEM_ERROR_INPUT, "%s: the %s is narrower than the diameter %g m; enlarge it", where,
                dem_insertion_shape_name(v), 2.0*radius);
    return DEM_OK;
}

int dem_insertion_shape_draw(const struct dem_insertion_shape *v, double radius, const double u[3],
                             double x[3])
{
    const double free = v->radius - radius, base = end_inset(v, 0, radius);
    const double a = (2.0*u[0] - 1.0)*free, b = (2.0*u[1] - 1.0)*free, c = (2.0*u[2] - 1.0)*free;
    const double h = base + (v->length - (base + end_inset(v, 1, radius)))*u[2];

    for (int k = 0; k < 3; k++)
    {
        const double low = inset(v, k, 0, radius), both = low + inset(v, k, 1, radius);

        x[k] = v->kind == DEM_INSERTION_SHAPE_BOX
                 ? v->min[k] + low + (v->max[k] - v->min[k] - both)*u[k]
             : v->kind == DEM_INSERTION_SHAPE_CYLINDER
                 ? v->from[k] + h*v->axis[k] + a*v->side[0][k] + b*v->side[1][k]
                 : v->from[k]
                       + (k == 0 ? a
                          : k == 1 ? b
                                   : c);
    }
    return v->kind == DEM_INSERTION_SHAPE_BOX
        || a*a + b*b + (v->kind == DEM_INSERTION_SHAPE_SPHERE ? c*c : 0.0) <= free*free;
}

int dem_insertion_shape_contains(const struct dem_insertion_shape *v, const double x[3])
{
    double r[3], h = 0.0;
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= x[k] >= v->min[k] && x[k] <= v->max[k];
        r[k] = x[k] - v->from[k];
        h += r[k]*v->axis[k];    /* the axis of a sphere is 0 */
    }
    if (v->kind == DEM_INSERTION_SHAPE_BOX || !inside)
    {
        return inside;
    }
    return dem_vec_dot(r, r) - h*h <= v->radius*v->radius
        && (v->kind == DEM_INSERTION_SHAPE_SPHERE || (h >= 0.0 && h <= v->length));
}

/* ---- paths ----------------------------------------------------------------------------------- */

/* Quotients are formed only where they are in 0 .. 1, so that none overflows. */
int dem_insertion_shape_clip(double at, double step, double low, double high, double part[2])
{
    const double size = fabs(step);
    const double in = step < 0.0 ? at - high : low - at, out = step < 0.0 ? at - low : high - at;

    if (in > size || out < 0.0)
    {
        return 0;
    }
    part[0] = in > 0.0 && in/size > part[0] ? in/size : part[0];
    part[1] = out < size && out/size < part[1] ? out/size : part[1];
    return part[0] <= part[1];
}

int dem_insertion_shape_meets(const struct dem_insertion_shape *v, const double from[3],
                              const double step[3], const double part[2])
{
    double inside[2] = {part[0], part[1]}, r[3], across[3];

    if (v->kind == DEM_INSERTION_SHAPE_BOX)
    {
        int meets = 1;

        for (int k = 0; k < 3; k++)
        {
            meets = meets
                 && dem_insertion_shape_clip(from[k], step[k], v->min[k], v->max[k], inside);
        }
        return meets;
    }
    dem_vec_minus(from, v->from, r);
    const double h = dem_vec_dot(r, v->axis), along = dem_vec_dot(step, v->axis);

    if (v->kind == DEM_INSERTION_SHAPE_CYLINDER
        && !dem_insertion_shape_clip(h, along, 0.0, v->length, inside))
    {
        return 0;
    }
    for (int k = 0; k < 3; k++)    /* the axis of a sphere is 0 */
    {
        r[k] -= h*v->axis[k];
        across[k] = step[k] - along*v->axis[k];
    }
    /* the path is nearest to the axis at t = -r.across/across^2, or at an end of its part */
    const double square = dem_vec_dot(across, across), to = -dem_vec_dot(r, across);
    const double t = to <= inside[0]*square ? inside[0]
                   : to >= inside[1]*square ? inside[1]
                                            : to/square;

    for (int k = 0; k < 3; k++)
    {
        r[k] += t*across[k];
    }
    return dem_vec_dot(r, r) <= v->radius*v->radius;
}

/* ---- confinement ----------------------------------------------------------------------------- */

static void confine_to_box(const struct dem_insertion_shape *v, double radius, double x[3])
{
    for (int k = 0; k < 3; k++)
    {
        if (!v->open[k][0] || !v->open[k][1] || v->min[k] >= v->max[k])
        {
            const double shift = image_shift(v, k, x[k]), there = x[k] + shift;
            const double low = v->min[k] + inset(v, k, 0, radius);
            const double high = v->max[k] - inset(v, k, 1, radius);
            const double at = there > low ? there : low;

            x[k] = (at < high ? at : high) - shift;    /* no fmin: packing calls this often */
        }
    }
}

void dem_insertion_shape_confine(const struct dem_insertion_shape *v, double radius, double x[3])
{
    double shift[3];

    if (v->kind == DEM_INSERTION_SHAPE_BOX)
    {
        confine_to_box(v, radius, x);
        return;
    }
    const double free = v->radius - radius;
    double r[3], h = 0.0;

    for (int k = 0; k < 3; k++)
    {
        shift[k] = image_shift(v, k, x[k]);
        r[k] = x[k] + shift[k] - v->from[k];
        h += r[k]*v->axis[k];    /* the axis of a sphere is 0 */
    }
    for (int k = 0; k < 3; k++)
    {
        r[k] -= h*v->axis[k];
    }
    const double size = dem_vec_norm(r), keep = size > free ? free/size : 1.0;

    h = v->open_end[0] && v->open_end[1] && v->length > 0.0
          ? h
          : fmin(fmax(h, end_inset(v, 0, radius)), v->length - end_inset(v, 1, radius));
    for (int k = 0; k < 3; k++)
    {
        x[k] = v->from[k] + keep*r[k]
             + (v->kind == DEM_INSERTION_SHAPE_CYLINDER ? h*v->axis[k] : 0.0) - shift[k];
    }
}
