/*
 * material_entry.c -- the material of a wall or of particles in a scene, by its name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/material_entry.h"
#include "core/error.h"
#include <stdio.h>
#include <string.h>

int dem_material_entry_read(const struct dem_dict *dict, const struct dem_interaction_table *r,
                            int *material)
{
    char list[256] = "";
    const char *name;

    if (dem_dict_has(dict, "material"))
    {
        DEM_TRY(dem_dict_word(dict, "material", &name));
        return dem_interaction_table_find_material(r, name, dem_dict_where(dict), material);
    }
    for (int k = 0; k < r->materials && strlen(list) < sizeof list - 64; k++)
    {
        snprintf(list + strlen(list), 64, "%s%s", k > 0 ? ", " : "", r->material[k].name);
    }
    DEM_REQUIRE(r->materials == 1, DEM_ERROR_INPUT,
                "%s: %s misses its material, as the scene has %d; add material, one of %s",
                dem_dict_where(dict), dem_dict_path(dict), r->materials, list);
    *material = 0;
    return DEM_OK;
}
