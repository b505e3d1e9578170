/*
 * contact_durations.c -- ages of contacts pair by pair, and the histogram of their durations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "diagnostics/contact_durations.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "core/sort.h"
#include "parallel/collect.h"
#include "simulation/dem_state.h"
#include <stdlib.h>
#include <string.h>

/* Count a contact that has touched for `age` steps up to the watched step `last`, and has ended or
   is older than the histogram. */
static void count_contact(struct dem_contact_durations *d, int32_t age, int32_t last)
{
    const int32_t began = last - age + 1;

    if (began < DEM_CONTACT_DURATIONS_MAX)
    {
        d->count[age <= DEM_CONTACT_DURATIONS_MAX ? age : DEM_CONTACT_DURATIONS_MAX + 1]++;
    }
}

/* The pair of a row, or DEM_ROW_NONE for padding, pairs counted by another rank and walls of
   triangles. */
static uint32_t watched_pair(const struct dem_state *p, uint32_t row)
{
    const uint32_t k = p->contacts.row_pair[row];
    const struct dem_pair *const q = k == DEM_ROW_NONE ? NULL : &p->contacts.pair[k];

    if (!q || q->i >= p->particles.n)
    {
        return DEM_ROW_NONE;
    }
    const int wall = q->wall ? p->walls.facet[p->pairs.wall_facet[q->j]].wall : -1;

    return wall >= 0 && p->walls.wall[wall].shape == DEM_SHAPE_TRIANGLES ? DEM_ROW_NONE : k;
}

static uint64_t hash_of(const struct dem_state *p, const struct dem_pair *q)
{
    const int64_t other = q->wall ? -1 - p->pairs.wall_facet[q->j] : p->particles.record[q->j].id;

    return dem_random_bits(0, (uint64_t)p->particles.record[q->i].id, (uint64_t)other, 0);
}

/* A pair that left the contact rows while apart is recognised when it returns: it was not seen in
   the step before. */
static void update_pair(struct dem_contact_durations *d, struct dem_contact_duration *p,
                        int touches, int32_t now)
{
    if (p->age > 0 && (!touches || p->seen < now - 1))
    {
        count_contact(d, p->age, p->seen);
        p->age = 0;
    }
    p->age = touches ? p->age < 0 ? -1 : p->age + 1 : 0;
    p->seen = now;
    if (p->age > DEM_CONTACT_DURATIONS_MAX)
    {
        count_contact(d, p->age, now);
        p->age = -1;
    }
}

/* ---- rebuilt lists --------------------------------------------------------------------------- */

static int by_name(const void *a, const void *b)
{
    const struct dem_contact_duration *const x = a, *const y = b;

    return (x->name > y->name) - (x->name < y->name);
}

/* Collective: all ranks rebuild lists together, and a pair may have moved to another rank. */
static int gather(struct dem_contact_durations *d, const struct dem_decomposition *q)
{
    const struct dem_collect_items own = {"watched contacts", d->saved, d->saved_count,
                                          sizeof *d->saved};
    size_t total;
    void *all;

    if (q->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_collect_gather(q, DEM_OK, &own, &all, &total));
    dem_memory_free(d->saved);
    d->saved = all;
    d->saved_count = d->saved_capacity = total;
    return DEM_OK;
}

/* Save the pairs of the old lists that touched in the last step; count those that ended outside of
   the contact rows. */
static int save_touching(struct dem_contact_durations *d, const struct dem_decomposition *q,
                         int32_t now)
{
    d->saved_count = 0;
    for (size_t k = 0; k < d->pairs; k++)
    {
        const struct dem_contact_duration *const p = &d->pair[k];

        if (p->age > 0 && p->seen < now - 1)
        {
            count_contact(d, p->age, p->seen);
        }
        else if (p->age > 0 && !DEM_GROW(d->saved, d->saved_capacity,
                                         d->saved_count + 1))     /* left out if memory is short */
        {
            d->saved[d->saved_count++] = *p;
        }
    }
    DEM_TRY(gather(d, q));
    if (d->saved_count > 0)
    {
        dem_sort_by(d->saved, d->saved_count, sizeof *d->saved, by_name);
    }
    return DEM_OK;
}

