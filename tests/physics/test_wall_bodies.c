/*
 * test_wall_bodies.c -- walls that are moved by force: free, on a hinge, pressed by a servo.
 *
 * Sources: Hertz; one-dimensional chains of springs; pendulum of finite amplitude (complete elliptic
 * integral); impact on a body on a hinge. The formulas stand beside the claims.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include "physics/world.h"

#include "dem_numbers.h"
#include <unistd.h>

static const double R = 0.5e-3, density = 2500.0;

static struct dem_wall_position position(const struct dem *d, int wall)
{
    struct dem_wall_position p;

    dem_wall_position(d, wall, &p);
    return p;
}

static double force_z(struct dem *d, int wall)
{
    double force[3], torque[3];

    WORLD_TRY(dem_wall_load(d, wall, force, torque));
    return force[2];
}

/* A straight column of n spheres that touch, on a floor at 0, below a lid. */
static struct dem *column(int n, const char *laws, const char *floor, const char *lid, double step)
{
    struct dem_new_particle *const seed = (struct dem_new_particle *)(void *)world_room((size_t)n*sizeof *seed);

    for (int k = 0; k < n; k++)
    {
        seed[k] = (struct dem_new_particle){.diameter = 2.0*R, .material = "glass", .id = k,
                                            .position = {0.0, 0.0, (2*k + 1)*R}};
    }
    return world(world_text("materials { glass { density %g; youngsModulus 1e7; poissonsRatio 0.3; } } "
                            "effects { %s } walls { floor { type plane; point (0 0 0); normal (0 0 1); %s } "
                            "lid { type plane; point (0 0 %.17g); normal (0 0 -1); motion { %s } } } "
                            "time { step %g; }", density, laws, floor, 2*n*R, lid, step), n, seed);
}

/* ---- statics --------------------------------------------------------------------------------- */

/* Nine contacts of spheres and two with planes, of the same material, in series under a force F:
   d = (F/(4/3 E* sqrt r))^(2/3), E* = E/(2 (1 - nu^2)), r = R/2 or R. */
static void hertz_column(const char *lid, const char *what)
{
    static const double F = 1e-3, stiff = 1e7/(2.0*(1.0 - 0.09))*4.0/3.0;
    const double settles = 9.0*pow(F/(stiff*sqrt(0.5*R)), 2.0/3.0) + 2.0*pow(F/(stiff*sqrt(R)), 2.0/3.0);
    struct dem *const d = column(10, "hertz {} dry { restitution 0.3; }", "", lid, 4e-6);

    world_run(d, 0.3);
    TAP_NEAR(settles, 44.555e-6, 5e-10, "a column of 10 spheres settles by 44.555 um by Hertz");
    TAP_NEAR(position(d, 1).moved[0]/settles, 1.0, 1e-6, "%s: the column settles by it", what);
    TAP_NEAR(force_z(d, 1)/F, 1.0, 1e-6, "%s: and the wall has its force", what);
    dem_free(d);
}

/* ---- dynamics -------------------------------------------------------------------------------- */

/* A plate that is let go where it just touches a sphere: W d = 2/5 k d^(5/2) at the turn, where the
   force is 5/2 W and the overlap (5/2)^(2/3) of the overlap at rest. The sphere is heavy enough to be at
   rest, 1e-7 of its acceleration remains. */
static void plate(void)
{
    static const double W = 9.81e-3, k = 4.0/3.0*1e7/0.91;
    const double rest = pow(W/(k*sqrt(R)), 2.0/3.0);
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, R}};
    struct dem *const d = world(
        world_text("materials { glass { density 2e13; youngsModulus 1e7; poissonsRatio 0.3; } "
                   "rigid { density 1; youngsModulus 1e30; } } effects { hertz {} } "
                   "walls { lid { type plane; material rigid; point (0 0 %.17g); normal (0 0 -1); "
                   "motion { type free; mass 1e-3; force (0 0 %.17g); } } } time { step 2e-6; }",
                   2.0*R, -W), 1, &seed);
    double most = 0.0, deepest = 0.0;

    for (int n = 0; n < 3000; n++)
    {
        world_step(d);
        most = fmax(most, force_z(d, 0));
        deepest = fmax(deepest, position(d, 0).moved[0]);
    }
    TAP_NEAR(most/W, 2.5, 2.5e-3, "a plate released on a sphere: at most 2.5 of its weight");
    TAP_NEAR(deepest/rest, pow(2.5, 2.0/3.0), 1.8e-3, "at 1.842 of the overlap at rest");
    dem_free(d);
}

