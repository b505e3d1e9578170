/*
 * scene.c -- read a whole scene; here also its short entries: domain, time, neighbours, bonds, start.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/did_you_mean.h"
#include "case/scene_internal.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* `min (x y z); max (x y z);`, or single axes, `x (0 0.1);`. The other axes have no limits. */
static int read_limits(struct dem_domain *d, const struct dem_dict *dict)
{
    static const char *const axis[] = {"x", "y", "z"};
    const bool corners = dem_dict_has(dict, "min") || dem_dict_has(dict, "max");
    int axes = 0;

    for (int k = 0; k < 3; k++)
    {
        const double *limit;
        size_t n;

        if (dem_dict_has(dict, axis[k]))
        {
            DEM_TRY(dem_dict_numbers(dict, axis[k], "m", &limit, &n));
            DEM_REQUIRE(n == 2, DEM_ERROR_INPUT,
                        "%s: domain/%s has %zu numbers; give two, %s (min max)",
                        dem_dict_where(dict), axis[k], n, axis[k]);
            DEM_REQUIRE(!corners, DEM_ERROR_INPUT,
                        "%s: domain has min or max and %s, which define the same limits; keep min "
                        "and max, or x, y, z",
                        dem_dict_where(dict), axis[k]);
            d->min[k] = limit[0];
            d->max[k] = limit[1];
            axes++;
        }
    }
    if (corners || axes == 0)
    {
        DEM_TRY(dem_dict_vector(dict, "min", "m", d->min));
        DEM_TRY(dem_dict_vector(dict, "max", "m", d->max));
    }
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(d->min[k] < d->max[k], DEM_ERROR_INPUT,
                    "%s: domain: min %g m is not below max %g m along %s", dem_dict_where(dict),
                    d->min[k], d->max[k], axis[k]);
    }
    return DEM_OK;
}

/* Read the list `periodic` or `flat`: its axes need limits. */
static int read_axes(const struct dem_domain *d, const struct dem_dict *dict, const char *list,
                     int found[3])
{
    const char *const *axis;
    size_t n;

    if (!dem_dict_has(dict, list))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_words(dict, list, &axis, &n));
    for (size_t k = 0; k < n; k++)
    {
        static const char *const known[] = {"x", "y", "z"};
        const int a = axis[k][0] - 'x';

        if (a < 0 || a > 2 || axis[k][1])
        {
            char what[32];

            snprintf(what, sizeof what, "%s axis", list);
            return dem_error_prefix(dem_did_you_mean_error(what, axis[k], known, 3),
                                    "%s: ", dem_dict_where(dict));
        }
        DEM_REQUIRE(isfinite(d->max[a] - d->min[a]), DEM_ERROR_INPUT,
                    "%s: domain: axis %s is %s but has no limits; give them, %s (min max)",
                    dem_dict_where(dict), axis[k], list, axis[k]);
        found[a] = 1;
    }
    return DEM_OK;
}

/* Read which axes are periodic and flat; complete the domain. */
static int read_axis_types(struct dem_domain *d, const struct dem_dict *dict)
{
    DEM_TRY(read_axes(d, dict, "periodic", d->periodic));
    DEM_TRY(read_axes(d, dict, "flat", d->flat));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(!d->periodic[k] || !d->flat[k], DEM_ERROR_INPUT,
                    "%s: domain: axis %c is both periodic and flat, but particles do not move "
                    "along a flat axis; keep one",
                    dem_dict_where(dict), "xyz"[k]);
    }
    DEM_REQUIRE(d->flat[0] + d->flat[1] + d->flat[2] < 3, DEM_ERROR_INPUT,
                "%s: domain: all axes are flat, so that no particle can move; keep two at most",
                dem_dict_where(dict));
    dem_domain_finish(d);
    return DEM_OK;
}

