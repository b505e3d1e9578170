/*
 * energy_work.c -- energy balance: the work of gravity, of moving walls and of body forces, the
 * energy of particles that enter or leave, and the heat content of the particles:
 *
 *   sum C (T - T_start) = heated + walls + bodies - left + came
 *
 *   C, T      heat capacity, temperature: the particle scalar with DEM_SCALAR_HEAT    [J/K], [K]
 *   heated    dissipated in contacts, where an effect makes heat of it                [J]
 *   walls     received at walls, less what was dissipated there: below 0 where walls receive    [J]
 *   bodies    received from the fluid and the program                                 [J]
 *
 * Both sides are exact sums of what each step adds, so they differ by the rounding of T alone: 3e-14 C
 * a particle and step at room temperature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/vec.h"
#include "particles/scalars.h"
#include "records/cell_stress.h"
#include "records/energy_balance.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <string.h>

/* Work of gravity over the drift. */
static void gravity_work(struct dem_state *state, double dt)
{
    const double *const g = state->energy_balance->gravity;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];
        const struct dem_clump *const b = dem_clump_of(&state->particles, i);
        const double mass = !b ? r->mass : dem_clump_counts(r) ? b->mass : 0.0;

        dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_GRAVITY],
                               mass*dem_vec_dot(g, b ? b->v : r->v)*dt);
    }
}

/* Work of what moves driven particles, against the contact forces of the last sweep over the time
   `span` [s], and against their weight over `fall` [s]. */
static void driven_work(struct dem_state *state, double span, double fall)
{
    const double *const force = dem_column(&state->particles, DEM_COLUMN_FORCE),
                 *const torque = dem_column(&state->particles, DEM_COLUMN_TORQUE);

    for (size_t i = 0; i < state->particles.n && state->energy_balance->driven; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];

        if (r->flags & DEM_PARTICLE_DRIVEN)
        {
            const double power =
                dem_vec_dot(force + 3*i, r->v) + dem_vec_dot(torque + 3*i, r->w);
            const double weight = r->mass*dem_vec_dot(state->energy_balance->gravity, r->v);

            dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_DRIVEN],
                                   -power*span - weight*fall);
        }
    }
}

void dem_energy_balance_after_drift(struct dem_state *state, double dt)
{
    gravity_work(state, dt);
    driven_work(state, 0.5*dt, dt);
}

void dem_energy_balance_after_sweep(struct dem_state *state, double dt)
{
    dem_cell_add_work(state, 0.5*dt);
    driven_work(state, 0.5*dt, 0.0);
}

/* The velocity at the time of the position, with gravity alone: outside the domain there are rarely
   contacts. */
void dem_energy_balance_particle_out(struct dem_state *state, const struct dem_particle *r, double late)
{
    const size_t i = (size_t)(r - state->particles.record);
    const struct dem_clump *const b = dem_clump_of(&state->particles, i);
    const double inverse = b ? 1.0/b->mass : r->inverse_mass;
    struct dem_particle_share s;
    double v[3];

    dem_particle_share(&state->particles, i, &s);
    for (int k = 0; k < 3; k++)
    {
        v[k] = (b ? b->v : r->v)[k] + late*s.mass*inverse*state->energy_balance->gravity[k];
    }
    dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_OUT],
                           0.5*s.mass*dem_vec_dot(v, v) + s.kinetic[1]);
    dem_energy_balance_add_content(state, i, 1.0,
                                   &state->energy_balance->sum[DEM_ENERGY_BALANCE_HEAT_OUT]);
}

void dem_energy_balance_particle_in(struct dem_state *state, const struct dem_particle *r)
{
    const size_t i = (size_t)(r - state->particles.record);
    struct dem_particle_share s;

    dem_particle_share(&state->particles, i, &s);
    dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_IN], s.kinetic[0] + s.kinetic[1]);
    dem_energy_balance_add_content(state, i, 1.0,
                                   &state->energy_balance->sum[DEM_ENERGY_BALANCE_HEAT_IN]);
}

/* ---- body forces ----------------------------------------------------------------------------- */

void dem_energy_balance_before_body_effect(struct dem_energy_balance *l,
                                           const struct dem_body_batch *b)
{
    for (int c = 0; c < b->n; c++)
    {
        l->scratch->force[0][c] = b->fx[c] + b->rx[c];
        l->scratch->force[1][c] = b->fy[c] + b->ry[c];
        l->scratch->force[2][c] = b->fz[c] + b->rz[c];
    }
}

void dem_energy_balance_after_body_effect(struct dem_energy_balance *l,
                                          const struct dem_body_batch *b, int entry)
{
    double (*const own)[DEM_BATCH_ROWS] = l->scratch->own[entry];

    for (int c = 0; c < b->n; c++)
    {
        own[0][c] = b->fx[c] + b->rx[c] - l->scratch->force[0][c];
        own[1][c] = b->fy[c] + b->ry[c] - l->scratch->force[1][c];
        own[2][c] = b->fz[c] + b->rz[c] - l->scratch->force[2][c];
    }
}

/* Impulse times the fluid's velocity is work of the fluid, the rest is heat; and the work of the
   impulse carried over from the last exchange. */