/* The servo is a dashpot of the chain's impedance: its wave carries half the force, the floor doubles
   it, and the wave that comes back is not reflected. In units of sqrt(m/k) a wave takes 1 a sphere. */
static void servo_on_chain(void)
{
    enum { N = 40 };
    static const double F = 1e-3, k = 1000.0;
    const double m = world_sphere_mass(R, density), unit = sqrt(m/k), step = 0.11*unit;
    const double away = 0.2*F/sqrt(k*m);
    struct dem *const d = column(
        N, world_text("hooke { stiffness %g; }", k),
        world_text("motion { type translation; velocity (0 0 %.17g); start %.17g; }", -away, 500*unit),
        world_text("type servo; force %g; maxSpeed %g;", F, F/sqrt(k*m)), step);
    double sum[3] = {0.0, 0.0, 0.0};
    int count[3] = {0, 0, 0};

    for (int n = 1; n*step < 1400*unit; n++)
    {
        const double t = n*step/unit;
        const int which = t > 20 && t < 75 ? 0 : t > 90 && t < 150 ? 1 : t > 1300 ? 2 : -1;

        world_step(d);
        if (which >= 0)
        {
            sum[which] += force_z(d, 1)/F;
            count[which]++;
        }
    }
    TAP_NEAR(sum[0]/count[0], 0.5, 0.015, "servo on a chain of springs: half the force");
    TAP_NEAR(sum[1]/count[1], 1.0, 0.03, "all of it when the wave has come back");
    /* without the integral it would be 0.8 */
    TAP_NEAR(sum[2]/count[2], 1.0, 0.01, "also when the floor moves away, after ten round trips");
    TAP_NEAR(position(d, 1).velocity[0]/away, 1.0, 0.05, "with the speed of the floor");
    dem_free(d);
}

/* A ball that meets a servo: the wall slows down with the force that grows, and does not swing from step to step, in
   which its dashpot would dissipate several times the energy that there is. */
static void servo_on_ball(void)
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, 0.999*R},
                                    .velocity = {0.0, 0.0, 0.05}};
    struct dem *const d = world("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { "
                                "hertz {} dry { restitution 0.3; } } walls { lid { type plane; point (0 0 1e-3); "
                                "normal (0 0 -1); motion { type servo; force 1e-3; maxSpeed 0.1; } } }", 1, &seed);
    double v[3] = {0.0, 0.0, 0.0};
    int turns = 0;

    for (int n = 0; n < 60; n++)
    {
        world_step(d);
        v[0] = v[1];
        v[1] = v[2];
        v[2] = position(d, 0).velocity[0];
        turns += n > 2 && (v[1] - v[0])*(v[2] - v[1]) < 0.0;
    }
    TAP_OK(turns <= 2, "the velocity of a servo that meets a ball turns %d times in 60 steps", turns);
    dem_free(d);
}

/* Without gravity, below the pressure of their own collisions for a while. */
static void servo_on_loose_layer(void)
{
    struct dem *const d = energy_world(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} dry { "
        "restitution 0.3; } mindlin { friction 0.3; } } walls { box { type box; min (0 0 0); max (0.01 0.01 0.1); } "
        "lid { type plane; point (0 0 6e-3); normal (0 0 -1); "
        "motion { type servo; pressure 10; area 1e-4; maxSpeed 0.1; } } } "
        "insert { grains { type random; count 300; diameter 1e-3; min (0 0 0); max (0.01 0.01 6e-3); } } ", 0, NULL);

    world_run(d, 0.05);
    TAP_OK(fabs(energy_term(d, "residual")) < 0.25*energy_term(d, "lost_dry"),
           "energy of a loose layer below a servo at the automatic step: residual %.2g J, %.2g J lost",
           energy_term(d, "residual"), energy_term(d, "lost_dry"));
    dem_free(d);
}

