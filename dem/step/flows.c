/*
 * flows.c -- when streams and outlets are looked at, who is let in, and the books of what has come and gone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/flows.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/vec.h"
#include "step/orientation.h"
#include "step/parts.h"
#include "step/sweep_bodies.h"
#include "step/uniform.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void dem_flows_free(struct dem_flows *f)
{
    dem_memory_free(f->arrival);
    dem_memory_free(f->departure);
    memset(f, 0, sizeof *f);
}

int dem_flows_step(const struct dem_parts *p)
{
    return p->flows.n > 0 && !p->flows.asked && p->steps%DEM_FLOW_STEPS == 0;
}

/* ---- beginning ----------------------------------------------------------------------------------------------- */

/* In what it is owed now, all that has come was owed: nothing is. */
static double nothing_owed(const struct dem_snapshot_flow *row)
{
    return row->kind == DEM_FLOW_MASSES ? row->mass : (double)row->count;
}

/* What a snapshot knew of a row. A stream whose rate or times were changed owes what it owed, and goes on with the new ones; one that
   was owed in numbers and now is in kilograms, or the other way round, begins with no debt. */
static void resume(struct dem_snapshot_flow *row, const struct dem_stream *s, const struct dem_snapshot *from, double time)
{
    for (int64_t k = 0; from && k < from->flows; k++)
    {
        const struct dem_snapshot_flow *const old = &from->flow[k];

        if (strcmp(old->name, row->name) == 0 && (old->kind == DEM_FLOW_OUTLET) == (row->kind == DEM_FLOW_OUTLET))
        {
            const struct dem_snapshot_flow new = *row;

            *row = *old;
            if (s && (old->kind != new.kind || old->rate != new.rate || old->start != new.start || old->end != new.end))
            {
                const struct dem_stream before = {.rate = old->rate, .start = old->start, .end = old->end};

                row->kind = new.kind;
                row->owed = old->kind != new.kind ? nothing_owed(row) : old->owed + dem_stream_owes(&before, old->since, time);
                row->since = time;
                row->rate = new.rate;
                row->start = new.start;
                row->end = new.end;
            }
        }
    }
}

static void add_row(struct dem_flows *f, const char *name, int kind)
{
    struct dem_snapshot_flow *const row = &f->flow[f->n++];

    memset(row, 0, sizeof *row);
    snprintf(row->name, sizeof row->name, "%s", name);
    row->kind = kind;
}

static int64_t free_id(const struct dem_parts *p)
{
    int64_t next = 0;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        next = p->particles.record[i].id >= next ? p->particles.record[i].id + 1 : next;
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &next, 1, MPI_INT64_T, MPI_MAX, p->pieces.comm);
    }
    return next;
}

int dem_flows_begin(struct dem_parts *p, const struct dem_streams *plan, const struct dem_snapshot *from)
{
    struct dem_flows *const f = &p->flows;

    f->plan = plan;
    f->n = 0;
    for (int k = 0; k < plan->streams; k++)
    {
        const struct dem_stream *const s = &plan->stream[k];

        add_row(f, s->name, s->by_mass ? DEM_FLOW_MASSES : DEM_FLOW_STREAM);
        f->flow[k].rate = s->rate;
        f->flow[k].start = s->start;
        f->flow[k].end = s->end;
        f->flow[k].since = f->flow[k].last = p->time;
        resume(&f->flow[k], s, from, p->time);
    }
    for (int k = 0; k < plan->outlets; k++)
    {
        add_row(f, plan->outlet[k].name, DEM_FLOW_OUTLET);
        resume(&f->flow[f->n - 1], NULL, from, p->time);
    }
    if (f->n == 0)
    {
        return DEM_OK;
    }
    add_row(f, "domain", DEM_FLOW_OUTLET);
    resume(&f->flow[f->n - 1], NULL, from, p->time);
    f->next_id = free_id(p);
    f->next_id = from && from->next_id > f->next_id ? from->next_id : f->next_id;
    return DEM_OK;
}

/* ---- in ------------------------------------------------------------------------------------------------------ */

static int let_in(struct dem_parts *p, const struct dem_particle *q)
{
    struct dem_particles *const all = &p->particles;
    const size_t i = all->n;

    DEM_TRY(dem_particles_add(all, q));
    if (dem_column(all, DEM_COLUMN_FLUID_VELOCITY))
    {
        dem_uniform_fill(all, i, p->flows.fluid, 0.0);
        memcpy(dem_column(all, DEM_COLUMN_START_VELOCITY) + 3*i, q->v, sizeof q->v);
        memcpy(dem_column(all, DEM_COLUMN_WAY) + 3*i, q->x, sizeof q->x);
        dem_column(all, DEM_COLUMN_KEPT)[i] = 1.0;
        all->record[i].viscosity = dem_column(all, DEM_COLUMN_FLUID_VISCOSITY)[i];
    }
    if (p->ledger.open)
    {
        dem_ledger_comes(p, q);
    }
    return DEM_OK;
}

static void kick_back(struct dem_parts *p, size_t first, double half)
{
    const struct dem_body_sweep back = {.kick = -half, .ledger = p->ledger.open ? &p->ledger : NULL};
    struct dem_body_pass pass;

    dem_bodies_begin(&pass, &p->particles, &p->recipe.bodies, &back);
    pass.next = first;
    dem_bodies_until(&pass, p->particles.n);
}

