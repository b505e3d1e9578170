/*
 * decomposition.c -- bisection planes of a level of the tree, all found together from sums of
 * weights.
 *
 * For each level of the tree: extents and weights of the groups of ranks, a plane across the
 * longest side of each, its position by bisection until the weights are equal within a tolerance.
 * Weights are integers, so their sums do not depend on the order of ranks. Zoltan is not used for
 * the reasons given in docs/design.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/decomposition.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include <math.h>
#include <string.h>

enum
{
    BISECTIONS = 50               /* limit of halvings: below any relevant precision */
};

/* Tolerance of the weights at a plane, as a fraction of the weight of one rank. Over the levels of
   the tree it adds up to at most twice that. */
static const double tolerance = 0.005;

/* a group of ranks [lo, hi) and its particles */
struct node
{
    int lo, hi;
    double box[6];                /* m: min and -max, for one reduction with MPI_MIN */
    double low, high;             /* m: limits of the position of the plane */
    double weight;
    int found;
};

static double weight_of(const uint32_t *weight, size_t i)
{
    return weight ? (double)weight[i] : 1.0;
}

int dem_decomposition_init(struct dem_decomposition *p, MPI_Comm comm, int rank, int ranks)
{
    *p = (struct dem_decomposition){.comm = comm, .rank = rank, .ranks = ranks};
    DEM_TRY(DEM_NEW(p->axis, ranks + 1));
    DEM_TRY(DEM_NEW(p->error, 1));
    DEM_TRY(DEM_NEW(p->count, ranks));
    DEM_TRY(DEM_NEW(p->number, 2*ranks));
    return DEM_NEW(p->at, ranks + 1);
}

void dem_decomposition_free(struct dem_decomposition *p)
{
    dem_memory_free(p->axis);
    dem_memory_free(p->at);
    dem_memory_free(p->error);
    dem_memory_free(p->count);
    dem_memory_free(p->number);
    memset(p, 0, sizeof *p);
}

struct load                                               /* positions and weights of this rank */
{
    size_t n, stride;             /* stride: doubles between positions */
    const double *x;              /* m */
    const uint32_t *weight;
    int *of;                      /* node of each position */
};

static const double *position(const struct load *q, size_t i)
{
    return q->x + q->stride*i;
}

static int extents(const struct dem_decomposition *p, const struct load *q, struct node *node,
                   int nodes, double *work)
{
    for (int k = 0; k < 7*nodes; k++)
    {
        work[k] = k < 6*nodes ? INFINITY : 0.0;
    }
    for (size_t i = 0; i < q->n; i++)
    {
        for (int a = 0; a < 3; a++)
        {
            const double x = position(q, i)[a];
            double *const box = work + 6*q->of[i];

            box[a] = x < box[a] ? x : box[a];
            box[a + 3] = -x < box[a + 3] ? -x : box[a + 3];
        }
        work[6*nodes + q->of[i]] += weight_of(q->weight, i);
    }
    DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, work, 6*nodes, MPI_DOUBLE, MPI_MIN, p->comm));
    DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, work + 6*nodes, nodes, MPI_DOUBLE, MPI_SUM, p->comm));
    for (int k = 0; k < nodes; k++)
    {
        memcpy(node[k].box, work + 6*k, sizeof node[k].box);
        node[k].weight = work[6*nodes + k];
        node[k].found = node[k].hi - node[k].lo == 1;
    }
    return DEM_OK;
}

static void choose_axes(struct dem_decomposition *p, struct node *node, int nodes)
{
    for (int k = 0; k < nodes; k++)
    {
        const int mid = (node[k].lo + node[k].hi)/2;
        int longest = 0;

        if (node[k].hi - node[k].lo == 1)
        {
            continue;
        }
        for (int a = 1; a < 3; a++)
        {
            longest = -node[k].box[a + 3] - node[k].box[a] >
                              -node[k].box[longest + 3] - node[k].box[longest]
                          ? a
                          : longest;
        }
        p->axis[mid] = longest;
        node[k].low = node[k].weight > 0.0 ? node[k].box[longest] : 0.0;
        node[k].high = node[k].weight > 0.0 ? -node[k].box[longest + 3] : 0.0;
    }
}

/* Weight below the trial plane of each node whose plane is not found yet. */
static int sum_below(const struct dem_decomposition *p, const struct load *q,
                     const struct node *node, int nodes, double *below)
{
    memset(below, 0, (size_t)nodes*sizeof *below);
    for (size_t i = 0; i < q->n; i++)
    {
        const struct node *const k = &node[q->of[i]];
        const int mid = (k->lo + k->hi)/2;

        if (!k->found && position(q, i)[p->axis[mid]] < 0.5*(k->low + k->high))
        {
            below[q->of[i]] += weight_of(q->weight, i);
        }
    }
    return DEM_MPI_STATUS(MPI_Allreduce(MPI_IN_PLACE, below, nodes, MPI_DOUBLE, MPI_SUM, p->comm));
}

