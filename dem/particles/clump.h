/*
 * clump.h -- rigid bodies of several spheres (clumps): their state and motion.
 *
 * The spheres are ordinary particles, with ids that follow each other; contacts, their history and
 * ghosts work as for spheres. Each sphere of a body holds the whole state of it in a column, with
 * the same bits, so that sorting, migration, backups and snapshots carry bodies along. All spheres
 * of a body are on the rank that owns its centre.
 *
 *   force and torque   F = sum f_k + M g,  T = sum (R r_k x f_k + t_k), in the order of the spheres
 *   kick               v += h F/M,  L += h T
 *   drift              x += dt v;  R by rotations about the principal axes 3, 2, 1, 2, 3 with L kept
 *   spheres            x_k = x + R r_k; velocity: displacement over dt in the drift, and after a kick
 *                      v + w x R r_k; spin w = R I^-1 R^T L, in the drift the mean of both ends
 *
 *   M, I   mass [kg] and principal moments of inertia [kg m2]
 *   x, v   centre [m], its velocity [m/s]
 *   R      rotation from the principal axes to space, as a unit quaternion q
 *   L      angular momentum about the centre, in space [kg m2/s]
 *   r_k    centre of sphere k in principal axes [m]
 *
 * The rotation about axis k by dt L_k/I_k solves the motion under the energy L_k^2/(2 I_k), so the
 * drift is symplectic, of second order and time-reversible, and keeps L exactly. A rotation by the
 * angle a uses the series of tan(a/2) of orientation.c; its error, 7e-4 (a/2)^13, changes the angle
 * only.
 *
 * Along periodic axes x and R r_k are rounded to the unit of the domain (domain.h).
 *
 * Source: Dullweber, Leimkuhler and McLachlan, J. Chem. Phys. 107 (1997) 5840.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "particles/particles.h"

struct dem_clump    /* the column of a sphere; all 0 for single spheres */
{
    double mass, inertia[3];
    double offset[3];            /* r_k of this sphere */
    double x[3], v[3], q[4];
    double momentum[3];          /* L */
};
_Static_assert(sizeof(struct dem_clump) == DEM_CLUMP_WIDTH*sizeof(double),
               "the column clump is as wide as this struct");

struct dem_clump_applied    /* forces of scene and program in a kick: step/clump_applied.c */
{
    double force[3], torque[3];          /* N, N m  about the centre */
    double v[3], momentum[3];            /* m/s, kg m2/s  before the kick */
};

/* the spheres of the bodies of a rank, by body */
struct dem_clumps
{
    size_t n;                    /* bodies */
    size_t *start;               /* of each in the next array, and the end */
    uint32_t *member;            /* particles in the order of their ids */
    double (*contact)[8];        /* N, N m  force and torque of the contacts of each particle,
                                    3 + 1 numbers each */
    struct dem_clump_applied *applied;    /* to each body; where forces of scene or program exist */
    uint32_t *place;             /* of each body: group times DEM_CLUMP_LANES, plus lane */
    size_t groups;               /* of bodies that move side by side */
    struct dem_clump_group *group;
    struct dem_clump_slot *slot;
    int ahead;                   /* 1: the groups have moved, and the columns have not followed */
    double max_spin_square;      /* 1/s2  largest |w|^2 after the last drift */
    size_t start_capacity, member_capacity, contact_capacity, applied_capacity;
    size_t place_capacity, group_capacity, slot_capacity;
    struct dem_clump_flow *flow; /* NULL: no fluid acts on them; clump_flow.h */
    struct dem_clump_heat *heat; /* NULL: they have no temperature; step/clump_heat.h */
};

/* The body of a particle that belongs to one. */
static inline struct dem_clump *dem_clump_at(const struct dem_particles *p, size_t i)
{
    return (struct dem_clump *)(void *)dem_column(p, DEM_COLUMN_CLUMP) + i;
}

