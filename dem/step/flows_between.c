/*
 * flows_between.c -- streams and outlets between two windows, for a program whose fluid must know of everybody beforehand. Positions and
 * velocities are of one time there, so nobody needs half a kick.
 *
 * Rows of contacts are lifted, as before a rebuild, which the next step makes. The first half kick of the next window knows from the
 * particles' columns what contacts did to them; what they did to walls is summed here before the rows go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/flows.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "step/agree.h"
#include "step/parts.h"
#include <stdlib.h>

static int by_id(const void *a, const void *b)
{
    const struct dem_goer *const p = a, *const q = b;

    return (p->id > q->id) - (p->id < q->id);
}

/* Where a particle goes out now: named, or in an outlet of the core's own. */
static int flow_of(const struct dem_parts *p, const struct dem_particle *q, const struct dem_goer *goer, size_t n)
{
    const struct dem_goer key = {.id = q->id};
    const struct dem_goer *const found = n > 0 ? bsearch(&key, goer, n, sizeof *goer, by_id) : NULL;
    struct dem_particle home = *q;

    dem_domain_wrap(&p->domain, &home);
    return found ? found->flow : dem_flows_outlet(&p->flows, home.x);
}

/* What drag owes who goes is part of what he carries, and so is what his contacts have still to give their partners. */
static int send_off(struct dem_parts *p, size_t i, int flow)
{
    const double *const pending = dem_column(&p->particles, DEM_COLUMN_PENDING), *const force = dem_column(&p->particles, DEM_COLUMN_FORCE);
    struct dem_flows *const f = &p->flows;

    DEM_TRY(dem_flows_note(p, flow, &p->particles.record[i], 0.0));
    struct dem_departure *const new = &f->departure[f->departures - 1];

    for (size_t k = 0; k < 3; k++)
    {
        new->momentum[k] += pending ? pending[3*i + k] : 0.0;
        new->push[k] = force[3*i + k];
    }
    if (p->ledger.open)
    {
        dem_ledger_leaves(p, &p->particles.record[i], 0.0);
    }
    return DEM_OK;
}

/* `order` of those who stay; how many. */
static int part(struct dem_parts *p, const struct dem_goer *goer, size_t n, uint32_t *order, size_t *stay)
{
    *stay = 0;
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const int flow = flow_of(p, &p->particles.record[i], goer, n);

        if (flow == DEM_FLOW_NONE)
        {
            order[(*stay)++] = (uint32_t)i;
        }
        else
        {
            DEM_TRY(send_off(p, i, flow));
        }
    }
    return DEM_OK;
}

static int let_through(struct dem_parts *p, uint32_t *order, size_t stay)
{
    if (p->stale < 2)
    {
        const int status = dem_wall_books_hold(p);

        DEM_TRY(dem_agree(p, status ? status : dem_contacts_lift(&p->contacts, &p->particles, p->pairs.wall_region)));
    }
    if (stay < p->particles.n)
    {
        dem_particles_reorder(&p->particles, order, stay);
    }
    p->particles.ghosts = 0;
    DEM_TRY(dem_flows_book(p));
    p->stale = 2;
    return dem_agree(p, dem_flows_let_in(p, 0.0));
}

int dem_flows_between(struct dem_parts *p, size_t n, struct dem_goer *goer, int *changed)
{
    double some;
    uint32_t *order;
    size_t stay;

    *changed = 0;
    if (p->flows.n == 0)
    {
        return DEM_OK;
    }
    dem_sort_by(goer, n, sizeof *goer, by_id);
    DEM_TRY(DEM_NEW(order, p->particles.n + 1));
    int status = dem_agree(p, part(p, goer, n, order, &stay));

    status = status ? status : dem_flows_call(p, p->steps);
    some = stay < p->particles.n || p->flows.arrivals > 0 ? 1.0 : 0.0;
    status = dem_agree_most(p, status, &some, 1);
    if (!status && some > 0.0)
    {
        *changed = 1;
        status = let_through(p, order, stay);
    }
    dem_memory_free(order);
    return status;
}
