/*
 * pieces.c -- all planes of one level of the tree are found together by bisection on sums of weights.
 *
 * Weights are whole numbers, so their sums are the same however ranks are added. Why not Zoltan: dem/README.md, section 7.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/pieces.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    BISECTIONS = 50                                       /* halvings of an extent: past the last bit that matters */
};

/* A plane is good enough when it gives away no more than this share of what one rank gets; down the tree it adds up to twice that. */
static const double tolerance = 0.005;

struct node                                               /* a group of ranks [lo, hi) and its particles' extent */
{
    int lo, hi;
    double box[6];                                        /* m: min, then -max, so that one minimum finds both */
    double low, high;                                     /* m: where the plane is searched */
    double weight;
    int found;
};

static double weight_of(const uint32_t *weight, size_t i)
{
    return weight ? (double)weight[i] : 1.0;
}

int dem_pieces_init(struct dem_pieces *p, MPI_Comm comm, int rank, int ranks)
{
    *p = (struct dem_pieces){.comm = comm, .rank = rank, .ranks = ranks};
    DEM_TRY(DEM_NEW(p->axis, ranks + 1));
    return DEM_NEW(p->at, ranks + 1);
}

void dem_pieces_free(struct dem_pieces *p)
{
    dem_memory_free(p->axis);
    dem_memory_free(p->at);
    memset(p, 0, sizeof *p);
}

struct load                                               /* what this rank brings, and the node that each is in */
{
    size_t n, stride;                                     /* doubles from place to place */
    const double *x;                                      /* m */
    const uint32_t *weight;
    int *of;
};

static const double *place(const struct load *q, size_t i)
{
    return q->x + q->stride*i;
}

static void extents(const struct dem_pieces *p, const struct load *q, struct node *node, int nodes, double *work)
{
    for (int k = 0; k < 7*nodes; k++)
    {
        work[k] = k < 6*nodes ? INFINITY : 0.0;
    }
    for (size_t i = 0; i < q->n; i++)
    {
        for (int a = 0; a < 3; a++)
        {
            const double x = place(q, i)[a];
            double *const box = work + 6*q->of[i];

            box[a] = x < box[a] ? x : box[a];
            box[a + 3] = -x < box[a + 3] ? -x : box[a + 3];
        }
        work[6*nodes + q->of[i]] += weight_of(q->weight, i);
    }
    MPI_Allreduce(MPI_IN_PLACE, work, 6*nodes, MPI_DOUBLE, MPI_MIN, p->comm);
    MPI_Allreduce(MPI_IN_PLACE, work + 6*nodes, nodes, MPI_DOUBLE, MPI_SUM, p->comm);
    for (int k = 0; k < nodes; k++)
    {
        memcpy(node[k].box, work + 6*k, sizeof node[k].box);
        node[k].weight = work[6*nodes + k];
        node[k].found = node[k].hi - node[k].lo == 1;
    }
}

static void choose_axes(struct dem_pieces *p, struct node *node, int nodes)
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
            longest = -node[k].box[a + 3] - node[k].box[a] > -node[k].box[longest + 3] - node[k].box[longest] ? a : longest;
        }
        p->axis[mid] = longest;
        node[k].low = node[k].weight > 0.0 ? node[k].box[longest] : 0.0;
        node[k].high = node[k].weight > 0.0 ? -node[k].box[longest + 3] : 0.0;
    }
}

/* What lies below the plane tried now, of each node that still searches. */
static void weigh(const struct dem_pieces *p, const struct load *q, const struct node *node, int nodes, double *below)
{
    memset(below, 0, (size_t)nodes*sizeof *below);
    for (size_t i = 0; i < q->n; i++)
    {
        const struct node *const k = &node[q->of[i]];
        const int mid = (k->lo + k->hi)/2;

        if (!k->found && place(q, i)[p->axis[mid]] < 0.5*(k->low + k->high))
        {
            below[q->of[i]] += weight_of(q->weight, i);
        }
    }
    MPI_Allreduce(MPI_IN_PLACE, below, nodes, MPI_DOUBLE, MPI_SUM, p->comm);
}

static void search_planes(struct dem_pieces *p, const struct load *q, struct node *node, int nodes, double *below)
{
    int searching = 1;

    for (int step = 0; step < BISECTIONS && searching; step++)
    {
        weigh(p, q, node, nodes, below);
        searching = 0;
        for (int k = 0; k < nodes; k++)
        {
            const int mid = (node[k].lo + node[k].hi)/2;
            const double plane = 0.5*(node[k].low + node[k].high), share = node[k].weight/(node[k].hi - node[k].lo);
            const double excess = below[k] - share*(mid - node[k].lo);

            if (!node[k].found)
            {
                *(excess < 0.0 ? &node[k].low : &node[k].high) = plane;
                p->at[mid] = plane;
                node[k].found = fabs(excess) <= tolerance*share;
                searching |= !node[k].found;
            }
        }
    }
}

/* Children of the nodes that still hold several ranks; single ranks are done and keep their place. */
static int descend(struct dem_pieces *p, const struct load *q, struct node *node, struct node *next, int nodes, int *child)
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

        q->of[i] = child[q->of[i]] + (k->hi - k->lo > 1 && place(q, i)[p->axis[mid]] >= p->at[mid]);
    }
    return count;
}

static int cut(struct dem_pieces *p, struct load load)
{
    struct node *node, *next;
    double *work;
    int *child, nodes = 1;

    if (p->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(node, 2*p->ranks));
    DEM_TRY(DEM_NEW(next, 2*p->ranks));
    DEM_TRY(DEM_NEW(work, 14*p->ranks));
    DEM_TRY(DEM_NEW(child, 2*p->ranks));
    DEM_TRY(DEM_NEW(load.of, load.n + 1));
    node[0] = (struct node){.lo = 0, .hi = p->ranks};
    while (nodes < p->ranks)
    {
        struct node *const old = node;

        extents(p, &load, node, nodes, work);
        choose_axes(p, node, nodes);
        search_planes(p, &load, node, nodes, work);
        nodes = descend(p, &load, node, next, nodes, child);
        node = next;
        next = old;
    }
    dem_memory_free(node);
    dem_memory_free(next);
    dem_memory_free(work);
    dem_memory_free(child);
    dem_memory_free(load.of);
    return DEM_OK;
}

int dem_pieces_balance(struct dem_pieces *p, const struct dem_particles *q, const uint32_t *weight)
{
    return cut(p, (struct load){.n = q->n, .stride = sizeof *q->record/sizeof(double), .x = q->n > 0 ? q->record->x : NULL, .weight = weight});
}

int dem_pieces_cut(struct dem_pieces *p, size_t n, const double *x, size_t stride)
{
    return cut(p, (struct load){.n = n, .stride = stride, .x = x});
}

int dem_pieces_owner(const struct dem_pieces *p, const double x[3])
{
    int lo = 0, hi = p->ranks;

    while (hi - lo > 1)
    {
        const int mid = (lo + hi)/2;

        *(x[p->axis[mid]] < p->at[mid] ? &hi : &lo) = mid;
    }
    return lo;
}

void dem_pieces_box(const struct dem_pieces *p, int rank, double min[3], double max[3])
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
