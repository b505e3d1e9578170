/*
 * dictionary_tree.c -- the tree of a dictionary.
 *
 * Entries keep the order of the text; one table of the tree finds a name in its dictionary, so that
 * reading takes linear time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"
#include "core/memory.h"

#include <stdio.h>
#include <string.h>

enum
{
    MAX_REPEATS = 100     /* sentences on entries given twice */
};

int dem_dict_new_top(struct dem_dict **d, const char *file)
{
    struct dem_dict_pool *pool = NULL;
    void *p;
    int status;

    *d = NULL;
    DEM_TRY(DEM_NEW(pool, 1));
    status = dem_dict_pool_alloc(pool, sizeof **d, &p);
    if (status != DEM_OK)
    {
        dem_memory_free(pool);
        return status;
    }
    *d = p;
    (*d)->pool = pool;
    (*d)->name = "";
    status = dem_dict_pool_copy(pool, file, strlen(file), &(*d)->file);
    if (status == DEM_OK)
    {
        status = dem_dict_pool_alloc(pool, sizeof *(*d)->known_names, &p);
        (*d)->known_names = p;
    }
    if (status != DEM_OK)
    {
        dem_dict_free(*d);
        *d = NULL;
    }
    return status;
}

void dem_dict_free(struct dem_dict *d)
{
    struct dem_dict_pool *pool = d ? d->pool : NULL;

    if (pool)
    {
        dem_dict_pool_free(pool);
    }
}

int dem_dict_new(struct dem_dict *parent, const char *name, const char *file, int line,
                 struct dem_dict **d)
{
    void *p;

    DEM_TRY(dem_dict_pool_alloc(parent->pool, sizeof **d, &p));
    *d = p;
    (*d)->pool = parent->pool;
    (*d)->parent = parent;
    (*d)->name = name;
    (*d)->file = file;
    (*d)->line = line;
    DEM_TRY(dem_dict_pool_alloc(parent->pool, sizeof *(*d)->known_names, &p));
    (*d)->known_names = p;
    return DEM_OK;
}

static uint64_t hash_in(const struct dem_dict *d, const char *name, size_t length)
{
    return dem_name_hash(name, length, (uint64_t)(uintptr_t)d);
}

struct dem_entry *dem_dict_find(const struct dem_dict *d, const char *name, size_t length)
{
    const uint64_t hash = hash_in(d, name, length);
    size_t at = 0, k;

    while (dem_name_index_next(&d->pool->names, hash, &at, &k))
    {
        struct dem_entry *const e = d->pool->entry[k];

        if (e && e->parent == d && strncmp(e->name, name, length) == 0 && e->name[length] == '\0')
        {
            return e;
        }
    }
    return NULL;
}

int dem_dict_new_entry(struct dem_dict *parent, const char *name, const char *file, int line,
                       struct dem_entry **e)
{
    void *p;

    DEM_TRY(dem_dict_pool_alloc(parent->pool, sizeof **e, &p));
    *e = p;
    (*e)->name = name;
    (*e)->file = file;
    (*e)->line = line;
    (*e)->parent = parent;
    (*e)->tokens = (void *)(*e + 1);    /* no token yet, but a valid pointer for adding zero */
    return DEM_OK;
}

int dem_dict_put(struct dem_entry *e)
{
    struct dem_dict *d = e->parent;
    struct dem_dict_pool *const pool = d->pool;
    const struct dem_entry *const old = dem_dict_find(d, e->name, strlen(e->name));
    void *entries = d->entries;

    if (old)
    {
        e->place = old->place;
        e->number = old->number;
        d->entries[e->place] = pool->entry[e->number] = e;
        return DEM_OK;
    }
    DEM_TRY(dem_dict_pool_grow(pool, &entries, &d->capacity, d->count + 1, sizeof *d->entries));
    d->entries = entries;
    DEM_TRY(DEM_GROW(pool->entry, pool->entry_capacity, pool->entries + 1));
    e->place = d->count;
    e->number = pool->entries;
    DEM_TRY(dem_name_index_add(&pool->names, hash_in(d, e->name, strlen(e->name)), e->number));
    d->entries[d->count++] = pool->entry[pool->entries++] = e;
    return DEM_OK;
}

bool dem_dict_remove_entry(struct dem_dict *d, const char *name)
{
    struct dem_entry *const e = dem_dict_find(d, name, strlen(name));

    if (!e)
    {
        return false;
    }
    for (size_t i = e->place + 1; i < d->count; i++)
    {
        d->entries[i]->place--;
        d->entries[i - 1] = d->entries[i];
    }
    d->count--;
    d->pool->entry[e->number] = NULL;
    return true;
}

