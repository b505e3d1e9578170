/*
 * test_dispersion.c -- turbulent dispersion of particles in homogeneous turbulence.
 *
 * In a fluid velocity u' of variance U^2 and autocorrelation exp(-t/T), a particle of relaxation
 * time tau, initially at rest, has
 *
 *   x(t) = int (1 - exp(-(t - s)/tau)) u'(s) ds,   <x^2>/(2 t) -> U^2 T,   <v^2> -> U^2 T/(T + tau)
 *
 * so in the long run it disperses like the fluid, whatever its mass (Tchen 1947; Hinze 1975).
 * <x^2> at finite times is 2 U^2 int f g, with f = 1 - exp(-a/tau) and g' = f - g/T.
 *
 * - Light and heavy particles have these variances.
 * - Particles that fall through the eddies at w have the time 1/(1/T + w/L) instead of T.
 * - Without kinetic energy there is no dispersion.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <stdio.h>
#include <stdlib.h>

enum
{
    SIDE = 22, COUNT = SIDE*SIDE*SIDE
};

/* U = 1 m/s, T = 0.1 s: k = 1.5 m2/s2, epsilon = 0.15 k/T. Steps h <= T/10: (h/T)^2/12 too much */
static const double T = 0.1;

static struct dem *turbulent(double tau, double step, const char *effects, double energy)
{
    char scene[1024];

    snprintf(scene, sizeof scene,
             "materials { bead { density 1000; youngsModulus 1e7; } }"
             "effects { stokesDrag {} %s }"
             "fluid { density 1; viscosity %.17g; turbulentEnergy %g; dissipation 2.25; }"
             "time { step %g; }"
             "insert { all { type lattice; material bead; diameter 1e-3; count %d; spacing 2e4; "
             "min (0 0 0); max (%g %g %g); } }",
             effects, 1000.0*1e-6/(18.0*tau), energy, step, COUNT, SIDE*20.0, SIDE*20.0, SIDE*20.0);
    return world(scene, 0, NULL);
}

/* <x^2>/U^2 at t, time scale of the fluid T */
static double variance(double t, double tau, double scale)
{
    const int steps = 20000;
    const double h = t/steps;
    double g = 0.0, sum = 0.0;

    for (int k = 0; k < steps; k++)
    {
        const double f = 1.0 - exp(-(k + 0.5)*h/tau), middle = g + 0.5*h*(f - g/scale);

        sum += 2.0*h*f*middle;
        g += h*(f - middle/scale);
    }
    return sum;
}

static double start[COUNT][3];

static void remember(struct dem *d)
{
    struct dem_view v;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            start[*(const int64_t *)(const void *)((const char *)v.id + i*v.stride)][k] =
                dem_at(v.position, v.stride, i)[k];
        }
    }
}

/* mean squares of displacement and velocity of the components x and y */
static void mean_squares(struct dem *d, double *x2, double *v2)
{
    struct dem_view v;

    dem_view(d, &v);
    *x2 = *v2 = 0.0;
    for (size_t i = 0; i < v.n; i++)
    {
        const int64_t id = *(const int64_t *)(const void *)((const char *)v.id + i*v.stride);

        for (int k = 0; k < 2; k++)
        {
            const double x = dem_at(v.position, v.stride, i)[k] - start[id][k],
                         u = dem_at(v.velocity, v.stride, i)[k];

            *x2 += x*x/(2.0*COUNT);
            *v2 += u*u/(2.0*COUNT);
        }
    }
}

/* variance of 2 COUNT normal numbers: standard deviation sqrt(2/(2 COUNT)), 1 %; four of these */
static const double margin = 0.04;

static void tchen(double tau, double t)
{
    struct dem *const d = turbulent(tau, 0.1*T, "turbulentDispersion { crossing no; }", 1.5);
    const double exact = variance(t, tau, T);
    double x2, v2;

    remember(d);
    world_run(d, t);
    mean_squares(d, &x2, &v2);
    TAP_NEAR(x2, exact, margin*exact, "tau/T = %g: <x^2> %g m2, closed form %g m2", tau/T, x2, exact);
    TAP_NEAR(v2, T/(T + tau), margin*T/(T + tau), "tau/T = %g: <v^2> %g m2/s2, Tchen %g m2/s2", tau/T,
             v2, T/(T + tau));
    if (tau < 2.0*T)
    {
        /* (T + 1.5 tau)/t short of the limit, 4 % */
        TAP_NEAR(x2/(2.0*t), T, (margin + 0.04)*T, "tau/T = %g: diffusivity %g m2/s, U^2 T %g m2/s",
                 tau/T, x2/(2.0*t), T);
    }
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    tchen(0.01, 6.0);
    tchen(1.0, 3.0);

    /* Falls at 20 m/s through eddies of 2/3 m, L/w = T/3 */
    {
        const double tau = 0.01, t = 1.5, exact = variance(t, tau, T/4.0);
        struct dem *const d = turbulent(
            tau, 0.05*T, "gravity { acceleration (0 0 -2000); } turbulentDispersion { length 0.816497; }", 1.5);
        double x2, v2;

        remember(d);
        world_run(d, t);
        mean_squares(d, &x2, &v2);
        TAP_NEAR(x2, exact, margin*exact, "falling: <x^2> %g m2, closed form %g m2", x2, exact);
        dem_free(d);
    }

    {
        struct dem *const d =
            turbulent(0.1, 0.05*T, "gravity { acceleration (0 0 -10); } turbulentDispersion {}", 0.0);
        const double exact = -10.0*0.1*(1.0 - exp(-10.0));

        world_run(d, 1.0);
        TAP_NEAR(world_at(d, 5).v[2], exact, 1e-12, "no turbulence: falls as in a fluid at rest");
        TAP_OK(world_at(d, 5).v[0] == 0.0, "no turbulence: straight down");
        dem_free(d);
    }
    TAP_DONE;
}
