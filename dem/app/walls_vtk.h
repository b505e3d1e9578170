/*
 * walls_vtk.h -- walls of triangles as VTK files: walls.vtp once when all are at rest,
 * walls_NNNNNN.vtp and walls.pvd at each output when one of them moves. Planes, cylinders and
 * spheres are not written.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "app/output_files.h"

/* Collective, before the first output. Write walls.vtp, when no wall moves. */
int dem_walls_vtk_begin(const struct dem_output *, struct dem *);

/* Collective, at each output: write walls_NNNNNN.vtp and its entry in walls.pvd, when a wall
   moves. */
int dem_walls_vtk_write(const struct dem_output *, struct dem *, int64_t number, double time);
