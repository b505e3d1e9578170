/*
 * body_window.c -- begin and end of a coupling window: constants of the body effects, and the
 * response of each particle to the fluid.
 *
 *   R = r |J|/|u - v(start)|, between r m E/gamma and r B; r B for a frozen particle  [kg]
 *   q = 1 - m E/(gamma B), 0 for a frozen particle                              [1]
 *
 *   J      impulse of drag in the window                                        [N s]
 *   E      1 - product of exp(-gamma b h/m) over the steps h                    [1]
 *   B      sum of b h, b the drag coefficient                                   [kg]
 *   gamma  slip factor: the slip is u - v(start) - gamma (v - v(start))         [1]
 *   r      slip of the law over the slip of the exchange, DEM_OWN_WAKE_DRAG     [1]
 *   m      inertial mass, with added mass                                       [kg]
 *   q      fraction of a steady force that drag passes on to the fluid
 *
 * Added mass a adds a m_i/m to R, with m_i the mass alone, and a for a frozen particle.
 * docs/theory-coupling.md, "Exchange", has the reasons.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/body_window.h"
#include "particles/scalars.h"
#include "step/body_batch.h"
#include "step/eddies.h"
#include "step/parcel_forces.h"
#include <math.h>
#include <string.h>

/* A slip of this part of its terms is rounding: u is a sum over up to thousands of cells, each with 2e-16, in an order
   that depends on the ranks. */
#define SLIP_ROUNDING 1e-12

/* prepare_bodies of all effects; on grains, where the particles are parcels. */
static void prepare_effects(struct dem_body_batch *b, const struct dem_particles *particles,
                            const struct dem_effect_list *effects, size_t first, int rows)
{
    double ratio[DEM_BATCH_ROWS];

    for (int c = 0; effects->grains && c < DEM_BATCH_ROWS; c++)
    {
        const size_t i = first + (size_t)(c < rows ? c : 0);

        ratio[c] = dem_scalar_values(particles, effects->parcel_scalar)[i];
    }
    for (int k = 0; k < effects->entries; k++)
    {
        const struct dem_effect_entry *const e = &effects->entry[k];

        if (e->effect->prepare_bodies && e->grains)
        {
            dem_parcels_prepare(e, b, ratio);
        }
        else if (e->effect->prepare_bodies)
        {
            e->effect->prepare_bodies(e->settings, b);
        }
    }
}

void dem_bodies_window_constants(struct dem_particles *particles,
                                 const struct dem_effect_list *effects)
{
    const int voidage = dem_column(particles, DEM_COLUMN_VOIDAGE_FACTOR_FIRST) != NULL,
              added = dem_column(particles, DEM_COLUMN_ADDED_MASS) != NULL;
    struct dem_body_workspace t;

    memset(&t, 0, sizeof t);
    for (size_t first = 0; (voidage || added) && first < particles->n; first += DEM_BATCH_ROWS)
    {
        const int rows = dem_body_batch_rows(particles, first);

        dem_body_batch_load_forces(&t, particles, first, rows);
        dem_body_batch_gather(&t, particles, first, rows, 0);
        dem_body_batch_gather_fluid(&t, particles, first, rows, 0.0);
        memset(t.batch.added_mass, 0, sizeof t.batch.added_mass);
        prepare_effects(&t.batch, particles, effects, first, rows);
        if (voidage)
        {
            dem_body_batch_store_voidage_factors(&t, particles, first, rows);
        }
        if (added)
        {
            dem_body_batch_store_added_mass(&t, particles, first, rows);
        }
    }
}

static void clear(struct dem_particles *particles, enum dem_column_name column)
{
    if (dem_column(particles, column))
    {
        memset(dem_column(particles, column), 0,
               (size_t)particles->column[column].width*particles->n*sizeof(double));
    }
}

void dem_bodies_begin_window(struct dem_particles *particles, const struct dem_effect_list *effects)
{
    if (!dem_column(particles, DEM_COLUMN_FLUID_VELOCITY))
    {
        return;
    }
    dem_bodies_window_constants(particles, effects);
    clear(particles, DEM_COLUMN_DRAG_IMPULSE);
    clear(particles, DEM_COLUMN_OTHER_IMPULSE);
    clear(particles, DEM_COLUMN_ANGULAR_IMPULSE);
    clear(particles, DEM_COLUMN_DRAG_INTEGRAL);
    for (size_t i = 0; i < particles->n; i++)
    {
        dem_column(particles, DEM_COLUMN_DECAY_FACTOR)[i] = 1.0;
        memcpy(dem_column(particles, DEM_COLUMN_START_VELOCITY) + 3*i, particles->record[i].v,
               sizeof particles->record[i].v);
        memcpy(dem_column(particles, DEM_COLUMN_DISPLACEMENT) + 3*i, particles->record[i].x,
               sizeof particles->record[i].x);
    }
}

