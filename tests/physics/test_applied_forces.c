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

/* ---- clumps ---------------------------------------------------------------------------------- */

/* Rods of three touching spheres in a row along x: M = 3 m, I = 6/5 m R^2 along the rod, 46/5 m R^2 across it. Ids 0 to 2,
   3 to 5, 6 to 8 (frozen), 10 mm apart along y; 9 is a single sphere. */
static char *rods(const char *forces)
{
    return world_text("materials { m { density %g; youngsModulus 1e7; } } effects { hooke { stiffness 1000; } }"
                      "shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } }"
                      "insert { a { type list; shape rod; orientation (1 0 0 0); positions ((0 0 0) (0 0.01 0)); }"
                      "b { type list; shape rod; orientation (1 0 0 0); frozen yes; positions ((0 0.02 0)); }"
                      "c { type list; diameter 2e-3; positions ((0 0.03 0)); } } %s time { step 1e-6; }", rho, forces);
}

/* Velocity over F t/M and spin over T t/I after 1 ms: of both rods and of the sphere. */
static void pushed_rods(const char *what, const char *chosen, double first, double second, double ball)
{
    struct dem *const d = energy_world(rods(world_text("forces { f { %s force (0 0 1e-4); torque (1e-8 0 0); } }",
                                                       chosen)), 0, NULL);
    const double m = mass(), v = 1e-7/(3.0*m), w = 1e-11/(1.2*m*R*R), share[2] = {first, second};

    world_run(d, 1e-3);
    for (int k = 0; k < 9; k++)
    {
        const double expected = k < 6 ? share[k/3] : 0.0;

        TAP_NEAR(world_at(d, k).v[2], expected*v, 1e-12, "%s: velocity of sphere %d", what, k);
        TAP_NEAR(world_at(d, k).w[0], expected*w, 1e-9*w, "%s: spin of sphere %d", what, k);
    }
    TAP_NEAR(world_at(d, 9).v[2], 3.0*ball*v, 1e-12, "%s: velocity of the single sphere", what);
    const double kinetic = energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");

    TAP_NEAR(energy_term(d, "work_forces"), kinetic, 1e-12*kinetic, "%s: the work is all of the energy", what);
    dem_free(d);
}

/* A rod and a sphere cross a periodic boundary long before the next neighbor list. */
static void across_a_boundary(void)
{
    struct dem *const d = world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } } effects { hooke { stiffness 1000; } }"
        "shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } }"
        "domain { x (0 0.02); periodic (x); } insert {"
        "a { type list; shape rod; orientation (1 0 0 0); velocity (0.1 0 0); positions ((0.01998 0 0)); }"
        "b { type list; diameter 2e-3; velocity (0.1 0 0); positions ((0.01998 0.01 0)); } }"
        "forces { f { min (0 -1 -1); max (0.02 1 1); force (0 0 1e-4); }"
        "g { min (1e-2 -1 -1); max (1 1 1); torque (0 0 1e-9); } } time { step 1e-6; }", rho), 0, NULL);
    const double m = mass(), v = 1e-7/m;

    world_run(d, 1e-3);
    TAP_NEAR(world_at(d, 0).v[2], v/3.0, 1e-12, "a box over the whole period holds a clump that crosses its end");
    TAP_NEAR(world_at(d, 3).v[2], v, 1e-12, "it holds a sphere");
    /* 200 kicks before the boundary, and the first half of one */
    TAP_NEAR(world_at(d, 3).w[2], 1e-9*2e-4/(0.4*m*R*R), 1e-9*1e-6/(0.4*m*R*R),
             "a box at its end loses the sphere there");
    dem_free(d);
}

/* On the last sphere of the first rod. */
static void lift(void *self, double time, const struct dem_view *view, double *force, double *torque)
{
    (void)time;
    (void)torque;
    for (size_t i = 0; i < view->n; i++)
    {
        if (*(const int64_t *)(const void *)dem_at((const double *)(const void *)view->id, view->stride, i) == 2)
        {
            force[3*i + 2] = *(const double *)self;
        }
    }
}

static void program_on_clumps(void)
{
    double f = 1e-5;
    const double m = mass(), t = 1e-3;
    struct dem *const d = energy_world(rods(""), 0, NULL);

    WORLD_TRY(dem_set_force(d, lift, &f));
    world_run(d, t);
    /* the arm turns by 2 R f/I t^2/2 = 1e-4 rad, a relative change of its length by the square */
    TAP_NEAR(world_at(d, 1).v[2], f*t/(3.0*m), 1e-7*f*t/m, "a program lifts a sphere: velocity of the centre");
    TAP_NEAR(world_at(d, 0).w[1], -2.0*R*f*t/(9.2*m*R*R), 1e-7*f*t/(m*R), "and spin of the rod");
    TAP_NEAR(world_at(d, 4).v[2], 0.0, 0.0, "no other rod moves");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-7*energy_term(d, "work_forces"), "no energy comes from nowhere");
    dem_free(d);
}

/* Drag b on the sphere of the same volume: v = F/b (1 - exp(-b t/M)), exact in each kick. */
static void clumps_in_fluid(void)
{
    const double mu = 0.1, F = 1e-4, b = 6.0*world_pi*mu*R*cbrt(3.0), M = 3.0*mass(), t = M/b;
    struct dem *const d = energy_world(world_text(
        "materials { m { density %g; youngsModulus 1e7; } } effects { hertz {} stokesDrag {} }"
        "shapes { rod { spheres ((-2e-3 0 0 1e-3) (0 0 0 1e-3) (2e-3 0 0 1e-3)); } }"
        "insert { a { type list; shape rod; positions ((0 0 0)); } } forces { f { force (0 0 %g); } }"
        "fluid { density 1; viscosity %g; } time { step %.17g; force yes; }", rho, F, mu, t/100.0), 0, NULL);

    world_run(d, t);
    TAP_NEAR(world_at(d, 1).v[2], F/b*(1.0 - exp(-1.0)), 1e-9*F/b, "in a fluid: F/b (1 - exp(-b t/M))");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-9*energy_term(d, "work_forces"), "and no energy comes from nowhere");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    pushed_rods("all", "", 1.0, 1.0, 1.0);
    pushed_rods("by an id of its spheres", "ids (5);", 0.0, 1.0, 0.0);
    pushed_rods("by several: once", "ids (0 2);", 1.0, 0.0, 0.0);
    pushed_rods("by its centre in a box", "min (-1e-3 -1e-3 -1); max (1e-3 1e-3 1);", 1.0, 0.0, 0.0);
    across_a_boundary();
    program_on_clumps();
    clumps_in_fluid();
    driven();
    chosen();
    pressed();
    TAP_DONE;
}
