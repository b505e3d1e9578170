/*
 * insert_facts.c -- what is known of groups that have been read, before their particles are placed: radii, number, place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/insert_batch.h"
#include "base/error.h"
#include <math.h>

void dem_insert_radii(const struct dem_insertion *i, double *least, double *most)
{
    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_batch *const b = &i->batch[k];

        for (int64_t m = 0; m < (b->diameters ? b->count : b->count > 0); m++)
        {
            const double radius = 0.5*dem_batch_diameter(b, m);

            least[b->material] = least[b->material] > 0.0 ? fmin(least[b->material], radius) : radius;
            most[b->material] = fmax(most[b->material], radius);
        }
    }
}

int64_t dem_insert_count(const struct dem_insertion *i)
{
    int64_t n = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        n += i->batch[k].count;
    }
    return n;
}

/* ---- where: in the domain, not too far --------------------------------------------------------------------------------------- */

static int check_far(const struct dem_batch *b, const char *what, const double x[3], double radius)
{
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(fabs(x[k]) <= dem_crowd_far*radius, DEM_ERROR_INPUT,
                    "%s: %s at (%g %g %g) m is more than %g radii of %g m from the origin, where a double tells no overlaps apart; move it",
                    b->where, what, x[0], x[1], x[2], dem_crowd_far, radius);
    }
    return DEM_OK;
}

static int check_place(const struct dem_batch *b, const struct dem_domain *d, int64_t id, const double x[3])
{
    DEM_REQUIRE(dem_domain_holds(d, x), DEM_ERROR_INPUT,
                "%s: particle %lld at (%g %g %g) m is outside the domain; move it, or enlarge the domain", b->where, (long long)id, x[0], x[1], x[2]);
    return DEM_OK;
}

/* Ends of the first row and layer, the first and the last of all. */
static int lattice_inside(const struct dem_batch *b, const struct dem_domain *d, int64_t first)
{
    const int64_t turn[] = {1, b->sites[0], b->sites[0]*b->sites[1], b->count};

    for (int k = 0; k < 4; k++)
    {
        const int64_t m = (turn[k] < b->count ? turn[k] : b->count) - 1;
        double x[3];

        dem_batch_site(b, m, x);
        DEM_TRY(check_far(b, "a particle", x, 0.5*b->diameter));
        DEM_TRY(check_place(b, d, first + m, x));
    }
    return DEM_OK;
}

/* Centres lie anywhere in the region. */
static int region_inside(const struct dem_batch *b, const struct dem_domain *d)
{
    const struct dem_vessel *const v = &b->vessel;
    double least = INFINITY;

    for (int64_t m = 0; m < (b->diameters ? b->count : 1); m++)
    {
        least = fmin(least, 0.5*dem_batch_diameter(b, m));
    }
    DEM_TRY(check_far(b, dem_vessel_name(v), v->min, least));
    DEM_TRY(check_far(b, dem_vessel_name(v), v->max, least));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(d->periodic[k] || (v->min[k] + least >= d->min[k] && v->max[k] - least <= d->max[k]), DEM_ERROR_INPUT,
                    "%s: the %s from %g to %g m along %c is not inside the domain, %g to %g m; make it smaller, or enlarge the domain",
                    b->where, dem_vessel_name(v), v->min[k], v->max[k], "xyz"[k], d->min[k], d->max[k]);
    }
    return DEM_OK;
}

static int list_inside(const struct dem_batch *b, const struct dem_domain *d, int64_t first)
{
    for (int64_t m = 0; m < b->count; m++)
    {
        DEM_TRY(check_far(b, "a particle", b->positions[m], 0.5*dem_batch_diameter(b, m)));
        DEM_TRY(check_place(b, d, first + m, b->positions[m]));
    }
    return DEM_OK;
}

int dem_insert_inside(const struct dem_insertion *i, const struct dem_domain *d)
{
    int64_t first = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_batch *const b = &i->batch[k];

        switch (b->type)
        {
        case DEM_BATCH_LATTICE: DEM_TRY(lattice_inside(b, d, first)); break;
        case DEM_BATCH_RANDOM: DEM_TRY(region_inside(b, d)); break;
        default: DEM_TRY(list_inside(b, d, first)); break;
        }
        first += b->count;
    }
    return DEM_OK;
}
