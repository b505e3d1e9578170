/*
 * principal_axes.h -- principal axes of a symmetric tensor, such as the inertia of a rigid body.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

/* A becomes diagonal, with the principal moments; the columns of R are the principal axes, and the quaternion q
   is the rotation R from them to the axes of A. */
void dem_principal_axes(double A[3][3], double R[3][3], double q[4]);
