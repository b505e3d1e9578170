/*
 * packing_pairs.c -- spots to their owners, own ones in the order of cells, copies of others, pairs.
 *
 * Own spots lie cell by cell, so a row of cells is a stretch of memory, looked at without a branch to guess. Copies hang in chains.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/packing_pairs.h"
#include "base/error.h"
#include "base/memory.h"
#include <string.h>

enum
{
    MOVES, COPIES,
    STRETCH = 256                                         /* spots looked at before those that are near are listed */
};

struct sent                                               /* whose copy is where, in the order in which they went */
{
    int peer;
    uint32_t spot;
};

static int migrate(struct dem_spots *s)
{
    size_t kept = 0;
    int gone;

    for (size_t i = 0; i < s->own; i++)
    {
        DEM_TRY(dem_spots_send(s, &s->spot[i], MOVES, &gone));
        if (!gone)
        {
            s->spot[kept++] = s->spot[i];
        }
    }
    s->n = kept;
    DEM_TRY(dem_spots_deliver(s));
    for (size_t k = 0; k < s->posts; k++)
    {
        DEM_TRY(dem_spots_add(s, &s->post[k].spot));
    }
    s->own = s->n;
    s->posts = 0;
    return DEM_OK;
}

static int chain(struct dem_spots *s, size_t from)
{
    memset(s->head, 0xff, (s->cells + 1)*sizeof *s->head);
    for (size_t i = from; i < s->n; i++)
    {
        DEM_TRY(dem_spots_enter(s, (uint32_t)i));
    }
    return DEM_OK;
}

/* Own spots cell by cell; where each cell begins. */
static int sort(struct dem_packing_pairs *g)
{
    struct dem_spots *const s = g->s;
    uint32_t count = 0;

    DEM_TRY(dem_spots_grid(s, g->skin + (g->stretch - 1.0)*2.0*s->most, s->n));
    DEM_TRY(chain(s, 0));
    DEM_TRY(DEM_GROW(g->order, g->order_room, s->n + 1));
    DEM_TRY(DEM_GROW(g->start, g->start_room, s->cells + 1));
    for (size_t c = 0; c < s->cells; c++)
    {
        g->start[c] = count;
        for (uint32_t m = s->head[c]; m != dem_spot_none; m = s->next[m])
        {
            g->order[count++] = s->spot[m];
        }
    }
    g->start[s->cells] = count;
    memcpy(s->spot, g->order, count*sizeof *s->spot);
    return DEM_OK;
}

static int send_copies(struct dem_packing_pairs *g)
{
    struct dem_spots *const s = g->s;

    g->sent = 0;
    for (size_t i = 0; i < s->own && s->pieces.ranks > 1; i++)
    {
        const size_t from = s->posts;

        DEM_TRY(dem_spots_copy(s, &s->spot[i], COPIES, g->stretch*(s->spot[i].radius + s->most) + g->skin));
        for (size_t k = from; k < s->posts; k++)
        {
            DEM_TRY(DEM_GROW(g->send, g->sent_room, g->sent + 1));
            g->send[g->sent++] = (struct sent){s->post[k].peer, (uint32_t)i};
        }
    }
    DEM_TRY(dem_spots_deliver(s));
    for (size_t k = 0; k < s->posts; k++)
    {
        DEM_TRY(dem_spots_add(s, &s->post[k].spot));
    }
    s->posts = 0;
    return chain(s, s->own);
}

static int take_places(struct dem_packing_pairs *g)
{
    const struct dem_spots *const s = g->s;

    DEM_TRY(DEM_GROW(g->place, g->place_room, s->n + 1));
    DEM_TRY(DEM_GROW(g->fixed, g->fixed_room, s->n + 1));
    for (size_t i = 0; i < s->n; i++)
    {
        memcpy(g->place[i].x, s->spot[i].x, sizeof g->place[i].x);
        g->place[i].radius = s->spot[i].radius;
        g->fixed[i] = s->spot[i].name < 0;
    }
    return DEM_OK;
}

int dem_packing_pairs_refresh(struct dem_packing_pairs *g)
{
    struct dem_spots *const s = g->s;

    if (s->pieces.ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(s->post, s->post_room, g->sent + 1));
    for (size_t k = 0; k < g->sent; k++)
    {
        s->post[k] = (struct dem_spot_post){g->send[k].peer, COPIES, s->spot[g->send[k].spot]};
    }
    s->posts = g->sent;
    DEM_TRY(dem_spots_deliver(s));
    for (size_t k = 0; k < s->posts; k++)
    {
        memcpy(g->place[s->own + k].x, s->post[k].spot.x, sizeof g->place->x);
    }
    s->posts = 0;
    return DEM_OK;
}

