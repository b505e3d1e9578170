/*
 * vtk_collection.c -- a .pvd file: the list of .vtp files with their times, rewritten with each
 * entry.
 *
 * Existing entries are copied unchanged, so a collection edited by hand keeps its attributes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/vtk.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"

#include <fenv.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* A part of an XML text. */
struct span
{
    const char *at, *end;
};

static bool is_text(struct span s, const char *text)
{
    return strlen(text) == (size_t)(s.end - s.at) && memcmp(text, s.at, strlen(text)) == 0;
}

/* The value of an attribute inside a tag. */
static bool attribute(struct span tag, const char *name, struct span *value)
{
    const size_t n = strlen(name);

    for (const char *c = tag.at; c + n + 3 < tag.end; c++)
    {
        if (*c == ' ' && strncmp(c + 1, name, n) == 0 && c[n + 1] == '=' && c[n + 2] == '"')
        {
            value->at = c + n + 3;
            value->end = memchr(value->at, '"', (size_t)(tag.end - value->at));
            return value->end != NULL;
        }
    }
    return false;
}

/* strtod that does not trap on overflow. */
static bool time_of(struct span value, double *time)
{
    char *end;
    fenv_t traps;

    feholdexcept(&traps);
    *time = strtod(value.at, &end);
    fesetenv(&traps);
    return end == value.end && end > value.at && isfinite(*time);
}

/* The shortest decimal that reads back as this time. */
static void put_time(FILE *f, double time)
{
    char text[32];

    for (int digits = 15; digits <= 17; digits++)
    {
        snprintf(text, sizeof text, "%.*g", digits, time);
        if (strtod(text, NULL) == time)
        {
            break;
        }
    }
    fputs(text, f);
}

/* Copy the entries before this time, without this file's. */
static int copy_entries(FILE *f, const char *path, const char *old, double time, const char *file)
{
    DEM_REQUIRE(
        strstr(old, "<Collection"), DEM_ERROR_FILE,
        "%s is not a collection of VTK files; move it away or give the collection another name",
        path);
    for (const char *c = strstr(old, "<DataSet"); c; c = strstr(c + 1, "<DataSet"))
    {
        const struct span tag = {c, strchr(c, '>')};
        struct span timestep, name;
        double old_time;

        DEM_REQUIRE(
            tag.end && attribute(tag, "timestep", &timestep) && attribute(tag, "file", &name) &&
                time_of(timestep, &old_time),
            DEM_ERROR_FILE,
            "%s has an entry without a timestep or a file; correct it or move the collection away",
            path);
        if (old_time < time && !is_text(name, file))
        {
            fprintf(f, "    %.*s\n", (int)(tag.end + 1 - tag.at), tag.at);
        }
    }
    return DEM_OK;
}

static int write_collection(FILE *f, const char *path, const char *old, double time,
                            const char *file)
{
    fputs(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n  <Collection>\n",
        f);
    if (old)
    {
        DEM_TRY(copy_entries(f, path, old, time, file));
    }
    fputs("    <DataSet timestep=\"", f);
    put_time(f, time);
    fputs("\" file=\"", f);
    fputs(file, f);
    fputs("\"/>\n  </Collection>\n</VTKFile>\n", f);
    return DEM_OK;
}

int dem_vtk_collection_add(const char *path, double time, const char *file)
{
    struct dem_file f;
    char *old = NULL;
    size_t n;
    int status;

    DEM_REQUIRE(isfinite(time), DEM_ERROR_STATE, "%s: the time of %s is not a finite number", path,
                file);
    DEM_TRY(dem_file_exists(path) ? dem_file_load(path, &old, &n) : DEM_OK);
    status = dem_file_begin(&f, path);
    if (status == DEM_OK)
    {
        status = dem_file_finish(&f, write_collection(f.stream, path, old, time, file));
    }
    dem_memory_free(old);
    return status;
}
