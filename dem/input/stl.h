/*
 * stl.h -- triangles from a file in STL format, text or binary.
 *
 * The format follows from the length of the file, because binary files may begin with "solid" too.
 * Normals in the file are not used. A text file may contain several solids; they become one list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>

/* n triangles, 9 coordinates each [m], `scale` being metres per unit of the file; the caller frees
   *corners with dem_memory_free. DEM_ERROR_FILE names the wrong line or triangle. */
int dem_stl_read(const char *path, double scale, double **corners, size_t *n);