/* T = 2 pi sqrt(I/(m g a)) 2 K(sin^2(1/2))/pi = 1.066334 of it from rest at 1 rad. */
static void hinge(void)
{
    static const double I = 2e-6, m = 1e-3, a = 0.03, g = 9.81, step = 1e-4;
    const double T = 1.066334*2.0*world_pi*sqrt(I/(m*g*a));
    struct dem *const d = world(
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
                   "effects { hertz {} gravity { acceleration (0 0 -9.81); } } "
                   "walls { flap { type triangles; corners ((0 -0.01 0) (%g -0.01 %g) (0 0.01 0)); motion { "
                   "type hinge; origin (0 0 0); axis (0 1 0); inertia %g; mass %g; centre (%.17g 0 %.17g); } } } "
                   "time { step %g; }", 2*a*sin(1.0), -2*a*cos(1.0), I, m, a*sin(1.0), -a*cos(1.0), step), 0, NULL);
    double crossed[2] = {0.0, 0.0}, before = -1.0;
    int crossings = 0;

    for (int n = 1; crossings < 2 && n < 20000; n++)
    {
        world_step(d);
        const double now = position(d, 0).moved[0] - 1.0;

        if ((now > 0.0) != (before > 0.0))
        {
            crossed[crossings++] = (n - now/(now - before))*step;
        }
        before = now;
    }
    TAP_NEAR(2.0*(crossed[1] - crossed[0])/T, 1.0, 1e-4, "a flap swings from 1 rad with the period of a pendulum");
    dem_free(d);
}

/* omega = (1 + e) v r/(I/m + r^2); here e = 1. The flap turns by omega t_c in the contact, by which
   arm and normal change. */
static void ball_on_flap(void)
{
    static const double v = 0.1, arm = 0.06, I = 1e-7;
    const double m = world_sphere_mass(R, density), omega = 2.0*v*arm/(I/m + arm*arm);
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .velocity = {v, 0.0, 0.0},
                                    .position = {-1.1*R, 0.0, -arm}};
    struct dem_case *const c = world_begin(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
        "walls { flap { type triangles; corners ((0 -0.01 0) (0 0.01 0) (0 0.01 -0.1) (0 -0.01 0) "
        "(0 0.01 -0.1) (0 -0.01 -0.1)); motion { type hinge; origin (0 0 0); axis (0 1 0); inertia 1e-7; "
        "stops (-0.01 0.1); } } } time { step 1e-6; }");

    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    WORLD_TRY(dem_case_enable_energy(c));
    struct dem *const d = world_start(c);

    world_run(d, 2e-3);
    const double found = -position(d, 0).velocity[0], back = world_at(d, 0).v[0];

    TAP_NEAR(found/omega, 1.0, 3e-4, "a ball strikes a flap: its angular velocity");
    TAP_NEAR((m*(v - back)*arm)/(I*found), 1.0, 3e-4, "which is the angular momentum of the ball");
    TAP_NEAR(energy_term(d, "kinetic_walls")/(0.5*I*found*found), 1.0, 1e-12, "kinetic energy of the flap");
    TAP_NEAR(energy_term(d, "residual")/(0.5*m*v*v), 0.0, 1e-5, "energy balance");
    world_run(d, 0.1);
    TAP_NEAR(position(d, 0).moved[0], -0.01, 0.0, "it ends at its stop");
    TAP_NEAR(energy_term(d, "lost_walls")/(0.5*I*found*found), 1.0, 1e-12, "where its energy is lost");
    TAP_NEAR(energy_term(d, "residual")/(0.5*m*v*v), 0.0, 1e-5, "and nothing else");
    dem_free(d);
}

