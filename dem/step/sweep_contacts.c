/*
 * sweep_contacts.c -- fill the tray -> each effect of the class in the order of stages -> one push per row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sweep_contacts.h"
#include "base/math.h"
#include "base/memory.h"
#include "step/hot_chain.h"
#include "step/loss_cause.h"
#include "step/push_place.h"
#include "step/tray.h"
#include "step/wall_springs.h"
#include "step/watch.h"
#include <string.h>

/* ---- results ------------------------------------------------------------------------------------------------- */

DEM_KERNEL
static void forget_apart(const struct dem_block *restrict b, double *restrict memory)
{
    for (int c = 0; c < b->n; c++)
    {
        memory[c] = dem_pick(b->touching[c] > 0.0, memory[c], 0.0);
    }
}

/* ---- passing through ----------------------------------------------------------------------------------------- */

/* 1 when a particle's centre was on the other side of its wall a step ago: it moves away faster than that takes. */
static inline double passed(const struct dem_block *restrict b, int c)
{
    return dem_pick(b->vn[c]*b->dt > b->least_radius[c] - b->overlap[c], b->touching[c], 0.0);
}

DEM_KERNEL
static double count_passes(const struct dem_block *restrict b)
{
    double count = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        count += passed(b, c);
    }
    return count;
}

/* Only triangles have two sides: elsewhere there is no behind. */
static int list_passes(struct dem_parts *p, const struct dem_tray *t, uint32_t row, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[row + (uint32_t)c]];

        if (passed(&t->block, c) > 0.0 && p->walls.region[p->pairs.wall_region[q->j]].shape == DEM_SHAPE_TRIANGLES)
        {
            DEM_TRY(DEM_GROW(p->losses.pass, p->losses.pass_room, p->losses.passes + 1));
            p->losses.pass[p->losses.passes++] = row + (uint32_t)c;
        }
    }
    return DEM_OK;
}

/* ---- the sweep ----------------------------------------------------------------------------------------------- */

/* The columns that an effect remembers, at the tray's rows; returns how many. */
static int recall(const struct dem_contacts *c, const struct dem_link *link, uint32_t row, double **memory)
{
    const int memories = dem_effect_memories(link->effect);

    for (int m = 0; m < memories; m++)
    {
        memory[m] = c->memory[link->memory + m] + row;
    }
    return memories;
}

static void shield(struct dem_tray *t, const struct dem_chain *chain, const struct dem_contacts *c, uint32_t row)
{
    double *memory[DEM_MEMORY_COLUMNS];

    for (int k = 0; k < chain->links; k++)
    {
        if (chain->link[k].effect->shield)
        {
            recall(c, &chain->link[k], row, memory);
            chain->link[k].effect->shield(chain->link[k].settings, &t->block, memory);
        }
    }
}

/* What films tell friction, just before it acts. */
static void adhere(struct dem_tray *t, const struct dem_chain *chain, const struct dem_contacts *c, uint32_t row)
{
    double *memory[DEM_MEMORY_COLUMNS];

    for (int k = 0; k < chain->links; k++)
    {
        if (chain->link[k].effect->adhere)
        {
            recall(c, &chain->link[k], row, memory);
            chain->link[k].effect->adhere(chain->link[k].settings, &t->block, memory);
        }
    }
}

/* 1 when this is the first link that acts after NORMAL and DAMP in a chain that may have a film */
static int films_first(const struct dem_chain *chain, int link)
{
    return chain->past_touching && chain->link[link].effect->stage >= DEM_STAGE_TANGENT
           && (link == 0 || chain->link[link - 1].effect->stage < DEM_STAGE_TANGENT);
}

static void act_one(struct dem_tray *t, const struct dem_chain *chain, int link, double **memory, int memories)
{
    const struct dem_effect *const effect = chain->link[link].effect;
    /* a shield takes touch and leaves the overlap */
    const int forgotten = effect->stage >= DEM_STAGE_BOND || (effect->forgets && !chain->past_touching);

    effect->act(chain->link[link].settings, &t->block, memory);
    for (int m = 0; m < memories && !forgotten; m++)
    {
        forget_apart(&t->block, memory[m]);
    }
}

