/*
 * test_wall_rotation.c -- free walls that rotate about their centre of mass: Euler's top, mass and inertia of solids,
 * the impact of a sphere, damping, one axis, restart, limits.
 *
 * Euler's top: I (1 2 3), spin (1/2 0 1) has the period 4 K(1/12) = 6.420600 (test_clumps.c).
 * A block a x b x c of mass m has the inertia m/12 (b^2 + c^2) about its first axis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include "physics/world.h"
#include "dem_numbers.h"
#include <unistd.h>

static const char glass[] = "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } ";

/* 12 triangles of a block with these edges [m], corners counterclockwise from outside, turned by R about its
   centre. */
static char *block(const double edge[3], const double R[3][3], const double centre[3])
{
    char *text = world_text("%s", "");

    for (int face = 0; face < 6; face++)
    {
        const int a = face%3, b = (a + 1)%3, c = (a + 2)%3, up = face/3;
        static const int order[2][6] = {{0, 2, 1, 1, 2, 3}, {0, 1, 2, 1, 3, 2}};

        for (int k = 0; k < 6; k++)
        {
            const int at = order[up][k];
            double x[3], y[3];

            x[a] = (up - 0.5)*edge[a];
            x[b] = ((at & 1) - 0.5)*edge[b];
            x[c] = ((at >> 1) - 0.5)*edge[c];
            for (int i = 0; i < 3; i++)
            {
                y[i] = centre[i] + R[i][0]*x[0] + R[i][1]*x[1] + R[i][2]*x[2];
            }
            text = world_text("%s (%.17g %.17g %.17g)", text, y[0], y[1], y[2]);
        }
    }
    return text;
}

static struct dem_wall_position position(const struct dem *d)
{
    struct dem_wall_position p;

    dem_wall_position(d, 0, &p);
    return p;
}

static double length(const double v[3])
{
    return sqrt(v[0]*v[0] + v[1]*v[1] + v[2]*v[2]);
}

/* ---- Euler's top ----------------------------------------------------------------------------- */

/* Relative error of the period, from two zeros of the spin about the middle axis of the body. */
static double top(int steps)
{
    static const double T = 6.420600;
    const double dt = T/steps;
    struct dem *const d = world(
        world_text("%s effects { hertz {} } walls { top { type triangles; corners ((0 0 0) (1 0 0) (0 1 0)); motion { "
                   "type free; mass 1; rotations (x y z); inertia (1 2 3); centre (0.2 0.3 0.1); spin (0.5 0 1); } } } "
                   "time { step %.17g; }", glass, dt), 0, NULL);
    double before = 0.0, zero[3];
    int zeros = 0;

    for (int n = 1; zeros < 3; n++)
    {
        world_step(d);
        const struct dem_wall_position p = position(d);
        const double now = p.rotation[0][1]*p.spin[0] + p.rotation[1][1]*p.spin[1] + p.rotation[2][1]*p.spin[2];

        if (n > 1 && (now > 0.0) != (before > 0.0))
        {
            zero[zeros++] = dt*(n - now/(now - before));
        }
        before = now;
    }
    const struct dem_wall_position p = position(d);
    const double c[3] = {0.2, 0.3, 0.1};
    double moved = 0.0;

    for (int k = 0; k < 3; k++)
    {
        moved = fmax(moved, fabs(p.rotation[k][0]*c[0] + p.rotation[k][1]*c[1] + p.rotation[k][2]*c[2] + p.shift[k] - c[k]));
    }
    TAP_NEAR(moved, 0.0, 1e-15, "Euler's top in %d steps a period: its centre rests", steps);
    dem_free(d);
    return fabs((zero[2] - zero[0])/T - 1.0);
}

/* ---- inertia of a solid ---------------------------------------------------------------------- */

static const double edge[3] = {3e-3, 4e-3, 6e-3}, density = 1000.0, centre[3] = {0.01, -0.02, 0.03};
static const double turned[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}};

