/*
 * test_ring.c -- neither output nor the share of rows that touch changes the run: the force buffer
 * (contacts/contact_forces.h), and stretches of rows (step/touching_rows.h).
 *
 * Contact forces go through a ring buffer, and are kept after a step of output only.
 * - A layer of touching spheres ends with the same bits, forces included, whether its means are
 *   sampled in every step, in some or in none.
 * - With periodic faces across it some rows exceed the ring and are deferred; a scene of few rows
 *   has no ring.
 * - With wide skins few rows touch, and only those become batches; with thin ones all rows become batches.
 *
 * Reference: a step with output, which keeps every contact force; the run with thin skins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "case/simulation.h"

#include <math.h>

enum
{
    LONG = 50, WIDE = 12, LAYER = LONG*WIDE,
    STEPS = 50
};

static const char friction[] = "mindlin { friction 0.4; }";

/* `high` layers of a cubic lattice, compressed by a thousandth, with random velocities. `laws`: effects
   besides hertz, dry and gravity; `more`: other entries of the scene. */
static struct dem *block(int high, const char *laws, const char *more)
{
    char *const scene = world_text(
        "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.3; } }"
        "effects { hertz { } dry { restitution 0.8; } %s "
        "gravity { acceleration (1 2 -9.81); } }"
        "domain { x (0 0.04995); y (0 0.01199); periodic (x y); }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "time { step 5e-6; } %s",
        laws, more);
    struct dem_new_particle *const seed = calloc((size_t)(LAYER*high), sizeof *seed);

    for (int k = 0; k < LAYER*high; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {0.999e-3*(k%LONG), 0.999e-3*(k/LONG%WIDE), 0.4995e-3 + 0.999e-3*(k/LAYER)},
            .velocity = {0.05*sin(1.3*k), 0.05*sin(2.1*k), 0.05*sin(0.7*k)}, .diameter = 1e-3,
            .id = k*7919%(LAYER*high), .material = "glass"};
    }
    struct dem *const d = world(scene, LAYER*high, seed);

    free(seed);
    return d;
}

static uint64_t hashed(uint64_t hash, const void *what, size_t bytes)
{
    for (size_t k = 0; k < bytes; k++)
    {
        hash = (hash ^ ((const unsigned char *)what)[k])*UINT64_C(1099511628211);
    }
    return hash;
}

/* Bits of everything that can be seen, forces and torques included. */
static uint64_t bits(struct dem *d, int count)
{
    struct world_particle *const p = calloc((size_t)count, sizeof *p);
    uint64_t hash = world_hash(d);

    world_all(d, p);
    hash = hashed(hash, p, (size_t)count*sizeof *p);
    free(p);
    return hash;
}

static const char every_step[] =
    "averages { all { min (0 0 0); max (0.05 0.012 0.008); interval 5e-6; } }";
static const char some_steps[] =
    "averages { all { min (0 0 0); max (0.05 0.012 0.008); interval 5e-5; } }";

static void compare(int high, int round)
{
    const int count = LAYER*high;
    struct dem *const never = block(high, friction, ""), *const always = block(high, friction, every_step),
                      *const sometimes = block(high, friction, some_steps);

    for (int k = 0; k < 4; k++)
    {
        world_run(never, STEPS*5e-6);
        world_run(always, STEPS*5e-6);
        world_run(sometimes, STEPS*5e-6);
    }
    TAP_OK(world_tally(never).contacts > count, "%d spheres touch: %lld contacts", count,
           (long long)world_tally(never).contacts);
    TAP_OK((never->state.contacts.forces.ring > 0) == round,
           "%d spheres: there is %s ring", count, round ? "a" : "no");
    if (round)
    {
        const struct dem_contact_forces *const f = &never->state.contacts.forces;

        TAP_OK(f->own_slots > f->first_deferred, "%zu rows are deferred beyond it",
               f->own_slots - f->first_deferred);
    }
    TAP_OK(bits(always, count) == bits(never, count),
           "%d spheres: the same bits when sampled in every step and never", count);
    TAP_OK(bits(sometimes, count) == bits(never, count), "%d spheres: the same bits when sampled in some steps",
           count);
    dem_free(never);
    dem_free(always);
    dem_free(sometimes);
}

/* What is on the stack afterwards is not a number. */
static void soil_stack(void)
{
    volatile unsigned char below[1 << 18];

    for (size_t k = 0; k < sizeof below; k++)
    {
        below[k] = 0xff;
    }
}

/* With these laws and entries: all rows in batches, and only those that touch. */
static void compact(int high, const char *name, const char *laws, const char *more)
{
    const int count = LAYER*high;
    static const char skins[] = "neighbours { outerSkin %g; innerSkin %g; } %s";
    struct dem *const thin = block(high, laws, world_text(skins, 0.3, 0.02, more)),
                      *const wide = block(high, laws, world_text(skins, 1.0, 0.8, more));

    for (int k = 0; k < 4; k++)
    {
        world_run(thin, STEPS*5e-6);
        soil_stack();
        world_run(wide, STEPS*5e-6);
    }
    TAP_OK(!thin->state.contacts.rows.few_touch && wide->state.contacts.rows.few_touch,
           "%s, %d spheres: few rows touch with wide skins only", name, count);
    TAP_OK((wide->state.contacts.forces.ring > 0) == (high > 1), "%s, %d spheres: the ring is %u rows", name, count,
           wide->state.contacts.forces.ring);
    TAP_OK(bits(wide, count) == bits(thin, count), "%s, %d spheres: the same bits", name, count);
    dem_free(thin);
    dem_free(wide);
}

int main(void)
{
    TAP_TRAPS;
    compare(1, 0);
    compare(5, 1);
    for (int high = 1; high <= 5; high += 4)
    {
        compact(high, "friction", friction, "");
        compact(high, "sampled", friction, every_step);
        compact(high, "rolling", "mindlin { friction 0.4; } rollingSpring { friction 0.1; }", "");
        compact(high, "no history", "", "");
    }
    return tap_done();
}
