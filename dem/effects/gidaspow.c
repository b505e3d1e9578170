/*
 * gidaspow.c -- drag of Ergun in a packed bed, of Wen and Yu in a dilute one, and a bridge between them.
 *
 *   G = (1 - phi) G_E + phi G_WY,   G_E = (150 s/e + 1.75 Re/e)/18,   G_WY = e^-2.65 F1(Re)
 *   phi = 1/2 + atan(150*1.75 (0.2 - s))/pi   (smooth)      or   0 for e < 0.8, 1 otherwise   (switch)
 *
 *   G    drag over Stokes drag, f = 3 pi mu d G (u - v)            [1]   see drag.h
 *   e    void fraction; s = 1 - e                                  [1]
 *   Re   superficial Reynolds number, e rho d |u - v|/mu           [1]
 *   F1   single sphere, see wen_yu.c                               [1]
 *
 * The switch jumps at e = 0.8 (Re = 200: from 26.4 to 12.1), which makes a fluid solver chatter; hence smooth is the
 * default. Its price: phi is 0.994 and not 1 at e = 1, 0.9985 of Ergun at e = 0.2.
 *
 * Source: Gidaspow, Multiphase Flow and Fluidization (1994); Ergun, Chem. Eng. Prog. 48 (1952) 89; Wen and Yu, Chem.
 * Eng. Prog. Symp. Ser. 62 (1966) 100; bridge: Lu and Gidaspow, Chem. Eng. Sci. 58 (2003) 3777.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/effect.h"

#include "effects/drag.h"

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

static const struct dem_field settings[] = {
    DEM_FIELD_CHOICE(gidaspow, blend, "blend", SMOOTH, blends,
                     "how to get from Ergun to Wen-Yu at void fraction 0.8: smooth, or the original switch"),
    {0},
};

/* atan x: |x| > 1 by pi/2 - atan(1/x); the angle halved twice, so that its tangent is below 0.2 and 11 terms of the
   series do: the next is below 0.2^22/23 = 2e-17 of the first */
static inline double arctangent(double x)
{
    const double size = fabs(x);
    const double z = dem_pick(size > 1.0, 1.0/dem_pick(size > 1.0, size, 1.0), size);
    const double half = z/(1.0 + sqrt(1.0 + z*z));
    const double t = half/(1.0 + sqrt(1.0 + half*half));
    const double w = t*t;
    const double sum = 1.0 - w*(1.0/3.0 - w*(1.0/5.0 - w*(1.0/7.0 - w*(1.0/9.0 - w*(1.0/11.0 - w*(1.0/13.0
                     - w*(1.0/15.0 - w*(1.0/17.0 - w*(1.0/19.0 - w/21.0)))))))));
    const double angle = 4.0*t*sum;
    const double y = dem_pick(size > 1.0, 1.57079632679489662 - angle, angle);

    return dem_pick(x < 0.0, -y, y);
}

/* e^-2.65 and phi */
DEM_KERNEL
static void open_bodies(const void *of, struct dem_body_block *restrict b)
{
    const int smooth = ((const struct gidaspow *)of)->blend == SMOOTH;
    const double pi = 3.14159265358979324;

    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]), s = 1.0 - e;
        const double bridge = 0.5 + arctangent(150.0*1.75*(0.2 - s))/pi;

        b->swarm[0][c] = dem_drag_swarm(e);
        b->swarm[1][c] = dem_pick(smooth, bridge, dem_pick(e < 0.8, 0.0, 1.0));
    }
}

DEM_KERNEL
static void act_on_bodies(const void *of, struct dem_body_block *restrict b)
{
    (void)of;
    for (int c = 0; c < b->n; c++)
    {
        const double e = dem_drag_void(b->void_fraction[c]), phi = b->swarm[1][c];
        const double re = dem_drag_reynolds(b, c, e);
        const double wen_yu = b->swarm[0][c]*dem_drag_single_sphere(re);

        dem_drag_add(b, c, (1.0 - phi)*dem_drag_ergun(e, re) + phi*wen_yu);
    }
}

const struct dem_effect dem_gidaspow = {
    .name = "gidaspow",
    .says = "drag of Ergun below void fraction 0.8, of Wen and Yu above, bridged smoothly or switched",
    .source = "Gidaspow 1994; Lu and Gidaspow 2003",
    .stage = DEM_STAGE_FLUID,
    .drag = 1,
    .needs = DEM_NEEDS_FLUID,
    .size = sizeof(struct gidaspow),
    .settings = settings,
    .open_bodies = open_bodies,
    .act_on_bodies = act_on_bodies,
};
