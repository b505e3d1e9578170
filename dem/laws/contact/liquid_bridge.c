/*
 * liquid_bridge.c -- liquid bridges between wet particles, and between wet particles and walls.
 *
 *   F_n = -2 pi R g cos(theta) X(H) - (3/2) pi mu R^2 X(h)^2/h v_n
 *   F_t = -6 pi mu R* (8/15 ln(R* over h) + 0.9588) v_t
 *   X(x) = 1 - x/sqrt(x^2 + 2 V/(pi R))        h = max(H, h_r)
 *
 *   H      gap between the surfaces; 0 in contact                  [m]
 *   V      volume of the bridge, fixed while it lasts (history)    [m3]
 *   R, R*  mean radius of Derjaguin 2 R*, reduced radius; R* = R_i at a wall      [m]
 *   g      surface tension                                         [N/m]
 *   theta  contact angle                                           [degree]
 *   mu     viscosity of the liquid                                 [Pa s]
 *   h_r    roughness: the smallest film thickness of the viscous force            [m]
 *   v_n, v_t  normal relative velocity, slip of the surfaces       [m/s]
 *
 * A bridge forms when surfaces touch, of what both partners hold on the cap that faces the other,
 * as seen from the centre:
 *
 *   V = f_i L_i + f_j L_j,    f_i = (1 - sqrt(1 - (R_j/(R_i + R_j))^2))/2
 *
 * L is the particle scalar liquidVolume, the liquid on a particle that is in no bridge. At a wall f
 * is 0.067, as for an equal sphere, and the wall gives nothing. Caps that face spheres which do
 * not overlap are disjoint, so bridges that form together take no more than there is; later ones
 * take their part of the rest. V is at most maxVolume R_min^3: what is more stays on the particles.
 * A bridge breaks when H reaches (1 + theta/2) V^(1/3), theta in rad. Each partner then gets V/2, a
 * particle at a wall all of it. Liquid is thus kept to rounding.
 *
 * Energy: the capillary force has the potential 2 pi R g cos(theta) (H - sqrt(H^2 + 2 V/(pi R))),
 * here zero at rupture. What a bridge gains when it forms, the work needed to break it, is counted
 * as lost at that moment: the loss of one loop of approach and separation.
 *
 * The viscous damper is limited to m* / (4 dt), the damper of slip to 2/7 of it, as in lubrication.c,
 * which also says why the viscous force rests while surfaces touch. With the largest step,
 * 0.2 m* / c at h_r, the limiters are never active.
 *
 * Source: capillary force: Rabinovich, Esayanur, Moudgil, Langmuir 21 (2005) 10992, without its
 * term of the wetted cap; viscous: Pitois, Moucheront, Chateau, J. Colloid Interface Sci. 231
 * (2000) 26, and Goldman, Cox, Brenner, Chem. Eng. Sci. 22 (1967) 637; rupture: Lian, Thornton,
 * Adams, J. Colloid Interface Sci. 161 (1993) 138; volume: Shi, McCarthy, Powder Technol. 184 (2008)
 * 64.
 * Not here: weight of the liquid, flow of liquid between bridges, bridges that merge, later rupture
 * at speed, evaporation. A bridge ends, too, where another facet of a wall takes over the contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/liquid_bridge.h"
#include "laws/effect.h"
#include <stdio.h>

static const char *const contacts[] = {"acts", "rests", NULL};

static const double pi = 3.14159265358979324;

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_liquid_bridge, tension, "surfaceTension", "N/m", DEM_SETTING_REQUIRED, 0.0,
                   INFINITY, "of the liquid; water in air: 0.072"),
    DEM_SETTING_AS(dem_liquid_bridge, contact_angle, "contactAngle", "degree", 0.0, 0.0, 60.0,
                   "between liquid and solid; the rupture distance is fitted up to 60 degrees"),
    DEM_SETTING(dem_liquid_bridge, viscosity, "Pa s", 0.0, 0.0, INFINITY,
                "of the liquid; 0: no viscous force"),
    DEM_SETTING(dem_liquid_bridge, roughness, "m", 0.0, 0.0, INFINITY,
                "height of the asperities: the thinnest film; viscosity needs it"),
    DEM_SETTING_AS(dem_liquid_bridge, max_volume, "maxVolume", "1", 0.05, DEM_ABOVE_ZERO, 0.1,
                   "largest volume of a bridge over R^3 of the smaller particle; a larger one "
                   "widens the pair search"),
    DEM_SETTING_AS(dem_liquid_bridge, min_volume, "minVolume", "m3", 0.0, 0.0, INFINITY,
                   "smaller bridges do not form"),
    DEM_SETTING_CHOICE(dem_liquid_bridge, contact, "contact", DEM_LIQUID_BRIDGE_RESTS, contacts,
                       "whether the viscous force acts while surfaces touch"),
    {0},
};

static const char *const history_names[] = {"bridge_volume", NULL};

static const struct dem_scalar liquid = {
    .name = "liquidVolume",
    .unit = "m3",
    .default_value = 0.0,
    .min = 0.0,
    .max = 1e9,
    .help = "volume of the liquid on a particle that is in no bridge",
    .flags = DEM_SCALAR_PARTNERS | DEM_SCALAR_RATE | DEM_SCALAR_WRITTEN | DEM_SCALAR_AMOUNT,
};

static const struct dem_scalar *const scalars[] = {&liquid, NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_liquid_bridge *const l = of;
    const double angle = l->contact_angle*(pi/180.0);

    DEM_REQUIRE(l->viscosity == 0.0 || l->roughness > 0.0, DEM_ERROR_INPUT,
                "liquidBridge between %s and %s: viscosity %g Pa s needs roughness, the smallest "
                "film thickness, which is %g m; give it, for example 1e-3 of the radius",
                pair->a->name, pair->b->name, l->viscosity, l->roughness);
    l->pull = 2.0*pi*l->tension*cos(angle);
    l->extent = 1.0 + 0.5*angle;
    l->wall = pair->with_wall ? 1.0 : 0.0;
    return DEM_OK;
}

/* Rupture distance of the largest bridge. */
static double reach(const void *of, const struct dem_pair_class *pair)
{
    const struct dem_liquid_bridge *const l = of;
    const double R = pair->with_wall ? pair->max_radius_sum : 0.5*pair->max_radius_sum;

    return l->extent*cbrt(l->max_volume)*R;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_liquid_bridge *const l = of;
    const double R = pair->min_radius, c = 6.0*pi*l->viscosity*R;

    *why = "0.2 of the time in which the thinnest film stops a particle (liquidBridge)";
    return c > 0.0 ? 0.2*pair->min_mass/
                         (c*fmax(R/l->roughness, 3.5*dem_liquid_bridge_slip(R, l->roughness)))
                   : DBL_MAX;
}

