/*
 * dry.c -- normal dashpot for a given restitution, independent of the impact speed.
 *
 *   F_n = ... - eta v_n,    eta = alpha(e) sqrt(m* k_n)
 *
 *   v_n    normal relative velocity, negative on approach          [m/s]
 *   e      coefficient of restitution, 0 to 1                      [1]
 *   k_n    secant stiffness, set by the normal law                 [N/m]
 *   m*     reduced inertial mass                                   [kg]
 *   alpha  depends on e and the exponent of the normal law         [1]   see restitution.h
 *
 * At the end of a contact the dashpot pulls harder than the spring repels, so F_n < 0 for a moment.
 * A contact returns e only if this attraction is allowed, which is the default. Clamped at zero, a
 * contact, linear or Hertzian, returns 0.33 for e = 0.2, 0.47 for 0.4, 0.55 for 0.5, 0.63 for 0.6,
 * 0.81 for 0.8 and 0.90 for 0.9.
 *
 * Source: Antypov and Elliott, EPL 94 (2011) 50004; the spring and dashpot: Tsuji, Tanaka, Ishida,
 * Powder Technol. 71 (1992) 239. Eqs. (12) and (14) of Kasuga, Discrete element method (in
 * Japanese, 2012), linear and Hertzian, and (8), (9) of Open DEM Japan, Hooke/Hysteresis normal
 * contact model (in Japanese, 2025) are the same law. Changed from these notes: e = 0, which has no
 * logarithm, is critical damping; max(F_n, 0) of the latter's (10) is `attraction clamped`, which
 * keeps the attraction of adhesion. Not here: restitution that depends on speed in a liquid (see
 * stokesDamping), plasticity, adhesion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/contact/dry.h"
#include "laws/contact/restitution_effect.h"
#include "laws/effect.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_dry, restitution, "1", DEM_SETTING_REQUIRED, 0.0, 1.0,
                "speed after a normal impact over speed before"),
    DEM_SETTING_CHOICE(dem_dry, attraction, "attraction", DEM_ATTRACTION_ALLOWED, dem_attractions,
                       "whether the contact may pull while it opens; clamped: the dashpot never "
                       "does (restitution 0.55 for 0.5, 0.81 for 0.8); none: max(F, 0), "
                       "without adhesion"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_dry *dry = of;
    const double loss = dem_restitution_loss(dry->restitution);

    dry->alpha =
        dem_restitution_critical(pair->exponent)*(loss/sqrt(DEM_RESTITUTION_PI2 + loss*loss));
    return DEM_OK;
}

#define LAW dem_dry
#define SETS DEM_SETS_ETA | DEM_SETS_FN | DEM_SETS_ADHESIVE_FORCE
#define ENERGY
#include "laws/contact_loop.h"

const struct dem_effect dem_dry = {
    .name = "dry",
    .aliases = "dashpot",
    .summary = "viscous damping that gives the same coefficient of restitution at any impact speed",
    .source = "Antypov and Elliott 2011; Tsuji, Tanaka, Ishida 1992",
    .stage = DEM_STAGE_DAMP,
    .parcels = DEM_PARCELS_SAME,
    .example = "restitution 0.9;",
    .size = sizeof(struct dem_dry),
    .settings = settings,
    .prepare = prepare,
    .apply = apply,
    .energy = energy,
};
