/*
 * grid_order.c -- order of owned particles in memory: by cell, in layers and columns; by id within
 * a cell.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/memory.h"
#include "core/sort.h"
#include "contacts/grid.h"

enum
{
    INSERTION_LIMIT = 32,         /* limit of insertion sort */
    COLUMN = 28                   /* width of a column, in cells */
};

/* Sort the particles of one cell by id. `key`: capacity 2 count, `index`: capacity count. */
static void sort_cell(const struct dem_particles *particles, uint32_t *order, uint32_t count,
                      uint64_t *key, uint32_t *index)
{
    for (uint32_t k = 0; count > INSERTION_LIMIT && k < count; k++)
    {
        key[k] = (uint64_t)particles->record[order[k]].id;
    }
    if (count > INSERTION_LIMIT)
    {
        dem_sort_keys(key, order, count, key + count, index);
    }
    for (uint32_t k = 1; count <= INSERTION_LIMIT && k < count; k++)
    {
        const uint32_t here = order[k];
        uint32_t m = k;

        for (; m > 0 && particles->record[order[m - 1]].id > particles->record[here].id; m--)
        {
            order[m] = order[m - 1];
        }
        order[m] = here;
    }
}

static int sort_cells(const struct dem_particles *particles, uint32_t *order, const uint32_t *end,
                      size_t cells)
{
    uint64_t *key = NULL;
    uint32_t *index = NULL, largest = 0;

    for (size_t c = 0; c < cells; c++)
    {
        const uint32_t count = end[c] - (c > 0 ? end[c - 1] : 0);

        largest = count > largest ? count : largest;
    }
    largest = largest > INSERTION_LIMIT ? largest : 0;
    int status = DEM_NEW(key, 2*largest);

    status = status ? status : DEM_NEW(index, largest);
    for (size_t c = 0; c < cells && !status; c++)
    {
        const uint32_t first = c > 0 ? end[c - 1] : 0;

        sort_cell(particles, order + first, end[c] - first, key, index);
    }
    dem_memory_free(key);
    dem_memory_free(index);
    return status;
}

/* A layer across the longest side may exceed the cache: then it is divided into columns about
   COLUMN cells wide, one after the other. Two layers of a bed then fit the force buffer of
   contacts/contacts.h. Along the first two axes: number, and width in cells. */
struct columns
{
    int n[2], wide[2];    /* along the first two axes: number, and width in cells */
};

static struct columns columns_of(const struct dem_grid_level *l)
{
    struct columns c;

    for (int k = 0; k < 2; k++)
    {
        const int count = (l->cells[k] + COLUMN/2)/COLUMN;

        c.wide[k] = count > 1 ? (l->cells[k] + count - 1)/count : l->cells[k];
        c.n[k] = (l->cells[k] + c.wide[k] - 1)/c.wide[k];
    }
    return c;
}

/* Column by column; within a column layer by layer along the longest side. */
static uint32_t index_in_columns(const struct columns *s, int layers, const int c[3])
{
    const size_t column = (size_t)(c[1]/s->wide[1])*(size_t)s->n[0] + (size_t)(c[0]/s->wide[0]);
    const size_t layer = column*(size_t)layers + (size_t)c[2];

    return (uint32_t)((layer*(size_t)s->wide[1] + (size_t)(c[1]%s->wide[1]))*
                          (size_t)s->wide[0] +
                      (size_t)(c[0]%s->wide[0]));
}

int dem_grid_order(struct dem_grid *g, const struct dem_particles *particles, uint32_t *order)
{
    struct dem_grid_level l = g->level[0];
    uint32_t *start = NULL, *cell = NULL;

    dem_grid_fit(g, &l, particles);

    const struct columns s = columns_of(&l);
    const size_t cells = (size_t)s.n[0]*(size_t)s.wide[0]*(size_t)s.n[1]*(size_t)s.wide[1]*
                         (size_t)l.cells[2];
    int c[3];

    int status = DEM_NEW(start, cells + 1);

    status = status ? status : DEM_NEW(cell, particles->n + 1);
    if (status)
    {
        dem_memory_free(start);
        return status;
    }
    for (size_t i = 0; i < particles->n; i++)
    {
        dem_grid_cells(g, &l, particles->record[i].x, c);
        cell[i] = index_in_columns(&s, l.cells[2], c);
        start[cell[i] + 1]++;
    }
    dem_grid_starts(start, cells);
    for (size_t i = 0; i < particles->n; i++)
    {
        order[start[cell[i]]++] = (uint32_t)i;            /* starts become ends */
    }
    status = sort_cells(particles, order, start, cells);
    dem_memory_free(start);
    dem_memory_free(cell);
    return status;
}
