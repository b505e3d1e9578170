/*
 * displacement.c -- reference positions as integers; extent and spread of the displacements.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/displacement.h"
#include "core/error.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

void dem_displacement_free(struct dem_displacement *d)
{
    dem_memory_free(d->reference);
    memset(d, 0, sizeof *d);
}

size_t dem_displacement_bytes(const struct dem_displacement *d)
{
    return d->capacity*sizeof *d->reference;
}

/* A double of 2^52 units has no fractional bits: the lowest bits of x + 1.5 * 2^52 units are x in
   whole units, for either sign. */
static uint32_t to_units(const struct dem_displacement *d, double x)
{
    const double sum = x + d->round;
    uint64_t bits;

    memcpy(&bits, &sum, sizeof bits);
    return (uint32_t)bits;
}

int dem_displacement_begin(struct dem_displacement *d, const struct dem_particles *particles,
                           double skin)
{
    int binary;

    frexp(skin, &binary);
    d->skin = skin;
    d->spread = 0.0;
    memset(d->centre, 0, sizeof d->centre);
    d->unit = ldexp(1.0, binary - 15);
    d->round = ldexp(1.5, binary - 15 + 52);
    if (3*particles->n > d->capacity || !d->reference)
    {
        dem_memory_free(d->reference);
        d->reference = NULL;
        d->capacity = 3*(particles->n + particles->n/32 +
                         1);                 /* migration changes n a little */
        DEM_TRY(DEM_NEW(d->reference, d->capacity));
    }
    for (size_t i = 0; i < particles->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            d->reference[3*i + k] = to_units(d, particles->record[i].x[k]);
        }
    }
    return DEM_OK;
}

/* Where a position was when the list was made, if it has followed the flow since. */
static double undeformed(const struct dem_displacement *d, const double x[3], size_t k)
{
    const double y = x[1] - d->origin[1], own = x[k] - d->origin[k] - (k == 0 ? d->slant[0]*y : 0.0);

    return d->origin[k] + d->back[k]*own + (k == 0 ? d->slant[1]*d->back[1]*y : 0.0);
}

static double displacement(const struct dem_displacement *d, const double x[3], size_t k, uint32_t then)
{
    return d->unit*(double)(int32_t)(to_units(d, d->deforms ? undeformed(d, x, k) : x[k]) - then);
}

/* Add the error of rounding both positions by up to half a unit along three axes. */
static double upper_bound(const struct dem_displacement *d, double distance)
{
    return distance + 2.0*d->unit;
}

void dem_displacement_extent(const struct dem_displacement *d,
                             const struct dem_particles *particles,
                             double extent[DEM_DISPLACEMENT_NUMBERS])
{
    double high[3] = {-INFINITY, -INFINITY, -INFINITY}, low[3] = {INFINITY, INFINITY, INFINITY},
           square = 0.0;

    for (size_t i = 0; i < particles->n; i++)
    {
        const double *const x = particles->record[i].x;
        const double d_i[3] = {displacement(d, x, 0, d->reference[3*i]),
                               displacement(d, x, 1, d->reference[3*i + 1]),
                               displacement(d, x, 2, d->reference[3*i + 2])};
        const double here = d_i[0]*d_i[0] + d_i[1]*d_i[1] + d_i[2]*d_i[2];

        for (int k = 0; k < 3; k++)
        {
            high[k] = d_i[k] > high[k] ? d_i[k] : high[k];
            low[k] = d_i[k] < low[k] ? d_i[k] : low[k];
        }
        square = here > square ? here : square;
    }
    for (int k = 0; k < 3; k++)
    {
        extent[k] = high[k];
        extent[3 + k] = -low[k];
    }
    extent[6] = particles->n > 0 ? upper_bound(d, sqrt(square)) : 0.0;
}

int dem_displacement_set_extent(struct dem_displacement *d,
                                const double extent[DEM_DISPLACEMENT_NUMBERS], const int free[3],
                                double centre[3])
{
    double half = 0.0;

    for (int k = 0; k < 3; k++)
    {
        /* 0: no particles */
        const double middle = extent[k] >= -extent[3 + k] ? 0.5*(extent[k] - extent[3 + k]) : 0.0;

        centre[k] = free[k] ? middle : 0.0;
        half += (fabs(middle - centre[k]) + 0.5*(extent[k] + extent[3 + k]))*
                (fabs(middle - centre[k]) + 0.5*(extent[k] + extent[3 + k]));
    }
    d->spread = extent[6];
    memset(d->centre, 0, sizeof d->centre);
    /* half diagonal of the box of all d, a bound of s */
    return sqrt(half) < 0.9*extent[6];
}

double dem_displacement_spread(const struct dem_displacement *d,
                               const struct dem_particles *particles, const double centre[3])
{
    double largest = 0.0;

    for (size_t i = 0; i < particles->n; i++)
    {
        const double *const x = particles->record[i].x;
        double square = 0.0;

        for (size_t k = 0; k < 3; k++)
        {
            const double d_i = displacement(d, x, k, d->reference[3*i + k]) - centre[k];

            square += d_i*d_i;
        }
        largest = square > largest ? square : largest;
    }
    return particles->n > 0 ? upper_bound(d, sqrt(largest)) : 0.0;
}

void dem_displacement_set(struct dem_displacement *d, double spread, const double centre[3])
{
    d->spread = spread;
    memcpy(d->centre, centre, sizeof d->centre);
}
