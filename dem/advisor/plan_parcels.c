/*
 * plan_parcels.c -- paragraph of a plan: parcels, which ratios the geometry allows, what they save.
 *
 *   l <= W/(10 d)     the narrowest width W of the domain is 10 parcels across
 *   l <= h/(3 d)      a cell h of the mesh is 3 parcels wide: wider kernels smooth the fluid
 *   l^3, l^4          particles saved; processor time, where contacts limit the time step (t ~ l)
 *
 *   d   Sauter diameter of the grains                              [m]
 *
 * Source: 3 diameters: Peng, Doroodchi, Luo, Moghtaderi, AIChE J. 60 (2014) 2000. That a flow of
 * grains should be about 10 across is common practice, not theory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan.h"
#include <math.h>

static const double across = 10.0, in_cell = 3.0;    /* parcels */

/* l up to which `length` is `parcels` diameters wide */
static void write_limit(struct dem_text *t, double length, double parcels, double grain,
                        const char *what)
{
    const double max = length/(parcels*grain);

    if (length > 0.0 && max >= 1.0)
    {
        dem_text_add(t, "    %s of %.4g m is %g parcels wide up to a ratio of %.3g\n", what, length,
                     parcels, max);
    }
    else if (length > 0.0)
    {
        dem_text_add(t, "    %s of %.4g m is less than %g grains wide\n", what, length, parcels);
    }
}

/* m: smallest width between planes, of a periodic domain or in a cylinder; 0: unknown */
static double narrowest(const struct dem_scene_numbers *s)
{
    double smallest = s->tube > 0.0 ? s->tube : INFINITY;

    for (int axis = 0; axis < 3; axis++)
    {
        smallest = s->width[axis] > 0.0 ? fmin(smallest, s->width[axis]) : smallest;
    }
    return isfinite(smallest) ? smallest : 0.0;
}

void dem_plan_parcels(struct dem_text *t, const struct dem_plan *p)
{
    const struct dem_scene_numbers *const s = &p->scene;
    struct dem_suspension grains;

    if (s->max_parcel_ratio == 0.0 || s->particles == 0.0)
    {
        return;
    }
    (void)dem_plan_suspension(p, &grains);
    const double n = s->particles, grain = grains.diameter, mean = cbrt(s->grains/n);

    dem_text_add(t, "Parcels\n    ratio %g", s->min_parcel_ratio);
    if (s->max_parcel_ratio > s->min_parcel_ratio)
    {
        dem_text_add(t, " to %g", s->max_parcel_ratio);
    }
    dem_text_add(t, ": %.0f parcels of %.6g grains, of Sauter diameter %.4g m\n", n, s->grains,
                 grain);
    write_limit(t, narrowest(s), across, grain, "the narrowest width");
    write_limit(t, p->run.cell, in_cell, grain, "the smallest cell");
    dem_text_add(t,
                 "    against single grains: %.3g times fewer particles, steps up to %.3g times as "
                 "long, %.3g times less processor time\n",
                 s->grains/n, mean, mean*s->grains/n);
}
