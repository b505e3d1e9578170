/*
 * insert_facts.c -- what is known of groups that have been read, before their particles are placed: radii, number, place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/insert_batch.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include <math.h>
#include <stdlib.h>

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

/* ---- ids ------------------------------------------------------------------------------------------------------ */

int64_t dem_batch_next_id(const struct dem_batch *b, int64_t first)
{
    int64_t next = first + (b->ids ? 0 : b->count);

    for (int64_t m = 0; b->ids && m < b->count; m++)
    {
        next = b->ids[m] >= next ? b->ids[m] + 1 : next;
    }
    return next;
}

int64_t dem_insert_next_id(const struct dem_insertion *i)
{
    int64_t next = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        next = dem_batch_next_id(&i->batch[k], next);
    }
    return next;
}

struct span                                               /* of ids, both included */
{
    int64_t from, to;
};

static int compare_spans(const void *a, const void *b)
{
    const struct span *const p = a, *const q = b;

    return (p->from > q->from) - (p->from < q->from);
}

/* Groups without ids are a span each, all others one by one. Returns how many. */
static size_t list_spans(const struct dem_insertion *i, size_t n, const int64_t *id, struct span *span)
{
    int64_t next = 0;
    size_t count = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_batch *const b = &i->batch[k];

        for (int64_t m = 0; b->ids && m < b->count; m++)
        {
            span[count++] = (struct span){b->ids[m], b->ids[m]};
        }
        if (!b->ids && b->count > 0)
        {
            span[count++] = (struct span){next, next + b->count - 1};
        }
        next = dem_batch_next_id(b, next);
    }
    for (size_t k = 0; k < n; k++)
    {
        span[count++] = (struct span){id[k], id[k]};
    }
    return count;
}

int dem_insert_refuse_twins(const struct dem_insertion *i, size_t n, const int64_t *id)
{
    struct span *span;
    size_t most = n + i->n;
    int64_t twin = -1, last = -1;

    for (size_t k = 0; k < i->n; k++)
    {
        most += i->batch[k].ids ? (size_t)i->batch[k].count : 0;
    }
    DEM_TRY(DEM_NEW(span, most + 1));
    const size_t count = list_spans(i, n, id, span);

    dem_sort_by(span, count, sizeof *span, compare_spans);
    for (size_t k = 0; k < count; k++)
    {
        twin = span[k].from <= last && twin < 0 ? span[k].from : twin;
        last = span[k].to > last ? span[k].to : last;
    }
    dem_memory_free(span);
    DEM_REQUIRE(twin < 0, DEM_ERROR_INPUT, "two particles have id %lld; give each its own, or none: then the next free one is taken",
                (long long)twin);
    return DEM_OK;
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

static int each_inside(const struct dem_batch *b, const struct dem_domain *d, int64_t first)
{
    for (int64_t m = 0; m < b->count; m++)
    {
        DEM_TRY(check_far(b, "a particle", b->positions[m], 0.5*dem_batch_diameter(b, m)));
        DEM_TRY(check_place(b, d, b->ids ? b->ids[m] : first + m, b->positions[m]));
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
        default: DEM_TRY(each_inside(b, d, first)); break;
        }
        first = dem_batch_next_id(b, first);
    }
    return DEM_OK;
}
