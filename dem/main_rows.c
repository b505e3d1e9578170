/*
 * main_rows.c -- the head and the rows up to the start are written anew.
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

static int keep(const char *path, char *text, int column, double until)
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

int dem_rows_begin(const char *path, int column, double start)
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
        const int status = keep(path, text, column, start*(1.0 + 1e-9));   /* times are written with 10 digits */

        dem_memory_free(text);
        return status;
    }
    DEM_REQUIRE(remove(path) == 0, DEM_ERROR_FILE, "can't remove %s of an earlier run: %s", path, strerror(errno));
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
