/*
 * domain.c -- wrapping and counting images; the planes of flat axes; walls at periodic faces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/domain.h"
#include "base/error.h"
#include <math.h>
#include <string.h>

void dem_domain_init(struct dem_domain *d)
{
    memset(d, 0, sizeof *d);
    for (int k = 0; k < 3; k++)
    {
        d->min[k] = -INFINITY;
        d->max[k] = INFINITY;
    }
}

/* The unit is the spacing of doubles two boxes away from the domain. A double of 2^52 units has no digits after the point: to add
   1.5 * 2^52 units and to take them away again rounds to whole ones. */
void dem_domain_close(struct dem_domain *d)
{
    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            const double length = d->max[k] - d->min[k];
            int binary;

            frexp(fmax(fabs(d->min[k]), fabs(d->max[k])) + 2.0*length, &binary);
            d->unit[k] = ldexp(1.0, binary - 53);
            d->round[k] = ldexp(1.5, binary - 1);
            d->length[k] = d->unit[k]*rint(length/d->unit[k]);
        }
        if (d->flat[k])
        {
            d->plane[k] = 0.5*(d->min[k] + d->max[k]);
            d->round[k] = 1e300;
        }
    }
}

void dem_domain_shifts(const struct dem_domain *d, double shift[DEM_SHIFTS][4])
{
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        for (int k = 0; k < 3; k++)
        {
            shift[code][k] = dem_shift_axis(code, k)*d->length[k];
        }
        shift[code][3] = 0.0;
    }
}

enum
{
    MOST_BOXES = 1024                                     /* who is further from a periodic box than so many is lost */
};

static int can_wrap(const struct dem_domain *d, int k, double x)
{
    return d->periodic[k] && fabs(x - d->min[k]) < MOST_BOXES*d->length[k];
}

void dem_domain_wrap(const struct dem_domain *d, struct dem_particle *p)
{
    for (int k = 0; k < 3; k++)
    {
        const int wraps = can_wrap(d, k, p->x[k]);

        p->x[k] = wraps ? d->unit[k]*rint(p->x[k]/d->unit[k]) : p->x[k];
        while (wraps && p->x[k] < d->min[k])
        {
            p->x[k] += d->length[k];
            p->image = dem_image_add(p->image, k, -1);
        }
        while (wraps && p->x[k] >= d->max[k])
        {
            p->x[k] -= d->length[k];
            p->image = dem_image_add(p->image, k, 1);
        }
    }
}

int dem_domain_holds(const struct dem_domain *d, const double x[3])
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= can_wrap(d, k, x[k]) || (x[k] >= d->min[k] && x[k] <= d->max[k]);
    }
    return inside;
}

/* ---- flat axes ----------------------------------------------------------------------------------------------- */

int dem_domain_lay(const struct dem_domain *d, struct dem_particle *p)
{
    for (int k = 0; k < 3; k++)
    {
        if (d->flat[k] && fabs(p->x[k] - d->plane[k]) > p->radius)
        {
            return 0;
        }
    }
    for (int k = 0; k < 3; k++)
    {
        p->x[k] = d->flat[k] ? d->plane[k] : p->x[k];
        p->v[k] = d->flat[k] ? 0.0 : p->v[k];
        p->w[k] = d->flat[(k + 1)%3] || d->flat[(k + 2)%3] ? 0.0 : p->w[k];
    }
    return 1;
}

int dem_domain_lay_all(const struct dem_domain *d, struct dem_particles *p)
{
    for (size_t i = 0; i < p->n; i++)
    {
        struct dem_particle *const q = &p->record[i];

        for (int k = 0; k < 3; k++)
        {
            DEM_REQUIRE(!d->flat[k] || fabs(q->x[k] - d->plane[k]) <= q->radius, DEM_ERROR_INPUT,
                        "particle %lld is at %c = %g m, but the domain is flat there and holds all centres at %g m; start it within a radius "
                        "of that, for example in a region of one diameter (%g m) about it", (long long)q->id, "xyz"[k], q->x[k],
                        d->plane[k], 2.0*q->radius);
            DEM_REQUIRE(!d->flat[k] || q->v[k] == 0.0, DEM_ERROR_INPUT,
                        "particle %lld moves by %g m/s along %c, where the domain is flat; start it without", (long long)q->id, q->v[k],
                        "xyz"[k]);
        }
        dem_domain_lay(d, q);
    }
    return DEM_OK;
}

