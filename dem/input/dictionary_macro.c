/*
 * dictionary_macro.c -- find the entry that a $name refers to.
 *
 *   $name         the nearest entry of that name, from the dictionary of the macro outward
 *   $dict.sub.x   the same for `dict`, then inward; a name that itself contains dots is found too
 *   $.x $..x      only in this dictionary, only in the parent; each further dot goes one up
 *   $:dict.x      from the top
 *
 * Only entries above the macro are known. A macro marks the entry as read: a dictionary that is
 * inserted elsewhere is a template and need not be read itself.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"
#include "core/did_you_mean.h"

#include <string.h>

enum
{
    MAX_CANDIDATES = 64  /* names compared for "did you mean" */
};

/* The entry of that dotted path in d itself. */
static struct dem_entry *descend(const struct dem_dict *d, const char *path)
{
    struct dem_entry *e = dem_dict_find(d, path, strlen(path));

    for (const char *dot = strchr(path, '.'); !e && dot; dot = strchr(dot + 1, '.'))
    {
        struct dem_entry *head = dem_dict_find(d, path, (size_t)(dot - path));

        e = head && head->dict ? descend(head->dict, dot + 1) : NULL;
    }
    return e;
}

static struct dem_entry *search_outward(const struct dem_dict *d, const char *path)
{
    struct dem_entry *e = NULL;

    for (; d && !e; d = d->parent)
    {
        e = descend(d, path);
    }
    return e;
}

static struct dem_entry *search(const struct dem_dict *d, const char *path)
{
    if (*path == ':')
    {
        while (d->parent)
        {
            d = d->parent;
        }
        return descend(d, path + 1);
    }
    if (*path == '.')
    {
        for (path++; d && *path == '.'; path++)
        {
            d = d->parent;
        }
        return d ? descend(d, path) : NULL;
    }
    return search_outward(d, path);
}

static const char *nearest(const struct dem_dict *d, const char *name)
{
    const char *known[MAX_CANDIDATES];
    int n = 0;

    for (; d; d = d->parent)
    {
        for (size_t i = 0; i < d->count && n < MAX_CANDIDATES; i++)
        {
            known[n++] = d->entries[i]->name;
        }
    }
    return n > 0 ? dem_did_you_mean_nearest(name, known, n) : NULL;
}

int dem_dict_macro(const struct dem_dict *here, const char *file, const struct dem_token *token,
                   const struct dem_entry **e)
{
    const char *name = token->text + 1, *near;
    struct dem_entry *found;

    DEM_REQUIRE(*name != '\0', DEM_ERROR_INPUT,
                "%s, line %d: $ stands alone; write $name directly, without a space", file,
                token->line);
    found = search(here, name);
    if (!found)
    {
        near = nearest(here, name);
        return dem_error(DEM_ERROR_INPUT, "%s, line %d: nothing above this line defines $%s%s%s%s",
                         file, token->line, name, near ? "; did you mean $" : "; define it first",
                         near ? near : "", near ? "?" : "");
    }
    found->used = true;
    if (found->dict)
    {
        dem_dict_mark_read(found->dict);
    }
    *e = found;
    return DEM_OK;
}