/* Displacement over the window. A wrapped particle has moved by less than half a box. */
static void displacements(struct dem_particles *particles, const struct dem_domain *domain)
{
    double *const displacement = dem_column(particles, DEM_COLUMN_DISPLACEMENT);

    for (size_t i = 0; i < 3*particles->n; i++)
    {
        const double length = domain->length[i%3],
                     moved = particles->record[i/3].x[i%3] - displacement[i];

        displacement[i] = moved - (length > 0.0 ? length*nearbyint(moved/length) : 0.0);
    }
}

/* R_a = a m/(m + a) for a free particle, a for a frozen one. */
static void response_of_added_mass(struct dem_particles *particles, double window)
{
    const double *const added = dem_column(particles, DEM_COLUMN_ADDED_MASS),
                        *const change = dem_column(particles, DEM_COLUMN_FLUID_CHANGE);

    for (size_t i = 0; added && i < particles->n; i++)
    {
        const struct dem_particle *const r = &particles->record[i];
        const double response = added[i]*(r->inverse_mass > 0.0 ? r->mass*r->inverse_mass : 1.0);

        dem_column(particles, DEM_COLUMN_RESPONSE)[i] += response;
        for (size_t k = 3*i; k < 3*i + 3; k++)
        {
            dem_column(particles, DEM_COLUMN_PREDICTED_ADDED_IMPULSE)[k] =
                response*change[k]*window;
            dem_column(particles, DEM_COLUMN_OTHER_IMPULSE)[k] -=
                dem_column(particles, DEM_COLUMN_PREDICTED_ADDED_IMPULSE)[k];
        }
    }
}

/* |u - v(start)|, u of the undisturbed fluid with its eddies; at least the rounding of its terms. */
static double slip_at_start(const struct dem_particles *particles, size_t i)
{
    const double *const u = dem_column(particles, DEM_COLUMN_FLUID_VELOCITY) + 3*i,
                        *const start = dem_column(particles, DEM_COLUMN_START_VELOCITY) + 3*i,
                        *const wake = dem_column(particles, DEM_COLUMN_OWN_WAKE);
    double eddy[3], sum = 0.0, scale = 0.0;

    dem_eddies_velocity(particles, i, eddy);
    for (size_t axis = 0; axis < 3; axis++)
    {
        const double own = wake ? wake[DEM_OWN_WAKE_WIDTH*i + axis] : 0.0,
                     slip = u[axis] - own + eddy[axis] - start[axis];

        sum += slip*slip;
        scale += u[axis]*u[axis] + own*own + eddy[axis]*eddy[axis] + start[axis]*start[axis];
    }
    return sqrt(fmax(sum, SLIP_ROUNDING*SLIP_ROUNDING*scale));
}

void dem_bodies_end_window(struct dem_particles *particles, const struct dem_domain *domain,
                           double window)
{
    const double *const impulse = dem_column(particles, DEM_COLUMN_DRAG_IMPULSE);

    if (!dem_column(particles, DEM_COLUMN_FLUID_VELOCITY))
    {
        return;
    }
    for (size_t i = 0; i < particles->n; i++)
    {
        const double *const J = impulse + 3*i;
        const double *const own = dem_column(particles, DEM_COLUMN_OWN_WAKE);
        const double law = own ? 1.0 + own[DEM_OWN_WAKE_WIDTH*i + DEM_OWN_WAKE_DRAG] : 1.0;
        const double slip_factor = dem_column(particles, DEM_COLUMN_SLIP_FACTOR)[i],
                     drag_integral = dem_column(particles, DEM_COLUMN_DRAG_INTEGRAL)[i],
                     slip = slip_at_start(particles, i),
                     drag = sqrt(J[0]*J[0] + J[1]*J[1] + J[2]*J[2]);
        const double inverse_mass = particles->record[i].inverse_mass;
        const double free =                                                     /* m E */
            inverse_mass > 0.0
                ? (1.0 - dem_column(particles, DEM_COLUMN_DECAY_FACTOR)[i])/inverse_mass
                : 0.0;
        const double most = drag_integral*slip, least = free/slip_factor,
                     response = inverse_mass == 0.0 || drag > most ? drag_integral
                                : slip > 0.0                       ? drag/slip
                                                                   : 0.0;

        dem_column(particles, DEM_COLUMN_RESPONSE)[i] = law*(response > least ? response : least);
        dem_column(particles, DEM_COLUMN_TRANSMITTED_FRACTION)[i] =
            free > 0.0 ? 1.0 - free/(slip_factor*drag_integral) : 0.0;
    }
    response_of_added_mass(particles, window);
    displacements(particles, domain);
}
