/*
 * test_energy.c -- each term of the energy balance has its closed form, the residual falls with
 * the order of the step, and a restart continues the balance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include <unistd.h>

static const double R = 1e-3, rho = 2500.0, E = 1e7, nu = 0.3;

static const char glass[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }";
static const char floor_at_0[] = "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }";

static struct dem_new_particle ball(double x, double z, double vx, double vz)
{
    return (struct dem_new_particle){
        .position = {x, 0.0, z}, .velocity = {vx, 0.0, vz}, .diameter = 2.0*R, .id = -1,
        .material = "glass"};
}

/* One sphere; `more` adds walls, a fluid or a domain. */
static struct dem *one(const char *effects, const char *more, double step,
                       struct dem_new_particle seed)
{
    return energy_world(world_text(
        "%s effects { %s } %s time { step %.17g; force yes; }", glass,
        effects, more, step), 1, &seed);
}

static double mass(void)
{
    return world_sphere_mass(R, rho);
}

/* s: an impact at 1 m/s on a wall of the same material */
static double impact(void)
{
    return world_contact_time(mass(), R, 0.5*E/(1.0 - nu*nu), 1.0);
}

/* Overlap of a sphere at rest under its weight, at which it starts. */
static double rest_overlap(void)
{
    return pow(mass()*9.81/(4.0/3.0*0.5*E/(1.0 - nu*nu)*sqrt(R)), 2.0/3.0);
}

/* ---- impacts --------------------------------------------------------------------------------- */

/* Largest residual of 40 samples over an impact at 1 m/s. */
static double worst_of_bounce(const char *effects, double step, double *lost, const char *term)
{
    struct dem *const d = one(effects, floor_at_0, step, ball(0.0, 1.02*R, 0.0, -1.0));
    double worst = 0.0;

    for (int k = 0; k < 40; k++)
    {
        world_run(d, impact()/20.0);
        worst = fmax(worst, fabs(energy_term(d, "residual")));
    }
    *lost = energy_term(d, term);
    TAP_OK(world_at(d, 0).v[2] > 0.0 && world_at(d, 0).f[2] == 0.0, "it has bounced");
    dem_free(d);
    return worst/(0.5*mass());
}

static void bounces(void)
{
    const double kinetic = 0.5*mass(), tc = impact();
    double coarse, fine, term;

    coarse = worst_of_bounce("hertz {}", tc/80.0, &term, "elastic_hertz");
    fine = worst_of_bounce("hertz {}", tc/160.0, &term, "elastic_hertz");
    TAP_OK(coarse < 2e-3 && coarse > 3.5*fine && coarse < 4.5*fine,
           "elastic: residual %.3g, %.3g at half the step: second order", coarse, fine);
    TAP_OK(term == 0.0, "no elastic energy after the impact");

    coarse = worst_of_bounce("hertz {} dry { restitution 0.8; }", tc/200.0, &term, "lost_dry");
    fine = worst_of_bounce("hertz {} dry { restitution 0.8; }", tc/400.0, &term, "lost_dry");
    TAP_OK(coarse > 1.7*fine && coarse < 2.3*fine,
           "e = 0.8: residual %.3g, %.3g at half the step: first order", coarse, fine);
    TAP_NEAR(term/kinetic, 1.0 - 0.64, 1e-3,
             /* e itself is 1e-4 off at t_c/400, docs/theory-contact.md */
             "e = 0.8: lost is 1 - e^2");

    /* loading at k stores all of it at d = v sqrt(m/k); k_2 returns k/k_2 of it, k_2 = k + (k_m -
       k) d/d_lim */
    const double k = 1000.0, d_max = sqrt(mass()/k), d_lim = 4.0/3.0*0.05*2.0*R,
                 k_2 = k*(1.0 + 3.0*d_max/d_lim);

    worst_of_bounce("hookeHysteresis { stiffness 1000; unloading 4; }", tc/400.0, &term,
                    "lost_hookeHysteresis");
    TAP_NEAR(term/kinetic, 1.0 - k/k_2, 1e-3,
             /* d_max is seen within a step */
             "plastic: lost is the loop of loading and unloading");
}

