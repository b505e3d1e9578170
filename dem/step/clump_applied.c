/*
 * clump_applied.c -- forces of the scene and of the program on rigid bodies of several spheres (clump_applied.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_applied.h"
#include "core/vec.h"
#include <string.h>

/* To the row of a sphere with this arm, and to the sum of its body. */
static void add(double contact[8], struct dem_clump_applied *sum, const double arm[3], const double force[3],
                const double torque[3])
{
    double moment[3];

    dem_vec_cross(arm, force, moment);
    for (int a = 0; a < 3; a++)
    {
        contact[a] += force[a];
        contact[4 + a] += torque[a];
        sum->force[a] += force[a];
        sum->torque[a] += moment[a] + torque[a];
    }
}

/* At the centre: at the first sphere, with the moment that this lacks. */
static void add_scene(struct dem_clumps *c, const struct dem_particles *p, const struct dem_applied_forces *forces,
                      const struct dem_domain *d, double time, size_t body, const struct dem_clump *b)
{
    const size_t spheres = c->start[body + 1] - c->start[body], i = c->member[c->start[body]];
    const struct dem_particle *const first = &p->record[i];
    double force[3], torque[3], arm[3], moment[3];

    dem_applied_forces_on_clump(forces, d, b->x, first->id, (int64_t)spheres, first->material, time, force,
                                torque);
    dem_clumps_arm(c, body, 0, arm);
    dem_vec_cross(arm, force, moment);
    for (int a = 0; a < 3; a++)
    {
        torque[a] -= moment[a];
    }
    add(c->contact[i], &c->applied[body], arm, force, torque);
}

void dem_clump_applied_add(struct dem_clumps *c, const struct dem_particles *p,
                           const struct dem_applied_forces *forces, const struct dem_domain *d, double time)
{
    for (size_t body = 0; body < c->n; body++)
    {
        struct dem_clump_applied *const sum = &c->applied[body];
        struct dem_clump b;

        memset(sum, 0, sizeof *sum);
        if (dem_clumps_frozen(c, body, p))
        {
            continue;
        }
        dem_clumps_body(c, body, p, &b);
        memcpy(sum->v, b.v, sizeof sum->v);
        memcpy(sum->momentum, b.momentum, sizeof sum->momentum);
        if (forces->n > 0)
        {
            add_scene(c, p, forces, d, time, body, &b);
        }
        for (size_t k = c->start[body]; k < c->start[body + 1] && forces->program.add; k++)
        {
            const size_t i = c->member[k];
            double arm[3];

            dem_clumps_arm(c, body, k - c->start[body], arm);
            add(c->contact[i], sum, arm, forces->program.force + 3*i, forces->program.torque + 3*i);
        }
    }
}

void dem_clump_applied_work(const struct dem_clumps *c, const struct dem_particles *p, struct dem_energy_balance *l,
                            double h)
{
    for (size_t body = 0; body < c->n; body++)
    {
        const struct dem_clump_applied *const of = &c->applied[body];
        struct dem_clump mean;
        double w[3];

        if (dem_clumps_frozen(c, body, p))
        {
            continue;
        }
        dem_clumps_body(c, body, p, &mean);
        for (int a = 0; a < 3; a++)
        {
            mean.v[a] = 0.5*(of->v[a] + mean.v[a]);
            mean.momentum[a] = 0.5*(of->momentum[a] + mean.momentum[a]);
        }
        dem_clump_spin(&mean, w);
        dem_energy_balance_add(&l->sum[DEM_ENERGY_BALANCE_APPLIED],
                               h*(dem_vec_dot(of->force, mean.v) + dem_vec_dot(of->torque, w)));
    }
}
