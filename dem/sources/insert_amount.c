/*
 * insert_amount.c -- the number of particles of a group: from count, mass [kg] or solidFraction of
 * its region.
 *
 * With mass or solidFraction, diameters are drawn until their volume is closest to the target: the
 * error is at most half of the last particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_amount.h"
#include "core/error.h"
#include "core/memory.h"
#include <math.h>
#include <stdio.h>

static const double pi = 3.14159265358979323846;

static int check_volume(const struct dem_insert_group *b, const struct dem_amount *a, double mean)
{
    DEM_REQUIRE(a->volume > 0.0, DEM_ERROR_INPUT, "%s: %s: less than half a particle; ask for more",
                b->where, a->what);
    DEM_REQUIRE(a->volume <= dem_amount_max*mean, DEM_ERROR_INPUT,
                "%s: %s: %.3g particles of %.3g m3 on average, the limit is %.0f; ask for less, or "
                "make several groups", b->where, a->what,
                a->volume/mean, mean, dem_amount_max);
    return DEM_OK;
}

static int read_count(struct dem_amount *a, const struct dem_insert_group *b)
{
    DEM_TRY(dem_dict_int64(b->dict, "count", &a->count));
    DEM_REQUIRE(a->count > 0 && (double)a->count <= dem_amount_max, DEM_ERROR_INPUT,
                "%s: count %lld; give 1 to %.0f", b->where, (long long)a->count, dem_amount_max);
    return DEM_OK;
}

int dem_amount_read(struct dem_amount *a, const struct dem_insert_group *b,
                    const struct dem_interaction_table *r, double mean)
{
    const struct dem_dict *const d = b->dict;
    const int ways =
        dem_dict_has(d, "count") + dem_dict_has(d, "mass") + dem_dict_has(d, "solidFraction");
    const struct dem_material *const m = &r->material[b->material];
    double value;

    *a = (struct dem_amount){.count = 0};
    DEM_REQUIRE(ways == 1 || (ways == 0 && b->type == DEM_INSERT_LATTICE), DEM_ERROR_INPUT,
                "%s: %s of count, mass, solidFraction; give one of them", b->where,
                ways ? "more than one" : "none");
    if (dem_dict_has(d, "count"))
    {
        return read_count(a, b);
    }
    if (dem_dict_has(d, "mass"))
    {
        DEM_TRY(dem_dict_number(d, "mass", "kg", &value));
        DEM_REQUIRE(value > 0.0, DEM_ERROR_INPUT, "%s: mass %g kg; give a number above 0", b->where,
                    value);
        a->volume = value/m->density;
        snprintf(a->what, sizeof a->what, "mass %g kg of %s, density %g kg/m3", value, m->name,
                 m->density);
        return check_volume(b, a, mean);
    }
    if (dem_dict_has(d, "solidFraction"))
    {
        DEM_TRY(dem_dict_number(d, "solidFraction", "1", &value));
        DEM_REQUIRE(value > 0.0 && value < 0.74, DEM_ERROR_INPUT,
                    "%s: solidFraction %g; give a number above 0 and below 0.74", b->where, value);
        a->volume = value*dem_insertion_shape_volume(&b->shape);
        snprintf(a->what, sizeof a->what, "solidFraction %g", value);
        return check_volume(b, a, mean);
    }
    return DEM_OK;
}

static int count_equal(struct dem_insert_group *b, const struct dem_amount *a, double diameter)
{
    const double each = b->clump.shape ? b->clump.shape->volume : pi/6.0*diameter*diameter*diameter;
    const double nearest = floor(a->volume/each + 0.5);

    b->diameter = diameter;
    b->count = a->count > 0 ? a->count : (int64_t)nearest;
    DEM_REQUIRE(b->count > 0, DEM_ERROR_INPUT,
                "%s: %s: less than half a particle, the first of which has %.3g m3; ask for more",
                b->where, a->what, each);
    return DEM_OK;
}

int dem_amount_draw(struct dem_insert_group *b, const struct dem_amount *a,
                    const struct dem_size_distribution *sizes)
{
    double volume = 0.0, last = 0.0;
    size_t capacity = 0;

    if (sizes->n == 0)
    {
        return count_equal(b, a, sizes->min);
    }
    for (b->count = 0; a->count > 0 ? b->count < a->count : volume < a->volume; b->count++)
    {
        /* a few large particles in the distribution make the mean a bad estimate of the number */
        DEM_REQUIRE((double)b->count < 2.0*dem_amount_max, DEM_ERROR_INPUT,
                    "%s: more than %.0f particles; ask for fewer", b->where, dem_amount_max);
        DEM_TRY(DEM_GROW(b->drawn, capacity, (size_t)b->count + 1));
        const double d = b->drawn[b->count] =
            dem_size_distribution_draw(sizes, (uint64_t)b->seed, (uint64_t)b->count);

        last = pi/6.0*d*d*d;
        volume += last;
    }
    b->count -= a->count == 0 && b->count > 0 && volume - a->volume > 0.5*last;
    b->diameters = b->drawn;
    DEM_REQUIRE(b->count > 0, DEM_ERROR_INPUT,
                "%s: %s: less than half a particle, the first of which has %.3g m3; ask for more",
                b->where, a->what, last);
    return DEM_OK;
}
