/*
 * energy_balance.c -- elastic energy and heat of the contact rows of a sweep, effect by effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/energy_balance.h"
#include "core/math.h"
#include "core/memory.h"
#include "ranks/dem_state.h"
#include "contacts/contact_batch.h"
#include <math.h>
#include <string.h>

/* ---- opening --------------------------------------------------------------------------------- */

int dem_energy_balance_open(struct dem_energy_balance *l, const struct dem_interaction_table *r)
{
    DEM_TRY(DEM_NEW(l->sum, DEM_ENERGY_BALANCE_SUMS));
    DEM_TRY(DEM_NEW(l->scratch, 1));
    for (int k = 0; k < r->chosen; k++)
    {
        l->scratch->effect[k] = r->effect[k];
    }
    for (int k = 0; k < DEM_HISTORY_COLUMNS; k++)
    {
        l->scratch->before[k] = l->scratch->column[k];
    }
    dem_interaction_table_gravity(r, l->gravity);
    l->heat = -1;
    for (int k = 0; k < r->scalars; k++)
    {
        l->heat = r->scalar[k]->flags & DEM_SCALAR_HEAT ? k : l->heat;
    }
    l->open = l->sums_elastic = 1;
    return DEM_OK;
}

int dem_energy_balance_watch_walls(struct dem_energy_balance *l, const struct dem_walls *w)
{
    DEM_TRY(w->passing > 0 ? DEM_NEW(l->wall_elastic, w->walls) : DEM_OK);
    for (int k = 0; l->wall_elastic && k < w->walls; k++)
    {
        dem_sum_clear(&l->wall_elastic[k]);
    }
    return DEM_OK;
}

void dem_energy_balance_free(struct dem_energy_balance *l)
{
    dem_memory_free(l->wall_elastic);
    dem_memory_free(l->backup);
    dem_memory_free(l->sum);
    dem_memory_free(l->scratch);
    memset(l, 0, sizeof *l);
}

struct dem_sum *dem_energy_balance_sums_of(const struct dem_energy_balance *l,
                                           const struct dem_effect *effect)
{
    int k = 0;

    while (l->scratch->effect[k] != effect)
    {
        k++;
    }
    return l->sum + k*DEM_ENERGY_BALANCE_SUMS_PER_EFFECT;
}

/* ---- backup ---------------------------------------------------------------------------------- */

int dem_energy_balance_backup(struct dem_energy_balance *l, int walls)
{
    if (!l->open)
    {
        return DEM_OK;
    }
    DEM_TRY(l->backup ? DEM_OK : DEM_NEW(l->backup, DEM_ENERGY_BALANCE_SUMS + walls));
    memcpy(l->backup, l->sum, DEM_ENERGY_BALANCE_SUMS*sizeof *l->sum);
    if (l->wall_elastic)
    {
        memcpy(l->backup + DEM_ENERGY_BALANCE_SUMS, l->wall_elastic, (size_t)walls*sizeof *l->sum);
    }
    l->backup_edited = l->edited;
    l->backup_edits = l->edits;
    return DEM_OK;
}

void dem_energy_balance_restore(struct dem_energy_balance *l, int walls)
{
    if (!l->backup)
    {
        return;
    }
    memcpy(l->sum, l->backup, DEM_ENERGY_BALANCE_SUMS*sizeof *l->sum);
    if (l->wall_elastic)
    {
        memcpy(l->wall_elastic, l->backup + DEM_ENERGY_BALANCE_SUMS, (size_t)walls*sizeof *l->sum);
    }
    l->edited = l->backup_edited;
    l->edits = l->backup_edits;
}

void dem_energy_balance_swap(struct dem_energy_balance *l)
{
    struct dem_sum *const sum = l->sum;

    l->sum = l->backup;
    l->backup = sum;
}

/* ---- before an effect acts ------------------------------------------------------------------- */

