/*
 * test_counters.c -- planes count what passes them, forth and back, also through periodic faces; outlets give
 * the times that particles have been in the domain.
 *
 * Source: kinematics of uniform motion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <unistd.h>

#define GLASS "materials { glass { density 2500; youngsModulus 1e6; } } effects { hertz {} } time { step 1e-5; } "

static char file[] = "/tmp/counters.XXXXXX";

static const char box[] =
    GLASS "domain { x (0 0.02); y (0 0.02); z (0 0.02); periodic (z); } planes { all { point (0 0 0.005); normal (0 0 "
    "2); } eye { point (0.005 0.005 0.005); normal (0 0 -1); radius 0.002; } face { point (0 0 0.02); normal (0 0 1); "
    "} } ";

static const struct dem_new_particle seeds[] = {
    {.position = {0.005, 0.006, 0.001}, .velocity = {0.0, 0.0, 1.0}, .diameter = 1e-3, .material = "glass", .id = 0},
    {.position = {0.015, 0.015, 0.001}, .velocity = {0.0, 0.0, -0.5}, .diameter = 1e-3, .material = "glass", .id = 1}};

/* Passages of z = height + m 0.02 by a particle from z0 on. */
static int64_t passages(double z0, double v, double time, double height)
{
    const double z = z0 + v*time;

    return llabs((long long)(floor((z - height)/0.02) - floor((z0 - height)/0.02)));
}

static void test_planes(void)
{
    struct dem *d = world(box, 2, seeds);
    const double time = 3200*1e-5*10;

    for (int k = 0; k < 10; k++)
    {
        world_run(d, 0.1*time);
        if (k == 4)
        {
            struct dem_case *const c = world_begin(box);

            WORLD_TRY(dem_save(d, file));
            dem_free(d);
            WORLD_TRY(dem_case_load(c, file));
            d = world_start(c);
        }
    }
    const int64_t forth = passages(0.001, 1.0, time, 0.005), back = passages(0.001, -0.5, time, 0.005);
    const struct dem_flow all[2] = {world_flow(d, 0), world_flow(d, 1)};

    TAP_OK(all[0].particles == forth && all[1].particles == back && all[0].enters == DEM_FLOW_WAY_FORTH
               && all[1].enters == DEM_FLOW_WAY_BACK, "a plane counts %lld forth and %lld back, across a restart: %lld "
           "%lld", (long long)forth, (long long)back, (long long)all[0].particles, (long long)all[1].particles);
    TAP_OK(world_flow(d, 2).particles == 0 && world_flow(d, 3).particles == forth,
           "a disc counts what passes within its radius: %lld", (long long)world_flow(d, 3).particles);
    TAP_OK(world_flow(d, 4).particles == passages(0.001, 1.0, time, 0.02)
               && world_flow(d, 5).particles == passages(0.001, -0.5, time, 0.02),
           "a plane on a periodic face counts each passage once: %lld %lld", (long long)world_flow(d, 4).particles,
           (long long)world_flow(d, 5).particles);
    const double m = world_at(d, 0).mass;

    TAP_OK(fabs(all[0].momentum[2] - m*(double)forth) < 1e-12*m*(double)forth
               && fabs(all[1].momentum[2] + 0.5*m*(double)back) < 1e-12*m*(double)back, "with their momentum");
    TAP_OK(world_tally(d).removed == 0 && world_tally(d).particles == 2, "and removes nothing");
    dem_free(d);
}

/* A stream of 0.5 m/s from a region to an outlet 0.05 m further: checks are 32 steps apart. */
static void test_residence(void)
{
    static const char scene[] =
        GLASS "insert { feed { type stream; rate 2000; diameter 1e-3; velocity (0 0 0.5); min (0 0 0); max (0.02 0.02 "
        "0.0011); } } outlets { out { point (0 0 0.05055); normal (0 0 1); residence 0.2; } other { min (1 1 1); max "
        "(2 2 2); } } ";
    struct dem *d = world(scene, 0, NULL);

    for (int k = 0; k < 2; k++)
    {
        struct dem_case *const c = world_begin(scene);

        world_run(d, 0.2);
        WORLD_TRY(dem_save(d, file));
        dem_free(d);
        WORLD_TRY(dem_case_load(c, file));
        d = world_start(c);
    }
    const struct dem_residence *const r = dem_residence(d, 1);
    const double mean = r ? r->sum/(double)r->particles : 0.0,
                 variance = r ? r->squares/(double)r->particles - mean*mean : 1.0;

    TAP_OK(r && r->particles == world_flow(d, 1).particles && r->particles > 500, "an outlet has the times of all "
           "particles that it removed, across restarts: %lld", r ? (long long)r->particles : 0);
    TAP_OK(fabs(mean - 0.1) < 5e-4 && variance < 1e-7, "their mean is 0.05 m over 0.5 m/s: %.6g s, variance %.2g s2",
           mean, variance);
    TAP_OK(r && r->bin[31] + r->bin[32] == r->particles, "and they are in the bins around it");
    TAP_OK(!dem_residence(d, 2) && !dem_residence(d, 0), "an outlet without the entry has none");
    dem_free(d);
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_set(c, "outlets/out/residence", "0.4"));
    WORLD_TRY(dem_case_load(c, file));
    d = world_start(c);
    world_run(d, 0.2);
    const struct dem_residence *const twice = dem_residence(d, 1);

    TAP_OK(twice->bin[15] + twice->bin[16] == twice->particles && twice->particles > 300,
           "with another end at a restart they are counted anew, in bins of one width: %lld of %lld",
           (long long)(twice->bin[15] + twice->bin[16]), (long long)twice->particles);
    dem_free(d);
}

int main(void)
{
    world_make_file(file);
    test_planes();
    test_residence();
    world_refused(GLASS "planes { a { point (0 0 0); normal (0 0 0); } }", "normal of length 0");
    world_refused(GLASS "planes { a { point (0 0 0); normal (0 0 1); } } outlets { a { point (0 0 0); normal (0 0 1); } }",
                  "rename");
    unlink(file);
    TAP_DONE;
}
