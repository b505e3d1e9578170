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

#include "laws/fluid/drag.h"

struct gidaspow
{
    int blend;
};

enum
{
    SMOOTH,
    SWITCH
};
static const char *const blends[] = {"smooth", "switch", NULL};

static const struct dem_setting settings[] = {
    DEM_SETTING_CHOICE(gidaspow, blend, "blend", SMOOTH, blends,
                     "transition from Ergun to Wen and Yu at void fraction 0.8: smooth, or the "
                     "original switch"),
    {0},
};

/* atan x: |x| > 1 by pi/2 - atan(1/x); the angle is halved twice, so that its tangent is below
   0.2 and 11 terms of the series suffice: the next is below 0.2^22/23 = 2e-17 of the first */
static inline double arctangent(double x)
{
    const double size = fabs(x);
    const double z = dem_select(size > 1.0, 1.0/dem_select(size > 1.0, size, 1.0), size);
    const double half = z/(1.0 + sqrt(1.0 + z*z));
    const double t = half/(1.0 + sqrt(1.0 + half*half));
    const double w = t*t;
    const double sum =
        1.0 -
        w*(1.0/3.0 -
             w*(1.0/5.0 -
                  w*(1.0/7.0 -
                       w*(1.0/9.0 -
                            w*(1.0/11.0 -
                                 w*(1.0/13.0 -
                                      w*(1.0/15.0 -
                                           w*(1.0/17.0 - w*(1.0/19.0 - w/21.0)))))))));
    const double angle = 4.0*t*sum;
    const double y = dem_select(size > 1.0, 1.57079632679489662 - angle, angle);

    return dem_select(x < 0.0, -y, y);
}

/* e^-2.65 and phi */
DEM_MATH void voidage_factors(const void *settings, double e, double *factor)
{
    const int smooth = ((const struct gidaspow *)settings)->blend == SMOOTH;
    const double pi = 3.14159265358979324, s = 1.0 - e;
    const double transition = 0.5 + arctangent(150.0*1.75*(0.2 - s))/pi;

    factor[0] = dem_drag_voidage_factor(e);
    factor[1] = dem_select(smooth, transition, dem_select(e < 0.8, 0.0, 1.0));
}

DEM_MATH double drag_over_stokes(const struct dem_drag_row *r)
{
    const double phi = r->factor[1], wen_yu = r->factor[0]*dem_drag_single_sphere(r->re);

    return (1.0 - phi)*dem_drag_ergun(r->e, r->re) + phi*wen_yu;
}

#define HAS_VOIDAGE_FACTORS
#include "laws/fluid/drag_loop.h"

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
    .size = sizeof(struct gidaspow),
    .settings = settings,
    .prepare_bodies = prepare_bodies,
    .apply_to_bodies = apply_to_bodies,
};
