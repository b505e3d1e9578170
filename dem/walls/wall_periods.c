/*
 * wall_periods.c -- periodic images of walls, and the check of walls that meet periodic faces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/wall_periods.h"
#include "core/error.h"
#include "core/memory.h"
#include "walls/wall_extent.h"
#include <math.h>
#include <stdio.h>

void dem_domain_make_walls_periodic(const struct dem_domain *d, double reach, struct dem_walls *w)
{
    w->reach = reach;
    for (int k = 0; k < 3; k++)
    {
        w->periodic |= d->periodic[k];
        w->period[k] = d->length[k];
        w->unit[k] = d->unit[k];
        w->face[0][k] = d->min[k];
        w->face[1][k] = d->max[k];
    }
}

/* Extent along an axis of a wall without triangles in its whole motion. A plane or an inclined cylinder that crosses
   the axis extends to infinity; a wall parallel to the axis has an empty extent. */
static void primitive_extent(const struct dem_walls *all, const struct dem_wall *w, int axis, double extent[2])
{
    const double along = fabs(w->normal[axis]);
    const int parallel = w->shape == DEM_SHAPE_PLANE
                             ? along < 1e-6
                             : w->shape == DEM_SHAPE_CYLINDER && along > 1.0 - 1e-12;
    const int bounded =
        w->shape == DEM_SHAPE_SPHERE || (w->shape == DEM_SHAPE_CYLINDER && along < 1e-6);

    extent[0] = parallel ? INFINITY : -INFINITY;
    extent[1] = parallel ? -INFINITY : INFINITY;
    if (bounded)
    {
        dem_walls_swept_point(all, w->frame, w->point, axis, extent);
        extent[0] -= w->radius;
        extent[1] += w->radius;
    }
}

/* 1 when a vector is not along an axis, to this fraction of its length. */
static int is_across(const double v[3], int axis, double fraction)
{
    return fmax(fabs(v[(axis + 1)%3]), fabs(v[(axis + 2)%3])) > fraction*fabs(v[axis]);
}

/* A surface whose rotation leans by less than this off a periodic axis has the velocity of its
   images to round-off. */
static const double round_off = 1e-12;

/* a rotation about another axis than a periodic one */
struct leaning
{
    const double *about;          /* NULL: none */
    const char *what;
};

static struct leaning leaning_of(const struct dem_walls *w, const struct dem_wall *of, int axis)
{
    const struct dem_motion *const m = of->frame < 0 ? NULL : &w->frame[of->frame].motion;
    const struct dem_compound_motion *const c = m ? w->frame[of->frame].compound : NULL;
    int any;
    const double *const about =
        c ? dem_compound_motion_leans(c, axis, &any)
          : m && m->kind == DEM_MOTION_ROTATION && is_across(m->axis, axis, 0.0) ? m->axis : NULL;

    return about ? (struct leaning){about, "its rotation"}
           : of->driven && is_across(of->drive.spin, axis, round_off)
               ? (struct leaning){of->drive.spin, "surfaceRotation"}
               : (struct leaning){NULL, ""};
}

static int check_primitive(const struct dem_domain *d, int axis, double radius,
                           const struct dem_walls *w, const struct dem_wall *of)
{
    const struct leaning l = leaning_of(w, of, axis);
    double extent[2];

    primitive_extent(w, of, axis, extent);
    DEM_REQUIRE(!l.about || extent[0] < extent[1], DEM_ERROR_INPUT,
                "wall %s runs through the periodic faces of domain along %c, where only a rotation about %c is "
                "periodic, and %s is about (%g %g %g); build it from triangles that end a radius (%g m) before the "
                "faces, or remove %c from domain/periodic", of->name, "xyz"[axis], "xyz"[axis], l.what,
                l.about ? l.about[0] : 0.0, l.about ? l.about[1] : 0.0, l.about ? l.about[2] : 0.0, radius, "xyz"[axis]);
    for (int side = 0; side < 2; side++)
    {
        const double face = side ? d->max[axis] : d->min[axis];

        DEM_REQUIRE(
            extent[0] >= face + radius || extent[1] <= face - radius, DEM_ERROR_INPUT,
            "wall %s comes%s nearer than a radius (%g m) to the periodic face %s %c = %g m of domain and does not run "
            "straight through it: particles beyond the face would not touch the wall and would overlap it when they "
            "are wrapped; move the wall away from the face%s, build it from triangles, or remove %c from "
            "domain/periodic",
            of->name, of->frame < 0 ? "" : ", in its motion,", radius, side ? "max" : "min", "xyz"[axis], face,
            of->frame < 0 ? "" : ", give its motion an end (if that is a stage, atMost or duration to all stages before it)",
            "xyz"[axis]);
    }
    return DEM_OK;
}

