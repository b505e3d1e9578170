/*
 * packing.c -- who has to be placed, who is there already; then places, then pushing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/packing.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

static const double most_fraction = 0.57;                 /* 0.58 takes three times as long as 0.55; random close packing is 0.64 */

int dem_packing_may_fit(const struct dem_vessel *v, double volume, double n, const char *where)
{
    const double fraction = volume/dem_vessel_volume(v);

    DEM_REQUIRE(fraction <= most_fraction, DEM_ERROR_INPUT,
                "%s: %.10g particles at random are a solid fraction of %.3g, and no more than %g finds room; enlarge the region, ask for fewer, "
                "use type lattice, or let a looser packing settle", where, n, fraction, most_fraction);
    return DEM_OK;
}

static double diameter_of(const struct dem_packing *p, int64_t m)
{
    return p->diameters ? p->diameters[m] : p->diameter;
}

static int may_touch(const struct dem_vessel *v, const struct dem_particle *q)
{
    int may = 1;

    for (int k = 0; k < 3; k++)
    {
        may &= q->x[k] + q->radius > v->min[k] && q->x[k] - q->radius < v->max[k];
    }
    return may;
}

/* The radii of all ranks: the list is everywhere, the crowd is not. Returns the mean diameter of the list. */
static double learn_sizes(const struct dem_packing *p, const struct dem_crowd *c, struct dem_spots *s)
{
    double sum = 0.0, most[DEM_SPOT_LEVELS];

    for (int64_t m = 0; m < (p->diameters ? p->n : 1); m++)
    {
        s->most = fmax(s->most, 0.5*diameter_of(p, m));
        sum += diameter_of(p, m);
    }
    for (size_t k = 0; k < c->n; k++)
    {
        s->most = may_touch(p->vessel, &c->particle[k]) ? fmax(s->most, c->particle[k].radius) : s->most;
    }
    if (s->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &s->most, 1, MPI_DOUBLE, MPI_MAX, s->pieces.comm);
    }
    for (int64_t m = 0; m < (p->diameters ? p->n : 1); m++)
    {
        dem_spots_admit(s, 0.5*diameter_of(p, m));
    }
    for (size_t k = 0; k < c->n; k++)
    {
        if (may_touch(p->vessel, &c->particle[k]))
        {
            dem_spots_admit(s, c->particle[k].radius);
        }
    }
    for (int k = 0; k < DEM_SPOT_LEVELS && s->pieces.ranks > 1; k++)
    {
        most[k] = s->level[k].most;
    }
    if (s->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, most, DEM_SPOT_LEVELS, MPI_DOUBLE, MPI_MAX, s->pieces.comm);
    }
    for (int k = 0; k < DEM_SPOT_LEVELS && s->pieces.ranks > 1; k++)
    {
        s->level[k].most = most[k];
    }
    return sum/(double)(p->diameters ? p->n : 1);
}

/* Who is there already goes to the rank that owns the place, as a copy to others. */
static int take_fixed(const struct dem_packing *p, const struct dem_crowd *c, struct dem_spots *s)
{
    enum { OWN, COPY };

    s->posts = 0;
    for (size_t k = 0; k < c->n; k++)
    {
        struct dem_spot spot = {.radius = c->particle[k].radius, .name = -1};
        int gone;

        if (may_touch(p->vessel, &c->particle[k]))
        {
            memcpy(spot.x, c->particle[k].x, sizeof spot.x);
            DEM_TRY(dem_spots_copy(s, &spot, COPY, spot.radius + s->most));
            DEM_TRY(dem_spots_send(s, &spot, OWN, &gone));
            spot.v[0] = 1.0;
            DEM_TRY(gone ? DEM_OK : dem_spots_add(s, &spot));
        }
    }
    DEM_TRY(dem_spots_deliver(s));
    for (size_t k = 0; k < s->posts; k++)
    {
        s->post[k].spot.v[0] = s->post[k].what == OWN;
        DEM_TRY(dem_spots_add(s, &s->post[k].spot));
    }
    s->posts = 0;
    return DEM_OK;
}

/* Cut the vessel where this rank's share of the list would come first. */
static int share_vessel(const struct dem_packing *p, struct dem_spots *s)
{
    const int64_t ranks = s->pieces.ranks, from = p->n*s->pieces.rank/ranks, to = p->n*(s->pieces.rank + 1)/ranks;
    struct dem_spot *first;

    if (ranks == 1)
    {
        return dem_spots_share(s, 0, NULL, p->vessel->min, p->vessel->max);
    }
    DEM_TRY(DEM_NEW(first, to - from + 1));
    for (int64_t m = from; m < to; m++)
    {
        first[m - from] = (struct dem_spot){.radius = 0.5*diameter_of(p, m), .name = m};
        dem_packing_draw(p, &first[m - from], 0);
    }
    const int status = dem_spots_share(s, (size_t)(to - from), first, p->vessel->min, p->vessel->max);

    dem_memory_free(first);
    return status;
}

int dem_packing_fill(const struct dem_packing *p, const struct dem_crowd *c, struct dem_spots *s)
{
    int64_t left;
    const double width = learn_sizes(p, c, s);

    DEM_TRY(share_vessel(p, s));
    DEM_TRY(take_fixed(p, c, s));
    DEM_TRY(dem_packing_place(p, s, &left));
    return left > 0 ? dem_packing_push(p, s, width) : DEM_OK;
}
