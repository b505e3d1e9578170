/*
 * scene_walls.c -- read the walls of a scene: planes, boxes of six planes, cylinders, spheres,
 * triangles, STL files, and patches and surfaces of a mesh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/scene_internal.h"
#include "laws/material_entry.h"
#include "walls/wall_scalars.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/did_you_mean.h"
#include "input/stl.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

struct wall_reader
{
    const struct dem_interaction_table *interaction_table;
    struct dem_walls *walls;
};

/* Six planes with normals inward: one wall a side, named after the box. */
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

        DEM_REQUIRE(corner[0][k%3] < corner[1][k%3], DEM_ERROR_INPUT,
                    "%s: %s: min %g m is not below max %g m along %c", dem_dict_where(dict),
                    dem_dict_path(dict), corner[0][k%3], corner[1][k%3], "xyz"[k%3]);
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
    DEM_REQUIRE(n > 0 && n%3 == 0, DEM_ERROR_INPUT,
                "%s: %s: %zu corners; give three for each triangle", dem_dict_where(dict),
                dem_dict_path(dict), n);
    DEM_TRY(dem_walls_add(w, dem_dict_name(dict), material, &wall));
    return dem_walls_add_triangles(w, wall, n/3, &corner[0][0]);
}

static int read_file(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    const char *file;
    double scale, *corner = NULL;
    size_t n = 0;
    int wall;

    DEM_TRY(dem_dict_text(dict, "file", &file));
    DEM_TRY(dem_dict_number_or(dict, "scale", "1", 1.0, &scale));
    DEM_REQUIRE(scale > 0.0, DEM_ERROR_INPUT,
                "%s: scale %g; give a number above 0, metres per unit of the file",
                dem_dict_where(dict), scale);
    DEM_TRY(w->elsewhere ? DEM_OK
                         : dem_error_prefix(dem_stl_read(file, scale, &corner, &n), "%s: wall %s: ",
                                            dem_dict_where(dict), dem_dict_name(dict)));
    int status = dem_walls_add(w, dem_dict_name(dict), material, &wall);

    status = status ? status : dem_walls_add_triangles(w, wall, n, corner);
    dem_memory_free(corner);
    return status;
}

static int read_plane(struct dem_walls *w, const struct dem_dict *dict, int material)
{
    double point[3], normal[3];

    DEM_TRY(dem_dict_vector(dict, "point", "m", point));
    DEM_TRY(dem_dict_vector(dict, "normal", "1", normal));
    return dem_walls_add_plane(w, dem_dict_name(dict), material, point, normal);
}

static int read_round(struct dem_walls *w, const struct dem_dict *dict, int material, int cylinder)
{
    static const char *const sides[] = {"inside", "outside"};
    double point[3], axis[3], radius;
    const char *side;

    DEM_TRY(dem_dict_vector(dict, cylinder ? "point" : "centre", "m", point));
    if (cylinder)
    {
        DEM_TRY(dem_dict_vector(dict, "axis", "1", axis));
    }
    DEM_TRY(dem_dict_number(dict, "radius", "m", &radius));
    DEM_TRY(dem_dict_word(dict, "particles", &side));
    if (strcmp(side, sides[0]) != 0 && strcmp(side, sides[1]) != 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("side of the particles", side, sides, 2),
                                "%s: ", dem_dict_where(dict));
    }
    return dem_walls_add_round(w, dem_dict_name(dict), material, point, cylinder ? axis : NULL,
                               radius, strcmp(side, sides[1]) == 0);
}

/* Add the walls of an entry; `first` is the index of the first of them. */
static int read_shape(const struct wall_reader *reader, const struct dem_dict *dict, int *first)
{
    static const char *const known[] = {"plane", "box", "cylinder", "sphere",
                                        "triangles", "stl", "patch", "surface"};
    struct dem_walls *const w = reader->walls;
    const char *type;
    int kind = 0, material;

    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_material_entry_read(dict, reader->interaction_table, &material));
    *first = w->walls;
    while (kind < 8 && strcmp(type, known[kind]) != 0)
    {
        kind++;
    }
    switch (kind)
    {
    case 0: return read_plane(w, dict, material);
    case 1: return read_box(w, dict, material);
    case 2: return read_round(w, dict, material, 1);
    case 3: return read_round(w, dict, material, 0);
    case 4: return read_triangles(w, dict, material);
    case 5: return read_file(w, dict, material);
    case 8:
        return dem_error_prefix(dem_did_you_mean_error("type of wall", type, known, 8),
                                "%s: ", dem_dict_where(dict));
    default:
        *first = dem_walls_named(w, dem_dict_name(dict));
        DEM_REQUIRE(*first < w->walls, DEM_ERROR_INPUT,
                    "%s: wall %s is a %s, but no mesh provides it; run it in OpenFOAM, or use type "
                    "plane, box, cylinder, sphere, triangles or stl",
                    dem_dict_where(dict), dem_dict_name(dict), type);
        return DEM_OK;
    }
}

/* `from` and `until`: times, or stages. */
static int read_presence(struct dem_walls *w, struct dem_wall *wall, const struct dem_dict *dict)
{
    int *const stage = wall->there_stage;

    DEM_TRY(dem_dict_time_or(dict, "from", -INFINITY, &wall->there[0], &stage[0]));
    DEM_TRY(dem_dict_time_or(dict, "until", INFINITY, &wall->there[1], &stage[1]));
    DEM_TRY(dem_dict_check_times(dict, "from", "until", wall->there, stage));
    w->passing += dem_dict_has(dict, "from") || dem_dict_has(dict, "until");
    return DEM_OK;
}

