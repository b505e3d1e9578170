/*
 * test_mixed.c -- the error of mixed precision.
 *
 * Contact forces are in single precision, but both partners get the same force and sums are in
 * double precision.
 * - Momentum is kept as in double precision.
 * - An impact has the result of double precision within 1e-6.
 * - A bed keeps its overlaps within 1e-6, also a kilometre from the origin, as distances are taken
 *   in double precision.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include <math.h>

static const char laws[] =
    "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.25; } } "
    "effects { hertz {} dry { restitution 0.9; } mindlin { friction 0.3; } %s } %s "
    "time { step 2e-6; precision %s; }";
static const char *const precisions[] = {"double", "mixed"};

enum
{
    CLOUD = 125,
    SIDE = 5
};

/* a cube of spheres that nearly touch, with random velocities; its corner is at `at` along all
   axes */
static void random_cube(struct dem_new_particle *seed, double at)
{
    unsigned long long state = 7;

    for (int k = 0; k < CLOUD; k++)
    {
        const double x[3] = {k%SIDE, k/SIDE%SIDE, k/SIDE/SIDE};

        seed[k] = (struct dem_new_particle){.diameter = 1e-3, .material = "glass", .id = k};
        for (int m = 0; m < 3; m++)
        {
            state = state*6364136223846793005ULL + 1442695040888963407ULL;
            seed[k].position[m] = at + 1.02e-3*x[m];
            seed[k].velocity[m] = (double)(state >> 40)/(double)(1 << 24) - 0.5;
            seed[k].spin[m] = 200.0*seed[k].velocity[m];
        }
    }
}

/* speed along z and spin about y after an impact on a second sphere, at 1 m/s, 30 degrees from the
   normal */
static void impact(int mixed, double out[2])
{
    char *const text = world_text(laws, "", "", precisions[mixed]);
    const struct dem_new_particle seed[2] =
        {{.diameter = 1e-3, .material = "glass", .id = 0, .position = {0.0, 0.0, 0.0}},
         {.diameter = 1e-3,
          .material = "glass",
          .id = 1,
          .position = {0.0, 0.0, 1.01e-3},
          .velocity = {0.5, 0.0, -0.8660254}}};
    struct dem *const d = world(text, 2, seed);

    world_run(d, 1e-3);
    out[0] = world_at(d, 1).v[2];
    out[1] = world_at(d, 1).w[1];
    dem_free(d);
    free(text);
}

/* the cloud after `duration` [s]; sums of momentum in units of m/s per sphere, and positions */
static void cloud(int mixed, double at, double duration, double momentum[3], double (*x)[3])
{
    char *const text = world_text(laws, "", "", precisions[mixed]);
    struct dem_new_particle seed[CLOUD];

    random_cube(seed, at);
    struct dem *const d = world(text, CLOUD, seed);
    double before[3] = {0.0};

    for (int k = 0; k < CLOUD; k++)
    {
        for (int m = 0; m < 3; m++)
        {
            before[m] += seed[k].velocity[m];
        }
    }
    world_run(d, duration);
    for (int m = 0; m < 3; m++)
    {
        momentum[m] = -before[m];
        for (int k = 0; k < CLOUD; k++)
        {
            const struct world_particle p = world_at(d, k);

            momentum[m] += p.v[m];
            x[k][m] = p.x[m] - at;
        }
        momentum[m] /= CLOUD;
    }
    dem_free(d);
    free(text);
}

/* mean square distance of two clouds, in diameters */
static double apart(double (*a)[3], double (*b)[3])
{
    double sum = 0.0;

    for (int k = 0; k < CLOUD; k++)
    {
        for (int m = 0; m < 3; m++)
        {
            sum += (a[k][m] - b[k][m])*(a[k][m] - b[k][m]);
        }
    }
    return sqrt(sum/CLOUD)/1e-3;
}

/* overlaps of a column of ten at rest: its weight in closed form */
static void column(void)
{
    char *const text = world_text(
        "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.25; } } "
        "effects { hertz {} dry { restitution 0.1; } mindlin { friction 0.3; } "
        "gravity { acceleration (0 0 -9.81); } } "
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } } time { step 5e-6; "
        "precision mixed; }");
    struct dem_new_particle seed[10];
    double worst = 0.0;

    for (int k = 0; k < 10; k++)
    {
        seed[k] = (struct dem_new_particle){.diameter = 1e-3,
                                            .material = "glass",
                                            .id = k,
                                            .position = {0.0, 0.0, 0.5e-3 + 1e-3*k}};
    }
    struct dem *const d = world(text, 10, seed);

    world_run(d, 1.0);
    for (int k = 0; k < 9; k++)
    {
        const struct world_particle low = world_at(d, k), high = world_at(d, k + 1);
        const double load = (9.0 - k)*9.81*low.mass,
                     stiffness = 4.0/3.0*5e6/(2.0*(1.0 - 0.0625))*sqrt(0.25e-3);
        const double overlap = 1e-3 - (high.x[2] - low.x[2]),
                     expected = pow(load/stiffness, 2.0/3.0);

        worst = fmax(worst, fabs(overlap/expected - 1.0));
    }
    /* a force known to 6e-8 is an overlap known to 4e-8; besides, the motion has not decayed
       fully */
    TAP_OK(worst < 1e-6, "a column of ten at rest carries its weight: error of overlaps at most %.2g",
           worst);
    dem_free(d);
    free(text);
}

int main(void)
{
    double one[2], two[2], momentum[3], here[CLOUD][3], there[CLOUD][3], other[CLOUD][3];

    /* some 200 steps of contact, each with a random rounding of 6e-8: sqrt(200) = 14 times as much
       is 8e-7 */
    impact(0, one);
    impact(1, two);
    TAP_NEAR(two[0]/one[0], 1.0, 1e-6, "speed after an oblique impact");
    TAP_NEAR(two[1]/one[1], 1.0, 1e-6, "spin after an oblique impact");

    cloud(1, 0.0, 0.02, momentum, here);
    for (int m = 0; m < 3; m++)
    {
        /* 1e4 steps, each of which rounds 125 velocities of up to 1 m/s to 1e-16, at random */
        TAP_NEAR(momentum[m], 0.0, 1e-14, "125 collide: momentum along %c is kept", "xyz"[m]);
    }

    /* 0.4 ms: 200 steps, in which most have had a contact; 6e-8 of 1 m/s over that time is 2e-8 d.
       Later the chaotic growth of any difference dominates, not the precision */
    cloud(0, 0.0, 4e-4, momentum, here);
    cloud(1, 0.0, 4e-4, momentum, there);
    TAP_OK(apart(here, there) > 0.0 && apart(here, there) < 1e-7,
           "positions are those of double precision within %.2g d", apart(here, there));

    /* a kilometre away positions are known to 1e-13 m, 1e-10 d, in either precision */
    cloud(0, 1000.0, 4e-4, momentum, here);
    cloud(1, 1000.0, 4e-4, momentum, other);
    TAP_OK(apart(here, other) < 1e-7, "a kilometre from the origin: within %.2g d",
           apart(here, other));
    column();
    return tap_done();
}
