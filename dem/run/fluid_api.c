/*
 * fluid_api.c -- exchange with a coupled fluid: columns of fluid values at the particles, and
 * forces of particles on the fluid.
 *
 * Formulas: laws/fluid/particle_exchange.h; the response R of a particle: step/body_window.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_fluid.h"
#include "core/error.h"
#include "laws/fluid/particle_exchange.h"
#include "laws/fluid/viscosity.h"
#include "particles/scalars.h"
#include "records/totals.h"
#include <string.h>

int dem_needs_fluid(const struct dem *d)
{
    return d->with_fluid;
}

int dem_fluid(struct dem *d, struct dem_fluid *f)
{
    const struct dem_particles *const p = &d->state.particles;

    DEM_REQUIRE(!d->scene.fluid.given, DEM_ERROR_INPUT,
                "the scene gives a uniform fluid, but it is coupled to a running one; remove the "
                "entry fluid");
    d->coupled = 1;
    *f = (struct dem_fluid){.n = p->n,
                            .velocity = dem_column(p, DEM_COLUMN_FLUID_VELOCITY),
                            .pressure_gradient = dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT),
                            .void_fraction = dem_column(p, DEM_COLUMN_VOID_FRACTION),
                            .density = dem_column(p, DEM_COLUMN_FLUID_DENSITY),
                            .viscosity = dem_scalar_values_of(p, &d->state.interaction_table,
                                                              dem_fluid_viscosity.name),
                            .acceleration = dem_column(p, DEM_COLUMN_FLUID_ACCELERATION),
                            .vorticity = dem_column(p, DEM_COLUMN_VORTICITY),
                            .stress = dem_column(p, DEM_COLUMN_STRESS),
                            .tension = dem_column(p, DEM_COLUMN_TENSION),
                            .interface_distance = dem_column(p, DEM_COLUMN_INTERFACE_DISTANCE),
                            .mean_diameter = dem_column(p, DEM_COLUMN_MEAN_DIAMETER),
                            .turbulence = dem_column(p, DEM_COLUMN_TURBULENCE),
                            .other_impulse = dem_column(p, DEM_COLUMN_OTHER_IMPULSE),
                            .angular_impulse = dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE),
                            .slip_factor = dem_column(p, DEM_COLUMN_SLIP_FACTOR),
                            .location = dem_column(p, DEM_COLUMN_COUPLING_INDEX),
                            .drag_integral = dem_column(p, DEM_COLUMN_DRAG_INTEGRAL),
                            .drag_impulse = dem_column(p, DEM_COLUMN_DRAG_IMPULSE),
                            .response = dem_column(p, DEM_COLUMN_RESPONSE),
                            .displacement = dem_column(p, DEM_COLUMN_DISPLACEMENT),
                            .transmitted_fraction = dem_column(p, DEM_COLUMN_TRANSMITTED_FRACTION),
                            .carried_over_impulse = dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE),
                            .under_relaxation = dem_column(p, DEM_COLUMN_UNDER_RELAXATION),
                            .owed_pressure_impulse =
                                dem_column(p, DEM_COLUMN_OWED_PRESSURE_IMPULSE),
                            .own_wake = dem_column(p, DEM_COLUMN_OWN_WAKE)};
    return DEM_OK;
}

void dem_fluid_whole_drag(struct dem *d, int yes)
{
    d->state.interaction_table.bodies.whole_drag = yes;
}

int dem_sim_require_fluid_scalars(const struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;
    const struct dem_particles *const p = &d->state.particles;

    for (int k = 0; k < r->listed; k++)
    {
        const double *const value = dem_scalar_values(p, k);

        for (size_t i = 0; r->scalar[k]->fluid_entry && i < p->n; i++)
        {
            DEM_REQUIRE(value[i] > 0.0, DEM_ERROR_INPUT,
                        "the effects need the %s at the particles, and the coupled fluid gives %g %s "
                        "at particle %lld; remove the effect of heat transfer, or give the fluid "
                        "this property",
                        r->scalar[k]->name, value[i], r->scalar[k]->unit,
                        (long long)p->record[i].id);
        }
    }
    return DEM_OK;
}

/* Effects are in the order of stages: the last one that needs a fluid is a contact law only where
   its viscosity is all that is missing. */