/* ---- energy ---------------------------------------------------------------------------------- */

static const char bed[] =
    "insert { grains { type random; min (0 0 0.5e-3); max (8e-3 8e-3 9e-3); count 300; diameter 1e-3; "
    "material glass; seed 3; } } ";

static char *pressed(const char *laws, const char *lid)
{
    return world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} %s "
        "gravity { acceleration (0 0 -9.81); } } walls { box { type box; min (0 0 0); max (8e-3 8e-3 0.1); } "
        "lid { type triangles; corners ((-1e-3 -1e-3 11e-3) (9e-3 -1e-3 11e-3) (9e-3 9e-3 11e-3) "
        "(-1e-3 -1e-3 11e-3) (9e-3 9e-3 11e-3) (-1e-3 9e-3 11e-3)); motion %s } } %s time { step 4e-6; }",
        laws, world_text(lid[0] == '(' ? "%s;" : "{ %s }", lid), bed);
}

/* In flight the terms of the wall alone balance, exactly; on the bed the error is the integrator's:
   elastic contacts, second order in the step. */
static void energy(void)
{
    char *const scene = pressed("", "type free; axis (0 0 1); mass 2e-3; damping 1e-3; force (0 0 -0.05);");
    struct dem *const d = energy_world(scene, 0, NULL);

    world_run(d, 4e-4);
    const double kinetic = energy_term(d, "kinetic_walls"), loads = energy_term(d, "work_loads"),
                 lost = energy_term(d, "lost_walls");

    TAP_OK(kinetic > 0.0 && lost > 0.0, "a lid falls through a damper: %g J, %g J lost", kinetic, lost);
    TAP_NEAR((kinetic + lost)/loads, 1.0, 1e-12, "the work of its weight and load");
    world_run(d, 0.05);
    TAP_OK(force_z(d, 6) > 0.0, "it lies on the bed");
    TAP_NEAR(energy_term(d, "residual")/energy_term(d, "work_loads"), 0.0, 1e-3,
             "energy balance of lid and bed");
    /* the half steps at the end of a run: force times acceleration times dt^2/8 */
    TAP_NEAR(energy_term(d, "work_walls")/energy_term(d, "work_loads"), 0.0, 1e-6,
             "no wall has a given motion, and none does work");
    dem_free(d);
}

/* A lid that a load throws on a sphere: elastic, so the error of the balance is the integrator's. */
static double thrown(double step)
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, R}};
    struct dem *const d = energy_world(
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
                   "walls { floor { type plane; point (0 0 0); normal (0 0 1); } lid { type plane; point (0 0 1.1e-3); "
                   "normal (0 0 -1); motion { type free; mass 5e-6; force (0 0 -1e-2); } } } time { step %g; }", step),
        1, &seed);

    world_run(d, 5e-4);
    const double residual = energy_term(d, "residual")/energy_term(d, "work_loads");

    dem_free(d);
    return residual;
}

/* ---- restart --------------------------------------------------------------------------------- */

static void restart(const char *lid, const char *what)
{
    char *const scene = pressed("dry { restitution 0.5; } mindlin { friction 0.4; }", lid);
    char path[] = "/tmp/bodies.XXXXXX";
    struct dem *d = world(scene, 0, NULL);
    double time;

    world_make_file(path);
    world_run(d, 0.04);
    WORLD_TRY(dem_save(d, path));
    WORLD_TRY(dem_backup_every(d, 0));
    world_run(d, 0.02);
    const uint64_t whole = world_hash(d);
    const struct dem_wall_position at = position(d, 6);

    WORLD_TRY(dem_restore(d, &time));
    world_run(d, 0.02);
    TAP_OK(world_hash(d) == whole && position(d, 6).moved[0] == at.moved[0], "%s: the same bits from a backup", what);
    dem_free(d);
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, path));
    d = world_start(c);
    world_run(d, 0.02);
    TAP_OK(world_hash(d) == whole && position(d, 6).moved[0] == at.moved[0] &&
               position(d, 6).velocity[0] == at.velocity[0],
           "%s: and from a snapshot", what);
    dem_free(d);
    unlink(path);
}

