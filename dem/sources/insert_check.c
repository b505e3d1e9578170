/*
 * insert_check.c -- queries and checks of groups before their particles are placed: radii, ids,
 * positions in the domain.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include <math.h>
#include <stdlib.h>

void dem_insert_radii(const struct dem_insertion *i, double *min, double *max, double *body)
{
    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_insert_group *const b = &i->group[k];
        const int64_t sizes = b->clump.shape ? dem_clump_source_ids(&b->clump) : b->diameters ? b->count : 1;

        for (int64_t m = 0; m < (b->count > 0 ? sizes : 0); m++)
        {
            const double radius = b->clump.shape ? b->clump.shape->sphere[m][3]
                                           : 0.5*dem_insert_group_diameter(b, m);

            min[b->material] = min[b->material] > 0.0 ? fmin(min[b->material], radius) : radius;
            max[b->material] = fmax(max[b->material], radius);
        }
        dem_clump_source_limit(&b->clump, &body[b->material]);
    }
}

void dem_insert_ratios(const struct dem_insertion *i, struct dem_interaction_table *r)
{
    for (size_t k = 0; r->parcels.used && k < i->n; k++)
    {
        const struct dem_insert_group *const b = &i->group[k];
        const double *const ratios = b->scalars[r->parcels.scalar];

        for (int64_t m = 0; m < (ratios ? b->count : 1); m++)
        {
            dem_interaction_table_add_parcel(r, ratios ? ratios[m] : b->ratio);
        }
    }
}

/* ---- ids ------------------------------------------------------------------------------------- */

int64_t dem_insert_next_id(const struct dem_insertion *i)
{
    int64_t next = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        next = dem_insert_group_next_id(&i->group[k], next);
    }
    return next;
}

/* a range of ids, both ends included */
struct id_range
{
    int64_t from, to;
};

static int compare_ranges(const void *a, const void *b)
{
    const struct id_range *const p = a, *const q = b;

    return (p->from > q->from) - (p->from < q->from);
}

/* A group without ids is one range; a given id is a range of one. Returns the number of ranges. */
static size_t list_ranges(const struct dem_insertion *i, size_t n, const int64_t *id,
                          struct id_range *range)
{
    int64_t next = 0;
    size_t count = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_insert_group *const b = &i->group[k];

        for (int64_t m = 0; b->ids && m < b->count; m++)
        {
            range[count++] = (struct id_range){b->ids[m], b->ids[m]};
        }
        if (!b->ids && b->count > 0)
        {
            range[count++] = (struct id_range){next, next + b->count*dem_clump_source_ids(&b->clump) - 1};
        }
        next = dem_insert_group_next_id(b, next);
    }
    for (size_t k = 0; k < n; k++)
    {
        range[count++] = (struct id_range){id[k], id[k]};
    }
    return count;
}

int dem_insert_refuse_duplicates(const struct dem_insertion *i, size_t n, const int64_t *id)
{
    struct id_range *range;
    size_t capacity = n + i->n;
    int64_t duplicate = -1, last = -1;

    for (size_t k = 0; k < i->n; k++)
    {
        capacity += i->group[k].ids ? (size_t)i->group[k].count : 0;
    }
    DEM_TRY(DEM_NEW(range, capacity + 1));
    const size_t count = list_ranges(i, n, id, range);

    dem_sort_by(range, count, sizeof *range, compare_ranges);
    for (size_t k = 0; k < count; k++)
    {
        duplicate = range[k].from <= last && duplicate < 0 ? range[k].from : duplicate;
        last = range[k].to > last ? range[k].to : last;
    }
    dem_memory_free(range);
    DEM_REQUIRE(duplicate < 0, DEM_ERROR_INPUT, "two particles have id %lld; give each its own, or "
                "none: then the next free one is taken",
                (long long)duplicate);
    return DEM_OK;
}

/* ---- positions: in the domain, near the origin ----------------------------------------------- */

static int check_distance(const struct dem_insert_group *b, const char *what, const double x[3],
                          double radius)
{
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(fabs(x[k]) <= dem_max_distance*radius, DEM_ERROR_INPUT,
                    "%s: %s at (%g %g %g) m is more than %g radii of %g m from the origin, where "
                    "overlaps are lost in rounding; move it",
                    b->where, what, x[0], x[1], x[2], dem_max_distance, radius);
    }
    return DEM_OK;
}

static int check_domain(const struct dem_insert_group *b, const struct dem_domain *d, int64_t id,
                        const double x[3])
{
    DEM_REQUIRE(dem_domain_contains(d, x), DEM_ERROR_INPUT,
                "%s: particle %lld at (%g %g %g) m is outside the domain; move it, or enlarge the "
                "domain",
                b->where, (long long)id, x[0], x[1], x[2]);
    return DEM_OK;
}

/* The first particle, the ends of the first row and layer, and the last particle. */
static int lattice_inside(const struct dem_insert_group *b, const struct dem_domain *d,
                          int64_t first)
{
    const int64_t end[] = {1, b->sites[0], b->sites[0]*b->sites[1], b->count};

    for (int k = 0; k < 4; k++)
    {
        const int64_t m = (end[k] < b->count ? end[k] : b->count) - 1;
        double x[3];

        dem_insert_group_site(b, m, x);
        DEM_TRY(check_distance(b, "a particle", x, 0.5*b->diameter));
        DEM_TRY(check_domain(b, d, first + m, x));
    }
    return DEM_OK;
}

/* Centres may lie anywhere in the region, a radius from its boundary. */
static int region_inside(const struct dem_insert_group *b, const struct dem_domain *d)
{
    const struct dem_insertion_shape *const v = &b->shape;
    double radius = INFINITY;    /* m  the smallest */

    for (int64_t m = 0; m < (b->diameters ? b->count : 1); m++)
    {
        radius = fmin(radius, 0.5*dem_insert_group_diameter(b, m));
    }
    DEM_TRY(check_distance(b, dem_insertion_shape_name(v), v->min, radius));
    DEM_TRY(check_distance(b, dem_insertion_shape_name(v), v->max, radius));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(d->periodic[k]
                        || (v->min[k] + radius >= d->min[k] && v->max[k] - radius <= d->max[k]),
                    DEM_ERROR_INPUT,
                    "%s: the %s from %g to %g m along %c is not inside the domain, %g to %g m; "
                    "make it smaller, or enlarge the domain",
                    b->where, dem_insertion_shape_name(v), v->min[k], v->max[k], "xyz"[k],
                    d->min[k], d->max[k]);
    }
    return DEM_OK;
}

static int each_inside(const struct dem_insert_group *b, const struct dem_domain *d, int64_t first)
{
    for (int64_t m = 0; m < b->count; m++)
    {
        DEM_TRY(check_distance(b, "a particle", b->positions[m],
                               0.5*dem_insert_group_diameter(b, m)));
        DEM_TRY(check_domain(b, d, b->ids ? b->ids[m] : first + m, b->positions[m]));
    }
    return DEM_OK;
}

int dem_insert_check_domain(const struct dem_insertion *i, const struct dem_domain *d)
{
    int64_t first = 0;

    for (size_t k = 0; k < i->n; k++)
    {
        const struct dem_insert_group *const b = &i->group[k];

        switch (b->type)
        {
        case DEM_INSERT_LATTICE: DEM_TRY(lattice_inside(b, d, first)); break;
        case DEM_INSERT_RANDOM: DEM_TRY(region_inside(b, d)); break;
        default: DEM_TRY(each_inside(b, d, first)); break;
        }
        first = dem_insert_group_next_id(b, first);
    }
    return DEM_OK;
}
