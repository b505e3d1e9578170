/*
 * contact_forces.c -- memory of the contact forces; places of the rows.
 *
 * A batch of particles is summed as soon as the last row that it needs has been computed. A row that
 * is then still in the ring is read from there; a row that has been overwritten is deferred.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "model/contact_forces.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

void dem_contact_forces_free(struct dem_contact_forces *c)
{
    dem_contact_forces_release(c);
    dem_contact_forces_clear(c);
    dem_memory_free(c->kept_row);
    memset(c, 0, sizeof *c);
}

static size_t bytes_of_place(const struct dem_contact_forces *c)
{
    return sizeof *c->force + (c->moments ? sizeof *c->moment : 0);
}

static size_t bytes_of_row(const struct dem_contact_forces *c)
{
    return (c->has_energy ? sizeof *c->energy : 0) + (size_t)(2*c->rates)*sizeof *c->rate;
}

size_t dem_contact_forces_ring_bytes(const struct dem_contact_forces *c)
{
    return DEM_FORCE_BUFFER_ROWS*bytes_of_place(c);
}

size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *c, int ring)
{
    return (ring && !c->keep ? 0 : bytes_of_place(c)) + bytes_of_row(c);
}

size_t dem_contact_forces_bytes(const struct dem_contact_forces *c)
{
    return (c->capacity + c->row_force_capacity)*bytes_of_place(c) +
           c->row_capacity*bytes_of_row(c) + c->kept_capacity*sizeof *c->kept_row;
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

static int allocate_rows(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    if (!c->ring || !c->keep)
    {
        release(&c->row_force, &c->row_moment, &c->row_force_capacity);
        return DEM_OK;
    }
    return allocate(&c->row_force, &c->row_moment, &c->row_force_capacity, c->moments,
                    rows->n + DEM_PADDING_ROWS, rows->capacity);
}

static void clear_places(struct dem_contact_forces *c, size_t first, size_t n)
{
    memset(c->force + first, 0, n*sizeof *c->force);
    if (c->moment)
    {
        memset(c->moment + first, 0, n*sizeof *c->moment);
    }
}

int dem_contact_forces_allocate(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    const size_t n = c->ring ? c->ring + c->kept : rows->n + DEM_PADDING_ROWS;

    DEM_TRY(allocate(&c->force, &c->moment, &c->capacity, c->moments, n,
                     c->ring ? n + c->kept/8 : rows->capacity));
    /* that of entries without a row */
    clear_places(c, c->ring ? c->ring : rows->n, c->ring ? 1 : DEM_PADDING_ROWS);
    return allocate_rows(c, rows);
}

int dem_contact_forces_keep(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    c->keep = 1;
    return c->force ? allocate_rows(c, rows) : DEM_OK;
}

/* ---- places ---------------------------------------------------------------------------------- */

/* 1 when the row is still in the ring when the particle is summed: at the end of the batch that holds
   the last row needed. */
static int is_in_ring(const struct dem_contact_rows *r, uint32_t row, size_t particle)
{
    return r->needed[particle/DEM_BATCH_ROWS] + 2*DEM_BATCH_ROWS <= row + DEM_FORCE_BUFFER_ROWS;
}

static const struct dem_pair *pair_of(const struct dem_contact_rows *r,
                                      const struct dem_pair_list *p, uint32_t row)
{
    return row >= r->n || r->pair[row] == DEM_ROW_NONE ? NULL : &p->pair[r->pair[row]];
}

static int is_deferred(const struct dem_contact_rows *r, const struct dem_pair *q, uint32_t row,
                       size_t n)
{
    return (q->i < n && !is_in_ring(r, row, q->i)) || (q->j < n && !is_in_ring(r, row, q->j));
}

static size_t count_deferred(const struct dem_contact_rows *r, const struct dem_pair_list *p,
                             size_t n)
{
    size_t count = 0;

    for (uint32_t row = 0; row < r->n; row++)
    {
        const struct dem_pair *const q = pair_of(r, p, row);

        count += q && !q->wall && is_deferred(r, q, row, n);
    }
    return count;
}

