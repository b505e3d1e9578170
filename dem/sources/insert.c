/*
 * insert.c -- read and check the groups of `insert` before any particle is placed.
 *
 *     bed { type lattice; material glass; diameter 1e-3; count 1000; min (0 0 0);
 *           max (0.01 0.01 0.05); spacing 1.1; jitter 0.5; seed 1; velocity (0 0 0); }
 *
 *   lattice   simple cubic in a box, from the bottom layer up; spacing in diameters,
 *             jitter as a fraction of the gap between neighbors
 *   random    random positions in a box, cylinder or sphere, without overlap with earlier groups
 *             and periodic images (packing.h), sizes from a distribution (size_distribution.h)
 *   list      positions ((x y z) ...), with one diameter or as many, velocities, spins, ids
 *   table     the same from the rows of a file (insert_table.c)
 *
 * The number of particles is read in insert_amount.c; they are placed in insert_place.c. A lattice
 * without count, mass or solidFraction fills its box.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "sources/insert_amount.h"
#include "laws/material_entry.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* ---- all ------------------------------------------------------------------------------------- */

static int refuse_moving(const struct dem_insert_group *b)
{
    for (int64_t m = 0; m < (b->velocities || b->spins ? b->count : 1); m++)
    {
        const double *const v = b->velocities ? b->velocities[m] : b->velocity;
        const double *const w = b->spins ? b->spins[m] : b->spin;
        const double speed = fmax(dem_vec_norm(v), dem_vec_norm(w));

        DEM_REQUIRE(speed == 0.0, DEM_ERROR_INPUT,
                    "%s: a frozen particle never moves, but has a velocity or spin of %g; leave it "
                    "out, or frozen%s",
                    b->where, speed, b->clump.shape ? "" : ", or give driven yes");
    }
    return DEM_OK;
}

/* Mass, moment of inertia and their inverses must be normal numbers. */
static int check_masses(const struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    for (int64_t m = 0; m < (b->diameters ? b->count : 1); m++)
    {
        const double d = b->diameters ? b->diameters[m] : b->diameter;
        const double mass = pi/6.0*d*d*d*r->material[b->material].density;

        DEM_REQUIRE(isnormal(mass*d*d) && isnormal(1.0/(mass*d*d)), DEM_ERROR_INPUT,
                    "%s: diameter %g m of %s, density %g kg/m3, gives a mass of %g kg; correct the "
                    "diameter or the density", b->where, d,
                    r->material[b->material].name, r->material[b->material].density, mass);
    }
    return DEM_OK;
}

/* Diameters of a list or table are for grains; each parcel has its own ratio, or the group's. */
static int enlarge_grains(struct dem_insert_group *b, const double *ratios)
{
    const double grain = b->diameter;

    b->diameter = b->ratio*grain;
    if (b->diameters || ratios)
    {
        DEM_TRY(DEM_NEW(b->drawn, b->count));
    }
    for (int64_t m = 0; b->drawn && m < b->count; m++)
    {
        b->drawn[m] = (ratios ? ratios[m] : b->ratio)*(b->diameters ? b->diameters[m] : grain);
    }
    b->diameters = b->drawn;
    return DEM_OK;
}

/* What a scalar must have that no list or table gives. */
static int check_scalars(const struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->scalars; k++)
    {
        DEM_REQUIRE(b->scalars[k] || !isnan(b->scalar[k].min), DEM_ERROR_INPUT,
                    "%s: no %s, which the effects need; add %s with a number in %s", b->where,
                    r->scalar[k]->name, r->scalar[k]->name, r->scalar[k]->unit);
    }
    return DEM_OK;
}