/* Motions of single faces of a box, whose walls begin with `first`:  faces { maxZ { motion ... } } */
static int read_faces(struct dem_walls *w, const struct dem_dict *dict, int first)
{
    static const char *const known[] = {"minX", "minY", "minZ", "maxX", "maxY", "maxZ"};
    const struct dem_dict *faces;

    DEM_TRY(dem_dict_sub_if(dict, "faces", &faces));
    for (size_t k = 0; faces && k < dem_dict_count(faces); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(faces, k);
        int side = 0;

        while (side < 6 && strcmp(dem_entry_name(e), known[side]) != 0)
        {
            side++;
        }
        if (side == 6)
        {
            return dem_error_prefix(dem_did_you_mean_error("face", dem_entry_name(e), known, 6),
                                    "%s: ", dem_entry_where(e));
        }
        DEM_REQUIRE(dem_entry_is_dict(e) && w->wall[first + side].frame < 0, DEM_ERROR_INPUT,
                    "%s: a face has { motion ... }, unless the whole box moves", dem_entry_where(e));
        DEM_TRY(dem_scene_read_motion(w, first + side, dem_entry_dict(e)));
    }
    return DEM_OK;
}

/* A box is six walls, and each would be a body of its own. */
static int check_bodies(const struct dem_walls *w, const struct dem_dict *dict, int first, int end)
{
    DEM_REQUIRE(end - first < 2 || !dem_walls_body(w, first), DEM_ERROR_INPUT,
                "%s: a box is six walls, which a force moves one by one; give the motion to some of its "
                "faces { maxZ { motion ... } }, or use triangles", dem_dict_where(dict));
    return DEM_OK;
}

/* wear { law; coefficient; hardness; } of triangles. */
static int read_wear(const struct dem_dict *dict, struct dem_wall *of)
{
    static const char *const laws[] = {"archard", "finnie"};
    const struct dem_dict *wear;
    const char *law;
    double coefficient, hardness;

    DEM_TRY(dem_dict_sub_if(dict, "wear", &wear));
    if (!wear)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_word_or(wear, "law", laws[0], &law));
    if (strcmp(law, laws[0]) != 0 && strcmp(law, laws[1]) != 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("law of wear", law, laws, 2), "%s: ", dem_dict_where(wear));
    }
    DEM_TRY(dem_dict_number(wear, "coefficient", "1", &coefficient));
    DEM_TRY(dem_dict_number(wear, "hardness", "Pa", &hardness));
    DEM_REQUIRE(coefficient >= 0.0 && hardness > 0.0, DEM_ERROR_INPUT,
                "%s: coefficient %g and hardness %g Pa; give numbers above 0", dem_dict_where(wear),
                coefficient, hardness);
    DEM_REQUIRE(of->shape == DEM_SHAPE_TRIANGLES, DEM_ERROR_INPUT,
                "%s: wall %s has no triangles, whose wear could be summed; build it from triangles",
                dem_dict_where(wear), of->name);
    of->wear = coefficient/hardness;
    of->wears_by_impact = strcmp(law, laws[1]) == 0;
    return DEM_OK;
}

static int read_wall(void *context, const struct dem_dict *dict)
{
    const struct wall_reader *const reader = context;
    struct dem_walls *const w = reader->walls;
    int first;

    DEM_TRY(read_shape(reader, dict, &first));
    /* a wall of a mesh is one wall and is already in the list */
    const int end = first < w->walls && strcmp(w->wall[first].name, dem_dict_name(dict)) == 0
                      ? first + 1
                      : w->walls;

    bool absorb, frictionless;

    DEM_TRY(dem_dict_switch_or(dict, "absorb", false, &absorb));
    DEM_TRY(dem_dict_switch_or(dict, "frictionless", false, &frictionless));
    for (int k = first; k < end; k++)
    {
        w->wall[k].absorbs = absorb ? dem_dict_name(dict) : NULL;
        w->wall[k].frictionless = frictionless;
        w->absorbing += absorb;
        DEM_TRY(read_wear(dict, &w->wall[k]));
        w->wearing += w->wall[k].wear > 0.0;
        DEM_REQUIRE(!absorb || !dem_dict_has(dict, "wear"), DEM_ERROR_INPUT,
                    "%s: wall %s absorbs particles, which have no contact with it, so it does not wear; take out "
                    "absorb or wear", dem_dict_where(dict), w->wall[k].name);
        DEM_TRY(dem_scalar_wall_read(dict, reader->interaction_table, &w->wall[k]));
        DEM_TRY(read_presence(w, &w->wall[k], dict));
        DEM_TRY(dem_scene_read_motion(w, k, dict));
        DEM_REQUIRE(!(frictionless && w->wall[k].driven), DEM_ERROR_INPUT,
                    "%s: wall %s is frictionless, so the velocity of its surface moves no particle; "
                    "take out frictionless, or surfaceVelocity and surfaceRotation",
                    dem_dict_where(dict), w->wall[k].name);
    }
    DEM_TRY(check_bodies(w, dict, first, end));
    return end - first == 6 ? read_faces(w, dict, first) : DEM_OK;
}

int dem_scene_read_walls(const struct dem_dict *scene, const struct dem_interaction_table *r,
                         struct dem_walls *w)
{
    struct wall_reader reader = {.interaction_table = r, .walls = w};

    return dem_dict_each(scene, "walls", read_wall, &reader);
}
