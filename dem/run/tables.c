/*
 * tables.c -- tables that grow by rows; at a restart, remove the rows after its time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_tables.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"
#include <errno.h>
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

/* Write the names of the columns and the rows up to a time. */
static int rewrite(const char *path, char *text, int column, double until)
{
    struct dem_file f;

    DEM_TRY(dem_file_begin(&f, path));
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1)
    {
        *end = 0;
        if (line == text || number(line, column) <= until)
        {
            fprintf(f.stream, "%s\n", line);
        }
    }
    return dem_file_finish(&f, DEM_OK);
}

void dem_table_name(struct dem_table *t, const char *folder, const char *file, double start)
{
    snprintf(t->folder, sizeof t->folder, "%s", folder);
    const int n = snprintf(t->path, sizeof t->path, "%s/%s", folder, file);

    t->start = start;
    if (strlen(folder) >= sizeof t->folder || n >= (int)sizeof t->path)
    {
        t->path[0] = '\0';
    }
}

static int require_path(const struct dem_table *t)
{
    DEM_REQUIRE(t->path[0], DEM_ERROR_INPUT, "the path of a table is longer than %zu characters: "
                "%.40s...; use a folder with a shorter path", sizeof t->folder - 1, t->folder);
    return DEM_OK;
}

int dem_table_begin(const struct dem_table *t, const struct dem *d, int time_column)
{
    char *text;
    size_t n;

    DEM_TRY(require_path(t));
    if (!dem_file_exists(t->path))
    {
        return DEM_OK;
    }
    if (t->start > 0.0 && time_column >= 0)
    {
        DEM_TRY(dem_file_load(t->path, &text, &n));
        /* times are written with 10 digits */
        const int status = rewrite(t->path, text, time_column, t->start*(1.0 + 1e-9));

        dem_memory_free(text);
        return status ? status : dem_effects_record(d, t->folder, t->start);
    }
    DEM_REQUIRE(remove(t->path) == 0, DEM_ERROR_FILE, "cannot remove %s of an earlier run: %s",
                t->path, strerror(errno));
    return DEM_OK;
}

int dem_table_append(const struct dem_table *t, const struct dem *d, const char *columns,
                     const char *rows)
{
    DEM_TRY(require_path(t));
    const int new = !dem_file_exists(t->path);

    if (new)
    {
        DEM_TRY(dem_file_make_folder(t->folder));
        DEM_TRY(dem_effects_record(d, t->folder, t->start));
    }
    FILE *const f = fopen(t->path, "a");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "cannot write %s: %s", t->path, strerror(errno));
    if (new)
    {
        fprintf(f, "%s\n", columns);
    }
    fputs(rows, f);
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE,
                "cannot write all of %s: %s; free disk space, or correct the permissions of its "
                "folder",
                t->path, strerror(errno));
    return DEM_OK;
}
