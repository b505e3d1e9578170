/*
 * wall_books.c -- one pass over the rows of the wall classes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_books.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/vec.h"
#include "step/parts.h"
#include <string.h>

void dem_wall_books_free(struct dem_wall_books *b)
{
    dem_memory_free(b->sum);
    dem_memory_free(b->held);
    memset(b, 0, sizeof *b);
}

int dem_wall_books_open(struct dem_wall_books *b, int walls)
{
    if (!b->sum)
    {
        DEM_TRY(DEM_NEW(b->sum, 6*walls + 1));
        b->walls = walls;
    }
    for (int k = 0; k < 6*walls; k++)
    {
        dem_sum_clear(&b->sum[k]);
    }
    return DEM_OK;
}

/* 0 where a row does nothing, as most rows near a wall: exact sums don't feel a zero. */
static int pushes(const struct dem_contacts *c, uint32_t r)
{
    const struct dem_push push = dem_contacts_push(c, r);
    int some = 0;

    for (uint32_t k = 0; k < 3; k++)
    {
        some |= push.f[k] != 0.0 || (c->moments && c->moment[3*r + k] != 0.0);
    }
    return some;
}

void dem_wall_books_sum(const struct dem_parts *p, int wall, double factor, struct dem_sum *sum)
{
    const struct dem_contacts *const c = &p->contacts;

    for (int s = 0; s < c->classes && c->rows > 0; s++)
    {
        const uint32_t end = c->segment[s].first + (p->recipe.chain[s].pair.with_wall ? c->segment[s].count : 0);

        for (uint32_t r = c->segment[s].first; r < end; r++)
        {
            const struct dem_pair *const q = &c->pair[c->row_pair[r]];
            const int here = p->walls.region[p->pairs.wall_region[q->j]].wall;
            const struct dem_push push = dem_contacts_push(c, r);
            const double f[3] = {-factor*push.f[0], -factor*push.f[1], -factor*push.f[2]};
            struct dem_sum *const to = sum + (wall < 0 ? 6*here : 0);
            double moment[3];

            if (!pushes(c, r))
            {
                continue;
            }
            dem_vec_cross(p->touches.touch[q->j].point, f, moment);
            for (uint32_t k = 0; k < 3 && (wall < 0 || wall == here); k++)
            {
                dem_sum_add(&to[k], f[k]);
                dem_sum_add(&to[3 + k], moment[k]);
                dem_sum_add(&to[3 + k], c->moments ? -factor*c->moment[3*r + k] : 0.0);
            }
        }
    }
}

int dem_wall_books_hold(struct dem_parts *p)
{
    struct dem_wall_books *const b = &p->books;

    if (b->sum && !b->held)
    {
        DEM_TRY(DEM_NEW(b->held, 6*b->walls + 1));
        for (int k = 0; k < 6*b->walls; k++)
        {
            dem_sum_clear(&b->held[k]);
        }
        dem_wall_books_sum(p, -1, 1.0, b->held);
    }
    return DEM_OK;
}

void dem_wall_books_drop(struct dem_wall_books *b)
{
    dem_memory_free(b->held);
    b->held = NULL;
}

/* Each rank's share is rounded once: the fluid that asks for this has rounded before. */
static void add_held(struct dem_wall_books *b, double kick)
{
    for (int k = 0; k < 6*b->walls; k++)
    {
        dem_sum_add(&b->sum[k], kick*dem_sum_value(&b->held[k]));
    }
    dem_wall_books_drop(b);
}

void dem_wall_books_add(struct dem_parts *p, double kick)
{
    if (p->books.held)
    {
        add_held(&p->books, kick);
    }
    else if (p->books.sum)
    {
        dem_wall_books_sum(p, -1, kick, p->books.sum);
    }
}
