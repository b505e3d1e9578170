/*
 * uniform_fluid.h -- fluid columns of particles in a scene with a uniform fluid (no coupling).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/scalar.h"
#include "particles/particles.h"

struct dem_uniform_fluid                                  /* the entry fluid */
{
    int given;                                        /* 1: the scene has the entry */
    /* m/s, kg/m3, Pa s, 1, Pa/m */
    double velocity[3], density, viscosity, void_fraction, pressure_gradient[3];
    double acceleration[3], vorticity[3], stress[3];  /* m/s2, 1/s, N/m3: Du/Dt, curl u, div tau */
    double turbulence[2];                             /* m2/s2, m2/s3: k, epsilon */
    /* scalars that are values of the fluid (fluid_entry): number, indices in the interaction table,
       values */
    int scalars, scalar[DEM_SCALARS];
    double value[DEM_SCALARS];
};

/* Fill the fluid columns of particle i. When the scene gives no fluid they get neutral values, to
   be overwritten by the coupling. `mean` [m]: mean (Sauter) diameter of all particles. */
void dem_uniform_fluid_fill(struct dem_particles *, size_t i, const struct dem_uniform_fluid *,
                      double mean);
