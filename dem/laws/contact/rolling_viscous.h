/*
 * rolling_viscous.h -- row function of rolling_viscous.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/rolling.h"

struct dem_rolling_viscous
{
    double time;
};

DEM_MATH void dem_rolling_viscous_row(const struct dem_rolling_viscous *l,
                                      struct dem_contact_row *r, double *history)
{
    const double hx = r->hx, hy = r->hy, hz = r->hz, R = r->reduced_radius;
    const double twist = r->wx*hx + r->wy*hy + r->wz*hz;
    const double viscous = dem_select(r->fn > 0.0, l->time*R*r->fn, 0.0);
    const double max_drag = dem_rolling_max_drag(r);
    const double drag = dem_select(viscous < max_drag, viscous, max_drag);    /* N m s */

    (void)history;
    r->mx -= drag*(r->wx - twist*hx);
    r->my -= drag*(r->wy - twist*hy);
    r->mz -= drag*(r->wz - twist*hz);
}

DEM_MATH void dem_rolling_viscous_energy_row(const struct dem_rolling_viscous *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    dem_rolling_energy(r, e);
}
