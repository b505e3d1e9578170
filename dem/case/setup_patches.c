/*
 * setup_patches.c -- patches of the program: their triangles and the fluid's velocity on each,
 * gathered from all ranks and given to the streams that enter through them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

struct dem_flow_patch *dem_sim_find_patch(const struct dem *d, const char *name)
{
    for (size_t k = 0; k < d->patches; k++)
    {
        if (strcmp(d->patch[k].name, name) == 0)
        {
            return &d->patch[k];
        }
    }
    return NULL;
}

int dem_sim_gather_patch(struct dem *d, int status, struct dem_flow_patch *patch, int64_t n,
                         const double *triangles, const double *velocity)
{
    double *mine = NULL, *all;    /* 12 numbers a triangle, as in struct dem_flow_patch */
    size_t total;

    status = status ? status : DEM_NEW(mine, 12*(size_t)n + 1);
    for (size_t t = 0; !status && t < (size_t)n; t++)
    {
        memcpy(mine + 12*t, triangles + 9*t, 9*sizeof *mine);
        if (velocity)
        {
            memcpy(mine + 12*t + 9, velocity + 3*t, 3*sizeof *mine);
        }
    }
    status = dem_sim_gather(&d->state, status, 12, (size_t)n, mine, &all, &total);
    dem_memory_free(mine);
    DEM_TRY(status);
    dem_memory_free(patch->triangles);
    patch->triangles = all;
    patch->n = total;
    return DEM_OK;
}

int dem_sim_give_patch(struct dem *d, const struct dem_flow_patch *patch)
{
    double *corners = NULL, *velocity = NULL;
    int status = DEM_NEW(corners, 9*patch->n + 1);

    status = status ? status : DEM_NEW(velocity, 3*patch->n + 1);
    for (size_t t = 0; t < patch->n && !status; t++)
    {
        memcpy(corners + 9*t, patch->triangles + 12*t, 9*sizeof *corners);
        memcpy(velocity + 3*t, patch->triangles + 12*t + 9, 3*sizeof *velocity);
    }
    for (int k = 0; k < d->scene.streams.streams && !status; k++)
    {
        struct dem_inlet_shape *const m = &d->scene.streams.stream[k].inlet;

        if (m->patch && strcmp(m->patch, patch->name) == 0)
        {
            status = dem_inlet_shape_set_triangles(m, patch->n, corners, velocity);
        }
    }
    dem_memory_free(corners);
    dem_memory_free(velocity);
    return status;
}

int dem_sim_assign_patches(struct dem *d)
{
    d->scene.streams.meshed = d->flow_on_request;
    for (size_t k = 0; k < d->patches; k++)
    {
        DEM_TRY(dem_sim_give_patch(d, &d->patch[k]));
    }
    return DEM_OK;
}
