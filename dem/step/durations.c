/*
 * durations.c -- ages of pairs, and a table of how old they became.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/durations.h"
#include "base/error.h"
#include "base/memory.h"
#include "step/parts.h"
#include <string.h>

/* It has touched for `age` steps up to the watched step `last`, and is apart, or older than what is counted. */
static void record(struct dem_durations *d, int32_t age, int32_t last)
{
    const int32_t began = last - age + 1;

    if (began < DEM_DURATIONS_MOST)
    {
        d->count[age <= DEM_DURATIONS_MOST ? age : DEM_DURATIONS_MOST + 1]++;
    }
}

/* The outer pair of a row that is watched, or none. */
static uint32_t watched_pair(const struct dem_parts *p, uint32_t row)
{
    const uint32_t k = p->contacts.row_pair[row];
    const struct dem_pair *const q = k == DEM_ROW_NONE ? NULL : &p->contacts.pair[k];

    if (!q || q->i >= p->particles.n)
    {
        return DEM_ROW_NONE;
    }
    const int wall = q->wall ? p->walls.region[p->pairs.wall_region[q->j]].wall : -1;

    return wall >= 0 && p->walls.wall[wall].shape == DEM_SHAPE_TRIANGLES ? DEM_ROW_NONE : k;
}

/* Who touches now is left out. */
static int begin(struct dem_durations *d, const struct dem_parts *p)
{
    const struct dem_contacts *const c = &p->contacts;

    DEM_TRY(DEM_GROW(d->pair, d->room, c->pairs));
    if (c->pairs > 0)
    {
        memset(d->pair, 0, c->pairs*sizeof *d->pair);
    }
    d->pairs = c->pairs;
    d->rebuilds = p->rebuilds;
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] != DEM_ROW_NONE && dem_contacts_push(c, r).arm > 0.0)
        {
            d->pair[c->row_pair[r]].age = -1;
        }
    }
    return DEM_OK;
}

/* One that went out of the lists while apart shows when it comes again: it was not seen in the step before. */
static void note_pair(struct dem_durations *d, struct dem_duration *p, int touches, int32_t now)
{
    if (p->age > 0 && (!touches || p->seen < now - 1))
    {
        record(d, p->age, p->seen);
        p->age = 0;
    }
    p->age = touches ? p->age < 0 ? -1 : p->age + 1 : 0;
    p->seen = now;
    if (p->age > DEM_DURATIONS_MOST)
    {
        record(d, p->age, now);
        p->age = -1;
    }
}

/* What has parted out of the lists and did not come again. */
static void finish(struct dem_durations *d, int32_t now)
{
    for (size_t k = 0; k < d->pairs; k++)
    {
        if (d->pair[k].age > 0 && d->pair[k].seen < now)
        {
            record(d, d->pair[k].age, d->pair[k].seen);
        }
    }
    d->pairs = 0;
}

int dem_durations_note(struct dem_durations *d, const struct dem_parts *p)
{
    const int32_t now = (int32_t)((p->steps - 1)%DEM_DURATIONS_EVERY);
    const int goes_on = p->steps == d->last + 1 && p->rebuilds == d->rebuilds && p->contacts.pairs == d->pairs && now > 0;

    d->last = p->steps;
    if (!goes_on)
    {
        return begin(d, p);
    }
    for (uint32_t r = 0; r < p->contacts.rows; r++)
    {
        const uint32_t k = watched_pair(p, r);

        if (k != DEM_ROW_NONE)
        {
            note_pair(d, &d->pair[k], dem_contacts_push(&p->contacts, r).arm > 0.0, now);
        }
    }
    if (now == DEM_DURATIONS_WATCHED - 1)
    {
        finish(d, now);
    }
    return DEM_OK;
}

void dem_durations_free(struct dem_durations *d)
{
    dem_memory_free(d->pair);
    *d = (struct dem_durations){.asked = 0};
}

void dem_durations_tell(const struct dem_parts *p, int64_t *watched, int64_t *longer, int *least, int *median)
{
    int64_t count[DEM_DURATIONS_MOST + 2], below = 0;

    memcpy(count, p->durations.count, sizeof count);
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, count, DEM_DURATIONS_MOST + 2, MPI_INT64_T, MPI_SUM, p->pieces.comm);
    }
    *watched = *least = *median = 0;
    *longer = count[DEM_DURATIONS_MOST + 1];
    for (int k = 1; k < DEM_DURATIONS_MOST + 2; k++)
    {
        *watched += count[k];
        *least = *least == 0 && count[k] > 0 ? k : *least;
    }
    for (int k = 1; k < DEM_DURATIONS_MOST + 2 && *median == 0 && *watched > 0; k++)
    {
        below += count[k];
        *median = 2*below >= *watched ? k : 0;
    }
}
