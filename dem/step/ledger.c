/*
 * ledger.c -- what the rows of a sweep hold and lose, effect by effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/ledger.h"
#include "base/math.h"
#include "base/memory.h"
#include "step/parts.h"
#include "step/tray.h"
#include <math.h>
#include <string.h>

/* ---- opening ------------------------------------------------------------------------------------------------- */

int dem_ledger_open(struct dem_ledger *l, const struct dem_recipe *r)
{
    DEM_TRY(DEM_NEW(l->sum, DEM_LEDGER_SUMS));
    DEM_TRY(DEM_NEW(l->scratch, 1));
    for (int k = 0; k < DEM_LEDGER_SUMS; k++)
    {
        dem_sum_clear(&l->sum[k]);
    }
    for (int k = 0; k < r->chosen; k++)
    {
        l->scratch->effect[k] = r->effect[k];
    }
    for (int k = 0; k < DEM_MEMORY_COLUMNS; k++)
    {
        l->scratch->before[k] = l->scratch->column[k];
    }
    dem_recipe_vector(r, "gravity", "acceleration", l->gravity);
    l->open = l->tells = 1;
    return DEM_OK;
}

void dem_ledger_free(struct dem_ledger *l)
{
    dem_memory_free(l->sum);
    dem_memory_free(l->scratch);
    memset(l, 0, sizeof *l);
}

struct dem_sum *dem_ledger_of(const struct dem_ledger *l, const struct dem_effect *effect)
{
    int k = 0;

    while (l->scratch->effect[k] != effect)
    {
        k++;
    }
    return l->sum + k*DEM_LEDGER_EACH;
}

/* ---- before an effect acts ----------------------------------------------------------------------------------- */

void dem_ledger_sweep(struct dem_ledger *l)
{
    for (int k = 0; k < DEM_CHAIN && l->tells; k++)
    {
        dem_sum_clear(&l->sum[k*DEM_LEDGER_EACH + DEM_LEDGER_STORED]);
    }
}

/* What a moment turns and what a force at the point of contact moves; arms as in geometry.h. Rows of padding are like the last. */
static void inertias(struct dem_parts *p, const struct dem_block *b, const struct dem_ledger_rows *r)
{
    struct dem_energy *const e = &p->ledger.scratch->tray;

    for (int c = 0; c < DEM_BLOCK; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[r->row + (uint32_t)(c < r->rows ? c : r->rows - 1)]];
        const struct dem_particle *const i = &p->particles.record[q->i], *const j = q->wall ? NULL : &p->particles.record[q->j];
        const double less = (j ? 0.5 : 1.0)*b->overlap[c], a = i->radius - less, other = j ? j->radius - less : 0.0;
        const double turn = i->inverse_inertia + (j ? j->inverse_inertia : 0.0), move = i->inverse_mass + (j ? j->inverse_mass : 0.0);
        const double slip = move + a*a*i->inverse_inertia + (j ? other*other*j->inverse_inertia : 0.0);

        e->inertia[c] = turn > 0.0 ? 1.0/turn : HUGE_VAL;
        e->slip_mass[c] = slip > 0.0 ? 1.0/slip : HUGE_VAL;
    }
}

/* The overlap before the drift: the distance has grown by dt v.h. Rows apart have none in the tray, but may have had one. */
void dem_ledger_block(struct dem_parts *p, const struct dem_tray *t, const struct dem_ledger_rows *r)
{
    struct dem_ledger_scratch *const s = p->ledger.scratch;
    const struct dem_block *const b = &t->block;
    const struct dem_gathered *const g = &t->g;

    for (int c = 0; c < b->n; c++)
    {
        const double distance = sqrt(g->rx[c]*g->rx[c] + g->ry[c]*g->ry[c] + g->rz[c]*g->rz[c]);
        const double raw = (r->chain->pair.with_wall ? b->least_radius[c] : g->radii[c]) - distance;
        const double now = b->overlap[c] > 0.0 ? b->overlap[c] : raw;

        s->rate[c] = g->vx[c]*b->hx[c] + g->vy[c]*b->hy[c] + g->vz[c]*b->hz[c];
        s->tray.was[c] = fmax(now + b->dt*s->rate[c], 0.0);
        s->tray.kn_was[c] = 0.0;
    }
    inertias(p, b, r);
}

