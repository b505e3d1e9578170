/*
 * clump_lanes.h -- rigid bodies of several spheres (clump.h), side by side in the lanes of vector registers.
 *
 * Each lane has the arithmetic, and the bits, of a body alone. Lanes follow each other in the order of the first
 * spheres in memory, so that bodies of a group are neighbors. Frozen bodies have groups of their own. Lanes without a
 * body repeat the first one; a lane whose body has no sphere k reads and writes an unused record.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/vec4.h"
#include "particles/clump.h"
#include "particles/quaternion.h"

enum
{
    DEM_CLUMP_LANES = 8
};

#define DEM_CLUMP_NO_SPHERE UINT32_MAX

struct dem_clump_group    /* bodies; struct dem_clump has the members */
{
    _Alignas(64) double mass[DEM_CLUMP_LANES];
    double inertia[3][DEM_CLUMP_LANES], x[3][DEM_CLUMP_LANES], v[3][DEM_CLUMP_LANES], q[4][DEM_CLUMP_LANES],
        momentum[3][DEM_CLUMP_LANES];
    double turned[DEM_CLUMP_LANES][4];                 /* the same as q, four numbers of a body side by side */
    size_t first, end;    /* slots */
    int n, moves;         /* bodies; 0: frozen */
};

struct dem_clump_slot     /* sphere k of each body of a group */
{
    _Alignas(64) double offset[3][DEM_CLUMP_LANES];    /* m  r_k */
    double arm[3][DEM_CLUMP_LANES];                    /* m  R r_k, as the drift left it */
    uint32_t particle[DEM_CLUMP_LANES];
};

/* Initializers: the numbers of lane c. */
#define DEM_CLUMP_LANE3(of) {(of)[0][c], (of)[1][c], (of)[2][c]}
#define DEM_CLUMP_LANE4(of) {(of)[0][c], (of)[1][c], (of)[2][c], (of)[3][c]}

/* Four numbers of each lane into columns. */
DEM_MATH void dem_clump_gather(const double *const from[DEM_CLUMP_LANES], double to[4][DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c += 4)
    {
        dem_vec4 row[4] = {DEM_VEC4(from[c]), DEM_VEC4(from[c + 1]), DEM_VEC4(from[c + 2]), DEM_VEC4(from[c + 3])};

        dem_transpose4(row);
        for (int a = 0; a < 4; a++)
        {
            DEM_VEC4_AT(to[a] + c) = row[a];
        }
    }
}

/* Three columns into the first three of four numbers of each lane. */
DEM_MATH void dem_clump_scatter(double from[3][DEM_CLUMP_LANES], double *const to[DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c += 4)
    {
        dem_vec4 row[4] = {DEM_VEC4(from[0] + c), DEM_VEC4(from[1] + c), DEM_VEC4(from[2] + c),
                           DEM_VEC4(from[2] + c)};

        dem_transpose4(row);
        for (int k = 0; k < 4; k++)
        {
            DEM_VEC4_AT(to[c + k]) = __builtin_shufflevector(row[k], DEM_VEC4(to[c + k]), 0, 1, 2, 7);
        }
    }
}

/* q into `turned`. */
DEM_MATH void dem_clump_keep_turns(struct dem_clump_group *g)
{
    for (int c = 0; c < DEM_CLUMP_LANES; c += 4)
    {
        dem_vec4 row[4] = {DEM_VEC4(g->q[0] + c), DEM_VEC4(g->q[1] + c), DEM_VEC4(g->q[2] + c), DEM_VEC4(g->q[3] + c)};

        dem_transpose4(row);
        for (int k = 0; k < 4; k++)
        {
            DEM_VEC4_AT(g->turned[c + k]) = row[k];
        }
    }
}

/* Prefetch the first cache lines of the elements of a group's spheres; `size`: bytes of an element. */
DEM_MATH void dem_clump_prefetch(const struct dem_clump_group *g, const struct dem_clump_slot *slot,
                                 const void *array, size_t size, size_t lines)
{
    for (size_t k = g->first; k < g->end; k++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            const size_t i = slot[k].particle[c] == DEM_CLUMP_NO_SPHERE ? 0 : slot[k].particle[c];

            for (size_t line = 0; line < lines; line++)
            {
                __builtin_prefetch((const char *)array + i*size + 64*line, 1);
            }
        }
    }
}

