/*
 * chords.h -- chords that the spheres or discs of a clump cut from a line, and their union.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/particles.h"
#include <math.h>
#include <string.h>

struct dem_chords
{
    int n;
    double at[DEM_CLUMP_SPHERES][2];    /* m  begin and end, sorted by the begin */
};

/* Add the chord of a sphere whose centre is at `middle` along the line, and whose radius squared less the
   square of its distance from the line is `square` [m2]; nothing where the line misses it. */
static inline void dem_chords_add(struct dem_chords *c, double middle, double square)
{
    if (square > 0.0)
    {
        const double half = sqrt(square), begin = middle - half;
        int k = c->n++;

        for (; k > 0 && c->at[k - 1][0] > begin; k--)
        {
            memcpy(c->at[k], c->at[k - 1], sizeof *c->at);
        }
        c->at[k][0] = begin;
        c->at[k][1] = middle + half;
    }
}

/* Join chords that overlap: disjoint ones are left. */
static inline void dem_chords_unite(struct dem_chords *c)
{
    int last = 0;

    for (int k = 1; k < c->n; k++)
    {
        if (c->at[k][0] <= c->at[last][1])
        {
            c->at[last][1] = fmax(c->at[last][1], c->at[k][1]);
        }
        else
        {
            memmove(c->at[++last], c->at[k], sizeof *c->at);    /* may be the same */
        }
    }
    c->n = c->n > 0 ? last + 1 : 0;
}
