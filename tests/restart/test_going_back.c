/*
 * test_going_back.c -- backups in memory.
 *
 * - A run that returns to its backup continues with the same bits, friction included.
 * - Backups within a window do not change the bits and are made by all ranks at the same step.
 * - Impulses on walls and the energy balance go back, too, and go on.
 * - After a failure the last good state is restored completely; a failed state is never backed up,
 *   saved or advanced: a snapshot of before stays, bit for bit.
 *
 * Source: the contract in dem.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <math.h>
#include <unistd.h>

static const char heap[] =
    "materials { glass { density 2500; youngsModulus 2e6; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.6; } "
    "mindlin { friction 0.5; } }"
    "walls { cup { type box; min (0 0 0); max (0.01 0.01 0.1); } }"
    "insert { grains { type lattice; count 60; diameter 2e-3; min (0 0 0); max (0.01 0.01 0.1); } }"
    "time { step 1.52587890625e-05; }";

static const double step =
    /* s: times are sums without round-off, so windows can be compared */
    1.0/65536.0;

static uint64_t hash_of(struct dem *d)
{
    uint64_t hash;

    WORLD_TRY(dem_hash(d, &hash));
    return hash;
}

static void twice(void)
{
    struct dem *const d = world(heap, 0, NULL);
    double time = 0.0;

    TAP_OK(dem_restore(d, &time) != 0 && strstr(dem_error_text(), "dem_backup_every"),
           "without a backup: refused, names dem_backup_every");
    TAP_OK(dem_backup_every(d, -1) != 0 && strstr(dem_error_text(), "-1"),
           "backups every -1 steps: refused");
    world_run(d, 4096*step);
    const uint64_t before = hash_of(d);

    WORLD_TRY(dem_backup_every(d, 0));
    world_run(d, 1000*step);
    const uint64_t after = hash_of(d);

    WORLD_TRY(dem_restore(d, &time));
    TAP_OK(time == 4096*step && hash_of(d) == before && before != after,
           "restored, contact history included");
    world_run(d, 1000*step);
    TAP_OK(hash_of(d) == after, "the same bits when it runs again");
    WORLD_TRY(dem_restore(d, &time));
    world_run(d, 1000*step);
    TAP_OK(hash_of(d) == after, "the same bits when restored again");
    dem_free(d);
}

/* Two runs, one of which makes backups; then the backup against a run that ends at its time. */
static void within(void)
{
    struct dem *const plain = world(heap, 0, NULL), *const with_backups = world(heap, 0, NULL),
                      *const ends = world(heap, 0, NULL);
    double time = 0.0;

    WORLD_TRY(dem_backup_every(with_backups, 300));
    world_run(plain, 1000*step);
    world_run(with_backups, 1000*step);
    TAP_OK(hash_of(plain) == hash_of(with_backups), "the same bits with backups and without");
    WORLD_TRY(dem_restore(with_backups, &time));
    TAP_OK(time == 900*step, "the last backup is of step 900");
    world_run(ends, 900*step);
    TAP_OK(hash_of(with_backups) == hash_of(ends), "it is the state of a run that ends there");
    dem_free(plain);
    dem_free(with_backups);
    dem_free(ends);
}

/* In a fluid, with heat, clumps, and a lid that falls on the heap. */
static struct dem *recorded(void)
{
    struct dem_case *const c = world_begin(world_text(
        "%s effects { stokesDrag {} gunn {} frictionHeat {} }"
        "materials { glass { heatCapacity 800; conductivity 1; } }"
        "fluid { density 1000; viscosity 1e-3; velocity (0.01 0 0.02); temperature 350; conductivity 0.6; "
        "heatCapacity 4000; }"
        "shapes { rod { spheres ((-5e-4 0 0 1e-3) (5e-4 0 0 1e-3)); } }"
        "insert { grains { temperature 300; } rods { type lattice; shape rod; count 12; temperature 310; "
        "min (0 0 9e-3); max (0.01 0.01 0.02); } }"
        "walls { lid { type plane; point (0 0 0.02); normal (0 0 -1); motion { type free; mass 5e-4; "
        "force (0 0 -5e-3); weight yes; damping 1e-2; } } }",
        heap));

    WORLD_TRY(dem_case_enable_energy(c));
    struct dem *const d = world_start(c);

    WORLD_TRY(dem_wall_impulse_reset(d));
    return d;
}

/* The largest difference of an impulse [N s] or angular impulse [N m s] on a wall, and of a term of the
   energy balance [J]. */
