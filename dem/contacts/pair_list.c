/*
 * pair_list.c -- pairs sorted by class and particle; the pairs of each owned particle, in the order in
 * which it sums them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/pair_list.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include <string.h>

void dem_pair_list_free(struct dem_pair_list *c)
{
    dem_memory_free(c->pair);
    dem_memory_free(c->start);
    dem_memory_free(c->entry);
    memset(c, 0, sizeof *c);
}

size_t dem_pair_list_bytes(const struct dem_pair_list *c)
{
    return c->capacity*sizeof *c->pair + c->entry_capacity*sizeof *c->entry +
           c->start_capacity*sizeof *c->start;
}

/* ---- sort ------------------------------------------------------------------------------------ */

static size_t class_of(const struct dem_pair *q)
{
    return q->class;
}

/* The partner that comes first in memory: an owned particle. */
static size_t first_of(const struct dem_pair *q)
{
    return !q->wall && q->j < q->i ? q->j : q->i;
}

/* Stable counting sort; the list has no spare memory afterwards. */
static int sort_by(struct dem_pair_list *c, size_t (*bin)(const struct dem_pair *), size_t bins)
{
    struct dem_pair *sorted;
    uint32_t *start = NULL;

    DEM_TRY(DEM_NEW(start, bins + 1));
    const int status = DEM_NEW(sorted, c->n + 1);

    for (size_t k = 0; k < c->n && !status; k++)
    {
        start[bin(&c->pair[k]) + 1]++;
    }
    for (size_t s = 1; s <= bins; s++)
    {
        start[s] += start[s - 1];
    }
    for (size_t k = 0; k < c->n && !status; k++)
    {
        sorted[start[bin(&c->pair[k])]++] = c->pair[k];
    }
    dem_memory_free(start);
    DEM_TRY(status);
    dem_memory_free(c->pair);
    c->pair = sorted;
    c->capacity = c->n + 1;
    return DEM_OK;
}

int dem_pair_list_sort(struct dem_pair_list *c, size_t particles, size_t classes)
{
    DEM_TRY(sort_by(c, first_of, particles));
    return classes < 2 ? DEM_OK : sort_by(c, class_of, classes);
}

/* ---- adjacency ------------------------------------------------------------------------------- */

/* Keys of the order of a particle's sum: partner id, then image; walls after all particles, by
   facet (the list of wall neighbors is in that order). */
static void list_keys(const struct dem_pair_list *c, const struct dem_particles *particles,
                      const uint32_t *entry, uint32_t count, struct dem_sort_pair *pair)
{
    for (uint32_t k = 0; k < count; k++)
    {
        const struct dem_pair *const q = &c->pair[entry[k] >> 1];
        const uint64_t other =
            q->wall ? (uint64_t)1 << 63 | q->j
                    : (uint64_t)particles->record[entry[k] & 1 ? q->i : q->j].id;

        pair[k] =
            (struct dem_sort_pair){.hi = other, .lo = q->wall ? 0 : q->shift, .index = entry[k]};
    }
}

static void sort_by_insertion(struct dem_sort_pair *pair, uint32_t count)
{
    for (uint32_t k = 1; k < count; k++)
    {
        const struct dem_sort_pair here = pair[k];
        uint32_t m = k;

        for (; m > 0 && (pair[m - 1].hi > here.hi ||
                         (pair[m - 1].hi == here.hi && pair[m - 1].lo > here.lo));
             m--)
        {
            pair[m] = pair[m - 1];
        }
        pair[m] = here;
    }
}

/* A large particle may have thousands of small neighbors: they are sorted in linear time. */
static int sort_entries(struct dem_pair_list *c, const struct dem_particles *particles)
{
    /* limit of insertion sort; equal spheres: about 15 */
    enum { INSERTION_LIMIT = 32 };

    struct dem_sort_pair *pair = NULL;
    size_t capacity = 0;

    for (size_t i = 0; i < particles->n; i++)
    {
        uint32_t *const entry = c->entry + c->start[i];
        const uint32_t count = c->start[i + 1] - c->start[i];
        const int grown = DEM_GROW(pair, capacity, 2*(size_t)count);

        if (grown)
        {
            dem_memory_free(pair);
            return grown;
        }
        list_keys(c, particles, entry, count, pair);
        if (count <= INSERTION_LIMIT)
        {
            sort_by_insertion(pair, count);
        }
        else
        {
            dem_sort_pairs(pair, count, pair + count);
        }
        for (uint32_t k = 0; k < count; k++)
        {
            entry[k] = pair[k].index;
        }
    }
    dem_memory_free(pair);
    return DEM_OK;
}

int dem_pair_list_build_adjacency(struct dem_pair_list *c, const struct dem_particles *particles)
{
    const size_t n = particles->n, capacity = dem_memory_capacity(c->start_capacity, n + 2);

    DEM_TRY(DEM_RESIZE(c->start, c->start_capacity, capacity));
    c->start_capacity = capacity;
    memset(c->start, 0, (n + 2)*sizeof *c->start);
    for (size_t k = 0; k < c->n; k++)
    {
        const struct dem_pair *const q = &c->pair[k];

        if (q->i < n)
        {
            c->start[q->i + 2]++;
        }
        if (!q->wall && q->j < n)
        {
            c->start[q->j + 2]++;
        }
    }
    for (size_t i = 2; i < n + 2; i++)
    {
        c->start[i] += c->start[i - 1];
    }
    const size_t entries = c->start[n + 1],
                 entry_capacity = dem_memory_capacity(c->entry_capacity, entries);

    DEM_TRY(DEM_RESIZE(c->entry, c->entry_capacity, entry_capacity));
    c->entry_capacity = entry_capacity;
    for (size_t k = 0; k < c->n; k++)
    {
        const struct dem_pair *const q = &c->pair[k];

        if (q->i < n)
        {
            c->entry[c->start[q->i + 1]++] = (uint32_t)(2*k);
        }
        if (!q->wall && q->j < n)
        {
            c->entry[c->start[q->j + 1]++] = (uint32_t)(2*k + 1);
        }
    }
    return sort_entries(c, particles);
}
