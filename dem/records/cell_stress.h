/*
 * cell_stress.h -- stress, fabric and modulus of the contacts of a periodic cell, exact sums over all
 * ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once


struct dem_state;

struct dem_cell_measured
{
    double stress[6];             /* Pa  xx yy zz xy yz zx, tension positive: contacts and motion */
    double fabric[6];             /* 1   mean of n n over the contacts with a force */
    double modulus[3];            /* Pa  sum k l^2 n^4/V along the axes */
    double mass, solid, volume;   /* kg; m3 of particles; m3 of the cell */
    double contacts;              /* with a force */
};

/* Collective. After a step whose forces of all rows are stored (contact_forces.h). */
void dem_cell_measure(const struct dem_state *, struct dem_cell_measured *);

/* Work of the cell over the time `span` [s] with the forces of the last sweep, into the energy balance. */
void dem_cell_add_work(struct dem_state *, double span);
