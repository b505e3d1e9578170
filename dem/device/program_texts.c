/*
 * program_texts.c -- put texts of the core into the program of a device.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/program_texts.h"
#include "core/error.h"
#include <string.h>

const struct dem_device_text *dem_program_find_text(const char *name, size_t length)
{
    for (const struct dem_device_text *t = dem_device_texts; t->name; t++)
    {
        const size_t n = strlen(t->name);

        if (n >= length && memcmp(t->name + n - length, name, length) == 0)
        {
            return t;
        }
    }
    return NULL;
}

static int is_new(struct dem_program_texts *p, const struct dem_device_text *t)
{
    for (int k = 0; k < p->n; k++)
    {
        if (p->included[k] == t)
        {
            return 0;
        }
    }
    if (p->n < DEM_PROGRAM_TEXTS && !strstr(t->name, ".cl"))
    {
        p->included[p->n++] = t;
    }
    return 1;
}

/* Append a line of a text. #pragma once and #include are left out; *name: what it includes. */
static void add_line(struct dem_program_texts *p, const char *line, size_t length, const char **name,
                     size_t *name_length)
{
    static const char begin[] = "#include ", once[] = "#pragma once";
    const char *const end = line + length;

    *name = NULL;
    if (length == sizeof once - 1 && memcmp(line, once, length) == 0)
    {
        return;
    }
    if (length <= sizeof begin || memcmp(line, begin, sizeof begin - 1) != 0)
    {
        dem_text_add(p->out, "%.*s\n", (int)length, line);
        return;
    }
    if (line[sizeof begin - 1] == '"')
    {
        *name = line + sizeof begin;
        *name_length = (size_t)((const char *)memchr(*name, '"', (size_t)(end - *name)) - *name);
    }
}

int dem_program_include(struct dem_program_texts *p, const struct dem_device_text *first)
{
    enum { DEPTH = 16 };

    const char *at[DEPTH];
    int depth = 0;

    at[0] = first && is_new(p, first) ? first->text : "";
    while (depth >= 0)
    {
        const char *const line = at[depth];
        const size_t length = strcspn(line, "\n");
        const char *name;
        size_t name_length = 0;

        if (!*line)
        {
            depth--;
            continue;
        }
        at[depth] = line + length + (line[length] == '\n');
        add_line(p, line, length, &name, &name_length);
        const struct dem_device_text *const t = name ? dem_program_find_text(name, name_length) : NULL;

        if (t && is_new(p, t))
        {
            DEM_REQUIRE(depth + 1 < DEPTH, DEM_ERROR_STATE, "%s is included in a circle", t->name);
            at[++depth] = t->text;
        }
    }
    return p->out->status;
}

int dem_program_include_name(struct dem_program_texts *p, const char *name)
{
    return dem_program_include(p, dem_program_find_text(name, strlen(name)));
}
