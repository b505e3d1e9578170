/*
 * test_following_walls.c -- walls of triangles that follow a moving mesh (dem_wall_move) carry and
 * drag a sphere, continue with the same bits, and refuse wrong meshes.
 *
 * Sources: statics and kinematics of rigid bodies; Earnshaw 1844 for the turntable
 * (test_moving_walls.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

static const double R = 1e-3, density = 2500.0, g = 9.81, E = 1e7, window = 2e-4;

struct floor
{
    struct mesh new, now;
    void (*place)(double time, const double new[3], double now[3]);
};

static void place(struct floor *f, double time)
{
    for (size_t k = 0; k < 3*f->new.n; k++)
    {
        f->place(time, f->new.corner + 3*k, f->now.corner + 3*k);
    }
}

static struct floor make_floor(double half, double size,
                               void (*how)(double, const double *, double *))
{
    struct floor f = {.new = mesh_floor(-half, half, size), .place = how};

    f.now.n = f.new.n;
    f.now.corner = malloc(9*f.new.n*sizeof *f.now.corner);
    return f;
}

static void free_floor(struct floor *f)
{
    free(f->new.corner);
    free(f->now.corner);
}

static double rest_height(void)
{
    return R - pow(0.75*world_sphere_mass(R, density)*g*(1.0 - 0.09)/(E*sqrt(R)), 2.0/3.0);
}

/* started at `time`, when the floor may have moved already; from a snapshot or with a sphere */
static struct dem *begin(struct floor *f, const char *more, const struct dem_new_particle *seed,
                         double time, const char *snapshot)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } "
        "rigid { density 1;"
        " youngsModulus 1e30; } } effects { hertz {} dry { restitution 0.3; } "
        "mindlin { friction 0.2; }"
        " gravity { acceleration (0 0 -9.81); } } time { step 4e-6; } %s",
        more));

    WORLD_TRY(dem_case_add_wall(c, "floor", "rigid", (int64_t)f->new.n, f->new.corner));
    if (time > 0.0)
    {
        place(f, time);
        WORLD_TRY(dem_case_move_wall(c, "floor", (int64_t)f->now.n, f->now.corner));
    }
    if (snapshot)
    {
        WORLD_TRY(dem_case_load(c, snapshot));
    }
    else
    {
        WORLD_TRY(dem_case_add_particles(c, 1, seed));
    }
    return world_start(c);
}

static void run(struct dem *d, struct floor *f, double duration)
{
    const double start = world_tally(d).time;
    const int n = (int)(duration/window + 0.5);

    for (int k = 1; k <= n; k++)
    {
        place(f, start + k*window);
        WORLD_TRY(dem_wall_move(d, "floor", (int64_t)f->now.n, f->now.corner));
        world_run(d, window);
    }
}

/* ---- motions of a floor ---------------------------------------------------------------------- */

static void rises(double t, const double new[3], double now[3])
{
    memcpy(now, new, 3*sizeof *now);
    now[2] += 0.05*t;
}

static void turns(double t, const double new[3], double now[3])
{
    const double s = sin(8.0*t), c = cos(8.0*t);

    now[0] = c*new[0] - s*new[1];
    now[1] = s*new[0] + c*new[1];
    now[2] = new[2];
}

/* a plateau: the part within 6 mm of x = 0 rises, the part beyond 12 mm stays */
static void bulges(double t, const double new[3], double now[3])
{
    const double far = fabs(new[0]), share = far < 6e-3 ? 1.0
                                             : far > 12e-3 ? 0.0
                                                           : (12e-3 - far)/6e-3;

    memcpy(now, new, 3*sizeof *now);
    now[2] += 0.05*t*share;
}

/* ---- a sphere on it -------------------------------------------------------------------------- */

static void ride(void (*how)(double, const double *, double *), double x, double y,
                 const char *what)
{
    const struct dem_new_particle seed = {
        .position = {x, y, rest_height()}, .diameter = 2.0*R, .material = "glass"};
    struct floor f = make_floor(0.018, 3e-3, how);
    struct dem *const d = begin(&f, "", &seed, 0.0, NULL);
    double force[3];

    run(d, &f, 0.04);
    const struct world_particle p = world_at(d, 0);
    const double m = world_sphere_mass(R, density);

    world_wall(d, "floor", force);
    /* the impact at the start has decayed: bounces at 0.05 m/s with restitution 0.3 last 5 ms */
    TAP_NEAR(p.v[2], 0.05, 1e-6*0.05, "%s: it has the floor's velocity", what);
    TAP_NEAR(p.x[2], 0.002 + rest_height(), 1e-10, "%s: and its position", what);
    TAP_NEAR(force[2], -m*g, 1e-6*m*g, "%s: and presses with its weight", what);
    TAP_OK(world_tally(d).contacts == 1, "%s: in one contact", what);
    dem_free(d);
    free_floor(&f);
}

