/*
 * flows.c -- insert arrivals, record departures, and keep the totals of streams and outlets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/flows.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include "particles/orientation.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include "particles/scalars.h"
#include "particles/uniform_fluid.h"
#include "records/energy_balance.h"
#include "sources/residence.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void dem_flows_free(struct dem_flows *f)
{
    dem_residence_free(f);
    dem_memory_free(f->arrival);
    dem_memory_free(f->departure);
    memset(f, 0, sizeof *f);
}

int dem_flows_due(const struct dem_state *state)
{
    return state->flows->n > 0 && !state->flows->asked && state->steps%DEM_FLOW_STEPS == 0 &&
           state->steps != state->flows->checked;
}

/* ---- beginning ------------------------------------------------------------------------------- */

/* The amount due that makes the debt of a stream zero: what it has inserted so far. */
static double inserted_so_far(const struct dem_snapshot_flow *row)
{
    return row->kind == DEM_FLOW_MASS_STREAM ? row->mass : (double)row->count;
}

/* Both are streams, or both the same. */
static int is_like(int64_t a, int64_t b)
{
    const int streams[2] = {a == DEM_FLOW_STREAM || a == DEM_FLOW_MASS_STREAM,
                            b == DEM_FLOW_STREAM || b == DEM_FLOW_MASS_STREAM};

    return a == b || (streams[0] && streams[1]);
}

/* Continue a flow from a snapshot. A stream whose rate or times were changed keeps the amount due
   and continues with the new ones. A stream that changed from particles to kilograms, or back,
   begins with nothing due. */
static void resume(struct dem_snapshot_flow *row, const struct dem_stream *s,
                   const struct dem_snapshot *from, double time)
{
    for (int64_t k = 0; from && k < from->flows; k++)
    {
        const struct dem_snapshot_flow *const old = &from->flow[k];

        if (strcmp(old->name, row->name) == 0 && is_like(old->kind, row->kind))
        {
            const struct dem_snapshot_flow new = *row;

            *row = *old;
            if (s && (old->kind != new.kind || old->rate != new.rate || old->start != new.start ||
                      old->end != new.end))
            {
                const struct dem_stream before = {
                    .at_once = s->at_once,
                    .rate = old->rate,
                    .start = old->start,
                    .end = old->end};

                row->kind = new.kind;
                row->owed = old->kind != new.kind
                                ? inserted_so_far(row)
                                : old->owed + dem_stream_amount_due(&before, old->since, time);
                row->since = time;
                row->rate = new.rate;
                row->start = new.start;
                row->end = new.end;
            }
        }
    }
}

static void add_flow(struct dem_flows *f, const char *name, int kind)
{
    struct dem_snapshot_flow *const row = &f->flow[f->n++];

    memset(row, 0, sizeof *row);
    snprintf(row->name, sizeof row->name, "%s", name);
    row->kind = kind;
}

int64_t dem_flows_first_free_id(const struct dem_state *state)
{
    int64_t next = 0;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        next = state->particles.record[i].id >= next ? state->particles.record[i].id + 1 : next;
    }
    dem_collect_max_int64(&state->decomposition, &next, 1);
    return next;
}

int dem_flows_begin(struct dem_state *state, const struct dem_streams *plan,
                    const struct dem_snapshot *from)
{
    struct dem_flows *const f = state->flows;

    f->plan = plan;
    f->n = 0;
    for (int k = 0; k < plan->streams; k++)
    {
        const struct dem_stream *const s = &plan->stream[k];

        add_flow(f, s->name, s->by_mass ? DEM_FLOW_MASS_STREAM : DEM_FLOW_STREAM);
        f->flow[k].rate = s->rate;
        f->flow[k].start = s->start;
        f->flow[k].end = s->end;
        f->flow[k].since = s->at_once ? fmin(state->time, s->start) : state->time;
        f->flow[k].last = state->time;
        resume(&f->flow[k], s, from, state->time);
    }
    for (int k = 0; k < plan->outlets; k++)
    {
        add_flow(f, plan->outlet[k].name, DEM_FLOW_OUTLET);
        resume(&f->flow[f->n - 1], NULL, from, state->time);
    }
    for (int k = 0; k < 2*plan->planes; k++)
    {
        add_flow(f, plan->plane[k/2].name, k%2 ? DEM_FLOW_BACK : DEM_FLOW_FORTH);
        resume(&f->flow[f->n - 1], NULL, from, state->time);
    }
    if (f->n == 0)
    {
        return DEM_OK;
    }
    state->energy_balance->flows = plan->streams + plan->outlets > 0;
    if (!from || from->flows == 0)
    {
        dem_flows_end_check(state);
    }
    add_flow(f, "domain", DEM_FLOW_OUTLET);
    resume(&f->flow[f->n - 1], NULL, from, state->time);
    f->next_id = dem_flows_first_free_id(state);
    f->next_id = from && from->next_id > f->next_id ? from->next_id : f->next_id;
    return DEM_OK;
}

