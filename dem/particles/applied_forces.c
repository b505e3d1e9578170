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

/* Binary search: is one of `n` ids from `id` on in the list? */
static int has_id(const struct dem_applied_force *f, int64_t id, int64_t n)
{
    size_t from = 0, to = f->count;

    while (from < to)
    {
        const size_t middle = from + (to - from)/2;

        from = f->ids[middle] < id ? middle + 1 : from;
        to = f->ids[middle] < id ? to : middle;
    }
    return from < f->count && f->ids[from] - id < n;
}

static int acts(const struct dem_applied_force *f, const double x[3], int64_t id, int64_t n, int material, double time)
{
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= x[k] >= f->min[k] && x[k] < f->max[k];
    }
    return time >= f->start && time < f->end && inside
        && (f->material < 0 || f->material == material) && (!f->ids || has_id(f, id, n));
}

/* Add the forces of the scene; 1 if there are any. */
static int add_scene(const struct dem_applied_forces *a, const struct dem_domain *d, const double x[3],
                     int64_t id, int64_t n, int material, double time, double force[3],
                     double torque[3])
{
    struct dem_particle centre = {.radius = 0.0};
    int any = 0;

    memcpy(centre.x, x, sizeof centre.x);
    dem_domain_wrap(d, &centre);
    for (int f = 0; f < a->n; f++)
    {
        if (acts(&a->force[f], centre.x, id, n, material, time))
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

int dem_applied_forces_ask(struct dem_applied_forces *a, const struct dem_particles *p,
                           const double period[3], double time)
{
    struct dem_program_forces *const g = &a->program;
    struct dem_view view;

    DEM_TRY(DEM_GROW(g->force, g->capacity, 3*p->n + 1));
    DEM_TRY(DEM_GROW(g->torque, g->torque_capacity, 3*p->n + 1));
    memset(g->force, 0, 3*p->n*sizeof *g->force);
    memset(g->torque, 0, 3*p->n*sizeof *g->torque);
    dem_particles_view(p, period, &view);
    g->worked = 1;
    g->add(g->self, time, &view, g->force, g->torque);
    return DEM_OK;
}

int dem_applied_forces_at(const struct dem_applied_forces *a, const struct dem_domain *d,
                          const struct dem_particles *all, size_t i, double time, double force[3],
                          double torque[3])
{
    const struct dem_particle *const p = &all->record[i];
    const int moves = p->inverse_mass > 0.0 && !p->body;
    int any = a->program.add && moves;

    for (int k = 0; k < 3; k++)
    {
        force[k] = any ? a->program.force[3*i + (size_t)k] : 0.0;
        torque[k] = any ? a->program.torque[3*i + (size_t)k] : 0.0;
    }
    if (moves && a->n > 0)
    {
        any |= add_scene(a, d, p->x, p->id, 1, p->material, time, force, torque);
    }
    return any;
}

void dem_applied_forces_on_clump(const struct dem_applied_forces *a, const struct dem_domain *d,
                                 const double x[3], int64_t id, int64_t spheres, int material,
                                 double time, double force[3], double torque[3])
{
    memset(force, 0, 3*sizeof *force);
    memset(torque, 0, 3*sizeof *torque);
    (void)add_scene(a, d, x, id, spheres, material, time, force, torque);
}
