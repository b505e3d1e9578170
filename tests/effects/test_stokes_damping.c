/*
 * test_stokes_damping.c -- the dashpot of impacts in a viscous fluid, row by row: latched speed, limits
 * without infinities, sources of viscosity and of added mass, the instantaneous speed. Restitutions
 * are in physics/test_stokes_impact.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "law_rows.h"

static const struct dem_material steel = {"steel", 7800.0, 200e9, .poissons_ratio = 0.3},
                                 glass = {"glass", 2540.0, 60e9, .poissons_ratio = 0.23};
static const struct dem_material rigid = {"rigid", 1.0, INFINITY, .poissons_ratio = 0.3};
static const double pi = 3.14159265358979324;
static struct law_rows w;

/* one row by hand: m* = 2 g, R* = 3 mm, kn = 1e6 N/m, touching; returns alpha = eta/sqrt(m* kn) */
static double alpha(const struct rows_effect *l, double vn, double fluid, double *speed)
{
    w.b.n = 1;
    w.b.reduced_mass[0] = 2e-3;
    w.b.reduced_radius[0] = 3e-3;
    w.b.kn[0] = 1e6;
    w.b.touching[0] = 1.0;
    w.b.overlap[0] = 1e-6;
    w.b.vn[0] = vn;
    w.b.viscosity[0] = fluid;
    w.b.fn[0] = 0.0;
    double *history[1] = {speed};

    dem_stokes_damping.apply(l->settings, &w.b, history);
    return w.b.eta[0]/sqrt(2e-3*1e6);
}

static double alpha_of(double e)
{
    const double l = -log(e);

    return sqrt(5.0)*l/sqrt(l*l + pi*pi);
}

static void by_hand(void)
{
    const double critical = sqrt(5.0), mu = 0.01, St = 2e-3*0.5/(6.0*pi*mu*9e-6);
    double speed = 0.0;

    rows_wall(&w, &steel, &rigid, 0.003);
    w.pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(&w, &dem_stokes_damping, "restitution", 0.97);

    /* from here on a few rounded factors: 1e-13 */
    TAP_NEAR(alpha(l, -0.5, mu, &speed), alpha_of(0.97*exp(-35.0/St)), 1e-13,
             "alpha of e_max exp(-beta/St), St = %.3g", St);
    TAP_OK(speed == 0.5 && w.b.fn[0] > 0.0, "the speed is latched, the force resists approach");
    TAP_NEAR(alpha(l, 0.1, mu, &speed), alpha_of(0.97*exp(-35.0/St)), 1e-13,
             "later speeds in the contact do not change it");
    TAP_OK(speed == 0.5 && w.b.fn[0] < 0.0, "still latched; the force may attract");
    w.b.touching[0] = 0.0;
    w.b.kn[0] = 0.0;
    double *history[1] = {&speed};
    dem_stokes_damping.apply(l->settings, &w.b, history);
    TAP_OK(speed == 0.0 && w.b.eta[0] == 0.0, "apart it is cleared and no force acts");
    alpha(l, -0.2, mu, &speed);
    TAP_OK(speed == 0.2, "the next contact latches its own speed");

    TAP_NEAR((speed = 0.0, alpha(l, 0.0, mu, &speed)), critical, 1e-13,
             "contact at rest: critical damping");
    TAP_OK(speed > 0.0 && speed < 1e-20, "contact at rest: latched, too");
    TAP_NEAR(alpha(l, -3.0, mu, &speed), critical, 1e-13,
             "contact at rest: a later compression is critically damped");
    TAP_NEAR((speed = 0.0, alpha(l, -0.5, 0.0, &speed)), alpha_of(0.97), 1e-13,
             "no viscosity: e_max");
    TAP_NEAR((speed = 0.0, alpha(l, 0.0, 0.0, &speed)), alpha_of(0.97), 1e-13,
             "no viscosity at rest: e_max");
    TAP_NEAR((speed = 0.0, alpha(l, -1e-12, mu, &speed)), critical, 1e-9,
             "creeping: critical damping");

    apply_setting(&dem_stokes_damping, l->settings, &w.pair, "restitution", 0.0);
    TAP_NEAR((speed = 0.0, alpha(l, -0.5, mu, &speed)), critical, 1e-13,
             "e_max = 0: critical damping");
    TAP_NEAR((speed = 0.0, alpha(l, -0.5, 0.0, &speed)), critical, 1e-13,
             "e_max = 0 without viscosity: critical damping");
    apply_setting(&dem_stokes_damping, l->settings, &w.pair, "restitution", 1.0);
    TAP_NEAR((speed = 0.0, alpha(l, -0.5, mu, &speed)), alpha_of(exp(-35.0/St)), 1e-13,
             "e_max = 1: damping by the fluid alone");
    TAP_OK((speed = 0.0, alpha(l, -0.5, 0.0, &speed)) == 0.0,
           "e_max = 1 without viscosity: no damping");

    apply_setting(&dem_stokes_damping, l->settings, &w.pair, "viscosity", 2.0*mu);
    TAP_NEAR((speed = 0.0, alpha(l, -0.5, mu, &speed)), alpha_of(exp(-70.0/St)), 1e-13,
             "the setting has priority over the fluid's viscosity");
    apply_setting(&dem_stokes_damping, l->settings, &w.pair, "beta", 0.0);
    TAP_OK((speed = 0.0, alpha(l, -0.5, mu, &speed)) == 0.0, "beta = 0: e_max whatever the fluid");
    TAP_OK((speed = 0.0, alpha(l, 0.0, mu, &speed)) == 0.0, "beta = 0 at rest");
    TAP_OK(dem_stokes_damping.needs & DEM_NEEDS_VISCOSITY, "it needs the fluid's viscosity");
}

