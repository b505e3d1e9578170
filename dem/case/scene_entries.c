/*
 * scene_entries.c -- look up entries of the scene that the program reads, by their path.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem.h"
#include "core/text.h"
#include "input/dictionary.h"
#include <stdlib.h>
#include <string.h>

/* The entry of a path; NULL: there is none. `group`: its dictionary, NULL for a value; a number in the path selects
   a dictionary of a list, from 0. Groups on the way count as read. */
static const struct dem_entry *find(const struct dem_dict *d, const char *path, const struct dem_dict **group)
{
    const struct dem_entry *found = NULL;

    while (d && path)
    {
        const size_t n = strcspn(path, "/");

        found = NULL;
        for (size_t k = 0; k < dem_dict_count(d) && !found; k++)
        {
            const struct dem_entry *const e = dem_dict_entry(d, k);

            found = strlen(dem_entry_name(e)) == n && strncmp(dem_entry_name(e), path, n) == 0
                        ? e
                        : NULL;
        }
        path = path[n] ? path + n + 1 : NULL;
        d = found && dem_entry_is_dict(found) ? dem_entry_dict(found) : NULL;
        if (found && !d && path && *path >= '0' && *path <= '9')
        {
            char *end;

            d = dem_entry_item(found, strtoul(path, &end, 10));
            d = *end == '/' || !*end ? d : NULL;
            path = !d ? path : *end ? end + 1 : NULL;
        }
    }
    *group = d;
    return path ? NULL : found;
}

const char *dem_scene_value(const struct dem_dict *scene, const char *path)
{
    static _Thread_local struct dem_text value;
    const struct dem_dict *group;
    const struct dem_entry *const e = find(scene, path, &group);

    dem_text_free(&value);
    if (!e || group)
    {
        return NULL;
    }
    for (size_t k = 0; k < dem_entry_tokens(e); k++)
    {
        dem_text_add(&value, "%s%s", k > 0 ? " " : "", dem_entry_token(e, k));
    }
    return value.status ? NULL : value.text ? value.text : "";
}

const char *dem_scene_name(const struct dem_dict *scene, const char *path, int k)
{
    const struct dem_dict *in = scene;

    if (path[0] && !find(scene, path, &in))
    {
        return NULL;
    }
    const struct dem_entry *const e = in && k >= 0 ? dem_dict_entry(in, (size_t)k) : NULL;

    return e ? dem_entry_name(e) : NULL;
}

void dem_scene_skip(const struct dem_dict *scene, const char *path)
{
    const struct dem_dict *group;
    const struct dem_entry *const e = find(scene, path, &group);

    if (e && group)
    {
        dem_dict_mark_read(group);
    }
    else if (e)
    {
        (void)dem_entry_token(e, 0);
    }
}
