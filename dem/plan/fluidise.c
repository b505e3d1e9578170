/*
 * fluidise.c -- the scene's law of drag is asked through its own tray, so the plan has no drag law of its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/fluidise.h"
#include "effects/effects.h"
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

enum
{
    ROWS = 8                                              /* a tray is padded to whole vectors */
};

static double volume(const struct dem_bed *b)
{
    return pi/6.0*b->diameter*b->diameter*b->diameter;
}

double dem_bed_archimedes(const struct dem_bed *b)
{
    const double d = b->diameter;

    return b->fluid_density*(b->density - b->fluid_density)*b->gravity*d*d*d/(b->viscosity*b->viscosity);
}

double dem_bed_wen_yu(const struct dem_bed *b)
{
    const double ar = dem_bed_archimedes(b);
    const double reynolds = ar > 0.0 ? sqrt(33.7*33.7 + 0.0408*ar) - 33.7 : 0.0;

    return reynolds*b->viscosity/(b->fluid_density*b->diameter);
}

double dem_bed_response(const struct dem_bed *b)
{
    return b->density*b->diameter*b->diameter/(18.0*b->viscosity);
}

double dem_bed_drag(const struct dem_recipe *r, const struct dem_bed *b, double void_fraction, double u)
{
    struct dem_body_block tray;
    double coefficient = 0.0;

    memset(&tray, 0, sizeof tray);
    tray.n = ROWS;
    for (int c = 0; c < ROWS; c++)
    {
        tray.radius[c] = 0.5*b->diameter;
        tray.volume[c] = volume(b);
        tray.mass[c] = b->density*volume(b);
        tray.ux[c] = u;
        tray.void_fraction[c] = void_fraction;
        tray.density[c] = b->fluid_density;
        tray.viscosity[c] = b->viscosity;
    }
    for (int k = 0; k < r->bodies.links; k++)
    {
        if (r->bodies.link[k].effect->drag)
        {
            dem_effect_on_bodies(r->bodies.link[k].effect, r->bodies.link[k].settings, &tray);
            coefficient = tray.b[0];
        }
    }
    return coefficient;
}

/* The slip at which drag is `force`: b u grows with u. */
static double slip_at(const struct dem_recipe *r, const struct dem_bed *b, double void_fraction, double force)
{
    double low = 0.0, high = force/(3.0*pi*b->viscosity*b->diameter);    /* Stokes' drag is the least */

    if (force <= 0.0 || dem_bed_drag(r, b, void_fraction, high) <= 0.0)
    {
        return 0.0;
    }
    for (int k = 0; k < 60 && dem_bed_drag(r, b, void_fraction, high)*high < force; k++)
    {
        high *= 2.0;
    }
    for (int k = 0; k < 100; k++)
    {
        const double u = 0.5*(low + high);
        const int less = dem_bed_drag(r, b, void_fraction, u)*u < force;

        low = less ? u : low;
        high = less ? high : u;
    }
    return 0.5*(low + high);
}

double dem_bed_balance(const struct dem_recipe *r, const struct dem_bed *b, double void_fraction)
{
    const double carried = b->feels_gradient ? void_fraction*(b->density - b->fluid_density) : b->density;

    return void_fraction*slip_at(r, b, void_fraction, carried*volume(b)*b->gravity);
}

double dem_bed_terminal(const struct dem_recipe *r, const struct dem_bed *b)
{
    const double sinks = b->feels_gradient ? b->density - b->fluid_density : b->density;

    return slip_at(r, b, 1.0, sinks*volume(b)*b->gravity);
}
