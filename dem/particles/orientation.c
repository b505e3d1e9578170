/*
 * orientation.c -- rotates each sphere by w dt in each drift, staggered with the spin as in
 * leapfrog.
 *
 *   q' = (1, u tan(|u|)/|u|) q / |...|,   u = w dt/2
 *   tan x/x = 1 + x^2/3 + 2 x^4/15 + 17 x^6/315 + 62 x^8/2835 + 1382 x^10/155925
 *
 *   q    orientation, a unit quaternion (Hamilton product)         [1]
 *   w    spin at the middle of the step, global axes               [1/s]
 *
 * (1, n tan x) is the rotation by 2 x about n except for its length, so no sine is needed and the
 * result has the same bits everywhere. The truncated series is in error by 7e-4 x^13 in the angle
 * of a step: 4e-16 at 0.2 rad per step. Division by the length keeps q a unit quaternion.
 *
 * Source: Hamilton 1844; series of the tangent: Abramowitz and Stegun, Handbook of Mathematical
 * Functions (1964), 4.3.67.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/orientation.h"
#include "laws/effect.h"
#include "particles/turn.h"

void dem_orientation_begin(struct dem_particles *p)
{
    double *const q = dem_column(p, DEM_COLUMN_ORIENTATION);

    for (size_t i = 0; q && i < p->n; i++)
    {
        if (q[4*i]*q[4*i] + q[4*i + 1]*q[4*i + 1] + q[4*i + 2]*q[4*i + 2] +
                q[4*i + 3]*q[4*i + 3] ==
            0.0)
        {
            q[4*i] = 1.0;
        }
    }
}

DEM_KERNEL
static void rotate(const struct dem_particle *restrict record, double *restrict all, size_t n,
                   double half)
{
    for (size_t i = 0; i < n; i++)
    {
        dem_turn(record[i].w[0], record[i].w[1], record[i].w[2], half, all + 4*i);
    }
}

void dem_orientation_turn(struct dem_particles *p, double dt)
{
    if (dem_column(p, DEM_COLUMN_ORIENTATION))
    {
        rotate(p->record, dem_column(p, DEM_COLUMN_ORIENTATION), p->n, 0.5*dt);
    }
}