/* ---- sliding, rolling, belts ----------------------------------------------------------------- */

static void slides_and_rolls(void)
{
    const double v = 0.5;
    struct dem *d = one(
        "gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } "
        "mindlin { friction 0.3; }",
        floor_at_0, impact()/40.0, ball(0.0, R - rest_overlap(), v, 0.0));

    world_run(d, 0.1);
    TAP_NEAR(world_at(d, 0).v[0], 5.0/7.0*v, 1e-3*v, "it rolls at 5/7 v");
    /* slip decreases as v - 7/2 mu g t, over a distance of v^2/(7 mu g): mu m g s = m v^2/7; the
       lever arm is shorter by the overlap of 4e-3 R */
    TAP_NEAR(energy_term(d, "lost_mindlin")/(mass()*v*v/7.0), 1.0, 5e-3,
             "sliding: mu m g times the slip distance");
    /* the first half kick has no history: there the dashpot alone carries mu m g, which slips at
       v */
    TAP_NEAR(energy_term(d, "residual")/(mass()*v*v/7.0),
             -3.5*0.3*9.81*impact()/40.0/v, 1e-5,
             "the residual is the first half kick's");
    dem_free(d);

    /* 7/10 m v^2; mindlin holds it to rolling without slip */
    struct dem_new_particle rolling = ball(0.0, R - rest_overlap(), 0.05, 0.0);

    rolling.spin[1] = 0.05/(R - rest_overlap());
    d = one(
        "gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } "
        "mindlin { friction 0.5; } rollingConstant { friction 0.02; }",
        floor_at_0, impact()/40.0, rolling);
    const double kinetic =
        energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");

    world_run(d, 0.5);
    TAP_OK(energy_term(d, "kinetic_translation") < 1e-6*kinetic, "it has come to rest");
    TAP_NEAR(energy_term(d, "lost_rollingConstant")/kinetic, 1.0, 2e-3,
             "rolling to rest: all of its energy");   /* a little goes to the tangential dashpot */
    TAP_OK(fabs(energy_term(d, "residual")) < 1e-4*kinetic, "residual %.2g of it",
           energy_term(d, "residual")/kinetic);
    dem_free(d);
}

/* Placed on a belt that moves at V a sphere ends at 2/7 V with a spin of 5/7 V/R: m V^2/7 of
   kinetic energy and as much of heat. */
