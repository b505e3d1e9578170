/*
 * sweep_contacts.c -- for each batch of contact rows: gather the partners, apply the effects of the
 * class (contact_effects.c), store one contact force a row. Where few rows touch, a stretch of rows at a time
 * (touching_rows.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sweep_contacts.h"
#include "core/math.h"
#include "core/memory.h"
#include "step/contact_effects.h"
#include "step/contact_scalars.h"
#include "records/lost_cause.h"
#include "step/fill_batch.h"
#include "step/store_forces.h"
#include "step/touching_rows.h"
#include "step/wall_bodies.h"
#include "step/wall_springs.h"
#include "step/limits.h"
#include "records/energy_balance.h"
#include "records/lost_particles.h"
#include "records/bonds.h"
#include "records/wall_wear.h"
#include <string.h>

/* ---- crossing a wall ------------------------------------------------------------------------- */

/* 1 when the particle's centre was on the other side of its wall a step ago: it moves away from the
   wall by more than its distance. */
static inline double crossed(const struct dem_contact_batch *restrict b, int c)
{
    return dem_select(b->vn[c]*b->dt > b->min_radius[c] - b->overlap[c], b->touching[c], 0.0);
}

DEM_KERNEL
static double count_crossings(const struct dem_contact_batch *restrict b)
{
    double count = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        count += crossed(b, c);
    }
    return count;
}

/* Triangles have two sides, and a solid cylinder or sphere that is thinner than a particle. */
static int has_two_sides(const struct dem_facet *r)
{
    return r->shape == DEM_SHAPE_TRIANGLES || (r->shape != DEM_SHAPE_PLANE && r->outside);
}

static int list_crossings(struct dem_state *state, const struct dem_contact_workspace *t,
                          uint32_t row, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row + (uint32_t)c);

        if (crossed(&t->batch, c) > 0.0
            && has_two_sides(&state->walls.facet[dem_pairs_facet(&state->pairs, q->j)]))
        {
            DEM_TRY(DEM_GROW(state->lost_particles->crossed,
                             state->lost_particles->crossed_capacity,
                             state->lost_particles->crossings + 1));
            state->lost_particles->crossed[state->lost_particles->crossings++] = row + (uint32_t)c;
        }
    }
    return DEM_OK;
}

/* ---- the sweep ------------------------------------------------------------------------------- */

static void store_energies(struct dem_contacts *c, const struct dem_contact_batch *b, uint32_t row,
                           int rows)
{
    for (int k = 0; k < rows; k++)
    {
        c->forces.energy[row + (uint32_t)k] = (struct dem_contact_energy){
            .stored = b->stored[k],
            .lost = b->lost[k],
            .bonds = b->bonds[k],
            .broke = b->broke[k]};
    }
}

DEM_KERNEL
static double count_broken(const struct dem_contact_batch *restrict b)
{
    double count = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        count += b->broke[c];
    }
    return count;
}

struct rows    /* of a batch: the first, their number, where their forces are stored */
{
    uint32_t row;
    int rows;
    struct dem_batch_forces to;
};

/* A batch: gather, apply the effects, store the forces. */
static int sweep_batch(struct dem_state *state, struct dem_contact_workspace *t,
                       const struct dem_effect_list *effects, const struct rows *at)
{
    const uint32_t row = at->row;
    const int rows = at->rows;

    dem_contact_batch_fill(t, state, effects, row, rows);
    if (t->scalars)
    {
        dem_contact_scalars_gather(t->scalars, state, &t->batch, row, rows);
    }
    if (effects->past_touching)
    {
        dem_contact_effects_replace_contacts(t, effects, &state->contacts.history, row);
    }
    if (state->energy_balance->open)
    {
        dem_contact_effects_apply_with_energy(state, t, effects, row, rows);
    }
    else
    {
        dem_contact_effects_apply(t, effects, &state->contacts.history, row);
    }
    if (effects->pair.with_wall && state->walls.bodies > 0)
    {
        dem_wall_bodies_add_batch(state, &t->batch, effects, row, rows);
    }
    if (effects->pair.with_wall && state->walls.wearing > 0)
    {
        DEM_TRY(dem_wall_wear_add(state, t, row, rows));
    }
    if (effects->past_touching && count_broken(&t->batch) > 0.0)
    {
        DEM_TRY(dem_bonds_record(state, &t->batch, row, rows));
    }
    if (dem_store_forces(&t->batch, effects->pair.with_wall ? 1.0 : 0.5, effects->past_touching,
                         state->limits.overlap, at->to))
    {
        dem_limits_check_record(state, t, state->contacts.rows.pair + row, rows);
    }
    if (effects->past_touching)
    {
        store_energies(&state->contacts, &t->batch, row, rows);
    }
    return effects->pair.with_wall && count_crossings(&t->batch) > 0.0
               ? list_crossings(state, t, row, rows)
               : DEM_OK;
}

