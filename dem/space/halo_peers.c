/*
 * halo_peers.c -- the ranks whose pieces come near this one's, found down the tree of pieces: as many steps as there are
 * neighbours and levels, however many ranks there are.
 *
 * Pieces reach to infinity at the outside; along a periodic axis they end at the domain's faces, else all particles would be near
 * through their images.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/halo_peers.h"
#include "base/memory.h"
#include "base/sort.h"
#include <math.h>
#include <stdlib.h>

void dem_halo_box(const struct dem_halo *h, const struct dem_domain *d, int rank, double box[2][3])
{
    dem_pieces_box(h->pieces, rank, box[0], box[1]);
    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            box[0][k] = fmax(box[0][k], d->min[k]);
            box[1][k] = fmin(box[1][k], d->max[k]);
        }
    }
}

/* Those of the ranks [lo, hi) whose pieces meet the box. */
static int descend(struct dem_halo *h, double box[2][3], int lo, int hi)
{
    const int mid = (lo + hi)/2;

    if (hi - lo == 1)
    {
        DEM_TRY(DEM_GROW(h->peer, h->peer_room, h->peers + 1));
        h->peer[h->peers] = lo;
        h->peers += lo != h->pieces->rank;
        return DEM_OK;
    }
    const double plane = h->pieces->at[mid];
    const int axis = h->pieces->axis[mid];

    DEM_TRY(box[0][axis] <= plane ? descend(h, box, lo, mid) : DEM_OK);
    return box[1][axis] >= plane ? descend(h, box, mid, hi) : DEM_OK;
}

static int ascending(const void *a, const void *b)
{
    const int p = *(const int *)a, q = *(const int *)b;

    return (p > q) - (p < q);
}

static void sort_out(struct dem_halo *h)
{
    int kept = 0;

    dem_sort_by(h->peer, (size_t)h->peers, sizeof *h->peer, ascending);
    for (int k = 0; k < h->peers; k++)
    {
        if (kept == 0 || h->peer[k] != h->peer[kept - 1])
        {
            h->peer[kept++] = h->peer[k];
        }
    }
    h->peers = kept;
}

int dem_halo_find_peers(struct dem_halo *h, const struct dem_domain *d, double reach)
{
    double mine[2][3], shift[DEM_SHIFTS][4];

    h->peers = 0;
    dem_halo_box(h, d, h->pieces->rank, mine);
    dem_domain_shifts(d, shift);
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        double box[2][3];
        int meets = 1;

        for (int k = 0; k < 3; k++)
        {
            box[0][k] = mine[0][k] + shift[code][k] - reach;
            box[1][k] = mine[1][k] + shift[code][k] + reach;
            meets &= dem_shift_axis(code, k) == 0 || (d->periodic[k] && box[0][k] <= d->max[k] && box[1][k] >= d->min[k]);
        }
        DEM_TRY(meets ? descend(h, box, 0, h->pieces->ranks) : DEM_OK);
    }
    sort_out(h);
    return DEM_OK;
}
