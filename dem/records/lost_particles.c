/*
 * lost_particles.c -- the list of lost particles of a rank, and its union over the ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/lost_particles.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include <stdio.h>
#include <string.h>

void dem_lost_particles_free(struct dem_lost_particles *l)
{
    dem_memory_free(l->loss);
    dem_memory_free(l->all);
    dem_memory_free(l->crossed);
    memset(l, 0, sizeof *l);
}

int dem_lost_particles_add(struct dem_lost_particles *l, const struct dem_particle *p, double time,
                           int removed, const char *cause)
{
    DEM_TRY(DEM_GROW(l->loss, l->capacity, l->n + 1));
    struct dem_loss *const new = &l->loss[l->n++];

    *new = (struct dem_loss){.id = p->id,
                             .time = time,
                             .diameter = 2.0*p->radius,
                             .removed = removed};
    memcpy(new->position, p->x, sizeof new->position);
    memcpy(new->velocity, p->v, sizeof new->velocity);
    snprintf(new->cause, sizeof new->cause, "%s", cause);
    return DEM_OK;
}

static int by_time_and_id(const void *a, const void *b)
{
    const struct dem_loss *const p = a, *const q = b;
    const int time = (p->time > q->time) - (p->time < q->time),
              id = (p->id > q->id) - (p->id < q->id);

    return time ? time : id ? id : strcmp(p->cause, q->cause);
}

int dem_lost_particles_collect(struct dem_lost_particles *l, const struct dem_decomposition *q,
                               int64_t *n)
{
    const struct dem_collect_items own =
        {"lost particles since the last output (write output more often)", l->loss, l->n,
         sizeof *l->loss};
    void *all = l->all;

    DEM_TRY(dem_collect_records(q, &own, by_time_and_id, &all, n));
    l->all = all;
    l->n = 0;
    return DEM_OK;
}
