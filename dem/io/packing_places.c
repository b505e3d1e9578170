/*
 * packing_places.c -- random places, in rounds: each sphere that still waits tries one place in a round, all of them at once.
 *
 * A place is free when it overlaps nobody that stands, and nobody of this round that is larger, or as large with a lower number,
 * whether he gets his place or not. So who gets his place does not depend on who looks first. The octaves of diameters come one after
 * the other, the largest first. Rounds end when one in sixteen of those that try finds nothing any more.
 *
 * Not the same as one after the other (Widom, J. Chem. Phys. 44 (1966) 3888), but alike in both first orders of the density.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/packing.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include <string.h>

enum
{
    USE_PLACE = 201,                                      /* stream of random numbers */
    DRAWS = 1000,                                         /* of a place; no vessel has a chance below 0.5 to be hit */
    ROUNDS = 64,
    SCARCE = 16                                           /* one in so many finds a place: that was the last round */
};

enum what
{
    TRIES,                                                /* yours to place */
    TRIES_ELSEWHERE,
    STANDS_ELSEWHERE
};

struct tries                                              /* those that try a place in this round, own ones and copies */
{
    size_t n, room, head_room, next_room;
    struct dem_spot *spot;                                /* v[0] 1: own, 0: a copy; v[1] 1: has found a place */
    uint32_t *head, *next;                                /* chains in the cells of the level, as in spots.h */
    int level;
};

void dem_packing_draw(const struct dem_packing *p, struct dem_spot *s, uint64_t trial)
{
    double u[3];
    int in = 0;

    for (uint64_t draw = trial*DRAWS; draw < (trial + 1)*DRAWS && !in; draw++)
    {
        for (int k = 0; k < 3; k++)
        {
            u[k] = dem_random_unit(p->seed, (uint64_t)s->name, draw, USE_PLACE + (uint64_t)k);
        }
        in = dem_vessel_place(p->vessel, s->radius, u, s->x);
    }
}

static int add_try(struct tries *t, const struct dem_spot *spot, int own)
{
    DEM_REQUIRE(t->n < UINT32_MAX - 1, DEM_ERROR_INPUT, "more than %u particles to place on one rank; use more ranks", UINT32_MAX - 1);
    DEM_TRY(DEM_GROW(t->spot, t->room, t->n + 1));
    t->spot[t->n] = *spot;
    t->spot[t->n].v[0] = own;
    t->spot[t->n++].v[1] = 0.0;
    return DEM_OK;
}

/* This rank's share of the list, as far as it is in the level. */
static int begin_level(struct tries *t, const struct dem_packing *p, const struct dem_spots *s, int level)
{
    const int64_t ranks = s->pieces.ranks, from = p->n*s->pieces.rank/ranks, to = p->n*(s->pieces.rank + 1)/ranks;

    t->n = 0;
    t->level = level;
    for (int64_t m = from; m < to; m++)
    {
        const struct dem_spot spot = {.radius = 0.5*(p->diameters ? p->diameters[m] : p->diameter), .name = m};

        if (dem_spots_level(s, spot.radius) == level)
        {
            DEM_TRY(add_try(t, &spot, 1));
        }
    }
    return DEM_OK;
}

/* A new place for each; those that lie in other ranks' pieces go there. */
static int draw_all(struct tries *t, const struct dem_packing *p, struct dem_spots *s, uint64_t round)
{
    size_t kept = 0;

    for (size_t k = 0; k < t->n; k++)
    {
        struct dem_spot spot = t->spot[k];
        int gone;

        dem_packing_draw(p, &spot, round);
        DEM_TRY(dem_spots_copy(s, &spot, TRIES_ELSEWHERE, spot.radius + s->most));
        DEM_TRY(dem_spots_send(s, &spot, TRIES, &gone));
        if (!gone)
        {
            t->spot[kept++] = spot;
        }
    }
    t->n = kept;
    DEM_TRY(dem_spots_deliver(s));
    for (size_t k = 0; k < s->posts; k++)
    {
        struct dem_spot *const spot = &s->post[k].spot;

        if (s->post[k].what == STANDS_ELSEWHERE)
        {
            spot->v[0] = 0.0;
            DEM_TRY(dem_spots_add(s, spot));
            DEM_TRY(dem_spots_enter(s, (uint32_t)(s->n - 1)));
        }
        else
        {
            DEM_TRY(add_try(t, spot, s->post[k].what == TRIES));
        }
    }
    s->posts = 0;
    return DEM_OK;
}

static int chain_tries(struct tries *t, const struct dem_spots *s)
{
    const struct dem_spot_level *const l = &s->level[t->level];
    const size_t cells = (size_t)(l->cells[0]*l->cells[1]*l->cells[2]);

    DEM_TRY(DEM_GROW(t->head, t->head_room, cells));
    DEM_TRY(DEM_GROW(t->next, t->next_room, t->n + 1));
    memset(t->head, 0xff, cells*sizeof *t->head);
    for (size_t k = 0; k < t->n; k++)
    {
        const size_t cell = dem_spots_cell(s, l, t->spot[k].x) - l->first;

        t->next[k] = t->head[cell];
        t->head[cell] = (uint32_t)k;
    }
    return DEM_OK;
}

static int overlap(const struct dem_spot *a, const struct dem_spot *b)
{
    const double dx = a->x[0] - b->x[0], dy = a->x[1] - b->x[1], dz = a->x[2] - b->x[2], d = a->radius + b->radius;

    return dx*dx + dy*dy + dz*dz < d*d;
}

