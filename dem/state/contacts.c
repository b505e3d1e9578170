/*
 * contacts.c -- laying out pairs and near rows; what rows remember stays with them through a prune.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "state/contacts.h"
#include "base/memory.h"
#include "base/sort.h"
#include <string.h>

enum
{
    LANES = 8                                             /* rows past the last, which do nothing */
};

int dem_contacts_init(struct dem_contacts *c, const struct dem_recipe *r)
{
    memset(c, 0, sizeof *c);
    c->classes = r->classes;
    c->memories = r->memories;
    c->moments = r->moments;
    c->booked = r->past_touching;
    c->single = r->mixed;
    return DEM_NEW(c->segment, r->classes + 1);
}

void dem_contacts_free(struct dem_contacts *c)
{
    for (int m = 0; m < DEM_MEMORY_COLUMNS; m++)
    {
        dem_memory_free(c->memory[m]);
    }
    dem_memory_free(c->pair);
    dem_memory_free(c->row_pair);
    dem_memory_free(c->near_row);
    dem_memory_free(c->segment);
    dem_memory_free(c->memory_scratch);
    dem_memory_free(c->push);
    dem_memory_free(c->push_single);
    dem_memory_free(c->ring);
    dem_memory_free(c->ring_single);
    dem_memory_free(c->far);
    dem_memory_free(c->moment);
    dem_memory_free(c->books);
    dem_memory_free(c->start);
    dem_memory_free(c->entry);
    dem_memory_free(c->near_start);
    dem_memory_free(c->near_entry);
    dem_memory_free(c->ready);
    dem_memory_free(c->carry);
    dem_memory_free(c->kept);
    memset(c, 0, sizeof *c);
}

/* a pair between two owned particles is an entry of both */
size_t dem_contacts_each_pair(const struct dem_contacts *c)
{
    return sizeof *c->pair + 2*(sizeof *c->entry + sizeof *c->near_entry);
}

static size_t each_row(const struct dem_contacts *c)
{
    return sizeof *c->row_pair + sizeof *c->near_row + (size_t)(c->memories + 1 + 3*c->moments)*sizeof *c->memory_scratch
         + (c->booked ? sizeof *c->books : 0);
}

/* what rows remember is carried through a rebuild in the room of what they push with */
size_t dem_contacts_each_row(const struct dem_contacts *c)
{
    return each_row(c) + (c->single ? sizeof *c->push_single : sizeof *c->push);
}

size_t dem_contacts_bytes(const struct dem_contacts *c)
{
    return c->pair_room*sizeof *c->pair + c->entry_room*sizeof *c->entry + c->near_room*sizeof *c->near_entry
         + c->start_room*(sizeof *c->start + sizeof *c->near_start) + c->row_room*each_row(c)
         + c->push_room*(c->single ? sizeof *c->push_single : sizeof *c->push) + (dem_contacts_go_round(c) ? dem_contacts_ring(c) : 0)
         + c->far_room*sizeof *c->far + c->carried_room*sizeof *c->carry + c->kept_room*sizeof *c->kept;
}

/* ---- who sums what ------------------------------------------------------------------------------------------- */

/* The order of a particle's sum: partner id, then image; walls after all particles, by region (they come in order). */
static int later(const struct dem_contacts *c, const struct dem_particles *p, uint32_t a, uint32_t b)
{
    const struct dem_pair *const s = &c->pair[a >> 1], *const t = &c->pair[b >> 1];

    if (s->wall || t->wall)
    {
        return s->wall > t->wall || (s->wall && t->wall && s->j > t->j);
    }
    const int64_t is = p->record[a & 1 ? s->i : s->j].id, it = p->record[b & 1 ? t->i : t->j].id;

    return is > it || (is == it && s->shift > t->shift);
}

static void sort_few(const struct dem_contacts *c, const struct dem_particles *p, uint32_t *entry, uint32_t count)
{
    for (uint32_t k = 1; k < count; k++)
    {
        const uint32_t here = entry[k];
        uint32_t m = k;

        for (; m > 0 && later(c, p, entry[m - 1], here); m--)
        {
            entry[m] = entry[m - 1];
        }
        entry[m] = here;
    }
}

