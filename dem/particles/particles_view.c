/*
 * particles_view.c -- views of the particles: addresses of their records and columns, and arrays
 * that a view keeps while the particles go on in others.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/particles.h"
#include "core/memory.h"
#include <string.h>

void dem_particles_view(const struct dem_particles *p, const double period[3], struct dem_view *v)
{
    const struct dem_particle *const r = p->record;

    *v = (struct dem_view){0};
    if (!r)
    {
        return;
    }
    *v = (struct dem_view){.n = p->n,
                           .stride = sizeof *r,
                           .position = r->x,
                           .velocity = r->v,
                           .spin = r->w,
                           .radius = &r->radius,
                           .mass = &r->mass,
                           .id = &r->id,
                           .material = &r->material,
                           .flags = &r->flags,
                           .force = dem_column(p, DEM_COLUMN_FORCE),
                           .torque = dem_column(p, DEM_COLUMN_TORQUE),
                           .orientation = dem_column(p, DEM_COLUMN_ORIENTATION),
                           .clump = dem_column(p, DEM_COLUMN_CLUMP) ? &r->body : NULL};
    memcpy(v->period, period, sizeof v->period);
}

int dem_particles_leave(struct dem_particles *p, struct dem_view_arrays *was)
{
    static const enum dem_column_name shown[3] = {DEM_COLUMN_FORCE, DEM_COLUMN_TORQUE,
                                                  DEM_COLUMN_ORIENTATION};
    void **const to[3] = {&was->force, &was->torque, &was->orientation};
    double *copy[3] = {NULL, NULL, NULL};
    struct dem_particle *record = NULL;
    int status = DEM_NEW(record, p->capacity);

    for (int k = 0; k < 3 && !status; k++)
    {
        const struct dem_column *const c = &p->column[shown[k]];

        status = c->data ? DEM_NEW(copy[k], p->capacity*(size_t)c->width) : DEM_OK;
    }
    if (status)
    {
        dem_memory_free(record);
        for (int k = 0; k < 3; k++)
        {
            dem_memory_free(copy[k]);
        }
        return status;
    }
    memcpy(record, p->record, p->capacity*sizeof *record);
    was->record = p->record;
    p->record = record;
    for (int k = 0; k < 3; k++)
    {
        struct dem_column *const c = &p->column[shown[k]];

        if (c->data)
        {
            memcpy(copy[k], c->data, p->capacity*(size_t)c->width*sizeof *copy[k]);
        }
        *to[k] = c->data;
        c->data = copy[k];
    }
    return DEM_OK;
}
