/*
 * clump_motion.c -- drift, rotation and kick of rigid bodies of several spheres, several at a time
 * (formulas and source: clump.h).
 *
 * Each rotation waits for the one before it, so bodies turn side by side (clump_lanes.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "particles/clump_lanes.h"
#include "particles/turn.h"
#include <math.h>

/* ---- drift ----------------------------------------------------------------------------------- */

/* Rotate about principal axis k over h [s] with the present angular momentum. */
DEM_MATH void turn_about(struct dem_clump_group *g, int k, double h)
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q[4] = DEM_CLUMP_LANE4(g->q), momentum[3] = DEM_CLUMP_LANE3(g->momentum);
        double body[3], to[4];

        dem_quaternion_rotate(q, -1.0, momentum, body);
        const double x = 0.5*h*body[k]/g->inertia[k][c], t = x*dem_tangent_series(x*x);
        const double turn[4] = {1.0, k == 0 ? t : 0.0, k == 1 ? t : 0.0, k == 2 ? t : 0.0};

        dem_quaternion_product(q, turn, to);
        const double scale = 1.0/sqrt(to[0]*to[0] + to[1]*to[1] + to[2]*to[2] + to[3]*to[3]);

        g->q[0][c] = scale*to[0];
        g->q[1][c] = scale*to[1];
        g->q[2][c] = scale*to[2];
        g->q[3][c] = scale*to[3];
    }
}

/* `square`: |w|^2 at the end [1/s2]. */
DEM_MATH void turn(struct dem_clump_group *g, double dt, double mean_spin[3][DEM_CLUMP_LANES],
                   double square[DEM_CLUMP_LANES])
{
    _Alignas(64) double before[3][DEM_CLUMP_LANES], after[3][DEM_CLUMP_LANES];

    dem_clump_spins(g, before);
    turn_about(g, 2, 0.5*dt);
    turn_about(g, 1, 0.5*dt);
    turn_about(g, 0, dt);
    turn_about(g, 1, 0.5*dt);
    turn_about(g, 2, 0.5*dt);
    dem_clump_spins(g, after);
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        for (int k = 0; k < 3; k++)
        {
            mean_spin[k][c] = 0.5*(before[k][c] + after[k][c]);
        }
        square[c] = after[0][c]*after[0][c] + after[1][c]*after[1][c] + after[2][c]*after[2][c];
    }
}

/* The velocities [m/s] at which the spheres of a slot drift to R r_k from the centres. */
DEM_MATH void find_velocities(const struct dem_clump_group *g, const struct dem_clump_slot *s,
                              const struct dem_particle *record, const struct dem_domain *d, double dt,
                              double v[3][DEM_CLUMP_LANES])
{
    static const struct dem_particle unused;
    _Alignas(64) double x[4][DEM_CLUMP_LANES];
    const double *at[DEM_CLUMP_LANES];

    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        at[c] = s->particle[c] == DEM_CLUMP_NO_SPHERE ? unused.x : record[s->particle[c]].x;
    }
    dem_clump_gather(at, x);
    for (int k = 0; k < 3; k++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            v[k][c] = g->x[k][c] + ((s->arm[k][c] + d->round[k]) - d->round[k]) - x[k][c];
        }
        for (int c = 0; c < DEM_CLUMP_LANES && d->periodic[k]; c++)
        {
            v[k][c] -= d->length[k]*rint(v[k][c]/d->length[k]);
        }
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            v[k][c] /= dt;
        }
    }
}

DEM_KERNEL
static void drift_group(struct dem_clump_group *restrict g, struct dem_clump_slot *restrict slot,
                        struct dem_particle *restrict record, const struct dem_domain *restrict d, double dt,
                        double square[DEM_CLUMP_LANES])
{
    _Alignas(64) double spin[3][DEM_CLUMP_LANES], v[3][DEM_CLUMP_LANES];

    for (int k = 0; k < 3; k++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            g->x[k][c] += (dt*g->v[k][c] + d->round[k]) - d->round[k];
        }
    }
    turn(g, dt, spin, square);
    dem_clump_keep_turns(g);
    for (size_t k = g->first; k < g->end; k++)
    {
        dem_clump_turn_arms(g, &slot[k]);
        find_velocities(g, &slot[k], record, d, dt, v);
        dem_clump_set_motion(&slot[k], record, v, spin);
    }
}

void dem_clumps_drift(struct dem_clumps *c, struct dem_particles *p, const struct dem_domain *d, double dt)
{
    double most = 0.0, invalid = 0.0;

    c->ahead = 1;
    for (size_t k = 0; k < c->groups; k++)
    {
        double square[DEM_CLUMP_LANES] = {0.0};

        if (k + 1 < c->groups)
        {
            dem_clump_prefetch(&c->group[k + 1], c->slot, p->record, sizeof *p->record, 2);
        }
        if (c->group[k].moves)
        {
            drift_group(&c->group[k], c->slot, p->record, d, dt, square);
        }
        for (int m = 0; m < DEM_CLUMP_LANES; m++)
        {
            most = square[m] > most ? square[m] : most;
            invalid += 0.0*square[m];
        }
    }
    c->max_spin_square = invalid == 0.0 ? most : INFINITY;
}

DEM_KERNEL
static void turn_group(struct dem_clump_group *g, double dt)
{
    double spin[3][DEM_CLUMP_LANES], square[DEM_CLUMP_LANES];

    turn(g, dt, spin, square);
}

void dem_clump_turn(struct dem_clump *b, double dt)
{
    struct dem_clump_group g;

    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        for (int k = 0; k < 4; k++)
        {
            g.q[k][c] = b->q[k];
        }
        for (int k = 0; k < 3; k++)
        {
            g.momentum[k][c] = b->momentum[k];
            g.inertia[k][c] = b->inertia[k];
        }
    }
    turn_group(&g, dt);
    for (int k = 0; k < 4; k++)
    {
        b->q[k] = g.q[k][0];
    }
}

/* ---- kick ------------------------------------------------------------------------------------ */

DEM_KERNEL
static void kick_group(struct dem_clump_group *restrict g, const struct dem_clump_slot *restrict slot,
                       struct dem_particle *restrict record, const double (*contact)[8], const double gravity[3],
                       double h)
{
    _Alignas(64) double F[3][DEM_CLUMP_LANES] = {{0.0}}, T[3][DEM_CLUMP_LANES] = {{0.0}};

    for (size_t k = g->first; k < g->end && g->moves; k++)
    {
        dem_clump_add_contacts(&slot[k], contact, F, T);
    }
    for (int a = 0; a < 3 && g->moves; a++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            g->v[a][c] += h*(F[a][c]/g->mass[c] + gravity[a]);
            g->momentum[a][c] += h*T[a][c];
        }
    }
    dem_clump_spread(g, slot, record);
}

void dem_clumps_kick(struct dem_clumps *c, struct dem_particles *p, const double g[3], double h)
{
    c->ahead = 1;
    for (size_t k = 0; k < c->groups; k++)
    {
        if (k + 1 < c->groups)
        {
            dem_clump_prefetch(&c->group[k + 1], c->slot, c->contact, sizeof *c->contact, 1);
            dem_clump_prefetch(&c->group[k + 1], c->slot, p->record, sizeof *p->record, 2);
        }
        kick_group(&c->group[k], c->slot, p->record, (const double (*)[8])c->contact, g, h);
    }
}
