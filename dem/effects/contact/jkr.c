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
#include "effects/effect.h"

#include "core/math.h"
#include <stdio.h>

struct jkr
{
    double work;
    double scale;  /* m    pi w/(8 E*): a_t^3 = this R*^2; derived */
};

static const double pi = 3.14159265358979324;

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(jkr, work, "workOfAdhesion", "J/m2", DEM_SETTING_REQUIRED, 0.0, INFINITY,
                 "w, of both surfaces together: twice the surface energy of two equal ones; "
                 "pull-off force 3/2 pi w R*"),
    {0},
};

static const char *const history_names[] = {"jkr_holds", NULL};

static int prepare(void *of, const struct dem_pair_class *pair)
{
    struct jkr *jkr = of;

    DEM_REQUIRE(pair->exponent == 1.5, DEM_ERROR_INPUT,
                "jkr between %s and %s needs hertz, which it replaces; add hertz to "
                "the effects",
                pair->a->name, pair->b->name);
    jkr->scale = pi*jkr->work/(8.0*pair->reduced_modulus);
    return DEM_OK;
}

/* m: a_t for a reduced radius R */
static double tear_off_radius(const struct jkr *jkr, double R)
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

/* Scratch column: x of each adhering row, or 0. Adhesive force: set before friction is
   evaluated. */
DEM_KERNEL
static void adhere(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    const struct jkr *jkr = of;
    const double scale = jkr->scale, third = 1.0/3.0, pull = jkr->work*pi;
    const double *restrict adheres = history[0];

    for (int c = 0; c < b->n; c++)
    {
        const double R = b->reduced_radius[c], a = dem_pow(scale*R*R, third),
                       length = a*a/dem_select(R > 0.0, R, 1.0);
        const double raw = -b->gap[c]/dem_select(length > 0.0, length, 1.0),
                       D = dem_select(raw > -3.0, raw, -3.0);

        /* adhesion begins at contact and ends with the tail */
        const double still = dem_select(raw > -3.0, adheres[c], 0.0),
                       bare = dem_select(b->bond_replaces[c] > 0.0, 0.0, 1.0);
        const double now =
            dem_select(b->touching[c] > 0.0, 1.0, still)*dem_select(length > 0.0, bare, 0.0);

        const double B = D*(4.0/3.0), radicand = 64.0 + B*B*B,
                       A = dem_pow(8.0 + sqrt(dem_select(radicand > 0.0, radicand, 0.0)), third);
        const double s = 16.0/(A*A + B + B*B/(A*A)), p = sqrt(s), discriminant = 8.0/p - s;
        const double x = 0.5*(p + sqrt(dem_select(discriminant > 0.0, discriminant, 0.0))),
                       x3 = x*x*x;

        b->scratch[c] = now*x;
        b->adhesive_force[c] = now*(pull*R*(x3/6.0*(x3 - 6.0) + 3.0) - b->kn[c]*b->overlap[c]);
    }
}

DEM_KERNEL
static void apply(const void *of, struct dem_contact_batch *restrict b, double *const *history)
{
    const struct jkr *jkr = of;
    const double scale = jkr->scale, third = 1.0/3.0, pull = jkr->work*pi;
    double *restrict adheres = history[0];

    for (int c = 0; c < b->n; c++)
    {
        /* a bond may have been made after `set_adhesion` */
        const double bare = dem_select(b->bond_replaces[c] > 0.0, 0.0, 1.0), before = adheres[c],
                       now = dem_select(b->scratch[c] > 0.0, bare, 0.0);
        const double R = b->reduced_radius[c], a = dem_pow(scale*R*R, third),
                       x = b->scratch[c], x3 = x*x*x, x4 = x3*x;
        const double hertz = b->kn[c]*b->overlap[c];

        /* the unit of energy, E a_t^5/R^2 with reduced quantities, is (pi w/8) a_t^2 */
        const double energy = pull/8.0*a*a*x4*(8.0 + x3*(x3*(8.0/15.0) - 16.0/3.0));
        /* x = 1; x^3 = 4: 4.8 x^4 */
        const double pull_off = pull/8.0*a*a*3.2, snap_in = pull/8.0*a*a*30.4780;
        const double left = dem_select(bare > 0.0, pull_off, energy - 0.4*hertz*b->overlap[c]);

        b->fn[c] += now*(pull*R/6.0*x3*(x3 - 6.0) - hertz);
        b->stored[c] += now*energy;
        b->lost[c] += dem_select(now > before, snap_in, dem_select(now < before, left, 0.0));
        adheres[c] = now;
    }
}

/* act has stored the energy of the whole law; 2/5 F_n d of it is already counted by hertz */
static void energy(const void *of, const struct dem_contact_batch *restrict b,
                   double *const *before, double *const *history, struct dem_energy *restrict e)
{
    (void)of, (void)before;
    for (int c = 0; c < b->n; c++)
    {
        e->stored[c] -= history[0][c]*0.4*b->kn[c]*b->overlap[c]*b->overlap[c];
    }
}

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
        const double w = ((const struct jkr *)of)->work, energy = 0.5*g->mass*g->speed*g->speed;

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
        "workOfAdhesion; for rough surfaces that of smooth ones times the ratio of asperity to sphere radius";
    return g->weight > 0.0 && g->exponent == 1.5 && !g->adhesive
           && (!g->fluid || g->suspension.density > 100.0*g->suspension.fluid_density);
}

/* Bond number: 3/2 pi w R* over the weight; two particles stick below
   sqrt(2 7.09 (w^5 R*^4/E*^2)^(1/3)/m*) (Thornton and Ning 1998). */
static int describe(const void *of, const struct dem_regime *g, char *line, size_t size)
{
    const double w = ((const struct jkr *)of)->work;

    snprintf(
        line, size,
        "Bond number %.3g: pull-off force of jkr over weight; two particles stick below %.3g m/s",
        1.5*pi*w*g->radius/g->weight, sqrt(2.0*contact_loss(w, g)/g->mass));
    return w > 0.0 && g->weight > 0.0;
}

static int adhesive(const void *of)
{
    (void)of;
    return 1;
}

const struct dem_effect dem_jkr = {
    .name = "jkr",
    .summary =
        "adhesion of elastic spheres after Johnson, Kendall and Roberts, beyond contact up to the pull-off distance",
    .source = "Johnson, Kendall, Roberts 1971; Thornton and Ning 1998",
    .stage = DEM_STAGE_FILM,
    .excludes = "sjkr",
    .example = "workOfAdhesion 1e-3;",
    .size = sizeof(struct jkr),
    .settings = settings,
    .history = history_names,
    .prepare = prepare,
    .reach = reach,
    .time_limit = time_limit,
    .set_adhesion = adhere,
    .apply = apply,
    .energy = energy,
    .relevance = relevance,
    .describe = describe,
    .adhesive = adhesive,
    .mechanism = DEM_MECHANISM_ADHESION,
};
