/*
 * stream_read.c -- streams, outlets and walls that absorb, from the text of a scene.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/stream.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "sources/insert.h"
#include "laws/material_entry.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int read_name(char *name, const struct dem_dict *dict, const char *where)
{
    DEM_REQUIRE(strlen(dem_dict_name(dict)) < DEM_FLOW_NAME, DEM_ERROR_INPUT,
                "%s: a name longer than %d characters; shorten it", where, DEM_FLOW_NAME - 1);
    snprintf(name, DEM_FLOW_NAME, "%s", dem_dict_name(dict));
    return DEM_OK;
}

static int read_rate(struct dem_stream *s, const struct dem_dict *dict)
{
    s->by_mass = dem_dict_has(dict, "massRate");
    DEM_REQUIRE(s->by_mass + dem_dict_has(dict, "rate") == 1, DEM_ERROR_INPUT,
                "%s: %s of rate (particles a second) and massRate (kg/s); "
                "give one of them",
                s->where, s->by_mass ? "both" : "none");
    DEM_TRY(dem_dict_number(dict, s->by_mass ? "massRate" : "rate", s->by_mass ? "kg/s" : "1/s",
                            &s->rate));
    DEM_REQUIRE(s->rate > 0.0, DEM_ERROR_INPUT, "%s: %s %g; give a number above 0", s->where,
                s->by_mass ? "massRate" : "rate", s->rate);
    DEM_TRY(dem_dict_time_or(dict, "start", 0.0, &s->start, &s->stage[0]));
    DEM_TRY(dem_dict_time_or(dict, "end", INFINITY, &s->end, &s->stage[1]));
    DEM_TRY(dem_dict_check_times(dict, "start", "end", (const double[2]){s->start, s->end}, s->stage));
    DEM_TRY(dem_dict_int64_or(dict, "count", INT64_MAX, &s->count));
    DEM_REQUIRE(s->count > 0, DEM_ERROR_INPUT, "%s: count %lld; give 1 or more, or leave it out",
                s->where, (long long)s->count);
    DEM_TRY(dem_dict_number_or(dict, "mass", "kg", INFINITY, &s->mass));
    DEM_REQUIRE(s->mass > 0.0, DEM_ERROR_INPUT,
                "%s: mass %g kg; give a number above 0, or leave it out", s->where, s->mass);
    return DEM_OK;
}

/* `velocity fluid;` is for patches; a particle that enters through a face needs a velocity. */
static int read_velocity(struct dem_stream *s, const struct dem_dict *dict)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const char *word = "fluid";

    if (s->inlet.patch && dem_dict_has(dict, "velocity"))
    {
        s->with_fluid = dem_dict_word(dict, "velocity", &word) == DEM_OK;
    }
    else
    {
        s->with_fluid = s->inlet.patch != NULL;
    }
    DEM_REQUIRE(!s->with_fluid || strcmp(word, "fluid") == 0, DEM_ERROR_INPUT,
                "%s: velocity %s; give fluid, or a vector in m/s", s->where, word);
    if (!s->with_fluid)
    {
        DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, s->velocity));
    }
    DEM_TRY(dem_dict_vector_or(dict, "spread", "m/s", zero, s->spread));
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, s->spin));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(s->spread[k] >= 0.0, DEM_ERROR_INPUT,
                    "%s: spread (%g %g %g) m/s; give numbers of 0 or more", s->where, s->spread[0],
                    s->spread[1], s->spread[2]);
    }
    DEM_REQUIRE(s->with_fluid || s->inlet.kind == DEM_INLET_REGION ||
                    dem_vec_norm(s->velocity) > 0.0,
                DEM_ERROR_INPUT,
                "%s: particles that enter through a face need a velocity; give velocity", s->where);
    return DEM_OK;
}

static int check_masses(const struct dem_stream *s, const struct dem_interaction_table *r)
{
    const double d[2] = {s->sizes.min, s->sizes.max};

    for (int k = 0; k < 2; k++)
    {
        const double mass = r->material[s->material].density*dem_sphere_volume(0.5*d[k]);

        DEM_REQUIRE(
            isnormal(mass*d[k]*d[k]) && isnormal(1.0/(mass*d[k]*d[k])), DEM_ERROR_INPUT,
            "%s: diameter %g m of %s, density %g kg/m3, makes a mass of %g kg, outside the range of numbers; correct them",
            s->where, d[k], r->material[s->material].name, r->material[s->material].density, mass);
    }
    return DEM_OK;
}

/* A body has the diameter of the sphere that holds it in any orientation. */
static int read_sizes(struct dem_stream *s, const struct dem_dict *dict)
{
    if (s->clump.shape)
    {
        s->sizes.min = s->sizes.max = 2.0*s->clump.shape->bound;
        return DEM_OK;
    }
    return dem_size_distribution_read(&s->sizes, dict, s->ratio);
}