/* The same in linear time: a large particle may have thousands of small ones around. `pair`: room for twice as many. */
static void sort_many(const struct dem_contacts *c, const struct dem_particles *p, uint32_t *entry, uint32_t count, struct dem_sort_pair *pair)
{
    for (uint32_t k = 0; k < count; k++)
    {
        const struct dem_pair *const q = &c->pair[entry[k] >> 1];
        const uint64_t other = q->wall ? (uint64_t)1 << 63 | q->j : (uint64_t)p->record[entry[k] & 1 ? q->i : q->j].id;

        pair[k] = (struct dem_sort_pair){.hi = other, .lo = q->wall ? 0 : q->shift, .index = entry[k]};
    }
    dem_sort_pairs(pair, count, pair + count);
    for (uint32_t k = 0; k < count; k++)
    {
        entry[k] = pair[k].index;
    }
}

static int sort_entries(struct dem_contacts *c, const struct dem_particles *p)
{
    enum { FEW = 32 };                                    /* up to so many by insertion: a bed of equal spheres has some fifteen */

    struct dem_sort_pair *pair = NULL;
    size_t room = 0;

    for (size_t i = 0; i < p->n; i++)
    {
        uint32_t *const entry = c->entry + c->start[i];
        const uint32_t count = c->start[i + 1] - c->start[i];

        if (count <= FEW)
        {
            sort_few(c, p, entry, count);
            continue;
        }
        const int grown = DEM_GROW(pair, room, 2*(size_t)count);

        if (grown)
        {
            dem_memory_free(pair);
            return grown;
        }
        sort_many(c, p, entry, count, pair);
    }
    dem_memory_free(pair);
    return DEM_OK;
}

int dem_contacts_adjoin(struct dem_contacts *c, const struct dem_particles *p)
{
    const size_t n = p->n, room = dem_memory_room(c->start_room, n + 2);

    DEM_TRY(DEM_RESIZE(c->start, c->start_room, room));
    DEM_TRY(DEM_RESIZE(c->near_start, c->start_room, room));
    c->start_room = room;
    memset(c->start, 0, (n + 2)*sizeof *c->start);
    for (size_t k = 0; k < c->pairs; k++)
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
    const size_t entries = c->start[n + 1], entry_room = dem_memory_room(c->entry_room, entries);

    DEM_TRY(DEM_RESIZE(c->entry, c->entry_room, entry_room));
    c->entry_room = entry_room;
    for (size_t k = 0; k < c->pairs; k++)
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
    return sort_entries(c, p);
}

/* ---- near rows ----------------------------------------------------------------------------------------------- */

static int grow_rows(struct dem_contacts *c, size_t rows)
{
    const size_t room = rows <= c->row_room ? c->row_room : rows + rows/64;    /* rows are most of all memory */

    DEM_TRY(DEM_RESIZE(c->row_pair, c->row_room, room));
    DEM_TRY(DEM_RESIZE(c->near_row, c->row_room, room));
    DEM_TRY(DEM_RESIZE(c->memory_scratch, c->row_room, room));
    if (c->moments)
    {
        DEM_TRY(DEM_RESIZE(c->moment, 3*c->row_room, 3*room));
    }
    if (c->booked)
    {
        DEM_TRY(DEM_RESIZE(c->books, c->row_room, room));
    }
    for (int m = 0; m < c->memories; m++)
    {
        DEM_TRY(DEM_RESIZE(c->memory[m], c->row_room, room));
    }
    c->row_room = room;
    return DEM_OK;
}

static size_t count_rows(const struct dem_contacts *c, const uint8_t *near)
{
    size_t rows = 0;

    for (size_t k = 0; k < c->pairs; k++)
    {
        rows += near[k];
    }
    return rows + (size_t)(DEM_BLOCK*c->classes + LANES + DEM_NEAR_AHEAD);
}

/* Pairs are sorted by class, so the rows of a class follow each other. `from`: which row each was. Every pair is written where the next
   near one goes and kept if it is near: there is no telling beforehand, and a guess costs more. */
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

            c->near_row[row] = (struct dem_near){q->i, q->j | (uint32_t)q->shift << DEM_NEAR_SHIFT};
            c->row_pair[row] = (uint32_t)k;
            from[row] = q->row;
            q->row = near[k] ? row : DEM_ROW_NONE;
            row += near[k];
        }
        c->segment[s].count = row - c->segment[s].first;
        for (; row%DEM_BLOCK; row++)                      /* so that a block never runs over the end of the ring */
        {
            c->near_row[row] = c->near_row[row - 1];
            c->row_pair[row] = from[row] = DEM_ROW_NONE;
        }
    }
    c->rows = row;
    for (int k = 0; k < LANES; k++)
    {
        c->row_pair[row + (uint32_t)k] = DEM_ROW_NONE;
    }
    memset(c->near_row + row, 0, DEM_NEAR_AHEAD*sizeof *c->near_row);
}

