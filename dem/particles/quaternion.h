/*
 * quaternion.h -- unit quaternions as rotations, written for loops over lanes of vector registers: no branch, no call.
 *
 *   rotate    v + 2 s a x v + 2 a x (a x v),  s and a: scalar and vector part of q
 *   product   first b, then a (Hamilton)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

/* `side` -1: the inverse rotation. */
DEM_MATH void dem_quaternion_rotate(const double q[4], double side, const double v[3], double out[3])
{
    const double a = side*q[1], b = side*q[2], c = side*q[3];
    const double once[3] = {b*v[2] - c*v[1], c*v[0] - a*v[2], a*v[1] - b*v[0]};

    out[0] = v[0] + 2.0*(q[0]*once[0] + (b*once[2] - c*once[1]));
    out[1] = v[1] + 2.0*(q[0]*once[1] + (c*once[0] - a*once[2]));
    out[2] = v[2] + 2.0*(q[0]*once[2] + (a*once[1] - b*once[0]));
}

DEM_MATH void dem_quaternion_product(const double a[4], const double b[4], double out[4])
{
    out[0] = a[0]*b[0] - a[1]*b[1] - a[2]*b[2] - a[3]*b[3];
    out[1] = a[0]*b[1] + a[1]*b[0] + a[2]*b[3] - a[3]*b[2];
    out[2] = a[0]*b[2] - a[1]*b[3] + a[2]*b[0] + a[3]*b[1];
    out[3] = a[0]*b[3] + a[1]*b[2] - a[2]*b[1] + a[3]*b[0];
}

/* R I^-1 R^T L: the spin [1/s] of a body with orientation q, principal moments I and angular momentum L. */
DEM_MATH void dem_quaternion_spin(const double q[4], const double inertia[3], const double momentum[3],
                                  double spin[3])
{
    double body[3];

    dem_quaternion_rotate(q, -1.0, momentum, body);
    body[0] /= inertia[0];
    body[1] /= inertia[1];
    body[2] /= inertia[2];
    dem_quaternion_rotate(q, 1.0, body, spin);
}
