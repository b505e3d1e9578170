/*
 * test_heat_energy.c -- heat of friction, damping, plastic work and broken bonds goes to its
 * partners, and all heat is accounted for.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include <float.h>
#include <math.h>

static const double R = 1e-3, rho = 2500.0, E = 1e7, nu = 0.3, c = 0.5;

#define MATERIAL                                                                                   \
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; conductivity 1; "     \
    "heatCapacity 0.5; } }"

static double mass(void)
{
    return world_sphere_mass(R, rho);
}

static double temperature(struct dem *d, int64_t id)
{
    return world_scalar(d, "temperature", id);
}

/* Rounding of the temperatures in a run, at 400 K: half a unit in the last place a step. */
static double rounding(double steps, double particles)
{
    return particles*steps*mass()*c*400.0*0.5*DBL_EPSILON;
}

/* Gain of heat less where it comes from. */
static double unexplained(struct dem *d)
{
    return energy_term(d, "heat_content") - energy_term(d, "heat_dissipated") -
           energy_term(d, "heat_walls") - energy_term(d, "heat_fluid");
}

/* At rest on its overlap, with 1 m/s: 2/7 v of it are lost after t = 2 v/(7 mu g). */
static void slides(const char *wall, double kept)
{
    const double weight = mass()*9.81, e_star = 0.5*E/(1.0 - nu*nu), v = 1.0, mu = 0.3, dt = 2e-6,
                 end = 0.12;
    const double depth = pow(weight/(4.0/3.0*e_star*sqrt(R)), 2.0/3.0);
    struct dem *const d = energy_world(world_text(
        MATERIAL "effects { hertz { } mindlin { friction %g; } gravity { acceleration (0 0 -9.81); } "
        "frictionHeat { %s } } walls { floor { type plane; point (0 0 0); normal (0 0 1); } } "
        "insert { one { type list; diameter %g; positions ((0 0 %.17g)); velocity (%g 0 0); "
        "temperature 300; } } time { step %g; }", mu, wall, 2.0*R, R - depth, v, dt),
        0, NULL);

    world_run(d, end);    /* 2 v/(7 mu g) is 0.097 s */
    const double lost = energy_term(d, "heat_dissipated"), gain = temperature(d, 0) - 300.0;
    /* J/kg  v^2/7, and 8e-4 more for the lever arm R - depth of friction */
    const double all = 0.5*v*v/(1.0 + 2.5*(1.0 - depth/R)*(1.0 - depth/R));

    TAP_NEAR(lost/(mass()*all), 1.0, 1e-5, "sliding: m v^2/7 is dissipated");    /* of the step */
    TAP_NEAR(mass()*c*gain/lost, kept, 1e-9, "%g of it heats the sphere", kept);
    TAP_NEAR(gain, kept*all/c, 1e-5*all/c, "by v^2/(7 c) times it");
    TAP_NEAR(energy_term(d, "heat_walls")/lost, kept - 1.0, 1e-9, "the rest heats the wall");
    TAP_NEAR(energy_term(d, "lost_mindlin"), lost, 1e-12*lost, "it is the loss of friction");
    TAP_NEAR(unexplained(d), 0.0, rounding(end/dt, 1.0), "the heat is accounted for");
    TAP_NEAR(energy_term(d, "residual")/lost, 0.0, 1e-4,    /* of the integrator */
             "so is the energy");
    dem_free(d);
}

