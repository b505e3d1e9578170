/*
 * test_piles.c -- columns, cradles and a fast sphere among many.
 *
 * - A column of 200 spheres at rest: force on the floor, overlap at the floor and height of the top
 *   by statics and Hertz.
 * - Newton's cradles of three and of five spheres: final speeds of an exact integration.
 * - A fast sphere among a thousand: thin, thick and complete neighbor lists give the same bits.
 *
 * Sources: column: statics, sum over the contacts of (3 F/(4 E* sqrt(R*)))^(2/3); cradle: Hertz
 * (1882), integrated with a Runge-Kutta method of order 8.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/random.h"

enum
{
    COLUMN = 200, SIDE = 10, GAS = SIDE*SIDE*SIDE
};

static const double R = 1e-3, density = 2500.0, E = 1e7, g = 9.80665;

/* The weight of all above presses each contact: from the floor (k = 0) to the top. */
static double overlap_at(int k)
{
    const double force = (COLUMN - k)*world_sphere_mass(R, density)*g, plane = E/(1.0 - 0.09);
    const double modulus = k ? 0.5*plane : plane, radius = k ? 0.5*R : R;

    return pow(0.75*force/(modulus*sqrt(radius)), 2.0/3.0);
}

static void column(void)
{
    static struct dem_new_particle seed[COLUMN];
    double force[3], top = 0.0;
    /* a viscous fluid without weight brings it to rest: the period of the slowest mode is 0.1 s */
    char *const scene = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
        "rigid { density 1; youngsModulus 1e30; } }"
        "effects { hertz { impactSpeed 0.1; } dry { restitution 0.5; } wenYu {}"
        "gravity { acceleration (0 0 -9.80665); } } fluid { density 1e-9; viscosity 0.06; }"
        "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }");

    for (int k = 0; k < COLUMN; k++)
    {
        seed[k] = (struct dem_new_particle){.position = {0.0, 0.0, R*(2*k + 1)},
                                            .diameter = 2.0*R,
                                            .id = k,
                                            .material = "glass"};
        top += overlap_at(k);
    }
    struct dem *const d = world(scene, COLUMN, seed);

    world_run(d, 1.0);
    world_wall(d, "floor", force);
    const double all = COLUMN*world_sphere_mass(R, density)*g, height = world_at(d, COLUMN - 1).x[2],
                 lowest = R - world_at(d, 0).x[2];

    /* the force still oscillates by 2e-7 of the weight after 1 s; the reference requires 1e-5 */
    TAP_NEAR(-force[2], 2.0538999e-2, 1e-5*all, "column: %.8g N on the floor", -force[2]);
    TAP_NEAR(all, 2.0538999e-2, 1e-6*all, "column: this is its weight");
    TAP_NEAR(lowest, 1.25253e-5, 1e-5*lowest, "column: overlap %.6g m at the floor", lowest);
    TAP_NEAR(height, 0.39599403592, 1e-5*top, "column: its top at %.11f m", height);
    TAP_NEAR((2*COLUMN - 1)*R - top, 0.39599403592, 1e-9,
             "column: this is the sum over all contacts");
    TAP_NEAR(fabs(force[0]) + fabs(force[1]), 0.0, 0.0, "column: no force across");
    TAP_OK(world_tally(d).contacts == COLUMN, "column: %d contacts", COLUMN);
    free(scene);
    dem_free(d);
}

static void cradle(int n, const double *expected)
{
    struct dem_new_particle seed[5];
    const double mass = world_sphere_mass(R, density),
                 time = world_contact_time(0.5*mass, 0.5*R, 0.5*E/(1.0 - 0.09), 1.0);
    char *const scene =
        world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
                   "effects { hertz {} } time { step %.17g; }",
                   time/400.0);

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < n; k++)
    {
        seed[k] = (struct dem_new_particle){.position = {2.0*R*k - (k ? 0.0 : 1e-6), 0.0, 0.0},
                                            .velocity = {k ? 0.0 : 1.0, 0.0, 0.0},
                                            .diameter = 2.0*R,
                                            .id = k,
                                            .material = "glass"};
    }
    struct dem *const d = world(scene, n, seed);

    world_run(d, 10.0*n*time);
    for (int k = 0; k < n; k++)
    {
        const double v = world_at(d, k).v[0];

        TAP_NEAR(v, expected[k], 5e-3, "cradle of %d: sphere %d leaves with %.5f", n, k, v);
    }
    free(scene);
    dem_free(d);
}

/* One sphere a hundred times as fast as the others crosses a box of a thousand, again and again. */
static struct dem *gas(double outer, double inner)
{
    static struct dem_new_particle seed[GAS];
    char *const scene = world_text(
        "materials { glass { density 2500; youngsModulus 1e8; poissonsRatio 0.3; } }"
        "effects { hertz { impactSpeed 20; } dry { restitution 0.95; } mindlin { friction 0.3; } }"
        "walls { b { type box; min (0 0 0); max (0.03 0.03 0.03); } }"
        "neighbours { outerSkin %g; innerSkin %g; }",
        outer, inner);

    for (int k = 0; k < GAS; k++)
    {
        const int at[3] = {k%SIDE, k/SIDE%SIDE, k/(SIDE*SIDE)};

        seed[k] = (struct dem_new_particle){.diameter = 2.0*R, .id = k, .material = "glass"};
        for (int a = 0; a < 3; a++)
        {
            seed[k].position[a] = 0.003*(at[a] + 0.5) +
                                  4e-4*(dem_random_unit(5, (uint64_t)k, 1, (uint64_t)a) - 0.5);
            seed[k].velocity[a] = 0.4*(dem_random_unit(5, (uint64_t)k, 0, (uint64_t)a) - 0.5);
        }
    }
    seed[0].velocity[0] = 13.0, seed[0].velocity[1] = 11.0, seed[0].velocity[2] = 7.0;
    struct dem *const d = world(scene, GAS, seed);

    free(scene);
    return d;
}

static void fast_sphere(void)
{
    static const double skins[][2] = {{2.0, 2.0}, {0.3, 0.04}, {0.05, 0.05}, {0.02, 0.005}};
    enum { CASES = sizeof skins/sizeof skins[0] };
    uint64_t hash[CASES];
    struct dem_totals t[CASES];

    for (int k = 0; k < CASES; k++)
    {
        struct dem *const d = gas(skins[k][0], skins[k][1]);

        world_run(d, 0.007);
        hash[k] = world_hash(d);
        t[k] = world_tally(d);
        dem_free(d);
    }
    TAP_NOTE("%lld steps; rebuilds %lld, %lld, %lld, %lld; prunes of the second %lld",
             (long long)t[0].steps, (long long)t[0].rebuilds, (long long)t[1].rebuilds,
             (long long)t[2].rebuilds, (long long)t[3].rebuilds, (long long)t[1].prunes);
    TAP_OK(t[0].largest_overlap > 0.005, "fast sphere: it hits others, overlap %.3f of a diameter",
           t[0].largest_overlap);
    TAP_OK(t[0].rebuilds < t[3].rebuilds, "fast sphere: the lists differ in age");
    for (int k = 1; k < CASES; k++)
    {
        TAP_OK(hash[k] == hash[0], "fast sphere: skins %g and %g give the bits of skins 2",
               skins[k][0], skins[k][1]);
    }
}

int main(void)
{
    static const double three[] = {-0.07095, 0.07640, 0.99455},
                        five[] = {-0.071083, -0.030273, -0.014463, 0.127040, 0.988778};

    TAP_TRAPS;
    column();
    cradle(3, three);
    cradle(5, five);
    fast_sphere();
    TAP_DONE;
}