/* New lists: saved contacts continue; others that touch now are left out. */
static int begin_lists(struct dem_contact_durations *d, const struct dem_state *p, int32_t now)
{
    DEM_TRY(DEM_GROW(d->pair, d->capacity, p->contacts.pairs));
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
        const int touches = dem_contacts_force(&p->contacts, r).arm > 0.0;
        const struct dem_contact_duration own = {
            .name = hash_of(p, &p->contacts.pair[k]),
            .age = touches ? -1 : 0};
        const struct dem_contact_duration *const old =
            d->saved_count > 0 ? bsearch(&own, d->saved, d->saved_count, sizeof own, by_name)
                               : NULL;

        d->pair[k] = old ? *old : own;
        update_pair(d, &d->pair[k], touches, now);
    }
    d->saved_count = 0;
    return DEM_OK;
}

/* Count contacts that ended outside of the contact rows and did not return. */
static void finish(struct dem_contact_durations *d, int32_t now)
{
    for (size_t k = 0; k < d->pairs; k++)
    {
        if (d->pair[k].age > 0 && d->pair[k].seen < now)
        {
            count_contact(d, d->pair[k].age, d->pair[k].seen);
        }
    }
    d->pairs = 0;
}

int dem_contact_durations_record(struct dem_contact_durations *d, const struct dem_state *p)
{
    const int32_t now = (int32_t)((p->steps - 1)%DEM_CONTACT_DURATIONS_PERIOD);
    const int continues = p->steps == d->last + 1 && now > 0, same = p->rebuilds == d->rebuilds;

    d->last = p->steps;
    if (!continues || !same)
    {
        DEM_TRY(continues ? save_touching(d, &p->decomposition, now) : DEM_OK);
        return begin_lists(d, p, now);
    }
    for (uint32_t r = 0; r < p->contacts.rows; r++)
    {
        const uint32_t k = watched_pair(p, r);

        if (k != DEM_ROW_NONE)
        {
            d->pair[k].name =
                d->pair[k].age == 0 ? hash_of(p, &p->contacts.pair[k]) : d->pair[k].name;
            update_pair(d, &d->pair[k], dem_contacts_force(&p->contacts, r).arm > 0.0, now);
        }
    }
    if (now == DEM_CONTACT_DURATIONS_WATCHED - 1)
    {
        finish(d, now);
    }
    return DEM_OK;
}

void dem_contact_durations_free(struct dem_contact_durations *d)
{
    dem_memory_free(d->pair);
    dem_memory_free(d->saved);
    *d = (struct dem_contact_durations){.asked = 0};
}

void dem_contact_durations_report(const struct dem_state *p, int64_t *watched, int64_t *longer,
                                  int *shortest, int *median)
{
    int64_t count[DEM_CONTACT_DURATIONS_MAX + 2], below = 0;

    memcpy(count, p->durations->count, sizeof count);
    dem_collect_sum_int64(&p->decomposition, count, DEM_CONTACT_DURATIONS_MAX + 2);
    *watched = *shortest = *median = 0;
    *longer = count[DEM_CONTACT_DURATIONS_MAX + 1];
    for (int k = 1; k < DEM_CONTACT_DURATIONS_MAX + 2; k++)
    {
        *watched += count[k];
        *shortest = *shortest == 0 && count[k] > 0 ? k : *shortest;
    }
    for (int k = 1; k < DEM_CONTACT_DURATIONS_MAX + 2 && *median == 0 && *watched > 0; k++)
    {
        below += count[k];
        *median = 2*below >= *watched ? k : 0;
    }
}