static void move_memory(struct dem_contacts *c, const uint32_t *from)
{
    for (int m = 0; m < c->memories; m++)
    {
        double *const old = c->memory[m], *const new = c->memory_scratch;

        for (uint32_t r = 0; r < c->rows; r++)
        {
            new[r] = from[r] == DEM_ROW_NONE ? 0.0 : old[from[r]];
        }
        c->memory[m] = new;
        c->memory_scratch = old;
    }
}

static int grow_entries(struct dem_contacts *c, size_t most)
{
    if (c->near_room < most)
    {
        dem_memory_free(c->near_entry);
        c->near_entry = NULL;
        c->near_room = 0;
        DEM_TRY(DEM_GROW(c->near_entry, c->near_room, most));
    }
    return DEM_OK;
}

/* As with rows, each entry is written and kept if its row is near. */
static int adjoin_near(struct dem_contacts *c, size_t n)
{
    uint32_t at = 0, ready = 0;

    DEM_TRY(DEM_GROW(c->ready, c->ready_room, n/DEM_BLOCK + 1));
    for (size_t i = 0; i < n; i++)
    {
        c->near_start[i] = at;
        for (uint32_t e = c->start[i]; e < c->start[i + 1]; e++)
        {
            const struct dem_pair *const q = &c->pair[c->entry[e] >> 1];
            const uint32_t near = q->row != DEM_ROW_NONE, needs = (near & !q->wall) ? q->row + 1 : 0;

            c->near_entry[at] = q->row << DEM_ENTRY_ROW | (c->entry[e] & DEM_ENTRY_SIDE);
            at += near;
            ready = needs > ready ? needs : ready;
        }
        c->ready[i/DEM_BLOCK] = ready;
        c->near_entry[at] = c->rows << DEM_ENTRY_ROW;
        at += at%2;
    }
    c->near_start[n] = at;
    return DEM_OK;
}

/* ---- pushes -------------------------------------------------------------------------------------------------- */

void dem_contacts_drop_pushes(struct dem_contacts *c)
{
    dem_memory_free(c->push);
    dem_memory_free(c->push_single);
    c->push = NULL;
    c->push_single = NULL;
    c->push_room = 0;
}

int dem_contacts_make_pushes(struct dem_contacts *c)
{
    const size_t rows = c->rows + LANES;

    if (rows > c->push_room)
    {
        dem_contacts_drop_pushes(c);
        DEM_TRY(c->single ? DEM_NEW(c->push_single, c->row_room) : DEM_NEW(c->push, c->row_room));
        c->push_room = c->row_room;
    }
    else if (c->single)
    {
        memset(c->push_single + c->rows, 0, LANES*sizeof *c->push_single);
    }
    else
    {
        memset(c->push + c->rows, 0, LANES*sizeof *c->push);
    }
    return DEM_OK;
}

void dem_contacts_drop_rows(struct dem_contacts *c)
{
    dem_memory_free(c->row_pair);
    dem_memory_free(c->near_row);
    dem_memory_free(c->memory_scratch);
    dem_memory_free(c->moment);
    dem_memory_free(c->books);
    for (int m = 0; m < c->memories; m++)
    {
        dem_memory_free(c->memory[m]);
        c->memory[m] = NULL;
    }
    c->row_pair = NULL;
    c->near_row = NULL;
    c->memory_scratch = c->moment = NULL;
    c->books = NULL;
    c->rows = 0;
    c->row_room = 0;
}

int dem_contacts_prune(struct dem_contacts *c, const struct dem_particles *p, const uint8_t *near)
{
    const size_t most = count_rows(c, near);

    DEM_TRY(grow_rows(c, most));
    DEM_TRY(grow_entries(c, 2*most + p->n + 1));
    number_rows(c, near, c->near_entry);                  /* which is made anew below */
    move_memory(c, c->near_entry);
    if (c->booked)
    {
        memset(c->books, 0, (c->rows + LANES)*sizeof *c->books);
    }
    if (c->moments)
    {
        memset(c->moment, 0, 3*(c->rows + LANES)*sizeof *c->moment);
    }
    DEM_TRY(adjoin_near(c, p->n));
    DEM_TRY(dem_contacts_make_ring(c, p->n));
    return c->carried > 0 ? DEM_OK : dem_contacts_make_pushes(c);
}