int dem_require_fluid(const struct dem *d)
{
    if (!d->with_fluid || d->scene.fluid.given || d->coupled)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(!(dem_interaction_table_needs(&d->state.interaction_table) & DEM_NEEDS_INTERFACE), DEM_ERROR_INPUT,
                "an effect acts at the interface of two fluids, and there is no fluid; take that effect out, or run "
                "the case in demInterFoam");
    DEM_REQUIRE(d->fluid_user->needs & DEM_NEEDS_FLUID, DEM_ERROR_INPUT,
                "effects/%s has no viscosity, and there is no fluid; give effects/%s/viscosity, "
                "add fluid { density; viscosity; velocity; } or run it in OpenFOAM",
                d->fluid_user->name, d->fluid_user->name);
    return dem_error(DEM_ERROR_INPUT,
                     "effects/%s needs a fluid, and there is none; add fluid { density; "
                     "viscosity; velocity; } or run it in OpenFOAM", d->fluid_user->name);
}

double dem_fluid_under_relax(struct dem *d)
{
    const struct dem_particles *const p = &d->state.particles;
    const double *const added = dem_column(p, DEM_COLUMN_ADDED_MASS);
    const double *const void_fraction = dem_column(p, DEM_COLUMN_VOID_FRACTION);
    const double *const own = dem_column(p, DEM_COLUMN_OWN_WAKE);
    const double *const density = dem_column(p, DEM_COLUMN_FLUID_DENSITY);
    const double *const transmitted = dem_column(p, DEM_COLUMN_TRANSMITTED_FRACTION);
    double *const factor = dem_column(p, DEM_COLUMN_UNDER_RELAXATION);
    double min = 1.0;

    for (size_t i = 0; factor && i < p->n; i++)
    {
        const struct dem_particle *const r = &p->record[i];
        const double displaced = density[i]*dem_totals_volume(&d->state, r);
        const int moves = r->inverse_mass > 0.0 && displaced > 0.0;
        const double of_cells =
            void_fraction[i] - (own ? own[DEM_OWN_WAKE_WIDTH*i + DEM_OWN_WAKE_VOID] : 0.0);

        factor[i] = moves ? dem_exchange_under_relaxation(of_cells, r->mass/displaced,
                                                          added ? added[i]/displaced : 0.0,
                                                          transmitted[i])
                          : 1.0;
        min = factor[i] < min ? factor[i] : min;
    }
    return min;
}

int dem_fluid_correct(struct dem *d, const double *velocity, const double *pressure_gradient)
{
    struct dem_particles *const p = &d->state.particles;
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY);
    const double *const g = dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT);
    const double *const R = dem_column(p, DEM_COLUMN_RESPONSE);
    const double *const transmitted = dem_column(p, DEM_COLUMN_TRANSMITTED_FRACTION);
    const double *const predicted = dem_column(p, DEM_COLUMN_PREDICTED_ADDED_IMPULSE);
    double *const carried_over = dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE);
    double *const change = dem_column(p, DEM_COLUMN_FLUID_CHANGE);

    DEM_REQUIRE(u, DEM_ERROR_STATE, "dem_fluid_correct without fluid effects");
    for (size_t i = 0; i < p->n; i++)
    {
        const double volume = d->pressure_gradient
                                  ? dem_totals_volume(&d->state, &p->record[i])
                                  : 0.0;
        const double Q = transmitted[i]*volume*d->state.window.length;

        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            carried_over[k] = R[i]*(velocity[k] - u[k]) + Q*(pressure_gradient[k] - g[k])
                            - (predicted ? predicted[k] : 0.0);
            if (change)
            {
                change[k] = (velocity[k] - u[k])/d->state.window.length;
            }
        }
    }
    return DEM_OK;
}

/* ---- forces on the fluid --------------------------------------------------------------------- */

double dem_fluid_slip_factor(const struct dem *d, double void_fraction)
{
    return dem_exchange_slip_factor(void_fraction, d->state.interaction_table.bodies.whole_drag);
}