#define LAW dem_liquid_bridge
#define COLUMNS dem_liquid_bridge_columns
#define SCALARS 1
#define SETS DEM_SETS_FN | DEM_SETS_FORCE | DEM_SETS_STORED | DEM_SETS_LOST | DEM_SETS_RATE | \
    DEM_READS_RADII
#include "laws/contact_loop.h"

/* ---- for `dem plan` -------------------------------------------------------------------------- */

/* N: at contact, 2 pi R g cos(theta), R = 2 R* */
static double pull_off(const void *of, const struct dem_regime *g)
{
    const struct dem_liquid_bridge *const l = of;

    return 4.0*pi*g->radius*l->tension*cos(l->contact_angle*(pi/180.0));
}

static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    v->fraction = of && g->weight > 0.0 ? pull_off(of, g)/g->weight : 0.0;
    v->quantity = "of the weight is the capillary force of a bridge at contact (Rabinovich, "
                  "Esayanur, Moudgil 2005)";
    return of && g->weight > 0.0;
}

static int describe(const void *of, const struct dem_regime *g, char *line, size_t size)
{
    const double pull = pull_off(of, g);

    snprintf(line, size, "Bond number %.3g: capillary force of liquidBridge at contact over weight",
             pull/g->weight);
    return pull > 0.0 && g->weight > 0.0;
}

const struct dem_effect dem_liquid_bridge = {
    .name = "liquidBridge",
    .aliases = "capillary washino/capillary/viscous easo/capillary/viscous",
    .summary = "liquid bridges between wet particles: capillary and viscous force up to rupture",
    .source = "Rabinovich, Esayanur, Moudgil 2005; Pitois, Moucheront, Chateau 2000; Lian, "
              "Thornton, Adams 1993",
    .limitation = "liquidBridge does not count the weight of the liquid",
    .stage = DEM_STAGE_FILM,
    .needs = DEM_NEEDS_RADII,
    .excludes = "jkr sjkr lubrication stokesDamping",
    .example = "surfaceTension 0.072;",
    .size = sizeof(struct dem_liquid_bridge),
    .settings = settings,
    .history = history_names,
    .scalars = scalars,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .apply = apply,
    .relevance = relevance,
    .describe = describe,
    .adhesive = dem_effect_always,
    .mechanism = DEM_MECHANISM_ADHESION,
};
