/*
 * ready_walls.c -- walls that the program handed in, each rank some of the triangles: gathered, and told where they go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "base/memory.h"
#include <limits.h>
#include <stdint.h>
#include <string.h>

int dem_door_gather(const struct dem_parts *p, size_t size, size_t n, const double *mine, double **items, size_t *number)
{
    const int count = n <= INT_MAX/size ? (int)(size*n) : -1;
    int *counts, *start, total = 0;
    int64_t sum = 0;
    double *all;

    if (p->pieces.ranks == 1)
    {
        DEM_TRY(DEM_NEW(all, size*n + 1));
        memcpy(all, mine, size*n*sizeof *all);
        *items = all;
        *number = n;
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(counts, p->pieces.ranks));
    DEM_TRY(DEM_NEW(start, p->pieces.ranks));
    MPI_Allgather(&count, 1, MPI_INT, counts, 1, MPI_INT, p->pieces.comm);
    for (int k = 0; k < p->pieces.ranks; k++)
    {
        sum = counts[k] < 0 || sum > INT_MAX ? INT64_MAX/2 : sum + counts[k];
    }
    /* all ranks know all counts, and fail together */
    DEM_REQUIRE(sum <= INT_MAX, DEM_ERROR_MPI, "a wall or patch of more than %zu triangles is too long for MPI; make it of several",
                INT_MAX/size);
    for (int k = 0; k < p->pieces.ranks; k++)
    {
        start[k] = total;
        total += counts[k];
    }
    DEM_TRY(DEM_NEW(all, total + 1));
    MPI_Allgatherv(mine, count, MPI_DOUBLE, all, counts, start, MPI_DOUBLE, p->pieces.comm);
    dem_memory_free(counts);
    dem_memory_free(start);
    *items = all;
    *number = (size_t)total/size;
    return DEM_OK;
}

/* walls.c sorts them, so who brought which does not matter. */
static int gather_wall(struct dem_parts *p, int wall, const struct dem_mesh_wall *m)
{
    double *corners;
    size_t n;

    DEM_TRY(dem_door_gather(p, 9, m->n, m->triangles, &corners, &n));
    const int status = dem_walls_add_triangles(&p->walls, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_door_tell_wall(struct dem *d, const struct dem_mesh_wall *m, int now)
{
    struct dem_walls *const w = &d->parts.walls;
    double *corners;
    int wall = 0;
    size_t n;

    while (wall < w->walls && strcmp(w->wall[wall].name, m->name) != 0)
    {
        wall++;
    }
    DEM_TRY(dem_door_gather(&d->parts, 9, m->n, m->now, &corners, &n));
    const int status = now ? dem_walls_place(w, wall, n, corners) : dem_walls_tell(w, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_door_place_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        if (d->mesh_wall[k].now)
        {
            DEM_TRY(dem_door_tell_wall(d, &d->mesh_wall[k], 1));
        }
    }
    return DEM_OK;
}

int dem_door_take_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        const struct dem_mesh_wall *const m = &d->mesh_wall[k];
        int material, wall;

        DEM_TRY(dem_recipe_material(&d->parts.recipe, m->material, m->name, &material));
        DEM_TRY(dem_walls_add(&d->parts.walls, m->name, material, &wall));
        DEM_TRY(gather_wall(&d->parts, wall, m));
    }
    return DEM_OK;
}