/* A run of `before` for 0.04 s, continued with the lid of `after`. */
static struct dem *edited(const char *before, const char *after, struct dem_wall_position *was)
{
    char path[] = "/tmp/bodies.XXXXXX";
    struct dem *const d = world(pressed("dry { restitution 0.5; }", before), 0, NULL);

    world_make_file(path);
    world_run(d, 0.04);
    WORLD_TRY(dem_save(d, path));
    *was = position(d, 6);
    dem_free(d);
    struct dem_case *const c = world_begin(pressed("dry { restitution 0.5; }", after));

    WORLD_TRY(dem_case_load(c, path));
    struct dem *const next = world_start(c);

    unlink(path);
    return next;
}

/* The snapshot has no sums over the contacts of the new body. */
static void begins_at_rest(const char *before, const char *after, const char *what)
{
    struct dem_wall_position was;
    struct dem *const d = edited(before, after, &was);

    world_step(d);
    TAP_OK(position(d, 6).moved[0] == 0.0, "%s from a snapshot rests until its contacts are summed: moved %g m",
           what, position(d, 6).moved[0]);
    world_step(d);
    TAP_OK(position(d, 6).moved[0] != 0.0, "and moves then");
    dem_free(d);
}

/* An edited motion before it does not take the state of the body away. */
static void keeps_state(const char *before, const char *after, const char *what)
{
    struct dem_wall_position was;
    struct dem *const d = edited(before, after, &was);
    const struct dem_wall_position now = position(d, 6);

    TAP_OK(was.moved[0] != 0.0 && now.moved[0] == was.moved[0] && now.velocity[0] == was.velocity[0],
           "%s: the servo goes on at %g m with %g m/s", what, now.moved[0], now.velocity[0]);
    TAP_NEAR(now.shift[0] - was.shift[0], 0.0, 1e-15, "from where the lid stood");
    dem_free(d);
}

static void write_rows(const char *path, double x)
{
    FILE *const f = fopen(path, "w");

    fprintf(f, "time, x\n0, 0\n0.02, %g\n0.06, 2e-4\n", x);
    fclose(f);
}

/* The file changes, the scene does not. */
static void other_rows(const char *body)
{
    char path[] = "/tmp/rows.XXXXXX", saved[] = "/tmp/bodies.XXXXXX";

    world_make_file(path);
    world_make_file(saved);
    write_rows(path, 1e-4);
    char *const scene = pressed("", world_text("( { type table; file \"%s\"; } %s )", path, body));
    struct dem *d = world(scene, 0, NULL);

    world_run(d, 0.04);
    WORLD_TRY(dem_save(d, saved));
    const struct dem_wall_position was = position(d, 6);

    dem_free(d);
    write_rows(path, 0.5e-4);
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, saved));
    d = world_start(c);
    const char *const note = dem_scene_note(d, 0);

    TAP_OK(note && strstr(note, "table of the motion of wall lid has other rows"), "note: %s", note ? note : "none");
    TAP_NEAR(position(d, 6).shift[0] - was.shift[0], 0.0, 1e-15, "it goes on from where it stood");
    TAP_OK(!was.axes || (was.moved[0] != 0.0 && position(d, 6).moved[0] == was.moved[0]),
           "with the state of its servo: %g m", was.moved[0]);
    dem_free(d);
    unlink(path);
    unlink(saved);
}

/* ---- absence --------------------------------------------------------------------------------- */

