/*
 * scene_walls.c -- the walls of a scene: planes, boxes of six planes, triangles, and patches that a mesh has handed in.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/scene_parts.h"
#include "base/error.h"
#include "base/unknown.h"
#include <stdio.h>
#include <string.h>

struct wall_reader
{
    const struct dem_recipe *recipe;
    struct dem_walls *walls;
};

/* Six planes that look inward: one wall a side, named after the box. */
static int read_box(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    static const char *const side[2][3] = {{"MinX", "MinY", "MinZ"}, {"MaxX", "MaxY", "MaxZ"}};
    double corner[2][3];

    DEM_TRY(dem_dict_vector(dict, "min", "m", corner[0]));
    DEM_TRY(dem_dict_vector(dict, "max", "m", corner[1]));
    for (int k = 0; k < 6; k++)
    {
        double normal[3] = {0.0, 0.0, 0.0};
        char name[64];

        DEM_REQUIRE(corner[0][k%3] < corner[1][k%3], DEM_ERROR_INPUT, "%s: min %g is not below max %g along axis %d",
                    dem_dict_where(dict), corner[0][k%3], corner[1][k%3], k%3);
        normal[k%3] = k < 3 ? 1.0 : -1.0;
        snprintf(name, sizeof name, "%.50s%s", dem_dict_name(dict), side[k/3][k%3]);
        DEM_TRY(dem_walls_add_plane(w, name, material, corner[k/3], normal));
    }
    return DEM_OK;
}

static int read_triangles(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    const double (*corner)[3];
    size_t n;
    int wall;

    DEM_TRY(dem_dict_vectors(dict, "corners", "m", &corner, &n));
    DEM_REQUIRE(n > 0 && n%3 == 0, DEM_ERROR_INPUT, "%s: %zu corners; give three for each triangle", dem_dict_where(dict), n);
    DEM_TRY(dem_walls_add(w, dem_dict_name(dict), material, &wall));
    return dem_walls_add_triangles(w, wall, n/3, &corner[0][0]);
}

static int is_there(const struct dem_walls *w, const char *name)
{
    for (int k = 0; k < w->walls; k++)
    {
        if (strcmp(w->wall[k].name, name) == 0)
        {
            return 1;
        }
    }
    return 0;
}

static int read_wall(void *with, const struct dem_dict *dict)
{
    static const char *const known[] = {"plane", "box", "triangles", "patch"};
    struct wall_reader *const reader = with;
    const struct dem_recipe *const r = reader->recipe;
    const char *type, *name;
    double point[3], normal[3];
    int material;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_dict_word_or(dict, "material", r->materials == 1 ? r->material[0].name : "", &name));
    DEM_TRY(dem_recipe_material(r, name, dem_dict_where(dict), &material));
    if (strcmp(type, "plane") == 0)
    {
        DEM_TRY(dem_dict_vector(dict, "point", "m", point));
        DEM_TRY(dem_dict_vector(dict, "normal", "1", normal));
        return dem_walls_add_plane(reader->walls, dem_dict_name(dict), material, point, normal);
    }
    if (strcmp(type, "box") == 0)
    {
        return read_box(reader->walls, dict, material);
    }
    if (strcmp(type, "triangles") == 0)
    {
        return read_triangles(reader->walls, dict, material);
    }
    if (strcmp(type, "patch") == 0)
    {
        DEM_REQUIRE(is_there(reader->walls, dem_dict_name(dict)), DEM_ERROR_INPUT,
                    "%s: wall %s is a patch, but no mesh has given it; run it in OpenFOAM, or use type plane, box or triangles",
                    dem_dict_where(dict), dem_dict_name(dict));
        return DEM_OK;
    }
    return dem_error_prefix(dem_unknown_word("type of wall", type, known, 4), "%s: ", dem_dict_where(dict));
}

int dem_scene_read_walls(const struct dem_dict *scene, const struct dem_recipe *r, struct dem_walls *w)
{
    struct wall_reader reader = {.recipe = r, .walls = w};

    return dem_dict_each(scene, "walls", read_wall, &reader);
}
