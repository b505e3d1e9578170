/*
 * walls_vtk.c -- write the triangles of all walls, at their present positions, as a VTK file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory.h"
#include "output/vtk.h"
#include <stdio.h>

/* The number of triangles; *moves: 1 when one of their walls moves. */
static int64_t count(const struct dem *d, int *moves)
{
    int64_t n = 0;

    *moves = 0;
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        struct dem_wall_info facts;

        dem_wall_info(d, w, &facts);
        n += facts.triangles;
        *moves |= facts.triangles > 0 && facts.moves;
    }
    return n;
}

static int write_all(const struct dem *d, int64_t n, const char *path)
{
    double *corners = NULL;
    int64_t *wall = NULL, done = 0;
    int status = DEM_NEW(corners, 9*n);

    status = status ? status : DEM_NEW(wall, n);
    for (int w = 0; w < dem_wall_count(d) && !status; w++)
    {
        struct dem_wall_info facts;

        dem_wall_info(d, w, &facts);
        dem_wall_corners(d, w, corners + 9*done);
        for (int64_t k = 0; k < facts.triangles; k++)
        {
            wall[done++] = w;
        }
    }
    status = status ? status : dem_vtk_write_triangles(path, n, corners, wall);
    dem_memory_free(corners);
    dem_memory_free(wall);
    return status;
}

int dem_walls_vtk_begin(const struct dem_output *o, const struct dem_program *prog,
                        const struct dem *d)
{
    char path[640];
    int moves, status = DEM_OK;
    const int64_t n = count(d, &moves);

    if (o->vtk && n > 0 && !moves && prog->rank == 0)
    {
        snprintf(path, sizeof path, "%s/walls.vtp", o->folder);
        status = dem_file_make_folder(o->folder);
        status = status ? status : write_all(d, n, path);
    }
    return dem_program_agree(prog, status);
}

int dem_walls_vtk_write(const struct dem_output *o, const struct dem *d, int64_t number,
                        double time)
{
    char file[64], path[640];
    int moves;
    const int64_t n = count(d, &moves);

    if (n == 0 || !moves)
    {
        return DEM_OK;
    }
    snprintf(file, sizeof file, "walls_%06lld.vtp", (long long)number);
    snprintf(path, sizeof path, "%s/%s", o->folder, file);
    DEM_TRY(write_all(d, n, path));
    snprintf(path, sizeof path, "%s/walls.pvd", o->folder);
    return dem_vtk_collection_add(path, time, file);
}
