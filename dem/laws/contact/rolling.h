/*
 * rolling.h -- what rolling resistances without a spring share on a row: the largest moment.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_ROLLING_H
#define DEM_LAWS_ROLLING_H

#include "laws/row.h"

/* Torque over spin [N m s] that stops the rolling in one step: 2/5 m* R*^2/dt. */
DEM_MATH double dem_rolling_max_drag(const struct dem_contact_row *r)
{
    const double per_step = 0.4/dem_select(r->dt > 0.0, r->dt, 1.0);

    return per_step*r->reduced_mass*r->reduced_radius*r->reduced_radius;
}

#endif
