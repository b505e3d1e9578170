/*
 * dictionary_entries.c -- iterate over a dictionary, refuse unread entries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary.h"

#include "core/error.h"
#include "core/did_you_mean.h"
#include "input/dictionary_tree.h"

#include <stdio.h>
#include <string.h>

size_t dem_dict_count(const struct dem_dict *d)
{
    return d->count;
}

const struct dem_entry *dem_dict_entry(const struct dem_dict *d, size_t i)
{
    return i < d->count ? d->entries[i] : NULL;
}

const char *dem_entry_name(const struct dem_entry *e)
{
    return e->name;
}

bool dem_entry_is_dict(const struct dem_entry *e)
{
    return e->dict != NULL;
}

/* The entry is looked up in its dictionary, so that marking it needs no write through a const
   pointer. */
static void mark(const struct dem_entry *e)
{
    struct dem_entry *own = dem_dict_find(e->parent, e->name, strlen(e->name));

    if (own)
    {
        own->used = true;
    }
}

const struct dem_dict *dem_entry_dict(const struct dem_entry *e)
{
    if (e->dict)
    {
        mark(e);
    }
    return e->dict;
}

size_t dem_entry_tokens(const struct dem_entry *e)
{
    return e->count;
}

const char *dem_entry_token(const struct dem_entry *e, size_t i)
{
    mark(e);
    return i < e->count ? e->tokens[i].text : NULL;
}

int dem_dict_each(const struct dem_dict *d, const char *name,
                  int (*read)(void *, const struct dem_dict *), void *context)
{
    const struct dem_dict *list;

    DEM_TRY(dem_dict_sub_if(d, name, &list));
    for (size_t k = 0; list && k < dem_dict_count(list); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(list, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: %s holds dictionaries; write %s { ... }", dem_entry_where(e), name,
                    dem_entry_name(e));
        DEM_TRY(read(context, dem_entry_dict(e)));
    }
    return DEM_OK;
}

int dem_dict_each_item(const struct dem_dict *d, const char *name,
                       int (*read)(void *, const struct dem_dict *), void *context)
{
    const struct dem_entry *const e = dem_dict_find(d, name, strlen(name));

    dem_dict_add_known_name(d, name);
    if (!e || e->dict)
    {
        return e ? read(context, dem_entry_dict(e)) : DEM_OK;
    }
    mark(e);
    DEM_REQUIRE(e->items > 0 && e->count == e->items + 2, DEM_ERROR_INPUT,
                "%s: %s is a dictionary, or a list of some; write %s { ... } or %s ( { ... } "
                "{ ... } )", dem_entry_where(e), name, name, name);
    for (size_t k = 1; k + 1 < e->count; k++)
    {
        DEM_TRY(read(context, e->tokens[k].dict));
    }
    return DEM_OK;
}

const struct dem_dict *dem_entry_item(const struct dem_entry *e, size_t k)
{
    mark(e);
    return k < e->items && e->count == e->items + 2 ? e->tokens[k + 1].dict : NULL;
}

bool dem_dict_remove(struct dem_dict *d, const char *within, bool deep, const char *name)
{
    const struct dem_entry *const e = dem_dict_find(d, within, strlen(within));
    bool found = false;

    if (!e || !e->dict)
    {
        return false;
    }
    for (size_t i = 0; i < e->dict->count && deep; i++)
    {
        found =
            (e->dict->entries[i]->dict && dem_dict_remove_entry(e->dict->entries[i]->dict, name))
            || found;
    }
    return deep ? found : dem_dict_remove_entry(e->dict, name);
}

bool dem_dict_unset(struct dem_dict *d, const char *path)
{
    const char *const slash = strchr(path, '/');

    if (!slash)
    {
        return dem_dict_remove_entry(d, path);
    }
    const struct dem_entry *const e = dem_dict_find(d, path, (size_t)(slash - path));

    return e && e->dict && dem_dict_unset(e->dict, slash + 1);
}

/* The message of dem_did_you_mean_error, `unknown entry "x"`, with the path of the dictionary
   inserted before the known words. */
static int refuse_entry(const struct dem_entry *e)
{
    const struct dem_dict_known_names *q = e->parent->known_names;
    const char *path = dem_dict_path(e->parent), *known = "";
    char head[128];
    const int n = snprintf(head, sizeof head, "unknown entry \"%s\"", e->name);

    for (size_t k = 0; k < q->count; k++)
    {
        DEM_REQUIRE(strcmp(q->names[k], e->name) != 0, DEM_ERROR_INPUT,
                    "%s: entry \"%s\"%s%s has no effect with the other entries there; remove it", dem_entry_where(e),
                    e->name, *path ? " of " : "", path);
    }
    if (q->count > 0)
    {
        (void)dem_did_you_mean_error("entry", e->name, q->names, (int)q->count);
        known = n > 0 && (size_t)n < sizeof head && strncmp(dem_error_text(), head, (size_t)n) == 0
                    ? dem_error_text() + n
                    : "";
    }
    return dem_error(DEM_ERROR_INPUT, "%s: unknown entry \"%s\"%s%s%s", dem_entry_where(e), e->name,
                     *path ? " in " : "", path, *known ? known : "; remove it");
}

static int refuse_unread_items(const struct dem_entry *e)
{
    for (size_t i = 0; i < e->count; i++)
    {
        if (e->tokens[i].dict)
        {
            DEM_TRY(dem_dict_refuse_unread(e->tokens[i].dict));
        }
    }
    return DEM_OK;
}

int dem_dict_refuse_unread(const struct dem_dict *d)
{
    /* queries return no status */
    DEM_REQUIRE(!d->pool->failed, DEM_ERROR_MEMORY,
                "%s: no memory for the names of entries; use fewer particles or more ranks", d->file);
    for (size_t i = 0; i < d->count; i++)
    {
        const struct dem_entry *e = d->entries[i];

        if (!e->used)
        {
            return refuse_entry(e);
        }
        DEM_TRY(e->dict ? dem_dict_refuse_unread(e->dict) : refuse_unread_items(e));
    }
    return DEM_OK;
}

void dem_dict_mark_read(const struct dem_dict *d)
{
    for (size_t i = 0; i < d->count; i++)
    {
        struct dem_entry *e = d->entries[i];

        e->used = true;
        if (e->dict)
        {
            dem_dict_mark_read(e->dict);
        }
        for (size_t k = 0; k < e->count; k++)
        {
            if (e->tokens[k].dict)
            {
                dem_dict_mark_read(e->tokens[k].dict);
            }
        }
    }
}