enum source
{
    GIVEN,        /* addedMass and fluidDensity */
    DENSITY,      /* fluidDensity alone */
    OF_RUN,       /* the density of the run's fluid */
    IN_INERTIA    /* the same, with an effect that adds it to the inertia: none in St */
};

/* alpha of a pair with added mass C_M rho_f per particle volume against the formula with both
   masses */
static void added(const char *what, enum source source, const struct dem_material *a, const struct dem_material *b,
                  double Ra, double Rb, int wall)
{
    const double more = source == IN_INERTIA ? 0.0 : 0.5*1000.0, mu = 0.01, v = 0.3;
    double speed = 0.0;

    if (wall)
    {
        rows_wall(&w, a, b, Ra);
    }
    else
    {
        rows_spheres(&w, a, b, Ra, Rb);
    }
    w.pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(&w, &dem_stokes_damping, "restitution", 0.97);
    if (source == GIVEN || source == DENSITY)
    {
        apply_setting(&dem_stokes_damping, l->settings, &w.pair, "fluidDensity", 1000.0);
    }
    else
    {
        w.pair.fluid_density = 1000.0;
        w.pair.inertia_has_added_mass = source == IN_INERTIA;
        apply_setting(&dem_stokes_damping, l->settings, &w.pair, "beta", 35.0);
    }
    if (source == GIVEN)
    {
        apply_setting(&dem_stokes_damping, l->settings, &w.pair, "addedMass", 0.5);
    }

    const double ma = sphere_mass(Ra, a->density + more), mb = wall ? 0.0 : sphere_mass(Rb, b->density + more);
    const double m = wall ? ma : ma*mb/(ma + mb), R = w.pair.min_radius;
    const double St = m*v/(6.0*pi*mu*R*R);

    w.b.n = 1;
    w.b.reduced_mass[0] = w.pair.min_mass;
    w.b.reduced_radius[0] = R;
    w.b.kn[0] = 1e6;
    w.b.touching[0] = 1.0;
    w.b.vn[0] = -v;
    w.b.viscosity[0] = mu;
    double *history[1] = {&speed};
    dem_stokes_damping.apply(l->settings, &w.b, history);
    TAP_NEAR(w.b.eta[0]/sqrt(w.pair.min_mass*1e6), alpha_of(0.97*exp(-35.0/St)), 1e-13,
             "added mass: %s", what);
}

/* the instantaneous signed speed, as in LIGGGHTS: St is negative while the surfaces separate */
static void instantaneous(void)
{
    const double mu = 0.01;
    double speed = 0.0;

    rows_wall(&w, &steel, &rigid, 0.003);
    w.pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(&w, &dem_stokes_damping, "restitution", 0.97);

    apply_setting(&dem_stokes_damping, l->settings, &w.pair, "speed", 1.0);
    for (double vn = -0.5; vn < 0.6; vn += 0.25)
    {
        const double St = 2e-3*vn/(6.0*pi*mu*9e-6), found = alpha(l, vn, mu, &speed);

        TAP_NEAR(found, vn == 0.0 ? sqrt(5.0) : fabs(alpha_of(0.97*exp(35.0/St))), 1e-13,
                 "instantaneous: alpha at %g m/s", vn);
    }
}

int main(void)
{
    TAP_TRAPS;
    by_hand();
    added("sphere and wall, density alone", DENSITY, &glass, &rigid, 0.003, 0.0, 1);
    added("sphere and wall, density of the run", OF_RUN, &glass, &rigid, 0.003, 0.0, 1);
    added("equal spheres, density of the run", OF_RUN, &glass, &glass, 0.003, 0.003, 0);
    added("not twice if the inertia contains it", IN_INERTIA, &glass, &rigid, 0.003, 0.0, 1);
    added("sphere and wall", GIVEN, &glass, &rigid, 0.003, 0.0, 1);
    added("equal spheres", GIVEN, &glass, &glass, 0.003, 0.003, 0);
    added("same density, different size", GIVEN, &glass, &glass, 0.003, 0.001, 0);
    added("same size, different density", GIVEN, &glass, &steel, 0.003, 0.003, 0);

    rows_wall(&w, &steel, &rigid, 0.003);
    w.pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(&w, &dem_stokes_damping, "restitution", 0.97);
    TAP_OK(apply_setting(&dem_stokes_damping, l->settings, &w.pair, "addedMass", 0.5) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    w.pair.fluid_density = 998.0;
    TAP_OK(apply_setting(&dem_stokes_damping, l->settings, &w.pair, "fluidDensity", 1000.0) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    instantaneous();
    TAP_DONE;
}
