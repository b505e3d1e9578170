/*
 * inflow_api.c -- streams and outlets on patches of a mesh, driven by the program between two
 * advances.
 *
 * A patch is the list of its triangles and of the fluid's velocity on each, gathered from all ranks
 * and handed to the streams that enter through it. Particles that the program has seen leave are
 * removed in the next dem_flow_apply.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/internal.h"
#include "core/error.h"
#include "core/memory.h"
#include <fenv.h>
#include <stdio.h>
#include <string.h>

int dem_flow_on_request(struct dem *d)
{
    DEM_TRY(dem_api_require_unchecked(d, "dem_flow_on_request"));
    d->flow_on_request = 1;
    return DEM_OK;
}

static int find_patch(struct dem *d, const char *name, struct dem_flow_patch **patch)
{
    size_t k = 0;

    while (k < d->patches && strcmp(d->patch[k].name, name) != 0)
    {
        k++;
    }
    if (k == d->patches)
    {
        DEM_REQUIRE(!d->checked, DEM_ERROR_STATE,
                    "dem_flow_patch: patch %s is new; it comes before dem_check", name);
        DEM_REQUIRE(strlen(name) < sizeof d->patch->name, DEM_ERROR_INPUT,
                    "patch %s: a name longer than %zu characters; shorten it", name,
                    sizeof d->patch->name - 1);
        DEM_TRY(DEM_GROW(d->patch, d->patch_capacity, d->patches + 1));
        snprintf(d->patch[d->patches++].name, sizeof d->patch->name, "%s", name);
    }
    *patch = &d->patch[k];
    return DEM_OK;
}

int dem_flow_patch(struct dem *d, const char *name, int64_t n, const double *triangles,
                   const double *velocity)
{
    struct dem_flow_patch *patch = NULL;
    double *mine = NULL, *all;    /* 12 numbers a triangle, as in struct dem_flow_patch */
    size_t total;
    int status = dem_api_require_count("dem_flow_patch", "triangles", n);

    status = status ? status : find_patch(d, name, &patch);
    status = status ? status : DEM_NEW(mine, 12*(size_t)n + 1);
    for (size_t t = 0; t < (size_t)n && !status; t++)
    {
        memcpy(mine + 12*t, triangles + 9*t, 9*sizeof *mine);
        if (velocity)
        {
            memcpy(mine + 12*t + 9, velocity + 3*t, 3*sizeof *mine);
        }
    }
    status = dem_api_gather(&d->state, status, 12, (size_t)n, mine, &all, &total);
    dem_memory_free(mine);
    DEM_TRY(status);
    dem_memory_free(patch->triangles);
    patch->triangles = all;
    patch->n = total;
    return d->checked ? dem_api_agree(d, dem_api_give_patch(d, patch)) : DEM_OK;
}

int dem_flow_remove(struct dem *d, const char *patch, int64_t n, const int64_t *id)
{
    const struct dem_streams *const s = &d->scene.streams;
    int outlet = 0;

    while (outlet < s->outlets
           && !(s->outlet[outlet].patch && strcmp(s->outlet[outlet].patch, patch) == 0))
    {
        outlet++;
    }
    DEM_REQUIRE(outlet < s->outlets, DEM_ERROR_INPUT,
                "dem_flow_remove: patch %s is no outlet of the scene; add outlets { NAME { patch "
                "%s; } }",
                patch, patch);
    DEM_TRY(dem_api_require_count("dem_flow_remove", "ids", n));
    for (int64_t k = 0; k < n; k++)
    {
        DEM_TRY(DEM_GROW(d->outgoing, d->outgoing_capacity, d->outgoing_count + 1));
        d->outgoing[d->outgoing_count++] =
            (struct dem_outgoing_particle){.id = id[k], .flow = s->streams + outlet};
    }
    return DEM_OK;
}

int dem_flow_apply(struct dem *d, int *changed)
{
    fenv_t caller;

    DEM_REQUIRE(d->is_set_up && d->flow_on_request, DEM_ERROR_STATE, "dem_flow_apply comes after "
                "dem_setup, and dem_flow_on_request before it");
    DEM_REQUIRE(!d->state.window.half_step_ahead, DEM_ERROR_STATE,
                "dem_flow_apply comes between two advances");
    DEM_TRY(dem_api_require_sound(d, "dem_flow_apply"));
    feholdexcept(&caller);
    const int status =
        dem_flows_between_windows(&d->state, d->outgoing_count, d->outgoing, changed);

    fesetenv(&caller);
    d->outgoing_count = 0;
    return status;
}
