/*
 * applied_forces.h -- forces and torques that a scene prescribes for chosen particles, and those that
 * a function of the program gives in each step (dem_set_force).
 *
 * A particle is chosen by all conditions that are given: its id, its material, a box in which its
 * centre is, and the time; a clump by the id of any of its spheres, and its centre. A centre that
 * has crossed a periodic boundary since the last neighbor list counts at its image in the box. Nothing is
 * stored with particles, so choice and force are the same on any number of ranks and after a restart.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/domain.h"
#include "particles/particles.h"

struct dem_applied_force
{
    const char *name;            /* of its entry in the scene */
    double force[3], torque[3];  /* N, N m */
    double start, end;           /* s  from start on, before end */
    double min[3], max[3];       /* m  the centre lies between them; infinite: anywhere */
    int material;                /* -1: any */
    int64_t *ids;                /* in rising order; NULL: all */
    size_t count;
};

typedef void dem_force_function(void *self, double time, const struct dem_view *, double *force,
                                double *torque);

struct dem_program_forces        /* of dem_set_force */
{
    dem_force_function *add;     /* NULL: none */
    void *self;
    double *force, *torque;      /* N, N m  3 each, of the owned particles, as asked for last */
    size_t capacity, torque_capacity;
    int worked;                  /* 1: some forces have acted */
};

struct dem_applied_forces
{
    struct dem_applied_force *force;
    int n;
    int torques;                 /* 1: some torque is not zero */
    struct dem_program_forces program;
};

void dem_applied_forces_free(struct dem_applied_forces *);

/* 1 when there are any. */
static inline int dem_applied_forces_exist(const struct dem_applied_forces *a)
{
    return a->n > 0 || a->program.add;
}

/* Ask the program, which gives forces, for them at this time [s]; period: of dem_view. */
int dem_applied_forces_ask(struct dem_applied_forces *, const struct dem_particles *,
                           const double period[3], double time);

/* Force [N] and torque [N m] on owned particle i at this time [s]; 0 if there is none. Frozen
   particles have none, nor spheres of clumps. */
int dem_applied_forces_at(const struct dem_applied_forces *, const struct dem_domain *,
                          const struct dem_particles *, size_t i, double time, double force[3],
                          double torque[3]);

/* The same of the scene on a clump, at its centre x [m]; its spheres have the ids from `id` on. */
void dem_applied_forces_on_clump(const struct dem_applied_forces *, const struct dem_domain *,
                                 const double x[3], int64_t id, int64_t spheres, int material,
                                 double time, double force[3], double torque[3]);