static void drag_work(struct dem_sum *sum, const struct dem_particles *p,
                      const struct dem_energy_balance_kick *k, int c, const double v[3])
{
    const struct dem_body_batch *const b = k->batch;
    const double *const impulse =
        dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE) + 3*(k->first + (size_t)c);
    const double j[3] = {k->j[0][c], k->j[1][c], k->j[2][c]}, u[3] = {b->ux[c], b->uy[c], b->uz[c]};
    const double work = dem_vec_dot(j, u),
                 carried_over = k->window > 0.0 ? dem_vec_dot(impulse, v)*k->h/k->window : 0.0;

    dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK], work + carried_over);
    dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_LOST], work - dem_vec_dot(j, v));
}

/* Work taken by the added mass: -a dv times the mean velocity. */
static double added_mass_work(const struct dem_particle *r, const struct dem_body_batch *b, int c,
                              const double v[3])
{
    const double gain[3] = {b->vx[c] - r->v[0], b->vy[c] - r->v[1], b->vz[c] - r->v[2]};

    return -b->added_mass[c]*dem_vec_dot(gain, v);
}

/* Impulse of rotational drag times the mean spin. */
static double rotational_work(const struct dem_particle *r, const struct dem_energy_balance_kick *k,
                              int c)
{
    const struct dem_body_batch *const b = k->batch;
    const double w[3] = {0.5*(r->w[0] + b->wx[c]), 0.5*(r->w[1] + b->wy[c]),
                         0.5*(r->w[2] + b->wz[c])};
    const double turn[3] = {k->spin_impulse[0][c], k->spin_impulse[1][c], k->spin_impulse[2][c]};

    return dem_vec_dot(turn, w);
}

void dem_energy_balance_after_kick(struct dem_energy_balance *l, const struct dem_particles *p,
                                   const struct dem_energy_balance_kick *k)
{
    for (int e = 0; e < k->effects->entries; e++)
    {
        const struct dem_effect *const effect = k->effects->entry[e].effect;
        struct dem_sum *const sum = dem_energy_balance_sums_of(l, effect);
        double (*const own)[DEM_BATCH_ROWS] = l->scratch->own[e];
        const int potential = effect->uniform_acceleration != NULL;    /* see gravity_work */

        for (int c = 0; c < k->rows && !potential; c++)
        {
            const struct dem_particle *const r = &p->record[k->first + (size_t)c];

            if (r->body)    /* step/clump_energy.c */
            {
                continue;
            }
            const double v[3] = {0.5*(r->v[0] + k->batch->vx[c]),
                                 0.5*(r->v[1] + k->batch->vy[c]),
                                 0.5*(r->v[2] + k->batch->vz[c])};
            const double f[3] = {own[0][c], own[1][c], own[2][c]};

            if (effect->drag && r->inverse_mass > 0.0)
            {
                drag_work(sum, p, k, c, v);
            }
            if (effect->has_added_mass)
            {
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK],
                                       added_mass_work(r, k->batch, c, v));
            }
            if (effect->has_rotational_drag)
            {
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK], rotational_work(r, k, c));
            }
            /* no force moves a driven particle */
            dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK],
                                   r->flags & DEM_PARTICLE_DRIVEN ? 0.0 : dem_vec_dot(f, v)*k->h);
        }
    }
}

/* ---- heat ------------------------------------------------------------------------------------ */

void dem_energy_balance_add_content(const struct dem_state *state, size_t particle, double sign,
                                    struct dem_sum *sum)
{
    const int k = state->energy_balance->heat;

    if (k >= 0)
    {
        const struct dem_particle *const q = &state->particles.record[particle];
        const double C = sign*dem_interaction_table_capacity(&state->interaction_table, k,
                                                             q->material, q->mass);
        const double T = dem_scalar_values(&state->particles, k)[particle], content = C*T;

        dem_energy_balance_add(sum, content);
        dem_energy_balance_add(sum, fma(C, T, -content));
    }
}

void dem_energy_balance_begin_heat(struct dem_state *state)
{
    struct dem_sum *const sum = state->energy_balance->sum;

    for (int k = DEM_ENERGY_BALANCE_CONTENT; k <= DEM_ENERGY_BALANCE_HEAT_IN; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        dem_energy_balance_add_content(state, i, -1.0, &sum[DEM_ENERGY_BALANCE_CONTENT]);
    }
}

void dem_energy_balance_contact_heat(struct dem_state *state, const struct dem_contact_batch *b,
                                     const struct dem_energy_balance_rows *r, const double *rate)
{
    struct dem_sum *const sum = state->energy_balance->sum;
    const int heats = (r->list->needs & DEM_NEEDS_DISSIPATION) != 0;

    for (int c = 0; c < r->rows && state->energy_balance->begun; c++)
    {
        const double heat = heats ? b->dissipated[c] : 0.0;

        if (dem_contacts_pair(&state->contacts, r->row + (uint32_t)c)->i < state->particles.n)
        {
            dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEATED], heat);
            if (r->list->pair.with_wall)
            {
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEAT_WALLS], rate[c]*b->dt);
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEAT_WALLS], -heat);
            }
        }
    }
}
