/*
 * contacts.c -- builds the contact rows and the list of rows that each particle sums.
 *
 * Adjacency: the pairs of each owned particle in the order of its sum (partner id, image; walls
 * last), then the same for rows. A prune renumbers the rows; history columns move with them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "model/contacts.h"
#include "core/memory.h"
#include "core/sort.h"
#include <string.h>

enum
{
    PADDING_ROWS = 8              /* rows past the last, with zero force */
};

int dem_contacts_init(struct dem_contacts *c, const struct dem_interaction_table *r)
{
    memset(c, 0, sizeof *c);
    c->classes = r->classes;
    c->history_columns = r->history_columns;
    c->moments = r->moments;
    c->has_energy = r->past_touching;
    c->single = r->mixed;
    return DEM_NEW(c->segment, r->classes + 1);
}

void dem_contacts_free(struct dem_contacts *c)
{
    for (int m = 0; m < DEM_HISTORY_COLUMNS; m++)
    {
        dem_memory_free(c->history[m]);
    }
    dem_memory_free(c->pair);
    dem_memory_free(c->row_pair);
    dem_memory_free(c->row_partners);
    dem_memory_free(c->segment);
    dem_memory_free(c->history_scratch);
    dem_memory_free(c->force);
    dem_memory_free(c->force_single);
    dem_memory_free(c->force_buffer);
    dem_memory_free(c->force_buffer_single);
    dem_memory_free(c->deferred_row);
    dem_memory_free(c->moment);
    dem_memory_free(c->energy);
    dem_memory_free(c->pair_start);
    dem_memory_free(c->pair_entry);
    dem_memory_free(c->row_start);
    dem_memory_free(c->row_entry);
    dem_memory_free(c->rows_needed);
    dem_memory_free(c->saved_key);
    dem_memory_free(c->saved_history);
    memset(c, 0, sizeof *c);
}

/* A pair between two owned particles is an entry of both. */
size_t dem_contacts_bytes_per_pair(const struct dem_contacts *c)
{
    return sizeof *c->pair + 2*(sizeof *c->pair_entry + sizeof *c->row_entry);
}

static size_t bytes_per_row(const struct dem_contacts *c)
{
    return sizeof *c->row_pair + sizeof *c->row_partners +
           (size_t)(c->history_columns + 1 + 3*c->moments)*sizeof *c->history_scratch +
           (c->has_energy ? sizeof *c->energy : 0);
}

/* During a rebuild saved history takes the memory that contact forces have otherwise. */
size_t dem_contacts_bytes_per_row(const struct dem_contacts *c)
{
    return bytes_per_row(c) + (c->single ? sizeof *c->force_single : sizeof *c->force);
}

size_t dem_contacts_bytes(const struct dem_contacts *c)
{
    return c->pair_capacity*sizeof *c->pair + c->pair_entry_capacity*sizeof *c->pair_entry +
           c->row_entry_capacity*sizeof *c->row_entry +
           c->start_capacity*(sizeof *c->pair_start + sizeof *c->row_start) +
           c->row_capacity*bytes_per_row(c) +
           c->force_capacity*(c->single ? sizeof *c->force_single : sizeof *c->force) +
           (dem_contacts_use_force_buffer(c) ? dem_contacts_force_buffer_bytes(c) : 0) +
           c->deferred_capacity*sizeof *c->deferred_row +
           c->saved_capacity*sizeof *c->saved_key +
           c->saved_history_capacity*sizeof *c->saved_history;
}

/* ---- order of sums --------------------------------------------------------------------------- */

/* The order of a particle's sum: partner id, then image; walls after all particles, by facet (the
   list of wall neighbors is in that order). */
static int comes_later(const struct dem_contacts *c, const struct dem_particles *p, uint32_t a,
                       uint32_t b)
{
    const struct dem_pair *const s = &c->pair[a >> 1], *const t = &c->pair[b >> 1];

    if (s->wall || t->wall)
    {
        return s->wall > t->wall || (s->wall && t->wall && s->j > t->j);
    }
    const int64_t is = p->record[a & 1 ? s->i : s->j].id, it = p->record[b & 1 ? t->i : t->j].id;

    return is > it || (is == it && s->shift > t->shift);
}

