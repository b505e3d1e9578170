/*
 * walls_vtk.c -- when the triangles of walls are written as a VTK file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/walls_vtk.h"
#include "dem_tables.h"
#include <math.h>
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

int dem_walls_vtk_begin(const struct dem_output *o, struct dem *d)
{
    int changes;
    const int64_t n = count(d, &changes);

    return !o->vtk || n == 0 || changes ? DEM_OK : dem_walls_draw(d, o->folder, "walls.vtp", NAN);
}

int dem_walls_vtk_write(const struct dem_output *o, struct dem *d, int64_t number, double time)
{
    char file[64];
    int changes;

    (void)count(d, &changes);
    if (!changes)
    {
        return DEM_OK;
    }
    snprintf(file, sizeof file, "walls_%06lld.vtp", (long long)number);
    return dem_walls_draw(d, o->folder, file, time);
}
