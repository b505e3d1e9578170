/*
 * packing_relax.c -- remove overlaps of a packing by pairwise relaxation: overlapping spheres move
 * apart, all at once, repeated until no overlap is left.
 *
 *   q_i = sum_j  w_ij ((1 + g)(R_i + R_j)/r - 1) r_ij     over those nearer than (1 + g)(R_i + R_j)
 *   d_i = b d_i' + q_i/2,     x_i = x_i' + d_i               b = 0 where d_i'.q_i < 0
 *
 *   q_i   displacement of sphere i by its overlaps                                             [m]
 *   d_i   its displacement in this sweep, d_i' in the last one; x_i position                   [m]
 *   r_ij  vector from j, or its nearest image, to i, r its length                              [m]
 *   R     radius                                                                               [m]
 *   w_ij  R_j^2/(R_i^2 + R_j^2), so that the smaller one moves more; 1 where j is fixed        [1]
 *   g     gap to which pairs are moved apart, 0.01: saves most of the slow convergence         [1]
 *   b     momentum, 0.8: takes a fifth of the sweeps                                           [1]
 *
 * Displacements are halved: a sphere may have twelve neighbours, and full ones would overshoot.
 * Jodrey and Tory, Phys. Rev. A 32 (1985) 2347, move one pair after the other, with shrinking
 * radii; the momentum is Polyak's, USSR Comput. Math. 4 (1964) 1.
 *
 * Displacements are summed as integers, in units of 2^-40 of the largest diameter: the sum does not
 * depend on the order, hence not on the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/packing.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "ranks/collect.h"
#include <math.h>
#include <string.h>

enum
{
    USE_DIRECTION = 211,  /* stream of random numbers */
    SWEEPS = 2000,
    CHUNK = 512,          /* pairs tested before those that are near are moved */
    RETRY_SWEEPS = 200,   /* sweeps before a sphere between fixed ones gets a new position */
    LATE_RETRY_SWEEPS = 25,  /* the same, after a quarter of the sweeps */
    LAST_SWEEPS = 200,    /* without new positions */
    FIRST_TRIAL = 64      /* of new positions: packing_addition.c uses the trials before */
};

static const double
    momentum = 0.8, half = 0.5,
    skin_fraction = 0.2,     /* of the mean diameter: skin of the pair list */
    touching = 1.0 - 1e-12;  /* of the sum of radii: nearer is an overlap; leaves its rounding
                                out */

enum
{
    OVERLAPS = 1, WEDGED = 2  /* state of a sphere in a sweep: overlaps; overlaps a fixed one */
};

/* sum of displacements of a sphere in a sweep */
struct move
{
    int64_t x[3];  /* units of relaxation->unit */
    int64_t seen;  /* OVERLAPS | WEDGED */
};

/* what the distance test reads */
struct packed
{
    double x[3], radius;  /* m */
};

struct relaxation
{
    const struct dem_packing *p;
    struct dem_packing_spheres *s;
    double unit, inverse_unit, stretch, skin;  /* m; 1/m; 1  (1 + g); m */
    uint64_t sweep;
    int64_t overlaps;                          /* pairs in this sweep, on this rank */
    size_t move_capacity, packed_capacity, fixed_capacity,
        listed_capacity;
    struct move *move;                         /* of owned spheres and ghosts; zero between sweeps */
    struct packed *packed;                     /* the same */
    uint8_t *fixed;                            /* the same; 1: of an earlier group */
    double (*listed)[3];                       /* m  owned positions when the pairs were listed */
};

/* 1 + g: a packing too dense for a wide gap gets a narrower one. */
static double stretch_of(uint64_t sweep)
{
    return sweep < SWEEPS/4 ? 1.01 : sweep < SWEEPS/2 ? 1.003 : 1.0005;
}

/* Spheres from index `from` on. */
static void pack(struct relaxation *g, size_t from)
{
    const struct dem_particles *const q = &g->s->particles;

    for (size_t i = from; i < q->n + q->ghosts; i++)
    {
        memcpy(g->packed[i].x, q->record[i].x, sizeof g->packed[i].x);
        g->packed[i].radius = q->record[i].radius;
        g->fixed[i] = q->record[i].id < 0;
    }
}

static int store_positions(struct relaxation *g)
{
    const struct dem_particles *const q = &g->s->particles;

    DEM_TRY(DEM_GROW(g->listed, g->listed_capacity, q->n + 1));
    for (size_t i = 0; i < q->n; i++)
    {
        memcpy(g->listed[i], q->record[i].x, sizeof g->listed[i]);
    }
    DEM_TRY(DEM_GROW(g->packed, g->packed_capacity, q->n + q->ghosts + 1));
    DEM_TRY(DEM_GROW(g->fixed, g->fixed_capacity, q->n + q->ghosts + 1));
    pack(g, 0);
    return DEM_GROW(g->move, g->move_capacity, q->n + q->ghosts + 1);
}

