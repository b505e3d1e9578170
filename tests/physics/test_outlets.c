/*
 * test_outlets.c -- outlets remove every particle that passes them between two checks, and no
 * other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/random.h"
#include "physics/world.h"

#include <unistd.h>

/* free flight: no effect of contacts */
#define BEADS "materials { glass { density 2500; youngsModulus 1e4; } } " \
              "effects { gravity { acceleration (0 0 0); } } " \
              "time { step 1e-5; maxOverlap 1e9; maxStartOverlap 1e9; } "

enum
{
    N = 400,
    CHECKS = 3,
    SAMPLES = 6000    /* of a path: 10 um apart, a twentieth of the thinnest region */
};

/* s: outlets are checked in the last of its 32 steps */
static const double window = 32e-5;

/* m: more than twice a step, as the core requires */
static const double diameter = 2e-3;

static int64_t removed(struct dem *d, int k)
{
    return world_flow(d, k).particles;
}

static double uniform(int64_t number, uint64_t use, double low, double high)
{
    return low + (high - low)*dem_random_unit(11, (uint64_t)number, 0, use);
}

/* Particles in a cube of 0.1 m with speeds of 20 to 60 m/s in all directions: 6 to 20 mm a check. */
static void throw_all(struct dem_new_particle *seed)
{
    for (int64_t m = 0; m < N; m++)
    {
        seed[m] = (struct dem_new_particle){.id = m, .diameter = diameter, .material = "glass"};
        for (uint64_t k = 0; k < 3; k++)
        {
            const double side = uniform(m, 10 + k, -1.0, 1.0) > 0.0 ? 1.0 : -1.0;

            seed[m].position[k] = uniform(m, k, 0.0, 0.1);
            seed[m].velocity[k] = side*uniform(m, 20 + k, 12.0, 35.0);
        }
    }
}

/* ---- paths ----------------------------------------------------------------------------------- */

typedef int inside(const double x[3]);

static int in_box(const double x[3])
{
    return x[2] >= 0.05 && x[2] <= 0.0502 && x[0] >= 0.01 && x[0] <= 0.09 && x[1] >= 0.01
        && x[1] <= 0.09;
}

static int in_disc(const double x[3])
{
    return x[0] >= 0.0003 && x[0] <= 0.0005 && hypot(x[1] - 0.05, x[2] - 0.05) <= 0.04;
}

static int in_sphere(const double x[3])
{
    return sqrt((x[0] - 0.05)*(x[0] - 0.05) + (x[1] - 0.05)*(x[1] - 0.05) +
                (x[2] - 0.05)*(x[2] - 0.05)) <= 0.015;
}

/* Does the path of CHECKS windows lead through the region? By samples, in the periodic box. */
static int passes(const struct dem_new_particle *q, inside *region, const double length[3])
{
    int found = 0;

    for (int s = 0; s <= SAMPLES && !found; s++)
    {
        double x[3];

        for (int k = 0; k < 3; k++)
        {
            x[k] = q->position[k] + q->velocity[k]*CHECKS*window*s/SAMPLES;
            x[k] -= length[k] > 0.0 ? length[k]*floor(x[k]/length[k]) : 0.0;
        }
        found = region(x);
    }
    return found;
}

static void test_paths(const char *what, const char *domain, const char *outlet, inside *region,
                       const double length[3])
{
    char *const text = world_text(BEADS "%s outlets { o { %s } }", domain, outlet);
    struct dem_new_particle seed[N];
    int here[N] = {0}, wrong = 0, expected = 0;
    struct dem_view v;

    throw_all(seed);
    struct dem *const d = world(text, N, seed);

    for (int k = 0; k < CHECKS; k++)
    {
        world_run(d, window);
    }
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        here[world_id(&v, i)] = 1;
    }
    for (int m = 0; m < N; m++)
    {
        const int goes = passes(&seed[m], region, length);

        expected += goes;
        wrong += goes == here[m];
    }
    TAP_OK(expected > 10 && wrong == 0 && removed(d, 0) == expected,
           "%s: %d of %d paths meet it, %lld are removed, %d of them wrongly", what, expected, N,
           (long long)removed(d, 0), wrong);
    dem_free(d);
}

