/*
 * insert_table.c -- read the particles of a group from the rows of a text file.
 *
 *     bed { type table; file "bed.csv"; }
 *
 *     id, x, y, z, diameter
 *     0, 1.5e-3, 2e-3, 1e-3, 1e-3
 *
 * The first row names the columns, in any order: x, y, z, and optionally diameter, vx, vy, vz, wx,
 * wy, wz, id, and the names of particle scalars. Columns are separated by a comma, a semicolon or
 * blanks; empty rows and rows that begin with # are skipped. A unit may follow a name, as in x[m];
 * it is not read: units are SI.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/insert_group.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/did_you_mean.h"
#include "core/file.h"
#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    DIAMETER = 9, ID,     /* after three vectors: position, velocity, spin */
    SCALAR,               /* from here on particle scalars */
    COLUMNS = SCALAR + DEM_SCALARS
};

static const char *const fixed_name[SCALAR] = {"x", "y", "z", "vx", "vy", "vz",
                                               "wx", "wy", "wz", "diameter", "id"};

struct table
{
    const char *file, *name[COLUMNS];
    int line, columns, what[COLUMNS], present[COLUMNS];  /* the quantity in each column; 1 when
                                                            there is a column of it */
    int known;                                           /* number of names */
    size_t n, capacity[5 + DEM_SCALARS];
    double (*vector[3])[3], *diameter, *scalar[DEM_SCALARS];
    int64_t *id;
};

static const char *skip(const char *at)
{
    at += strspn(at, " \t\r");
    at += *at == ',' || *at == ';';
    return at + strspn(at, " \t\r");
}

static int read_name(struct table *t, const char *at, size_t length)
{
    char word[32];
    int k = 0;

    snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : sizeof word - 1), at);
    word[strcspn(word, "[")] = '\0';
    while (k < t->known && strcmp(word, t->name[k]) != 0)
    {
        k++;
    }
    if (k == t->known)
    {
        return dem_error_prefix(dem_did_you_mean_error("column", word, t->name, t->known),
                                "%s, line %d: ", t->file, t->line);
    }
    DEM_REQUIRE(!t->present[k], DEM_ERROR_INPUT, "%s, line %d: column %s comes twice; remove one",
                t->file, t->line, word);
    t->present[k] = 1;
    t->what[t->columns++] = k;
    return DEM_OK;
}

static int read_names(struct table *t, const char *line)
{
    for (const char *at = skip(line); *at; at = skip(at))
    {
        const size_t length = strcspn(at, " \t\r,;");

        DEM_TRY(read_name(t, at, length));
        at += length;
    }
    for (int k = 0; k < 3; k++)
    {
        const int *const v = &t->present[3*k], found = v[0] + v[1] + v[2];

        DEM_REQUIRE(found == 3 || (found == 0 && k > 0), DEM_ERROR_INPUT, "%s, line %d: columns "
                    "%s, %s, %s are not all there; the first row names the columns, x, y and z "
                    "among them", t->file, t->line, t->name[3*k], t->name[3*k + 1], t->name[3*k + 2]);
    }
    return DEM_OK;
}

static int grow(struct table *t)
{
    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(t->present[3*k] ? DEM_GROW(t->vector[k], t->capacity[k], t->n + 1) : DEM_OK);
    }
    DEM_TRY(t->present[DIAMETER] ? DEM_GROW(t->diameter, t->capacity[3], t->n + 1) : DEM_OK);
    for (int k = SCALAR; k < t->known; k++)
    {
        DEM_TRY(t->present[k]
                    ? DEM_GROW(t->scalar[k - SCALAR], t->capacity[5 + k - SCALAR], t->n + 1)
                    : DEM_OK);
    }
    return t->present[ID] ? DEM_GROW(t->id, t->capacity[4], t->n + 1) : DEM_OK;
}

static int read_row(struct table *t, const char *line)
{
    const char *at = skip(line);
    int good = 1;

    DEM_TRY(grow(t));
    for (int c = 0; c < t->columns && good; c++, at = skip(at))
    {
        const int k = t->what[c];
        char *end;

        errno = 0;
        if (k == ID)
        {
            t->id[t->n] = strtoll(at, &end, 10);
            good = end > at && errno == 0;
        }
        else
        {
            double *const to = k == DIAMETER  ? &t->diameter[t->n]
                             : k >= SCALAR    ? &t->scalar[k - SCALAR][t->n]
                                              : &t->vector[k/3][t->n][k%3];

            *to = strtod(at, &end);
            good = end > at && isfinite(*to);
        }
        at = end;
        good = good && (!*at || strchr(" \t\r,;", *at));
    }
    DEM_REQUIRE(good && !*at, DEM_ERROR_INPUT, "%s, line %d: \"%.40s\" is not a row of %d numbers, "
                "one for each column", t->file, t->line, line,
                t->columns);
    t->n++;
    return DEM_OK;
}

static int read_lines(struct table *t, char *text)
{
    for (char *next; text; text = next)
    {
        next = strchr(text, '\n');
        if (next)
        {
            *next++ = '\0';
        }
        t->line++;
        const char first = text[strspn(text, " \t\r")];

        if (first && first != '#')
        {
            DEM_TRY(t->columns == 0 ? read_names(t, text) : read_row(t, text));
        }
    }
    DEM_REQUIRE(t->n > 0, DEM_ERROR_INPUT, "%s has no row of numbers; the first row names the "
                "columns, then follows one for each particle", t->file);
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
    struct table t = {.known = SCALAR + r->scalars};
    char *text;
    fenv_t traps;

    memcpy(t.name, fixed_name, sizeof fixed_name);
    for (int k = 0; k < r->scalars; k++)
    {
        t.name[SCALAR + k] = r->scalar[k]->name;
    }

    DEM_TRY(dem_dict_text(b->dict, "file", &t.file));
    DEM_TRY(dem_error_prefix(dem_file_load_text(t.file, &text), "%s: ", b->where));
    feholdexcept(&traps);    /* a number that overflows ends in a message, not in a signal */
    const int status = dem_error_prefix(read_lines(&t, text), "%s: ", b->where);

    fesetenv(&traps);
    dem_memory_free(text);
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
                    t.file, (long long)m + 1, t.diameter[m]);
    }
    return status ? status : check_scalars(b, r);
}