/* The same for a class with effects that read or change particle scalars. */
static int sweep_batch_with_scalars(struct dem_state *state, struct dem_contact_workspace *t,
                                    const struct dem_effect_list *effects, const struct rows *at)
{
    struct dem_contact_scalars scalars;

    t->scalars = &scalars;
    const int status = sweep_batch(state, t, effects, at);

    t->scalars = NULL;
    dem_contact_scalars_store(&scalars, &state->contacts, at->row, at->rows);
    if (state->energy_balance->open && state->energy_balance->heat >= 0)
    {
        dem_energy_balance_contact_heat(
            state, &t->batch,
            &(struct dem_energy_balance_rows){.list = effects, .row = at->row, .rows = at->rows},
            scalars.rate[0][state->energy_balance->heat]);
    }
    return status;
}

/* Sum the particles that no contact row from `rows` on acts on, and kick them if the pass does. */
static void finish_ready(struct dem_body_pass *bodies, const struct dem_contacts *c, uint32_t rows)
{
    while (bodies->next < bodies->particles->n &&
           c->rows.needed[bodies->next/DEM_BATCH_ROWS] <= rows)
    {
        dem_bodies_work_until(bodies, bodies->next + 1);
    }
}

/* All batches of a pair class; with `bodies`, particles are worked on as soon as they can be.
   *deferred: deferred rows copied so far, over all classes. */
static int sweep_class(struct dem_state *state, struct dem_contact_workspace *t, int class,
                       size_t *deferred, struct dem_body_pass *bodies)
{
    const struct dem_effect_list *const effects = &state->interaction_table.list[class];
    const struct dem_segment *const seg = &state->contacts.rows.segment[class];
    struct dem_contact_forces *const forces = &state->contacts.forces;
    const int with_wall = effects->pair.with_wall, observed = !bodies || !bodies->unobserved,
              compact = dem_touching_rows_pay(state, effects);
    const uint32_t most = compact ? DEM_STRETCH_ROWS : DEM_BATCH_ROWS, end = seg->first + seg->count;
    int rows;

    for (uint32_t row = seg->first; row < end; row += (uint32_t)rows)
    {
        /* no stretch crosses the end of the force buffer */
        rows = (int)(end - row < most - row%most ? end - row : most - row%most);
        const struct rows at = {
            .row = row,
            .rows = rows,
            .to = dem_store_target(forces, dem_contact_forces_slot(forces, seg, with_wall, row))};

        if (compact)
        {
            dem_touching_rows_sweep(state, t, effects, row, rows, &at.to);
        }
        else if (effects->scalars)
        {
            DEM_TRY(sweep_batch_with_scalars(state, t, effects, &at));
        }
        else
        {
            DEM_TRY(sweep_batch(state, t, effects, &at));
        }
        if (observed)
        {
            dem_store_observed(&state->contacts, &at.to, row, rows, state->particles.n);
        }
        if (!with_wall)
        {
            *deferred = dem_store_deferred(forces, *deferred, row + (uint32_t)rows);
        }
        if (bodies && !with_wall)
        {
            finish_ready(bodies, &state->contacts, row + (uint32_t)rows);
        }
    }
    return DEM_OK;
}

int dem_sweep_contacts_and_bodies(struct dem_state *state, double dt, const double time[2],
                                  struct dem_body_pass *bodies)
{
    struct dem_contact_workspace t;
    size_t deferred = 0;

    memset(&t, 0, sizeof t);
    state->contacts.forces.touching = 0;
    t.batch.dt = dt;
    t.batch.max_dt = state->max_dt;
    t.batch.previous_time = time[0];
    t.batch.time = time[1];
    dem_wall_touches_update(&state->touches, &state->pairs.wall_search, &state->walls,
                            &state->particles);
    dem_wall_springs_redistribute(state);
    if (state->walls.bodies > 0)
    {
        dem_wall_bodies_begin_sweep(&state->walls);
    }
    if (state->energy_balance->open)
    {
        dem_energy_balance_begin_sweep(state);
    }
    for (int walls = 1; walls >= 0; walls--)
    {
        for (int s = 0; s < state->contacts.rows.classes; s++)
        {
            if (state->interaction_table.list[s].pair.with_wall == walls)
            {
                DEM_TRY(sweep_class(state, &t, s, &deferred, bodies));
            }
        }
        /* particles that crossed a wall are reported with their present speed: from here on they are
           summed only, and kicked after the report */
        if (bodies && state->lost_particles->crossings > 0)
        {
            bodies->unobserved = 0;
            bodies->work = DEM_BODIES_SUM;
        }
    }
    DEM_TRY(dem_lost_cause_record_crossings(state));
    return dem_limits_check_status(state);
}

int dem_sweep_contacts_and_sum(struct dem_state *state, double dt, const double time[2])
{
    const struct dem_body_sweep sums = {.contacts = &state->contacts, .sums_first = 1};
    struct dem_body_pass pass;

    dem_bodies_begin_pass(&pass, &state->particles, &state->interaction_table.bodies, &sums);
    const int status = dem_sweep_contacts_and_bodies(state, dt, time, &pass);

    dem_bodies_finish_sums(&pass);
    return status;
}