/* The body of a particle, or NULL. */
static inline struct dem_clump *dem_clump_of(const struct dem_particles *p, size_t i)
{
    return dem_column(p, DEM_COLUMN_CLUMP) && p->record[i].body ? dem_clump_at(p, i) : NULL;
}

/* 1 for single spheres and for the first sphere of each body. */
static inline int dem_clump_counts(const struct dem_particle *p)
{
    return p->body == 0 || p->body == p->id + 1;
}

/* The position that decides which rank owns a particle and whether it is in the domain: its own, or
   the centre of its body. */
static inline const double *dem_clump_home(const struct dem_particles *p, size_t i)
{
    const struct dem_clump *const b = dem_clump_of(p, i);

    return b ? b->x : p->record[i].x;
}

/* R v, and R^T v. */
void dem_clump_rotate(const double q[4], const double v[3], double out[3]);
void dem_clump_rotate_back(const double q[4], const double v[3], double out[3]);

/* The product of two quaternions: first b, then a. */
void dem_clump_product(const double a[4], const double b[4], double out[4]);

/* Angular velocity [1/s]. */
void dem_clump_spin(const struct dem_clump *, double w[3]);

/* rad  in a step, by which a clump turns at most */
#define DEM_CLUMP_MAX_TURN 0.3

/* `error` when the clump of this sphere turns further in a step of dt [s]. */
int dem_clump_check_spin(const struct dem_clump *, const struct dem_particle *, double dt, int error);

/* What a particle adds to sums over all of them: a single sphere its own, the first sphere of a body
   the body's, the others nothing. */
struct dem_particle_share
{
    double mass, momentum[3];         /* kg, kg m/s */
    double kinetic[2];                /* J  of translation, of rotation */
};
void dem_particle_share(const struct dem_particles *, size_t particle, struct dem_particle_share *);

/* The largest distance [m] of a sphere from the centre of its body, on this rank. */
double dem_clumps_reach(const struct dem_particles *);

/* Free rotation over dt [s]. */
void dem_clump_turn(struct dem_clump *, double dt);

void dem_clumps_free(struct dem_clumps *);

/* List the spheres of the bodies and load their state, after particles or their order have changed. */
int dem_clumps_index(struct dem_clumps *, const struct dem_particles *);

/* The state of the bodies from the columns, and back where it has moved since. */
void dem_clumps_load(struct dem_clumps *, const struct dem_particles *);
void dem_clumps_store(struct dem_clumps *, struct dem_particles *);

/* The present state of a body, as of its first sphere; R r_k of its sphere k. */
void dem_clumps_body(const struct dem_clumps *, size_t body, const struct dem_particles *,
                     struct dem_clump *);
void dem_clumps_arm(const struct dem_clumps *, size_t body, size_t k, double arm[3]);

/* 1 when no force moves the body: it is frozen. */
static inline int dem_clumps_frozen(const struct dem_clumps *c, size_t body, const struct dem_particles *p)
{
    return (p->record[c->member[c->start[body]]].flags & DEM_PARTICLE_FROZEN) != 0;
}

/* Position, velocity and spin of a sphere of a new body, whose centre has been wrapped. */
void dem_clump_put(const struct dem_clump *, const struct dem_domain *, struct dem_particle *);

/* Before the drift of particles over dt: move the bodies; set the velocities and spins with which
   their spheres drift to their places. */
void dem_clumps_drift(struct dem_clumps *, struct dem_particles *, const struct dem_domain *, double dt);

/* After the kick of particles over h [s], which leaves no valid velocities of these spheres: the same
   for bodies, with the contact forces in `contact` and gravity g [m/s2]. */
void dem_clumps_kick(struct dem_clumps *, struct dem_particles *, const double g[3], double h);

/* The same for a new sphere of a body that touches nothing, and its body, in the columns. */
void dem_clump_fall(struct dem_particles *, size_t i, const double g[3], double h);

/* Wrap the centre of the body of a particle along periodic axes. */
void dem_clump_wrap(const struct dem_domain *, const struct dem_particles *, size_t i);
