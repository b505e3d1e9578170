/*
 * test_applied_forces.c -- forces, torques and drives that a scene prescribes act on the chosen
 * particles only, move them by Newton's laws, and do the work that the energy balance reports.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

static const double R = 1e-3, rho = 2500.0;

static double mass(void)
{
    return world_sphere_mass(R, rho);
}

/* m/s and 1/s after 1 ms of the bead with this id, of five on a line along x, 5 mm apart; id 3 is
   of another material, id 4 is frozen */
static void pushed(const char *what, const char *forces, const double v[5], const double w[5])
{
    struct dem *const d = world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } other { density %g; youngsModulus 1e7; } }"
        "effects { hooke { stiffness 1000; } }"
        "insert { a { type list; material m; diameter 2e-3; positions ((0 0 0) (5e-3 0 0) (1e-2 0 0)); }"
        "b { type list; material other; diameter 2e-3; positions ((1.5e-2 0 0)); }"
        "c { type list; material m; frozen yes; diameter 2e-3; positions ((2e-2 0 0)); } }"
        "forces { %s } time { step 1e-6; }", rho, rho, forces),
        0, NULL);

    world_run(d, 1e-3);
    for (int k = 0; k < 5; k++)
    {
        const struct world_particle p = world_at(d, k);

        /* round-off of 1000 kicks */
        TAP_NEAR(p.v[2], v[k], 1e-12, "%s: velocity of id %d", what, k);
        TAP_NEAR(p.w[1], w[k], 1e-9, "%s: spin of id %d", what, k);
    }
    dem_free(d);
}

static void chosen(void)
{
    const double m = mass(), v = 1e-4*1e-3/m, w = 1e-8*1e-3/(0.4*m*R*R);
    static const double none[5] = {0.0, 0.0, 0.0, 0.0, 0.0};

    pushed("all", "f { force (0 0 1e-4); }", (const double[5]){v, v, v, v, 0.0}, none);
    pushed("by id", "f { ids (2 0); force (0 0 1e-4); torque (0 1e-8 0); }",
           (const double[5]){v, 0.0, v, 0.0, 0.0}, (const double[5]){w, 0.0, w, 0.0, 0.0});
    pushed("by material", "f { material other; force (0 0 1e-4); }",
           (const double[5]){0.0, 0.0, 0.0, v, 0.0}, none);
    pushed("in a box", "f { min (4e-3 -1 -1); max (11e-3 1 1); force (0 0 1e-4); }",
           (const double[5]){0.0, v, v, 0.0, 0.0}, none);
    pushed("two add up", "f { force (0 0 1e-4); } g { ids (1); force (0 0 -3e-4); }",
           (const double[5]){v, -2.0*v, v, v, 0.0}, none);

    /* each kick takes the force at its own time: 400 whole kicks of 1 us from 0.2 ms on */
    pushed("for a time", "f { ids (1); force (0 0 1e-4); start 0.1995e-3; end 0.5995e-3; }",
           (const double[5]){0.0, 0.4*v, 0.0, 0.0, 0.0}, none);
}

static void pressed(void)
{
    const double F = 0.01, k = 1000.0, m = mass(), w = sqrt(2.0*k/m), half = world_pi/w;
    struct dem *const d = energy_world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } } effects { hooke { stiffness %g; } }"
        "insert { a { type list; diameter 2e-3; positions ((0 0 0) (0 0 2e-3)); } }"
        "forces { down { ids (1); force (0 0 %g); } up { ids (0); force (0 0 %g); } }"
        "time { step %.17g; }", rho, k, -F, F, half/1000.0), 0, NULL);

    world_run(d, half);
    const double overlap = 2.0*R - (world_at(d, 1).x[2] - world_at(d, 0).x[2]);

    /* the frequency is too high by (w dt)^2/24 = 4e-7 of itself */
    TAP_NEAR(overlap, 2.0*F/k, 1e-6*2.0*F/k, "pressed by %g N: overlap 2 F/k", F);
    TAP_NEAR(energy_term(d, "work_forces"), F*2.0*F/k, 1e-5*F*2.0*F/k, "work F 2 F/k");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-5*F*2.0*F/k, "no energy comes from nowhere");
    dem_free(d);
}

static void driven(void)
{
    const double m = mass(), v = 0.1, k = 1000.0, time = 2.0*world_pi*sqrt(m/k), g = 9.81;
    struct dem *const d = energy_world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } } effects { hooke { stiffness %g; }"
        "gravity { acceleration (0 0 %g); } }"
        "insert { a { type list; driven yes; velocity (0 0 %g); spin (3 0 0); diameter 2e-3;"
        "             positions ((0 0 0)); }"
        "b { type list; diameter 2e-3; positions ((0 0 2.0001e-3)); } } time { step %.17g; }",
        rho, k, 0.0, v, time/4000.0), 0, NULL);

    world_run(d, time);
    const struct world_particle a = world_at(d, 0), b = world_at(d, 1);

    TAP_OK(a.v[2] == v && a.w[0] == 3.0, "a driven particle keeps velocity and spin");
    TAP_NEAR(a.x[2], v*time, 1e-12*v*time, "and moves with it");
    /* 2000 steps a contact: (pi/2000)^2/24 of the frequency */
    TAP_NEAR(b.v[2], 2.0*v, 1e-5*v, "a free one that it hits leaves at twice its speed");
    TAP_NEAR(energy_term(d, "work_driven"), 2.0*m*v*v, 1e-4*m*v*v, "work of the drive: 2 m v^2");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-4*m*v*v, "no energy comes from nowhere");
    dem_free(d);

    struct dem *const e = energy_world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } } effects { hooke { stiffness %g; }"
        "gravity { acceleration (0 0 %g); } }"
        "insert { a { type list; driven yes; velocity (0 0 %g); diameter 2e-3;"
        "             positions ((0 0 0)); } } time { step 1e-5; }", rho, k, -g, v), 0, NULL);

    world_run(e, 0.1);
    TAP_NEAR(energy_term(e, "work_driven"), m*g*v*0.1, 1e-10*m*g*v*0.1, "lifted: m g h");
    TAP_NEAR(energy_term(e, "residual"), 0.0, 1e-10*m*g*v*0.1, "lifted: no energy from nowhere");
    dem_free(e);
}

int main(void)
{
    TAP_TRAPS;
    driven();
    chosen();
    pressed();
    TAP_DONE;
}
