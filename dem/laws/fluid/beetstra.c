/*
 * beetstra.c -- drag of Beetstra et al. for one or several sizes.
 *
 *   G = y e F(e, Re),   y = d/<d>
 *   F = 10 s/e^2 + e^2 (1 + 1.5 sqrt s)
 *       + 0.413 Re/(24 e^2) (1/e + 3 e s + 8.4 Re^-0.343)/(1 + 10^(3 s) Re^-(1 + 4 s)/2)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number of <d>, e rho <d> |u - v|/mu  [1]
 *   d    diameter of the particle                                  [m]
 *   <d>  Sauter mean diameter of the mixture, sum d^3/sum d^2: a setting, or of the particles
 *        around each particle (mean around; of all particles where the fluid is uniform); with
 *        neither, <d> = d                                          [m]
 *
 * F is as in the paper, normalised by 3 pi mu d U with the superficial slip U = e (u - v): hence
 * the factor e. In its last term both fractions are multiplied by powers of Re, so that nothing is
 * 0/0 at rest. G -> 1 for e -> 1, Re -> 0; for a single sphere at Re = 100 it is 16 % above
 * Schiller and Naumann.
 *
 * Several sizes: the factor e y + s y^2 of the paper belongs to the whole force; its second part
 * comes from the pressure gradient, which is a separate force here, so y remains, and b is
 * proportional to d^2.
 *
 * Source: Beetstra, van der Hoef, Kuipers, AIChE J. 53 (2007) 489, from lattice-Boltzmann
 * simulations.
 * Not here: the local mean slip in Re (the particle's slip is used); 0.064 e y^3, a correction for
 * wide mixtures, because it would not vanish for equal spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/beetstra.h"

static const char *const means[] = {"given", "around", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_beetstra, mean_diameter, "meanDiameter", "m", 0.0, 0.0, INFINITY,
                 "Sauter mean of the mixture, sum d^3/sum d^2; 0: the particle's own diameter"),
    DEM_SETTING_CHOICE(dem_beetstra, mean, "mean", DEM_BEETSTRA_GIVEN, means,
                     "meanDiameter, or the Sauter mean of the surrounding particles"),
    {0},
};

#define LAW dem_beetstra
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

static unsigned extra_needs(const void *of)
{
    const struct dem_beetstra *const own = of;

    return own->mean == DEM_BEETSTRA_AROUND ? DEM_NEEDS_MEAN_DIAMETER : 0;
}

static int prepare(void *of, const struct dem_pair_class *pair)
{
    const struct dem_beetstra *const own = of;

    (void)pair;
    DEM_REQUIRE(own->mean == DEM_BEETSTRA_GIVEN || own->mean_diameter == 0.0, DEM_ERROR_INPUT,
                "beetstra: meanDiameter %g m and mean around exclude each other; give one of "
                "them", own->mean_diameter);
    return DEM_OK;
}

const struct dem_effect dem_beetstra = {
    .name = "beetstra",
    .aliases = "Beetstra BeetstraDrag BVK",
    .summary =
        "drag from packed to dilute, for one or several sizes, fitted to lattice-Boltzmann simulations",
    .source = "Beetstra, van der Hoef, Kuipers 2007",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .size = sizeof(struct dem_beetstra),
    .settings = settings,
    .extra_needs = extra_needs,
    .prepare = prepare,
    .apply_to_bodies = apply_to_bodies,
};