/* ---- insertion ------------------------------------------------------------------------------- */

void dem_flows_begin_columns(struct dem_state *state, size_t i, const struct dem_uniform_fluid *fluid)
{
    struct dem_particles *const all = &state->particles;
    const struct dem_particle *const q = &all->record[i];

    dem_scalars_begin_particle(all, &state->interaction_table, i);
    dem_uniform_fluid_fill(all, i, fluid, 0.0);
    if (dem_column(all, DEM_COLUMN_BIRTH))
    {
        dem_column(all, DEM_COLUMN_BIRTH)[i] = state->time;
    }
    if (dem_column(all, DEM_COLUMN_FLUID_VELOCITY))
    {
        memcpy(dem_column(all, DEM_COLUMN_START_VELOCITY) + 3*i, q->v, sizeof q->v);
        memcpy(dem_column(all, DEM_COLUMN_DISPLACEMENT) + 3*i, q->x, sizeof q->x);
        dem_column(all, DEM_COLUMN_DECAY_FACTOR)[i] = 1.0;
    }
}

static int insert_sphere(struct dem_state *state, const struct dem_arrival *new,
                         const struct dem_particle *q, const struct dem_clump *body)
{
    const struct dem_stream *const s = &state->flows->plan->stream[new->stream];
    struct dem_particles *const all = &state->particles;
    const size_t i = all->n;

    DEM_TRY(dem_particles_add(all, q));
    if (body)
    {
        *dem_clump_at(all, i) = *body;
    }
    for (int k = 0; k < state->interaction_table.scalars; k++)
    {
        dem_scalar_values(all, k)[i] =
            dem_scalar_draw(&s->scalar[k], k, (uint64_t)s->seed, (uint64_t)new->number);
    }
    dem_flows_begin_columns(state, i, state->flows->fluid);
    if (state->energy_balance->open)
    {
        dem_energy_balance_particle_in(state, &all->record[i]);
    }
    return DEM_OK;
}

static int insert_particle(struct dem_state *state, const struct dem_arrival *new)
{
    const struct dem_stream *const s = &state->flows->plan->stream[new->stream];
    const double density = state->interaction_table.material[s->material].density;
    struct dem_clump body;

    if (!s->clump.shape)
    {
        return insert_sphere(state, new, &new->particle, NULL);
    }
    dem_clump_source_make(&s->clump, (uint64_t)s->seed, new->number, density, &new->particle, &body);
    for (size_t k = 0; k < s->clump.shape->n; k++)
    {
        struct dem_particle q =
            dem_clump_source_sphere(&s->clump, density, &new->particle, k, &body);

        dem_domain_wrap(&state->domain, &q);
        DEM_TRY(insert_sphere(state, new, &q, &body));
    }
    return DEM_OK;
}

int dem_flows_insert(struct dem_state *state)
{
    struct dem_flows *const f = state->flows;

    for (size_t k = 0; k < f->arrivals; k++)
    {
        const struct dem_particle *const q = &f->arrival[k].particle;

        if (state->decomposition.ranks == 1 ||
            dem_decomposition_owner(&state->decomposition, q->x) == state->decomposition.rank)
        {
            DEM_TRY(insert_particle(state, &f->arrival[k]));
        }
    }
    f->arrivals = 0;
    dem_orientation_begin(&state->particles);
    return DEM_OK;
}

/* ---- removal --------------------------------------------------------------------------------- */

