/*
 * jkr.c -- adhesion of elastic spheres (JKR), including the tail beyond contact.
 *
 *   d = a^2/R - sqrt(2 pi w a/E)        F_n = 4 E a^3/(3 R) - sqrt(8 pi w E a^3)
 *
 *   d    overlap, negative across a gap                            [m]
 *   a    radius of the contact area                                [m]
 *   w    work of adhesion of both surfaces together                [J/m2]
 *   E, R reduced modulus, reduced radius                           [Pa], [m]
 *
 * With a_t^3 = pi w R^2/(8 E) and a = a_t x^2 this is
 *
 *   d = (a_t^2/R) (x^4 - 4 x)            F_n = (pi w R/6) (x^6 - 6 x^3)            x >= 1
 *   U = (E a_t^5/R^2) (8/15 x^10 - 16/3 x^7 + 8 x^4)                energy, F_n = dU/dd
 *
 * The largest root of x^4 - 4 x = D in closed form: s^3 + 4 D s = 16,
 * x = (sqrt(s) + sqrt(8/sqrt(s) - s))/2.
 *
 * Contact begins at touching (d = 0), where the force jumps to -4/3 pi w R, and ends at
 * d = -3 a_t^2/R (x = 1), where it jumps back from -5/6 pi w R. In between the attraction is at
 * most 3/2 pi w R (pull-off force). Both jumps dissipate energy, together 7.09 (w^5 R^4/E^2)^(1/3)
 * for each contact: slower bodies stick. The loss is part of the energy balance.
 *
 * The effect acts together with `hertz` and replaces that law: it adds the difference. Damping and
 * rolling resistance see the Hertz part; the friction limit is mu (F_n + 2 F_c), F_c = 3/2 pi w R*
 * (Thornton 1991: slider.h). Where a bond replaces the contact nothing acts; the energy held when
 * the bond was made is dissipated (the bond accounts for the Hertz part), and after the bond has
 * broken the surfaces adhere again once they have separated. Largest time step: 1/20 of half a
 * period of oscillation about equilibrium, at which this oscillation is 0.10 % too fast (0.95 % at
 * three times that).
 *
 * Source: Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; loss: Thornton and Ning,
 * Powder Technol. 99 (1998) 154.
 * Not here: long-range attraction of stiff small bodies (DMT), peeling in shear, liquid bridges.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"

#include "laws/contact/jkr.h"
#include "laws/parcels.h"
#include <stdio.h>

static const double pi = 3.14159265358979324;

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_jkr, work, "workOfAdhesion", "J/m2", DEM_SETTING_REQUIRED, 0.0, INFINITY,
                 "w, of both surfaces together: twice the surface energy of two equal ones; "
                 "pull-off force 3/2 pi w R*"),
    {0},
};

static const char *const history_names[] = {"jkr_holds", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct dem_jkr *jkr = of;

    DEM_REQUIRE(pair->exponent == 1.5, DEM_ERROR_INPUT,
                "jkr between %s and %s needs hertz, which it replaces; add hertz to "
                "the effects",
                pair->a->name, pair->b->name);
    DEM_TRY(dem_parcels_scale(pair, "jkr", "workOfAdhesion", 1, &jkr->work));
    jkr->scale = pi*jkr->work/(8.0*pair->reduced_modulus);
    return DEM_OK;
}

/* m: a_t for a reduced radius R */
static double tear_off_radius(const struct dem_jkr *jkr, double R)
{
    return dem_pow(jkr->scale*R*R, 1.0/3.0);
}

/* R_i R_j/(R_i + R_j) is at most a quarter of the largest R_i + R_j; at a wall it is R_i. */
static double reach(const void *of, const struct dem_pair_class *pair)
{
    const double R = pair->with_wall ? pair->max_radius_sum : 0.25*pair->max_radius_sum,
                 a = tear_off_radius(of, R);

    return 3.0*a*a/R;
}

static double time_limit(const void *of, const struct dem_pair_class *pair, const char **why)
{
    /* stiffness at x^3 = 6, where the force is zero: 0.9 6^(2/3) 4/3 E a_t */
    const double stiffness = 3.9623127*pair->reduced_modulus*tear_off_radius(of, pair->min_radius);

    *why = "1/20 of half an oscillation of two adhering bodies (jkr)";
    return stiffness > 0.0 ? 0.05*pi*sqrt(pair->min_mass/stiffness) : DBL_MAX;
}

