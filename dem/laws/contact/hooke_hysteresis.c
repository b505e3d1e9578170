/*
 * hooke_hysteresis.c -- elastic-plastic, adhesive normal force: linear loading, steeper unloading.
 *
 *   F_n = k d                          loading, while d_max < d_lim
 *         k_2 (d - d_r) + k d_r        unloading and reloading, and all loading beyond d_lim
 *         -k_c d                       where that would be smaller: adhesive branch
 *
 *   k_2 = k + (k_m - k) d_max/d_lim, at most k_m
 *   d_r = min(d_max, d_lim),    d_lim = k_m/(k_m - k) phi 2 R*
 *   d_max' = (d + sqrt(d^2 + 4 (k + k_c) d_lim/(k_m - k) d))/2    on the adhesive branch
 *
 *   d      overlap; d_max the largest so far (history)             [m]
 *   k      stiffness of first loading: given, or from a characteristic speed (impact_speed.h) [N/m]
 *   k_m    largest stiffness of unloading, a multiple of k         [N/m]
 *   k_c    stiffness of the adhesive branch, a multiple of k       [N/m]
 *   phi    plastic depth: overlap over 2 R* at which yielding ends (with k_m large)            [1]
 *
 * On the adhesive branch d_max is reduced to the value for which the unloading line of k_2 passes
 * through (d, -k_c d), so that reloading follows this line. Every closed loop dissipates energy;
 * none produces any. Damping (dry, viscous, stokesDamping) refers to k. Without adhesion: k_c = 0. Largest
 * time step: pi sqrt(m/k_m)/20, at which oscillations on the line of k_m are 0.10 % too fast
 * (0.95 % at three times that).
 *
 * Limiting cases: k_m = k is a linear spring without yield and adhesion; phi = 0 is a linear spring
 * of stiffness k_m.
 *
 * Source: Open DEM Japan, Hooke/Hysteresis normal contact model (in Japanese, 2025), after Luding,
 * Granul. Matter 10 (2008) 235 and Walton and Braun, J. Rheol. 30 (1986) 949. Changed from the
 * note:
 *   (6), (7)    beyond d_lim the note keeps loading on k and unloads from there; here, as in
 *               Luding, the line of k_m through (d_lim, k d_lim) is followed in both directions. At
 *               1.5 d_lim and k_m = 5 k the force is 3.5 k d_lim instead of 1.5 k d_lim.
 *   after (7)   "d_max is re-updated" has no formula in the note; the one above follows from the
 *               condition stated there.
 *   (2), (4)    divide by zero for k_m = k and for phi = 0: see the limiting cases. At a wall
 *               2 R* = 2 R_i.
 *   (8)         is the law of dry; with the Stokes number it is stokesDamping, with the impact speed.
 *   (10)        max(F_n, 0) of the whole force would remove the adhesion: `attraction clamped` of
 *               dry clamps the attraction of the dashpot only.
 * The friction limit is mu (F_n + k_c d), as in Luding: it goes to zero where adhesion is strongest
 * (slider.h).
 * Not here: k_2 in the dashpot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/contact/hooke_hysteresis.h"
#include "laws/contact/impact_speed.h"
#include "laws/parcels.h"

static const struct dem_setting settings[] = {
    DEM_SETTING(dem_hooke_hysteresis, stiffness, "N/m", 0.0, 0.0, INFINITY,
                "k: force per overlap of first loading; 0: from the materials "
                "and impactSpeed"),
    DEM_SETTING_AS(
        dem_hooke_hysteresis, impact_speed, "impactSpeed", "m/s", 1.0, DEM_ABOVE_ZERO, INFINITY,
        "without stiffness: k such that an impact at this speed has the largest overlap of "
        "hertz"),
    DEM_SETTING(dem_hooke_hysteresis, unloading, "1", DEM_SETTING_REQUIRED, 1.0, 1e6,
                "k_m/k: largest stiffness of unloading over loading; 1: no hysteresis"),
    DEM_SETTING(dem_hooke_hysteresis, adhesion, "1", 0.0, 0.0, 1e6,
                "k_c/k: stiffness of the adhesive branch over loading; 0: no adhesion"),
    DEM_SETTING_AS(dem_hooke_hysteresis, depth, "plasticDepth", "1", 0.05, 0.0, 1.0,
                   "phi: overlap over 2 R* at which yielding ends"),
    {0},
};

static const char *const history_names[] = {"largest_overlap", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_hooke_hysteresis *h = of;
    const int plain = h->unloading <= 1.0 + 1e-12;        /* k_m/(k_m - k) is infinite */

    DEM_TRY(dem_parcels_scale(pair, "hookeHysteresis", "stiffness", 1, &h->stiffness));
    h->spring = (struct dem_impact_spring){.stiffness = h->stiffness, .speed = h->impact_speed};
    h->stiffer = plain ? 0.0 : h->unloading - 1.0;
    h->limit = plain ? 0.0 : h->unloading/h->stiffer*2.0*h->depth;
    return dem_impact_prepare(&h->spring, "hookeHysteresis", pair);
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    const struct dem_hooke_hysteresis *h = of;

    return dem_impact_time_limit(&h->spring, h->unloading, pair, why);
}

/* of first loading; unloading is faster */
static double contact_time(const void *of, const struct dem_pair_class *pair)
{
    return dem_impact_contact_time(&((const struct dem_hooke_hysteresis *)of)->spring, 1.0, pair);
}

