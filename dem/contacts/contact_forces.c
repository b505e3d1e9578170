/*
 * contact_forces.c -- memory of the contact forces; slots of the rows.
 *
 * A batch of particles is summed as soon as the last row that it needs has been computed. A row that
 * is then still in the ring is read from there; a row that has been overwritten is deferred.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/contact_forces.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

enum
{
    ROWS_PER_DEFERRED = 8    /* at least, where there is a ring: deferred rows are written twice */
};

void dem_contact_forces_free(struct dem_contact_forces *c)
{
    dem_contact_forces_release(c);
    dem_contact_forces_clear(c);
    dem_memory_free(c->slot_row);
    dem_memory_free(c->deferred);
    dem_memory_free(c->deferred_before);
    memset(c, 0, sizeof *c);
}

static size_t bytes_of_slot(const struct dem_contact_forces *c)
{
    return sizeof *c->force + (c->moments ? sizeof *c->moment : 0);
}

static size_t bytes_of_row(const struct dem_contact_forces *c)
{
    return (c->has_energy ? sizeof *c->energy : 0) + (size_t)(2*c->rates)*sizeof *c->rate;
}

size_t dem_contact_forces_ring_bytes(const struct dem_contact_forces *c)
{
    return DEM_FORCE_BUFFER_ROWS*bytes_of_slot(c);
}

size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *c, int ring)
{
    return (ring ? bytes_of_slot(c)/ROWS_PER_DEFERRED : 0) +
           (!ring || c->all_rows ? bytes_of_slot(c) : 0) + bytes_of_row(c);
}

size_t dem_contact_forces_bytes(const struct dem_contact_forces *c)
{
    return (c->capacity + c->row_force_capacity)*bytes_of_slot(c) +
           c->row_capacity*bytes_of_row(c) + c->slot_row_capacity*sizeof *c->slot_row +
           c->deferred_capacity*sizeof *c->deferred +
           c->before_capacity*sizeof *c->deferred_before;
}

/* ---- energies and rates ---------------------------------------------------------------------- */

int dem_contact_forces_resize(struct dem_contact_forces *c, size_t n, size_t capacity)
{
    if (c->has_energy)
    {
        DEM_TRY(DEM_RESIZE(c->energy, c->row_capacity, capacity));
        memset(c->energy, 0, n*sizeof *c->energy);
    }
    if (c->rates)
    {
        const size_t width = 2*(size_t)c->rates;

        DEM_TRY(DEM_RESIZE(c->rate, width*c->row_capacity, width*capacity));
        memset(c->rate, 0, width*n*sizeof *c->rate);
    }
    c->row_capacity = capacity;
    return DEM_OK;
}

void dem_contact_forces_clear(struct dem_contact_forces *c)
{
    dem_memory_free(c->energy);
    dem_memory_free(c->rate);
    c->energy = NULL;
    c->rate = NULL;
    c->row_capacity = 0;
}

/* ---- forces and moments ---------------------------------------------------------------------- */

static void release(struct dem_contact_force **force, struct dem_contact_moment **moment,
                    size_t *capacity)
{
    dem_memory_free(*force);
    dem_memory_free(*moment);
    *force = NULL;
    *moment = NULL;
    *capacity = 0;
}

void dem_contact_forces_release(struct dem_contact_forces *c)
{
    c->touching = 0;
    release(&c->force, &c->moment, &c->capacity);
    release(&c->row_force, &c->row_moment, &c->row_force_capacity);
}

/* `capacity` records where there are fewer than n. */
static int allocate(struct dem_contact_force **force, struct dem_contact_moment **moment,
                    size_t *present, int moments, size_t n, size_t capacity)
{
    if (n <= *present)
    {
        return DEM_OK;
    }
    release(force, moment, present);
    DEM_TRY(DEM_NEW(*force, capacity));
    DEM_TRY(moments ? DEM_NEW(*moment, capacity) : DEM_OK);
    *present = capacity;
    return DEM_OK;
}

/* Zero: what entries without a row read. */
static void clear(struct dem_contact_force *force, struct dem_contact_moment *moment, size_t first,
                  size_t n)
{
    memset(force + first, 0, n*sizeof *force);
    if (moment)
    {
        memset(moment + first, 0, n*sizeof *moment);
    }
}

static int allocate_rows(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    if (!c->ring || !c->all_rows)
    {
        release(&c->row_force, &c->row_moment, &c->row_force_capacity);
        return DEM_OK;
    }
    DEM_TRY(allocate(&c->row_force, &c->row_moment, &c->row_force_capacity, c->moments,
                     rows->n + DEM_PADDING_ROWS, rows->capacity));
    clear(c->row_force, c->row_moment, rows->n, DEM_PADDING_ROWS);
    return DEM_OK;
}

int dem_contact_forces_allocate(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    const size_t n = c->ring ? c->ring + c->own_slots : rows->n + DEM_PADDING_ROWS;

    DEM_TRY(allocate(&c->force, &c->moment, &c->capacity, c->moments, n,
                     c->ring ? n + c->own_slots/8 : rows->capacity));
    clear(c->force, c->moment, c->ring ? c->ring : rows->n, c->ring ? 1 : DEM_PADDING_ROWS);
    return allocate_rows(c, rows);
}