static void sort_by_insertion(const struct dem_contacts *c, const struct dem_particles *p,
                              uint32_t *entry, uint32_t count)
{
    for (uint32_t k = 1; k < count; k++)
    {
        const uint32_t here = entry[k];
        uint32_t m = k;

        for (; m > 0 && comes_later(c, p, entry[m - 1], here); m--)
        {
            entry[m] = entry[m - 1];
        }
        entry[m] = here;
    }
}

/* The same in linear time: a large particle may have thousands of small neighbours. `pair`:
   capacity 2 count. */
static void sort_by_radix(const struct dem_contacts *c, const struct dem_particles *p,
                          uint32_t *entry, uint32_t count, struct dem_sort_pair *pair)
{
    for (uint32_t k = 0; k < count; k++)
    {
        const struct dem_pair *const q = &c->pair[entry[k] >> 1];
        const uint64_t other =
            q->wall ? (uint64_t)1 << 63 | q->j : (uint64_t)p->record[entry[k] & 1 ? q->i : q->j].id;

        pair[k] =
            (struct dem_sort_pair){.hi = other, .lo = q->wall ? 0 : q->shift, .index = entry[k]};
    }
    dem_sort_pairs(pair, count, pair + count);
    for (uint32_t k = 0; k < count; k++)
    {
        entry[k] = pair[k].index;
    }
}

static int sort_entries(struct dem_contacts *c, const struct dem_particles *p)
{
    /* limit of insertion sort; equal spheres: about 15 */
    enum { INSERTION_LIMIT = 32 };

    struct dem_sort_pair *pair = NULL;
    size_t capacity = 0;

    for (size_t i = 0; i < p->n; i++)
    {
        uint32_t *const entry = c->pair_entry + c->pair_start[i];
        const uint32_t count = c->pair_start[i + 1] - c->pair_start[i];

        if (count <= INSERTION_LIMIT)
        {
            sort_by_insertion(c, p, entry, count);
            continue;
        }
        const int grown = DEM_GROW(pair, capacity, 2*(size_t)count);

        if (grown)
        {
            dem_memory_free(pair);
            return grown;
        }
        sort_by_radix(c, p, entry, count, pair);
    }
    dem_memory_free(pair);
    return DEM_OK;
}

int dem_contacts_build_adjacency(struct dem_contacts *c, const struct dem_particles *p)
{
    const size_t n = p->n, capacity = dem_memory_capacity(c->start_capacity, n + 2);

    DEM_TRY(DEM_RESIZE(c->pair_start, c->start_capacity, capacity));
    DEM_TRY(DEM_RESIZE(c->row_start, c->start_capacity, capacity));
    c->start_capacity = capacity;
    memset(c->pair_start, 0, (n + 2)*sizeof *c->pair_start);
    for (size_t k = 0; k < c->pairs; k++)
    {
        const struct dem_pair *const q = &c->pair[k];

        if (q->i < n)
        {
            c->pair_start[q->i + 2]++;
        }
        if (!q->wall && q->j < n)
        {
            c->pair_start[q->j + 2]++;
        }
    }
    for (size_t i = 2; i < n + 2; i++)
    {
        c->pair_start[i] += c->pair_start[i - 1];
    }
    const size_t entries = c->pair_start[n + 1],
                 entry_capacity = dem_memory_capacity(c->pair_entry_capacity, entries);

    DEM_TRY(DEM_RESIZE(c->pair_entry, c->pair_entry_capacity, entry_capacity));
    c->pair_entry_capacity = entry_capacity;
    for (size_t k = 0; k < c->pairs; k++)
    {
        const struct dem_pair *const q = &c->pair[k];

        if (q->i < n)
        {
            c->pair_entry[c->pair_start[q->i + 1]++] = (uint32_t)(2*k);
        }
        if (!q->wall && q->j < n)
        {
            c->pair_entry[c->pair_start[q->j + 1]++] = (uint32_t)(2*k + 1);
        }
    }
    return sort_entries(c, p);
}

