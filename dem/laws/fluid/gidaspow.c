/*
 * gidaspow.c -- drag of Ergun in dense and of Wen and Yu in dilute flow, with a smooth transition.
 *
 *   G = (1 - phi) G_E + phi G_WY,   G_E = (150 s/e + 1.75 Re/e)/18,   G_WY = e^-2.65 F1(Re)
 *   phi = 1/2 + atan(150*1.75 (0.2 - s))/pi   (smooth)   or   0 for e < 0.8, 1 otherwise (switch)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *   F1   single sphere, see wen_yu.c                               [1]
 *
 * With `blend switch` G is discontinuous at e = 0.8 (Re = 200: from 26.4 to 12.1), which makes the
 * fluid solver oscillate; therefore smooth is the default. It costs accuracy at the ends: phi is
 * 0.994 and not 1 at e = 1, and G is 0.9985 of Ergun's at e = 0.2.
 *
 * Source: Gidaspow, Multiphase Flow and Fluidization (1994); Ergun, Chem. Eng. Prog. 48 (1952) 89;
 * Wen and Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100; transition: Lu and Gidaspow, Chem. Eng.
 * Sci. 58 (2003) 3777.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/gidaspow.h"

static const char *const blends[] = {"smooth", "switch", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING_CHOICE(dem_gidaspow, blend, "blend", DEM_GIDASPOW_SMOOTH, blends,
                     "transition from Ergun to Wen and Yu at void fraction 0.8: smooth, or the "
                     "original switch"),
    {0},
};

#define LAW dem_gidaspow
#define PREPARES DEM_SETS_VOIDAGE_FACTOR
#define SETS DEM_SETS_DRAG
#include "laws/body_loop.h"

const struct dem_effect dem_gidaspow = {
    .name = "gidaspow",
    .aliases = "ErgunWenYu ErgunWenYuDrag ergunWenYu",
    .summary =
        "drag of Ergun below void fraction 0.8, of Wen and Yu above, with a smooth transition or a switch",
    .source = "Gidaspow 1994; Lu and Gidaspow 2003",
    .stage = DEM_STAGE_FLUID,
    .parcels = DEM_PARCELS_GRAINS,
    .drag = DEM_DRAG_BED,
    .needs = DEM_NEEDS_FLUID,
    .size = sizeof(struct dem_gidaspow),
    .settings = settings,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
