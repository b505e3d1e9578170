/*
 * packing_push.c -- spheres that overlap push each other apart, all at once, until none do.
 *
 *   q_i = sum_j  w_ij ((1 + g)(R_i + R_j)/r - 1) r_ij      over those nearer than (1 + g)(R_i + R_j)
 *   d_i = b d_i' + q_i/2,     x_i = x_i' + d_i               b = 0 where d_i'.q_i < 0
 *
 *   r_ij  from j to i, r its size                                                [m]
 *   w_ij  R_j^2/(R_i^2 + R_j^2), so that the smaller one moves more; 1 where j stays          [1]
 *   g     how much further than touching they are pushed, 0.01: it saves the long end          [1]
 *   b     share of the last displacement that goes on, 0.8: a fifth of the sweeps              [1]
 *
 * Half of each push: with twelve neighbours a whole one would throw them about. Jodrey and Tory, Phys. Rev. A 32 (1985) 2347, push
 * spheres apart, too, one pair after the other and with radii that shrink; the momentum is Polyak's, USSR Comput. Math. 4 (1964) 1.
 *
 * Pushes are added up as integers, in units of 2^-40 of the largest diameter: the sum does not depend on the order, so neither
 * does it on the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/packing.h"
#include "io/packing_pairs.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include <math.h>
#include <string.h>

enum
{
    USE_PUSH = 211,                                       /* stream of random numbers */
    SWEEPS = 2000,
    BLOCK = 512,                                          /* pairs looked at before those that are near are pushed */
    PATIENCE = 200,                                       /* sweeps before a sphere that is wedged goes elsewhere */
    LATER = 64                                            /* trials of a place from here on: packing_places.c had those before */
};

static const double
    go_on = 0.8, half = 0.5,
    skin_of = 0.2,                                        /* mean diameters: pairs nearer than this are listed */
    touching = 1.0 - 1e-12;                               /* nearer than this share of the radii is an overlap: of the sum's rounding */

enum
{
    OVERLAPS = 1, WEDGED = 2                              /* what a sweep has seen */
};

struct push
{
    int64_t x[3];                                         /* units of pushing->unit */
    int64_t seen;
};

struct pushing
{
    const struct dem_packing *p;
    struct dem_spots *s;
    struct dem_packing_pairs near;
    double unit, units, further;                          /* m; 1/m: one over it; 1: (1 + g) */
    uint64_t sweep;
    int64_t overlaps;                                     /* pairs in this sweep, on this rank */
    size_t push_room, at_room;
    struct push *push;                                    /* of own spots and copies */
    double (*at)[3];                                      /* m: own spots when pairs were listed */
};

static int list_pairs(struct pushing *g)
{
    const struct dem_spots *const s = g->s;

    DEM_TRY(dem_packing_pairs_list(&g->near));
    DEM_TRY(DEM_GROW(g->at, g->at_room, s->own + 1));
    for (size_t i = 0; i < s->own; i++)
    {
        memcpy(g->at[i], s->spot[i].x, sizeof g->at[i]);
    }
    return DEM_GROW(g->push, g->push_room, s->n + 1);
}

/* ---- one sweep ----------------------------------------------------------------------------------------------- */

/* Where one lies in the other, any direction from b to a, the same on all ranks. Returns its size. */
static double any_direction(const struct pushing *g, const struct dem_packing_pair *pair, double r[3])
{
    const struct dem_spot *const a = &g->s->spot[pair->a], *const b = &g->s->spot[pair->b];
    const double sum = a->radius + b->radius, sign = a->name < b->name ? 1.0 : -1.0;
    const int64_t lower = a->name < b->name ? a->name : b->name;

    for (int k = 0; k < 3; k++)
    {
        r[k] = sign*sum*(dem_random_unit(g->p->seed, (uint64_t)lower, g->sweep, USE_PUSH + (uint64_t)k) - 0.5);
    }
    return fmax(1e-6*sum, sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]));
}

static void push_apart(struct pushing *g, const struct dem_packing_pair *pair)
{
    const struct dem_place *const a = &g->near.place[pair->a], *const b = &g->near.place[pair->b];
    const int a_stays = g->near.fixed[pair->a], b_stays = g->near.fixed[pair->b];
    struct push *const of_a = &g->push[pair->a], *const of_b = &g->push[pair->b];
    double r[3] = {a->x[0] - b->x[0], a->x[1] - b->x[1], a->x[2] - b->x[2]};
    const double sum = a->radius + b->radius, near = sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]);
    const double size = near < 1e-6*sum ? any_direction(g, pair, r) : near, wanted = g->further*sum;
    const double aa = a->radius*a->radius, bb = b->radius*b->radius, move = size < wanted ? (wanted/size - 1.0)*g->units/(aa + bb) : 0.0;
    const double to_a = a_stays ? 0.0 : move*(b_stays ? aa + bb : bb), to_b = b_stays ? 0.0 : move*(a_stays ? aa + bb : aa);

    for (int k = 0; k < 3; k++)
    {
        of_a->x[k] += llrint(to_a*r[k]);
        of_b->x[k] -= llrint(to_b*r[k]);
    }
    if (near < touching*sum)
    {
        of_a->seen |= OVERLAPS | (b_stays ? WEDGED : 0);
        of_b->seen |= OVERLAPS | (a_stays ? WEDGED : 0);
        g->overlaps++;
    }
}