static void turntable(void)
{
    static const double omega = 8.0, far = 0.01;
    const struct dem_new_particle seed = {
        .position = {far, 0.0, rest_height()}, .velocity = {0.0, omega*far, 0.0},
        .spin = {0.0, 0.0, omega}, .diameter = 2.0*R, .material = "glass"};
    struct floor f = make_floor(0.08, 2e-2, turns);
    struct dem *const d = begin(&f, "", &seed, 0.0, NULL);

    run(d, &f, 2.0*world_pi/omega);
    const struct world_particle p = world_at(d, 0);
    const double arm = rest_height()/R, slower = 0.4/(0.4 + arm*arm),
                 angle = slower*omega*world_tally(d).time;
    const double centre = far*(1.0 - 1.0/slower);

    /* chord for circle: (omega window)^2/8 = 3e-7; the rest as in test_moving_walls */
    TAP_NEAR(p.x[0], centre + (far - centre)*cos(angle), 5e-4*far,
             "on a turntable: on its circle after a turn, x");
    TAP_NEAR(p.x[1], (far - centre)*sin(angle), 5e-4*far,
             "on a turntable: on its circle after a turn, y");
    TAP_NEAR(p.w[2], omega, 1e-6*omega,
             "on a turntable: the spin about the normal does not change");
    dem_free(d);
    free_floor(&f);
}

/* ---- restart, skins, refusals ---------------------------------------------------------------- */

/* all motions together: up, along and a growing plateau, from one of its edges to the other */
static void wanders(double t, const double new[3], double now[3])
{
    bulges(t, new, now);
    now[0] += 0.05*t + 1e-3*sin(30.0*t + 200.0*new[1]);
    now[2] += 2e-4*sin(20.0*t)*sin(300.0*new[0])*sin(250.0*new[1]);
}

static uint64_t wander(const char *more, double stop)
{
    const struct dem_new_particle seed = {
        .position = {3e-3, 1e-3, rest_height()}, .velocity = {0.02, 0.05, 0.0}, .diameter = 2.0*R,
        .material = "glass"};
    const char *const file = "/tmp/test_following_walls.dem";
    struct floor f = make_floor(0.018, 3e-3, wanders);
    struct dem *d = begin(&f, more, &seed, 0.0, NULL);

    run(d, &f, 0.04);
    if (stop > 0.0)
    {
        WORLD_TRY(dem_save(d, file));
        dem_free(d);
        d = begin(&f, more, NULL, 0.04, file);
    }
    else
    {
        /* writing rebuilds the lists, as reading does */
        WORLD_TRY(dem_save(d, file));
    }
    run(d, &f, 0.04);
    const uint64_t hash = world_hash(d);

    TAP_OK(stop > 0.0 || world_at(d, 0).x[2] > 2e-3, "wandering floor: it was lifted");
    dem_free(d);
    free_floor(&f);
    remove(file);
    return hash;
}

static void refusals(void)
{
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, 2.0*R}, .diameter = 2.0*R, .material = "glass"};
    struct floor f = make_floor(0.02, 5e-3, rises);
    struct dem *const d = begin(&f, "", &seed, 0.0, NULL);

    place(&f, 0.01);
    TAP_OK(dem_wall_move(d, "floor", (int64_t)f.now.n - 1, f.now.corner) &&
               strstr(dem_error_text(), "its faces must stay the same"),
           "another number of triangles is refused: %s", dem_error_text());
    TAP_OK(dem_wall_move(d, "flor", (int64_t)f.now.n, f.now.corner) &&
               strstr(dem_error_text(), "no wall flor"),
           "an unknown wall is refused");
    f.now.corner[7] = NAN;
    TAP_OK(dem_wall_move(d, "floor", (int64_t)f.now.n, f.now.corner) &&
               strstr(dem_error_text(), "not a number"),
           "a corner that is not a number is refused: %s", dem_error_text());
    place(&f, 1.0);
    WORLD_TRY(dem_wall_move(d, "floor", (int64_t)f.now.n, f.now.corner));
    TAP_OK(dem_advance(d, 4e-6) && strstr(dem_error_text(), "a wall moves by"),
           "a wall too fast for the step is refused: %s", dem_error_text());
    dem_free(d);
    free_floor(&f);
}

int main(void)
{
    TAP_TRAPS;
    ride(rises, 0.0, 0.0, "on a floor that rises");
    ride(rises, 1.7e-3, -3.1e-3, "at another point of it");
    ride(bulges, 0.5e-3, 1e-3, "on a part that rises");
    turntable();
    const uint64_t straight = wander("", 0.0);

    TAP_OK(wander("", 0.04) == straight, "a restart has the bits of an uninterrupted run");
    TAP_OK(wander("neighbours { outerSkin 0.1; innerSkin 0.01; }", 0.0) == straight,
           "the skins do not change the bits");
    refusals();
    TAP_DONE;
}