static int keep_row(struct dem_contact_forces *c, uint32_t row)
{
    DEM_TRY(DEM_GROW(c->kept_row, c->kept_capacity, c->kept + 1));
    c->kept_row[c->kept++] = row;
    return DEM_OK;
}

/* Whole batches, because a batch is stored as a whole. */
static int place_walls(struct dem_contact_forces *c, struct dem_contact_rows *r,
                       const struct dem_pair_list *p)
{
    for (int s = 0; s < r->classes; s++)
    {
        struct dem_segment *const segment = &r->segment[s];
        const int wall = segment->count > 0 && pair_of(r, p, segment->first)->wall;

        segment->place = c->ring + (uint32_t)c->kept;
        for (uint32_t k = 0; wall && k < (segment->count + DEM_BATCH_ROWS - 1)/DEM_BATCH_ROWS*
                                            DEM_BATCH_ROWS; k++)
        {
            DEM_TRY(keep_row(c, segment->first + k));
        }
    }
    return DEM_OK;
}

static int place_deferred(struct dem_contact_forces *c, const struct dem_contact_rows *r,
                          const struct dem_pair_list *p, size_t n)
{
    c->first_deferred = c->kept;
    for (uint32_t row = 0; row < r->n; row++)
    {
        const struct dem_pair *const q = pair_of(r, p, row);

        DEM_TRY(q && !q->wall && is_deferred(r, q, row, n) ? keep_row(c, row) : DEM_OK);
    }
    return DEM_OK;
}

static uint32_t find_deferred(const struct dem_contact_forces *c, uint32_t row)
{
    size_t low = c->first_deferred, high = c->kept - 1;

    while (low < high)
    {
        const size_t middle = low + (high - low)/2;

        low = c->kept_row[middle] < row ? middle + 1 : low;
        high = c->kept_row[middle] < row ? high : middle;
    }
    return c->ring + (uint32_t)low;
}

/* The place that a particle reads a row from. */
static uint32_t place_of(const struct dem_contact_forces *c, const struct dem_contact_rows *r,
                         const struct dem_pair_list *p, uint32_t row, size_t particle)
{
    const struct dem_pair *const q = pair_of(r, p, row);

    return !q                             ? c->ring
           : q->wall                      ? r->segment[q->class].place + row -
                                                r->segment[q->class].first
           : is_in_ring(r, row, particle) ? row & (c->ring - 1)
                                          : find_deferred(c, row);
}

static void place_entries(const struct dem_contact_forces *c, struct dem_contact_rows *r,
                          const struct dem_pair_list *p, size_t n)
{
    enum { BITS = (1 << DEM_ENTRY_PLACE_SHIFT) - 1 };

    for (size_t i = 0; i < n; i++)
    {
        for (uint32_t e = r->start[i]; e < r->start[i + 1]; e++)
        {
            r->entry[e] = place_of(c, r, p, r->entry[e] >> DEM_ENTRY_PLACE_SHIFT, i)
                              << DEM_ENTRY_PLACE_SHIFT |
                          (r->entry[e] & BITS);
        }
    }
}

int dem_contact_forces_place_rows(struct dem_contact_forces *c, struct dem_contact_rows *r,
                                  const struct dem_pair_list *p, size_t n)
{
    /* deferred rows are written twice: at most 1 in 8 */
    enum { ROWS_PER_DEFERRED = 8 };

    c->ring = 0;
    c->kept = 0;
    if (r->n <= DEM_FORCE_BUFFER_ROWS || ROWS_PER_DEFERRED*count_deferred(r, p, n) > r->n)
    {
        return DEM_OK;
    }
    c->ring = DEM_FORCE_BUFFER_ROWS;
    DEM_TRY(keep_row(c, r->n));
    DEM_TRY(place_walls(c, r, p));
    DEM_TRY(place_deferred(c, r, p, n));
    place_entries(c, r, p, n);
    return DEM_OK;
}
