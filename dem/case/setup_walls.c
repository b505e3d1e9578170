/*
 * setup_walls.c -- walls of dem_case_add_wall: each rank gives its triangles. When a wall moves,
 * each rank gathers all its triangles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include <string.h>

/* Collective. Hold all triangles of a wall from its first movement on. Wall neighbors keep their
   triangles and facets, which now have other indices. */
static int follow(struct dem_state *state, int wall)
{
    struct dem_wall_search *const s = &state->pairs.wall_search;

    if (state->decomposition.ranks == 1 || state->walls.wall[wall].follows_mesh)
    {
        return DEM_OK;
    }
    dem_wall_search_use_indices(s, &state->walls);
    DEM_TRY(dem_wall_store_follow(&state->wall_store, &state->walls, wall));
    dem_wall_search_use_held(s, &state->walls);
    return dem_collect_agree(&state->decomposition,
                             dem_wall_search_prepare(s, &state->walls, s->radius));
}

/* The original triangles stay; each call overwrites the moved ones. */
static int copy_moved_corners(struct dem_mesh_wall *w, int64_t n, const double *triangles)
{
    DEM_REQUIRE(n >= 0 && (size_t)n == w->n, DEM_ERROR_INPUT, "wall %s is to move with %lld "
                "triangles, but was added with %zu; a mesh may move, but its faces must stay the "
                "same", w->name, (long long)n, w->n);
    if (!w->moved)
    {
        DEM_TRY(DEM_NEW(w->moved, 9*w->n + 1));
    }
    memcpy(w->moved, triangles, 9*w->n*sizeof *triangles);
    return DEM_OK;
}

int dem_sim_copy_corners(struct dem *d, const char *call, const char *name, int64_t n,
                         const double *triangles, struct dem_mesh_wall **wall)
{
    size_t k = 0;

    while (k < d->mesh_walls && strcmp(d->mesh_wall[k].name, name) != 0)
    {
        k++;
    }
    DEM_REQUIRE(k < d->mesh_walls, DEM_ERROR_INPUT,
                "%s: there is no wall %s of dem_case_add_wall", call, name);
    *wall = &d->mesh_wall[k];
    return dem_sim_agree(d, copy_moved_corners(*wall, n, triangles));
}

int dem_sim_move_wall(struct dem *d, const struct dem_mesh_wall *m, int now)
{
    struct dem_walls *const w = &d->state.walls;
    const int wall = dem_walls_named(w, m->name);
    double *corners;
    size_t n;

    DEM_TRY(follow(&d->state, wall));
    DEM_TRY(dem_sim_gather(&d->state, DEM_OK, 9, m->n, m->moved, &corners, &n));
    const int status = now ? dem_walls_set_corners(w, wall, n, corners)
                           : dem_walls_set_target(w, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_sim_position_mesh_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        if (d->mesh_wall[k].moved)
        {
            DEM_TRY(dem_sim_move_wall(d, &d->mesh_wall[k], 1));
        }
    }
    return DEM_OK;
}

int dem_sim_add_mesh_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        struct dem_mesh_wall *const m = &d->mesh_wall[k];
        int material, wall;

        int status = dem_interaction_table_find_material(&d->state.interaction_table, m->material,
                                                         m->name, &material);

        status = status ? status : dem_walls_add(&d->state.walls, m->name, material, &wall);
        DEM_TRY(dem_sim_agree(d, status));
        /* the walls sort their triangles, so the order of the ranks has no influence */
        DEM_TRY(dem_wall_store_add(&d->state.wall_store, &d->state.walls, wall, m->n,
                                   m->triangles));
        dem_memory_free(m->triangles);
        m->triangles = NULL;
    }
    return DEM_OK;
}

/* 1 when a group is placed inside walls, a mesh or a zone: each rank tests positions anywhere. */
static int places_inside(const struct dem_dict *scene)
{
    const struct dem_dict *insert = NULL;
    int inside = 0;

    if (!dem_dict_has(scene, "insert") || dem_dict_sub_if(scene, "insert", &insert) || !insert)
    {
        return 0;
    }
    for (size_t k = 0; k < dem_dict_count(insert); k++)
    {
        const struct dem_entry *const e = dem_dict_entry(insert, k);
        const struct dem_dict *const group = dem_entry_is_dict(e) ? dem_entry_dict(e) : NULL;

        inside |= group && (dem_dict_has(group, "inside") || dem_dict_has(group, "zone"));
    }
    return inside;
}

void dem_sim_begin_walls(struct dem *d)
{
    dem_wall_store_begin(&d->state.wall_store, &d->state.walls, places_inside(d->dict));
}