#define LAW dem_hooke_hysteresis
#define COLUMNS dem_hooke_hysteresis_columns
#define BEFORE(settings, batch) dem_impact_stiffnesses(&(settings)->spring, batch)
#define ROW dem_hooke_hysteresis_force_row
#define SETS DEM_SETS_FN | DEM_SETS_ADHESIVE_FORCE
#define ENERGY
#include "laws/contact_loop.h"

/* 1: k_2/k after the first impact, whose overlap follows from k d^2/2 = m v^2/2, or from
   hertz */
static double first_unloading(const struct dem_hooke_hysteresis *h, const struct dem_regime *g)
{
    const double limit = h->unloading > 1.0 ? h->unloading/(h->unloading - 1.0)*2.0*h->depth : 0.0;
    const double d =
        h->stiffness > 0.0 ? g->speed*sqrt(g->mass/h->stiffness)/g->radius : g->overlap;

    return limit > 0.0 ? 1.0 + (h->unloading - 1.0)*fmin(1.0, d/limit) : 1.0;
}

/* In use: fraction of energy that the first impact loses by yielding, 1 - k/k_2. Otherwise, where a
   material has a yield strength: 1 - e^2 of an impact at v above v_y, less the loss by damping,
   e^2 = (6 sqrt3/5) (1 - s^2/6) sqrt(s/(s + 2 sqrt(6/5 - s^2/5))), s = v_y/v
   (Thornton, J. Appl. Mech. 64 (1997) 383). */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    if (of)
    {
        v->fraction = 1.0 - 1.0/first_unloading(of, g);
        v->quantity = "of the energy of an impact is lost by yielding (Walton and Braun 1986)";
        return 1;
    }
    if (!(g->yield_speed > 0.0 && g->speed > g->yield_speed))
    {
        return 0;
    }
    const double s = g->yield_speed/g->speed,
                 rebounds = 1.2*sqrt(3.0)*(1.0 - s*s/6.0)*
                            sqrt(s/(s + 2.0*sqrt(1.2 - 0.2*s*s)));

    v->fraction = g->restitution*g->restitution - rebounds;
    v->quantity =
        "of the energy of an impact is lost by yielding, besides the loss by damping (Thornton 1997)";
    v->missing_setting =
        "unloading and plasticDepth, or give damping the restitution of yielding particles";
    return 1;
}

/*
 * Restitution of an impact at v without dashpot, e^2 from the energy that the loop keeps:
 *
 *   v <= v_lim   k/k_2 - (k_c/k) (k_2 - k)^2/(k_2 (k_2 + k_c)),   k_2 of d_max = v sqrt(m/k)
 *   v >  v_lim   1 - d_lim^2 (k - k^2/k_m + k_c (k_m - k)^2/(k_m (k_m + k_c)))/(m v^2)
 *
 * v_lim = d_lim sqrt(k/m); the partners stick where e^2 < 0.
 */
static double rebound(const struct dem_hooke_hysteresis *h, double k, double m, double d_lim)
{
    const double km = k*h->unloading, kc = k*h->adhesion, v = h->impact_speed;
    const double d = v*sqrt(m/k);

    if (h->stiffer == 0.0 || d_lim == 0.0)
    {
        return 1.0;
    }
    if (d <= d_lim)
    {
        const double k2 = k*(1.0 + h->stiffer*d/d_lim);

        return k/k2 - h->adhesion*(k2 - k)*(k2 - k)/(k2*(k2 + kc));
    }
    return 1.0 - d_lim*d_lim*(k - k*k/km + kc*(km - k)*(km - k)/(km*(km + kc)))/(m*v*v);
}

static void describe_pair(const void *of, const struct dem_pair_class *pair, char *line,
                          size_t size)
{
    const struct dem_hooke_hysteresis *h = of;
    const double m = pair->min_mass, R = pair->min_radius,
                 k = h->spring.scale > 0.0 ? h->spring.scale*pow(R*R*m, 0.2) : h->stiffness,
                 d_lim = h->limit*R, kept = rebound(h, k, m, d_lim);
    char speed[64] = "sticks";

    if (kept > 0.0)
    {
        snprintf(speed, sizeof speed, "restitution by yielding %.4g", sqrt(kept));
    }
    snprintf(line, size, ", stiffness %.5g N/m, limit overlap %.5g m, %s at %g m/s", k, d_lim, speed,
             h->impact_speed);
}

static int adhesive(const void *of)
{
    return ((const struct dem_hooke_hysteresis *)of)->adhesion > 0.0;
}

const struct dem_effect dem_hooke_hysteresis = {
    .name = "hookeHysteresis",
    .aliases = "hooke/hysteresis luding elastoPlastic",
    .summary =
        "elastic-plastic, adhesive contact of linear springs: loading k, unloading k_2, adhesion k_c",
    .source = "Luding 2008; Walton and Braun 1986",
    .stage = DEM_STAGE_NORMAL,
    .parcels = DEM_PARCELS_SETTINGS,
    .exponent = 1.0,
    .example = "unloading 5; adhesion 0.1;",
    .size = sizeof(struct dem_hooke_hysteresis),
    .settings = settings,
    .history = history_names,
    .prepare = prepare,
    .time_limit = time_limit,
    .contact_time = contact_time,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .describe_pair = describe_pair,
    .adhesive = adhesive,
    .mechanism = DEM_MECHANISM_YIELDING,
};