/* ---- slots ---------------------------------------------------------------------------------- */

enum
{
    WORD = 64    /* rows of a word of `deferred` */
};

/* Marks the rows that a particle sums when they are no more in the ring; never rows of walls, as the
   oldest row in the ring is before them. *count: their number. */
static int mark_deferred(struct dem_contact_forces *c, const struct dem_contact_rows *r, size_t n,
                         size_t *count)
{
    const size_t words = r->n/WORD + 1;

    DEM_TRY(DEM_GROW(c->deferred, c->deferred_capacity, words));
    DEM_TRY(DEM_GROW(c->deferred_before, c->before_capacity, words));
    memset(c->deferred, 0, words*sizeof *c->deferred);
    for (size_t i = 0; i < n; i++)
    {
        const int64_t oldest = dem_contact_forces_oldest(c, r, i);

        for (uint32_t e = r->start[i]; e < r->start[i + 1]; e++)
        {
            const uint32_t row = r->entry[e] >> DEM_ENTRY_SLOT_SHIFT;

            if (row < oldest)
            {
                c->deferred[row/WORD] |= UINT64_C(1) << row%WORD;
            }
        }
    }
    *count = 0;
    for (size_t k = 0; k < words; k++)
    {
        c->deferred_before[k] = (uint32_t)*count;
        *count += (size_t)__builtin_popcountll(c->deferred[k]);
    }
    return DEM_OK;
}

/* After the ring: the slot without a row, the slots of walls, the deferred slots. */
static int list_own_slots(struct dem_contact_forces *c, const struct dem_contact_rows *r,
                          size_t deferred)
{
    const size_t n = 1 + r->n - r->walls + deferred;

    DEM_TRY(DEM_GROW(c->slot_row, c->slot_row_capacity, n));
    uint32_t *to = c->slot_row;

    *to++ = r->n;
    for (uint32_t row = r->walls; row < r->n; row++)
    {
        *to++ = row;
    }
    c->first_deferred = (size_t)(to - c->slot_row);
    for (uint32_t k = 0; k*WORD < r->n; k++)
    {
        for (uint64_t left = c->deferred[k]; left; left &= left - 1)
        {
            *to++ = k*WORD + (uint32_t)__builtin_ctzll(left);
        }
    }
    c->own_slots = n;
    return DEM_OK;
}

static uint32_t slot_of_deferred(const struct dem_contact_forces *c, uint32_t row)
{
    const uint64_t before = c->deferred[row/WORD] & ((UINT64_C(1) << row%WORD) - 1);

    return c->ring + (uint32_t)c->first_deferred + c->deferred_before[row/WORD] +
           (uint32_t)__builtin_popcountll(before);
}

/* The slot of a row that is not in the ring when a particle sums it. */
static uint32_t own_slot(const struct dem_contact_forces *c, const struct dem_contact_rows *r,
                         uint32_t row)
{
    return row >= r->n       ? c->ring
           : row >= r->walls ? c->ring + 1 + (row - r->walls)
                             : slot_of_deferred(c, row);
}

static void assign_entries(const struct dem_contact_forces *c, struct dem_contact_rows *r,
                           size_t n)
{
    enum { BITS = (1 << DEM_ENTRY_SLOT_SHIFT) - 1 };

    const uint32_t in_ring = c->ring << DEM_ENTRY_SLOT_SHIFT, walls = r->walls;

    for (size_t i = 0; i < n; i++)
    {
        const int64_t oldest = dem_contact_forces_oldest(c, r, i);

        for (uint32_t e = r->start[i]; e < r->start[i + 1]; e++)
        {
            const uint32_t entry = r->entry[e], row = entry >> DEM_ENTRY_SLOT_SHIFT;

            r->entry[e] = row >= oldest && row < walls    /* most */
                              ? entry & (in_ring - 1)
                              : own_slot(c, r, row) << DEM_ENTRY_SLOT_SHIFT | (entry & BITS);
        }
    }
    for (int s = 0; s < r->classes; s++)
    {
        if (r->segment[s].first >= r->walls)
        {
            r->segment[s].slot = c->ring + 1 + (r->segment[s].first - r->walls);
        }
    }
}

int dem_contact_forces_assign_slots(struct dem_contact_forces *c, struct dem_contact_rows *r,
                                    size_t n)
{
    size_t deferred;

    c->own_slots = 0;
    for (c->ring = DEM_FORCE_BUFFER_ROWS; c->ring <= DEM_FORCE_BUFFER_MAX_ROWS && c->ring < r->n;
         c->ring *= 2)
    {
        DEM_TRY(mark_deferred(c, r, n, &deferred));
        if (ROWS_PER_DEFERRED*deferred <= r->n)
        {
            DEM_TRY(list_own_slots(c, r, deferred));
            assign_entries(c, r, n);
            return DEM_OK;
        }
    }
    c->ring = 0;
    return DEM_OK;
}
