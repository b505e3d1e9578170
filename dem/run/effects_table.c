/*
 * effects_table.c -- write effects.csv anew with one more row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "run/effects_table.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory.h"
#include "core/text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char head[] = "time[s],effects";

/* Append a row, unless the row above has the same effects. `last` points to these. */
static void add_row(struct dem_text *t, const char **last, double time, const char *effects)
{
    if (!*last || strcmp(*last, effects) != 0)
    {
        dem_text_add(t, "%.10g,%s\n", time, effects);
    }
    *last = effects;
}

/* The old rows before `time`, then the new one. */
static void merge(struct dem_text *t, char *old, double time, const char *effects)
{
    /* times are written with 10 digits */
    const double end = time - 1e-9*fabs(time);
    const char *last = NULL;

    dem_text_add(t, "%s\n", head);
    for (char *line = old, *next; line && *line; line = next)
    {
        next = strchr(line, '\n');
        if (next)
        {
            *next++ = '\0';
        }
        char *const names = strchr(line, ',');

        if (strcmp(line, head) != 0 && names && strtod(line, NULL) < end)
        {
            add_row(t, &last, strtod(line, NULL), names + 1);
        }
    }
    add_row(t, &last, time, effects);
}

static int write_anew(const char *path, const struct dem_text *t)
{
    struct dem_file f;

    DEM_TRY(dem_file_begin(&f, path));
    fputs(t->text, f.stream);
    return dem_file_finish(&f, DEM_OK);
}

int dem_effects_table_begin(const char *folder, double time, const char *effects)
{
    struct dem_text path = {0}, t = {0};
    char *old = NULL;

    dem_text_add(&path, "%s/effects.csv", folder);
    int status = path.status;

    if (!status && dem_file_exists(path.text))
    {
        status = dem_file_load_text(path.text, &old);
    }
    if (!status)
    {
        merge(&t, old, time, effects);
        status = t.status ? t.status : write_anew(path.text, &t);
    }
    dem_memory_free(old);
    dem_text_free(&t);
    dem_text_free(&path);
    return status;
}
