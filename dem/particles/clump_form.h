/*
 * clump_form.h -- the form of a union of spheres as drag laws for non-spherical particles need it:
 * volume-equivalent sphere, surface, projected areas.
 *
 *   d = cbrt(6 V/pi)                      diameter of the sphere of the same volume V       [m]
 *   phi = pi d^2/S                        sphericity, S: surface                            [1]
 *   phi_c(n) = pi d^2/4/A(n)              crosswise: A, area projected along the unit vector n
 *   phi_l(n) = pi d^2/4/(S/2 - A_l(n))    lengthwise: A_l, mean of A over all directions across n
 *
 * n is the direction of the slip in principal axes. All are 1 for a sphere. A(n) = A(-n): half of a
 * cube around the body has a grid of DEM_CLUMP_FORM_CELLS^2 squares on each of its three faces, with
 * A and A_l at the nodes, and linear interpolation between them. A is a sum over lines across the
 * discs that the spheres project, exact along each line; S counts points of a spiral on each sphere
 * that lie in no other one. Errors: A and S 2e-4; interpolation 3e-3, 1.6e-2 at a direction along which
 * discs hide each other, where A has a cusp. Only + - * /, square
 * roots and dem_pow, so all machines give the same bits.
 *
 * Source: Hoelzer and Sommerfeld, Powder Technol. 184 (2008) 361, for the definitions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "particles/clump_shape.h"

enum
{
    DEM_CLUMP_FORM_CELLS = 24,    /* even, so that the axes are nodes */
    DEM_CLUMP_FORM_NODES = DEM_CLUMP_FORM_CELLS + 1
};

struct dem_clump_form
{
    double radius, volume;        /* m, m3  of the volume-equivalent sphere */
    double surface;               /* m2 */
    double sphericity;            /* 1 */
    int areas;                    /* 1: the next are known */
    /* 1/phi_c and 1/phi_l at the nodes of the faces across the axes 1, 2, 3 */
    double inverse[3][DEM_CLUMP_FORM_NODES][DEM_CLUMP_FORM_NODES][2];
};

/* `areas` 0: no projected areas. */
void dem_clump_form_make(struct dem_clump_form *, const struct dem_clump_shape *, int areas);

/* Crosswise and lengthwise sphericity of rows for slips along n, of any length, in principal axes. Row c has
   the form form[which[c]], or is a sphere where that is -1. */
void dem_clump_forms_along(const struct dem_clump_form *form, const int *which, double n[3][DEM_BATCH_ROWS], int rows,
                           double *crosswise, double *lengthwise);