/* Two spheres at 1 m/s each; `more` are effects. */
static void collides(const char *effects, double lost_fraction, const char *claim)
{
    const double dt = 1e-6, end = 1e-3, energy = mass();
    struct dem *const d = energy_world(world_text(
        MATERIAL "effects { %s frictionHeat { } } insert { two { type list; diameter %g; "
        "positions ((0 0 0) (%.17g 0 0)); velocities ((1 0 0) (-1 0 0)); temperatures (300 350); } } "
        "time { step %g; force yes; }", effects, 2.0*R, 2.02*R, dt),
        0, NULL);

    world_run(d, end);
    const double a = temperature(d, 0) - 300.0, b = temperature(d, 1) - 350.0;

    TAP_NEAR(mass()*c*(a + b)/energy, lost_fraction, 2e-3, "%s", claim);
    TAP_NEAR(a, b, rounding(end/dt, 2.0)/(mass()*c), "half of it heats each sphere");
    TAP_NEAR(unexplained(d), 0.0, rounding(end/dt, 2.0), "the heat is accounted for");
    dem_free(d);
}

/* A bond that is pulled apart loses its stored energy, which heats its partners. */
static void breaks(void)
{
    const double dt = 1e-7;
    struct dem *const d = energy_world(world_text(
        MATERIAL "effects { bondLinear { normalStiffness 1e11; shearStiffness 1e11; radius 0.5; "
        "makeDistance 1.01; normalStrength 1e5; shearStrength 1e5; } frictionHeat { } } "
        "insert { two { type list; diameter %g; positions ((0 0 0) (%.17g 0 0)); "
        "velocities ((-0.1 0 0) (0.1 0 0)); temperature 300; } } time { step %g; force yes; }",
        2.0*R, 2.0*R, dt), 0, NULL);

    world_run(d, 2e-4);
    TAP_OK(energy_term(d, "broken") > 0.0, "the bond is broken");
    TAP_NEAR(mass()*c*(temperature(d, 0) + temperature(d, 1) - 600.0)/
                 (energy_term(d, "broken") + energy_term(d, "lost_bondLinear")), 1.0, 1e-6,
             "its energy heats the partners");
    TAP_NEAR(unexplained(d), 0.0, rounding(2e-4/dt, 2.0), "the heat is accounted for");
    dem_free(d);
}

/* Spheres of random temperatures fall into a box. */
static void bed(const char *walls, const char *effects, const char *claim)
{
    const double dt = 1e-5, end = 0.1;
    struct dem *const d = energy_world(world_text(
        MATERIAL "effects { hertz { } dry { restitution 0.5; } mindlin { friction 0.4; } "
        "rollingSpring { friction 0.1; } conduction { } %s gravity { acceleration (0 0 -9.81); } "
        "frictionHeat { wallFraction 0; } } walls { box { type box; min (0 0 0); "
        "max (0.012 0.012 0.05); %s } } insert { spheres { type lattice; count 150; diameter %g; "
        "min (0 0 0); max (0.012 0.012 0.05); velocity (0.1 0.2 0); "
        "temperature { min 300; max 400; } } } time { step %g; }", effects, walls, 2.0*R, dt),
        0, NULL);

    world_run(d, end);
    const double lost = energy_term(d, "heat_dissipated"), given = energy_term(d, "heat_walls");

    /* insulated: a step of dissipation is rounded by multiplication */
    TAP_OK(lost > 0.0 && (fabs(given) > 1e-12*lost) == (walls[0] != '\0'), "%s", claim);
    TAP_NEAR(unexplained(d), 0.0, rounding(end/dt, 150.0)/30.0,    /* signs are at random */
             "its heat is accounted for, in %g steps of 150 particles", end/dt);
    TAP_NEAR(energy_term(d, "lost_dry") + energy_term(d, "lost_mindlin") +
                 energy_term(d, "lost_rollingSpring"), lost, 1e-12*lost,
             "contacts have lost all that is dissipated");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    slides("", 0.5);
    slides("wallFraction 0;", 1.0);
    collides("hertz { } dry { restitution 0.8; }", 1.0 - 0.64, "a damped impact: 1 - e^2");
    collides("hertz { }", 0.0, "an elastic one: nothing");
    breaks();
    bed("", "", "an adiabatic bed");
    bed("temperature { value 350; }", "gasFilm { conductivity 0.026; }", "a bed in hot walls, with gas films");
    TAP_DONE;
}
