/*
 * stl.h -- triangles from a file in STL format, text or binary.
 *
 * Which of the two a file is follows from its length, as binary files may begin with "solid" too. Normals in the file
 * are not used. A text may hold several solids; they become one list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_STL_H
#define DEM_IO_STL_H

#include <stddef.h>

/* n triangles, 9 numbers each, multiplied by `scale` (metres per unit of the file); the caller gives them back with
   dem_memory_free. What is wrong is told with its line or triangle. */
int dem_stl_read(const char *path, double scale, double **corners, size_t *n);

#endif
