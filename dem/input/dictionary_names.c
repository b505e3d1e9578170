/*
 * dictionary_names.c -- path and location of dictionaries and entries; names that were asked for.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"

#include <stdio.h>
#include <string.h>

void dem_dict_add_known_name(const struct dem_dict *d, const char *name)
{
    struct dem_dict_known_names *q = d->known_names;
    void *names = q->names;

    for (size_t i = 0; i < q->count; i++)
    {
        if (strcmp(q->names[i], name) == 0)
        {
            return;
        }
    }
    /* without memory the name is only missing from the list of known words */
    if (dem_dict_pool_grow(d->pool, &names, &q->capacity, q->count + 1, sizeof *q->names) == DEM_OK)
    {
        q->names = names;
        q->count += dem_dict_pool_copy(d->pool, name, strlen(name), &q->names[q->count]) == DEM_OK;
    }
}

const char *dem_dict_name(const struct dem_dict *d)
{
    return d->name;
}

/* The last part of the path of d: "glass", "walls/floor", or "walls[2]" for an item without a
   name. */
static size_t print_step(const struct dem_dict *d, char *out, size_t size)
{
    const int n = !d->list  ? snprintf(out, size, "%s", d->name)
                  : *d->name ? snprintf(out, size, "%s/%s", d->list, d->name)
                             : snprintf(out, size, "%s[%zu]", d->list, d->item);

    return n > 0 ? (size_t)n : 0;
}

/* The text is filled from its end to its beginning, from d outward. */
const char *dem_dict_path(const struct dem_dict *d)
{
    size_t length = 0;
    char *text;
    void *p;

    for (const struct dem_dict *at = d; at->parent; at = at->parent)
    {
        length += print_step(at, NULL, 0) + (at->parent->parent != NULL);
    }
    if (length == 0 || dem_dict_pool_alloc(d->pool, length + 1, &p) != DEM_OK)
    {
        return "";
    }
    text = p;
    for (const struct dem_dict *at = d; at->parent; at = at->parent)
    {
        const size_t n = print_step(at, NULL, 0);
        const char after = text[length];

        length -= n;
        print_step(at, text + length, n + 1);
        text[length + n] = after;
        if (at->parent->parent)
        {
            text[--length] = '/';
        }
    }
    return text;
}

static const char *location(struct dem_dict_pool *pool, const char *file, int line)
{
    const size_t size = strlen(file) + sizeof ", line -2147483648";
    void *p;

    if (dem_dict_pool_alloc(pool, size, &p) != DEM_OK)
    {
        return file;
    }
    snprintf(p, size, "%s, line %d", file, line);
    return p;
}

const char *dem_dict_where(const struct dem_dict *d)
{
    return d->parent ? location(d->pool, d->file, d->line) : d->file;
}

const char *dem_entry_where(const struct dem_entry *e)
{
    return location(e->parent->pool, e->file, e->line);
}
