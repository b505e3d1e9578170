/*
 * csv_rows.c -- head line of CSV tables; at a restart, remove the rows after its time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/csv_rows.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"
#include "output/effects_table.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The number in a column of a line; 1e300 when there is none. */
static double number(const char *line, int column)
{
    for (; column > 0 && line; column--)
    {
        line = strchr(line, ',');
        line = line ? line + 1 : NULL;
    }
    return line ? strtod(line, NULL) : 1e300;
}

/* A comment with the effects, as the tables of earlier versions have it above their columns and
   where a restart changed them: the names in it, else NULL. */
static const char *effects_in(const char *line)
{
    static const char words[] = "# effects: ";

    return strncmp(line, words, sizeof words - 1) == 0 ? line + sizeof words - 1 : NULL;
}

/* Write the names of the columns and the rows up to a time. Effects in comments go to effects.csv,
   from the row below them on. */
static int rewrite(const char *path, char *text, int column, double until, const char *folder)
{
    const char *effects = NULL;
    struct dem_file f;
    int head = 1, status = DEM_OK;

    DEM_TRY(dem_file_begin(&f, path));
    for (char *line = text, *end; !status && (end = strchr(line, '\n')); line = end + 1)
    {
        *end = 0;
        if (line[0] == '#')
        {
            effects = effects_in(line) ? effects_in(line) : effects;
            continue;
        }
        const double time = head ? until : number(line, column);

        if (head || time <= until)
        {
            fprintf(f.stream, "%s\n", line);
        }
        if (!head && time <= until && effects)
        {
            status = dem_effects_table_add(folder, time, effects);
            effects = NULL;
        }
        head = 0;
    }
    return dem_file_finish(&f, status);
}

int dem_csv_begin(const char *path, int column, const struct dem_output *o, const struct dem *d)
{
    char *text;
    size_t n;

    if (!dem_file_exists(path))
    {
        return DEM_OK;
    }
    if (o->start > 0.0)
    {
        DEM_TRY(dem_file_load(path, &text, &n));
        /* times are written with 10 digits */
        const int status = rewrite(path, text, column, o->start*(1.0 + 1e-9), o->folder);

        dem_memory_free(text);
        return status ? status : dem_effects_record(d, o->folder, o->start);
    }
    DEM_REQUIRE(remove(path) == 0, DEM_ERROR_FILE, "cannot remove %s of an earlier run: %s", path,
                strerror(errno));
    return DEM_OK;
}

int dem_csv_open(FILE **f, const char *path, const struct dem_output *o, const struct dem *d,
                 const char *columns)
{
    const int new = !dem_file_exists(path);

    if (new)
    {
        DEM_TRY(dem_effects_record(d, o->folder, o->start));
    }
    *f = fopen(path, "a");
    DEM_REQUIRE(*f, DEM_ERROR_FILE, "cannot write %s: %s", path, strerror(errno));
    if (new)
    {
        fprintf(*f, "%s\n", columns);
    }
    return DEM_OK;
}

int dem_csv_close(FILE *f, const char *path)
{
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE, "cannot write all of %s: %s", path,
                strerror(errno));
    return DEM_OK;
}

double dem_csv_next_due(double interval, double now, double next)
{
    const double due = interval > 0.0 ? (floor(now/interval + 1e-6) + 1.0)*interval : next;

    return due < next*(1.0 - 1e-12) ? due : next;
}

int dem_csv_is_due(double interval, double now)
{
    const double number = interval > 0.0 ? now/interval : 0.5;

    return fabs(number - floor(number + 0.5)) <= 1e-6;
}