void dem_energy_balance_begin_sweep(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;

    for (int k = 0; l->wall_elastic && k < state->walls.walls && l->sums_elastic; k++)
    {
        if (!state->walls.wall[k].absent)
        {
            dem_sum_clear(&l->wall_elastic[k]);
        }
    }
    for (int k = 0; k < DEM_EFFECT_LIST_LIMIT && l->sums_elastic; k++)
    {
        dem_sum_clear(&l->sum[k*DEM_ENERGY_BALANCE_SUMS_PER_EFFECT + DEM_ENERGY_BALANCE_ELASTIC]);
    }
}

/* Effective inertia of a moment and effective mass of a tangential force at the contact point;
   lever arms as in geometry.h. Lanes of padding repeat the last row. */
static void inertias(struct dem_state *state, const struct dem_contact_batch *b,
                     const struct dem_energy_balance_rows *r)
{
    struct dem_energy *const e = &state->energy_balance->scratch->energy;

    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        const struct dem_pair *const q =
            dem_contacts_pair(&state->contacts, r->row + (uint32_t)(c < r->rows ? c : r->rows - 1));
        const struct dem_particle *const i = &state->particles.record[q->i],
                                  *const j = q->wall ? NULL : &state->particles.record[q->j];
        const double depth = (j ? 0.5 : 1.0)*b->overlap[c], a = i->radius - depth, other = j ? j->radius - depth : 0.0;
        const double turn = i->inverse_inertia + (j ? j->inverse_inertia : 0.0), move = i->inverse_mass + (j ? j->inverse_mass : 0.0);
        const double slip = move + a*a*i->inverse_inertia + (j ? other*other*j->inverse_inertia : 0.0);

        e->inertia[c] = turn > 0.0 ? 1.0/turn : HUGE_VAL;
        e->slip_mass[c] = slip > 0.0 ? 1.0/slip : HUGE_VAL;
    }
}

/* The overlap before the drift: over the drift the distance has grown by dt v.h. A row that is
   apart now may have had an overlap. */
void dem_energy_balance_begin_batch(struct dem_state *state, const struct dem_contact_workspace *t,
                                    const struct dem_energy_balance_rows *r)
{
    struct dem_energy_balance_scratch *const s = state->energy_balance->scratch;
    const struct dem_contact_batch *const b = &t->batch;
    const struct dem_gathered *const g = &t->gathered;

    for (int c = 0; c < b->n; c++)
    {
        const double distance = sqrt(g->rx[c]*g->rx[c] + g->ry[c]*g->ry[c] + g->rz[c]*g->rz[c]);
        const double raw = (r->list->pair.with_wall ? b->min_radius[c] : g->radii[c]) - distance;
        const double now = b->overlap[c] > 0.0 ? b->overlap[c] : raw;

        s->rate[c] = g->vx[c]*b->hx[c] + g->vy[c]*b->hy[c] + g->vz[c]*b->hz[c];
        s->energy.previous_overlap[c] = fmax(now + b->dt*s->rate[c], 0.0);
        s->energy.previous_kn[c] = 0.0;
    }
    inertias(state, b, r);
}

void dem_energy_balance_before_effect(struct dem_state *state, const struct dem_contact_workspace *t,
                                      const struct dem_energy_balance_rows *r)
{
    struct dem_energy_balance_scratch *const s = state->energy_balance->scratch;
    const struct dem_contact_batch *const b = &t->batch;

    for (int c = 0; c < b->n; c++)
    {
        s->then.fn[c] = b->fn[c];
        s->then.fx[c] = b->fx[c];
        s->then.fy[c] = b->fy[c];
        s->then.fz[c] = b->fz[c];
        s->then.mx[c] = b->mx[c];
        s->then.my[c] = b->my[c];
        s->then.mz[c] = b->mz[c];
        s->then.stored[c] = b->stored[c];
        s->then.lost[c] = b->lost[c];
        s->then.broke[c] = b->broke[c];
    }
    for (int m = 0; m < dem_effect_history_columns(r->entry->effect); m++)
    {
        memcpy(s->column[m], r->memory[m], (size_t)t->batch.n*sizeof *s->column[m]);
    }
}

/* ---- after it -------------------------------------------------------------------------------- */

