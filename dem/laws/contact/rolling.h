/*
 * rolling.h -- what rolling resistances without a spring share on a row: the largest moment, energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/energy_row.h"

/* Torque over spin [N m s] that stops the rolling in one step: 2/5 m* R*^2/dt. */
DEM_MATH double dem_rolling_max_drag(const struct dem_contact_row *r)
{
    const double per_step = 0.4/dem_select(r->dt > 0.0, r->dt, 1.0);

    return per_step*r->reduced_mass*r->reduced_radius*r->reduced_radius;
}

/* Energy that a moment without a spring dissipates:
 *
 *   P dt - M^2 dt^2/(2 I)      P = -M.w                            [J]
 *
 *   M    moment of the effect on i                                 [N m]
 *   w    relative spin at the start of the step                    [1/s]
 *   I    reduced inertia                                           [kg m2]
 *
 * All energy taken from the spin is dissipated. The second term is exact for a moment that is
 * constant over the step. */
DEM_MATH void dem_rolling_energy(const struct dem_contact_row *r, struct dem_energy_row *e)
{
    const double power = -(e->mx*r->wx + e->my*r->wy + e->mz*r->wz);
    const double square = e->mx*e->mx + e->my*e->my + e->mz*e->mz;

    e->lost = r->touching*(power - 0.5*r->dt*square/e->inertia)*r->dt;
}
