/*
 * setup_patches.c -- give the triangles of patches to the streams that enter through them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/internal.h"
#include "core/error.h"
#include "core/memory.h"
#include <string.h>

int dem_api_give_patch(struct dem *d, const struct dem_flow_patch *patch)
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

int dem_api_assign_patches(struct dem *d)
{
    d->scene.streams.meshed = d->flow_on_request;
    for (size_t k = 0; k < d->patches; k++)
    {
        DEM_TRY(dem_api_give_patch(d, &d->patch[k]));
    }
    return DEM_OK;
}
