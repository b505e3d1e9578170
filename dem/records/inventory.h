/*
 * inventory.h -- count what a run holds over all ranks: particles by material and in total, listed
 * pairs, bytes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

struct dem_material_inventory    /* particles of one material, or of all */
{
    int64_t n, frozen;
    double min_diameter, max_diameter;                       /* m   smallest and largest diameter;
                                                 infinite and 0 without particles */
    double diameters, squares, volume, mass;  /* m, m2, m3, kg: sums over particles */
    double moving_volume, moving_mass;        /* m3, kg: of particles that are not frozen */
    double grains, grain_squares;             /* 1, m2: sums over the grains of parcels; of particles
                                                 without parcels */
};

struct dem_inventory
{
    struct dem_material_inventory all, material[DEM_MATERIALS];
    double fluid_density, fluid_viscosity;  /* kg/m3, Pa s: means at the
                                               particles; 0 without fluid */
    int64_t pairs, rows;                    /* listed pairs, contact rows (those at
                                               subdomain borders once a rank) */
    double bytes, max_bytes;               /* memory of all ranks, largest of any rank */
};

/* Collective. The results are the same on all ranks and on any number of ranks, except pairs, rows
   and bytes. Changes nothing. Errors of MPI are recorded (ranks/collect.h). */
void dem_inventory_take(const struct dem_state *, struct dem_inventory *);
