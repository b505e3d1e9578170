/*
 * grid_order.c -- the order of owned particles in memory.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "space/grid.h"

enum
{
    FEW = 32,                                             /* ids that are sorted by insertion */
    COLUMN = 28
};

/* Places of one cell by id; `room` for as many. */
static void sort_cell(const struct dem_particles *p, uint32_t *order, uint32_t count, uint64_t *key, uint32_t *index)
{
    for (uint32_t k = 0; count > FEW && k < count; k++)
    {
        key[k] = (uint64_t)p->record[order[k]].id;
    }
    if (count > FEW)
    {
        dem_sort_keys(key, order, count, key + count, index);
    }
    for (uint32_t k = 1; count <= FEW && k < count; k++)
    {
        const uint32_t here = order[k];
        uint32_t m = k;

        for (; m > 0 && p->record[order[m - 1]].id > p->record[here].id; m--)
        {
            order[m] = order[m - 1];
        }
        order[m] = here;
    }
}

static int sort_cells(const struct dem_particles *p, uint32_t *order, const uint32_t *end, size_t cells)
{
    uint64_t *key;
    uint32_t *index, most = 0;

    for (size_t c = 0; c < cells; c++)
    {
        const uint32_t count = end[c] - (c > 0 ? end[c - 1] : 0);

        most = count > most ? count : most;
    }
    most = most > FEW ? most : 0;
    DEM_TRY(DEM_NEW(key, 2*most));
    DEM_TRY(DEM_NEW(index, most));
    for (size_t c = 0; c < cells; c++)
    {
        const uint32_t first = c > 0 ? end[c - 1] : 0;

        sort_cell(p, order + first, end[c] - first, key, index);
    }
    dem_memory_free(key);
    dem_memory_free(index);
    return DEM_OK;
}

/* A layer across the longest side may hold more than a cache: then it is cut into columns about COLUMN cells wide, that follow each
   other. Two layers of a bed fit the ring of state/contacts.h. */
struct columns                                            /* along the first two axes: how many, and cells across each */
{
    int n[2], wide[2];
};

static struct columns columns_of(const struct dem_grid_level *l)
{
    struct columns c;

    for (int k = 0; k < 2; k++)
    {
        const int few = (l->cells[k] + COLUMN/2)/COLUMN;

        c.wide[k] = few > 1 ? (l->cells[k] + few - 1)/few : l->cells[k];
        c.n[k] = (l->cells[k] + c.wide[k] - 1)/c.wide[k];
    }
    return c;
}

/* Column by column, in each layer by layer along the longest side. */
static uint32_t place_in_columns(const struct columns *s, int layers, const int c[3])
{
    const size_t column = (size_t)(c[1]/s->wide[1])*(size_t)s->n[0] + (size_t)(c[0]/s->wide[0]);
    const size_t layer = column*(size_t)layers + (size_t)c[2];

    return (uint32_t)((layer*(size_t)s->wide[1] + (size_t)(c[1]%s->wide[1]))*(size_t)s->wide[0] + (size_t)(c[0]%s->wide[0]));
}

int dem_grid_order(struct dem_grid *g, const struct dem_particles *p, uint32_t *order)
{
    struct dem_grid_level l = g->level[0];
    uint32_t *start, *cell;

    dem_grid_lay(g, &l, p);

    const struct columns s = columns_of(&l);
    const size_t cells = (size_t)s.n[0]*(size_t)s.wide[0]*(size_t)s.n[1]*(size_t)s.wide[1]*(size_t)l.cells[2];
    int c[3];

    DEM_TRY(DEM_NEW(start, cells + 1));
    DEM_TRY(DEM_NEW(cell, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        dem_grid_cells(g, &l, p->record[i].x, c);
        cell[i] = place_in_columns(&s, l.cells[2], c);
        start[cell[i] + 1]++;
    }
    dem_grid_starts(start, cells);
    for (size_t i = 0; i < p->n; i++)
    {
        order[start[cell[i]]++] = (uint32_t)i;            /* the starts move on and end as ends */
    }
    const int status = sort_cells(p, order, start, cells);

    dem_memory_free(start);
    dem_memory_free(cell);
    return status;
}
