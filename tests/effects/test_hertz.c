/*
 * test_hertz.c -- the normal law of Hertz.
 *
 * - The force is 4/3 E* sqrt(R*) d^1.5.
 * - Elastic impacts have the peak force, overlap and duration of the closed form (Chung and Ooi,
 *   Granular Matter 13 (2011) 643, tests 1 and 2) and lose no speed.
 * - The step limits are the stated fractions and name their reason.
 * - Rows without contact are zero and raise no trap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "impacts.h"

/* Chung and Ooi's numbers for F_max: 10.704 kN glass, 11.357 kN aluminium (digitised); ours are the
   closed forms */
static void impact(const char *what, struct impacts *w, double speed, double overlap_um,
                   double force_kN, double time_us)
{
    const double t = impacts_contact_time(w, speed), dt = t/400.0;

    impacts_add(w, &dem_hertz, "impactSpeed", speed);
    impacts_aim(w, 16, dt, speed);
    TAP_OK(impacts_impact(w, dt, 1000) > 0, "%s: separates", what);

    /* the peak lies at most half a step from a sample, where 1 - cos(pi/800) < 1e-5 of it is
       missing */
    TAP_NEAR(1e6*mean(w->peak_overlap, 16), overlap_um, 0.002*overlap_um,
             "%s: largest overlap %g um", what, overlap_um);
    TAP_NEAR(1e-3*mean(w->peak_force, 16), force_kN, 0.002*force_kN, "%s: largest force %g kN",
             what, force_kN);

    /* counted in whole steps of 1/400 */
    double steps = 0.0;
    for (int c = 0; c < 16; c++)
    {
        steps += w->steps_touching[c]/16.0;
    }
    TAP_NEAR(1e6*dt*steps, time_us, 0.01*time_us, "%s: contact time %g us", what, time_us);
    TAP_NEAR(impacts_rebound_speed(w)/speed, 1.0, 1e-4, "%s: no speed is lost",
             what);    /* second order: ~(pi/400)^2 */
    TAP_NEAR(1e6*t, time_us, 1e-4*time_us, "%s: the closed form of the contact time", what);
}

static void law(void)
{
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0);
    struct impacts w;

    impacts_spheres(&w, &glass, &glass, 0.01, 0.03);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);
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

/* the error of an elastic impact decreases at least fourfold with half the step (velocity Verlet is
   of order two); the mean over the phases does not, so the largest error is used */
static double loss(struct impacts *w, double speed, int steps)
{
    const double dt = impacts_contact_time(w, speed)/steps;
    double worst = 0.0;

    impacts_aim(w, 64, dt, speed);
    impacts_impact(w, dt, 4*steps);
    for (int c = 0; c < 64; c++)
    {
        worst = fmax(worst, fabs((w->v[0][2][c] - w->v[1][2][c])/speed - 1.0));
    }
    return worst;
}

static void order(void)
{
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0);
    struct impacts w;

    impacts_spheres(&w, &glass, &glass, 0.01, 0.01);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);
    TAP_NEAR(loss(&w, 1.0, 20), 0.0, 1e-3,
             "at 1/20 of the contact time an impact keeps its speed within 0.1 %%");
    const double coarse = loss(&w, 1.0, 50), fine = loss(&w, 1.0, 100), finer = loss(&w, 1.0, 200);

    TAP_NOTE("speed error %.3g, %.3g, %.3g at 1/50, 1/100, 1/200 of the contact time", coarse, fine,
             finer);
    TAP_OK(fine <= coarse/4.0 && finer <= fine/4.0,
           "the error of the rebound speed decreases at least fourfold per halving");
}

static void limits(void)
{
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0),
                              soft = material("rubber", 1e6, 0.49, 1100.0);
    const char *why = "";
    struct impacts w;

    /* T_R = pi R sqrt(rho/G)/(0.1631 nu + 0.8766): 12.93 us for R = 10 mm; t_c/20 at 1 m/s is 3.67
       us, 0.2 T_R 2.59 us */
    impacts_spheres(&w, &glass, &glass, 0.01, 0.01);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);
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
    impacts_wall(&w, &glass, &soft, 0.01);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1e-9);
    TAP_NEAR(dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why), 0.2*rayleigh,
             1e-12*rayleigh, "particle on soft wall");

    /* a stiffness in place of 4/3 E*: the same numbers, without the limit of the Rayleigh wave */
    impacts_spheres(&w, &glass, &glass, 0.01, 0.01);
    impacts_add(&w, &dem_hertz, "impactSpeed", 1.0);
    apply_setting(&dem_hertz, w.effect_entry[0].settings, &w.pair, "stiffness", 4.0/3.0*25e9);
    TAP_NEAR(dem_hertz.time_limit(w.effect_entry[0].settings, &w.pair, &why),
             0.05*impacts_contact_time(&w, 1.0), 1e-7*3.67e-6, "a given stiffness: %s",
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
    const struct dem_material glass = material("glass", 48e9, 0.2, 2800.0),
                              stone = material("limestone", 20e9, 0.25, 2500.0);
    const struct dem_material aluminium = material("aluminium", 70e9, 0.3, 2699.0),
                              rigid = material("rigid", INFINITY, 0.3, 1.0);
    const struct dem_material magnesium = material("magnesium", 40e9, 0.35, 1800.0);
    static struct impacts w;

    TAP_TRAPS;
    law();

    impacts_spheres(&w, &glass, &glass, 0.01, 0.01);
    impact("glass pair at 20 m/s", &w, 20.0, 274.1127, 10.696889, 40.339456);
    impacts_spheres(&w, &stone, &stone, 0.01, 0.01);
    impact("limestone pair at 20 m/s", &w, 20.0, 368.30403, 7.1082413, 54.201005);
    impacts_wall(&w, &aluminium, &rigid, 0.1);
    impact("aluminium on a rigid wall at 0.2 m/s", &w, 0.2, 49.717175, 11.369858, 731.65664);
    impacts_wall(&w, &magnesium, &rigid, 0.1);
    impact("magnesium on a rigid wall at 0.2 m/s", &w, 0.2, 52.123288, 7.232681, 767.06591);

    order();
    limits();
    TAP_DONE;
}
