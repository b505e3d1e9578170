/*
 * packing_pairs.c -- build the pair list of a packing: migration, sorting by cell, ghosts, pairs.
 *
 * Owned spheres are stored cell by cell, so that a row of cells is contiguous in memory and is
 * tested without an unpredictable branch. Ghosts are in linked cells.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "insertion/packing_pairs.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

enum
{
    MOVED, GHOST,  /* kinds of messages */
    CHUNK = 256    /* spheres tested before pairs are listed */
};

/* a ghost sent to a rank, in the order of sending */
struct sent
{
    int peer;
    uint32_t sphere;
};

static int migrate(struct dem_placed_spheres *s)
{
    size_t kept = 0;
    int sent;

    for (size_t i = 0; i < s->owned; i++)
    {
        DEM_TRY(dem_placed_spheres_send_to_owner(s, &s->sphere[i], MOVED, &sent));
        if (!sent)
        {
            s->sphere[kept++] = s->sphere[i];
        }
    }
    s->n = kept;
    DEM_TRY(dem_placed_spheres_exchange(s));
    for (size_t k = 0; k < s->messages; k++)
    {
        DEM_TRY(dem_placed_spheres_add(s, &s->message[k].sphere));
    }
    s->owned = s->n;
    s->messages = 0;
    return DEM_OK;
}

/* Link the spheres from this one on into their cells. */
static int link_cells(struct dem_placed_spheres *s, size_t from)
{
    memset(s->head, 0xff, (s->cells + 1)*sizeof *s->head);
    for (size_t i = from; i < s->n; i++)
    {
        DEM_TRY(dem_placed_spheres_link(s, (uint32_t)i));
    }
    return DEM_OK;
}

/* Sort owned spheres by cell, and store where each cell begins. */
static int sort_by_cell(struct dem_packing_pairs *g)
{
    struct dem_placed_spheres *const s = g->s;
    uint32_t count = 0;

    DEM_TRY(dem_placed_spheres_clear_grids(s, g->skin + (g->stretch - 1.0)*2.0*s->max_radius,
                                           s->n));
    DEM_TRY(link_cells(s, 0));
    DEM_TRY(DEM_GROW(g->order, g->order_capacity, s->n + 1));
    DEM_TRY(DEM_GROW(g->start, g->start_capacity, s->cells + 1));
    for (size_t c = 0; c < s->cells; c++)
    {
        g->start[c] = count;
        for (uint32_t m = s->head[c]; m != dem_placed_sphere_none; m = s->next[m])
        {
            g->order[count++] = s->sphere[m];
        }
    }
    g->start[s->cells] = count;
    memcpy(s->sphere, g->order, count*sizeof *s->sphere);
    return DEM_OK;
}

static int send_ghosts(struct dem_packing_pairs *g)
{
    struct dem_placed_spheres *const s = g->s;

    g->sent = 0;
    for (size_t i = 0; i < s->owned && s->decomposition.ranks > 1; i++)
    {
        const size_t from = s->messages;

        DEM_TRY(dem_placed_spheres_send_ghosts(s, &s->sphere[i], GHOST,
                                               g->stretch*(s->sphere[i].radius + s->max_radius)
                                                   + g->skin));
        for (size_t k = from; k < s->messages; k++)
        {
            DEM_TRY(DEM_GROW(g->send, g->sent_capacity, g->sent + 1));
            g->send[g->sent++] = (struct sent){s->message[k].peer, (uint32_t)i};
        }
    }
    DEM_TRY(dem_placed_spheres_exchange(s));
    for (size_t k = 0; k < s->messages; k++)
    {
        DEM_TRY(dem_placed_spheres_add(s, &s->message[k].sphere));
    }
    s->messages = 0;
    return link_cells(s, s->owned);
}

static int copy_positions(struct dem_packing_pairs *g)
{
    const struct dem_placed_spheres *const s = g->s;

    DEM_TRY(DEM_GROW(g->packed, g->place_capacity, s->n + 1));
    DEM_TRY(DEM_GROW(g->fixed, g->fixed_capacity, s->n + 1));
    for (size_t i = 0; i < s->n; i++)
    {
        memcpy(g->packed[i].x, s->sphere[i].x, sizeof g->packed[i].x);
        g->packed[i].radius = s->sphere[i].radius;
        g->fixed[i] = s->sphere[i].number < 0;
    }
    return DEM_OK;
}

int dem_packing_pairs_refresh(struct dem_packing_pairs *g)
{
    struct dem_placed_spheres *const s = g->s;

    if (s->decomposition.ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(s->message, s->message_capacity, g->sent + 1));
    for (size_t k = 0; k < g->sent; k++)
    {
        s->message[k] = (struct dem_placed_sphere_message){g->send[k].peer, GHOST,
                                                           s->sphere[g->send[k].sphere]};
    }
    s->messages = g->sent;
    DEM_TRY(dem_placed_spheres_exchange(s));
    for (size_t k = 0; k < s->messages; k++)
    {
        memcpy(g->packed[s->owned + k].x, s->message[k].sphere.x, sizeof g->packed->x);
    }
    s->messages = 0;
    return DEM_OK;
}

