/*
 * parcel_forces.c -- evaluate fluid effects on the grains of parcels.
 *
 *   result += l^3 result(R/l, V/l^3, m/l^3)
 *
 *   l         ratio of the parcel                                  [1]
 *   R, V, m   radius, volume, mass of the parcel                   [m], [m3], [kg]
 *
 * The result is all that an effect adds to a body batch: forces, drag coefficient with its target,
 * and the same of its particle scalars. The n = l^3 grains have the velocity of the parcel, so
 * parcel and grain have the same drag coefficient over mass, and the response of their sum to the
 * fluid is the sum of their responses. The mean diameter of the surrounding particles is divided
 * by l too; it is used with one ratio only.
 *
 * Source: Sakai and Koshizuka, Chem. Eng. Sci. 64 (2009) 533.
 * Not here: torques, whose sum over grains that spin like the parcel does not turn it as a grain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/parcel_forces.h"
#include <string.h>

enum
{
    SIZES = 4,
    RESULTS = 10 + 3*DEM_EFFECT_SCALARS
};

/* radius, mass, volume, mean diameter of parcels; the batch has the values of grains */
struct sizes
{
    double of[SIZES][DEM_BATCH_ROWS];
};

static void get_sizes(struct dem_body_batch *b, double *column[SIZES])
{
    memcpy(column, (double *[SIZES]){b->radius, b->mass, b->volume, b->mean_diameter},
           SIZES*sizeof *column);
}

static void to_grains(struct dem_body_batch *b, const double *ratio, struct sizes *parcels)
{
    double *column[SIZES];

    get_sizes(b, column);
    for (int k = 0; k < SIZES; k++)
    {
        memcpy(parcels->of[k], column[k], sizeof parcels->of[k]);
    }
    for (int c = 0; c < b->n; c++)
    {
        const double per_length = 1.0/ratio[c], per_grain = per_length*per_length*per_length;

        b->radius[c] *= per_length;
        b->mass[c] *= per_grain;
        b->volume[c] *= per_grain;
        b->mean_diameter[c] *= per_length;
    }
}

static void to_parcels(struct dem_body_batch *b, const struct sizes *parcels)
{
    double *column[SIZES];

    get_sizes(b, column);
    for (int k = 0; k < SIZES; k++)
    {
        memcpy(column[k], parcels->of[k], sizeof parcels->of[k]);
    }
}

static int get_results(const struct dem_effect_entry *e, struct dem_body_batch *b,
                       double *column[RESULTS])
{
    int n = 10;

    memcpy(column, (double *[]){b->fx, b->fy, b->fz, b->drag, b->drag_ux, b->drag_uy, b->drag_uz,
                                b->rx, b->ry, b->rz}, 10*sizeof *column);
    for (int k = 0; k < e->scalars; k++)
    {
        column[n++] = b->scalars[k].rate;
        column[n++] = b->scalars[k].coefficient;
        column[n++] = b->scalars[k].to_target;
    }
    return n;
}

void dem_parcels_prepare(const struct dem_effect_entry *e, struct dem_body_batch *b,
                         const double ratio[DEM_BATCH_ROWS])
{
    struct sizes parcels;

    to_grains(b, ratio, &parcels);
    e->effect->prepare_bodies(e->settings, b);
    to_parcels(b, &parcels);
}

void dem_parcels_apply(const struct dem_effect_entry *e, struct dem_body_batch *b,
                       const double ratio[DEM_BATCH_ROWS])
{
    struct sizes parcels;
    double *column[RESULTS], before[RESULTS][DEM_BATCH_ROWS];
    const int n = get_results(e, b, column);

    for (int k = 0; k < n; k++)
    {
        memcpy(before[k], column[k], sizeof before[k]);
        memset(column[k], 0, sizeof before[k]);
    }
    to_grains(b, ratio, &parcels);
    e->effect->apply_to_bodies(e->settings, b);
    to_parcels(b, &parcels);
    for (int k = 0; k < n; k++)
    {
        for (int c = 0; c < b->n; c++)
        {
            column[k][c] = before[k][c] + ratio[c]*ratio[c]*ratio[c]*column[k][c];
        }
    }
}
