/*
 * test_turning.c -- a loaded friction spring rotates with its pair about the normal.
 *
 * Two spheres that stick and spin alike, a sphere on a plate, and one on a turntable. They slip at
 * a steady rate in space under springs too soft to change it, so the force describes a circle at
 * the mean spin W of both partners, k s (e^(i W t) - 1)/(i W), and vanishes after each turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double R = 0.5e-3, W = 1000.0, u = 1.0, k = 1e-6,
                    step = 1e-6;   /* m; 1/s about n, and along it; N/m */

/* Softness: k/m is 0.8 1/s2, so in a turn of 6 ms the slip changes by 7/2 k/m t^2 = 1e-4 of it,
   by the steps (W dt)^2/12 = 1e-7. The spin u about x does not tilt the pair, as it is the same for
   both. */
static const double tolerance = 2e-4;

static void circle(struct dem *d, double slip, double mean, const char *what)
{
    const double across = k*slip*2.0/mean;                /* N   the circle's diameter */
    const int steps = (int)floor(2.0*world_pi/mean/step + 0.5);

    for (int n = 1; n <= steps; n++)
    {
        world_step(d);
        if (n == steps/4 || n == steps/2 || n == steps)
        {
            const double t = mean*step*(double)n;
            const struct world_particle p = world_at(d, 1);

            /* xi = s ((sin t) + i (1 - cos t))/W along slip and across; F = -k xi, slip of 1 over
               its partner along -y */
            TAP_NEAR(p.f[1], 0.5*across*sin(t), tolerance*fabs(across),
                     "%s: along the slip after %.3g turns", what, t/(2.0*world_pi));
            TAP_NEAR(p.f[0], -0.5*across*(1.0 - cos(t)), tolerance*fabs(across),
                     "%s: across it", what);
        }
    }
    dem_free(d);
}

/* In equilibrium at x^3 = 6: see jkr.c. */
static struct dem *pair(double *arm)
{
    const double E = 1e7/(2.0*0.91), w = 0.05, Rs = 0.5*R,
                 a = pow(world_pi*w*Rs*Rs/(8.0*E), 1.0/3.0), x = pow(6.0, 1.0/3.0);
    const double overlap = a*a/Rs*(x*x*x*x - 4.0*x);
    const struct dem_new_particle seed[2] = {
        {.position = {0, 0, 0}, .spin = {u, 0, W}, .diameter = 2.0*R, .id = 0, .material = "clay"},
        {.position = {0, 0, 2.0*R - overlap}, .spin = {u, 0, W}, .diameter = 2.0*R, .id = 1,
         .material = "clay"}};
    *arm = 2.0*R - overlap;
    return world(world_text(
        "materials { clay { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
        "effects { hertz { } jkr { workOfAdhesion %g; } linear { stiffness %g; friction 10; } }"
        "time { step %g; }",
        w, k, step), 2, seed);
}

/* A sphere rests under its weight on a plate that rotates at `omega` about the vertical below
   it. */
static struct dem *plate(double spin, double omega)
{
    const double m = world_sphere_mass(R, 2500.0), stiffness = 100.0;
    const struct dem_new_particle seed = {
        .position = {0, 0, R - m*9.81/stiffness}, .spin = {u, 0, spin}, .diameter = 2.0*R, .id = 1,
        .material = "clay"};
    return world(world_text(
        "materials { clay { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hooke { stiffness %g; } "
        "linear { stiffness %g; friction 10; } }"
        "walls { table { type triangles; corners ((-0.01 -0.01 0) (0.02 -0.01 0) (-0.01 0.02 0));"
        "motion { type rotation; origin (0 0 0); axis (0 0 1); omega %g; } } }"
        "time { step %g; }",
        stiffness, k, omega, step), 1, &seed);
}

int main(void)
{
    TAP_TRAPS;
    const double height = R - world_sphere_mass(R, 2500.0)*9.81/100.0;
    double arm;
    struct dem *const two = pair(&arm);

    /* the spin u about x moves the bottom of the upper sphere along +y and the top of the lower one
       along -y */
    circle(two, -arm*u, W, "two spheres with equal spins");
    circle(plate(W, 0.0), -height*u, 0.5*W, "a spinning sphere on a plate at rest");
    circle(plate(W, W), -height*u, W, "a sphere that spins with its plate");
    circle(plate(0.0, W), -height*u, 0.5*W, "a sphere without spin on a turntable");
    circle(plate(W, 2.0*W), -height*u, 1.5*W, "a sphere slower than its turntable");
    TAP_DONE;
}
