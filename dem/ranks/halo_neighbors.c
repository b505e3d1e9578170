/*
 * halo_neighbors.c -- finds the neighbor ranks by descending the tree of the decomposition.
 *
 * The cost grows with the number of neighbours and of levels of the tree, not with the number of
 * ranks. The outer subdomains extend to infinity; along a periodic axis they end at the faces of
 * the domain, otherwise all particles would be near through their images.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/halo.h"
#include "core/memory.h"
#include "core/sort.h"
#include <math.h>

void dem_halo_box(const struct dem_halo *h, const struct dem_domain *d, int rank, double box[2][3])
{
    dem_decomposition_box(h->decomposition, rank, box[0], box[1]);
    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            box[0][k] = fmax(box[0][k], d->min[k]);
            box[1][k] = fmin(box[1][k], d->max[k]);
        }
    }
}

/* Append the ranks of [lo, hi) whose subdomains meet the box. */
static int descend(struct dem_halo *h, double box[2][3], int lo, int hi)
{
    const int mid = (lo + hi)/2;

    if (hi - lo == 1)
    {
        DEM_TRY(DEM_GROW(h->neighbor, h->neighbor_capacity, h->neighbors + 1));
        h->neighbor[h->neighbors] = lo;
        h->neighbors += lo != h->decomposition->rank;
        return DEM_OK;
    }
    const double plane = h->decomposition->at[mid];
    const int axis = h->decomposition->axis[mid];

    DEM_TRY(box[0][axis] <= plane ? descend(h, box, lo, mid) : DEM_OK);
    return box[1][axis] >= plane ? descend(h, box, mid, hi) : DEM_OK;
}

static int ascending(const void *a, const void *b)
{
    const int p = *(const int *)a, q = *(const int *)b;

    return (p > q) - (p < q);
}

static void sort_unique(struct dem_halo *h)
{
    int count = 0;

    dem_sort_by(h->neighbor, (size_t)h->neighbors, sizeof *h->neighbor, ascending);
    for (int k = 0; k < h->neighbors; k++)
    {
        if (count == 0 || h->neighbor[k] != h->neighbor[count - 1])
        {
            h->neighbor[count++] = h->neighbor[k];
        }
    }
    h->neighbors = count;
}

int dem_halo_find_neighbors(struct dem_halo *h, const struct dem_domain *d, double reach)
{
    double own[2][3], shift[DEM_SHIFTS][4];

    h->neighbors = 0;
    dem_halo_box(h, d, h->decomposition->rank, own);
    dem_domain_shifts(d, shift);
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        double box[2][3];
        int meets = 1;

        for (int k = 0; k < 3; k++)
        {
            box[0][k] = own[0][k] + shift[code][k] - reach;
            box[1][k] = own[1][k] + shift[code][k] + reach;
            meets &= dem_shift_axis(code, k) == 0 ||
                     (d->periodic[k] && box[0][k] <= d->max[k] && box[1][k] >= d->min[k]);
        }
        DEM_TRY(meets ? descend(h, box, 0, h->decomposition->ranks) : DEM_OK);
    }
    sort_unique(h);
    return DEM_OK;
}