static int read_stream(struct dem_stream *s, const struct dem_dict *dict,
                       const struct dem_interaction_table *r, const struct dem_domain *d,
                       const struct dem_clump_shapes *shapes)
{
    const char *type;

    memset(s, 0, sizeof *s);
    snprintf(s->where, sizeof s->where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(read_name(s->name, dict, s->where));
    DEM_TRY(dem_material_entry_read(dict, r, &s->material));
    DEM_TRY(dem_dict_int64_or(dict, "seed", 1, &s->seed));
    DEM_TRY(dem_scalar_entries_read(dict, r, 1, s->scalar));
    DEM_TRY(dem_scalar_entries_parcel_ratio(r, s->scalar, s->where, &s->ratio));
    DEM_TRY(dem_clump_source_read(&s->clump, dict, shapes, d, s->where));
    DEM_TRY(read_sizes(s, dict));
    DEM_TRY(check_masses(s, r));
    if (strcmp(type, "stream") != 0)
    {
        DEM_TRY(dem_stream_read_group(s, dict, type, r, d));
        return read_velocity(s, dict);
    }
    DEM_TRY(read_rate(s, dict));
    DEM_TRY(dem_inlet_shape_read(&s->inlet, dict, s->where));
    DEM_TRY(read_velocity(s, dict));
    return dem_inlet_shape_check(&s->inlet, d, 0.5*s->sizes.max, s->where);
}

static int read_outlet(struct dem_outlet *o, const struct dem_dict *dict)
{
    const int plane = dem_dict_has(dict, "point") || dem_dict_has(dict, "normal");
    const int boxed = dem_dict_has(dict, "min") || dem_dict_has(dict, "max");
    const int shapes = plane + boxed + dem_dict_has(dict, "cylinder") +
                       dem_dict_has(dict, "sphere") + dem_dict_has(dict, "patch");
    char where[256];

    memset(o, 0, sizeof *o);
    snprintf(where, sizeof where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(read_name(o->name, dict, where));
    DEM_TRY(dem_dict_number_or(dict, "residence", "s", 0.0, &o->residence));
    DEM_REQUIRE(o->residence > 0.0 || !dem_dict_has(dict, "residence"), DEM_ERROR_INPUT,
                "%s: residence %g s; give the end of the histogram, above 0", where, o->residence);
    DEM_REQUIRE(
        shapes == 1, DEM_ERROR_INPUT,
        "%s: %s of min and max, cylinder, sphere, point and normal, patch; give one of them", where,
        shapes ? "more than one" : "none");
    if (dem_dict_has(dict, "patch"))
    {
        return dem_dict_word(dict, "patch", &o->patch);
    }
    o->plane = plane;
    if (plane)
    {
        DEM_TRY(dem_dict_vector(dict, "point", "m", o->shape.from));
        DEM_TRY(dem_dict_vector(dict, "normal", "1", o->shape.axis));
        DEM_REQUIRE(dem_vec_norm(o->shape.axis) > 0.0, DEM_ERROR_INPUT,
                    "%s: the normal is zero; give the direction out of the domain", where);
        return DEM_OK;
    }
    DEM_TRY(dem_insertion_shape_read(&o->shape, dict));
    return dem_insertion_shape_check_fits(&o->shape, 0.0, where);
}

/* A stream and an outlet of the same name could not be distinguished in tables. */
static int check_names(const struct dem_streams *s)
{
    for (int o = 0; o < s->outlets; o++)
    {
        DEM_REQUIRE(
            strcmp(s->outlet[o].name, "domain") != 0, DEM_ERROR_INPUT,
            "outlets/domain: this name is reserved for particles that leave the domain; give "
            "another one");
        for (int k = 0; k < s->streams; k++)
        {
            DEM_REQUIRE(strcmp(s->outlet[o].name, s->stream[k].name) != 0, DEM_ERROR_INPUT,
                        "insert/%s and outlets/%s have the same name; rename one of them",
                        s->outlet[o].name, s->outlet[o].name);
        }
    }
    return DEM_OK;
}

int dem_streams_read(struct dem_streams *s, const struct dem_dict *insert,
                     const struct dem_dict *outlets, const struct dem_interaction_table *r,
                     const struct dem_domain *d)
{
    for (size_t k = 0; insert && k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        if (dem_entry_is_dict(e) && dem_insert_is_stream(dem_entry_dict(e)))
        {
            DEM_TRY(DEM_GROW(s->stream, s->stream_capacity, s->streams + 1));
            DEM_TRY(read_stream(&s->stream[s->streams++], dem_entry_dict(e), r, d, s->shapes));
        }
    }
    for (size_t k = 0; outlets && k < dem_dict_count(outlets); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(outlets, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: outlets holds regions like %s { point (0 0 0); normal (0 0 -1); }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(DEM_GROW(s->outlet, s->outlet_capacity, s->outlets + 1));
        DEM_TRY(read_outlet(&s->outlet[s->outlets++], dem_entry_dict(e)));
    }
    return check_names(s);
}

int dem_streams_add_wall(struct dem_streams *s, const char *name, int *outlet)
{
    for (int k = 0; k < s->outlets; k++)
    {
        const int same = strcmp(s->outlet[k].name, name) == 0;

        DEM_REQUIRE(
            !same || s->outlet[k].wall, DEM_ERROR_INPUT,
            "walls/%s absorbs particles and is counted by its name, which an outlet has too; rename one of them",
            name);
        if (same)
        {
            *outlet = k;
            return DEM_OK;
        }
    }
    DEM_REQUIRE(strlen(name) < DEM_FLOW_NAME, DEM_ERROR_INPUT,
                "walls/%s absorbs particles and is counted by its name, which has %zu "
                "characters; the limit is %zu",
                name, strlen(name), (size_t)DEM_FLOW_NAME - 1);
    DEM_TRY(DEM_GROW(s->outlet, s->outlet_capacity, s->outlets + 1));
    *outlet = s->outlets;
    s->outlet[s->outlets] = (struct dem_outlet){.wall = 1};
    snprintf(s->outlet[s->outlets++].name, DEM_FLOW_NAME, "%s", name);
    return check_names(s);
}