/* A lid that meets nothing any more: 0.3 s are 300 diameters. */
static void absent_from(void)
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, R}};
    struct dem *const d = world(
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} dry "
                   "{ restitution 0.3; } } stages { press { duration 0.02; } open { duration 0.3; } } walls { floor { "
                   "type plane; point (0 0 0); normal (0 0 1); } lid { type plane; point (0 0 1.1e-3); normal (0 0 -1); "
                   "until open; motion { type servo; force 1e-3; maxSpeed 1; } } } time { step 4e-6; }"), 1, &seed);

    world_run(d, 0.0201);
    const double at = position(d, 1).moved[0];

    world_run(d, 0.29);
    TAP_OK(at > 1e-4 && position(d, 1).moved[0] == at, "a servo that has gone rests: at %g m", at);
    dem_free(d);
}

static void absent_until(void)
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, R}};
    struct dem *const d = world(
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} dry "
                   "{ restitution 0.3; } } stages { fill { duration 0.01; } press { duration 0.01; } } walls { floor { "
                   "type plane; point (0 0 0); normal (0 0 1); } lid { type triangles; corners ((-1e-2 -1e-2 1.1e-3) "
                   "(1e-2 -1e-2 1.1e-3) (0 2e-2 1.1e-3)); from press; motion { type servo; axis (0 0 -1); force 1e-3; "
                   "maxSpeed 0.1; } } } time { step 4e-6; }"), 1, &seed);

    struct dem_wall_info facts;

    world_run(d, 0.009);
    dem_wall_info(d, 1, &facts);
    TAP_OK(facts.passes && facts.absent, "it is known to be absent");
    TAP_OK(position(d, 1).moved[0] == 0.0, "a servo that comes later waits: moved %g m", position(d, 1).moved[0]);
    world_run(d, 0.011);
    dem_wall_info(d, 1, &facts);
    TAP_OK(facts.passes && !facts.absent, "and to have come");
    TAP_NEAR(force_z(d, 1)/1e-3, 1.0, 1e-3, "and presses when it is there");
    dem_free(d);
}

/* ---- clumps ---------------------------------------------------------------------------------- */

/* The damping of a servo on one contact is sqrt(k M), M the mass of the clump. */
static void servo_on_clump(void)
{
    static const double k = 1000.0, F = 1e-3;
    struct dem *const d = world(
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hooke { "
                   "stiffness %g; } } shapes { pair { spheres ((0 0 -0.5e-3 1e-3) (0 0 0.5e-3 1e-3)); } } walls { lid { "
                   "type plane; point (0 0 1.5e-3); normal (0 0 -1); motion { type servo; force %g; maxSpeed 1; } } } "
                   "insert { one { type list; material glass; shape pair; positions ((0 0 -1e-8)); } } "
                   "time { step 1e-6; }", k, F), 0, NULL);
    double mass = 0.0;

    for (int n = 0; n < 40; n++)
    {
        world_step(d);
    }
    for (int n = 0; n < 2; n++)
    {
        mass += world_at(d, n).mass;
    }
    TAP_NEAR((F - force_z(d, 0))/position(d, 0).velocity[0]/sqrt(k*mass), 1.0, 1e-9,
             "a servo on a clump has the impedance of the clump's mass");
    dem_free(d);
}

/* ---- loads ----------------------------------------------------------------------------------- */

static char *loaded_scene(const char *table)
{
    return world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
                      "walls { lid { type plane; point (0 0 0); normal (0 0 -1); motion ( { type translation; velocity "
                      "(0.3 0 0); } { type free; mass 1e-9; damping 4; force { file \"%s\"; interpolation linear; } } ); } } "
                      "time { step 1e-4; }", table);
}

/* A load of the program is in the snapshot; NULL takes the scene's back, here 2 N/s since 0. */
static void restarts_loaded(struct dem *d, const char *table)
{
    char saved[] = "/tmp/bodies.XXXXXX";

    world_make_file(saved);
    WORLD_TRY(dem_save(d, saved));
    struct dem_case *const c = world_begin(loaded_scene(table));

    WORLD_TRY(dem_case_load(c, saved));
    struct dem *const next = world_start(c);
    const char *const note = dem_scene_note(next, 0);

    TAP_OK(note && strstr(note, "wall lid has the load that the program has set"), "note: %s", note ? note : "none");
    world_run(next, 0.01);
    TAP_NEAR(position(next, 0).velocity[0], -0.25, 1e-9, "it goes on after a restart");
    WORLD_TRY(dem_wall_set_load(next, "lid", NULL));
    world_run(next, 0.08);
    TAP_NEAR(position(next, 0).velocity[0], -0.2*2.0/4.0, 1e-6, "until the scene's load is taken back");
    dem_free(next);
    unlink(saved);
}

