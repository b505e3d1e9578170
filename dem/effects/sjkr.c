/*
 * sjkr.c -- spheres in contact attract each other in proportion to the area of their contact.
 *
 *   F_n = ... - w A,    A = 2 pi R* d
 *
 *   w    cohesion energy density, the only setting                 [J/m3]
 *   A    the circle in which the undeformed spheres meet, to first order in d/R*                    [m2]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   d    overlap                                                   [m]
 *
 * It acts after friction and rolling, whose limits so count the repulsion alone: mu (F_n + w A), Derjaguin's law of friction under
 * adhesion. It does nothing where a bond stands in place of the surfaces (sealed).
 *
 * Source: the simplified Johnson-Kendall-Roberts force of LIGGGHTS (sjkr), there with the exact circle.
 * Not here: attraction past touching, pull-off at a force that the surface energy gives.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "base/math.h"

struct sjkr
{
    double density;
};

static const struct dem_field settings[] = {
    DEM_FIELD_AS(sjkr, density, "energyDensity", "J/m3", DEM_FIELD_REQUIRED, 0.0, INFINITY, "attraction per area of contact"),
    {0},
};

DEM_KERNEL
static void act(const void *of, struct dem_block *restrict b, dem_real *const *memory)
{
    const dem_real scale = 6.28318530717958648*((const struct sjkr *)of)->density;

    (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        b->fn[c] -= scale*b->reduced_radius[c]*dem_pick(b->sealed[c] > 0.0, 0.0, b->overlap[c]);
    }
}

/* what it takes to part them; a bond that seals the surfaces lets them keep it */
static void energy(const void *of, const struct dem_block *restrict b, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict e)
{
    const dem_real scale = 6.28318530717958648*((const struct sjkr *)of)->density;

    (void)before, (void)memory;
    for (int c = 0; c < b->n; c++)
    {
        const dem_real held = -0.5*scale*b->reduced_radius[c]*b->overlap[c]*b->overlap[c];

        e->stored[c] = b->sealed[c] > 0.0 ? 0.0 : held;
        e->lost[c] = b->sealed[c] > 1.0 ? held : 0.0;
    }
}

const struct dem_effect dem_sjkr = {
    .name = "sjkr",
    .says = "cohesion in proportion to the area of contact, -w 2 pi R* d",
    .source = "after Johnson, Kendall, Roberts 1971, simplified",
    .stage = DEM_STAGE_FILM,
    .size = sizeof(struct sjkr),
    .settings = settings,
    .act = act,
    .energy = energy,
};