/* ---- pair search ----------------------------------------------------------------------------- */

static int add_pair(struct dem_packing_pairs *g, uint32_t i, uint32_t j)
{
    DEM_TRY(g->n == g->capacity ? DEM_GROW(g->pair, g->capacity, g->n + 1) : DEM_OK);
    g->pair[g->n] = (struct dem_packing_pair){i, j};
    g->n += !(g->fixed[i] && g->fixed[j]);
    return DEM_OK;
}

static int near(const struct dem_packing_pairs *g, const struct dem_packed_sphere *p,
                const struct dem_packed_sphere *q)
{
    const double dx = p->x[0] - q->x[0], dy = p->x[1] - q->x[1], dz = p->x[2] - q->x[2];
    const double reach = g->stretch*(p->radius + q->radius) + g->skin;

    return dx*dx + dy*dy + dz*dz < reach*reach;
}

/* Pairs of i with owned spheres that are contiguous in memory. */
static int search_owned(struct dem_packing_pairs *g, uint32_t i, uint32_t from, uint32_t to)
{
    const struct dem_packed_sphere me = g->packed[i];
    uint32_t found[CHUNK];

    for (uint32_t first = from; first < to; first += CHUNK)
    {
        const uint32_t last = to - first > CHUNK ? first + CHUNK : to;
        uint32_t n = 0;

        for (uint32_t j = first; j < last; j++)
        {
            found[n] = j;
            n += (uint32_t)near(g, &me, &g->packed[j]);
        }
        for (uint32_t k = 0; k < n; k++)
        {
            DEM_TRY(add_pair(g, i, found[k]));
        }
    }
    return DEM_OK;
}

static int search_ghosts(struct dem_packing_pairs *g, uint32_t i, size_t first, size_t last)
{
    const struct dem_placed_spheres *const s = g->s;

    for (size_t c = first; c <= last; c++)
    {
        for (uint32_t j = s->head[c]; j != dem_placed_sphere_none; j = s->next[j])
        {
            DEM_TRY(near(g, &g->packed[i], &g->packed[j]) ? add_pair(g, i, j) : DEM_OK);
        }
    }
    return DEM_OK;
}

/* Each pair once: the smaller sphere searches in the grids of its own and of larger sizes. In
   the same grid, the first of two owned spheres searches, and the owned one of an owned sphere
   and a ghost. */
static int search(struct dem_packing_pairs *g, uint32_t i)
{
    const struct dem_placed_spheres *const s = g->s;
    const struct dem_packed_sphere *const p = &g->packed[i];
    const int level = dem_placed_spheres_level(s, p->radius), own = i < s->owned;

    for (int k = 0; k < level + own; k++)
    {
        const struct dem_placed_sphere_level *const l = &s->level[k];

        if (l->max_radius > 0.0)
        {
            const struct dem_cell_range r =
                dem_placed_spheres_cell_range(s, l, p->x,
                                              g->stretch*(p->radius + l->max_radius) + g->skin);

            for (int64_t z = r.from[2]; z <= r.to[2]; z++)
            {
                for (int64_t y = r.from[1]; y <= r.to[1]; y++)
                {
                    const size_t row = l->first + (size_t)((z*l->cells[1] + y)*l->cells[0]);
                    const size_t first = row + (size_t)r.from[0], last = row + (size_t)r.to[0];
                    const uint32_t from =
                        k == level && g->start[first] <= i ? i + 1 : g->start[first];

                    DEM_TRY(search_owned(g, i, from, g->start[last + 1]));
                    DEM_TRY(own && s->n > s->owned ? search_ghosts(g, i, first, last) : DEM_OK);
                }
            }
        }
    }
    return DEM_OK;
}

int dem_packing_pairs_list(struct dem_packing_pairs *g)
{
    DEM_TRY(migrate(g->s));
    DEM_TRY(sort_by_cell(g));
    DEM_TRY(send_ghosts(g));
    DEM_TRY(copy_positions(g));
    g->n = 0;
    for (size_t i = 0; i < g->s->n; i++)
    {
        DEM_TRY(search(g, (uint32_t)i));
    }
    return DEM_OK;
}

void dem_packing_pairs_free(struct dem_packing_pairs *g)
{
    dem_memory_free(g->pair);
    dem_memory_free(g->packed);
    dem_memory_free(g->fixed);
    dem_memory_free(g->order);
    dem_memory_free(g->start);
    dem_memory_free(g->send);
}
