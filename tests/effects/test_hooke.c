/*
 * test_hooke.c -- the linear normal law: stiffness given or from the speed, duration and overlap
 * of an impact, restitution with dry, step limits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

static const struct dem_material glass = {"glass", 2500.0, 1e7, .poissons_ratio = 0.3},
                                 stone = {"stone", 2700.0, 5e7, .poissons_ratio = 0.2};
static const double pi = 3.14159265358979324;
static struct impacts w;

/* an impact of equal spheres of 1 mm on the spring k, `steps` a contact; attraction -1: no
   damping */
static double impact(double k, double v, double e, int attraction, int steps)
{
    impacts_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    const double dt = pi*sqrt(w.pair.min_mass/k)/steps;

    impacts_add(&w, &dem_hooke, "stiffness", k);
    if (attraction >= 0)
    {
        struct impacts_effect *const dry = impacts_add(&w, &dem_dry, "restitution", e);

        apply_setting(&dem_dry, dry->settings, &w.pair, "attraction", attraction);
    }
    impacts_aim(&w, 16, dt, v);
    return impacts_impact(&w, dt, 20*steps) > 0 ? impacts_rebound_speed(&w)/v : NAN;
}

/* restitution of a linear spring with a dashpot that cannot attract: the contact ends where the
   force is zero */
static double clamped(double e)
{
    const double L = -log(e), z = L/sqrt(pi*pi + L*L), s = sqrt(1.0 - z*z),
                 angle = atan2(2.0*z*s, s*s - z*z);

    return exp(-z/s*(pi - angle));
}

static void law(void)
{
    impacts_spheres(&w, &glass, &stone, 1e-3, 3e-3);
    struct impacts_effect *const l = impacts_add(&w, &dem_hooke, "stiffness", 1000.0);

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
    impacts_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    struct impacts_effect *const reference = impacts_add(&w, &dem_hooke, "impactSpeed", 1.0);

    w.b.n = 1;
    w.b.touching[0] = 1.0;
    w.b.reduced_radius[0] = w.pair.min_radius, w.b.reduced_mass[0] = w.pair.min_mass;
    dem_hooke.apply(reference->settings, &w.b, reference->history);
    TAP_NEAR(w.b.kn[0], 1090.8212625, 1e-7, "the reference pair: 1090.8212625 N/m");
}

static void impacts(void)
{
    const double k = 1000.0, v = 0.5, unit = sqrt(0.5*sphere_mass(1e-3, 2500.0)/k);

    TAP_NEAR(impact(k, v, 1.0, -1, 400), 1.0, 1e-4,
             "no speed lost");              /* second order: (1/400)^2 = 6e-6 */
    TAP_NEAR(mean(w.peak_overlap, 16), v*unit, 1e-4*v*unit,
             "overlap v sqrt(m/k)");/* the peak lies within half a step */
    /* counted in whole steps */
    TAP_NEAR(w.steps_touching[0], 400, 2, "steps of contact");
    for (double e = 0.1; e < 0.95; e += 0.2)
    {
        /* first order in the step with a dashpot, see test_dry; a tenth of it at t_c/4000 */
        TAP_NEAR(impact(k, v, e, 0, 4000), e, 1e-4, "restitution %g", e);
        TAP_NEAR(impact(k, v, e, 1, 4000), clamped(e), 1e-4, "clamped: %.4f comes out for %g",
                 clamped(e), e);
    }
}

static void limits(void)
{
    const char *why = "";

    impacts_spheres(&w, &glass, &glass, 1e-3, 1e-3);
    struct impacts_effect *const l = impacts_add(&w, &dem_hooke, "stiffness", 1000.0);
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
    impacts();
    limits();
    TAP_DONE;
}
