/*
 * test_orientation.c -- orientations are exact after thousands of turns, and continue from a
 * snapshot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"

static const char free_scene[] =
    "materials { glass { density 2500; youngsModulus 1e6; } } "
    "effects { gravity { acceleration (0 0 0); } hertz {} }"
    "time { step 1e-5; }";

static const char rolling_scene[] =
    "materials { glass { density 2500; youngsModulus 1e7; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } "
    "mindlin { friction 0.5; } }"
    "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }";

static struct dem *tracked(const char *scene, const struct dem_new_particle *seed)
{
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_enable_orientation(c));
    WORLD_TRY(dem_case_add_particles(c, 1, seed));
    return world_start(c);
}

static const double *orientation(const struct dem *d)
{
    struct dem_view v;

    dem_view(d, &v);
    return v.orientation;
}

/* largest difference from the rotation by `angle` about n; q and -q are the same rotation */
static double rotation_error(const double q[4], double angle, const double n[3])
{
    const double want[4] = {cos(0.5*angle), n[0]*sin(0.5*angle), n[1]*sin(0.5*angle),
                            n[2]*sin(0.5*angle)};
    double plus = 0.0, minus = 0.0;

    for (int k = 0; k < 4; k++)
    {
        plus = fmax(plus, fabs(q[k] - want[k]));
        minus = fmax(minus, fabs(q[k] + want[k]));
    }
    return fmin(plus, minus);
}

static double length(const double q[4])
{
    return sqrt(q[0]*q[0] + q[1]*q[1] + q[2]*q[2] + q[3]*q[3]);
}

int main(void)
{
    const double n[3] = {2.0/7.0, -3.0/7.0, 6.0/7.0}, w = 20000.0, T = 1.0;
    struct dem_new_particle seed = {
        .position = {0.0, 0.0, 1.0}, .diameter = 1e-3, .id = -1, .material = "glass",
        .spin = {w*n[0], w*n[1], w*n[2]}};

    TAP_TRAPS;

    /* 0.2 rad a step, 100 000 steps, 3183 turns */
    struct dem *d = tracked(free_scene, &seed);

    TAP_NEAR(rotation_error(orientation(d), 0.0, n), 0.0, 0.0, "identity at the start");
    world_run(d, T);
    TAP_NEAR(rotation_error(orientation(d), fmod(w*T, 4.0*world_pi), n), 0.0, 1e-9,
             "3183 turns about an inclined axis");    /* 4e-16 and rounding a step */
    TAP_NEAR(length(orientation(d)), 1.0, 4e-16,
             "still a unit quaternion");                     /* one division's rounding */

    /* the same in two halves, through a file */
    const char *const file = "orientation.dem";
    struct dem *first = tracked(free_scene, &seed);
    struct dem_case *const c = world_begin(free_scene);

    world_run(first, 0.5*T);
    WORLD_TRY(dem_save(first, file));
    WORLD_TRY(dem_case_enable_orientation(c));
    WORLD_TRY(dem_case_load(c, file));
    struct dem *const second = world_start(c);
    remove(file);
    TAP_OK(memcmp(orientation(first), orientation(second), 4*sizeof(double)) == 0,
           "a snapshot keeps it");
    world_run(first, 0.5*T);
    world_run(second, 0.5*T);
    TAP_OK(memcmp(orientation(first), orientation(second), 4*sizeof(double)) == 0,
           "the run continues with the same bits");
    dem_free(first);
    dem_free(second);
    dem_free(d);

    /* rolling at 0.1 m/s along x: about y, by displacement over height, as the lever arm is R less
       the overlap, 1.7e-3 R at rest */
    const double R = 0.005, v = 0.1;
    const double y[3] = {0.0, 1.0, 0.0};

    seed = (struct dem_new_particle){
        .position = {0.0, 0.0, R}, .velocity = {v, 0.0, 0.0}, .spin = {0.0, v/R, 0.0},
        .diameter = 2.0*R, .id = -1, .material = "glass"};
    d = tracked(rolling_scene, &seed);
    world_run(d, 0.3);
    TAP_NEAR(rotation_error(orientation(d), world_at(d, 0).x[0]/world_at(d, 0).x[2], y), 0.0, 2e-4,
             "rotates by its displacement over its radius");   /* first bounces */
    dem_free(d);

    d = world(free_scene, 1, &seed);
    TAP_OK(orientation(d) == NULL, "no orientations without the request");
    dem_free(d);
    TAP_DONE;
}
