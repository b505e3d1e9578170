/*
 * pieces.c -- all planes of one level of the tree are found together by bisection on counts.
 *
 * Our own hundred lines rather than Zoltan: Debian's Zoltan comes with all of Trilinos.
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

struct node                                               /* a group of ranks [lo, hi) and its particles' extent */
{
    int lo, hi;
    double box[6];                                        /* m: min, then -max, so that one minimum finds both */
    double low, high;                                     /* m: where the plane is searched */
    double count, below;
};

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

static void extents(const struct dem_pieces *p, const struct dem_particles *q, const int *of, struct node *node, int nodes,
                    double *work)
{
    for (int k = 0; k < 7*nodes; k++)
    {
        work[k] = k < 6*nodes ? INFINITY : 0.0;
    }
    for (size_t i = 0; i < q->n; i++)
    {
        for (int a = 0; a < 3; a++)
        {
            const double x = q->record[i].x[a];
            double *const box = work + 6*of[i];

            box[a] = x < box[a] ? x : box[a];
            box[a + 3] = -x < box[a + 3] ? -x : box[a + 3];
        }
        work[6*nodes + of[i]] += 1.0;
    }
    MPI_Allreduce(MPI_IN_PLACE, work, 6*nodes, MPI_DOUBLE, MPI_MIN, p->comm);
    MPI_Allreduce(MPI_IN_PLACE, work + 6*nodes, nodes, MPI_DOUBLE, MPI_SUM, p->comm);
    for (int k = 0; k < nodes; k++)
    {
        memcpy(node[k].box, work + 6*k, sizeof node[k].box);
        node[k].count = work[6*nodes + k];
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
        node[k].low = node[k].count > 0.0 ? node[k].box[longest] : 0.0;
        node[k].high = node[k].count > 0.0 ? -node[k].box[longest + 3] : 0.0;
    }
}

static void search_planes(struct dem_pieces *p, const struct dem_particles *q, const int *of, struct node *node, int nodes,
                          double *below)
{
    for (int step = 0; step < BISECTIONS; step++)
    {
        memset(below, 0, (size_t)nodes*sizeof *below);
        for (size_t i = 0; i < q->n; i++)
        {
            const struct node *const k = &node[of[i]];
            const int mid = (k->lo + k->hi)/2;

            below[of[i]] += k->hi - k->lo > 1 && q->record[i].x[p->axis[mid]] < 0.5*(k->low + k->high);
        }
        MPI_Allreduce(MPI_IN_PLACE, below, nodes, MPI_DOUBLE, MPI_SUM, p->comm);
        for (int k = 0; k < nodes; k++)
        {
            const int mid = (node[k].lo + node[k].hi)/2;
            const double plane = 0.5*(node[k].low + node[k].high);
            const double wanted = node[k].count*(mid - node[k].lo)/(node[k].hi - node[k].lo);

            if (node[k].hi - node[k].lo > 1)
            {
                *(below[k] < wanted ? &node[k].low : &node[k].high) = plane;
                p->at[mid] = plane;
            }
        }
    }
}

/* Children of the nodes that still hold several ranks; single ranks are done and keep their place. */
static int descend(struct dem_pieces *p, const struct dem_particles *q, int *of, struct node *node, struct node *next, int nodes,
                   int *child)
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
        const struct node *const k = &node[of[i]];
        const int mid = (k->lo + k->hi)/2;

        of[i] = child[of[i]] + (k->hi - k->lo > 1 && q->record[i].x[p->axis[mid]] >= p->at[mid]);
    }
    return count;
}

int dem_pieces_balance(struct dem_pieces *p, const struct dem_particles *q)
{
    struct node *node, *next;
    double *work;
    int *of, *child, nodes = 1;

    if (p->ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(node, 2*p->ranks));
    DEM_TRY(DEM_NEW(next, 2*p->ranks));
    DEM_TRY(DEM_NEW(work, 14*p->ranks));
    DEM_TRY(DEM_NEW(child, 2*p->ranks));
    DEM_TRY(DEM_NEW(of, q->n + 1));
    node[0] = (struct node){.lo = 0, .hi = p->ranks};
    while (nodes < p->ranks)
    {
        struct node *const old = node;

        extents(p, q, of, node, nodes, work);
        choose_axes(p, node, nodes);
        search_planes(p, q, of, node, nodes, work);
        nodes = descend(p, q, of, node, next, nodes, child);
        node = next;
        next = old;
    }
    dem_memory_free(node);
    dem_memory_free(next);
    dem_memory_free(work);
    dem_memory_free(child);
    dem_memory_free(of);
    return DEM_OK;
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

double dem_pieces_imbalance(const struct dem_pieces *p, size_t n)
{
    double count[2] = {(double)n, (double)n};

    if (p->ranks == 1)
    {
        return 1.0;
    }
    MPI_Allreduce(MPI_IN_PLACE, &count[0], 1, MPI_DOUBLE, MPI_MAX, p->comm);
    MPI_Allreduce(MPI_IN_PLACE, &count[1], 1, MPI_DOUBLE, MPI_SUM, p->comm);
    return count[1] > 0.0 ? count[0]*p->ranks/count[1] : 1.0;
}
