/*
 * csv_rows.c -- head lines of CSV tables; at a restart, remove the rows after its time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/csv_rows.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"
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

/* Write the head and the rows up to a time; then the heading, where the last comment of the file
   is another one. */
static int rewrite(const char *path, char *text, int column, double until, const char *heading)
{
    const char *comment = "# ";
    struct dem_file f;
    int head = 1;

    DEM_TRY(dem_file_begin(&f, path));
    for (char *line = text, *end; (end = strchr(line, '\n')); line = end + 1)
    {
        *end = 0;
        comment = line[0] == '#' ? line : comment;
        if (head || line[0] == '#' || number(line, column) <= until)
        {
            fprintf(f.stream, "%s\n", line);
        }
        head = head && line[0] == '#';
    }
    if (strcmp(comment + 2, heading) != 0)
    {
        fprintf(f.stream, "# %s\n", heading);
    }
    return dem_file_finish(&f, DEM_OK);
}

int dem_csv_begin(const char *path, int column, double start, const struct dem *d)
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
        /* times are written with 10 digits */
        const int status = rewrite(path, text, column, start*(1.0 + 1e-9), dem_heading(d));

        dem_memory_free(text);
        return status;
    }
    DEM_REQUIRE(remove(path) == 0, DEM_ERROR_FILE, "cannot remove %s of an earlier run: %s", path,
                strerror(errno));
    return DEM_OK;
}

int dem_csv_open(FILE **f, const char *path, const struct dem *d, const char *columns)
{
    const int new = !dem_file_exists(path);

    *f = fopen(path, "a");
    DEM_REQUIRE(*f, DEM_ERROR_FILE, "cannot write %s: %s", path, strerror(errno));
    if (new)
    {
        fprintf(*f, "# %s\n%s\n", dem_heading(d), columns);
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