int dem_fluid_reaction(const struct dem *d, double window, double *coefficient, double *force)
{
    const struct dem_particles *const p = &d->state.particles;
    const double *const drag = dem_column(p, DEM_COLUMN_DRAG_IMPULSE);
    const double *const other = dem_column(p, DEM_COLUMN_OTHER_IMPULSE);
    const double *const u = dem_column(p, DEM_COLUMN_FLUID_VELOCITY);
    const double *const response = dem_column(p, DEM_COLUMN_RESPONSE);

    DEM_REQUIRE(u, DEM_ERROR_STATE, "dem_fluid_reaction without fluid effects");
    DEM_REQUIRE(window > 0.0, DEM_ERROR_INPUT,
                "dem_fluid_reaction: a window of %g s; give a time above 0", window);
    for (size_t i = 0; i < p->n; i++)
    {
        coefficient[i] = response[i]/window;
        for (size_t k = 0; k < 3; k++)
        {
            const double impulse = other ? drag[3*i + k] + other[3*i + k] : drag[3*i + k];

            force[3*i + k] = dem_exchange_force(coefficient[i], u[3*i + k], impulse, window);
        }
    }
    return DEM_OK;
}

void dem_fluid_following(const struct dem *d, double *coefficient)
{
    const struct dem_particles *const p = &d->state.particles;
    const double *const density = dem_column(p, DEM_COLUMN_FLUID_DENSITY);

    for (size_t i = 0; density && i < p->n; i++)
    {
        const struct dem_particle *const r = &p->record[i];
        const double displaced = density[i]*dem_totals_volume(&d->state, r);

        if (r->inverse_mass == 0.0 || r->mass >= DEM_EXCHANGE_LIGHT*displaced)
        {
            coefficient[i] = 0.0;
        }
    }
}

void dem_fluid_interface_force(const struct dem *d, double *force)
{
    const struct dem_particles *const p = &d->state.particles;
    const struct dem_effect_list *const effects = &d->state.interaction_table.bodies;
    const double *const tension = dem_column(p, DEM_COLUMN_TENSION),
                 *const distance = dem_column(p, DEM_COLUMN_INTERFACE_DISTANCE);

    for (size_t first = 0; first < p->n; first += DEM_BATCH_ROWS)
    {
        const int rows = p->n - first < DEM_BATCH_ROWS ? (int)(p->n - first) : DEM_BATCH_ROWS;
        struct dem_body_batch b = {.n = DEM_BATCH_ROWS};

        for (int c = 0; c < rows; c++)
        {
            const size_t i = first + (size_t)c;

            b.radius[c] = p->record[i].radius;
            b.tension_x[c] = tension[3*i];
            b.tension_y[c] = tension[3*i + 1];
            b.tension_z[c] = tension[3*i + 2];
            b.interface_distance[c] = distance[i];
        }
        for (int k = 0; k < effects->entries; k++)
        {
            if (effects->entry[k].effect->needs & DEM_NEEDS_INTERFACE)
            {
                effects->entry[k].effect->apply_to_bodies(effects->entry[k].settings, &b);
            }
        }
        for (int c = 0; c < rows; c++)
        {
            memcpy(force + 3*(first + (size_t)c), (double[3]){b.fx[c], b.fy[c], b.fz[c]},
                   3*sizeof *force);
        }
    }
}

double dem_fluid_relaxation(const struct dem *d)
{
    const struct dem_state *const state = &d->state;
    const double *const drag_integral = dem_column(&state->particles, DEM_COLUMN_DRAG_INTEGRAL);
    double max = 0.0;

    for (size_t i = 0; drag_integral && state->window.length > 0.0 && i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        /* B and mass of a sphere of a body are the same share of the body's */
        const double per_mass = r->flags & DEM_PARTICLE_FROZEN ? 0.0 : r->body ? 1.0/r->mass : r->inverse_mass,
                     rate = dem_exchange_rate(drag_integral[i], state->window.length, per_mass);

        max = rate > max ? rate : max;
    }
    return max;
}

double dem_sauter_diameter(double volume, double per_diameter)
{
    return dem_exchange_sauter(volume, per_diameter);
}
