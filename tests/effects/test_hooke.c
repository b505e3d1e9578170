/*
 * test_hooke.c -- the linear normal law: stiffness given or from the speed, step limits. Impacts:
 * physics/test_bounce.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, .poissons_ratio = 0.3},
                                 stone = {"stone", 2700.0, 5e7, .poissons_ratio = 0.2};
static const double pi = 3.14159265358979324;
static struct law_rows w;

static void law(void)
{
    rows_spheres(&w, &glass, &stone, 1e-3, 3e-3);
    struct rows_effect *const l = rows_add(&w, &dem_hooke, "stiffness", 1000.0);

    w.b.n = 2;
    w.b.touching[0] = 1.0, w.b.overlap[0] = 1e-5;
    w.b.fn[0] = w.b.fn[1] = 3.0;
    for (int c = 0; c < 2; c++)
    {
        w.b.reduced_radius[c] = 0.75e-3, w.b.reduced_mass[c] = 1e-5;
    }
    dem_hooke.apply(l->settings, &w.b, l->history);
    /* rounding */
    TAP_NEAR(w.b.fn[0], 3.0 + 1000.0*1e-5, 1e-15, "adds k d to the force");
    TAP_OK(w.b.kn[0] == 1000.0 && w.b.kn[1] == 0.0 && w.b.fn[1] == 3.0, "a row apart has no force");

    /* from the speed: k of the note; dem_pow and a few factors */
    apply_setting(&dem_hooke, l->settings, &w.pair, "stiffness", 0.0);
    for (double v = 0.01; v < 100.0; v *= 7.0)
    {
        const double E = w.pair.reduced_modulus, R = 0.75e-3, m = 1e-5;
        const double note = 16.0/15.0*E*sqrt(R)*pow(15.0*m*v*v/(16.0*E*sqrt(R)), 0.2);
        const double hertz = pow(15.0*m*v*v/(16.0*E*sqrt(R)), 0.4);

        apply_setting(&dem_hooke, l->settings, &w.pair, "impactSpeed", v);
        dem_hooke.apply(l->settings, &w.b, l->history);
        TAP_NEAR(w.b.kn[0]/note, 1.0, 1e-14, "k for %g m/s: %g N/m", v, note);
        TAP_NEAR(v*sqrt(m/w.b.kn[0])/hertz, 1.0, 1e-14, "overlap as with Hertz, %g m", hertz);
        TAP_OK(w.b.kn[1] == 0.0, "a row apart: no stiffness");
    }
    /* the reference pair of the note: E* 5.4945055e6 Pa, R* 0.5 mm, m* 5.2359878e-6 kg at 1 m/s;
       ten digits printed */
    rows_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    struct rows_effect *const reference = rows_add(&w, &dem_hooke, "impactSpeed", 1.0);

    w.b.n = 1;
    w.b.touching[0] = 1.0;
    w.b.reduced_radius[0] = w.pair.min_radius, w.b.reduced_mass[0] = w.pair.min_mass;
    dem_hooke.apply(reference->settings, &w.b, reference->history);
    TAP_NEAR(w.b.kn[0], 1090.8212625, 1e-7, "the reference pair: 1090.8212625 N/m");
}

static void limits(void)
{
    const char *why = "";

    rows_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    struct rows_effect *const l = rows_add(&w, &dem_hooke, "stiffness", 1000.0);
    const double contact = 0.05*pi*sqrt(w.pair.min_mass/1000.0);

    /* rounding, also of dem_pow */
    TAP_NEAR(dem_hooke.time_limit(l->settings, &w.pair, &why), contact, 1e-15*contact,
             "1/20 of the contact time");
    TAP_OK(strstr(why, "glass-glass on a spring of 1e+03 N/m"), "says why: %s", why);
    apply_setting(&dem_hooke, l->settings, &w.pair, "stiffness", 0.0);
    TAP_NEAR(dem_hooke.time_limit(l->settings, &w.pair, &why),
             contact*sqrt(1000.0/1090.8212625), 1e-9*contact,
             "stiffness from the speed: 1/20 of the contact time");
    apply_setting(&dem_hooke, l->settings, &w.pair, "impactSpeed", 1e-6);
    const double wave = 0.2*pi*1e-3*sqrt(2500.0/(1e7/2.6))/(0.1631*0.3 + 0.8766);

    TAP_NEAR(dem_hooke.time_limit(l->settings, &w.pair, &why), wave, 1e-13*wave,
             "slow impacts: %s", why);
    TAP_OK(strcmp(why, "0.2 of the Rayleigh time of glass") == 0,
           "slow impacts: the reason is named");
    apply_setting(&dem_hooke, l->settings, &w.pair, "stiffness", 1e-6);
    TAP_OK(dem_hooke.time_limit(l->settings, &w.pair, &why) > 0.01,
           "a given stiffness has no limit by the Rayleigh time: %s", why);
    w.pair.reduced_modulus = 0.0;
    TAP_OK(dem_hooke.prepare(l->settings, &w.pair) == DEM_OK, "a given stiffness needs no modulus");
    apply_setting(&dem_hooke, l->settings, &w.pair, "stiffness", 0.0);
    TAP_OK(dem_hooke.prepare(l->settings, &w.pair) == DEM_ERROR_INPUT,
           "a stiffness from the materials needs the modulus: %s", dem_error_text());
}

int main(void)
{
    TAP_TRAPS;
    law();
    limits();
    TAP_DONE;
}
