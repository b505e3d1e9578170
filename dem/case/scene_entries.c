/*
 * scene_entries.c -- look up entries of the scene that the program reads, by their path.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem.h"
#include "core/error.h"
#include "core/text.h"
#include "input/dictionary.h"
#include <string.h>

/* The entry of a path; NULL: there is none. Groups on the way count as read. */
static const struct dem_entry *find(const struct dem_dict *d, const char *path)
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
    }
    return path ? NULL : found;
}

const char *dem_scene_value(const struct dem_dict *scene, const char *path)
{
    static _Thread_local struct dem_text value;
    const struct dem_entry *const e = find(scene, path);

    dem_text_free(&value);
    if (!e || dem_entry_is_dict(e))
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
    const struct dem_entry *const group = path[0] ? find(scene, path) : NULL;
    const struct dem_dict *const in =
        !path[0] ? scene : group && dem_entry_is_dict(group) ? dem_entry_dict(group) : NULL;
    const struct dem_entry *const e = in && k >= 0 ? dem_dict_entry(in, (size_t)k) : NULL;

    return e ? dem_entry_name(e) : NULL;
}

void dem_scene_skip(const struct dem_dict *scene, const char *path)
{
    const struct dem_entry *const e = find(scene, path);

    if (e && dem_entry_is_dict(e))
    {
        dem_dict_mark_read(dem_entry_dict(e));
    }
    else if (e)
    {
        (void)dem_entry_token(e, 0);
    }
}
