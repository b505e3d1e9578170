/*
 * minimum_fluidisation.c -- minimum fluidisation and terminal velocity, expansion, response time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/minimum_fluidisation.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

static double volume(const struct dem_suspension *b)
{
    return pi/6.0*b->diameter*b->diameter*b->diameter;
}

double dem_suspension_archimedes(const struct dem_suspension *b)
{
    const double d = b->diameter;

    return b->fluid_density*(b->density - b->fluid_density)*b->gravity*d*d*d/
           (b->viscosity*b->viscosity);
}

double dem_suspension_wen_yu_velocity(const struct dem_suspension *b)
{
    const double ar = dem_suspension_archimedes(b);
    const double reynolds = ar > 0.0 ? sqrt(33.7*33.7 + 0.0408*ar) - 33.7 : 0.0;

    return reynolds*b->viscosity/(b->fluid_density*b->diameter);
}

double dem_suspension_response_time(const struct dem_suspension *b)
{
    return b->density*b->diameter*b->diameter/(18.0*b->viscosity);
}

/* m/s: the slip at which the drag is `force` [N], by bisection: b u increases with u. */
static double slip_at(const struct dem *d, const struct dem_suspension *b,
                      double void_fraction, double force)
{
    /* Stokes drag is the smallest */
    double low = 0.0, high = force/(3.0*pi*b->viscosity*b->diameter);

    if (force <= 0.0 || dem_drag_coefficient(d, b, void_fraction, high) <= 0.0)
    {
        return 0.0;
    }
    for (int k = 0; k < 60 && dem_drag_coefficient(d, b, void_fraction, high)*high < force; k++)
    {
        high *= 2.0;
    }
    for (int k = 0; k < 100; k++)
    {
        const double u = 0.5*(low + high);
        const int less = dem_drag_coefficient(d, b, void_fraction, u)*u < force;

        low = less ? u : low;
        high = less ? high : u;
    }
    return 0.5*(low + high);
}

/* N: weight that the drag on a particle supports at minimum fluidisation */
static double supported_weight(const struct dem_suspension *b, double void_fraction)
{
    const double density = b->feels_gradient ? void_fraction*(b->density - b->fluid_density) : b->density;

    return density*volume(b)*b->gravity;
}

double dem_suspension_fluidisation_velocity(const struct dem *d,
                                            const struct dem_suspension *b, double void_fraction)
{
    return void_fraction*slip_at(d, b, void_fraction, supported_weight(b, void_fraction));
}

double dem_suspension_terminal_velocity(const struct dem *d,
                                        const struct dem_suspension *b)
{
    const double submerged = b->feels_gradient ? b->density - b->fluid_density : b->density;

    return slip_at(d, b, 1.0, submerged*volume(b)*b->gravity);
}

/* 3 pi mu d f u balances the weight less buoyancy */
double dem_sphere_terminal_velocity(double diameter, double density, double fluid_density, double viscosity,
                                    double gravity)
{
    const double stokes = fabs(density - fluid_density)*gravity*diameter*diameter/(18.0*viscosity);
    double low = 0.0, high = stokes;

    while (high - low > 1e-12*high)
    {
        const double u = 0.5*(low + high);
        const int less = dem_single_sphere_drag(fluid_density*u*diameter/viscosity)*u < stokes;

        low = less ? u : low;
        high = less ? high : u;
    }
    return 0.5*(low + high);
}

/* 1 when U m/s (superficial) lifts the particles at this void fraction: b u increases with u. The scene has
   a drag law. */
static int lifts(const struct dem *d, const struct dem_suspension *b, double void_fraction, double U)
{
    const double u = U/void_fraction;

    return dem_drag_coefficient(d, b, void_fraction, u)*u > supported_weight(b, void_fraction);
}

double dem_suspension_expanded_void_fraction(const struct dem *d,
                                             const struct dem_suspension *b, double packed,
                                             double U)
{
    double low = packed, high = 1.0;

    if (!lifts(d, b, low, U))
    {
        return 0.0;
    }
    if (lifts(d, b, high, U))
    {
        return 1.0;
    }
    for (int k = 0; k < 40; k++)
    {
        const double e = 0.5*(low + high);
        const int less = lifts(d, b, e, U);

        low = less ? e : low;
        high = less ? high : e;
    }
    return 0.5*(low + high);
}

double dem_suspension_richardson_zaki(const struct dem_suspension *b, double U)
{
    const double u = dem_sphere_terminal_velocity(b->diameter, b->density, b->fluid_density,
                                                  b->viscosity, b->gravity);
    const double re = b->fluid_density*u*b->diameter/b->viscosity;
    const double n = re < 0.2 ? 4.65
                     : re < 1.0 ? 4.35*pow(re, -0.03)
                     : re < 500.0 ? 4.45*pow(re, -0.1)
                                  : 2.39;

    return u > U ? pow(U/u, 1.0/n) : 1.0;
}
