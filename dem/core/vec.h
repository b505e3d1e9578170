/*
 * vec.h -- dot product, cross product, difference and norm of vectors of three numbers.
 *
 * For set-up code, and on devices. Kernels work on columns instead, one component at a time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

static inline double dem_vec_dot(const double a[3], const double b[3])
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

/* out must be neither a nor b */
static inline void dem_vec_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1]*b[2] - a[2]*b[1];
    out[1] = a[2]*b[0] - a[0]*b[2];
    out[2] = a[0]*b[1] - a[1]*b[0];
}

static inline void dem_vec_minus(const double a[3], const double b[3], double out[3])
{
    out[0] = a[0] - b[0];
    out[1] = a[1] - b[1];
    out[2] = a[2] - b[2];
}

static inline double dem_vec_norm(const double a[3])
{
    return sqrt(dem_vec_dot(a, a));
}
