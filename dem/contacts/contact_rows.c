/*
 * contact_rows.c -- make the rows of the pairs that are near, and list the rows that each particle
 * sums.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/contact_rows.h"
#include "core/error.h"
#include "core/memory.h"
#include "laws/batch.h"
#include <string.h>

int dem_contact_rows_init(struct dem_contact_rows *c, int classes)
{
    memset(c, 0, sizeof *c);
    c->classes = classes;
    return DEM_NEW(c->segment, classes + 1);
}

void dem_contact_rows_free(struct dem_contact_rows *c)
{
    dem_contact_rows_clear(c);
    dem_memory_free(c->segment);
    dem_memory_free(c->start);
    dem_memory_free(c->entry);
    dem_memory_free(c->needed);
    memset(c, 0, sizeof *c);
}

void dem_contact_rows_clear(struct dem_contact_rows *c)
{
    dem_memory_free(c->pair);
    dem_memory_free(c->partners);
    c->pair = NULL;
    c->partners = NULL;
    c->n = 0;
    c->capacity = 0;
}

size_t dem_contact_rows_bytes(const struct dem_contact_rows *c)
{
    return c->capacity*(sizeof *c->pair + sizeof *c->partners) +
           c->start_capacity*sizeof *c->start + c->entry_capacity*sizeof *c->entry +
           c->needed_capacity*sizeof *c->needed;
}

static size_t count_rows(const struct dem_contact_rows *c, const struct dem_pair_list *p,
                         const uint8_t *near)
{
    size_t rows = 0;

    for (size_t k = 0; k < p->n; k++)
    {
        rows += near[k];
    }
    return rows + (size_t)(DEM_BATCH_ROWS*c->classes + DEM_PADDING_ROWS + DEM_ROWS_AHEAD);
}

/* Pairs are sorted by class, so the rows of a class follow each other. `from`: the former index of
   each row. Every pair is written to the next row and the index advances only if the pair is near:
   this avoids a branch that cannot be predicted. */
static void number_rows(struct dem_contact_rows *c, struct dem_pair_list *p, const uint8_t *near,
                        uint32_t *from)
{
    uint32_t row = 0;
    size_t k = 0;

    c->walls = 0;
    for (int s = 0; s < c->classes; s++)
    {
        const size_t first = k;

        c->segment[s].first = c->segment[s].slot = row;
        for (; k < p->n && p->pair[k].class == s; k++)
        {
            struct dem_pair *const q = &p->pair[k];

            c->partners[row] =
                (struct dem_row_partners){q->i, q->j | (uint32_t)q->shift << DEM_PARTNER_SHIFT};
            c->pair[row] = (uint32_t)k;
            from[row] = q->row;
            q->row = near[k] ? row : DEM_ROW_NONE;
            row += near[k];
        }
        c->segment[s].count = row - c->segment[s].first;
        /* so that no batch crosses the end of the force buffer */
        for (; row%DEM_BATCH_ROWS; row++)
        {
            c->partners[row] = c->partners[row - 1];
            c->pair[row] = from[row] = DEM_ROW_NONE;
        }
        c->walls = first < k && !p->pair[first].wall ? row : c->walls;
    }
    c->n = row;
    for (int k = 0; k < DEM_PADDING_ROWS; k++)
    {
        c->pair[row + (uint32_t)k] = DEM_ROW_NONE;
    }
    memset(c->partners + row, 0, DEM_ROWS_AHEAD*sizeof *c->partners);
}

static int grow_entries(struct dem_contact_rows *c, size_t limit)
{
    if (c->entry_capacity < limit)
    {
        dem_memory_free(c->entry);
        c->entry = NULL;
        c->entry_capacity = 0;
        DEM_TRY(DEM_GROW(c->entry, c->entry_capacity, limit));
    }
    return DEM_OK;
}

int dem_contact_rows_number(struct dem_contact_rows *c, struct dem_pair_list *p,
                            const uint8_t *near, size_t particles, const uint32_t **from)
{
    /* grow by little: rows take most of all memory */
    /* slots are 32 bits; with a ring there are some thousands more than rows (contact_forces.h) */
    const size_t limit = count_rows(c, p, near),
                 most = (UINT32_MAX >> DEM_ENTRY_SLOT_SHIFT) - (1 << 14);

    DEM_REQUIRE(limit <= most, DEM_ERROR_MEMORY, "a rank has %zu candidate contacts; the limit is %zu; use "
                "more ranks", limit, most);
    const size_t capacity = limit <= c->capacity ? c->capacity : limit + limit/64;

    DEM_TRY(DEM_RESIZE(c->pair, c->capacity, capacity));
    DEM_TRY(DEM_RESIZE(c->partners, c->capacity, capacity));
    c->capacity = capacity;
    DEM_TRY(grow_entries(c, 2*limit + DEM_ENTRIES_AT_ONCE*(particles + 1)));
    number_rows(c, p, near, c->entry);
    *from = c->entry;
    return DEM_OK;
}

/* As with rows, each entry is written, and the index advances only if its pair has a row: no branch depends on what
   is near. */
static uint32_t list_entries(struct dem_contact_rows *c, const struct dem_pair_list *p, size_t n)
{
    const struct dem_pair *const pair = p->pair;
    const uint32_t *const of = p->entry, none = c->n << DEM_ENTRY_SLOT_SHIFT, walls = c->walls;
    uint32_t *restrict const entry = c->entry;
    uint32_t at = 0, ready = 0, e = p->start[0];

    for (size_t i = 0; i < n; i++)
    {
        const uint32_t first = at, end = p->start[i + 1];

        c->start[i] = first;
        for (; e < end; e++)
        {
            const uint32_t row = pair[of[e] >> 1].row, needs = (row + 1) & -(uint32_t)(row < walls);

            entry[at] = row << DEM_ENTRY_SLOT_SHIFT | (of[e] & DEM_ENTRY_SIDE);
            at += row != DEM_ROW_NONE;
            ready = needs > ready ? needs : ready;
        }
        c->needed[i/DEM_BATCH_ROWS] = ready;
        entry[at] = entry[at + 1] = none;
        at += at == first ? DEM_ENTRIES_AT_ONCE : (at - first)%DEM_ENTRIES_AT_ONCE;
        entry[at - 1] |= DEM_ENTRY_LAST;
    }
    return at;
}

_Static_assert(DEM_ENTRIES_AT_ONCE == 2, "list_entries pads to an even number");

int dem_contact_rows_build_adjacency(struct dem_contact_rows *c, const struct dem_pair_list *p,
                                     size_t n)
{
    const size_t capacity = dem_memory_capacity(c->start_capacity, n + 2);

    DEM_TRY(DEM_RESIZE(c->start, c->start_capacity, capacity));
    c->start_capacity = capacity;
    DEM_TRY(DEM_GROW(c->needed, c->needed_capacity, n/DEM_BATCH_ROWS + 1));
    c->start[n] = list_entries(c, p, n);
    return DEM_OK;
}
