/*
 * bed_packing.h -- height and void fraction of a bed of particles as they are now.
 *
 *   F(z)   fraction of the solid volume of the particles that move below the height z along -g, of
 *          each sphere what lies below the plane: (2 + 3 s - s^3)/4, s = (z - z_i)/r_i in [-1, 1]
 *   z_10, z_90   F = 0.1 and 0.9: the slab in between is the bed without its uneven top and the
 *                layer at its bottom
 *   e = 1 - V_s/(A (z_90 - z_10)), V_s the solid volume in the slab, of frozen particles too, A its
 *       mean cross-section [m2]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

struct dem_bed_packing
{
    double up[3];       /* 1   against gravity */
    double low, high;   /* m   the slab: heights x . up */
    double solid;       /* m3  volume of particles in it */
};

/* Collective. Returns 0 without gravity or without particles that move; else 1. */
int dem_bed_packing_measure(const struct dem_state *, struct dem_bed_packing *);

/* 1: void fraction of the slab of this mean cross-section [m2] */
double dem_bed_packing_void_fraction(const struct dem_bed_packing *, double area);
