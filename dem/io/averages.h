/*
 * averages.h -- grids of boxes over which the user wants means: what the scene says of them, and the files they end in.
 *
 *     averages { NAME { min (0 0 0); max (0.1 0.1 0.2); cells (10 1 20); start 1; end 10; interval 0.01; } }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_IO_AVERAGES_H
#define DEM_IO_AVERAGES_H

#include "io/dictionary.h"

struct dem_average_plan
{
    const char *name;
    const char *says;                                         /* a line for the heads of both files; NULL: none */
    double min[3], max[3];                                    /* m   */
    int cells[3];                                             /* along x, y, z */
    double start, end, interval;                              /* s   between samples; the first at start */
};

/* Read `averages`; *plan is NULL and *n 0 when there is none. The caller frees *plan; names live as long as the tree. */
int dem_averages_read(const struct dem_dict *scene, struct dem_average_plan **plan, int *n);

struct dem_average_field                                      /* one quantity in all cells */
{
    const char *name, *unit;
    int components;                                           /* 1, 3 (x y z) or 6 (xx yy zz xy yz zx) */
    const double *value, *ci;                                 /* of the first cell; half widths of 95 % intervals */
};

/* Write folder/NAME.csv (a row a cell, x fastest: centre, then each component and its interval) and folder/NAME.vti
   (image data of cells for ParaView). `stride` numbers from cell to cell in every field. Not collective. */
int dem_averages_write(const char *folder, const struct dem_average_plan *, const struct dem_average_field *, int fields,
                       size_t stride);

#endif
