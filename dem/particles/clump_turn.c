/*
 * clump_turn.c -- free rotation of rigid bodies, several at a time (formulas and source: clump.h).
 *
 * Each rotation waits for the one before it, so the bodies of a batch turn side by side in the lanes of
 * vector registers: the formulas of clump.c stand here again, as loops over lanes. Each lane has the arithmetic, and the bits, of a body alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "particles/clump.h"
#include <math.h>

struct lanes
{
    double q[4][DEM_CLUMP_LANES], momentum[3][DEM_CLUMP_LANES], inertia[3][DEM_CLUMP_LANES];
    double before[3][DEM_CLUMP_LANES], after[3][DEM_CLUMP_LANES];    /* spins [1/s] */
};

#define ALWAYS static inline __attribute__((always_inline))

/* Rotate about principal axis k over h [s] with the present angular momentum; m, n the next axes. */
ALWAYS void turn_about(struct lanes *s, int k, double h)
{
    const int m = (k + 1)%3, n = (k + 2)%3;

    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q0 = s->q[0][c], q1 = s->q[1][c], q2 = s->q[2][c], q3 = s->q[3][c];
        const double ak = -s->q[1 + k][c], am = -s->q[1 + m][c], an = -s->q[1 + n][c];
        const double vk = s->momentum[k][c], vm = s->momentum[m][c], vn = s->momentum[n][c];
        const double once_k = am*vn - an*vm, once_m = an*vk - ak*vn, once_n = ak*vm - am*vk;
        const double along = vk + 2.0*(q0*once_k + (am*once_n - an*once_m));
        const double x = 0.5*h*along/s->inertia[k][c], square = x*x;
        const double t =
            x*(1.0 + square*(1.0/3.0 + square*(2.0/15.0 + square*(17.0/315.0 + square*(62.0/2835.0 +
                                                                     square*(1382.0/155925.0))))));
        const double b1 = k == 0 ? t : 0.0, b2 = k == 1 ? t : 0.0, b3 = k == 2 ? t : 0.0;
        const double t0 = q0 - q1*b1 - q2*b2 - q3*b3, t1 = q0*b1 + q1 + q2*b3 - q3*b2,
                     t2 = q0*b2 - q1*b3 + q2 + q3*b1, t3 = q0*b3 + q1*b2 - q2*b1 + q3;
        const double scale = 1.0/sqrt(t0*t0 + t1*t1 + t2*t2 + t3*t3);

        s->q[0][c] = scale*t0;
        s->q[1][c] = scale*t1;
        s->q[2][c] = scale*t2;
        s->q[3][c] = scale*t3;
    }
}

/* R I^-1 R^T L */
ALWAYS void find_spin(const struct lanes *s, double spin[3][DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q0 = s->q[0][c], x = s->q[1][c], y = s->q[2][c], z = s->q[3][c];
        const double a = -x, b = -y, d = -z;
        const double u = s->momentum[0][c], v = s->momentum[1][c], w = s->momentum[2][c];
        const double o0 = b*w - d*v, o1 = d*u - a*w, o2 = a*v - b*u;
        const double r0 = (u + 2.0*(q0*o0 + (b*o2 - d*o1)))/s->inertia[0][c],
                     r1 = (v + 2.0*(q0*o1 + (d*o0 - a*o2)))/s->inertia[1][c],
                     r2 = (w + 2.0*(q0*o2 + (a*o1 - b*o0)))/s->inertia[2][c];
        const double p0 = y*r2 - z*r1, p1 = z*r0 - x*r2, p2 = x*r1 - y*r0;

        spin[0][c] = r0 + 2.0*(q0*p0 + (y*p2 - z*p1));
        spin[1][c] = r1 + 2.0*(q0*p1 + (z*p0 - x*p2));
        spin[2][c] = r2 + 2.0*(q0*p2 + (x*p1 - y*p0));
    }
}

DEM_KERNEL
static void turn(struct lanes *s, double dt)
{
    find_spin(s, s->before);
    turn_about(s, 2, 0.5*dt);
    turn_about(s, 1, 0.5*dt);
    turn_about(s, 0, dt);
    turn_about(s, 1, 0.5*dt);
    turn_about(s, 2, 0.5*dt);
    find_spin(s, s->after);
}

void dem_clump_turn_several(struct dem_clump *const *body, int n, double dt, double mean_spin[][3])
{
    struct lanes s;

    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const struct dem_clump *const b = body[c < n ? c : 0];

        for (int k = 0; k < 4; k++)
        {
            s.q[k][c] = b->q[k];
        }
        for (int k = 0; k < 3; k++)
        {
            s.momentum[k][c] = b->momentum[k];
            s.inertia[k][c] = b->inertia[k];
        }
    }
    turn(&s, dt);
    for (int c = 0; c < n; c++)
    {
        for (int k = 0; k < 4; k++)
        {
            body[c]->q[k] = s.q[k][c];
        }
        for (int k = 0; k < 3; k++)
        {
            mean_spin[c][k] = 0.5*(s.before[k][c] + s.after[k][c]);
        }
    }
}

void dem_clump_turn(struct dem_clump *b, double dt)
{
    double mean_spin[1][3];

    dem_clump_turn_several(&b, 1, dt, mean_spin);
}