static int read_domain(struct dem_domain *d, struct dem_cell *cell, const struct dem_dict *scene)
{
    static const char *const known[] = {"error", "remove"};
    const struct dem_dict *dict;
    const char *leaving;

    DEM_TRY(dem_dict_sub_if(scene, "domain", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(read_limits(d, dict));
    DEM_TRY(dem_dict_word_or(dict, "leaving", "error", &leaving));
    d->remove = strcmp(leaving, "remove") == 0;
    if (!d->remove && strcmp(leaving, "error") != 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("way of leaving", leaving, known, 2),
                                "%s: ", dem_dict_where(dict));
    }
    DEM_TRY(read_axis_types(d, dict));
    return dem_scene_read_cell(cell, d, dict);
}

/* Particles are parcels of grains. */
static int read_parcels(struct dem_interaction_table *r, const struct dem_dict *scene)
{
    const struct dem_dict *dict;
    double ratio;

    DEM_TRY(dem_dict_sub_if(scene, "parcels", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number(dict, "ratio", "1", &ratio));
    DEM_TRY(dem_interaction_table_use_parcels(r, ratio, dem_dict_where(dict)));
    return dem_scalar_require(r, r->parcels.scalar, ratio, dem_dict_where(dict));
}

static int read_time(struct dem_scene *s, const struct dem_dict *scene)
{
    const struct dem_dict *dict;
    const char *step;

    s->max_overlap = 0.5;
    s->max_start_overlap = 0.05;
    DEM_TRY(dem_dict_sub_if(scene, "time", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_number_or(dict, "maxOverlap", "1", s->max_overlap, &s->max_overlap));
    DEM_REQUIRE(s->max_overlap > 0.0, DEM_ERROR_INPUT,
                "%s: maxOverlap %g of a diameter; give a number above 0", dem_dict_where(dict),
                s->max_overlap);
    DEM_TRY(dem_dict_number_or(dict, "maxStartOverlap", "1",
                               fmin(s->max_start_overlap, s->max_overlap), &s->max_start_overlap));
    DEM_REQUIRE(s->max_start_overlap > 0.0 && s->max_start_overlap <= s->max_overlap,
                DEM_ERROR_INPUT,
                "%s: maxStartOverlap %g of a diameter; give a number above 0 and up to maxOverlap, "
                "%g, at which the run stops",
                dem_dict_where(dict), s->max_start_overlap, s->max_overlap);
    DEM_TRY(dem_dict_number_or(dict, "maxSpeed", "m/s", 0.0, &s->max_speed));
    DEM_REQUIRE(s->max_speed > 0.0 || !dem_dict_has(dict, "maxSpeed"), DEM_ERROR_INPUT,
                "%s: maxSpeed %g m/s; give a number above 0, or leave it out", dem_dict_where(dict),
                s->max_speed);
    DEM_TRY(dem_dict_switch_or(dict, "force", false, &s->force));
    DEM_TRY(dem_dict_word_or(dict, "step", "auto", &step));
    if (strcmp(step, "auto") != 0)
    {
        DEM_TRY(dem_dict_number(dict, "step", "s", &s->step));
        DEM_REQUIRE(s->step > 0.0, DEM_ERROR_INPUT, "%s: step %g s; give a number above 0, or auto",
                    dem_dict_where(dict), s->step);
    }
    return DEM_OK;
}

static int read_neighbours(struct dem_scene *s, const struct dem_dict *scene)
{
    const struct dem_dict *dict;

    s->outer_skin = 0.3;
    s->inner_skin = 0.04;
    s->tuned_skins = 1;
    DEM_TRY(dem_dict_sub_if(scene, "neighbours", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    s->tuned_skins = !dem_dict_has(dict, "outerSkin") && !dem_dict_has(dict, "innerSkin");
    DEM_TRY(dem_dict_number_or(dict, "outerSkin", "1", s->outer_skin, &s->outer_skin));
    DEM_TRY(dem_dict_number_or(dict, "innerSkin", "1", s->inner_skin, &s->inner_skin));
    DEM_REQUIRE(s->inner_skin > 0.0 && s->outer_skin >= s->inner_skin && s->outer_skin <= 2.0,
                DEM_ERROR_INPUT,
                "%s: outerSkin %g, innerSkin %g (of a diameter); give 0 < innerSkin <= outerSkin "
                "<= 2",
                dem_dict_where(dict), s->outer_skin, s->inner_skin);
    return DEM_OK;
}

/* ---- all entries ----------------------------------------------------------------------------- */

static int check_bonds(const int64_t *id, size_t n, const char *where)
{
    DEM_REQUIRE(n%2 == 0, DEM_ERROR_INPUT, "%s: bonds/pairs: %zu ids; give two for each bond",
                where, n);
    for (size_t k = 0; k < n; k += 2)
    {
        DEM_REQUIRE(id[k] >= 0 && id[k + 1] >= 0 && id[k] != id[k + 1], DEM_ERROR_INPUT,
                    "%s: bonds/pairs: %lld and %lld; give two different ids of particles, whole "
                    "numbers from 0",
                    where, (long long)id[k], (long long)id[k + 1]);
    }
    return DEM_OK;
}

/* Read only when an effect makes bonds; without one the entry is refused as unread. */
static int read_bonds(struct dem_scene *s, const struct dem_dict *scene,
                      const struct dem_interaction_table *r)
{
    const struct dem_dict *bonds = NULL;

    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        if (e->makes_listed)
        {
            DEM_TRY(dem_dict_sub_if(scene, "bonds", &bonds));
            DEM_REQUIRE(
                bonds || !e->makes_listed(r->settings[k]), DEM_ERROR_INPUT,
                "effects/%s makes listed bonds, but the scene has no list; add bonds { pairs (...); } with two ids for each",
                e->name);
        }
    }
    if (!bonds)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_int64s(bonds, "pairs", &s->bond_ids, &s->bond_id_count));
    return check_bonds(s->bond_ids, s->bond_id_count, dem_dict_where(bonds));
}

/* Particles of a snapshot may be frozen, or freed. */
static int read_frozen(struct dem_scene *s, const struct dem_dict *start,
                       struct dem_interaction_table *r)
{
    bool frozen = false;

    s->start_frozen = -1;
    if (dem_dict_has(start, "frozen"))
    {
        DEM_TRY(dem_dict_switch(start, "frozen", &frozen));
        s->start_frozen = frozen;
    }
    r->motionless = frozen;
    return DEM_OK;
}

static int read_device(struct dem_scene *s, const struct dem_dict *scene)
{
    s->device = "cpu";
    DEM_TRY(dem_dict_has(scene, "device") ? dem_dict_text(scene, "device", &s->device) : DEM_OK);
    DEM_REQUIRE(s->device[0], DEM_ERROR_INPUT,
                "%s: device is empty; give cpu, gpu, or a part of a name of dem run -device list",
                dem_dict_where(scene));
    return DEM_OK;
}

int dem_scene_read(struct dem_scene *s, const struct dem_dict *scene,
                   struct dem_interaction_table *r, struct dem_walls *w, struct dem_domain *d)
{
    const struct dem_dict *insert, *outlets, *planes, *start;

    DEM_TRY(dem_scene_read_interactions(scene, r));
    DEM_TRY(read_parcels(r, scene));
    DEM_TRY(dem_interaction_table_add_fluid_scalars(r, dem_dict_where(scene)));
    DEM_TRY(dem_scene_read_walls(scene, r, w));
    DEM_TRY(dem_scene_read_stages(&s->stages, scene, w));
    DEM_TRY(read_domain(d, &s->cell, scene));
    DEM_TRY(dem_scene_read_fluid(&s->fluid, scene, r));
    DEM_TRY(read_time(s, scene));
    DEM_TRY(read_neighbours(s, scene));
    DEM_TRY(read_device(s, scene));
    DEM_TRY(dem_averages_io_read(scene, &s->average, &s->averages));
    DEM_TRY(read_bonds(s, scene, r));
    DEM_TRY(dem_dict_sub_if(scene, "start", &start));
    if (start)
    {
        DEM_TRY(dem_dict_text(start, "snapshot", &s->snapshot));
        DEM_TRY(dem_scalar_entries_read(start, r, 0, s->start_scalar));
        DEM_TRY(read_frozen(s, start, r));
    }
    DEM_TRY(dem_clump_shapes_read(&s->shapes, scene));
    DEM_TRY(dem_dict_sub_if(scene, "insert", &insert));
    DEM_TRY(dem_dict_sub_if(scene, "outlets", &outlets));
    s->streams.shapes = &s->shapes;
    DEM_TRY(dem_dict_sub_if(scene, "planes", &planes));
    DEM_TRY(dem_streams_read(&s->streams, insert, outlets, r, d));
    for (int k = 0; k < w->walls; k++)
    {
        if (w->wall[k].absorbs)
        {
            DEM_TRY(dem_streams_add_wall(&s->streams, w->wall[k].absorbs, &w->wall[k].outlet));
        }
    }
    DEM_TRY(dem_streams_read_planes(&s->streams, planes));
    DEM_REQUIRE(!r->motionless || s->streams.streams == 0, DEM_ERROR_INPUT,
                "%s: start freezes all particles, but insert/%s lets others move; leave out one of "
                "the two", dem_dict_where(start), s->streams.stream[0].name);
    s->insertion.domain = d;
    s->insertion.shapes = &s->shapes;
    DEM_TRY(insert ? dem_insert_read(&s->insertion, insert, r, w) : DEM_OK);
    DEM_REQUIRE(!start || s->insertion.n == 0, DEM_ERROR_INPUT,
                "%s: the scene has both start and insert; keep one, or keep in insert only entries "
                "of type stream",
                dem_dict_where(start));
    return DEM_OK;
}

void dem_scene_free(struct dem_scene *s)
{
    dem_memory_free(s->average);
    dem_memory_free(s->stages.stage);
    dem_insert_free(&s->insertion);
    dem_clump_shapes_free(&s->shapes);
    dem_streams_free(&s->streams);
    dem_initial_particles_free(&s->initial);
}
