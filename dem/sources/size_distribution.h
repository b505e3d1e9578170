/*
 * size_distribution.h -- diameters of a group of particles: one for all, or drawn from a
 * distribution.
 *
 *     diameter 1e-3;
 *     sizes { type uniform;   min 0.8e-3; max 1.2e-3; }
 *     sizes { type normal;    mean 1e-3; deviation 1e-4; min 7e-4; max 1.3e-3; }
 *     sizes { type logNormal; median 1e-3; deviation 0.2; min 5e-4; max 2e-3; }
 *     sizes { type list;      diameters (1e-3 2e-3); weights (3 1); }
 *     sizes { type table;     file "sieve.csv"; }        rows "diameter, weight"
 *     by number | volume;                                meaning of weights and densities
 *
 * `deviation` is the standard deviation of d [m], or of ln d. Without min and max the range is 3
 * deviations each way.
 *
 * A distribution by volume q3 has the number density q0 ~ q3/d^3. A draw is a function of (seed,
 * number of the particle).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"

struct dem_size_distribution
{
    double min, max;   /* m */
    int n;             /* nodes; 0: all diameters are `min` */
    int smooth;        /* 1: diameters between nodes; 0: at nodes only */
    double *diameter;  /* m  of the nodes; smooth ones in equal steps of the logarithm */
    double *below;     /* 1  cumulative number fraction up to and including the node */
};

/* Read `diameter` or `sizes` of a group and multiply all by a factor (1; l of parcels). To be freed
   also after a failure. */
int dem_size_distribution_read(struct dem_size_distribution *, const struct dem_dict *group,
                               double factor);
void dem_size_distribution_free(struct dem_size_distribution *);

/* Mean volume of a particle [m3]; between nodes with the mean diameter of both, to 1e-5 for
   max/min of 100. */
double dem_size_distribution_mean_volume(const struct dem_size_distribution *);

/* The diameter [m] of the particle with this number. */
double dem_size_distribution_draw(const struct dem_size_distribution *, uint64_t seed,
                                  uint64_t number);
