/*
 * beetstra.c -- drag in a swarm of spheres of one size or several, after lattice-Boltzmann simulations.
 *
 *   G = y e F(e, Re),   y = d/<d>
 *   F = 10 s/e^2 + e^2 (1 + 1.5 sqrt s) + 0.413 Re/(24 e^2) (1/e + 3 e s + 8.4 Re^-0.343)/(1 + 10^(3 s) Re^-(1 + 4 s)/2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number of the mean sphere, e rho <d> |u - v|/mu                      [1]
 *   d    diameter of the particle                                  [m]
 *   <d>  Sauter mean diameter of the mixture, sum d^3/sum d^2: a setting, or that of the particles
 *        around each (mean around; of all where the fluid is uniform); without either <d> = d        [m]
 *
 * F is the paper's, on 3 pi mu d U with the superficial slip U = e (u - v): hence the e. Its last term is written with
 * both its fractions multiplied by powers of Re, so that nothing is 0/0 at rest. G -> 1 for e -> 1, Re -> 0; for a
 * lone sphere at Re = 100 it is 16 % above Schiller and Naumann's.
 *
 * Of several sizes: the paper's e y + s y^2 goes with the whole force; its second part is the pressure gradient's, which
 * acts by itself here, so y is left, and b goes with d^2.
 *
 * Source: Beetstra, van der Hoef, Kuipers, AIChE J. 53 (2007) 489.
 * Not here: the mean slip of the place in Re (the particle's own is taken); 0.064 e y^3, a correction for wide mixtures,
 * because it would not vanish for equal spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

struct beetstra
{
    double mean_diameter;
    int mean;
};

enum
{
    GIVEN,
    AROUND
};
static const char *const means[] = {"given", "around", NULL};

static const struct dem_field settings[] = {
    DEM_FIELD_AS(beetstra, mean_diameter, "meanDiameter", "m", 0.0, 0.0, INFINITY,
                 "Sauter mean of the mixture, sum d^3/sum d^2; 0: each particle as if among its equals"),
    DEM_FIELD_CHOICE(beetstra, mean, "mean", GIVEN, means,
                     "meanDiameter, or the Sauter mean of the particles around each, by the coupling's kernel"),
    {0},
};

/* the paper's F: creeping, then inertial flow */
static inline __attribute__((always_inline)) double paper(double e, double re)
{
    const double s = 1.0 - e, half = 0.5*(1.0 + 4.0*s), power = dem_pow(re, half);
    const double ten = dem_exp(6.90775527898213705*s);    /* 10^(3 s): 3 ln 10 */
    const double creeping = 10.0*s/(e*e) + e*e*(1.0 + 1.5*sqrt(s));
    const double above = (1.0/e + 3.0*e*s)*re + 8.4*dem_pow(re, 0.657);

    return creeping + 0.413/(24.0*e*e)*above*(power/(power + ten));
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    const struct beetstra *const own = of;
    const int around = own->mean == AROUND;

    for (int c = 0; c < b->n; c++)
    {
        const double mean = dem_pick(around, b->mean_diameter[c], own->mean_diameter);
        const double e = dem_drag_void(b->void_fraction[c]), d = 2.0*b->radius[c];
        const double y = dem_pick(mean > 0.0, d/dem_pick(mean > 0.0, mean, 1.0), 1.0);
        const double re = dem_drag_reynolds(b, c, e)/dem_pick(y > 0.0, y, 1.0);

        dem_drag_add(b, c, y*e*paper(e, re));
    }
}

static unsigned asks(const void *of)
{
    return ((const struct beetstra *)of)->mean == AROUND ? DEM_NEEDS_MEAN_DIAMETER : 0;
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    const struct beetstra *const own = of;

    (void)pair;
    DEM_REQUIRE(own->mean == GIVEN || own->mean_diameter == 0.0, DEM_ERROR_INPUT,
                "beetstra: meanDiameter %g m and mean around are two means; leave one of them out", own->mean_diameter);
    return DEM_OK;
}

const struct dem_effect dem_beetstra = {
    .name = "beetstra",
    .says = "drag from packed to dilute, of one size or several, fitted to simulations",
    .source = "Beetstra, van der Hoef, Kuipers 2007",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .size = sizeof(struct beetstra),
    .settings = settings,
    .asks = asks,
    .prepare = prepare,
    .act_on_bodies = act_on_bodies,
};
