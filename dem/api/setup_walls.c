/*
 * setup_walls.c -- walls of dem_add_wall: the triangles of all ranks are gathered on each, at
 * set-up and at each movement.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "api/internal.h"
#include "core/error.h"
#include "core/memory.h"
#include "parallel/collect.h"
#include <stdio.h>
#include <string.h>

int dem_api_gather(const struct dem_state *p, size_t size, size_t n, const double *mine,
                   double **items, size_t *number)
{
    const struct dem_collect_items own = {"triangles of a wall or patch (make it of several)", mine,
                                          n, size*sizeof *mine};
    void *all;

    DEM_TRY(dem_collect_gather(&p->decomposition, DEM_OK, &own, &all, number));
    *items = all;
    return DEM_OK;
}

/* The walls sort their triangles, so the order of the ranks has no influence. */
static int gather_wall(struct dem_state *p, int wall, const struct dem_mesh_wall *m)
{
    double *corners;
    size_t n;

    DEM_TRY(dem_api_gather(p, 9, m->n, m->triangles, &corners, &n));
    const int status = dem_walls_add_triangles(&p->walls, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_api_move_wall(struct dem *d, const struct dem_mesh_wall *m, int now)
{
    struct dem_walls *const w = &d->state.walls;
    double *corners;
    int wall = 0;
    size_t n;

    while (wall < w->walls && strcmp(w->wall[wall].name, m->name) != 0)
    {
        wall++;
    }
    DEM_TRY(dem_api_gather(&d->state, 9, m->n, m->moved, &corners, &n));
    const int status = now ? dem_walls_set_corners(w, wall, n, corners)
                           : dem_walls_set_target(w, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_api_position_mesh_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        if (d->mesh_wall[k].moved)
        {
            DEM_TRY(dem_api_move_wall(d, &d->mesh_wall[k], 1));
        }
    }
    return DEM_OK;
}

int dem_api_add_mesh_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        const struct dem_mesh_wall *const m = &d->mesh_wall[k];
        int material, wall;

        DEM_TRY(dem_interaction_table_find_material(&d->state.interaction_table, m->material,
                                                    m->name, &material));
        DEM_TRY(dem_walls_add(&d->state.walls, m->name, material, &wall));
        DEM_TRY(gather_wall(&d->state, wall, m));
    }
    return DEM_OK;
}

int dem_insert_region(struct dem *d, const char *name, int zone, int64_t n,
                      const double *triangles)
{
    struct dem_insertion_regions *const g = &d->scene.insertion.regions;
    double *corners;
    size_t total;

    DEM_TRY(dem_api_require_unchecked(d, "dem_insert_region"));
    DEM_REQUIRE(strlen(name) < sizeof g->surface->name, DEM_ERROR_INPUT,
                "zone %s: a name longer than %zu characters; shorten it", name,
                sizeof g->surface->name - 1);
    DEM_TRY(DEM_GROW(g->surface, g->capacity, g->n + 1));
    DEM_TRY(dem_api_gather(&d->state, 9, (size_t)n, triangles, &corners, &total));
    struct dem_closed_surface *const s = &g->surface[g->n++];

    *s = (struct dem_closed_surface){.what = zone ? "zone" : "mesh", .zone = zone};
    snprintf(s->name, sizeof s->name, "%s", name);
    return dem_api_agree(d, dem_closed_surface_init(s, total, corners));
}
