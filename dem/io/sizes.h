/*
 * sizes.h -- diameters of a group: one for all, or drawn from a distribution.
 *
 *     diameter 1e-3;
 *     sizes { type uniform;   min 0.8e-3; max 1.2e-3; }
 *     sizes { type normal;    mean 1e-3; deviation 1e-4; min 7e-4; max 1.3e-3; }      min, max: 3 deviations unless given
 *     sizes { type logNormal; median 1e-3; deviation 0.2; min 5e-4; max 2e-3; }       deviation of ln d
 *     sizes { type list;      diameters (1e-3 2e-3); weights (3 1); }
 *     sizes { type table;     file "sieve.csv"; }                                     rows "diameter, weight"
 *     by number | volume;                                                             what weights and densities count
 *
 * A distribution by volume q3 has the numbers q0 ~ q3/d^3. A draw is a function of (seed, number of the particle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_SIZES_H
#define DEM_IO_SIZES_H

#include "io/dictionary.h"

struct dem_sizes
{
    double least, most;                                   /* m */
    int n;                                                /* nodes; 0: all are `least` */
    int smooth;                                           /* 1: between nodes; 0: at nodes */
    double *diameter;                                     /* m  of the nodes, smooth ones in equal steps of the logarithm */
    double *below;                                        /* 1  share of all particles up to and with the node */
};

/* Reads `diameter` or `sizes`. Free it also after a failure. */
int dem_sizes_read(struct dem_sizes *, const struct dem_dict *group);
void dem_sizes_free(struct dem_sizes *);

/* Of a particle in the mean [m3]; between nodes the middle stands for all, to 1e-5 for widths of 1:100. */
double dem_sizes_mean_volume(const struct dem_sizes *);

double dem_sizes_draw(const struct dem_sizes *, uint64_t seed, uint64_t number);

#endif