/* Names all periodic axes that are in the way. */
static int refuse_free_rotation(const struct dem_domain *d, const struct dem_walls *w, const struct dem_wall *of,
                                const struct dem_wall_rotation *t)
{
    const char about = t->axis[0] != 0.0 ? 'x' : t->axis[1] != 0.0 ? 'y' : 'z';
    char rotations[] = "x y z", along[] = "x, y, z", cure[24];
    int n = 0, last = 0;

    if (t->axes == 1)
    {
        snprintf(rotations, sizeof rotations, "%c", about);
    }
    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k] && leaning_of(w, of, k).about)
        {
            snprintf(along + 3*n, sizeof along - (size_t)(3*n), "%c, ", "xyz"[k]);
            last = k;
            n++;
        }
    }
    along[3*n - 2] = '\0';
    snprintf(cure, sizeof cure, n == 1 ? "give rotations (%c)" : "leave rotations out", "xyz"[last]);
    return dem_error(DEM_ERROR_INPUT, "wall %s has rotations (%s) and may come to any place of domain, which is "
                     "periodic along %s; remove %s from domain/periodic, or %s", of->name, rotations, along, along, cure);
}

/* A rotation about another axis than a periodic one takes images apart. */
static int check_rotation(const struct dem_domain *d, int axis, double radius,
                          const struct dem_walls *w, const struct dem_triangle *t)
{
    const struct dem_wall *const of = &w->wall[t->wall];
    const struct dem_compound_motion *const c = of->frame < 0 ? NULL : w->frame[of->frame].compound;
    const struct leaning l = leaning_of(w, of, axis);
    double extent[2];

    if (!l.about)
    {
        return DEM_OK;
    }
    if (c && c->body && c->body->rotation.axes > 0)
    {
        return refuse_free_rotation(d, w, of, &c->body->rotation);
    }
    dem_walls_swept_extent(w, t, axis, extent);
    for (int side = 0; side < 2; side++)
    {
        const double face = side ? d->max[axis] : d->min[axis];

        DEM_REQUIRE(
            extent[0] >= face + radius || extent[1] <= face - radius, DEM_ERROR_INPUT,
            "wall %s: %s about (%g %g %g) brings it nearer than a radius (%g m) to the periodic face %s %c = %g m "
            "of domain, where only a rotation about %c is periodic; move the wall away from the face, or remove %c "
            "from domain/periodic",
            of->name, l.what, l.about[0], l.about[1], l.about[2], radius,
            side ? "max" : "min", "xyz"[axis], face, "xyz"[axis], "xyz"[axis]);
    }
    return DEM_OK;
}

/* Slope along a periodic axis below which a surface counts as straight. */
static const double max_slope = 0.05;

/* Fraction of a radius by which a surface that ends at both faces may be longer: round-off of its
   corners in a file. */
static const double longer = 1e-3;

/* A surface longer than the period lies beside its image; where it is straight both are one. */
static int check_length(const struct dem_walls *w, int axis, double radius,
                        const double (*extent)[2])
{
    const double period = w->period[axis];

    for (size_t t = 0; t < w->triangles; t++)
    {
        const struct dem_triangle *const here = &w->triangle[t];
        const double length = extent[here->wall][1] - extent[here->wall][0],
                     slope = fabs(w->facet[here->facet].normal[axis]);
        double own[2] = {INFINITY, -INFINITY};

        for (int k = 0; k < 3; k++)
        {
            own[0] = fmin(own[0], here->corner[k][axis]);
            own[1] = fmax(own[1], here->corner[k][axis]);
        }
        DEM_REQUIRE(length <= period + longer*radius || slope <= max_slope ||
                        (own[0] >= extent[here->wall][1] - period &&
                         own[1] <= extent[here->wall][0] + period),
                    DEM_ERROR_INPUT,
                    "wall %s is %g m long along %c, the periodic domain %g m, and where it meets its own image it "
                    "is not straight (slope %.2g, the limit is %g); cut it off at the periodic faces, or remove %c "
                    "from domain/periodic",
                    w->wall[here->wall].name, length, "xyz"[axis], period, slope, max_slope,
                    "xyz"[axis]);
    }
    return DEM_OK;
}

static int check_lengths(const struct dem_walls *w, int axis, double radius)
{
    double (*extent)[2];

    DEM_TRY(DEM_NEW(extent, w->walls + 1));
    for (int k = 0; k < w->walls; k++)
    {
        extent[k][0] = INFINITY;
        extent[k][1] = -INFINITY;
    }
    for (size_t t = 0; t < w->triangles; t++)
    {
        double *const of = extent[w->triangle[t].wall];

        for (int k = 0; k < 3; k++)
        {
            of[0] = fmin(of[0], w->triangle[t].corner[k][axis]);
            of[1] = fmax(of[1], w->triangle[t].corner[k][axis]);
        }
    }
    const int status = check_length(w, axis, radius, (const double (*)[2])extent);

    dem_memory_free(extent);
    return status;
}

int dem_domain_check_walls(const struct dem_domain *d, const struct dem_walls *w, double radius)
{
    for (int axis = 0; axis < 3; axis++)
    {
        for (int k = 0; d->periodic[axis] && k < w->walls; k++)
        {
            if (w->wall[k].shape != DEM_SHAPE_TRIANGLES)
            {
                DEM_TRY(check_primitive(d, axis, radius, w, &w->wall[k]));
            }
        }
        for (size_t t = 0; d->periodic[axis] && t < w->triangles; t++)
        {
            DEM_TRY(check_rotation(d, axis, radius, w, &w->triangle[t]));
        }
        DEM_TRY(d->periodic[axis] && w->triangles > 0 ? check_lengths(w, axis, radius) : DEM_OK);
    }
    return DEM_OK;
}
