/*
 * applied_forces.c -- which prescribed forces act on a particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/applied_forces.h"
#include "core/memory.h"

void dem_applied_forces_free(struct dem_applied_forces *a)
{
    for (int k = 0; k < a->n; k++)
    {
        dem_memory_free(a->force[k].ids);
    }
    dem_memory_free(a->force);
    *a = (struct dem_applied_forces){.force = NULL};
}

/* Binary search. */
static int has_id(const struct dem_applied_force *f, int64_t id)
{
    size_t from = 0, to = f->count;

    while (from < to)
    {
        const size_t middle = from + (to - from)/2;

        if (f->ids[middle] == id)
        {
            return 1;
        }
        from = f->ids[middle] < id ? middle + 1 : from;
        to = f->ids[middle] < id ? to : middle;
    }
    return 0;
}

static int acts(const struct dem_applied_force *f, const struct dem_particle *p, double time)
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= p->x[k] >= f->min[k] && p->x[k] < f->max[k];
    }
    return time >= f->start && time < f->end && inside
        && (f->material < 0 || f->material == p->material) && (!f->ids || has_id(f, p->id));
}

int dem_applied_forces_at(const struct dem_applied_forces *a, const struct dem_particle *p,
                          double time, double force[3], double torque[3])
{
    int any = 0;

    for (int k = 0; k < 3; k++)
    {
        force[k] = torque[k] = 0.0;
    }
    for (int f = 0; f < a->n && p->inverse_mass > 0.0; f++)
    {
        if (acts(&a->force[f], p, time))
        {
            any = 1;
            for (int k = 0; k < 3; k++)
            {
                force[k] += a->force[f].force[k];
                torque[k] += a->force[f].torque[k];
            }
        }
    }
    return any;
}