/* Who goes before whom in one round. */
static int before(const struct dem_spot *a, const struct dem_spot *b)
{
    return a->radius > b->radius || (a->radius >= b->radius && a->name < b->name);
}

static int free_in_cell(const struct tries *t, const struct dem_spots *s, const struct dem_spot *who, int level, size_t cell)
{
    for (uint32_t m = s->head[s->level[level].first + cell]; m != dem_spot_none; m = s->next[m])
    {
        if (overlap(who, &s->spot[m]))
        {
            return 0;
        }
    }
    for (uint32_t m = level == t->level ? t->head[cell] : dem_spot_none; m != dem_spot_none; m = t->next[m])
    {
        if (&t->spot[m] != who && before(&t->spot[m], who) && overlap(who, &t->spot[m]))
        {
            return 0;
        }
    }
    return 1;
}

static int is_free(const struct tries *t, const struct dem_spots *s, const struct dem_spot *who)
{
    for (int k = 0; k < DEM_SPOT_LEVELS; k++)
    {
        const struct dem_spot_level *const l = &s->level[k];

        if (l->most > 0.0)
        {
            const struct dem_spot_range r = dem_spots_range(s, l, who->x, who->radius + l->most);

            for (int64_t z = r.from[2]; z <= r.to[2]; z++)
            {
                for (int64_t y = r.from[1]; y <= r.to[1]; y++)
                {
                    for (int64_t x = r.from[0]; x <= r.to[0]; x++)
                    {
                        if (!free_in_cell(t, s, who, k, (size_t)((z*l->cells[1] + y)*l->cells[0] + x)))
                        {
                            return 0;
                        }
                    }
                }
            }
        }
    }
    return 1;
}

/* Own ones, cell by cell: neighbours look at the same memory. */
static void look(struct tries *t, const struct dem_spots *s)
{
    const struct dem_spot_level *const l = &s->level[t->level];
    const size_t cells = (size_t)(l->cells[0]*l->cells[1]*l->cells[2]);

    for (size_t c = 0; c < cells; c++)
    {
        for (uint32_t m = t->head[c]; m != dem_spot_none; m = t->next[m])
        {
            t->spot[m].v[1] = t->spot[m].v[0] > 0.0 && is_free(t, s, &t->spot[m]);
        }
    }
}

static int stand(struct dem_spots *s, const struct dem_spot *spot)
{
    DEM_TRY(dem_spots_add(s, spot));
    DEM_TRY(dem_spots_enter(s, (uint32_t)(s->n - 1)));
    return dem_spots_copy(s, spot, STANDS_ELSEWHERE, spot->radius + s->most);
}

/* Who has found a place stands there; at the end of a level all do. count: those that do, those that still wait. */
static int settle(struct tries *t, struct dem_spots *s, int64_t count[2])
{
    size_t kept = 0;

    count[0] = count[1] = 0;
    for (size_t k = 0; k < t->n; k++)
    {
        const struct dem_spot spot = t->spot[k];

        if (spot.v[0] > 0.0)
        {
            count[spot.v[1] > 0.0 ? 0 : 1]++;
            if (spot.v[1] > 0.0)
            {
                DEM_TRY(stand(s, &spot));
            }
            else
            {
                t->spot[kept++] = spot;
            }
        }
    }
    t->n = kept;
    if (s->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_INT64_T, MPI_SUM, s->pieces.comm);
    }
    return DEM_OK;
}

static int place_level(struct tries *t, const struct dem_packing *p, struct dem_spots *s, int64_t *left)
{
    int64_t count[2] = {1, 1};

    for (uint64_t round = 0; round < ROUNDS && count[1] > 0 && count[0]*SCARCE >= count[1]; round++)
    {
        DEM_TRY(draw_all(t, p, s, round));
        DEM_TRY(chain_tries(t, s));
        look(t, s);
        DEM_TRY(settle(t, s, count));
    }
    *left += count[1];
    for (size_t k = 0; k < t->n; k++)
    {
        DEM_TRY(stand(s, &t->spot[k]));
    }
    return DEM_OK;
}

static void drop_copies(struct dem_spots *s)
{
    size_t kept = 0;

    for (size_t k = 0; k < s->n; k++)
    {
        if (s->spot[k].v[0] > 0.0)
        {
            s->spot[kept] = s->spot[k];
            memset(s->spot[kept++].v, 0, sizeof s->spot->v);
        }
    }
    s->n = s->own = kept;
}

int dem_packing_place(const struct dem_packing *p, struct dem_spots *s, int64_t *left)
{
    struct tries t = {.n = 0};
    int status = dem_spots_grid(s, 0.0, s->n + (size_t)(p->n/s->pieces.ranks));

    *left = 0;
    for (size_t k = 0; k < s->n && !status; k++)
    {
        status = dem_spots_enter(s, (uint32_t)k);
    }
    for (int level = 0; level < DEM_SPOT_LEVELS && !status; level++)
    {
        if (s->level[level].most > 0.0)
        {
            status = begin_level(&t, p, s, level);
            status = status ? status : place_level(&t, p, s, left);
        }
    }
    drop_copies(s);
    s->posts = 0;
    dem_memory_free(t.spot);
    dem_memory_free(t.head);
    dem_memory_free(t.next);
    return status;
}