/* First who is near, without a branch to guess, then the few. */
static void push_all(struct pushing *g)
{
    const struct dem_place *const place = g->near.place;
    const double square = g->further*g->further;
    uint32_t near[BLOCK];

    memset(g->push, 0, g->s->n*sizeof *g->push);
    g->overlaps = 0;
    for (size_t from = 0; from < g->near.n; from += BLOCK)
    {
        const size_t to = from + BLOCK < g->near.n ? from + BLOCK : g->near.n;
        size_t n = 0;

        for (size_t k = from; k < to; k++)
        {
            const struct dem_place *const a = &place[g->near.pair[k].a], *const b = &place[g->near.pair[k].b];
            const double x = a->x[0] - b->x[0], y = a->x[1] - b->x[1], z = a->x[2] - b->x[2], sum = a->radius + b->radius;

            near[n] = (uint32_t)(k - from);
            n += x*x + y*y + z*z < square*(sum*sum);
        }
        for (size_t k = 0; k < n; k++)
        {
            push_apart(g, &g->near.pair[from + near[k]]);
        }
    }
}

static int64_t of_all(const struct pushing *g, int64_t count)
{
    if (g->s->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &count, 1, MPI_INT64_T, MPI_SUM, g->s->pieces.comm);
    }
    return count;
}

/* How many overlap, of all ranks. */
static int64_t count_overlaps(const struct pushing *g)
{
    int64_t count = 0;

    for (size_t i = 0; i < g->s->own; i++)
    {
        count += g->s->spot[i].name >= 0 && (g->push[i].seen & OVERLAPS) != 0;
    }
    return of_all(g, count);
}

/* 1 when there is nothing to do: nobody pushes, and what is left of the last way is nothing. */
static int rests(struct dem_spot *s, const struct push *push)
{
    const double *const v = s->v;

    if ((push->x[0] | push->x[1] | push->x[2]) != 0 || v[0]*v[0] + v[1]*v[1] + v[2]*v[2] > 1e-12*s->radius*s->radius)
    {
        return 0;
    }
    memset(s->v, 0, sizeof s->v);
    return 1;
}

static void move_one(const struct pushing *g, struct dem_spot *s, const struct push *push)
{
    double q[3], from[3], along = 0.0;

    for (int k = 0; k < 3; k++)
    {
        q[k] = g->unit*(double)push->x[k];
        along += q[k]*s->v[k];
        from[k] = s->x[k];
    }
    for (int k = 0; k < 3; k++)
    {
        s->x[k] += (along < 0.0 ? 0.0 : go_on*s->v[k]) + half*q[k];
    }
    dem_vessel_confine(g->p->vessel, s->radius, s->x);
    for (int k = 0; k < 3; k++)
    {
        s->v[k] = s->x[k] - from[k];
    }
}

/* All at once; who is wedged between spheres that stay starts anew elsewhere. Returns the largest way since pairs were listed [m]. */
static double move_all(struct pushing *g)
{
    const int again = g->sweep%PATIENCE == PATIENCE - 1;
    struct dem_spots *const s = g->s;
    double furthest = 0.0;

    for (size_t i = 0; i < s->own; i++)
    {
        double square = 0.0;

        if (s->spot[i].name < 0 || rests(&s->spot[i], &g->push[i]))
        {
            continue;
        }
        if (again && (g->push[i].seen & WEDGED) != 0)
        {
            dem_packing_draw(g->p, &s->spot[i], LATER + g->sweep);
            memset(s->spot[i].v, 0, sizeof s->spot[i].v);
        }
        else
        {
            move_one(g, &s->spot[i], &g->push[i]);
        }
        for (int k = 0; k < 3; k++)
        {
            square += (s->spot[i].x[k] - g->at[i][k])*(s->spot[i].x[k] - g->at[i][k]);
        }
        memcpy(g->near.place[i].x, s->spot[i].x, sizeof g->near.place[i].x);
        furthest = square > furthest ? square : furthest;
    }
    if (s->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &furthest, 1, MPI_DOUBLE, MPI_MAX, s->pieces.comm);
    }
    return sqrt(furthest);
}

/* ---- all ----------------------------------------------------------------------------------------------------- */

/* Where even g is too much, less has to do. */
static double how_much_further(uint64_t sweep)
{
    return sweep < SWEEPS/4 ? 1.01 : sweep < SWEEPS/2 ? 1.003 : 1.0005;
}

static int sweep_all(struct pushing *g)
{
    const struct dem_packing *const p = g->p;
    int64_t left = 1;

    for (double moved = INFINITY; left > 0; g->sweep++)
    {
        g->further = how_much_further(g->sweep);
        DEM_TRY(moved > 0.5*g->near.skin ? list_pairs(g) : dem_packing_pairs_refresh(&g->near));
        push_all(g);
        left = of_all(g, g->overlaps);
        if (left > 0 && g->sweep == SWEEPS)
        {
            left = count_overlaps(g);
            return dem_error(DEM_ERROR_INPUT, "%s: %lld of %lld particles found no room at random in %d sweeps of pushing; enlarge the region, "
                             "ask for fewer, use type lattice, or let them settle", p->where, (long long)left, (long long)p->n, SWEEPS);
        }
        moved = left > 0 ? move_all(g) : 0.0;
    }
    return DEM_OK;
}

int dem_packing_push(const struct dem_packing *p, struct dem_spots *s, double width)
{
    const double unit = 2.0*s->most*0x1p-40;
    struct pushing g = {.p = p, .s = s, .unit = unit, .units = 1.0/unit,
                        .near = {.s = s, .skin = skin_of*width, .stretch = how_much_further(0)}};
    const int status = sweep_all(&g);

    s->n = s->own;
    dem_packing_pairs_free(&g.near);
    dem_memory_free(g.push);
    dem_memory_free(g.at);
    return status;
}
