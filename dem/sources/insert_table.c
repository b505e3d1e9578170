/*
 * insert_table.c -- read the particles of a group from the rows of a text file.
 *
 *     bed { type table; file "bed.csv"; }
 *
 *     id, x, y, z, diameter
 *     0, 1.5e-3, 2e-3, 1e-3, 1e-3
 *
 * The first row names the columns, in any order: x, y, z, and optionally diameter, vx, vy, vz, wx,
 * wy, wz, id, and the names of particle scalars; its form: input/text_table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/error.h"
#include "core/memory.h"
#include "input/text_table.h"
#include <string.h>

enum
{
    DIAMETER = 9, ID,     /* after three vectors: position, velocity, spin */
    SCALAR                /* from here on particle scalars */
};

_Static_assert(SCALAR + DEM_SCALARS <= DEM_TEXT_TABLE_COLUMNS, "a table may have all of them");

static const char *const fixed_name[SCALAR] = {"x", "y", "z", "vx", "vy", "vz",
                                               "wx", "wy", "wz", "diameter", "id"};

struct table
{
    size_t n, capacity[5 + DEM_SCALARS];
    double (*vector[3])[3], *diameter, *scalar[DEM_SCALARS];
    int64_t *id;
};

static int check_names(const struct dem_text_table *t)
{
    for (int k = 0; k < 3; k++)
    {
        const int *const v = &t->present[3*k], found = v[0] + v[1] + v[2];

        DEM_REQUIRE(found == 3 || (found == 0 && k > 0), DEM_ERROR_INPUT, "%s, line %d: columns "
                    "%s, %s, %s are not all there; the first row names the columns, x, y and z "
                    "among them", t->file, t->line, t->name[3*k], t->name[3*k + 1], t->name[3*k + 2]);
    }
    return DEM_OK;
}

static int grow(struct table *t, const int *present, int names)
{
    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(present[3*k] ? DEM_GROW(t->vector[k], t->capacity[k], t->n + 1) : DEM_OK);
    }
    DEM_TRY(present[DIAMETER] ? DEM_GROW(t->diameter, t->capacity[3], t->n + 1) : DEM_OK);
    for (int k = SCALAR; k < names; k++)
    {
        DEM_TRY(present[k]
                    ? DEM_GROW(t->scalar[k - SCALAR], t->capacity[5 + k - SCALAR], t->n + 1)
                    : DEM_OK);
    }
    return present[ID] ? DEM_GROW(t->id, t->capacity[4], t->n + 1) : DEM_OK;
}

static int take_row(struct dem_text_table *from, const double *number)
{
    struct table *const t = from->data;
    const int *const present = from->present;

    DEM_TRY(grow(t, present, from->names));
    for (int k = 0; k < 3; k++)
    {
        if (present[3*k])
        {
            memcpy(t->vector[k][t->n], number + 3*k, sizeof *t->vector[k]);
        }
    }
    if (present[DIAMETER])
    {
        t->diameter[t->n] = number[DIAMETER];
    }
    if (present[ID])
    {
        t->id[t->n] = from->integer;
    }
    for (int k = SCALAR; k < from->names; k++)
    {
        if (present[k])
        {
            t->scalar[k - SCALAR][t->n] = number[k];
        }
    }
    t->n++;
    return DEM_OK;
}

/* Limits of the scalars in the table. */
static int check_scalars(const struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->scalars; k++)
    {
        for (int64_t m = 0; b->scalars[k] && m < b->count; m++)
        {
            DEM_TRY(dem_scalar_require(r, k, b->scalars[k][m], b->where));
        }
    }
    return DEM_OK;
}

int dem_insert_group_read_table(struct dem_insert_group *b, const struct dem_interaction_table *r)
{
    struct table t = {.n = 0};
    struct dem_text_table from = {.names = SCALAR + r->scalars, .whole = ID, .check = check_names,
                                  .take = take_row, .data = &t};

    memcpy(from.name, fixed_name, sizeof fixed_name);
    for (int k = 0; k < r->scalars; k++)
    {
        from.name[SCALAR + k] = r->scalar[k]->name;
    }
    DEM_TRY(dem_dict_text(b->dict, "file", &from.file));
    const int status = dem_error_prefix(dem_text_table_read(&from), "%s: ", b->where);

    memcpy(b->table, (void *[]){t.vector[0], t.vector[1], t.vector[2], t.diameter, t.id},
           5*sizeof *b->table);
    for (int k = 0; k < r->scalars; k++)
    {
        b->table[5 + k] = t.scalar[k];
        b->scalars[k] = t.scalar[k];
    }
    b->positions = (const double (*)[3])t.vector[0];
    b->velocities = (const double (*)[3])t.vector[1];
    b->spins = (const double (*)[3])t.vector[2];
    b->diameters = t.diameter;
    b->ids = t.id;
    b->count = (int64_t)t.n;
    for (int64_t m = 0; m < b->count && t.diameter && !status; m++)
    {
        DEM_REQUIRE(t.diameter[m] > 0.0, DEM_ERROR_INPUT,
                    "%s: %s: number %lld of its diameters is %g m; give numbers above 0", b->where,
                    from.file, (long long)m + 1, t.diameter[m]);
    }
    if (!status)
    {
        DEM_REQUIRE(t.n > 0, DEM_ERROR_INPUT, "%s: %s has no row of numbers; the first row names the columns, "
                    "then follows one for each particle", b->where, from.file);
    }
    return status ? status : check_scalars(b, r);
}