static int read_group(const struct dem_dict *dict, const struct dem_interaction_table *r,
                      const struct dem_insertion *i, const struct dem_walls *w,
                      struct dem_insert_group *b)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const char *type;

    *b = (struct dem_insert_group){.dict = dict};
    snprintf(b->where, sizeof b->where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_material_entry_read(dict, r, &b->material));
    DEM_TRY(dem_dict_vector_or(dict, "velocity", "m/s", zero, b->velocity));
    DEM_TRY(dem_dict_vector_or(dict, "spin", "1/s", zero, b->spin));
    DEM_TRY(dem_dict_switch_or(dict, "frozen", false, &b->frozen));
    DEM_TRY(dem_dict_switch_or(dict, "driven", false, &b->driven));
    DEM_REQUIRE(!(b->frozen && b->driven), DEM_ERROR_INPUT,
                "%s: frozen particles stay, driven ones keep their velocity; give one of the two",
                b->where);
    DEM_TRY(dem_clump_source_read(&b->clump, dict, i->shapes, i->domain, b->where));
    DEM_REQUIRE(!b->clump.shape || !b->driven, DEM_ERROR_INPUT,
                "%s: clumps are not driven; leave it out, or make a wall of triangles",
                b->where);
    DEM_TRY(dem_scalar_entries_read(dict, r, 0, b->scalar));
    DEM_TRY(dem_scalar_entries_parcel_ratio(r, b->scalar, b->where, &b->ratio));
    DEM_TRY(dem_insert_group_read_type(b, r, i, w, type));
    if (r->parcels.used && (b->type == DEM_INSERT_LIST || b->type == DEM_INSERT_TABLE))
    {
        DEM_TRY(enlarge_grains(b, b->scalars[r->parcels.scalar]));
    }
    DEM_TRY(check_scalars(b, r));
    DEM_TRY(check_masses(b, r));
    return b->frozen ? refuse_moving(b) : DEM_OK;
}

int dem_insert_is_stream(const struct dem_dict *group)
{
    const char *type = "";

    return dem_dict_has(group, "at")
        || (dem_dict_has(group, "type") && dem_dict_word(group, "type", &type) == DEM_OK
            && strcmp(type, "stream") == 0);
}

int dem_insert_read(struct dem_insertion *i, const struct dem_dict *insert,
                    const struct dem_interaction_table *r, const struct dem_walls *w)
{
    int64_t next = 0;

    for (size_t k = 0; k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: insert holds groups like %s { type lattice; ... }", dem_entry_where(e),
                    dem_entry_name(e));
        if (dem_insert_is_stream(dem_entry_dict(e)))
        {
            continue;
        }
        DEM_TRY(DEM_GROW(i->group, i->capacity, i->n + 1));
        struct dem_insert_group *const b = &i->group[i->n++];

        DEM_TRY(read_group(dem_entry_dict(e), r, i, w, b));
        DEM_REQUIRE(b->ids || b->count <= (INT64_MAX - next)/dem_clump_source_ids(&b->clump), DEM_ERROR_INPUT,
                    "%s: %lld more ids from %lld on pass the largest, %lld; "
                    "give smaller ids to the groups before it",
                    b->where, (long long)b->count, (long long)next, (long long)INT64_MAX - 1);
        next = dem_insert_group_next_id(b, next);
    }
    return dem_insert_refuse_duplicates(i, 0, NULL);
}

const char *dem_insert_name(const struct dem_insertion *i, size_t k)
{
    return dem_dict_name(i->group[k].dict);
}

static void free_group(struct dem_insert_group *b)
{
    dem_memory_free(b->drawn);
    dem_memory_free(b->site);
    dem_insertion_limits_free(b->limits);
    for (size_t t = 0; t < sizeof b->table/sizeof *b->table; t++)
    {
        dem_memory_free(b->table[t]);
    }
}

void dem_insert_drop(struct dem_insertion *i, size_t k)
{
    free_group(&i->group[k]);
    memmove(&i->group[k], &i->group[k + 1], (--i->n - k)*sizeof *i->group);
}

void dem_insert_free(struct dem_insertion *i)
{
    for (size_t k = 0; k < i->n; k++)
    {
        free_group(&i->group[k]);
    }
    dem_memory_free(i->group);
    dem_insertion_regions_free(&i->regions);
    memset(i, 0, sizeof *i);
}