static void act(struct dem_tray *t, const struct dem_chain *chain, const struct dem_contacts *c, uint32_t row)
{
    double *memory[DEM_MEMORY_COLUMNS];

    for (int k = 0; k < chain->links; k++)
    {
        if (films_first(chain, k))
        {
            adhere(t, chain, c, row);
        }
        const int memories = recall(c, &chain->link[k], row, memory);

        act_one(t, chain, k, memory, memories);
    }
}

/* The same with the ledger looking on. */
static void act_and_tell(struct dem_parts *p, struct dem_tray *t, const struct dem_chain *chain, uint32_t row, int rows)
{
    double *memory[DEM_MEMORY_COLUMNS];

    struct dem_ledger_rows r = {.chain = chain, .memory = memory, .row = row, .rows = rows};

    dem_ledger_block(p, t, &r);
    for (int k = 0; k < chain->links; k++)
    {
        if (films_first(chain, k))
        {
            adhere(t, chain, &p->contacts, row);
        }
        r.link = &chain->link[k];
        const int memories = recall(&p->contacts, r.link, row, memory);

        dem_ledger_before(p, t, &r);
        act_one(t, chain, k, memory, memories);
        dem_ledger_after(p, t, &r);
    }
}

static void keep_moments(struct dem_contacts *c, const struct dem_block *b, uint32_t row, int rows)
{
    for (int k = 0; k < rows; k++)
    {
        double *const m = c->moment + 3*(row + (uint32_t)k);

        m[0] = b->mx[k];
        m[1] = b->my[k];
        m[2] = b->mz[k];
    }
}

static void keep_books(struct dem_contacts *c, const struct dem_block *b, uint32_t row, int rows)
{
    for (int k = 0; k < rows; k++)
    {
        c->books[row + (uint32_t)k] = (struct dem_books){.stored = b->stored[k], .lost = b->lost[k], .bonds = b->bonds[k],
                                                         .broke = b->broke[k]};
    }
}

DEM_KERNEL
static double broken(const struct dem_block *restrict b)
{
    double count = 0.0;

    for (int c = 0; c < b->n; c++)
    {
        count += b->broke[c];
    }
    return count;
}

struct rows                                               /* of a block: the first, how many, and where their pushes go */
{
    uint32_t row;
    int rows;
    struct dem_push_place to;
};

static void sweep_hot_block(struct dem_parts *p, struct dem_tray *t, const struct dem_chain *chain, const struct rows *at)
{
    double *memory[DEM_MEMORY_COLUMNS];

    struct dem_block *const b = &t->block;
    const struct dem_hot_laws laws = dem_hot_chain_laws(chain, p->watch.overlap);

    recall(&p->contacts, &chain->link[DEM_HOT_FRICTION], at->row, memory);
    dem_tray_gather(t, p, chain, at->row, at->rows);

    const struct dem_hot_rows single = {.n = b->n, .dt = b->dt, .least_radius = b->least_radius, .overlap = b->overlap,
                                        .fn = b->fn, .fx = b->fx, .fy = b->fy, .fz = b->fz};

    if (at->to.single ? dem_hot_chain_act_single(&laws, &single, &t->g, memory, at->to.single)
                      : dem_hot_chain_act(&laws, b, &t->g, memory, at->to.push))
    {
        dem_watch_note(p, t, at->row, at->rows);
    }
}