/* After one step from rest under a force and a torque the wall has F t/m and I^-1 T t. */
static void solid(void)
{
    static const double F = 2e-3, T[3] = {1e-7, 2e-7, -3e-7}, dt = 1e-5;
    const double m = density*edge[0]*edge[1]*edge[2];
    struct dem *const d = world(
        world_text("%s effects { hertz {} } walls { w { type triangles; corners (%s); motion { type free; rotations "
                   "(x y z); density %g; force (0 0 %g); torque (%g %g %g); } } } time { step %g; }", glass,
                   block(edge, turned, centre), density, F, T[0], T[1], T[2], dt), 0, NULL);

    world_step(d);
    const struct dem_wall_position p = position(d);

    TAP_NEAR(p.velocity[2]/(F*dt/m), 1.0, 1e-12, "a block: its mass from the density");
    for (int k = 0; k < 3; k++)
    {
        double w = 0.0;

        for (int a = 0; a < 3; a++)
        {
            const double I = m/12.0*(edge[(a + 1)%3]*edge[(a + 1)%3] + edge[(a + 2)%3]*edge[(a + 2)%3]);
            const double along = turned[0][a]*T[0] + turned[1][a]*T[1] + turned[2][a]*T[2];

            w += turned[k][a]*along/I*dt;
        }
        TAP_NEAR(p.spin[k]/w, 1.0, 1e-6, "its inertia, spin about %c", "xyz"[k]);
    }
    dem_free(d);
}

/* ---- impact ---------------------------------------------------------------------------------- */

