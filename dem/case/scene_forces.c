/*
 * scene_forces.c -- read the entry `forces` of a scene: forces and torques on chosen particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/applied_forces.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    MAX_FORCES = 64
};

struct reader
{
    const struct dem_interaction_table *table;
    struct dem_applied_forces *forces;
};

static int compare(const void *a, const void *b)
{
    const int64_t i = *(const int64_t *)a, j = *(const int64_t *)b;

    return (i > j) - (i < j);
}

static int read_ids(struct dem_applied_force *f, const struct dem_dict *dict)
{
    const int64_t *ids;

    if (!dem_dict_has(dict, "ids"))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_int64s(dict, "ids", &ids, &f->count));
    DEM_REQUIRE(f->count > 0, DEM_ERROR_INPUT,
                "%s: forces/%s/ids is empty; name particles, or leave ids out for all",
                dem_dict_where(dict), dem_dict_name(dict));
    DEM_TRY(DEM_NEW(f->ids, f->count));
    memcpy(f->ids, ids, f->count*sizeof *ids);
    qsort(f->ids, f->count, sizeof *f->ids, compare);
    for (size_t k = 0; k < f->count; k++)
    {
        DEM_REQUIRE(f->ids[k] >= 0 && (k == 0 || f->ids[k] != f->ids[k - 1]), DEM_ERROR_INPUT,
                    "%s: forces/%s/ids: id %lld is negative or there twice; correct the list",
                    dem_dict_where(dict), dem_dict_name(dict), (long long)f->ids[k]);
    }
    return DEM_OK;
}

static int read_conditions(struct dem_applied_force *f, const struct dem_interaction_table *table,
                           const struct dem_dict *dict)
{
    static const double low[3] = {-INFINITY, -INFINITY, -INFINITY},
                        high[3] = {INFINITY, INFINITY, INFINITY};
    const char *material = NULL;

    DEM_TRY(dem_dict_vector_or(dict, "min", "m", low, f->min));
    DEM_TRY(dem_dict_vector_or(dict, "max", "m", high, f->max));
    DEM_TRY(dem_dict_number_or(dict, "start", "s", -INFINITY, &f->start));
    DEM_TRY(dem_dict_number_or(dict, "end", "s", INFINITY, &f->end));
    DEM_REQUIRE(f->min[0] < f->max[0] && f->min[1] < f->max[1] && f->min[2] < f->max[2]
                    && f->start < f->end, DEM_ERROR_INPUT,
                "%s: forces/%s: min must be below max along each axis, and start before end",
                dem_dict_where(dict), dem_dict_name(dict));
    f->material = -1;
    if (dem_dict_has(dict, "material"))
    {
        DEM_TRY(dem_dict_word(dict, "material", &material));
        DEM_TRY(dem_interaction_table_find_material(table, material, dem_dict_where(dict),
                                                    &f->material));
    }
    return read_ids(f, dict);
}

static int read_force(void *of, const struct dem_dict *dict)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    struct reader *const r = of;
    struct dem_applied_forces *const a = r->forces;

    DEM_REQUIRE(a->n < MAX_FORCES, DEM_ERROR_INPUT, "%s: more than %d forces; merge equal ones",
                dem_dict_where(dict), MAX_FORCES);
    struct dem_applied_force *const f = &a->force[a->n++];

    f->name = dem_dict_name(dict);

    DEM_REQUIRE(dem_dict_has(dict, "force") || dem_dict_has(dict, "torque"), DEM_ERROR_INPUT,
                "%s: forces/%s has neither force (N) nor torque (N m); give one of them",
                dem_dict_where(dict), dem_dict_name(dict));
    DEM_TRY(dem_dict_vector_or(dict, "force", "N", zero, f->force));
    DEM_TRY(dem_dict_vector_or(dict, "torque", "N m", zero, f->torque));
    a->torques |= f->torque[0] != 0.0 || f->torque[1] != 0.0 || f->torque[2] != 0.0;
    return read_conditions(f, r->table, dict);
}

int dem_scene_read_forces(const struct dem_dict *scene, const struct dem_interaction_table *table,
                          struct dem_applied_forces *forces)
{
    struct reader r = {table, forces};
    const struct dem_dict *dict;

    DEM_TRY(dem_dict_sub_if(scene, "forces", &dict));
    if (!dict)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(forces->force, MAX_FORCES));
    return dem_dict_each(scene, "forces", read_force, &r);
}