static int search_planes(struct dem_decomposition *p, const struct load *q, struct node *node,
                         int nodes, double *below)
{
    int searching = 1;

    for (int step = 0; step < BISECTIONS && searching; step++)
    {
        DEM_TRY(sum_below(p, q, node, nodes, below));
        searching = 0;
        for (int k = 0; k < nodes; k++)
        {
            const int mid = (node[k].lo + node[k].hi)/2;
            const double plane = 0.5*(node[k].low + node[k].high),
                         per_rank = node[k].weight/(node[k].hi - node[k].lo);
            const double excess = below[k] - per_rank*(mid - node[k].lo);

            if (!node[k].found)
            {
                *(excess < 0.0 ? &node[k].low : &node[k].high) = plane;
                p->at[mid] = plane;
                node[k].found = fabs(excess) <= tolerance*per_rank;
                searching |= !node[k].found;
            }
        }
    }
    return DEM_OK;
}

/* Replace nodes of several ranks by their children; nodes of single ranks stay. Returns the number
   of nodes. */
static int descend(struct dem_decomposition *p, const struct load *q, struct node *node,
                   struct node *next, int nodes, int *child)
{
    int count = 0;

    for (int k = 0; k < nodes; k++)
    {
        const int lo = node[k].lo, hi = node[k].hi, mid = (lo + hi)/2;

        child[k] = count;
        next[count++] = (struct node){.lo = lo, .hi = hi - lo > 1 ? mid : hi};
        if (hi - lo > 1)
        {
            next[count++] = (struct node){.lo = mid, .hi = hi};
        }
    }
    for (size_t i = 0; i < q->n; i++)
    {
        const struct node *const k = &node[q->of[i]];
        const int mid = (k->lo + k->hi)/2;

        q->of[i] =
            child[q->of[i]] + (k->hi - k->lo > 1 && position(q, i)[p->axis[mid]] >= p->at[mid]);
    }
    return count;
}

struct scratch                                           /* of a division */
{
    struct node *node, *next;
    double *work;
    int *child;
};

/* Level by level, until each node is one rank. */
static int find_planes(struct dem_decomposition *p, struct load *load, struct scratch *s)
{
    int nodes = 1;

    s->node[0] = (struct node){.lo = 0, .hi = p->ranks};
    while (nodes < p->ranks)
    {
        struct node *const old = s->node;

        DEM_TRY(extents(p, load, s->node, nodes, s->work));
        choose_axes(p, s->node, nodes);
        DEM_TRY(search_planes(p, load, s->node, nodes, s->work));
        nodes = descend(p, load, s->node, s->next, nodes, s->child);
        s->node = s->next;
        s->next = old;
    }
    return DEM_OK;
}

static int divide(struct dem_decomposition *p, struct load load)
{
    struct scratch s = {.node = NULL};

    if (p->ranks == 1)
    {
        return DEM_OK;
    }
    int status = DEM_NEW(s.node, 2*p->ranks);

    status = status ? status : DEM_NEW(s.next, 2*p->ranks);
    status = status ? status : DEM_NEW(s.work, 14*p->ranks);
    status = status ? status : DEM_NEW(s.child, 2*p->ranks);
    status = status ? status : DEM_NEW(load.of, load.n + 1);
    status = dem_collect_agree(p, status);
    status = status ? status : find_planes(p, &load, &s);
    dem_memory_free(s.node);
    dem_memory_free(s.next);
    dem_memory_free(s.work);
    dem_memory_free(s.child);
    dem_memory_free(load.of);
    return status;
}

int dem_decomposition_balance(struct dem_decomposition *p, const struct dem_particles *q,
                              const uint32_t *weight)
{
    return divide(p, (struct load){.n = q->n,
                                   .stride = sizeof *q->record/sizeof(double),
                                   .x = q->n > 0 ? q->record->x : NULL,
                                   .weight = weight});
}

int dem_decomposition_divide(struct dem_decomposition *p, size_t n, const double *x, size_t stride)
{
    return divide(p, (struct load){.n = n, .stride = stride, .x = x});
}

int dem_decomposition_owner(const struct dem_decomposition *p, const double x[3])
{
    int lo = 0, hi = p->ranks;

    while (hi - lo > 1)
    {
        const int mid = (lo + hi)/2;

        *(x[p->axis[mid]] < p->at[mid] ? &hi : &lo) = mid;
    }
    return lo;
}

void dem_decomposition_box(const struct dem_decomposition *p, int rank, double min[3],
                           double max[3])
{
    int lo = 0, hi = p->ranks;

    for (int a = 0; a < 3; a++)
    {
        min[a] = -INFINITY;
        max[a] = INFINITY;
    }
    while (hi - lo > 1)
    {
        const int mid = (lo + hi)/2, a = p->axis[mid];

        if (rank < mid)
        {
            max[a] = p->at[mid];
            hi = mid;
        }
        else
        {
            min[a] = p->at[mid];
            lo = mid;
        }
    }
}
