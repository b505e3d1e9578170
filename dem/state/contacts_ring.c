/*
 * contacts_ring.c -- which pushes may go round in the ring of contacts.h, and whether it pays.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/memory.h"
#include "state/contacts.h"

size_t dem_contacts_ring(const struct dem_contacts *c)
{
    return DEM_RING*(c->single ? sizeof *c->ring_single : sizeof *c->ring);
}

/* A block of particles sums as soon as its last row is swept, at the end of that row's block: is this row still in the ring then? */
static int is_soon(const struct dem_contacts *c, uint32_t row, size_t particle)
{
    return c->ready[particle/DEM_BLOCK] + 2*DEM_BLOCK <= row + DEM_RING;
}

static void mark_soon(struct dem_contacts *c, size_t n)
{
    for (size_t i = 0; i < n; i++)
    {
        for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
        {
            const uint32_t row = c->near_entry[e] >> DEM_ENTRY_ROW;

            if (row < c->rows && !c->pair[c->row_pair[row]].wall && is_soon(c, row, i))
            {
                c->near_entry[e] |= DEM_ENTRY_SOON;
            }
        }
    }
}

static int list_far(struct dem_contacts *c, size_t n)
{
    c->fars = 0;
    for (uint32_t row = 0; row < c->rows; row++)
    {
        const struct dem_pair *const q = c->row_pair[row] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[row]];

        if (q && !q->wall && ((q->i < n && !is_soon(c, row, q->i)) || (q->j < n && !is_soon(c, row, q->j))))
        {
            DEM_TRY(DEM_GROW(c->far, c->far_room, c->fars + 1));
            c->far[c->fars++] = row;
        }
    }
    return DEM_OK;
}

/* Rows that are far are written twice. */
int dem_contacts_make_ring(struct dem_contacts *c, size_t n)
{
    enum { WORTH = 8 };                                   /* far rows: at most one of so many */

    DEM_TRY(list_far(c, n));

    const int pays = c->rows > DEM_RING && WORTH*c->fars <= c->rows;

    if (pays && !dem_contacts_go_round(c))
    {
        DEM_TRY(c->single ? DEM_NEW(c->ring_single, DEM_RING) : DEM_NEW(c->ring, DEM_RING));
    }
    else if (!pays)
    {
        dem_memory_free(c->ring);
        dem_memory_free(c->ring_single);
        c->ring = NULL;
        c->ring_single = NULL;
    }
    if (pays)
    {
        mark_soon(c, n);
    }
    return DEM_OK;
}
