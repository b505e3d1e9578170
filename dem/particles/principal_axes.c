/*
 * principal_axes.c -- principal axes of a symmetric tensor by Jacobi rotations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/principal_axes.h"
#include <math.h>
#include <string.h>

static void diagonalise(double A[3][3], double R[3][3])
{
    const double small = 1e-14*(fabs(A[0][0]) + fabs(A[1][1]) + fabs(A[2][2]));

    for (int turn = 0; turn < 60; turn++)
    {
        const int p = turn%3 == 2, q = turn%3 == 0 ? 1 : 2;

        if (fabs(A[p][q]) > small)
        {
            const double theta = 0.5*(A[q][q] - A[p][p])/A[p][q];
            const double t = (theta < 0.0 ? -1.0 : 1.0)/(fabs(theta) + sqrt(theta*theta + 1.0));
            const double c = 1.0/sqrt(t*t + 1.0), s = t*c;

            for (int k = 0; k < 3; k++)
            {
                const double a = A[k][p], b = A[k][q], e = R[k][p], f = R[k][q];

                A[k][p] = c*a - s*b, A[k][q] = s*a + c*b;
                R[k][p] = c*e - s*f, R[k][q] = s*e + c*f;
            }
            for (int k = 0; k < 3; k++)
            {
                const double a = A[p][k], b = A[q][k];

                A[p][k] = c*a - s*b, A[q][k] = s*a + c*b;
            }
        }
    }
}

/* The quaternion of a rotation matrix: of four forms the one with the largest divisor. */
static void quaternion(double R[3][3], double q[4])
{
    const double size[4] = {1.0 + R[0][0] + R[1][1] + R[2][2], 1.0 + R[0][0] - R[1][1] - R[2][2],
                            1.0 - R[0][0] + R[1][1] - R[2][2], 1.0 - R[0][0] - R[1][1] + R[2][2]};
    const double odd[3] = {R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]};
    int most = 0;

    for (int k = 1; k < 4; k++)
    {
        most = size[k] > size[most] ? k : most;
    }
    const double scale = 0.5/sqrt(size[most]);

    q[most] = scale*size[most];
    for (int k = 0; k < 4; k++)
    {
        if (k != most)
        {
            q[k] = scale*(most == 0 ? odd[k - 1]
                          : k == 0  ? odd[most - 1]
                                    : R[most - 1][k - 1] + R[k - 1][most - 1]);
        }
    }
}

void dem_principal_axes(double A[3][3], double R[3][3], double q[4])
{
    static const double unit[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};

    memcpy(R, unit, sizeof unit);
    diagonalise(A, R);
    quaternion(R, q);
}