static int sweep_block(struct dem_parts *p, struct dem_tray *t, const struct dem_chain *chain, const struct rows *at)
{
    const uint32_t row = at->row;
    const int rows = at->rows;

    dem_tray_fill(t, p, chain, row, rows);
    if (chain->past_touching)
    {
        shield(t, chain, &p->contacts, row);
    }
    if (p->ledger.open)
    {
        act_and_tell(p, t, chain, row, rows);
    }
    else
    {
        act(t, chain, &p->contacts, row);
    }
    if (chain->past_touching && broken(&t->block) > 0.0)
    {
        DEM_TRY(dem_bonds_note(p, &t->block, row, rows));
    }
    dem_push_out(&t->block, chain->pair.with_wall ? 1.0 : 0.5, chain->past_touching, &at->to);
    if (chain->past_touching)
    {
        keep_books(&p->contacts, &t->block, row, rows);
    }
    if (p->contacts.moment)
    {
        keep_moments(&p->contacts, &t->block, row, rows);
    }
    dem_watch_note(p, t, row, rows);
    return chain->pair.with_wall && count_passes(&t->block) > 0.0 ? list_passes(p, t, row, rows) : DEM_OK;
}

/* Those who wait for no row from `rows` on. */
static void kick_ready(struct dem_body_pass *bodies, const struct dem_contacts *c, uint32_t rows)
{
    while (bodies->next < bodies->particles->n && c->ready[bodies->next/DEM_BLOCK] <= rows)
    {
        dem_bodies_until(bodies, bodies->next + 1);
    }
}

static int sweep_class(struct dem_parts *p, struct dem_tray *t, int class, struct dem_body_pass *bodies)
{
    const struct dem_chain *const chain = &p->recipe.chain[class];
    const struct dem_segment *const seg = &p->contacts.segment[class];
    const int hot = dem_hot_chain_is(chain) && !p->ledger.open && !p->contacts.moment;
    const int ring = bodies && bodies->quiet && !chain->pair.with_wall && dem_contacts_go_round(&p->contacts);
    size_t far = 0;

    for (; ring && far < p->contacts.fars && p->contacts.far[far] < seg->first; far++) {}

    for (uint32_t done = 0; done < seg->count; done += DEM_BLOCK)
    {
        const int rows = seg->count - done < DEM_BLOCK ? (int)(seg->count - done) : DEM_BLOCK;
        const struct rows at = {.row = seg->first + done, .rows = rows, .to = dem_push_place(&p->contacts, seg->first + done, ring)};

        if (hot)
        {
            sweep_hot_block(p, t, chain, &at);
        }
        else
        {
            DEM_TRY(sweep_block(p, t, chain, &at));
        }
        far = ring ? dem_push_keep_far(&p->contacts, far, at.row + (uint32_t)rows) : 0;
        if (bodies && !chain->pair.with_wall)
        {
            kick_ready(bodies, &p->contacts, seg->first + done + (uint32_t)rows);
        }
    }
    return DEM_OK;
}

int dem_sweep_contacts_and(struct dem_parts *p, double dt, const double time[2], struct dem_body_pass *bodies)
{
    struct dem_tray t;

    memset(&t, 0, sizeof t);
    t.block.dt = dt;
    t.block.longest = p->longest_step;
    t.block.since = time[0];
    t.block.time = time[1];
    dem_wall_touches_update(&p->touches, &p->pairs.search, &p->walls, &p->particles);
    dem_wall_springs(p);
    if (p->ledger.open)
    {
        dem_ledger_sweep(&p->ledger);
    }
    for (int walls = 1; walls >= 0; walls--)
    {
        for (int s = 0; s < p->contacts.classes; s++)
        {
            if (p->recipe.chain[s].pair.with_wall == walls)
            {
                DEM_TRY(sweep_class(p, &t, s, bodies));
            }
        }
        /* who passed a wall is told with his speed of now: then nobody is kicked before all rows are done */
        if (bodies && p->losses.passes > 0)
        {
            bodies->quiet = 0;
            bodies = NULL;
        }
    }
    DEM_TRY(dem_loss_note_passes(p));
    return dem_watch_judge(p);
}

int dem_sweep_contacts(struct dem_parts *p, double dt, const double time[2])
{
    return dem_sweep_contacts_and(p, dt, time, NULL);
}