int dem_flows_let_in(struct dem_parts *p, double half)
{
    struct dem_flows *const f = &p->flows;
    const size_t first = p->particles.n;

    for (size_t k = 0; k < f->arrivals; k++)
    {
        const struct dem_particle *const q = &f->arrival[k].particle;

        if (p->pieces.ranks == 1 || dem_pieces_owner(&p->pieces, q->x) == p->pieces.rank)
        {
            DEM_TRY(let_in(p, q));
        }
    }
    f->arrivals = 0;
    dem_orientation_begin(&p->particles);
    if (half > 0.0)
    {
        dem_uniform_renew(p, f->fluid);
        kick_back(p, first, half);
        dem_domain_hold(&p->domain, &p->particles);
    }
    return DEM_OK;
}

/* ---- out ----------------------------------------------------------------------------------------------------- */

int dem_flows_outlet(const struct dem_flows *f, const double x[3])
{
    for (int k = 0; f->n > 0 && k < f->plan->outlets; k++)
    {
        if (dem_outlet_holds(&f->plan->outlet[k], x))
        {
            return f->plan->streams + k;
        }
    }
    return DEM_FLOW_NONE;
}

int dem_flows_note(struct dem_parts *p, int flow, const struct dem_particle *q, double late)
{
    struct dem_flows *const f = &p->flows;
    double gravity[3], v[3];

    DEM_TRY(DEM_GROW(f->departure, f->departure_room, f->departures + 1));
    struct dem_departure *const new = &f->departure[f->departures++];

    dem_recipe_vector(&p->recipe, "gravity", "acceleration", gravity);
    *new = (struct dem_departure){.id = q->id, .flow = flow == DEM_FLOW_DOMAIN ? f->n - 1 : flow, .mass = q->mass};
    for (int k = 0; k < 3; k++)
    {
        v[k] = q->v[k] + late*q->mass*q->inverse_mass*gravity[k];         /* with added mass it falls slower */
        new->momentum[k] = q->mass*v[k];
    }
    new->energy = 0.5*q->mass*dem_vec_dot(v, v) + 0.2*q->mass*q->radius*q->radius*dem_vec_dot(q->w, q->w);
    return DEM_OK;
}

static int by_id(const void *a, const void *b)
{
    const struct dem_departure *const p = a, *const q = b;

    return (p->id > q->id) - (p->id < q->id);
}

static int gather(struct dem_flows *f, const struct dem_pieces *q, struct dem_departure **all, size_t *n)
{
    const int mine = (int)(f->departures*sizeof *f->departure);
    int *count, *start, total = 0;

    DEM_TRY(DEM_NEW(count, q->ranks));
    DEM_TRY(DEM_NEW(start, q->ranks));
    MPI_Allgather(&mine, 1, MPI_INT, count, 1, MPI_INT, q->comm);
    for (int k = 0; k < q->ranks; k++)
    {
        start[k] = total;
        total += count[k];
    }
    *n = (size_t)total/sizeof **all;
    DEM_TRY(DEM_NEW(*all, *n + 1));
    MPI_Allgatherv(f->departure, mine, MPI_BYTE, *all, count, start, MPI_BYTE, q->comm);
    dem_memory_free(count);
    dem_memory_free(start);
    return DEM_OK;
}

int dem_flows_book(struct dem_parts *p)
{
    struct dem_flows *const f = &p->flows;
    struct dem_departure *all = f->departure;
    size_t n = f->departures;

    if (p->pieces.ranks > 1)
    {
        DEM_TRY(gather(f, &p->pieces, &all, &n));
    }
    dem_sort_by(all, n, sizeof *all, by_id);
    for (size_t k = 0; k < n; k++)
    {
        struct dem_snapshot_flow *const row = &f->flow[all[k].flow];

        row->count++;
        row->mass += all[k].mass;
        row->energy += all[k].energy;
        for (int a = 0; a < 3; a++)
        {
            row->momentum[a] += all[k].momentum[a];
            f->push[all[k].flow][a] += all[k].push[a];
        }
    }
    f->departures = 0;
    if (p->pieces.ranks > 1)
    {
        dem_memory_free(all);
    }
    return DEM_OK;
}

void dem_flows_kick(struct dem_flows *f, double kick)
{
    for (int k = 0; k < f->n; k++)
    {
        for (int a = 0; a < 3; a++)
        {
            f->flow[k].momentum[a] += kick*f->push[k][a];
            f->push[k][a] = 0.0;
        }
    }
}

/* ---- copies -------------------------------------------------------------------------------------------------- */

void dem_flows_keep(struct dem_flows *f)
{
    memcpy(f->kept, f->flow, sizeof f->kept);
    memcpy(f->kept_push, f->push, sizeof f->kept_push);
    f->kept_id = f->next_id;
}

void dem_flows_go_back(struct dem_flows *f)
{
    memcpy(f->flow, f->kept, sizeof f->flow);
    memcpy(f->push, f->kept_push, sizeof f->push);
    f->next_id = f->kept_id;
    f->arrivals = f->departures = 0;
    f->now = f->left = 0;
}