static int list_pairs(struct relaxation *g)
{
    const struct dem_insertion_limits *const limits = g->p->shape->limits;

    DEM_TRY(dem_packing_list_pairs(g->p, g->s, limits ? limits->status : DEM_OK,
                                   g->skin + (stretch_of(0) - 1.0)*2.0*g->s->max_radius));
    return dem_collect_agree(&g->s->decomposition, store_positions(g));
}

/* ---- one sweep ------------------------------------------------------------------------------- */

/* For two spheres with the same centre: a random vector from b to a, the same on all ranks.
   Returns its length. */
static double random_direction(const struct relaxation *g, const struct dem_particle *a,
                               const struct dem_particle *b, double r[3])
{
    const double sum = a->radius + b->radius, sign = a->id < b->id ? 1.0 : -1.0;
    const int64_t lower = a->id < b->id ? a->id : b->id;
    const uint64_t number = (uint64_t)(lower < 0 ? -1 : lower);

    for (int k = 0; k < 3; k++)
    {
        r[k] = sign*sum
             *(dem_random_unit(g->p->seed, number, g->sweep, USE_DIRECTION + (uint64_t)k) - 0.5);
    }
    return fmax(1e-6*sum, sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]));
}

static void move_apart(struct relaxation *g, const struct dem_pair *pair)
{
    const struct packed *const a = &g->packed[pair->i], *const b = &g->packed[pair->j];
    const struct dem_particle *const record = g->s->particles.record;
    const int a_stays = g->fixed[pair->i], b_stays = g->fixed[pair->j];
    struct move *const of_a = &g->move[pair->i], *const of_b = &g->move[pair->j];
    const double *const shift = g->s->search.shift[pair->shift];
    double r[3] = {a->x[0] - b->x[0] + shift[0], a->x[1] - b->x[1] + shift[1],
                   a->x[2] - b->x[2] + shift[2]};
    const double sum = a->radius + b->radius, near = sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]);
    const double size = near < 1e-6*sum ? random_direction(g, &record[pair->i], &record[pair->j], r) : near;
    const double wanted = g->stretch*sum;
    const double aa = a->radius*a->radius, bb = b->radius*b->radius;
    const double move = size < wanted ? (wanted/size - 1.0)*g->inverse_unit/(aa + bb) : 0.0;
    const double to_a = a_stays ? 0.0 : move*(b_stays ? aa + bb : bb);
    const double to_b = b_stays ? 0.0 : move*(a_stays ? aa + bb : aa);

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

/* Select the near ones of `n` pairs without an unpredictable branch; returns their number.
   `periodic` is known at compile time: without periodic axes no shift is read. */
__attribute__((always_inline)) static inline size_t
select_near(const struct relaxation *g, const struct dem_pair *pair, size_t n, uint32_t *near,
            const int periodic)
{
    const double square = g->stretch*g->stretch;
    size_t found = 0;

    for (size_t k = 0; k < n; k++)
    {
        const struct packed *const a = &g->packed[pair[k].i], *const b = &g->packed[pair[k].j];
        double x = a->x[0] - b->x[0], y = a->x[1] - b->x[1], z = a->x[2] - b->x[2];
        const double sum = a->radius + b->radius;

        if (periodic)
        {
            const double *const shift = g->s->search.shift[pair[k].shift];

            x += shift[0];
            y += shift[1];
            z += shift[2];
        }

        near[found] = (uint32_t)k;
        found += x*x + y*y + z*z < square*(sum*sum);
    }
    return found;
}

/* Sum the displacements of all spheres. */
static void move_pairs(struct relaxation *g)
{
    const int *const axis = g->p->domain->periodic, periodic = axis[0] | axis[1] | axis[2];
    const struct dem_pair_list *const pairs = &g->s->contacts.pairs;
    uint32_t near[CHUNK];

    g->overlaps = 0;
    for (size_t from = 0; from < pairs->n; from += CHUNK)
    {
        const struct dem_pair *const pair = pairs->pair + from;
        const size_t all = from + CHUNK < pairs->n ? CHUNK : pairs->n - from;
        const size_t n = periodic ? select_near(g, pair, all, near, 1)
                                  : select_near(g, pair, all, near, 0);

        for (size_t k = 0; k < n; k++)
        {
            move_apart(g, &pair[near[k]]);
        }
    }
}

/* The number of new spheres that overlap, on all ranks. */
static int64_t count_overlaps(const struct relaxation *g)
{
    int64_t count = 0;

    for (size_t i = 0; i < g->s->particles.n; i++)
    {
        count += g->s->particles.record[i].id >= 0 && (g->move[i].seen & OVERLAPS) != 0;
    }
    dem_collect_sum_int64(&g->s->decomposition, &count, 1);
    return count;
}