/* v = F/c behind a damper without mass to speak of; a table rises linearly. */
static void loads(void)
{
    char path[] = "/tmp/load.XXXXXX";
    FILE *const f = fdopen(mkstemp(path), "w");

    fputs("time, z\n0, 0\n1, 2\n", f);
    fclose(f);
    struct dem *const d = world(loaded_scene(path), 0, NULL);

    world_run(d, 0.1);
    TAP_NEAR(position(d, 0).velocity[0], -0.1*2.0/4.0, 1e-6, "a load from a table");
    TAP_NEAR(position(d, 0).shift[0], 0.03, 1e-15, "beside a translation");
    WORLD_TRY(dem_wall_set_load(d, "lid", (const double[3]){0.0, 0.0, 1.0}));
    world_run(d, 0.01);
    TAP_NEAR(position(d, 0).velocity[0], -0.25, 1e-9, "a load set by the program");
    restarts_loaded(d, path);
    TAP_OK(dem_wall_set_load(d, "lip", (const double[3]){0.0, 0.0, 1.0}) == DEM_ERROR_INPUT,
           "refused: %s", dem_error_text());
    dem_free(d);
    unlink(path);
}

/* ---- rest ------------------------------------------------------------------------------------ */

/* A sphere rests on the floor, while a flap beside it swings through a damper. Returns 1 when the test of
   rest has been passed within two seconds. */
static int comes_to_rest(double damping)
{
    const double m = world_sphere_mass(R, density), k = 4.0/3.0*1e5/(2.0*0.91)*sqrt(R);
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass",
                                    .position = {0.0, 0.0, R - pow(m*9.81/k, 2.0/3.0)}};
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density 2500; youngsModulus 1e5; poissonsRatio 0.3; } } "
        "effects { hertz {} dry { restitution 0.3; } gravity { acceleration (0 0 -9.81); } } "
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } flap { type triangles; "
        "corners ((0.1 -0.01 0.1) (0.12 -0.01 0.09) (0.1 0.01 0.1)); motion { type hinge; origin (0.1 0 0.1); "
        "axis (0 1 0); inertia 1e-7; mass 1e-4; centre (0.12 0 0.09); damping %g; } } } "
        "time { step 2e-5; untilQuiet { lasting 0.05; } }", damping));
    struct dem_quiet quiet;

    WORLD_TRY(dem_case_read_quiet(c, &quiet));
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *const d = world_start(c);

    for (int n = 0; n < 200 && !quiet.reached; n++)
    {
        const struct dem_totals t = world_tally(d);

        WORLD_TRY(dem_quiet_test(d, &quiet, &t));
        world_run(d, 0.01);
    }
    dem_free(d);
    return quiet.reached;
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void refuse(const char *lid, const char *words)
{
    world_refused(pressed("", lid), words);
}

/* The run ends with a sentence with these words. */
static void ends(const char *lid, const char *words)
{
    struct dem *const d = world(pressed("", lid), 0, NULL);
    const int status = dem_advance(d, 0.5);

    TAP_OK(status != DEM_OK && strstr(dem_error_text(), words), "ends: %s", status ? dem_error_text() : lid);
    dem_free(d);
}