/* Evaluate the normal law again with the overlap before the drift, also where partners have
   separated since. This overwrites the saved history columns. */
static void stiffness_before(struct dem_energy_balance_scratch *s,
                             const struct dem_contact_batch *b,
                             const struct dem_effect_entry *entry)
{
    struct dem_contact_batch *const was = &s->was;

    *was = *b;
    for (int c = 0; c < b->n; c++)
    {
        was->overlap[c] = s->energy.previous_overlap[c];
        was->touching[c] = s->energy.previous_overlap[c] > 0.0 ? 1.0 : 0.0;
        was->kn[c] = was->fn[c] = 0.0;
    }
    entry->effect->apply(entry->settings, was, s->before);
    memcpy(s->energy.previous_kn, was->kn, sizeof s->energy.previous_kn);
}

/* What the effect has added to forces, moments and energies of the batch. */
static void contribution(struct dem_energy_balance_scratch *s, const struct dem_contact_batch *b)
{
    struct dem_energy *const e = &s->energy;

    for (int c = 0; c < b->n; c++)
    {
        e->normal_force[c] = b->fn[c] - s->then.fn[c];
        e->mx[c] = b->mx[c] - s->then.mx[c];
        e->my[c] = b->my[c] - s->then.my[c];
        e->mz[c] = b->mz[c] - s->then.mz[c];
        e->stored[c] = b->stored[c] - s->then.stored[c];
        e->lost[c] = b->lost[c] - s->then.lost[c];
    }
}

/* The work of forces and moments on the relative motion of the drift, with the forces at its
   end. */
static void measure_work(struct dem_energy_balance_scratch *s, const struct dem_contact_batch *b)
{
    struct dem_energy *const e = &s->energy;

    for (int c = 0; c < b->n; c++)
    {
        const double along = e->normal_force[c]*s->rate[c];
        const double slip = (b->fx[c] - s->then.fx[c])*b->sx[c] + (b->fy[c] - s->then.fy[c])*b->sy[c]
                          + (b->fz[c] - s->then.fz[c])*b->sz[c];
        const double spin = e->mx[c]*b->wx[c] + e->my[c]*b->wy[c] + e->mz[c]*b->wz[c];

        e->lost[c] = -b->touching[c]*(along + slip + spin)*b->dt;
    }
}

void dem_energy_balance_after_effect(struct dem_state *state, const struct dem_contact_workspace *t,
                                     const struct dem_energy_balance_rows *r)
{
    struct dem_energy_balance *const l = state->energy_balance;
    struct dem_energy_balance_scratch *const s = l->scratch;
    const struct dem_contact_batch *const b = &t->batch;
    const struct dem_effect *const effect = r->entry->effect;
    struct dem_sum *const sum = dem_energy_balance_sums_of(l, effect);

    contribution(s, b);
    if (effect->energy)
    {
        effect->energy(r->entry->settings, b, s->before, r->memory, &s->energy);
    }
    else if (effect->stage < DEM_STAGE_BOND)
    {
        measure_work(s, b);
    }
    if (effect->stage == DEM_STAGE_NORMAL)
    {
        stiffness_before(s, b, r->entry);
    }
    for (int c = 0; c < r->rows; c++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, r->row + (uint32_t)c);

        if (l->wall_elastic && r->list->pair.with_wall && l->sums_elastic)
        {
            const int wall = state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall;

            dem_energy_balance_add(&l->wall_elastic[wall], s->energy.stored[c]);
        }
        if (q->i < state->particles.n)
        {
            const int broke = effect->stage == DEM_STAGE_BOND && b->broke[c] > s->then.broke[c];

            /* bonds that break in the sweep before the first step hold their energy until then */
            const double held = broke && !l->begun ? s->energy.lost[c] : 0.0;

            dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_ELASTIC], l->sums_elastic ? s->energy.stored[c] + held : 0.0);
            dem_energy_balance_add(broke ? &l->sum[DEM_ENERGY_BALANCE_BROKEN] : &sum[DEM_ENERGY_BALANCE_LOST], l->begun ? s->energy.lost[c] : 0.0);
        }
    }
}