#define LOOP set_adhesion
#define LAW dem_jkr
#define COLUMNS dem_jkr_columns
#define ROW dem_jkr_adhesion_row
#define SETS DEM_SETS_SCRATCH | DEM_SETS_ADHESIVE_FORCE
#include "laws/contact_loop.h"

#define LAW dem_jkr
#define COLUMNS dem_jkr_columns
#define SETS DEM_SETS_FN | DEM_SETS_STORED | DEM_SETS_LOST
#define ENERGY
#include "laws/contact_loop.h"

/* J: 7.09 (w^5 R^4/E^2)^(1/3), lost in each contact */
static double contact_loss(double w, const struct dem_regime *g)
{
    return 7.09*cbrt(pow(w, 5.0)*pow(g->radius, 4.0)/(g->modulus*g->modulus));
}

/* In use: pull-off force 3/2 pi w R* over the weight, or the loss of a contact over m* v^2/2.
   Otherwise, in a gas or dry, with hertz, which it replaces: pull-off force 3/2 pi w r of asperities
   of r = 0.1 um with w = 0.05 J/m2 over the weight. This is an order of magnitude only, so it is
   called for where it exceeds the weight: below 0.12 mm for glass, i.e. in groups A and C of Geldart
   (Seville, Willett, Knight, Powder Technol. 113 (2000) 261). */
static int relevance(const void *of, const struct dem_regime *g, struct dem_relevance *v)
{
    const double usual = 0.05, asperity = 1e-7;           /* J/m2, m */

    if (of)
    {
        const double w = ((const struct dem_jkr *)of)->work, energy = 0.5*g->mass*g->speed*g->speed;

        v->fraction = fmax(g->weight > 0.0 ? 1.5*pi*w*g->radius/g->weight : 0.0,
                           energy > 0.0 ? contact_loss(w, g)/energy : 0.0);
        v->quantity = "of the weight, or of the energy of an impact, is due to adhesion "
                      "(Johnson, Kendall, Roberts 1971; Thornton and Ning 1998)";
        return 1;
    }
    v->fraction = 1.5*pi*usual*asperity/g->weight;
    v->threshold = 1.0;
    v->quantity =
        "of the weight is the adhesion of asperities of 0.1 um with 0.05 J/m2 (Seville, Willett, Knight 2000)";
    v->missing_setting =
        "workOfAdhesion; for rough surfaces the value of smooth ones times the ratio of asperity to sphere radius";
    return g->weight > 0.0 && g->exponent == 1.5 && !g->adhesive
           && (!g->fluid || g->suspension.density > 100.0*g->suspension.fluid_density);
}

/* Bond number: 3/2 pi w R* over the weight; two particles stick below
   sqrt(2 7.09 (w^5 R*^4/E*^2)^(1/3)/m*) (Thornton and Ning 1998). */
static int describe(const void *of, const struct dem_regime *g, char *line, size_t size)
{
    const double w = ((const struct dem_jkr *)of)->work;

    snprintf(
        line, size,
        "Bond number %.3g: pull-off force of jkr over weight; two particles stick below %.3g m/s",
        1.5*pi*w*g->radius/g->weight, sqrt(2.0*contact_loss(w, g)/g->mass));
    return w > 0.0 && g->weight > 0.0;
}

const struct dem_effect dem_jkr = {
    .name = "jkr",
    .summary =
        "adhesion of elastic spheres after Johnson, Kendall and Roberts, beyond contact up to the pull-off distance",
    .source = "Johnson, Kendall, Roberts 1971; Thornton and Ning 1998",
    .stage = DEM_STAGE_FILM,
    .parcels = DEM_PARCELS_SETTINGS,
    .excludes = "sjkr",
    .example = "workOfAdhesion 1e-3;",
    .size = sizeof(struct dem_jkr),
    .settings = settings,
    .history = history_names,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .set_adhesion = set_adhesion,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .describe = describe,
    .adhesive = dem_effect_always,
    .mechanism = DEM_MECHANISM_ADHESION,
};
