/*
 * stream.c -- reading streams and outlets; what is owed when, and where number k may come in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/stream.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include "base/unknown.h"
#include "base/vec.h"
#include "io/crowd.h"
#include "io/scene_parts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    USE_SPREAD = 201,                                     /* streams of random numbers: three each */
    USE_PLACE = 1001                                      /* and from here on four a trial */
};

/* A centre on a mesh's face belongs to no cell, and a face of four corners is not flat: this share of a radius further in. */
static const double behind_face = 1e-3;

/* ---- reading ------------------------------------------------------------------------------------------------- */

int dem_stream_is(const struct dem_dict *group)
{
    const char *type = "";

    return dem_dict_has(group, "type") && dem_dict_word(group, "type", &type) == DEM_OK && strcmp(type, "stream") == 0;
}

static int read_name(char *name, const struct dem_dict *dict, const char *where)
{
    DEM_REQUIRE(strlen(dem_dict_name(dict)) < DEM_FLOW_NAME, DEM_ERROR_INPUT, "%s: a name longer than %d letters; shorten it", where,
                DEM_FLOW_NAME - 1);
    snprintf(name, DEM_FLOW_NAME, "%s", dem_dict_name(dict));
    return DEM_OK;
}

static int read_rate(struct dem_stream *s, const struct dem_dict *dict)
{
    s->by_mass = dem_dict_has(dict, "massRate");
    DEM_REQUIRE(s->by_mass + dem_dict_has(dict, "rate") == 1, DEM_ERROR_INPUT, "%s: %s of rate (particles a second) and massRate (kg/s); "
                "give one of them", s->where, s->by_mass ? "both" : "none");
    DEM_TRY(dem_dict_number(dict, s->by_mass ? "massRate" : "rate", s->by_mass ? "kg/s" : "1/s", &s->rate));
    DEM_REQUIRE(s->rate > 0.0, DEM_ERROR_INPUT, "%s: %s %g; give a number above 0", s->where, s->by_mass ? "massRate" : "rate", s->rate);
    DEM_TRY(dem_dict_number_or(dict, "start", "s", 0.0, &s->start));
    DEM_TRY(dem_dict_number_or(dict, "end", "s", INFINITY, &s->end));
    DEM_REQUIRE(s->start < s->end, DEM_ERROR_INPUT, "%s: start %g s is not before end %g s; give an earlier one", s->where, s->start, s->end);
    DEM_TRY(dem_dict_int64_or(dict, "count", INT64_MAX, &s->count));
    DEM_REQUIRE(s->count > 0, DEM_ERROR_INPUT, "%s: count %lld; give 1 or more, or leave it out", s->where, (long long)s->count);
    DEM_TRY(dem_dict_number_or(dict, "mass", "kg", INFINITY, &s->mass));
    DEM_REQUIRE(s->mass > 0.0, DEM_ERROR_INPUT, "%s: mass %g kg; give a number above 0, or leave it out", s->where, s->mass);
    return DEM_OK;
}

/* `velocity fluid;` is for patches; who comes through a face must go somewhere. */
static int read_velocity(struct dem_stream *s, const struct dem_dict *dict)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const char *word = "fluid";

    if (s->mouth.patch && dem_dict_has(dict, "velocity"))
    {
        s->with_fluid = dem_dict_word(dict, "velocity", &word) == DEM_OK;
    }
    else
    {
        s->with_fluid = s->mouth.patch != NULL;
    }
    DEM_REQUIRE(!s->with_fluid || strcmp(word, "fluid") == 0, DEM_ERROR_INPUT, "%s: velocity %s; give fluid, or a vector in m/s", s->where, word);
    if (!s->with_fluid)
    {
        DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, s->velocity));
    }
    DEM_TRY(dem_dict_vector_or(dict, "spread", "m/s", zero, s->spread));
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, s->spin));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(s->spread[k] >= 0.0, DEM_ERROR_INPUT, "%s: spread (%g %g %g) m/s; give numbers of 0 or more", s->where, s->spread[0],
                    s->spread[1], s->spread[2]);
    }
    DEM_REQUIRE(s->with_fluid || s->mouth.kind == DEM_MOUTH_REGION || dem_vec_norm(s->velocity) > 0.0, DEM_ERROR_INPUT,
                "%s: who comes through a face has a velocity; give it", s->where);
    return DEM_OK;
}

static int check_masses(const struct dem_stream *s, const struct dem_recipe *r)
{
    const double d[2] = {s->sizes.least, s->sizes.most};

    for (int k = 0; k < 2; k++)
    {
        const double mass = r->material[s->material].density*dem_sphere_volume(0.5*d[k]);

        DEM_REQUIRE(isnormal(mass*d[k]*d[k]) && isnormal(1.0/(mass*d[k]*d[k])), DEM_ERROR_INPUT,
                    "%s: diameter %g m of %s, density %g kg/m3, makes a mass of %g kg; give real ones", s->where, d[k],
                    r->material[s->material].name, r->material[s->material].density, mass);
    }
    return DEM_OK;
}

