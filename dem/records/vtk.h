/*
 * vtk.h -- particles, triangles and lines in files for ParaView and VTK: .vtp for one time, .pvd
 * for a series.
 *
 *     const struct dem_vtk_column columns[] = {
 *         {"points", p->x, sizeof *p, DEM_VTK_DOUBLE, 3},        first column: positions [m]
 *         {"id", &p->id, sizeof *p, DEM_VTK_INT64, 1},
 *         {"diameter", d, sizeof *d, DEM_VTK_FLOAT32, 1},
 *     };
 *     DEM_TRY(dem_vtk_write(NULL, "VTK/particles_000012.vtp", n, columns, 3));
 *     DEM_TRY(dem_vtk_collection_add("particles.pvd", time, "VTK/particles_000012.vtp"));
 *
 * Format: VTK XML PolyData, data appended raw with 64-bit lengths, after "VTK File Formats"
 * (Kitware), in the byte order of the machine, which the file states. Each particle is a point and
 * a vertex cell, so that it is visible without a filter. All ranks write their part of each array
 * into one file, lower ranks first; nothing is gathered. Files are written under a temporary name
 * and renamed.
 *
 * Why raw and not compressed: the file of a moving bed shrinks to 0.62 of its size under zlib at
 * 74 MB/s (level 1, one core), which is slower than a disk; and the offset of a rank's part of a
 * compressed array is known only when the parts before it are compressed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/parallel_file.h"
#include <stddef.h>
#include <stdint.h>

enum dem_vtk_type
{
    DEM_VTK_DOUBLE,    /* double, written as Float64                                   */
    DEM_VTK_FLOAT32,    /* double, written as Float32: half the bytes, seven digits     */
    DEM_VTK_INT64
};

struct dem_vtk_column
{
    const char *name;
    const void *data;          /* of the first particle                                        */
    size_t stride;             /* from one particle to the next [byte]                         */
    enum dem_vtk_type type;
    int components;            /* 1, 3 or up to 9, side by side in memory                      */
};

/* Collective; a null first argument means one rank. n particles of this rank; with 0 on all
   ranks the file is valid and has no points, and data may be null. */
int dem_vtk_write(const struct dem_file_ranks *, const char *path, int64_t n,
                  const struct dem_vtk_column *columns, int count);

/* Not collective. n triangles, 9 coordinates each [m], the wall number of each, and the depth [m] of its
   wear, or NULL. */
int dem_vtk_write_triangles(const char *path, int64_t n, const double *corners,
                            const int64_t *wall, const double *wear);

/* Collective, like dem_vtk_write, for n lines: the first column has six coordinates, both ends
   [m]; the other columns belong to the lines. */
int dem_vtk_write_lines(const struct dem_file_ranks *, const char *path, int64_t n,
                        const struct dem_vtk_column *columns, int count);

/* Add the file of a time [s] to a .pvd collection; `file` is relative to the collection's
   folder. Entries of that time and later, which an earlier run may have left before a restart,
   are dropped. The collection is created if it does not exist. Not collective. */
int dem_vtk_collection_add(const char *path, double time, const char *file);
