/*
 * clump_turn.c -- free rotation of rigid bodies, several at a time (formulas and source: clump.h).
 *
 * Each rotation waits for the one before it, so the bodies of a batch turn side by side in the lanes of
 * vector registers. Each lane has the arithmetic, and the bits, of a body alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "particles/clump.h"
#include "particles/quaternion.h"
#include "particles/turn.h"
#include <math.h>

struct lanes
{
    double q[4][DEM_CLUMP_LANES], momentum[3][DEM_CLUMP_LANES], inertia[3][DEM_CLUMP_LANES];
    double before[3][DEM_CLUMP_LANES], after[3][DEM_CLUMP_LANES];    /* spins [1/s] */
};

/* What lane c has of columns. */
#define LANE3(of) {(of)[0][c], (of)[1][c], (of)[2][c]}
#define LANE4(of) {(of)[0][c], (of)[1][c], (of)[2][c], (of)[3][c]}

/* Rotate about principal axis k over h [s] with the present angular momentum. */
DEM_MATH void turn_about(struct lanes *s, int k, double h)
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q[4] = LANE4(s->q), momentum[3] = LANE3(s->momentum);
        double body[3], to[4];

        dem_quaternion_rotate(q, -1.0, momentum, body);
        const double x = 0.5*h*body[k]/s->inertia[k][c], t = x*dem_tangent_series(x*x);
        const double turn[4] = {1.0, k == 0 ? t : 0.0, k == 1 ? t : 0.0, k == 2 ? t : 0.0};

        dem_quaternion_product(q, turn, to);
        const double scale = 1.0/sqrt(to[0]*to[0] + to[1]*to[1] + to[2]*to[2] + to[3]*to[3]);

        s->q[0][c] = scale*to[0];
        s->q[1][c] = scale*to[1];
        s->q[2][c] = scale*to[2];
        s->q[3][c] = scale*to[3];
    }
}

DEM_MATH void find_spin(const struct lanes *s, double spin[3][DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q[4] = LANE4(s->q), momentum[3] = LANE3(s->momentum), inertia[3] = LANE3(s->inertia);
        double w[3];

        dem_quaternion_spin(q, inertia, momentum, w);
        spin[0][c] = w[0];
        spin[1][c] = w[1];
        spin[2][c] = w[2];
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