/* 1 when a sphere has no overlap and its momentum is negligible, which is then set to 0. */
static int rests(struct dem_particle *s, const struct move *move)
{
    const double *const v = s->v;

    if ((move->x[0] | move->x[1] | move->x[2]) != 0
        || v[0]*v[0] + v[1]*v[1] + v[2]*v[2] > 1e-12*s->radius*s->radius)
    {
        return 0;
    }
    memset(s->v, 0, sizeof s->v);
    return 1;
}

static void move_one(const struct relaxation *g, struct dem_particle *s, const struct move *move)
{
    double q[3], from[3], along = 0.0;

    for (int k = 0; k < 3; k++)
    {
        q[k] = g->unit*(double)move->x[k];
        along += q[k]*s->v[k];
        from[k] = s->x[k];
    }
    for (int k = 0; k < 3; k++)
    {
        s->x[k] += (along < 0.0 ? 0.0 : momentum*s->v[k]) + half*q[k];
    }
    dem_insertion_shape_confine(g->p->shape, s->radius, s->x);
    if (g->p->shape->limits)
    {
        dem_insertion_limits_confine(g->p->shape->limits, s->radius, from, s->x);
    }
    for (int k = 0; k < 3; k++)
    {
        s->v[k] = s->x[k] - from[k];
    }
}

/* Move all spheres and zero the displacements; one that overlaps fixed spheres for long gets a new
   random position. Returns the largest displacement since the pairs were listed, of all ranks [m]. */
static double move_all(struct relaxation *g)
{
    const uint64_t every = g->sweep < SWEEPS/4 ? RETRY_SWEEPS : LATE_RETRY_SWEEPS;
    const int again = g->sweep%every == every - 1 && g->sweep < SWEEPS - LAST_SWEEPS;
    double furthest = 0.0;

    for (size_t i = 0; i < g->s->particles.n; i++)
    {
        struct dem_particle *const s = &g->s->particles.record[i];
        const struct move move = g->move[i];
        double square = 0.0;

        g->move[i] = (struct move){.seen = 0};
        if (s->id < 0 || rests(s, &move))
        {
            continue;
        }
        if (again && (move.seen & WEDGED) != 0)
        {
            (void)dem_packing_draw(g->p, s, FIRST_TRIAL + g->sweep);
            memset(s->v, 0, sizeof s->v);
        }
        else
        {
            move_one(g, s, &move);
        }
        for (int k = 0; k < 3; k++)
        {
            square += (s->x[k] - g->listed[i][k])*(s->x[k] - g->listed[i][k]);
        }
        memcpy(g->packed[i].x, s->x, sizeof g->packed[i].x);
        furthest = square > furthest ? square : furthest;
    }
    memset(g->move + g->s->particles.n, 0, g->s->particles.ghosts*sizeof *g->move);
    dem_collect_max_double(&g->s->decomposition, &furthest, 1);
    return sqrt(furthest);
}

/* ---- sweeps ---------------------------------------------------------------------------------- */

/* The pairs at the present positions of ghosts. */
static int update_pairs(struct relaxation *g, double moved)
{
    if (moved > 0.5*g->skin)
    {
        return list_pairs(g);
    }
    dem_halo_send(&g->s->halo, &g->s->particles, DEM_HALO_ALL);
    dem_halo_receive(&g->s->halo, &g->s->particles);
    pack(g, g->s->particles.n);
    return DEM_OK;
}

static int sweep_all(struct relaxation *g)
{
    const struct dem_packing *const p = g->p;
    int64_t left = 1;

    for (double moved = INFINITY; left > 0; g->sweep++)
    {
        g->stretch = stretch_of(g->sweep);
        DEM_TRY(update_pairs(g, moved));
        move_pairs(g);
        left = g->overlaps;
        dem_collect_sum_int64(&g->s->decomposition, &left, 1);
        if (left > 0 && g->sweep == SWEEPS)
        {
            return dem_error(DEM_ERROR_INPUT, "%s: %lld of %lld particles still overlap after %d "
                             "sweeps of relaxation; enlarge the region, ask for fewer, use type "
                             "lattice, or let them settle", p->where, (long long)count_overlaps(g),
                             (long long)p->n, SWEEPS);
        }
        moved = left > 0 ? move_all(g) : 0.0;
    }
    return dem_collect_agree(&g->s->decomposition,
                             p->shape->limits ? p->shape->limits->status : DEM_OK);
}

int dem_packing_relax(const struct dem_packing *p, struct dem_packing_spheres *s,
                      double mean_diameter)
{
    const double unit = 2.0*s->max_radius*0x1p-40;
    struct relaxation g = {.p = p,
                           .s = s,
                           .unit = unit,
                           .inverse_unit = 1.0/unit,
                           .skin = skin_fraction*mean_diameter};
    const int status = sweep_all(&g);

    dem_memory_free(g.move);
    dem_memory_free(g.packed);
    dem_memory_free(g.fixed);
    dem_memory_free(g.listed);
    return status;
}