/* ---- contact rows ---------------------------------------------------------------------------- */

static int grow_rows(struct dem_contacts *c, size_t rows)
{
    /* grow by little: rows take most of all memory */
    const size_t capacity = rows <= c->row_capacity ? c->row_capacity : rows + rows/64;

    DEM_TRY(DEM_RESIZE(c->row_pair, c->row_capacity, capacity));
    DEM_TRY(DEM_RESIZE(c->row_partners, c->row_capacity, capacity));
    DEM_TRY(DEM_RESIZE(c->history_scratch, c->row_capacity, capacity));
    if (c->moments)
    {
        DEM_TRY(DEM_RESIZE(c->moment, 3*c->row_capacity, 3*capacity));
    }
    if (c->has_energy)
    {
        DEM_TRY(DEM_RESIZE(c->energy, c->row_capacity, capacity));
    }
    for (int m = 0; m < c->history_columns; m++)
    {
        DEM_TRY(DEM_RESIZE(c->history[m], c->row_capacity, capacity));
    }
    c->row_capacity = capacity;
    return DEM_OK;
}

static size_t count_rows(const struct dem_contacts *c, const uint8_t *near)
{
    size_t rows = 0;

    for (size_t k = 0; k < c->pairs; k++)
    {
        rows += near[k];
    }
    return rows + (size_t)(DEM_BATCH_ROWS*c->classes + PADDING_ROWS + DEM_ROWS_AHEAD);
}

/* Pairs are sorted by class, so the rows of a class follow each other. `from`: the former index of
   each row. Every pair is written to the next row and the index advances only if the pair is near:
   this avoids a branch that cannot be predicted. */
static void number_rows(struct dem_contacts *c, const uint8_t *near, uint32_t *from)
{
    uint32_t row = 0;
    size_t k = 0;

    for (int s = 0; s < c->classes; s++)
    {
        c->segment[s].first = row;
        for (; k < c->pairs && c->pair[k].class == s; k++)
        {
            struct dem_pair *const q = &c->pair[k];

            c->row_partners[row] =
                (struct dem_row_partners){q->i, q->j | (uint32_t)q->shift << DEM_PARTNER_SHIFT};
            c->row_pair[row] = (uint32_t)k;
            from[row] = q->row;
            q->row = near[k] ? row : DEM_ROW_NONE;
            row += near[k];
        }
        c->segment[s].count = row - c->segment[s].first;
        /* so that no batch crosses the end of the force buffer */
        for (; row%DEM_BATCH_ROWS; row++)
        {
            c->row_partners[row] = c->row_partners[row - 1];
            c->row_pair[row] = from[row] = DEM_ROW_NONE;
        }
    }
    c->rows = row;
    for (int k = 0; k < PADDING_ROWS; k++)
    {
        c->row_pair[row + (uint32_t)k] = DEM_ROW_NONE;
    }
    memset(c->row_partners + row, 0, DEM_ROWS_AHEAD*sizeof *c->row_partners);
}

static void move_history(struct dem_contacts *c, const uint32_t *from)
{
    for (int m = 0; m < c->history_columns; m++)
    {
        double *const old = c->history[m], *const new = c->history_scratch;

        for (uint32_t r = 0; r < c->rows; r++)
        {
            new[r] = from[r] == DEM_ROW_NONE ? 0.0 : old[from[r]];
        }
        c->history[m] = new;
        c->history_scratch = old;
    }
}

static int grow_entries(struct dem_contacts *c, size_t limit)
{
    if (c->row_entry_capacity < limit)
    {
        dem_memory_free(c->row_entry);
        c->row_entry = NULL;
        c->row_entry_capacity = 0;
        DEM_TRY(DEM_GROW(c->row_entry, c->row_entry_capacity, limit));
    }
    return DEM_OK;
}