void dem_ledger_before(struct dem_parts *p, const struct dem_tray *t, const struct dem_ledger_rows *r)
{
    struct dem_ledger_scratch *const s = p->ledger.scratch;
    const struct dem_block *const b = &t->block;

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
    for (int m = 0; m < dem_effect_memories(r->link->effect); m++)
    {
        memcpy(s->column[m], r->memory[m], (size_t)t->block.n*sizeof *s->column[m]);
    }
}

/* ---- after it ------------------------------------------------------------------------------------------------ */

/* The normal law once more, with the overlap of before the drift; also where partners have parted since. It spoils the columns of before. */
static void stiffness_was(struct dem_ledger_scratch *s, const struct dem_block *b, const struct dem_link *link)
{
    struct dem_block *const was = &s->was;

    *was = *b;
    for (int c = 0; c < b->n; c++)
    {
        was->overlap[c] = s->tray.was[c];
        was->touching[c] = s->tray.was[c] > 0.0 ? 1.0 : 0.0;
        was->kn[c] = was->fn[c] = 0.0;
    }
    link->effect->act(link->settings, was, s->before);
    memcpy(s->tray.kn_was, was->kn, sizeof s->tray.kn_was);
}

/* What the effect has added to the tray; what its books say before it is asked. */
static void fill(struct dem_ledger_scratch *s, const struct dem_block *b)
{
    struct dem_energy *const e = &s->tray;

    for (int c = 0; c < b->n; c++)
    {
        e->push[c] = b->fn[c] - s->then.fn[c];
        e->mx[c] = b->mx[c] - s->then.mx[c];
        e->my[c] = b->my[c] - s->then.my[c];
        e->mz[c] = b->mz[c] - s->then.mz[c];
        e->stored[c] = b->stored[c] - s->then.stored[c];
        e->lost[c] = b->lost[c] - s->then.lost[c];
    }
}

/* The work of forces and moments on the relative motion of the drift, taken with the force at its end. */
static void measure(struct dem_ledger_scratch *s, const struct dem_block *b)
{
    struct dem_energy *const e = &s->tray;

    for (int c = 0; c < b->n; c++)
    {
        const double along = e->push[c]*s->rate[c];
        const double slip = (b->fx[c] - s->then.fx[c])*b->sx[c] + (b->fy[c] - s->then.fy[c])*b->sy[c]
                          + (b->fz[c] - s->then.fz[c])*b->sz[c];
        const double spin = e->mx[c]*b->wx[c] + e->my[c]*b->wy[c] + e->mz[c]*b->wz[c];

        e->lost[c] = -b->touching[c]*(along + slip + spin)*b->dt;
    }
}

void dem_ledger_after(struct dem_parts *p, const struct dem_tray *t, const struct dem_ledger_rows *r)
{
    struct dem_ledger *const l = &p->ledger;
    struct dem_ledger_scratch *const s = l->scratch;
    const struct dem_block *const b = &t->block;
    const struct dem_effect *const effect = r->link->effect;
    struct dem_sum *const sum = dem_ledger_of(l, effect);

    fill(s, b);
    if (effect->energy)
    {
        effect->energy(r->link->settings, b, s->before, r->memory, &s->tray);
    }
    else if (effect->stage < DEM_STAGE_BOND)
    {
        measure(s, b);
    }
    if (effect->stage == DEM_STAGE_NORMAL)
    {
        stiffness_was(s, b, r->link);
    }
    for (int c = 0; c < r->rows; c++)
    {
        if (p->contacts.pair[p->contacts.row_pair[r->row + (uint32_t)c]].i < p->particles.n)
        {
            const int broke = effect->stage == DEM_STAGE_BOND && b->broke[c] > s->then.broke[c];

            dem_ledger_add(&sum[DEM_LEDGER_STORED], l->tells ? s->tray.stored[c] : 0.0);
            dem_ledger_add(broke ? &l->sum[DEM_LEDGER_BROKEN] : &sum[DEM_LEDGER_LOST], l->begun ? s->tray.lost[c] : 0.0);
        }
    }
}