static void refusals(void)
{
    static const char walls[] =
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} } "
        "walls { w { %s } } time { step 4e-6; }";

    refuse("type free;", "mass");
    refuse("type free; mass 0;", "give a number above 0");
    refuse("type free; mass 1; axes (x x);", "axes has x twice");
    refuse("type servo; maxSpeed 1; axis (0 0 -1); force 1; pressure 1; area 1;", "one of the two");
    refuse("type servo; maxSpeed 1; force 1;", "axis");
    refuse("type servo; maxSpeed 1; axis (0 0 -1); force -1;", "give a number above 0");
    refuse("type servo; maxSpeed 1; axis (0 0 -1); pressure 0; area 1;", "give a number above 0");
    /* 2 kg at 3 m from the axis along z */
    refuse("type hinge; origin (0 0 0); axis (0 0 1); inertia 17; mass 2; centre (0 3 5);", "at least 18 kg m2");
    refuse("type hinge; origin (0 0 0); axis (0 1 0); inertia 1; stops (0.1 0.2);", "stops are two angles");
    world_refused(world_text(walls, "type plane; point (0 0 0); normal (0 0 1); motion { type free; mass 1; "
                                    "axes (x); }"), "wall w is a plane: free along its normal only");
    world_refused(world_text(walls, "type box; min (0 0 0); max (1 1 1); motion { type free; mass 1; }"),
                  "a box is six walls");
    world_refused(world_text(walls, "type box; min (0 0 0); max (1 1 1); faces { topZ { } }"), "maxZ");
    world_refused(world_text(walls, "type sphere; centre (0 0 0); radius 1; particles inside; motion { type free; "
                                    "mass 1; }"), "wall w is round");
    world_refused(world_text(walls, "type plane; point (0 0 0); normal (0 0 1); motion ( { type free; mass 1; } "
                                    "{ type translation; velocity (1 0 0); } );"), "is the last one of a wall");
    ends("type free; axis (0 0 1); mass 1e-7; force (0 0 -0.01);", "kg, or type servo");
    ends("type servo; axis (0 0 1); force 1; maxSpeed 1;", "wall lid has met nothing over");
    ends("type servo; axis (0 0 -1); force 0.01; maxSpeed 1; damping 1e-6;", "so that it swings");
}

int main(void)
{
    hertz_column("type servo; force 1e-3; maxSpeed 0.01;", "servo");
    hertz_column("type free; mass 2e-6; damping 5e-3; force (0 0 -1e-3);", "free lid");
    plate();
    servo_on_chain();
    servo_on_ball();
    servo_on_loose_layer();
    hinge();
    ball_on_flap();
    energy();
    TAP_NEAR(thrown(2e-6)/thrown(1e-6), 4.0, 0.2, "the error of the balance falls with the square of the step");
    restart("type servo; axis (0 0 -1); pressure 1e3; area 64e-6; maxSpeed 0.5;", "servo");
    restart("type free; axes (z); mass 1e-3; force (0 0 -0.05);", "free lid");
    restart("type hinge; origin (0 0 11e-3); axis (0 1 0); inertia 1e-7; torque 2e-4;", "hinge");
    begins_at_rest("type free; axes (z); mass 1e-3; force (0 0 -0.05);",
                   "type servo; axis (0 0 -1); force 0.05; maxSpeed 0.5;", "a new servo");
    begins_at_rest("type servo; axis (0 0 -1); force 0.05; maxSpeed 0.5;",
                   "type free; axes (z); mass 1e-3; force (0 0 -0.05);", "a new free lid");
    keeps_state("( { type translation; velocity (0.01 0 0); } { type servo; axis (0 0 -1); force 0.05; maxSpeed 0.5; } )",
                "( { type translation; velocity (0.02 0 0); } { type servo; axis (0 0 -1); force 0.05; maxSpeed 0.5; } )",
                "a faster translation");
    other_rows("{ type servo; axis (0 0 -1); force 0.05; maxSpeed 0.5; }");
    other_rows("");
    absent_from();
    absent_until();
    servo_on_clump();
    loads();
    TAP_OK(!comes_to_rest(0.0), "untilQuiet waits for a flap that swings");
    TAP_OK(comes_to_rest(3e-6), "and ends when it hangs still");
    refusals();
    TAP_DONE;
}