static void belt(void)
{
    const double V = 0.5;
    struct dem *const d = one(
        "gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } "
        "mindlin { friction 0.3; }",
        "walls { belt { type plane; point (0 0 0); normal (0 0 1); surfaceVelocity (0.5 0 0); } }",
        impact()/40.0, ball(0.0, R - rest_overlap(), 0.0, 0.0));
    const double unit = mass()*V*V/7.0;

    world_run(d, 0.1);
    TAP_NEAR((energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation"))/unit,
             1.0, 1e-2, "belt: kinetic energy");
    TAP_NEAR(energy_term(d, "lost_mindlin")/unit, 1.0, 1e-2,
             "belt: heat");      /* the lever arm is shorter by 4e-3 */
    TAP_NEAR(energy_term(d, "work_walls")/unit, 2.0, 2e-2,
             "belt: its work");            /* the sum of both above */
    TAP_NEAR(energy_term(d, "residual")/unit, -3.5*0.3*9.81*impact()/40.0/V, 1e-5,
             "the residual is the first half kick's");
    dem_free(d);
}

/* ---- bonds, fluid, leaving ------------------------------------------------------------------- */

static void bond(void)
{
    /* A = pi r_b^2, stiffness k_n A; it breaks at a stress of sigma: (sigma A)^2/(2 k_n A) */
    const double k_n = 1e9, sigma = 1e4, A = world_pi*R*R, held = sigma*sigma*A/(2.0*k_n);
    struct dem_new_particle pair[2] = {ball(-R, 0.0, -0.2, 0.0), ball(R, 0.0, 0.2, 0.0)};
    struct dem *const d = energy_world(world_text(
        "%s effects { hertz {} bondLinear { normalStiffness %g; shearStiffness %g; "
        "normalStrength %g; breakDistance 1.5; } } "
        "time { step 1e-7; }",
        glass, k_n, k_n, sigma), 2, pair);

    world_run(d, 5e-4);
    TAP_NEAR(energy_term(d, "broken")/held, 1.0, 2e-2,
             /* a step too late: 0.04 um of 10 um */
             "a bond that breaks loses its elastic energy");
    TAP_OK(energy_term(d, "elastic_bondLinear") == 0.0, "and stores nothing afterwards");
    TAP_OK(fabs(energy_term(d, "residual")) < 1e-2*held, "residual %.2g of it",
           energy_term(d, "residual")/held);
    dem_free(d);
}

static void fluid(void)
{
    const char *const still = "fluid { density 1; viscosity 1e-3; }";
    const double v = 0.01, relaxation = mass()/(6.0*world_pi*1e-3*R);
    struct dem *d = one("stokesDrag {}", still, 1e-4, ball(0.0, 0.0, v, 0.0));

    world_run(d, 20.0*relaxation);
    TAP_NEAR(energy_term(d, "lost_stokesDrag")/(0.5*mass()*v*v), 1.0, 1e-9,
             "drag dissipates all kinetic energy");   /* e^-40 of it is left */
    TAP_OK(energy_term(d, "work_stokesDrag") == 0.0, "a fluid at rest does no work");
    dem_free(d);

    d = one("stokesDrag {}", "fluid { density 1; viscosity 1e-3; velocity (0.01 0 0); }", 1e-4,
            ball(0.0, 0.0, 0.0, 0.0));
    world_run(d, 20.0*relaxation);
    TAP_NEAR(energy_term(d, "work_stokesDrag")/(mass()*v*v), 1.0, 5e-9,
             "a stream does the work m u^2");         /* e^-20 of the slip is left */
    TAP_NEAR(energy_term(d, "lost_stokesDrag")/(0.5*mass()*v*v), 1.0, 1e-6,
             "half of it is dissipated");   /* the mean of a kick's ends: (dt/relaxation)^2/12 */
    dem_free(d);

    /* settling: m g less rho V g, times the distance */
    d = one("gravity { acceleration (0 0 -9.81); } stokesDrag {} pressureGradient {}",
            "fluid { density 1000; viscosity 0.1; }", 1e-5, ball(0.0, 0.0, 0.0, 0.0));
    world_run(d, 0.2);
    const double fall = energy_term(d, "gravity");

    TAP_NEAR(energy_term(d, "work_pressureGradient")/fall, 1000.0/rho, 1e-7,
             /* second order: kicks and drifts */
             "the work of buoyancy is rho/rho_p of the work of gravity");
    TAP_OK(fabs(energy_term(d, "residual")) < 1e-7*fabs(fall), "settling: residual %.2g",
           energy_term(d, "residual")/fall);   /* of the same order */
    dem_free(d);
}

static void leaving(void)
{
    struct dem *const d = one("gravity { acceleration (0 0 -9.81); } hertz {}",
                              "domain { min (-1 -1 -0.1); max (1 1 1); leaving remove; }", 1e-5,
                              ball(0.0, 0.0, 0.3, 0.0));

    world_run(d, 0.2);
    TAP_OK(world_tally(d).particles == 0, "it has fallen out");
    TAP_NEAR(energy_term(d, "left"), 0.5*mass()*0.09 - energy_term(d, "gravity"),
             1e-9*energy_term(d, "left"), "and its energy is in the term left");
    TAP_OK(fabs(energy_term(d, "residual")) < 1e-9*energy_term(d, "left"), "residual %.2g of it",
           energy_term(d, "residual")/energy_term(d, "left"));
    dem_free(d);
}

/* ---- many particles -------------------------------------------------------------------------- */

static struct dem *heap(double step, const char *floor_motion)
{
    return energy_world(world_text(
        "%s effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.8; } "
        "mindlin { friction 0.3; } rollingSpring { friction 0.05; } } "
        "walls { cup { type box; min (0 0 0); max (0.012 0.012 0.1); %s } } "
        "insert { bed { type lattice; count 200; diameter 2e-3; min (0 0 0.001); "
        "max (0.012 0.012 0.05); } } "
        "time { step %.17g; }",
        glass, floor_motion, step), 0, NULL);
}

static void shakes(const char *motion, const char *what)
{
    double residual[2];

    for (int h = 0; h < 2; h++)
    {
        struct dem *const d = heap(8e-6/(1 + h), motion);

        world_run(d, 0.1);
        const double work = energy_term(d, "work_walls");
        const double heat = energy_term(d, "lost_dry") + energy_term(d, "lost_mindlin") +
                            energy_term(d, "lost_rollingSpring");

        residual[h] = fabs(energy_term(d, "residual"))/work;
        TAP_OK(work > 0.0 && heat > 0.5*work,
               "%s: the walls do %.3g J of work, %.3g J are dissipated", what, work, heat);
        dem_free(d);
    }
    TAP_OK(residual[0] < 2e-3 && residual[1] < residual[0]/1.3,
           "%s: residual %.2g of the walls' work, %.2g at half the step", what, residual[0],
           residual[1]);
}

/* The balance starts from the energies of the loaded state; a run without the balance has the same
   bits. */
static void restart(void)
{
    const char *const file = "energy_state.dem";
    struct dem *d = heap(8e-6, "motion { type oscillation; amplitude (0 0 5e-4); frequency 40; }");

    world_run(d, 0.05);
    WORLD_TRY(dem_save(d, file));
    const double elastic = energy_term(d, "elastic_hertz"),
                 friction = energy_term(d, "elastic_mindlin");

    world_run(d, 0.02);
    const uint64_t hash = world_hash(d);

    dem_free(d);
    for (int enabled = 0; enabled < 2; enabled++)
    {
        struct dem_case *c = world_begin(world_text(
            "%s effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.8; } "
            "mindlin { friction 0.3; } rollingSpring { friction 0.05; } } "
            "walls { cup { type box; min (0 0 0); max (0.012 0.012 0.1); "
            "motion { type oscillation; amplitude (0 0 5e-4); frequency 40; } } } "
            "time { step 8e-6; }",
            glass));
        WORLD_TRY(dem_case_load(c, file));
        if (enabled)
        {
            WORLD_TRY(dem_case_enable_energy(c));
        }
        d = world_start(c);
        if (enabled)
        {
            TAP_NEAR(energy_term(d, "elastic_hertz"), elastic, 1e-12*elastic,
                     "loaded: elastic energy of contacts");
            TAP_NEAR(energy_term(d, "elastic_mindlin"), friction, 2e-2*friction,
                     "loaded: elastic energy of friction springs");
            /* sliding springs are cut to the limit with the dashpot at the present velocity, not at
               the velocity half a step before */
            TAP_OK(energy_term(d, "lost_dry") == 0.0 && energy_term(d, "residual") == 0.0,
                   "loaded: losses and residual start at 0");
        }
        world_run(d, 0.02);
        TAP_OK(world_hash(d) == hash, "the same bits %s the energy balance",
               enabled ? "with" : "without");
        if (enabled)
        {
            TAP_OK(fabs(energy_term(d, "residual")) < 2e-3*energy_term(d, "work_walls"),
                   "residual %.2g of the walls' work",
                   energy_term(d, "residual")/energy_term(d, "work_walls"));
        }
        dem_free(d);
    }
    unlink(file);
}

static void not_asked_for(void)
{
    const struct dem_energy_item *item;
    const struct dem_new_particle seed = ball(0.0, 1.0, 0.0, 0.0);
    struct dem *const d = world(world_text("%s effects { hertz {} }", glass), 1, &seed);
    double since;
    int n;

    TAP_OK(dem_energy(d, &since, &n, &item) != 0
               && strstr(dem_error_text(), "dem_case_enable_energy"),
           "dem_energy without dem_case_enable_energy: %s", dem_error_text());
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    bounces();
    slides_and_rolls();
    belt();
    bond();
    fluid();
    leaving();
    shakes("motion { type oscillation; amplitude (0 0 5e-4); frequency 40; }", "shaken");
    restart();
    not_asked_for();
    TAP_DONE;
}