static int read_stream(struct dem_stream *s, const struct dem_dict *dict, const struct dem_recipe *r)
{
    const char *type;

    memset(s, 0, sizeof *s);
    snprintf(s->where, sizeof s->where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(read_name(s->name, dict, s->where));
    DEM_TRY(dem_scene_read_material_of(dict, r, &s->material));
    DEM_TRY(dem_dict_int64_or(dict, "seed", 1, &s->seed));
    DEM_TRY(read_rate(s, dict));
    DEM_TRY(dem_mouth_read(&s->mouth, dict, s->where));
    DEM_TRY(read_velocity(s, dict));
    DEM_TRY(dem_sizes_read(&s->sizes, dict));
    DEM_TRY(check_masses(s, r));
    return dem_mouth_holds(&s->mouth, 0.5*s->sizes.most, s->where);
}

static int read_outlet(struct dem_outlet *o, const struct dem_dict *dict)
{
    const int plane = dem_dict_has(dict, "point") || dem_dict_has(dict, "normal");
    const int boxed = dem_dict_has(dict, "min") || dem_dict_has(dict, "max");
    const int ways = plane + boxed + dem_dict_has(dict, "cylinder") + dem_dict_has(dict, "sphere") + dem_dict_has(dict, "patch");
    char where[256];

    memset(o, 0, sizeof *o);
    snprintf(where, sizeof where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(read_name(o->name, dict, where));
    DEM_REQUIRE(ways == 1, DEM_ERROR_INPUT, "%s: %s of min and max, cylinder, sphere, point and normal, patch; give one of them", where,
                ways ? "more than one" : "none");
    if (dem_dict_has(dict, "patch"))
    {
        return dem_dict_word(dict, "patch", &o->patch);
    }
    o->plane = plane;
    if (plane)
    {
        DEM_TRY(dem_dict_vector(dict, "point", "m", o->vessel.from));
        DEM_TRY(dem_dict_vector(dict, "normal", "1", o->vessel.axis));
        DEM_REQUIRE(dem_vec_norm(o->vessel.axis) > 0.0, DEM_ERROR_INPUT, "%s: the normal is zero; give the way out", where);
        return DEM_OK;
    }
    DEM_TRY(dem_vessel_read(&o->vessel, dict));
    return dem_vessel_holds(&o->vessel, 0.0, where);
}

/* A stream and an outlet of one name would be one row of the tables. */
static int refuse_twins(const struct dem_streams *s)
{
    for (int o = 0; o < s->outlets; o++)
    {
        DEM_REQUIRE(strcmp(s->outlet[o].name, "domain") != 0, DEM_ERROR_INPUT, "outlets/domain: that name is taken by those who leave the "
                    "domain; give another one");
        for (int k = 0; k < s->streams; k++)
        {
            DEM_REQUIRE(strcmp(s->outlet[o].name, s->stream[k].name) != 0, DEM_ERROR_INPUT, "insert/%s and outlets/%s have one name; rename one "
                        "of them", s->outlet[o].name, s->outlet[o].name);
        }
    }
    /* and one more for the domain */
    DEM_REQUIRE(s->streams + s->outlets < DEM_SNAPSHOT_FLOWS, DEM_ERROR_INPUT, "%d streams and %d outlets; the limit is %d in all; join some",
                s->streams, s->outlets, DEM_SNAPSHOT_FLOWS - 1);
    return DEM_OK;
}

int dem_streams_read(struct dem_streams *s, const struct dem_dict *insert, const struct dem_dict *outlets, const struct dem_recipe *r)
{
    for (size_t k = 0; insert && k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        if (dem_entry_is_dict(e) && dem_stream_is(dem_entry_dict(e)))
        {
            DEM_TRY(DEM_GROW(s->stream, s->stream_room, s->streams + 1));
            DEM_TRY(read_stream(&s->stream[s->streams++], dem_entry_dict(e), r));
        }
    }
    for (size_t k = 0; outlets && k < dem_dict_count(outlets); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(outlets, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT, "%s: outlets holds regions like %s { point (0 0 0); normal (0 0 -1); }",
                    dem_entry_where(e), dem_entry_name(e));
        DEM_TRY(DEM_GROW(s->outlet, s->outlet_room, s->outlets + 1));
        DEM_TRY(read_outlet(&s->outlet[s->outlets++], dem_entry_dict(e)));
    }
    return refuse_twins(s);
}

void dem_streams_free(struct dem_streams *s)
{
    for (int k = 0; k < s->streams; k++)
    {
        dem_sizes_free(&s->stream[k].sizes);
        dem_mouth_free(&s->stream[k].mouth);
    }
    dem_memory_free(s->stream);
    dem_memory_free(s->outlet);
    memset(s, 0, sizeof *s);
}

/* ---- asking -------------------------------------------------------------------------------------------------- */

void dem_streams_radii(const struct dem_streams *s, double *least, double *most)
{
    for (int k = 0; k < s->streams; k++)
    {
        const struct dem_stream *const t = &s->stream[k];
        const double small = 0.5*t->sizes.least, large = 0.5*t->sizes.most;

        least[t->material] = least[t->material] > 0.0 ? fmin(least[t->material], small) : small;
        most[t->material] = fmax(most[t->material], large);
    }
}

/* A mesh's patch is looked at by the program that has the mesh. */
static int mouth_inside(const struct dem_stream *s, const struct dem_domain *d)
{
    const double edge = s->mouth.kind == DEM_MOUTH_REGION ? 0.5*s->sizes.least : 0.0, radius = 0.5*s->sizes.least;
    double min[3], max[3];

    DEM_REQUIRE(!s->mouth.patch || s->mouth.n > 0, DEM_ERROR_INPUT, "%s: patch %s, but no mesh has given it; run it in OpenFOAM, or give a "
                "region or a surface", s->where, s->mouth.patch);
    dem_mouth_box(&s->mouth, min, max);
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(fmax(fabs(min[k]), fabs(max[k])) <= dem_crowd_far*radius, DEM_ERROR_INPUT, "%s: it reaches from %g to %g m along %c, more than "
                    "%g radii of %g m from the origin, where a double tells no overlaps apart; move it", s->where, min[k], max[k], "xyz"[k],
                    dem_crowd_far, radius);
        DEM_REQUIRE(d->periodic[k] || (min[k] + edge >= d->min[k] && max[k] - edge <= d->max[k]), DEM_ERROR_INPUT,
                    "%s: from %g to %g m along %c it is not inside the domain, %g to %g m; make it smaller, or enlarge the domain", s->where,
                    min[k], max[k], "xyz"[k], d->min[k], d->max[k]);
    }
    return DEM_OK;
}

int dem_streams_inside(const struct dem_streams *s, const struct dem_domain *d)
{
    for (int k = 0; k < s->streams; k++)
    {
        DEM_TRY(mouth_inside(&s->stream[k], d));
    }
    for (int k = 0; k < s->outlets; k++)
    {
        DEM_REQUIRE(!s->outlet[k].patch || s->meshed, DEM_ERROR_INPUT, "outlets/%s: patch %s, but there is no mesh; run it in OpenFOAM, or give a "
                    "region", s->outlet[k].name, s->outlet[k].patch);
    }
    return DEM_OK;
}

double dem_stream_owes(const struct dem_stream *s, double since, double time)
{
    return s->rate*fmax(0.0, fmin(time, s->end) - fmax(since, s->start));
}

double dem_stream_diameter(const struct dem_stream *s, int64_t k)
{
    return dem_sizes_draw(&s->sizes, (uint64_t)s->seed, (uint64_t)k);
}

double dem_stream_mean_mass(const struct dem_stream *s, const struct dem_recipe *r)
{
    return r->material[s->material].density*dem_sizes_mean_volume(&s->sizes);
}

double dem_stream_way(const struct dem_stream *s, double ago, double radius)
{
    const double behind = s->mouth.patch ? 2.0*behind_face*radius : 0.0;    /* past any round-off */
    double fastest = 0.0;

    for (size_t t = 0; s->with_fluid && t < s->mouth.n; t++)
    {
        fastest = fmax(fastest, dem_vec_norm(s->mouth.flow[t]));
    }
    return s->mouth.kind == DEM_MOUTH_REGION ? 0.0 : behind + ago*(fastest + dem_vec_norm(s->velocity) + dem_vec_norm(s->spread));
}

int dem_stream_place(const struct dem_stream *s, const struct dem_stream_trial *t, double x[3], double v[3])
{
    const uint64_t seed = (uint64_t)s->seed, number = (uint64_t)t->number, step = (uint64_t)t->step, use = USE_PLACE + 4*(uint64_t)t->trial;
    size_t triangle;
    double u[3], inward[3];

    for (unsigned k = 0; k < 3; k++)
    {
        u[k] = dem_random_unit(seed, number, step, use + k);
    }
    if (!dem_mouth_place(&s->mouth, t->radius, u, x, &triangle))
    {
        return 0;
    }
    const double way = s->mouth.kind == DEM_MOUTH_REGION ? 0.0 : t->ago*dem_random_unit(seed, number, step, use + 3);

    dem_mouth_inward(&s->mouth, triangle, inward);
    for (unsigned k = 0; k < 3; k++)
    {
        v[k] = (s->with_fluid ? s->mouth.flow[triangle][k] : s->velocity[k])
               + s->spread[k]*(2.0*dem_random_unit(seed, number, 0, USE_SPREAD + k) - 1.0);
        x[k] += way*v[k];
    }
    for (int k = 0; k < 3; k++)
    {
        x[k] += s->mouth.patch ? behind_face*t->radius*inward[k] : 0.0;
    }
    return !s->mouth.patch || dem_vec_dot(v, inward) > 0.0;
}

int dem_outlet_holds(const struct dem_outlet *o, const double x[3])
{
    if (o->plane)
    {
        return (x[0] - o->vessel.from[0])*o->vessel.axis[0] + (x[1] - o->vessel.from[1])*o->vessel.axis[1]
               + (x[2] - o->vessel.from[2])*o->vessel.axis[2] > 0.0;
    }
    return !o->patch && dem_vessel_contains(&o->vessel, x);
}
