/*
 * vtk.h -- particles as points, and triangles, in files that ParaView and VTK open: .vtp for a moment, .pvd for the whole run.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     const struct dem_vtk_column columns[] = {
 *         {"points", p->x, sizeof *p, DEM_VTK_DOUBLE, 3},              the first column: positions [m]
 *         {"id", &p->id, sizeof *p, DEM_VTK_INT64, 1},
 *         {"diameter", d, sizeof *d, DEM_VTK_NARROW, 1},
 *     };
 *     DEM_TRY(dem_vtk_write(NULL, "VTK/particles_000012.vtp", n, columns, 3));
 *     DEM_TRY(dem_vtk_collection_add("particles.pvd", time, "VTK/particles_000012.vtp"));
 *
 * VTK XML PolyData, data appended raw with 64-bit lengths, after "VTK File Formats" (Kitware), in the byte order
 * of the machine, which the file names. Each particle is a point and a vertex cell, so that it is seen without a
 * filter. All ranks write their part of each array into one file, that of lower ranks first; nothing is gathered. Files are written
 * aside and renamed. Raw and not compressed: a picture of a moving bed shrinks to 0.62 under zlib at 74 MB/s (level 1, one core),
 * less than a disk takes, and a part of a compressed array has no place of its own before those before it are compressed.
 */
#ifndef DEM_IO_VTK_H
#define DEM_IO_VTK_H

#include "io/store.h"
#include <stddef.h>
#include <stdint.h>

enum dem_vtk_type
{
    DEM_VTK_DOUBLE,    /* double, written as Float64                                   */
    DEM_VTK_NARROW,    /* double, written as Float32: half the bytes and seven digits  */
    DEM_VTK_INT64,
    DEM_VTK_INT32
};

struct dem_vtk_column
{
    const char *name;
    const void *data;          /* of the first particle                                        */
    size_t stride;             /* from one particle to the next [byte]                         */
    enum dem_vtk_type type;
    int components;            /* 1, 3 or up to 9, side by side in memory                      */
};

/* Collective; NULL: alone. n particles of this rank; 0 of all give a valid file without points, and data may then be null. */
int dem_vtk_write(const struct dem_writers *, const char *path, int64_t n, const struct dem_vtk_column *columns, int count);

/* Not collective. n triangles, 9 numbers each [m], and the number of each one's wall. */
int dem_vtk_write_triangles(const char *path, int64_t n, const double *corners, const int64_t *wall);

/* The same for n lines: the first column holds six numbers, both ends; the others belong to the lines. */
int dem_vtk_write_lines(const struct dem_writers *, const char *path, int64_t n, const struct dem_vtk_column *columns, int count);

/* Add the file of a time [s], named as seen from the collection's folder. Entries of that time and later, left by a
   run that was restarted from before them, are dropped. The collection is made if it does not exist. */
int dem_vtk_collection_add(const char *path, double time, const char *file);

#endif