int dem_flows_absorbed(const struct dem_flows *f, const struct dem_particle *q)
{
    const int mark = (q->flags & DEM_PARTICLE_ABSORBED) >> DEM_PARTICLE_ABSORBED_SHIFT;

    return mark > 0 && mark <= f->plan->outlets ? f->plan->streams + mark - 1 : DEM_FLOW_NONE;
}

int dem_flows_record_departure(struct dem_state *state, int flow, const struct dem_particle *q,
                               double late)
{
    struct dem_flows *const f = state->flows;
    const size_t i = (size_t)(q - state->particles.record);
    const struct dem_clump *const b = dem_clump_of(&state->particles, i);
    const double inverse = b ? 1.0/b->mass : q->inverse_mass;
    struct dem_particle_share share;
    double gravity[3], v[3];

    dem_particle_share(&state->particles, i, &share);
    DEM_TRY(DEM_GROW(f->departure, f->departure_capacity, f->departures + 1));
    struct dem_departure *const new = &f->departure[f->departures++];

    dem_interaction_table_gravity(&state->interaction_table, gravity);
    *new = (struct dem_departure){.id = q->id,
                                  .flow = flow == DEM_FLOW_DOMAIN ? f->n - 1 : flow,
                                  .mass = share.mass};
    for (int k = 0; k < 3; k++)
    {
        /* m/(m + added mass): slower fall */
        v[k] = (b ? b->v : q->v)[k] + late*share.mass*inverse*gravity[k];
        new->momentum[k] = share.mass*v[k];
    }
    new->energy = 0.5*share.mass*dem_vec_dot(v, v) +
                  (b ? share.kinetic[1] : 0.2*q->mass*q->radius*q->radius*dem_vec_dot(q->w, q->w));
    return DEM_OK;
}

static int by_id(const void *a, const void *b)
{
    const struct dem_departure *const p = a, *const q = b;

    return p->id != q->id ? (p->id > q->id) - (p->id < q->id)
                          : (p->flow > q->flow) - (p->flow < q->flow);
}

int dem_flows_sum_departures(struct dem_state *state)
{
    struct dem_flows *const f = state->flows;
    const struct dem_collect_items own = {"particles leave in one step", f->departure,
                                          f->departures, sizeof *f->departure};
    struct dem_departure *all;
    void *gathered;
    size_t n;

    DEM_TRY(dem_collect_gather(&state->decomposition, DEM_OK, &own, &gathered, &n));
    f->departures = 0;
    if (n == 0)
    {
        return DEM_OK;
    }
    all = gathered;
    dem_sort_by(all, n, sizeof *all, by_id);
    for (size_t k = 0; k < n; k++)
    {
        struct dem_snapshot_flow *const row = &f->flow[all[k].flow];

        if (all[k].mass > 0.0)    /* the first sphere of a body */
        {
            row->count++;
            dem_residence_add(f, all[k].flow, all[k].age);
        }
        row->mass += all[k].mass;
        row->energy += all[k].energy;
        for (int a = 0; a < 3; a++)
        {
            row->momentum[a] += all[k].momentum[a];
            f->contact_force[all[k].flow][a] += all[k].contact_force[a];
        }
    }
    dem_memory_free(all);
    return DEM_OK;
}

void dem_flows_complete_departures(struct dem_flows *f, double kick)
{
    for (int k = 0; k < f->n; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            f->flow[k].momentum[a] += kick*f->contact_force[k][a];
            f->contact_force[k][a] = 0.0;
        }
    }
}

/* ---- backup ---------------------------------------------------------------------------------- */

void dem_flows_backup(struct dem_flows *f)
{
    memcpy(f->backup, f->flow, sizeof f->backup);
    memcpy(f->backup_contact_force, f->contact_force, sizeof f->backup_contact_force);
    dem_residence_backup(f);
    f->backup_id = f->next_id;
}

void dem_flows_restore(struct dem_flows *f)
{
    memcpy(f->flow, f->backup, sizeof f->flow);
    memcpy(f->contact_force, f->backup_contact_force, sizeof f->contact_force);
    dem_residence_restore(f);
    f->next_id = f->backup_id;
    f->arrivals = f->departures = 0;
    f->now = f->left = 0;
    f->checked = 0;
    f->found = 0;
}
