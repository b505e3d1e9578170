/*
 * main_surfaces.h -- walls made of triangles for ParaView: walls.vtp once when they rest, walls_NNNNNN.vtp and walls.pvd at each
 * output when one of them moves. Nothing for planes, cylinders and spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_SURFACES_H
#define DEM_MAIN_SURFACES_H

#include "main_output.h"

/* Collective; before the first output. */
int dem_surfaces_begin(const struct dem_output *, const struct dem_program *, const struct dem *);

/* Where the first rank writes its pictures. */
int dem_surfaces_write(const struct dem_output *, const struct dem *, int64_t number, double time);

#endif