/* Spins [1/s]. */
DEM_MATH void dem_clump_spins(const struct dem_clump_group *g, double w[3][DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q[4] = DEM_CLUMP_LANE4(g->q), inertia[3] = DEM_CLUMP_LANE3(g->inertia),
                     momentum[3] = DEM_CLUMP_LANE3(g->momentum);
        double spin[3];

        dem_quaternion_spin(q, inertia, momentum, spin);
        w[0][c] = spin[0];
        w[1][c] = spin[1];
        w[2][c] = spin[2];
    }
}

/* R r_k. */
DEM_MATH void dem_clump_turn_arms(const struct dem_clump_group *g, struct dem_clump_slot *s)
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double q[4] = DEM_CLUMP_LANE4(g->q), offset[3] = DEM_CLUMP_LANE3(s->offset);
        double arm[3];

        dem_quaternion_rotate(q, 1.0, offset, arm);
        s->arm[0][c] = arm[0];
        s->arm[1][c] = arm[1];
        s->arm[2][c] = arm[2];
    }
}

/* R r_k x f. */
DEM_MATH void dem_clump_moment(const struct dem_clump_slot *s, double f[][DEM_CLUMP_LANES],
                               double moment[3][DEM_CLUMP_LANES])
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        moment[0][c] = s->arm[1][c]*f[2][c] - s->arm[2][c]*f[1][c];
        moment[1][c] = s->arm[2][c]*f[0][c] - s->arm[0][c]*f[2][c];
        moment[2][c] = s->arm[0][c]*f[1][c] - s->arm[1][c]*f[0][c];
    }
}

/* Write velocities and spins to the spheres of a slot. */
DEM_MATH void dem_clump_set_motion(const struct dem_clump_slot *s, struct dem_particle *record,
                                   double v[3][DEM_CLUMP_LANES], double w[3][DEM_CLUMP_LANES])
{
    struct dem_particle unused;
    double *velocity[DEM_CLUMP_LANES], *spin[DEM_CLUMP_LANES];

    unused.inverse_mass = unused.inverse_inertia = 0.0;
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        struct dem_particle *const r = s->particle[c] == DEM_CLUMP_NO_SPHERE ? &unused : record + s->particle[c];

        velocity[c] = r->v;
        spin[c] = r->w;
    }
    dem_clump_scatter(v, velocity);
    dem_clump_scatter(w, spin);
}

/* Eight numbers of each sphere of a slot into columns; 0 where a body has no such sphere. */
DEM_MATH void dem_clump_gather_rows(const struct dem_clump_slot *s, const void *rows, double row[2][4][DEM_CLUMP_LANES])
{
    _Alignas(64) static const double none[8];
    const double *from[DEM_CLUMP_LANES], *second[DEM_CLUMP_LANES];

    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        from[c] = s->particle[c] == DEM_CLUMP_NO_SPHERE ? none : (const double *)rows + 8*(size_t)s->particle[c];
        second[c] = from[c] + 4;
    }
    dem_clump_gather(from, row[0]);
    dem_clump_gather(second, row[1]);
}

/* Add force and moment of the contacts of a slot. */
DEM_MATH void dem_clump_add_contacts(const struct dem_clump_slot *s, const double (*contact)[8],
                                     double F[3][DEM_CLUMP_LANES], double T[3][DEM_CLUMP_LANES])
{
    _Alignas(64) double row[2][4][DEM_CLUMP_LANES], moment[3][DEM_CLUMP_LANES];

    dem_clump_gather_rows(s, contact, row);
    dem_clump_moment(s, row[0], moment);
    for (int a = 0; a < 3; a++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            F[a][c] += row[0][a][c];
            T[a][c] += moment[a][c] + row[1][a][c];
        }
    }
}

/* After a kick: write the motion of the bodies to their spheres. */
DEM_MATH void dem_clump_spread(const struct dem_clump_group *g, const struct dem_clump_slot *slot,
                               struct dem_particle *record)
{
    _Alignas(64) double w[3][DEM_CLUMP_LANES], v[3][DEM_CLUMP_LANES];

    dem_clump_spins(g, w);
    for (size_t k = g->first; k < g->end; k++)
    {
        const struct dem_clump_slot *const s = &slot[k];

        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            v[0][c] = g->v[0][c] + (w[1][c]*s->arm[2][c] - w[2][c]*s->arm[1][c]);
            v[1][c] = g->v[1][c] + (w[2][c]*s->arm[0][c] - w[0][c]*s->arm[2][c]);
            v[2][c] = g->v[2][c] + (w[0][c]*s->arm[1][c] - w[1][c]*s->arm[0][c]);
        }
        dem_clump_set_motion(s, record, v, w);
    }
}