static void test_shapes(void)
{
    static const double none[3] = {0.0, 0.0, 0.0}, all[3] = {0.1, 0.1, 0.1};
    static const struct
    {
        const char *what, *outlet;
        inside *region;
    } shape[] = {
        {"box", "min (0.01 0.01 0.05); max (0.09 0.09 0.0502);", in_box},
        {"disc", "cylinder { from (0.0003 0.05 0.05); to (0.0005 0.05 0.05); radius 0.04; }", in_disc},
        {"sphere", "sphere { centre (0.05 0.05 0.05); radius 0.015; }", in_sphere},
    };

    for (size_t k = 0; k < sizeof shape/sizeof *shape; k++)
    {
        char what[64];

        test_paths(shape[k].what, "", shape[k].outlet, shape[k].region, none);
        snprintf(what, sizeof what, "%s in a periodic domain", shape[k].what);
        test_paths(what, "domain { min (0 0 0); max (0.1 0.1 0.1); periodic (x y z); }",
                   shape[k].outlet, shape[k].region, all);
    }
}

/* ---- start, snapshot, program ---------------------------------------------------------------- */

#define SINK "outlets { sink { min (-1 -1 0); max (1 1 1e-4); } } "

static struct dem_new_particle falling(int64_t id, double z)
{
    return (struct dem_new_particle){
        .id = id, .diameter = diameter, .material = "glass", .position = {(double)id*1e-3, 0.0, z},
        .velocity = {0.0, 0.0, -10.0}};
}

static void test_start(void)
{
    const struct dem_new_particle seed = falling(0, 5e-5);
    struct dem *const d = world(BEADS SINK, 1, &seed);

    world_run(d, window);
    TAP_OK(removed(d, 0) == 1, "a particle that starts in the outlet is removed at the first check");
    dem_free(d);
}

static void test_snapshot(void)
{
    /* at 0.1 mm a step the first passes in step 69, the second in step 85; checks are in steps 64
       and 96 */
    const struct dem_new_particle seed[2] = {falling(0, 0.0069), falling(1, 0.0085)};
    char path[] = "/tmp/suna_outlets_XXXXXX";
    const int file = mkstemp(path);
    struct dem *d = world(BEADS SINK, 2, seed);

    world_run(d, 2.0*window + 10e-5);    /* the first has passed since the last check */
    WORLD_TRY(dem_save(d, path));
    TAP_OK(removed(d, 0) == 0 && world_at(d, 0).x[2] < 0.0, "between two checks one has passed");
    dem_free(d);
    struct dem_case *c = world_begin(BEADS SINK);
    WORLD_TRY(dem_case_load(c, path));
    d = world_start(c);
    world_run(d, window - 10e-5);
    TAP_OK(removed(d, 0) == 2, "the continued run removes it, and the other one");
    dem_free(d);
    close(file);
    remove(path);
}

static void test_program(void)
{
    const struct dem_new_particle seed = falling(0, 0.0015);
    struct dem_case *const c = world_begin(BEADS SINK);
    int changed;

    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    WORLD_TRY(dem_case_flows_on_request(c));
    struct dem *const d = world_start(c);
    for (int k = 0; k < 3; k++)
    {
        world_run(d, window);
        WORLD_TRY(dem_flow_apply(d, &changed));
    }
    TAP_OK(removed(d, 0) == 1, "an outlet that the program checks removes a particle that passed it");
    dem_free(d);
}

static void test_column(void)
{
    const struct dem_new_particle seed = falling(0, 0.1);
    struct dem *const with = world(BEADS SINK, 1, &seed);
    struct dem *const without =
        world(BEADS "outlets { below { point (0 0 0); normal (0 0 -1); } }", 1, &seed);

    TAP_OK(dem_column(&with->state.particles, DEM_COLUMN_CHECKED_POSITION)
               && !dem_column(&without->state.particles, DEM_COLUMN_CHECKED_POSITION),
           "positions at the last check are stored for regions only");
    dem_free(with);
    dem_free(without);
}

int main(void)
{
    TAP_TRAPS;
    test_shapes();
    test_start();
    test_snapshot();
    test_program();
    test_column();
    TAP_DONE;
}
