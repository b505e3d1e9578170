/*
 * contact_forces.c -- memory of the contact forces; which of them pass through the force buffer.
 *
 * A batch of particles is summed as soon as the last row that it needs has been computed. A row
 * that is then still in the buffer is read from there; a row that has been overwritten is deferred:
 * it is stored at its own index as well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "model/contact_forces.h"
#include "core/error.h"
#include "core/memory.h"
#include "effects/batch.h"
#include <string.h>

static void free_buffer(struct dem_contact_forces *c)
{
    dem_memory_free(c->buffer);
    dem_memory_free(c->moment_buffer);
    c->buffer = NULL;
    c->moment_buffer = NULL;
}

void dem_contact_forces_free(struct dem_contact_forces *c)
{
    dem_contact_forces_release(c);
    dem_contact_forces_clear(c);
    free_buffer(c);
    dem_memory_free(c->deferred_row);
    memset(c, 0, sizeof *c);
}

static size_t bytes_beside_force(const struct dem_contact_forces *c)
{
    return (c->moments ? sizeof *c->moment : 0) + (c->has_energy ? sizeof *c->energy : 0) +
           (size_t)(2*c->rates)*sizeof *c->rate;
}

size_t dem_contact_forces_bytes_per_row(const struct dem_contact_forces *c)
{
    return sizeof *c->force + bytes_beside_force(c);
}

size_t dem_contact_forces_buffer_bytes(const struct dem_contact_forces *c)
{
    return DEM_FORCE_BUFFER_ROWS*(sizeof *c->buffer + (c->moments ? sizeof *c->moment_buffer : 0));
}

size_t dem_contact_forces_bytes(const struct dem_contact_forces *c)
{
    return c->moment_capacity*bytes_beside_force(c) + c->capacity*sizeof *c->force +
           c->deferred_capacity*sizeof *c->deferred_row +
           (dem_contact_forces_use_buffer(c) ? dem_contact_forces_buffer_bytes(c) : 0);
}

/* ---- per row --------------------------------------------------------------------------------- */

int dem_contact_forces_resize(struct dem_contact_forces *c, size_t n, size_t capacity)
{
    if (c->moments)
    {
        DEM_TRY(DEM_RESIZE(c->moment, c->moment_capacity, capacity));
        memset(c->moment, 0, n*sizeof *c->moment);
    }
    if (c->has_energy)
    {
        DEM_TRY(DEM_RESIZE(c->energy, c->moment_capacity, capacity));
        memset(c->energy, 0, n*sizeof *c->energy);
    }
    if (c->rates)
    {
        const size_t width = 2*(size_t)c->rates;

        DEM_TRY(DEM_RESIZE(c->rate, width*c->moment_capacity, width*capacity));
        memset(c->rate, 0, width*n*sizeof *c->rate);
    }
    c->moment_capacity = capacity;
    return DEM_OK;
}

void dem_contact_forces_clear(struct dem_contact_forces *c)
{
    dem_memory_free(c->moment);
    dem_memory_free(c->energy);
    dem_memory_free(c->rate);
    c->moment = NULL;
    c->energy = NULL;
    c->rate = NULL;
    c->moment_capacity = 0;
}

void dem_contact_forces_release(struct dem_contact_forces *c)
{
    dem_memory_free(c->force);
    c->force = NULL;
    c->capacity = 0;
}

int dem_contact_forces_allocate(struct dem_contact_forces *c, const struct dem_contact_rows *rows)
{
    if (rows->n + DEM_PADDING_ROWS > c->capacity)
    {
        dem_contact_forces_release(c);
        DEM_TRY(DEM_NEW(c->force, rows->capacity));
        c->capacity = rows->capacity;
    }
    else
    {
        memset(c->force + rows->n, 0, DEM_PADDING_ROWS*sizeof *c->force);
    }
    return DEM_OK;
}

/* ---- force buffer ---------------------------------------------------------------------------- */

/* 1 when the row is still in the force buffer when the particle is summed: at the end of the batch
   that holds the last row needed. */
static int is_buffered(const struct dem_contact_rows *c, uint32_t row, size_t particle)
{
    return c->needed[particle/DEM_BATCH_ROWS] + 2*DEM_BATCH_ROWS <=
           row + DEM_FORCE_BUFFER_ROWS;
}

static void mark_buffered(struct dem_contact_rows *c, const struct dem_pair_list *p, size_t n)
{
    for (size_t i = 0; i < n; i++)
    {
        for (uint32_t e = c->start[i]; e < c->start[i + 1]; e++)
        {
            const uint32_t row = c->entry[e] >> DEM_ENTRY_ROW_SHIFT;

            if (row < c->n && !p->pair[c->pair[row]].wall && is_buffered(c, row, i))
            {
                c->entry[e] |= DEM_ENTRY_BUFFERED;
            }
        }
    }
}

static int list_deferred(struct dem_contact_forces *c, const struct dem_contact_rows *r,
                         const struct dem_pair_list *p, size_t n)
{
    c->deferred = 0;
    for (uint32_t row = 0; row < r->n; row++)
    {
        const struct dem_pair *const q =
            r->pair[row] == DEM_ROW_NONE ? NULL : &p->pair[r->pair[row]];

        if (q && !q->wall &&
            ((q->i < n && !is_buffered(r, row, q->i)) || (q->j < n && !is_buffered(r, row, q->j))))
        {
            DEM_TRY(DEM_GROW(c->deferred_row, c->deferred_capacity, c->deferred + 1));
            c->deferred_row[c->deferred++] = row;
        }
    }
    return DEM_OK;
}

int dem_contact_forces_make_buffer(struct dem_contact_forces *c, struct dem_contact_rows *r,
                                   const struct dem_pair_list *p, size_t n)
{
    /* deferred rows are written twice: at most 1 in 8 */
    enum { ROWS_PER_DEFERRED = 8 };

    DEM_TRY(list_deferred(c, r, p, n));

    const int pays =
        r->n > DEM_FORCE_BUFFER_ROWS && ROWS_PER_DEFERRED*c->deferred <= r->n;

    if (pays && !dem_contact_forces_use_buffer(c))
    {
        DEM_TRY(DEM_NEW(c->buffer, DEM_FORCE_BUFFER_ROWS));
        DEM_TRY(c->moments ? DEM_NEW(c->moment_buffer, DEM_FORCE_BUFFER_ROWS) : DEM_OK);
    }
    else if (!pays)
    {
        free_buffer(c);
    }
    if (pays)
    {
        mark_buffered(r, p, n);
    }
    return DEM_OK;
}
