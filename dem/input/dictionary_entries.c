/*
 * dictionary_entries.c -- iterate over a dictionary, give its path and location, refuse unread
 * entries.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary.h"

#include "core/error.h"
#include "core/did_you_mean.h"
#include "input/dictionary_tree.h"

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

/* The message of dem_did_you_mean_error, `unknown entry "x"`, with the path of the dictionary
   inserted before the known words. */
static int refuse_entry(const struct dem_entry *e)
{
    const struct dem_dict_known_names *q = e->parent->known_names;
    const char *path = dem_dict_path(e->parent), *known = "";
    char head[128];
    const int n = snprintf(head, sizeof head, "unknown entry \"%s\"", e->name);

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
