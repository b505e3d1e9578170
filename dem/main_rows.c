/*
 * main_rows.c -- heads, and the rows up to the start written anew.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_rows.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/file.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The number in a column of one line; infinite when there is none. */
static double number(const char *line, int column)
{
    for (; column > 0 && line; column--)
    {
        line = strchr(line, ',');
        line = line ? line + 1 : NULL;
    }
    return line ? strtod(line, NULL) : 1e300;
}

static int keep(const char *path, char *text, int column, double until, const char *heading)
{
    const char *said = "# ";
    struct dem_file f;
    int head = 1;

    DEM_TRY(dem_file_begin(&f, path));
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1)
    {
        *end = 0;
        said = line[0] == '#' ? line : said;
        if (head || line[0] == '#' || number(line, column) <= until)
        {
            fprintf(f.stream, "%s\n", line);
        }
        head = head && line[0] == '#';
    }
    if (strcmp(said + 2, heading) != 0)
    {
        fprintf(f.stream, "# %s\n", heading);
    }
    return dem_file_finish(&f, DEM_OK);
}

int dem_rows_begin(const char *path, int column, double start, const struct dem *d)
{
    char *text;
    size_t n;

    if (!dem_file_exists(path))
    {
        return DEM_OK;
    }
    if (start > 0.0)
    {
        DEM_TRY(dem_file_load(path, &text, &n));
        const int status = keep(path, text, column, start*(1.0 + 1e-9), dem_heading(d));   /* times are written with 10 digits */

        dem_memory_free(text);
        return status;
    }
    DEM_REQUIRE(remove(path) == 0, DEM_ERROR_FILE, "can't remove %s of an earlier run: %s", path, strerror(errno));
    return DEM_OK;
}

int dem_rows_open(FILE **f, const char *path, const struct dem *d, const char *columns)
{
    const int new = !dem_file_exists(path);

    *f = fopen(path, "a");
    DEM_REQUIRE(*f, DEM_ERROR_FILE, "can't write %s: %s", path, strerror(errno));
    if (new)
    {
        fprintf(*f, "# %s\n%s\n", dem_heading(d), columns);
    }
    return DEM_OK;
}

int dem_rows_close(FILE *f, const char *path)
{
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE, "can't write all of %s: %s", path, strerror(errno));
    return DEM_OK;
}

double dem_rows_due(double interval, double now, double next)
{
    const double due = interval > 0.0 ? (floor(now/interval + 1e-6) + 1.0)*interval : next;

    return due < next*(1.0 - 1e-12) ? due : next;
}

int dem_rows_are_due(double interval, double now)
{
    const double number = interval > 0.0 ? now/interval : 0.5;

    return fabs(number - floor(number + 0.5)) <= 1e-6;
}
