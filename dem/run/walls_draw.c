/*
 * walls_draw.c -- write the triangles of the walls that are there, at their present positions and with their
 * wear, as a VTK file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "dem_tables.h"
#include "records/vtk.h"
#include <math.h>
#include <stdio.h>

int dem_walls_wear(const struct dem *d)
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
static int gather(struct dem *d, int wall, int64_t done,
                  struct triangles *t, int64_t *n)
{
    const int first = d->state.decomposition.rank == 0;
    struct dem_wall_info facts;

    dem_wall_info(d, wall, &facts);
    *n = facts.absent ? 0 : facts.triangles;
    if (*n == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_wall_corners(d, wall, first ? t->corners + 9*done : NULL));
    DEM_TRY(dem_walls_wear(d) ? dem_wall_wear(d, wall, first ? t->wear + done : NULL) : DEM_OK);
    for (int64_t k = done; k < done + *n && first; k++)
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
static int write_all(struct dem *d, const char *path)
{
    struct triangles t = {NULL, NULL, NULL};
    int64_t all = 0, done = 0, more = 0;

    for (int w = 0; w < dem_wall_count(d); w++)
    {
        struct dem_wall_info facts;

        dem_wall_info(d, w, &facts);
        all += facts.absent ? 0 : facts.triangles;
    }
    int status = dem_sim_agree(d, d->state.decomposition.rank == 0 ? reserve(&t, all + 1, dem_walls_wear(d)) : DEM_OK);

    for (int w = 0; w < dem_wall_count(d) && !status; w++)
    {
        status = gather(d, w, done, &t, &more);
        done += more;
    }
    status = status || d->state.decomposition.rank > 0
                 ? status
                 : dem_vtk_write_triangles(path, all, t.corners, t.wall, t.wear);
    dem_memory_free(t.corners);
    dem_memory_free(t.wall);
    dem_memory_free(t.wear);
    return dem_sim_agree(d, status);
}

int dem_walls_draw(struct dem *d, const char *folder, const char *file, double time)
{
    char path[2048];

    snprintf(path, sizeof path, "%s/%s", folder, file);
    DEM_TRY(write_all(d, path));
    snprintf(path, sizeof path, "%s/walls.pvd", folder);
    return dem_sim_agree(d, d->state.decomposition.rank == 0 && !isnan(time)
                                ? dem_vtk_collection_add(path, time, file) : DEM_OK);
}
