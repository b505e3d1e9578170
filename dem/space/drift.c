/*
 * drift.c -- places in whole units, and their differences.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/drift.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

void dem_drift_free(struct dem_drift *d)
{
    dem_memory_free(d->then);
    memset(d, 0, sizeof *d);
}

size_t dem_drift_bytes(const struct dem_drift *d)
{
    return d->room*sizeof *d->then;
}

/* A double of 2^52 units has no digits after the point: x + 1.5 * 2^52 units ends with x in whole units, whatever its sign. */
static uint32_t whole(const struct dem_drift *d, double x)
{
    const double sum = x + d->round;
    uint64_t bits;

    memcpy(&bits, &sum, sizeof bits);
    return (uint32_t)bits;
}

int dem_drift_begin(struct dem_drift *d, const struct dem_particles *p, double skin)
{
    int binary;

    frexp(skin, &binary);
    d->skin = skin;
    d->spread = 0.0;
    memset(d->centre, 0, sizeof d->centre);
    d->unit = ldexp(1.0, binary - 15);
    d->round = ldexp(1.5, binary - 15 + 52);
    if (3*p->n > d->room || !d->then)
    {
        dem_memory_free(d->then);
        d->then = NULL;
        d->room = 3*(p->n + p->n/32 + 1);                 /* pieces of space change owners by a few */
        DEM_TRY(DEM_NEW(d->then, d->room));
    }
    for (size_t i = 0; i < p->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            d->then[3*i + k] = whole(d, p->record[i].x[k]);
        }
    }
    return DEM_OK;
}

static double way(const struct dem_drift *d, double x, uint32_t then)
{
    return d->unit*(double)(int32_t)(whole(d, x) - then);
}

/* Rounding, then and now, half a unit each along three axes. */
static double surely(const struct dem_drift *d, double distance)
{
    return distance + 2.0*d->unit;
}

void dem_drift_look(const struct dem_drift *d, const struct dem_particles *p, double most[DEM_DRIFT_NUMBERS])
{
    double high[3] = {-INFINITY, -INFINITY, -INFINITY}, low[3] = {INFINITY, INFINITY, INFINITY}, square = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        const double *const x = p->record[i].x;
        const double go[3] = {way(d, x[0], d->then[3*i]), way(d, x[1], d->then[3*i + 1]), way(d, x[2], d->then[3*i + 2])};
        const double here = go[0]*go[0] + go[1]*go[1] + go[2]*go[2];

        for (int k = 0; k < 3; k++)
        {
            high[k] = go[k] > high[k] ? go[k] : high[k];
            low[k] = go[k] < low[k] ? go[k] : low[k];
        }
        square = here > square ? here : square;
    }
    for (int k = 0; k < 3; k++)
    {
        most[k] = high[k];
        most[3 + k] = -low[k];
    }
    most[6] = p->n > 0 ? surely(d, sqrt(square)) : 0.0;
}

int dem_drift_take(struct dem_drift *d, const double most[DEM_DRIFT_NUMBERS], const int free[3], double centre[3])
{
    double half = 0.0;

    for (int k = 0; k < 3; k++)
    {
        const double middle = most[k] >= -most[3 + k] ? 0.5*(most[k] - most[3 + k]) : 0.0;    /* nobody: no middle */

        centre[k] = free[k] ? middle : 0.0;
        half += (fabs(middle - centre[k]) + 0.5*(most[k] + most[3 + k]))*(fabs(middle - centre[k]) + 0.5*(most[k] + most[3 + k]));
    }
    d->spread = most[6];
    memset(d->centre, 0, sizeof d->centre);
    return sqrt(half) < 0.9*most[6];                      /* of the box that all d are in: s is less */
}

double dem_drift_spread(const struct dem_drift *d, const struct dem_particles *p, const double centre[3])
{
    double most = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        const double *const x = p->record[i].x;
        double square = 0.0;

        for (size_t k = 0; k < 3; k++)
        {
            const double go = way(d, x[k], d->then[3*i + k]) - centre[k];

            square += go*go;
        }
        most = square > most ? square : most;
    }
    return p->n > 0 ? surely(d, sqrt(most)) : 0.0;
}

void dem_drift_settle(struct dem_drift *d, double spread, const double centre[3])
{
    d->spread = spread;
    memcpy(d->centre, centre, sizeof d->centre);
}
