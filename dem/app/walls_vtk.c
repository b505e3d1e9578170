/*
 * walls_vtk.c -- write the triangles of all walls, at their present positions, as a VTK file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/vtk.h"
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

/* Collective; the first rank writes the file. */
static int write_all(const struct dem_program *prog, struct dem *d, int64_t n, const char *path)
{
    double *corners = NULL;
    int64_t *wall = NULL, done = 0;
    int status = prog->rank == 0 ? DEM_NEW(corners, 9*n) : DEM_OK;

    status = status || prog->rank > 0 ? status : DEM_NEW(wall, n);
    status = dem_program_agree(prog, status);
    for (int w = 0; w < dem_wall_count(d) && !status; w++)
    {
        struct dem_wall_info facts;

        dem_wall_info(d, w, &facts);
        status = dem_wall_corners(d, w, prog->rank == 0 ? corners + 9*done : NULL);
        for (int64_t k = 0; k < facts.triangles && prog->rank == 0; k++)
        {
            wall[done++] = w;
        }
    }
    status = status || prog->rank > 0 ? status : dem_vtk_write_triangles(path, n, corners, wall);
    dem_memory_free(corners);
    dem_memory_free(wall);
    return dem_program_agree(prog, status);
}

int dem_walls_vtk_begin(const struct dem_output *o, const struct dem_program *prog, struct dem *d)
{
    char path[640];
    int moves;
    const int64_t n = count(d, &moves);

    if (!o->vtk || n == 0 || moves)
    {
        return DEM_OK;
    }
    snprintf(path, sizeof path, "%s/walls.vtp", o->folder);
    return write_all(prog, d, n, path);
}

int dem_walls_vtk_write(const struct dem_output *o, const struct dem_program *prog, struct dem *d,
                        int64_t number, double time)
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
    DEM_TRY(write_all(prog, d, n, path));
    snprintf(path, sizeof path, "%s/walls.pvd", o->folder);
    return dem_program_agree(prog, prog->rank == 0 ? dem_vtk_collection_add(path, time, file)
                                                   : DEM_OK);
}