static const double still[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, origin[3] = {0.0, 0.0, 0.0};

static struct dem *hit(const char *laws, const char *entries, double step)
{
    static const struct dem_new_particle seed = {.diameter = 2e-3, .material = "glass", .spin = {30.0, 20.0, 10.0},
                                                 .velocity = {0.01, -0.02, -0.2},
                                                 .position = {0.9e-3, 1.3e-3, 4.2e-3}};

    return energy_world(
        world_text("%s effects { hertz {} %s } walls { w { type triangles; corners (%s); motion { type free; rotations "
                   "(x y z); density %g; %s } } } time { step %g; }", glass, laws, block(edge, still, origin), density,
                   entries, step), 1, &seed);
}

/* Momentum and angular momentum about the origin of sphere and wall, `of` 0 .. 5. */
static void momenta(struct dem *d, double of[6])
{
    const struct world_particle q = world_at(d, 0);
    const struct dem_wall_position p = position(d);
    const double m = density*edge[0]*edge[1]*edge[2], M = q.mass, r = 1e-3;

    for (int k = 0; k < 3; k++)
    {
        const int a = (k + 1)%3, b = (k + 2)%3;
        double L = 0.0;

        for (int c = 0; c < 3; c++)
        {
            const double I = m/12.0*(edge[(c + 1)%3]*edge[(c + 1)%3] + edge[(c + 2)%3]*edge[(c + 2)%3]);

            L += p.rotation[k][c]*I*(p.rotation[0][c]*p.spin[0] + p.rotation[1][c]*p.spin[1] + p.rotation[2][c]*p.spin[2]);
        }
        of[k] = M*q.v[k] + m*p.velocity[k];
        of[3 + k] = M*(q.x[a]*q.v[b] - q.x[b]*q.v[a]) + 0.4*M*r*r*q.w[k]
                  + m*(p.moved[a]*p.velocity[b] - p.moved[b]*p.velocity[a]) + L;
    }
}

static double impact(const char *laws, double step, double *kept)
{
    struct dem *const d = hit(laws, "", step);
    double before[6], after[6], error[2] = {0.0, 0.0};

    momenta(d, before);
    world_run(d, 4e-3);
    momenta(d, after);
    for (int k = 0; k < 6; k++)
    {
        error[k/3] = fmax(error[k/3], fabs(after[k] - before[k]));
    }
    const double m = world_sphere_mass(1e-3, 2500.0), kinetic = energy_term(d, "kinetic_walls");

    TAP_OK(kinetic > 0.05*0.5*m*0.04 && length(position(d).spin) > 10.0, "a sphere hits a block, which spins: %.3g 1/s",
           length(position(d).spin));
    TAP_NEAR(error[0]/(m*0.2), 0.0, 1e-13, "momentum");
    *kept = error[1]/(m*0.2*1.3e-3);
    const double residual = energy_term(d, "residual")/(0.5*m*0.04);

    dem_free(d);
    return residual;
}

static void impacts(void)
{
    double kept;
    const double residual = impact("", 1e-6, &kept);

    TAP_NEAR(kept, 0.0, 1e-12, "angular momentum, frictionless");
    TAP_NEAR(residual, 0.0, 2e-5, "energy balance, elastic");
    TAP_NEAR(impact("mindlin { friction 0.4; } dry { restitution 0.6; }", 1e-6, &kept), 0.0, 2e-3,
             "energy balance with friction and damping");
    TAP_NEAR(kept, 0.0, 1e-12, "angular momentum with them");
}

/* ---- damping, one axis ----------------------------------------------------------------------- */

/* The kicks are backward in c: two halves at the ends of an advance. */
static void damped(void)
{
    static const double I = 2e-7, c = 1e-5, dt = 1e-4;
    struct dem *const d = energy_world(
        world_text("%s effects { hertz {} } walls { w { type triangles; corners ((0 0 0) (1e-2 0 0) (0 1e-2 0)); motion { "
                   "type free; mass 1e-3; axes (x); rotations (y); inertia (1e-7 %g 3e-7); centre (0 0 0); spin (0 5 0); "
                   "velocity (0.1 0 0); angularDamping %g; } } } time { step %g; }", glass, I, c, dt), 0, NULL);

    world_step(d);
    world_step(d);
    const double left = 5.0/pow(1.0 + 0.5*c*dt/I, 4.0);
    const struct dem_wall_position p = position(d);

    TAP_NEAR(p.spin[1]/left, 1.0, 1e-12, "one axis: damped spin about it");
    TAP_NEAR(p.spin[0] + p.spin[2], 0.0, 0.0, "none about the others");
    TAP_NEAR(p.shift[0]/(0.1*2.0*dt), 1.0, 1e-12, "and a velocity along the free axis");
    TAP_NEAR(p.rotation[1][1], 1.0, 1e-15, "the axis stays");
    TAP_NEAR((energy_term(d, "lost_walls") + energy_term(d, "kinetic_walls"))/(0.5*I*25.0 + 0.5*1e-3*0.01), 1.0, 1e-12,
             "the energy lost in the damper");
    dem_free(d);
}

/* ---- restart --------------------------------------------------------------------------------- */

static void restart(void)
{
    static const char laws[] = "mindlin { friction 0.4; } dry { restitution 0.6; } gravity { acceleration (0 0 -1); }";
    struct dem *d = hit(laws, "spin (3 2 1);", 1e-6);
    char path[] = "/tmp/turn.XXXXXX";
    double time;

    world_make_file(path);
    world_run(d, 1.03e-3);
    TAP_OK(position(d).spin[0] != 3.0, "in the midst of the impact");
    WORLD_TRY(dem_save(d, path));
    WORLD_TRY(dem_backup_every(d, 0));
    world_run(d, 2e-3);
    const struct dem_wall_position whole = position(d);

    WORLD_TRY(dem_restore(d, &time));
    world_run(d, 2e-3);
    struct dem_wall_position again = position(d);

    TAP_OK(memcmp(&again, &whole, sizeof whole) == 0, "the same bits from a backup");
    dem_free(d);
    struct dem_case *const c = world_begin(
        world_text("%s effects { hertz {} %s } walls { w { type triangles; corners (%s); motion { type free; rotations "
                   "(x y z); density %g; } } } time { step 1e-6; }", glass, laws, block(edge, still, origin), density));

    WORLD_TRY(dem_case_load(c, path));
    d = world_start(c);
    world_run(d, 2e-3);
    again = position(d);
    TAP_OK(memcmp(&again, &whole, sizeof whole) == 0, "and from a snapshot, whatever the spin of the scene");
    dem_free(d);
    unlink(path);
}

static char *moved_by(const char *motion)
{
    return world_text("%s effects { hertz {} } walls { w { type triangles; corners (%s); motion { %s } } } time { step "
                      "1e-3; }", glass, block(edge, still, origin), motion);
}

/* A wall that a motion has turned by a quarter: free from the snapshot on, it begins at rest. */
static void edited(void)
{
    struct dem *d = energy_world(moved_by("type rotation; origin (0 0 0); axis (0 0 1); omega 1.5707963267948966;"), 0, NULL);
    char path[] = "/tmp/turn.XXXXXX";

    world_make_file(path);
    world_run(d, 1.0);
    WORLD_TRY(dem_save(d, path));
    dem_free(d);
    struct dem_case *const c = world_begin(
        moved_by("type free; rotations (x y z); density 1000; velocity (1 0 0); spin (1 2 3); torque (1e-9 0 0);"));

    WORLD_TRY(dem_case_load(c, path));
    d = world_start(c);
    TAP_NEAR(length(position(d).spin) + position(d).velocity[0], 0.0, 0.0, "made free in an edited scene, it begins at rest");
    world_run(d, 1e-3);
    world_run(d, 1e-3);
    const struct dem_wall_position p = position(d);
    const double m = density*edge[0]*edge[1]*edge[2], I = m/12.0*(edge[0]*edge[0] + edge[2]*edge[2]);

    TAP_NEAR(p.spin[0]*I/1e-9/1.5e-3, 1.0, 1e-6, "and turns with the inertia of how it stands");
    dem_free(d);
    d = world(world_text("%s effects { hertz {} } time { step 1e-3; }", glass), 0, NULL);
    world_run(d, 1e-3);
    WORLD_TRY(dem_save(d, path));
    dem_free(d);
    struct dem_case *const next = world_begin(moved_by("type free; rotations (z); density 1000; spin (0 0 3);"));

    WORLD_TRY(dem_case_load(next, path));
    d = world_start(next);
    world_run(d, 1e-3);
    TAP_NEAR(position(d).spin[2], 3.0, 1e-12, "a new wall of the edited scene has its spin");
    dem_free(d);
    unlink(path);
}

/* 0.2 rad in a step, with a tip 50 radii away */
static void too_fast(void)
{
    static const struct dem_new_particle far = {.diameter = 2e-3, .material = "glass", .position = {1.0, 1.0, 1.0}};
    struct dem *const d = world(
        world_text("%s effects { hertz {} } walls { w { type triangles; corners ((0 0 0) (0.05 0 0) (0 0.001 0)); motion { "
                   "type free; mass 1; rotations (z); inertia (1 1 1); centre (0 0 0); spin (0 0 2e5); } } } time { step "
                   "1e-6; }", glass), 1, &far);

    TAP_OK(dem_advance(d, 1e-6) == DEM_ERROR_NUMBER && strstr(dem_error_text(), "a wall moves by"), "too fast at its tip: %s",
           dem_error_text());
    dem_free(d);
}

static void weight_in_fluid(const char *motion, int refused)
{
    struct dem *const d = world(
        world_text("%s effects { hertz {} stokesDrag {} } fluid { velocity (0 0 0); viscosity 1e-3; density 1000; } walls { w { type "
                   "triangles; corners ((0 0 0) (1 0 0) (0 1 0)); motion { %s } } } time { step 1e-6; }", glass, motion),
        0, NULL);
    const int status = dem_advance(d, 1e-6);

    TAP_OK(refused ? status == DEM_ERROR_INPUT && strstr(dem_error_text(), "weight no") : status == DEM_OK, "in a fluid: %s",
           motion);
    dem_free(d);
}

/* ---- refusals -------------------------------------------------------------------------------- */

static const char *leaning_torque(void)
{
    static char path[] = "/tmp/torque.XXXXXX";

    world_make_file(path);
    FILE *const f = fopen(path, "w");

    if (!f || fputs("time, x, z\n0, 1, 0\n1, 3, 0.2\n", f) < 0 || fclose(f))
    {
        printf("Bail out! cannot write %s\n", path);
        exit(1);
    }
    return path;
}

static void refuses(const char *entries, const char *words)
{
    world_refused(world_text("%s effects { hertz {} } walls { w { type triangles; corners ((0 0 0) (1 0 0) (0 1 0)); "
                             "motion { type free; %s } } }", glass, entries), words);
}

int main(void)
{
    const double coarse = top(200), fine = top(400);

    TAP_OK(coarse < 1e-4, "its period is 6.420600 to %.2g in 200 steps", coarse);
    TAP_NEAR(coarse/fine, 4.0, 0.2, "of second order in the step");
    solid();
    impacts();
    damped();
    restart();
    edited();
    too_fast();
    weight_in_fluid("type free; mass 1;", 1);
    weight_in_fluid("type free; mass 1; weight yes;", 0);
    weight_in_fluid("type hinge; origin (0 0 0); axis (1 0 0); inertia 1; mass 1; centre (0 0 0);", 1);
    weight_in_fluid("type hinge; origin (0 0 0); axis (1 0 0); inertia 1; mass 1; centre (0 0 0); weight no;", 0);
    refuses("mass 1; rotations (x y); inertia (1 1 1); centre (0 0 0);", "walls/w/motion: rotations about two axes");
    refuses("mass 1; rotations (x y z); inertia (1 1 3); centre (0 0 0);", "at most the sum of the others");
    refuses("mass 1; rotations (x y z); inertia (1 1); centre (0 0 0);", "give three (xx yy zz)");
    refuses("density 1000; rotations (x y z);", "surface must be closed");
    refuses("mass 1; rotations (z); inertia (1 1 3); centre (0 0 0);", "at most the sum of the others");
    refuses("density 1000; mass 1; rotations (x y z);", "walls/w/motion: both density and mass");
    refuses("mass -1;", "walls/w/motion: mass -1 kg; give a number above 0");
    refuses("mass 1; rotations (z); inertia (1 1 1); centre (0 0 0); spin (5 0 2);",
            "spin (5 0 2) 1/s, but wall w rotates freely about z only; give spin (0 0 2), or more rotations");
    refuses("mass 1; axes (y z); velocity (1 3 0);",
            "velocity (1 3 0) m/s, but wall w moves freely along y z only; give velocity (0 3 0), or more axes");
    refuses("mass 1; axis (3 0 4); velocity (4 0 -3);", "moves freely along (0.6 0 0.8) only");
    refuses("mass 1; axes (z); force (0 2 -5);",
            "force (0 2 -5) N, but wall w moves freely along z only; give force (0 0 -5), or more axes");
    refuses(world_text("mass 1; rotations (x); inertia (1 1 1); centre (0 0 0); torque { file \"%s\"; }", leaning_torque()),
            "torque (3 0 0.2) N m at time 1 s of the table, but wall w rotates freely about x only");
    refuses("mass 1; velocity (1 0 0); start 1;", "moves later");
    world_refused(world_text("%s effects { hertz {} } walls { w { type plane; point (0 0 0); normal (0 0 1); motion { type "
                             "free; mass 1; rotations (z); inertia (1 1 1); centre (0 0 0); } } }", glass),
                  "no centre about which");
    world_refused(world_text("%s effects { hertz {} } domain { x (0 1); periodic (x); } walls { w { type triangles; corners "
                             "((0.1 0 0) (0.2 0 0) (0.1 0.1 0)); motion { type free; mass 1; rotations (z); inertia "
                             "(1 1 1); centre (0 0 0); } } } time { step 1e-4; }", glass), "has rotations (z) and may come to any place of domain, "
                  "which is periodic along x; remove x from domain/periodic, or give rotations (x)");
    world_refused(world_text("%s effects { hertz {} } domain { x (0 1); y (0 1); periodic (x y); } walls { w { type "
                             "triangles; corners ((0.1 0 0) (0.2 0 0) (0.1 0.1 0)); motion { type free; mass 1; rotations "
                             "(x y z); inertia (1 1 1); centre (0 0 0); } } } time { step 1e-4; }", glass),
                  "periodic along x, y; remove x, y from domain/periodic, or leave rotations out");
    TAP_DONE;
}