static void differences(struct dem *d, struct dem *other, double *impulse, double *energy)
{
    const struct dem_energy_item *a, *b;
    double since, one[6], two[6];
    int n, m;

    WORLD_TRY(dem_energy(d, &since, &n, &a));
    WORLD_TRY(dem_energy(other, &since, &m, &b));
    *energy = n == m ? 0.0 : INFINITY;
    *impulse = 0.0;
    for (int k = 0; k < n && n == m; k++)
    {
        *energy = fmax(*energy, fabs(a[k].value - b[k].value));
    }
    for (int wall = 0; wall < 7; wall++)
    {
        WORLD_TRY(dem_wall_impulse(d, wall, one, one + 3));
        WORLD_TRY(dem_wall_impulse(other, wall, two, two + 3));
        for (int k = 0; k < 6; k++)
        {
            *impulse = fmax(*impulse, fabs(one[k] - two[k]));
        }
    }
}

/* A return to a backup within a window against a run that ends there; then both go on. */
static void records(void)
{
    struct dem *const d = recorded(), *const ends = recorded();
    double time, impulse, energy;

    WORLD_TRY(dem_backup_every(d, 2900));
    world_run(d, 3000*step);
    world_run(ends, 2900*step);
    differences(d, ends, &impulse, &energy);
    TAP_OK(impulse > 1e-7 && energy > 1e-7, "impulses and energies change in 100 steps: by %g and %g", impulse, energy);
    WORLD_TRY(dem_restore(d, &time));
    differences(d, ends, &impulse, &energy);
    TAP_OK(hash_of(d) == hash_of(ends), "in a fluid: the state of a run that ends at the backup");
    TAP_OK(impulse == 0.0 && energy == 0.0, "impulses on walls and the energy balance, too");
    world_run(d, 100*step);
    world_run(ends, 100*step);
    differences(d, ends, &impulse, &energy);
    TAP_OK(hash_of(d) == hash_of(ends) && impulse < 1e-18, "they go on: impulses to round-off");
    TAP_OK(energy < 1e-10, "energies but for the work of the lid in half a step: %g J", energy);
    dem_free(d);
    dem_free(ends);
}

static void give_fluid(struct dem *d, double velocity)
{
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(d, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.velocity[3*i] = f.velocity[3*i + 1] = 0.0;
        f.velocity[3*i + 2] = velocity;
        f.void_fraction[i] = 0.6;
        f.density[i] = 1.2;
        f.viscosity[i] = 1.8e-5;
    }
}

/* A fluid velocity that is not a number. */
static void failure(void)
{
    struct dem *const d = world(world_text("%s effects { gidaspow {} }", heap), 0, NULL);
    static char file[] = "/tmp/going_back.XXXXXX";
    const int made = mkstemp(file);
    uint64_t saved = 0;
    double time = 0.0;

    TAP_OK(made >= 0 && close(made) == 0, "a file for the snapshot");
    give_fluid(d, 0.5);
    WORLD_TRY(dem_backup_every(d, 100));
    world_run(d, 1050*step);
    const uint64_t before = hash_of(d);

    WORLD_TRY(dem_save(d, file));
    WORLD_TRY(dem_backup_every(d, 100));
    give_fluid(d, (double)NAN);
    TAP_OK(dem_advance(d, 500*step) != 0, "a velocity that is not a number ends the run: %s",
           dem_error_text());
    TAP_OK(dem_backup_every(d, 0) != 0 && strstr(dem_error_text(), "dem_restore"),
           "a failed state is not backed up");
    TAP_OK(dem_save(d, file) != 0 && strstr(dem_error_text(), "dem_restore"),
           "it is not saved: %s", dem_error_text());
    TAP_OK(dem_snapshot_hash(file, &saved) == 0 && saved == before, "the good snapshot stays");
    TAP_OK(dem_advance(d, step) != 0 && strstr(dem_error_text(), "dem_restore"),
           "it is not advanced");
    WORLD_TRY(dem_restore(d, &time));
    TAP_OK(dem_save(d, file) == 0 && dem_snapshot_hash(file, &saved) == 0 && saved == before,
           "the restored state is saved");
    remove(file);
    TAP_OK(time == 1050*step && hash_of(d) == before, "the previous state is restored completely");
    give_fluid(d, 0.5);
    TAP_OK(dem_advance(d, 500*step) == 0, "it continues with a valid fluid");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    twice();
    within();
    records();
    failure();
    TAP_DONE;
}