/* ---- pairs --------------------------------------------------------------------------------------------------- */

static int add(struct dem_packing_pairs *g, uint32_t i, uint32_t j)
{
    DEM_TRY(g->n == g->room ? DEM_GROW(g->pair, g->room, g->n + 1) : DEM_OK);
    g->pair[g->n] = (struct dem_packing_pair){i, j};
    g->n += !(g->fixed[i] && g->fixed[j]);
    return DEM_OK;
}

static int near(const struct dem_packing_pairs *g, const struct dem_place *p, const struct dem_place *q)
{
    const double dx = p->x[0] - q->x[0], dy = p->x[1] - q->x[1], dz = p->x[2] - q->x[2];
    const double reach = g->stretch*(p->radius + q->radius) + g->skin;

    return dx*dx + dy*dy + dz*dz < reach*reach;
}

/* Own spots of a stretch of memory. */
static int look_along(struct dem_packing_pairs *g, uint32_t i, uint32_t from, uint32_t to)
{
    const struct dem_place me = g->place[i];
    uint32_t found[STRETCH];

    for (uint32_t first = from; first < to; first += STRETCH)
    {
        const uint32_t last = to - first > STRETCH ? first + STRETCH : to;
        uint32_t n = 0;

        for (uint32_t j = first; j < last; j++)
        {
            found[n] = j;
            n += (uint32_t)near(g, &me, &g->place[j]);
        }
        for (uint32_t k = 0; k < n; k++)
        {
            DEM_TRY(add(g, i, found[k]));
        }
    }
    return DEM_OK;
}

static int look_at_copies(struct dem_packing_pairs *g, uint32_t i, size_t first, size_t last)
{
    const struct dem_spots *const s = g->s;

    for (size_t c = first; c <= last; c++)
    {
        for (uint32_t j = s->head[c]; j != dem_spot_none; j = s->next[j])
        {
            DEM_TRY(near(g, &g->place[i], &g->place[j]) ? add(g, i, j) : DEM_OK);
        }
    }
    return DEM_OK;
}

/* The smaller one looks, into the grids of those that are as large or larger. Of two in the same grid both are own ones, and the
   first looks, or one is a copy, and the own one looks. */
static int look(struct dem_packing_pairs *g, uint32_t i)
{
    const struct dem_spots *const s = g->s;
    const struct dem_place *const p = &g->place[i];
    const int level = dem_spots_level(s, p->radius), own = i < s->own;

    for (int k = 0; k < level + own; k++)
    {
        const struct dem_spot_level *const l = &s->level[k];

        if (l->most > 0.0)
        {
            const struct dem_spot_range r = dem_spots_range(s, l, p->x, g->stretch*(p->radius + l->most) + g->skin);

            for (int64_t z = r.from[2]; z <= r.to[2]; z++)
            {
                for (int64_t y = r.from[1]; y <= r.to[1]; y++)
                {
                    const size_t row = l->first + (size_t)((z*l->cells[1] + y)*l->cells[0]);
                    const size_t first = row + (size_t)r.from[0], last = row + (size_t)r.to[0];
                    const uint32_t from = k == level && g->start[first] <= i ? i + 1 : g->start[first];

                    DEM_TRY(look_along(g, i, from, g->start[last + 1]));
                    DEM_TRY(own && s->n > s->own ? look_at_copies(g, i, first, last) : DEM_OK);
                }
            }
        }
    }
    return DEM_OK;
}

int dem_packing_pairs_list(struct dem_packing_pairs *g)
{
    DEM_TRY(migrate(g->s));
    DEM_TRY(sort(g));
    DEM_TRY(send_copies(g));
    DEM_TRY(take_places(g));
    g->n = 0;
    for (size_t i = 0; i < g->s->n; i++)
    {
        DEM_TRY(look(g, (uint32_t)i));
    }
    return DEM_OK;
}

void dem_packing_pairs_free(struct dem_packing_pairs *g)
{
    dem_memory_free(g->pair);
    dem_memory_free(g->place);
    dem_memory_free(g->fixed);
    dem_memory_free(g->order);
    dem_memory_free(g->start);
    dem_memory_free(g->send);
}
