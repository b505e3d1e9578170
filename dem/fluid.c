/*
 * fluid.c -- the door of a coupled fluid: columns of what particles know of it, and what it gets of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "effects/exchange.h"

int dem_needs_fluid(const struct dem *d)
{
    return d->with_fluid;
}

int dem_fluid(struct dem *d, struct dem_fluid *f)
{
    const struct dem_particles *const p = &d->parts.particles;

    DEM_REQUIRE(!d->scene.fluid.given, DEM_ERROR_INPUT, "the scene gives a uniform fluid, but it is coupled to a running one; remove "
                "the entry fluid");
    d->coupled = 1;
    *f = (struct dem_fluid){.n = p->n, .velocity = dem_column(p, DEM_COLUMN_FLUID_VELOCITY),
                            .pressure_gradient = dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT),
                            .void_fraction = dem_column(p, DEM_COLUMN_VOID_FRACTION), .density = dem_column(p, DEM_COLUMN_FLUID_DENSITY),
                            .viscosity = dem_column(p, DEM_COLUMN_FLUID_VISCOSITY),
                            .acceleration = dem_column(p, DEM_COLUMN_FLUID_ACCELERATION),
                            .vorticity = dem_column(p, DEM_COLUMN_VORTICITY), .stress = dem_column(p, DEM_COLUMN_STRESS),
                            .mean_diameter = dem_column(p, DEM_COLUMN_MEAN_DIAMETER),
                            .other_impulse = dem_column(p, DEM_COLUMN_OTHER_IMPULSE),
                            .turn_impulse = dem_column(p, DEM_COLUMN_TURN_IMPULSE),
                            .counterflow = dem_column(p, DEM_COLUMN_COUNTERFLOW), .place = dem_column(p, DEM_COLUMN_PLACE),
                            .drag_time = dem_column(p, DEM_COLUMN_DRAG_TIME),
                            .drag_impulse = dem_column(p, DEM_COLUMN_DRAG_IMPULSE), .response = dem_column(p, DEM_COLUMN_RESPONSE),
                            .way = dem_column(p, DEM_COLUMN_WAY), .passed = dem_column(p, DEM_COLUMN_PASSED), .pending = dem_column(p, DEM_COLUMN_PENDING)};
    return DEM_OK;
}

void dem_fluid_whole_drag(struct dem *d, int yes)
{
    d->parts.recipe.bodies.whole_drag = yes;
}

int dem_fluid_correct(struct dem *d, const double *velocity, const double *pressure_gradient)
{
    struct dem_particles *const p = &d->parts.particles;
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY), *const g = dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT);
    const double *const R = dem_column(p, DEM_COLUMN_RESPONSE), *const passed = dem_column(p, DEM_COLUMN_PASSED);
    const double *const foreseen = dem_column(p, DEM_COLUMN_FORESEEN);
    double *const pending = dem_column(p, DEM_COLUMN_PENDING), *const change = dem_column(p, DEM_COLUMN_FLUID_CHANGE);

    DEM_REQUIRE(d->with_fluid, DEM_ERROR_STATE, "dem_fluid_correct without fluid effects");
    for (size_t i = 0; i < p->n; i++)
    {
        const double volume = d->feels_gradient ? dem_particle_volume(&p->record[i]) : 0.0;
        const double Q = passed[i]*volume*d->parts.window;

        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            pending[k] = R[i]*(velocity[k] - u[k]) + Q*(pressure_gradient[k] - g[k]) - (foreseen ? foreseen[k] : 0.0);
            if (change)
            {
                change[k] = (velocity[k] - u[k])/d->parts.window;
            }
        }
    }
    return DEM_OK;
}

/* ---- what it gets -------------------------------------------------------------------------------------------- */

double dem_fluid_counterflow(const struct dem *d, double void_fraction)
{
    return dem_exchange_counterflow(void_fraction, d->parts.recipe.bodies.whole_drag);
}

int dem_fluid_reaction(const struct dem *d, enum dem_exchange how, double window, double *coefficient, double *force)
{
    const struct dem_particles *const p = &d->parts.particles;
    const double *const drag = dem_column(p, DEM_COLUMN_DRAG_IMPULSE), *const other = dem_column(p, DEM_COLUMN_OTHER_IMPULSE);
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY);
    const double *const answer = dem_column(p, how == DEM_EXCHANGE_DEFERRED ? DEM_COLUMN_RESPONSE : DEM_COLUMN_DRAG_TIME);

    DEM_REQUIRE(d->with_fluid, DEM_ERROR_STATE, "dem_fluid_reaction without fluid effects");
    DEM_REQUIRE(window > 0.0, DEM_ERROR_INPUT, "dem_fluid_reaction: a window of %g s; give a time above 0", window);
    for (size_t i = 0; i < p->n; i++)
    {
        coefficient[i] = how == DEM_EXCHANGE_EXPLICIT ? 0.0 : answer[i]/window;
        for (size_t k = 0; k < 3; k++)
        {
            const double impulse = other ? drag[3*i + k] + other[3*i + k] : drag[3*i + k];
            const double at = how == DEM_EXCHANGE_DEFERRED ? u[3*i + k] : p->record[i].v[k];

            force[3*i + k] = dem_exchange_force(coefficient[i], at, how == DEM_EXCHANGE_SEMI_IMPLICIT ? drag[3*i + k] : 0.0, impulse, window);
        }
    }
    return DEM_OK;
}

double dem_fluid_relaxation(const struct dem *d)
{
    const struct dem_parts *const p = &d->parts;
    const double *const time = dem_column(&p->particles, DEM_COLUMN_DRAG_TIME);
    double most = 0.0;

    for (size_t i = 0; time && p->window > 0.0 && i < p->particles.n; i++)
    {
        const double rate = dem_exchange_rate(time[i], p->window, p->particles.record[i].inverse_mass);

        most = rate > most ? rate : most;
    }
    return most;
}

double dem_sauter(double volume, double per_diameter)
{
    return dem_exchange_sauter(volume, per_diameter);
}
