/*
 * applied_forces.c -- which prescribed forces act on a particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/applied_forces.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

void dem_applied_forces_free(struct dem_applied_forces *a)
{
    for (int k = 0; k < a->n; k++)
    {
        dem_memory_free(a->force[k].ids);
    }
    dem_memory_free(a->force);
    dem_memory_free(a->program.force);
    dem_memory_free(a->program.torque);
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

int dem_applied_forces_ask(struct dem_applied_forces *a, const struct dem_particles *p,
                           const double period[3], double time)
{
    struct dem_program_forces *const g = &a->program;
    struct dem_view view;

    if (!g->add)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(g->force, g->capacity, 3*p->n + 1));
    DEM_TRY(DEM_GROW(g->torque, g->torque_capacity, 3*p->n + 1));
    memset(g->force, 0, 3*p->n*sizeof *g->force);
    memset(g->torque, 0, 3*p->n*sizeof *g->torque);
    dem_particles_view(p, period, &view);
    g->worked = 1;
    g->add(g->self, time, &view, g->force, g->torque);
    return DEM_OK;
}

int dem_applied_forces_at(const struct dem_applied_forces *a, const struct dem_particles *all,
                          size_t i, double time, double force[3], double torque[3])
{
    const struct dem_particle *const p = &all->record[i];
    int any = a->program.add && p->inverse_mass > 0.0;

    for (int k = 0; k < 3; k++)
    {
        force[k] = any ? a->program.force[3*i + (size_t)k] : 0.0;
        torque[k] = any ? a->program.torque[3*i + (size_t)k] : 0.0;
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
