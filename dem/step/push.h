/*
 * push.h -- four rows' forces from columns into their records.
 *
 * f: force on i along x, y, z and the arm; t: n x F. Columns of four rows each, of which these are four records.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_PUSH_H
#define DEM_STEP_PUSH_H

#include "state/contacts.h"
#include "step/quad.h"

__attribute__((always_inline)) static inline void dem_push_put(struct dem_push *push, dem_quad f[4], dem_quad t[4])
{
    dem_quad_turn(f);
    dem_quad_turn(t);
    for (int k = 0; k < 4; k++)
    {
        DEM_QUAD_AT(push[k].f) = f[k];
        DEM_QUAD_AT(push[k].t) = t[k];
    }
}

__attribute__((always_inline)) static inline void dem_push_put_single(struct dem_push_single *push, dem_quad f[4], dem_quad t[4])
{
    dem_quad_turn(f);
    dem_quad_turn(t);
    for (int k = 0; k < 4; k++)
    {
        DEM_QUAD_SINGLE_AT(push[k].f) = DEM_QUAD_NARROW(f[k]);
        DEM_QUAD_SINGLE_AT(push[k].t) = DEM_QUAD_NARROW(t[k]);
    }
}

#endif