int dem_dict_put_dict(struct dem_dict *d, const char *name, const char *file, int line,
                      struct dem_dict **sub)
{
    struct dem_entry *e = dem_dict_find(d, name, strlen(name));

    if (!e || !e->dict)
    {
        DEM_TRY(dem_dict_new_entry(d, name, file, line, &e));
        DEM_TRY(dem_dict_new(d, name, file, line, &e->dict));
        DEM_TRY(dem_dict_put(e));
    }
    *sub = e->dict;
    return DEM_OK;
}

int dem_dict_note(const struct dem_dict *d, const char *name, const char *file, int line,
                  int block)
{
    struct dem_entry *const e = dem_dict_find(d, name, strlen(name));
    struct dem_dict_pool *const pool = d->pool;
    const char *const path = dem_dict_path(d);
    void *repeats = pool->repeats;
    char text[512];

    if (!e)
    {
        return DEM_OK;
    }
    if (e->block == block && (d->parent || !e->dict) && pool->repeat_count < MAX_REPEATS)
    {
        snprintf(text, sizeof text, "%s, line %d: %s%s%s is given again after line %d; %s", file, line,
                 path, *path ? "/" : "", name, e->block_line,
                 e->dict ? "both are merged, and of a setting that both have the later one acts; "
                           "remove one"
                         : "the later one acts; remove one");
        DEM_TRY(dem_dict_pool_grow(pool, &repeats, &pool->repeat_capacity, pool->repeat_count + 1,
                                   sizeof *pool->repeats));
        pool->repeats = repeats;
        DEM_TRY(dem_dict_pool_copy(pool, text, strlen(text), &pool->repeats[pool->repeat_count]));
        pool->repeat_count++;
    }
    e->block = block;
    e->block_line = line;
    return DEM_OK;
}

size_t dem_dict_repeats(const struct dem_dict *d, const char *const **sentences)
{
    *sentences = d->pool->repeats;
    return d->pool->repeat_count;
}

int dem_dict_append(struct dem_entry *e, struct dem_token token)
{
    void *tokens = e->tokens;

    DEM_TRY(dem_dict_pool_grow(e->parent->pool, &tokens, &e->capacity, e->count + 1, sizeof token));
    e->tokens = tokens;
    e->tokens[e->count++] = token;
    return DEM_OK;
}

int dem_dict_new_item(struct dem_entry *list, const char *name, const char *file, int line,
                      struct dem_dict **item)
{
    DEM_TRY(dem_dict_new(list->parent, name, file, line, item));
    (*item)->list = list->name;
    (*item)->item = list->items++;
    return dem_dict_append(list, (struct dem_token){.text = "{}",
                                                    .dict = *item,
                                                    .line = line,
                                                    .kind = DEM_TOKEN_DICT});
}

int dem_dict_append_copies(struct dem_entry *e, const struct dem_entry *from, int line)
{
    for (size_t i = 0; i < from->count; i++)
    {
        struct dem_token token = from->tokens[i];

        DEM_TRY(dem_dict_count_copy(e->parent->pool));
        if (token.dict)
        {
            struct dem_dict *item;

            DEM_TRY(
                dem_dict_new_item(e, token.dict->name, token.dict->file, token.dict->line, &item));
            DEM_TRY(dem_dict_merge(item, token.dict));
        }
        else
        {
            token.line = line;
            DEM_TRY(dem_dict_append(e, token));
        }
    }
    return DEM_OK;
}

int dem_dict_merge(struct dem_dict *into, const struct dem_dict *from)
{
    for (size_t i = 0; i < from->count; i++)
    {
        const struct dem_entry *e = from->entries[i];

        DEM_TRY(dem_dict_count_copy(into->pool));
        if (e->dict)
        {
            struct dem_dict *sub;

            DEM_TRY(dem_dict_put_dict(into, e->name, e->file, e->line, &sub));
            DEM_TRY(dem_dict_merge(sub, e->dict));
        }
        else
        {
            struct dem_entry *copy;

            DEM_TRY(dem_dict_new_entry(into, e->name, e->file, e->line, &copy));
            DEM_TRY(dem_dict_append_copies(copy, e, e->line));
            DEM_TRY(dem_dict_put(copy));
        }
    }
    return DEM_OK;
}
