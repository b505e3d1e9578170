/*
 * rolling_constant.h -- rolling torque of one contact, the row function of rolling_constant.c,
 * which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/rolling.h"

struct dem_rolling_constant
{
    double friction;
};

DEM_MATH void dem_rolling_constant_row(const struct dem_rolling_constant *l,
                                       struct dem_contact_row *r, double *history)
{
    const double hx = r->hx, hy = r->hy, hz = r->hz, R = r->reduced_radius;
    const double twist = r->wx*hx + r->wy*hy + r->wz*hz;
    const double wx = r->wx - twist*hx, wy = r->wy - twist*hy, wz = r->wz - twist*hz;
    const double size = sqrt(wx*wx + wy*wy + wz*wz);

    /* N m s: torque over spin, of friction, limited to what stops the rolling in this step */
    const double torque = dem_select(r->fn > 0.0, l->friction*R*r->fn, 0.0);
    const double max_drag = dem_rolling_max_drag(r);
    const double drag =
        dem_select(torque < max_drag*size, torque/dem_select(size > 0.0, size, 1.0),
                   dem_select(torque > 0.0, max_drag, 0.0));

    (void)history;
    r->mx -= drag*wx;
    r->my -= drag*wy;
    r->mz -= drag*wz;
}

DEM_MATH void dem_rolling_constant_energy_row(const struct dem_rolling_constant *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    (void)l, (void)before, (void)after;
    dem_rolling_energy(r, e);
}