void dem_domain_hold(const struct dem_domain *d, struct dem_particles *p)
{
    for (int k = 0; k < 3; k++)
    {
        for (size_t i = 0; d->flat[k] && i < p->n; i++)
        {
            p->record[i].v[k] = 0.0;
            p->record[i].w[(k + 1)%3] = 0.0;
            p->record[i].w[(k + 2)%3] = 0.0;
        }
    }
}

/* ---- walls at periodic faces --------------------------------------------------------------------------------- */

/* Slope along a periodic axis below which a wall counts as straight: a sphere then misses half of its square, 1e-3 of a radius. */
static const double straight = 0.05;

/* Where a triangle begins and ends along an axis, as it stands in the world. */
static void reach_of_triangle(const struct dem_walls *w, const struct dem_triangle *t, int axis, double reach[2])
{
    const int moving = w->wall[t->wall].moving;

    reach[0] = INFINITY;
    reach[1] = -INFINITY;
    for (int k = 0; k < 3; k++)
    {
        double there[3];

        memcpy(there, t->corner[k], sizeof there);
        if (moving >= 0)
        {
            dem_pose_point(&w->moving[moving].pose, t->corner[k], there);
        }
        reach[0] = fmin(reach[0], there[axis]);
        reach[1] = fmax(reach[1], there[axis]);
    }
}

static double slope_of_triangle(const struct dem_walls *w, const struct dem_triangle *t, int axis)
{
    const int moving = w->wall[t->wall].moving;
    double normal[3];

    memcpy(normal, w->region[t->region].normal, sizeof normal);
    if (moving >= 0)
    {
        dem_pose_direction(&w->moving[moving].pose, w->region[t->region].normal, normal);
    }
    return fabs(normal[axis]);
}

/* The same for a wall that is no triangles; a plane or slanted tube that crosses the axis reaches everywhere. */
static void reach_of_whole(const struct dem_wall *w, int axis, double reach[2])
{
    const double along = fabs(w->normal[axis]);
    const int straight_on = w->shape == DEM_SHAPE_PLANE ? along < 1e-6 : w->shape == DEM_SHAPE_CYLINDER && along > 1.0 - 1e-12;
    const int bounded = w->shape == DEM_SHAPE_SPHERE || (w->shape == DEM_SHAPE_CYLINDER && along < 1e-6);

    reach[0] = straight_on ? INFINITY : bounded ? w->point[axis] - w->radius : -INFINITY;
    reach[1] = straight_on ? -INFINITY : bounded ? w->point[axis] + w->radius : INFINITY;
}

static int check_reach(const struct dem_domain *d, int axis, double radius, const double reach[2], const char *name)
{
    for (int side = 0; side < 2; side++)
    {
        const double face = side ? d->max[axis] : d->min[axis];

        DEM_REQUIRE(reach[0] >= face + radius || reach[1] <= face - radius, DEM_ERROR_INPUT,
                    "wall %s comes nearer than a radius (%g m) to the periodic face %s %c = %g m of domain and does not run straight through it:"
                    " particles behind the face would not touch it and enter it when they come around; keep it off the face, or leave %c out of"
                    " domain/periodic", name, radius, side ? "max" : "min", "xyz"[axis], face, "xyz"[axis]);
    }
    return DEM_OK;
}

int dem_domain_check_walls(const struct dem_domain *d, const struct dem_walls *w, double radius)
{
    double reach[2];

    for (int axis = 0; axis < 3; axis++)
    {
        for (int k = 0; d->periodic[axis] && k < w->walls; k++)
        {
            if (w->wall[k].shape != DEM_SHAPE_TRIANGLES)
            {
                reach_of_whole(&w->wall[k], axis, reach);
                DEM_TRY(check_reach(d, axis, radius, reach, w->wall[k].name));
            }
        }
        for (size_t t = 0; d->periodic[axis] && t < w->triangles; t++)
        {
            if (slope_of_triangle(w, &w->triangle[t], axis) > straight)
            {
                reach_of_triangle(w, &w->triangle[t], axis, reach);
                DEM_TRY(check_reach(d, axis, radius, reach, w->wall[w->triangle[t].wall].name));
            }
        }
    }
    return DEM_OK;
}
