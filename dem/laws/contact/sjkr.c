/*
 * sjkr.c -- simplified JKR cohesion: an attraction proportional to the contact area.
 *
 *   F_n = ... - w A,    A = 2 pi R* d
 *
 *   w    cohesion energy density, the only setting                 [J/m3]
 *   A    circle in which the undeformed spheres intersect, to first order in d/R*     [m2]
 *   R*   reduced radius, R_i R_j/(R_i + R_j); R_i at a wall        [m]
 *   d    overlap                                                   [m]
 *
 * It is applied after friction and rolling, whose limits therefore count the repulsion alone:
 * mu (F_n + w A), the friction law of Derjaguin under adhesion. Where a bond replaces the contact
 * it does not act.
 *
 * Source: the simplified Johnson-Kendall-Roberts force of LIGGGHTS (sjkr), there with the exact
 * circle.
 * Not here: attraction across a gap, pull-off at a force given by the surface energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/sjkr.h"
#include "laws/effect.h"

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_sjkr, density, "energyDensity", "J/m3", DEM_SETTING_REQUIRED, 0.0, INFINITY,
                   "attraction per area of contact"),
    {0},
};

#define LAW dem_sjkr
#define SETS DEM_SETS_FN
#define ENERGY
#include "laws/contact_loop.h"

/* In use: its largest attraction 2/3 pi^3 w^3 (R* over E*)^2 (with hertz) over the weight, or its
   fraction 3/2 pi w sqrt(R* / d)/E* of the force of an impact at overlap d:
   F = 4/3 E* sqrt(R*) d^(3/2) - 2 pi w R* d. */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double pi = 3.14159265358979324, w = of ? ((const struct dem_sjkr *)of)->density : 0.0;
    const double pull = 2.0/3.0*(pi*w)*(pi*w)*(pi*w)*g->radius*g->radius/(g->modulus*g->modulus);
    const double impact = g->overlap > 0.0 ? 1.5*pi*w/(g->modulus*sqrt(g->overlap)) : 0.0;

    v->fraction = fmax(impact, g->weight > 0.0 ? pull/g->weight : 0.0);
    v->quantity =
        "of the force of an impact, or of the weight, is due to cohesion (the law itself)";
    return of != NULL;
}

const struct dem_effect dem_sjkr = {
    .name = "sjkr",
    .aliases = "sjkr2 cohesion",
    .summary = "cohesion in proportion to the area of contact, -w 2 pi R* d",
    .source = "after Johnson, Kendall, Roberts 1971, simplified",
    .stage = DEM_STAGE_FILM,
    .parcels = DEM_PARCELS_SAME,
    .example = "energyDensity 1e3;",
    .size = sizeof(struct dem_sjkr),
    .settings = settings,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .adhesive = dem_effect_always,
    .mechanism = DEM_MECHANISM_ADHESION,
};
