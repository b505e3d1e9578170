/*
 * contacts_buffer.c -- decides which contact forces pass through the force buffer, and whether it
 * pays.
 *
 * A batch of particles is summed as soon as the last row that it needs has been computed. A row
 * that is then still in the buffer is read from there; a row that has been overwritten is deferred:
 * it is stored at its own index as well. The buffer pays when at most one row in eight is deferred.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/memory.h"
#include "model/contacts.h"

size_t dem_contacts_force_buffer_bytes(const struct dem_contacts *c)
{
    return DEM_FORCE_BUFFER_ROWS*
           (c->single ? sizeof *c->force_buffer_single : sizeof *c->force_buffer);
}

/* 1 when the row is still in the force buffer when the particle is summed: at the end of the batch
   that holds the last row needed. */
static int is_buffered(const struct dem_contacts *c, uint32_t row, size_t particle)
{
    return c->rows_needed[particle/DEM_BATCH_ROWS] + 2*DEM_BATCH_ROWS <=
           row + DEM_FORCE_BUFFER_ROWS;
}

static void mark_buffered(struct dem_contacts *c, size_t n)
{
    for (size_t i = 0; i < n; i++)
    {
        for (uint32_t e = c->row_start[i]; e < c->row_start[i + 1]; e++)
        {
            const uint32_t row = c->row_entry[e] >> DEM_ENTRY_ROW_SHIFT;

            if (row < c->rows && !c->pair[c->row_pair[row]].wall && is_buffered(c, row, i))
            {
                c->row_entry[e] |= DEM_ENTRY_BUFFERED;
            }
        }
    }
}

static int list_deferred(struct dem_contacts *c, size_t n)
{
    c->deferred_rows = 0;
    for (uint32_t row = 0; row < c->rows; row++)
    {
        const struct dem_pair *const q =
            c->row_pair[row] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[row]];

        if (q && !q->wall &&
            ((q->i < n && !is_buffered(c, row, q->i)) || (q->j < n && !is_buffered(c, row, q->j))))
        {
            DEM_TRY(DEM_GROW(c->deferred_row, c->deferred_capacity, c->deferred_rows + 1));
            c->deferred_row[c->deferred_rows++] = row;
        }
    }
    return DEM_OK;
}

int dem_contacts_make_force_buffer(struct dem_contacts *c, size_t n)
{
    /* deferred rows are written twice: at most 1 in 8 */
    enum { ROWS_PER_DEFERRED = 8 };

    DEM_TRY(list_deferred(c, n));

    const int pays =
        c->rows > DEM_FORCE_BUFFER_ROWS && ROWS_PER_DEFERRED*c->deferred_rows <= c->rows;

    if (pays && !dem_contacts_use_force_buffer(c))
    {
        DEM_TRY(c->single ? DEM_NEW(c->force_buffer_single, DEM_FORCE_BUFFER_ROWS)
                          : DEM_NEW(c->force_buffer, DEM_FORCE_BUFFER_ROWS));
    }
    else if (!pays)
    {
        dem_memory_free(c->force_buffer);
        dem_memory_free(c->force_buffer_single);
        c->force_buffer = NULL;
        c->force_buffer_single = NULL;
    }
    if (pays)
    {
        mark_buffered(c, n);
    }
    return DEM_OK;
}
