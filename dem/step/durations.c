/*
 * durations.c -- ages of pairs, and a table of how old they became.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/durations.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/sort.h"
#include "step/parts.h"
#include <stdlib.h>
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

static uint64_t name_of(const struct dem_parts *p, const struct dem_pair *q)
{
    const int64_t other = q->wall ? -1 - p->pairs.wall_region[q->j] : p->particles.record[q->j].id;

    return dem_random_bits(0, (uint64_t)p->particles.record[q->i].id, (uint64_t)other, 0);
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

/* ---- lists come and go ------------------------------------------------------------------------------------------- */

static int by_name(const void *a, const void *b)
{
    const struct dem_duration *const x = a, *const y = b;

    return (x->name > y->name) - (x->name < y->name);
}

/* Collective: all ranks renew lists together, and a pair may have gone to another one. */
static int gather(struct dem_durations *d, const struct dem_pieces *pieces)
{
    int mine = (int)(d->carries*sizeof *d->carried), *bytes, *start, all = 0;
    struct dem_duration *own = d->carried;

    if (pieces->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(bytes, (size_t)(2*pieces->ranks)));
    start = bytes + pieces->ranks;
    MPI_Allgather(&mine, 1, MPI_INT, bytes, 1, MPI_INT, pieces->comm);
    for (int k = 0; k < pieces->ranks; k++)
    {
        start[k] = all;
        all += bytes[k];
    }
    d->carried = NULL;
    d->carries = (size_t)all/sizeof *own;
    d->carry_room = 0;
    const int status = DEM_GROW(d->carried, d->carry_room, d->carries + 1);

    if (!status)
    {
        MPI_Allgatherv(own, mine, MPI_BYTE, d->carried, bytes, start, MPI_BYTE, pieces->comm);
    }
    dem_memory_free(own);
    dem_memory_free(bytes);
    return status;
}

/* From old lists those that touched in the last step; who parted out of the lists is recorded. */
static int carry(struct dem_durations *d, const struct dem_pieces *pieces, int32_t now)
{
    d->carries = 0;
    for (size_t k = 0; k < d->pairs; k++)
    {
        const struct dem_duration *const p = &d->pair[k];

        if (p->age > 0 && p->seen < now - 1)
        {
            record(d, p->age, p->seen);
        }
        else if (p->age > 0 && !DEM_GROW(d->carried, d->carry_room, d->carries + 1))     /* without room it is left out */
        {
            d->carried[d->carries++] = *p;
        }
    }
    DEM_TRY(gather(d, pieces));
    if (d->carries > 0)
    {
        dem_sort_by(d->carried, d->carries, sizeof *d->carried, by_name);
    }
    return DEM_OK;
}

/* New lists: who is carried goes on, who else touches now is left out. */
static int begin(struct dem_durations *d, const struct dem_parts *p, int32_t now)
{
    DEM_TRY(DEM_GROW(d->pair, d->room, p->contacts.pairs));
    if (p->contacts.pairs > 0)
    {
        memset(d->pair, 0, p->contacts.pairs*sizeof *d->pair);
    }
    d->pairs = p->contacts.pairs;
    d->rebuilds = p->rebuilds;
    for (uint32_t r = 0; r < p->contacts.rows; r++)
    {
        const uint32_t k = watched_pair(p, r);

        if (k == DEM_ROW_NONE)
        {
            continue;
        }
        const int touches = dem_contacts_push(&p->contacts, r).arm > 0.0;
        const struct dem_duration own = {.name = name_of(p, &p->contacts.pair[k]), .age = touches ? -1 : 0};
        const struct dem_duration *const old = d->carries > 0 ? bsearch(&own, d->carried, d->carries, sizeof own, by_name) : NULL;

        d->pair[k] = old ? *old : own;
        note_pair(d, &d->pair[k], touches, now);
    }
    d->carries = 0;
    return DEM_OK;
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
    const int goes_on = p->steps == d->last + 1 && now > 0, same = p->rebuilds == d->rebuilds;

    d->last = p->steps;
    if (!goes_on || !same)
    {
        DEM_TRY(goes_on ? carry(d, &p->pieces, now) : DEM_OK);
        return begin(d, p, now);
    }
    for (uint32_t r = 0; r < p->contacts.rows; r++)
    {
        const uint32_t k = watched_pair(p, r);

        if (k != DEM_ROW_NONE)
        {
            d->pair[k].name = d->pair[k].age == 0 ? name_of(p, &p->contacts.pair[k]) : d->pair[k].name;
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
    dem_memory_free(d->carried);
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
