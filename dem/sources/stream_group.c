/*
 * stream_group.c -- read a group of `insert` with a time `at`: a stream whose particles are all due then.
 *
 *     more { type random; at 0.5; count 1000; min; max; material; diameter; velocity; }
 *     ball { type list; at NAME; positions ((0 0 0.1)); material; diameter; velocity; }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/stream.h"
#include "core/error.h"
#include "core/memory.h"
#include "sources/insert_amount.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The box around all positions of a list; its particles have one diameter and velocity. */
static int read_positions(struct dem_stream *s, const struct dem_dict *dict)
{
    struct dem_insertion_shape *const box = &s->inlet.shape;
    const double radius = 0.5*s->sizes.max;
    size_t n;

    DEM_TRY(dem_dict_vectors(dict, "positions", "m", &s->positions, &n));
    DEM_REQUIRE(n > 0 && s->sizes.n == 0, DEM_ERROR_INPUT,
                "%s: a list with `at` has %zu positions and one diameter for all; give at least one "
                "position, and diameter", s->where, n);
    s->count = (int64_t)n;
    for (int k = 0; k < 3; k++)
    {
        box->min[k] = INFINITY;
        box->max[k] = -INFINITY;
        for (size_t m = 0; m < n; m++)
        {
            box->min[k] = fmin(box->min[k], s->positions[m][k] - radius);
            box->max[k] = fmax(box->max[k], s->positions[m][k] + radius);
        }
    }
    return DEM_OK;
}

/* The number of particles of a random group, from count, mass or solidFraction. */
static int read_group_count(struct dem_stream *s, const struct dem_dict *dict,
                            const struct dem_interaction_table *r)
{
    struct dem_insert_group group = {.dict = dict,
                                     .type = DEM_INSERT_RANDOM,
                                     .material = s->material,
                                     .seed = s->seed,
                                     .shape = s->inlet.shape,
                                     .clump = s->clump};
    struct dem_amount amount;

    snprintf(group.where, sizeof group.where, "%s", s->where);
    DEM_TRY(dem_amount_read(&amount, &group, r,
                            s->clump.shape ? s->clump.shape->volume
                                           : dem_size_distribution_mean_volume(&s->sizes)));
    const int status = dem_amount_draw(&group, &amount, &s->sizes);

    dem_memory_free(group.drawn);
    s->count = group.count;
    return status;
}

/* What a group with `at` has instead of a rate and an inlet; the region of a random one is opened at
   periodic faces before its volume counts. */
int dem_stream_read_group(struct dem_stream *s, const struct dem_dict *dict, const char *type,
                          const struct dem_interaction_table *r, const struct dem_domain *d)
{
    const int list = strcmp(type, "list") == 0;

    DEM_REQUIRE(list || strcmp(type, "random") == 0, DEM_ERROR_INPUT,
                "%s: type %s with `at`; groups of a later time are of type random or list", s->where,
                type);
    DEM_TRY(dem_dict_time_or(dict, "at", 0.0, &s->start, &s->stage[0]));
    DEM_REQUIRE(s->stage[0] || (s->start >= 0.0 && isfinite(s->start)), DEM_ERROR_INPUT,
                "%s: at %g s; give a time of 0 or more, or the name of a stage", s->where, s->start);
    s->end = s->start;
    s->stage[1] = s->stage[0];
    s->at_once = 1;
    s->mass = INFINITY;
    DEM_TRY(list ? read_positions(s, dict) : dem_inlet_shape_read(&s->inlet, dict, s->where));
    DEM_REQUIRE(s->inlet.kind == DEM_INLET_REGION, DEM_ERROR_INPUT,
                "%s: a random group with `at` fills a region; give min and max, cylinder or sphere",
                s->where);
    DEM_TRY(list ? DEM_OK : dem_inlet_shape_check(&s->inlet, d, 0.5*s->sizes.max, s->where));
    DEM_TRY(list ? DEM_OK : read_group_count(s, dict, r));
    s->rate = (double)s->count;
    return DEM_OK;
}
