/*
 * walls_vtk.c -- write the triangles of the walls that are there, at their present positions and with their
 * wear, as a VTK file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "records/vtk.h"
#include <stdio.h>

/* The number of triangles that are there; *changes: 1 when one of the walls of triangles moves, wears,
   comes or goes. */
static int64_t count(const struct dem *d, int *changes)
{
    int64_t n = 0;

    *changes = 0;
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        struct dem_wall_info facts;

        dem_wall_info(d, w, &facts);
        n += facts.absent ? 0 : facts.triangles;
        *changes |= facts.triangles > 0 && (facts.moves || facts.passes || dem_wall_wears(d, w));
    }
    return n;
}

static int any_wears(const struct dem *d)
{
    int wears = 0;

    for (int w = 0; w < dem_wall_count(d); w++)
    {
        wears |= dem_wall_wears(d, w);
    }
    return wears;
}

/* Area of a triangle [m2]. */
static double area(const double *corners)
{
    double a[3], b[3], normal[3];

    dem_vec_minus(corners + 3, corners, a);
    dem_vec_minus(corners + 6, corners, b);
    dem_vec_cross(a, b, normal);
    return 0.5*dem_vec_norm(normal);
}

struct triangles    /* of all walls, on the first rank */
{
    double *corners, *wear;    /* m, m; wear NULL: no wall wears */
    int64_t *wall;
};

/* Collective. The triangles of a wall, from number `done` on. */
static int gather(const struct dem_program *prog, struct dem *d, int wall, int64_t done,
                  struct triangles *t, int64_t *n)
{
    struct dem_wall_info facts;

    dem_wall_info(d, wall, &facts);
    *n = facts.absent ? 0 : facts.triangles;
    if (*n == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_wall_corners(d, wall, prog->rank == 0 ? t->corners + 9*done : NULL));
    DEM_TRY(any_wears(d) ? dem_wall_wear(d, wall, prog->rank == 0 ? t->wear + done : NULL) : DEM_OK);
    for (int64_t k = done; k < done + *n && prog->rank == 0; k++)
    {
        t->wall[k] = wall;
        if (t->wear)
        {
            t->wear[k] /= area(t->corners + 9*k);
        }
    }
    return DEM_OK;
}

static int reserve(struct triangles *t, int64_t n, int wears)
{
    DEM_TRY(DEM_NEW(t->corners, 9*n));
    DEM_TRY(DEM_NEW(t->wall, n));
    return wears ? DEM_NEW(t->wear, n) : DEM_OK;
}

/* Collective; the first rank writes the file. */
static int write_all(const struct dem_program *prog, struct dem *d, int64_t n, const char *path)
{
    struct triangles t = {NULL, NULL, NULL};
    int64_t done = 0, more = 0;
    int status = dem_program_agree(prog, prog->rank == 0 ? reserve(&t, n, any_wears(d)) : DEM_OK);

    for (int w = 0; w < dem_wall_count(d) && !status; w++)
    {
        status = gather(prog, d, w, done, &t, &more);
        done += more;
    }
    status = status || prog->rank > 0
                 ? status
                 : dem_vtk_write_triangles(path, n, t.corners, t.wall, t.wear);
    dem_memory_free(t.corners);
    dem_memory_free(t.wall);
    dem_memory_free(t.wear);
    return dem_program_agree(prog, status);
}

int dem_walls_vtk_begin(const struct dem_output *o, const struct dem_program *prog, struct dem *d)
{
    char path[640];
    int changes;
    const int64_t n = count(d, &changes);

    if (!o->vtk || n == 0 || changes)
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
    int changes;
    const int64_t n = count(d, &changes);

    if (!changes)
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
