/*
 * contact_force.h -- store the contact forces of four rows: from columns into one record a row.
 *
 * f: force on particle i along x, y, z, and in the fourth place the distance by which the lever arm
 * is shorter than the radius (`arm`). t: n x F. The arguments are columns of four rows each; they
 * are transposed into four records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_CONTACT_FORCE_H
#define DEM_STEP_CONTACT_FORCE_H

#include "model/contacts.h"
#include "step/vec4.h"

__attribute__((always_inline)) static inline void
dem_contact_force_store(struct dem_contact_force *to, dem_vec4 f[4], dem_vec4 t[4])
{
    dem_transpose4(f);
    dem_transpose4(t);
    for (int k = 0; k < 4; k++)
    {
        DEM_VEC4_AT(to[k].f) = f[k];
        DEM_VEC4_AT(to[k].t) = t[k];
    }
}

#endif
