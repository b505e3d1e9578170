/*
 * averages_io.h -- grids of time averages: the scene entry `averages` and the output files.
 *
 *     averages
 *     {
 *         NAME
 *         {
 *             min (0 0 0); max (0.1 0.1 0.2); cells (10 1 20);
 *             start 1; end 10; interval 0.01;
 *         }
 *     }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"

struct dem_averages_entry             /* one grid as the scene describes it */
{
    const char *name;
    const char *comment;               /* a comment for the .vti file; NULL: none */
    double min[3], max[3];          /* m   */
    int cells[3];                   /* along x, y, z */
    double start, end, interval;    /* s   interval between samples; the first at start */
};

/* Read the scene entry `averages`; *plan is NULL and *n 0 when there is none. The caller frees
   *plan; names belong to the dictionary. DEM_ERROR_INPUT with the location of a wrong entry. */
int dem_averages_io_read(const struct dem_dict *scene, struct dem_averages_entry **plan, int *n);

struct dem_averages_quantity         /* one quantity in all cells */
{
    const char *name, *unit;
    int components;              /* 1, 3 (x y z) or 6 (xx yy zz xy yz zx) */
    const double *value, *ci;    /* first cell; half width of the 95 % interval */
};

/* Write folder/NAME.csv (a row a cell, x fastest: centre, then each component and its interval)
   and folder/NAME.vti (cell data for ParaView). The values of consecutive cells are `stride`
   numbers apart. Not collective. */
int dem_averages_io_write(const char *folder, const struct dem_averages_entry *,
                          const struct dem_averages_quantity *, int fields, size_t stride);
