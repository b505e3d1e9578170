/*
 * test_hertz.c -- Hertz's law: the force is 4/3 E* sqrt(R*) d^1.5, and the step limits are the stated
 * fractions and name their reason. Impacts are in physics/test_impact.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static void law(void)
{
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0);
    struct law_rows w;

    rows_spheres(&w, &glass, &glass, 0.01, 0.03);
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    w.b.n = 8;
    for (int c = 0; c < 8; c++)
    {
        w.b.reduced_radius[c] = 0.0075;
        w.b.overlap[c] = 1e-5*c;
        w.b.fn[c] = 3.0;
    }
    dem_hertz.apply(w.effect_entry[0].settings, &w.b, w.effect_entry[0].history);
    double worst = 0.0, worst_stiffness = 0.0;
    for (int c = 0; c < 8; c++)
    {
        /* E* = 25 GPa; products of a few rounded factors */
        const double force = 4.0/3.0*25e9*sqrt(0.0075)*pow(1e-5*c, 1.5);

        worst = fmax(worst, fabs(w.b.fn[c] - 3.0 - force)/(3.0 + force));
        worst_stiffness = fmax(worst_stiffness, fabs(w.b.kn[c]*1e-5*c - force)/(1.0 + force));
    }
    TAP_NEAR(worst, 0.0, 1e-14, "adds 4/3 E* sqrt(R*) d^1.5 to the force");
    TAP_NEAR(worst_stiffness, 0.0, 1e-14, "the secant stiffness times the overlap is the force");
    TAP_OK(w.b.kn[0] == 0.0 && w.b.fn[0] == 3.0, "a row apart has no force");
}

static void limits(void)
{
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0),
                              soft = material("rubber", 1e6, 0.49, 1100.0);
    const char *why = "";
    struct law_rows w;

    /* T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766): 12.93 us for R = 10 mm; t_c/20 at 1 m/s is 3.67
       us, 0.2 T_R 2.59 us */
    rows_spheres(&w, &glass, &glass, 0.01, 0.01);
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    const double rayleigh = 3.14159265358979324*0.01*sqrt(2800.0/20e9)/(0.1631*0.2 + 0.8766);

    /* dem_pow, a product and a quotient: a few units in the last place */
    TAP_NEAR(dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why), 0.2*rayleigh,
             1e-12*rayleigh, "0.2 Rayleigh time");
    TAP_OK(strcmp(why, "0.2 of the Rayleigh time of glass") == 0, "says why: %s", why);

    apply_setting(&dem_hertz, w.effect_entry[0].settings, &w.pair, "impactSpeed", 20.0);
    const double limit = dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why);
    TAP_NEAR(limit, 40.339456e-6/20.0, 1e-7*limit,
             "1/20 of the contact time of Chung and Ooi's test 1");
    TAP_OK(strcmp(why, "1/20 of the Hertz contact time of glass-glass at 20 m/s") == 0,
           "says why: %s", why);

    /* at a wall the Rayleigh time is the particle's, and the reduced radius is its radius */
    rows_wall(&w, &glass, &soft, 0.01);
    rows_add(&w, &dem_hertz, "impactSpeed", 1e-9);
    TAP_NEAR(dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why), 0.2*rayleigh,
             1e-12*rayleigh, "particle on soft wall");

    /* a stiffness in place of 4/3 E*: the same numbers, without the limit of the Rayleigh wave */
    rows_spheres(&w, &glass, &glass, 0.01, 0.01);
    rows_add(&w, &dem_hertz, "impactSpeed", 1.0);
    apply_setting(&dem_hertz, w.effect_entry[0].settings, &w.pair, "stiffness", 4.0/3.0*25e9);
    const double contact = 2.8682657*pow(w.pair.min_mass*w.pair.min_mass/(0.005*25e9*25e9), 0.2);
    TAP_NEAR(dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why), 0.05*contact,
             1e-7*3.67e-6, "a given stiffness: %s",
             why);                                               /* digits of 2.8682657 */
    w.b.n = 1;
    w.b.overlap[0] = 1e-5, w.b.reduced_radius[0] = 0.005, w.b.fn[0] = 0.0;
    dem_hertz.apply(w.effect_entry[0].settings, &w.b, w.effect_entry[0].history);
    TAP_NEAR(w.b.fn[0], 4.0/3.0*25e9*sqrt(0.005)*pow(1e-5, 1.5), 1e-13*75.0,
             "a given stiffness: the force of these materials");    /* rounding */

    w.pair.reduced_modulus = 0.0;
    TAP_OK(dem_hertz.prepare(w.effect_entry[0].settings, &w.pair) == DEM_OK,
           "a given stiffness needs no modulus");
    apply_setting(&dem_hertz, w.effect_entry[0].settings, &w.pair, "stiffness", 0.0);
    TAP_OK(dem_hertz.prepare(w.effect_entry[0].settings, &w.pair) == DEM_ERROR_INPUT,
           "without stiffness and modulus it is refused: %s", dem_error_text());
}

int main(void)
{
    TAP_TRAPS;
    law();
    limits();
    TAP_DONE;
}