/* As with rows, each entry is written, and the index advances only if its pair has a row. */
static int build_row_adjacency(struct dem_contacts *c, size_t n)
{
    uint32_t at = 0, ready = 0;

    DEM_TRY(DEM_GROW(c->rows_needed, c->rows_needed_capacity, n/DEM_BATCH_ROWS + 1));
    for (size_t i = 0; i < n; i++)
    {
        c->row_start[i] = at;
        for (uint32_t e = c->pair_start[i]; e < c->pair_start[i + 1]; e++)
        {
            const struct dem_pair *const q = &c->pair[c->pair_entry[e] >> 1];
            const uint32_t near = q->row != DEM_ROW_NONE,
                           needs = (near & !q->wall) ? q->row + 1 : 0;

            c->row_entry[at] = q->row << DEM_ENTRY_ROW_SHIFT | (c->pair_entry[e] & DEM_ENTRY_SIDE);
            at += near;
            ready = needs > ready ? needs : ready;
        }
        c->rows_needed[i/DEM_BATCH_ROWS] = ready;
        c->row_entry[at] = c->rows << DEM_ENTRY_ROW_SHIFT;
        at += at%2;
    }
    c->row_start[n] = at;
    return DEM_OK;
}

/* ---- contact forces -------------------------------------------------------------------------- */

void dem_contacts_free_forces(struct dem_contacts *c)
{
    dem_memory_free(c->force);
    dem_memory_free(c->force_single);
    c->force = NULL;
    c->force_single = NULL;
    c->force_capacity = 0;
}

int dem_contacts_allocate_forces(struct dem_contacts *c)
{
    const size_t rows = c->rows + PADDING_ROWS;

    if (rows > c->force_capacity)
    {
        dem_contacts_free_forces(c);
        DEM_TRY(c->single ? DEM_NEW(c->force_single, c->row_capacity)
                          : DEM_NEW(c->force, c->row_capacity));
        c->force_capacity = c->row_capacity;
    }
    else if (c->single)
    {
        memset(c->force_single + c->rows, 0, PADDING_ROWS*sizeof *c->force_single);
    }
    else
    {
        memset(c->force + c->rows, 0, PADDING_ROWS*sizeof *c->force);
    }
    return DEM_OK;
}

void dem_contacts_free_rows(struct dem_contacts *c)
{
    dem_memory_free(c->row_pair);
    dem_memory_free(c->row_partners);
    dem_memory_free(c->history_scratch);
    dem_memory_free(c->moment);
    dem_memory_free(c->energy);
    for (int m = 0; m < c->history_columns; m++)
    {
        dem_memory_free(c->history[m]);
        c->history[m] = NULL;
    }
    c->row_pair = NULL;
    c->row_partners = NULL;
    c->history_scratch = c->moment = NULL;
    c->energy = NULL;
    c->rows = 0;
    c->row_capacity = 0;
}

int dem_contacts_prune(struct dem_contacts *c, const struct dem_particles *p, const uint8_t *near)
{
    const size_t limit = count_rows(c, near);

    DEM_TRY(grow_rows(c, limit));
    DEM_TRY(grow_entries(c, 2*limit + p->n + 1));
    number_rows(c, near, c->row_entry);                  /* scratch here; build_row_adjacency fills it */
    move_history(c, c->row_entry);
    if (c->has_energy)
    {
        memset(c->energy, 0, (c->rows + PADDING_ROWS)*sizeof *c->energy);
    }
    if (c->moments)
    {
        memset(c->moment, 0, 3*(c->rows + PADDING_ROWS)*sizeof *c->moment);
    }
    DEM_TRY(build_row_adjacency(c, p->n));
    DEM_TRY(dem_contacts_make_force_buffer(c, p->n));
    return c->saved > 0 ? DEM_OK : dem_contacts_allocate_forces(c);
}
