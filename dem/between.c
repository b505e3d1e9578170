/*
 * between.c -- what a program with a mesh and a fluid says of streams and outlets, between two advances.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "base/memory.h"
#include <fenv.h>
#include <stdio.h>
#include <string.h>

int dem_flow_between(struct dem *d)
{
    DEM_TRY(dem_door_early(d, "dem_flow_between"));
    d->between = 1;
    return DEM_OK;
}

static int to_streams(struct dem *d, const struct dem_patch *patch)
{
    double *corners, *flow;

    DEM_TRY(DEM_NEW(corners, 9*patch->n + 1));
    DEM_TRY(DEM_NEW(flow, 3*patch->n + 1));
    for (size_t t = 0; t < patch->n; t++)
    {
        memcpy(corners + 9*t, patch->triangles + 12*t, 9*sizeof *corners);
        memcpy(flow + 3*t, patch->triangles + 12*t + 9, 3*sizeof *flow);
    }
    for (int k = 0; k < d->scene.streams.streams; k++)
    {
        struct dem_mouth *const m = &d->scene.streams.stream[k].mouth;

        if (m->patch && strcmp(m->patch, patch->name) == 0)
        {
            DEM_TRY(dem_mouth_take(m, patch->n, corners, flow));
        }
    }
    dem_memory_free(corners);
    dem_memory_free(flow);
    return DEM_OK;
}

int dem_door_take_patches(struct dem *d)
{
    d->scene.streams.meshed = d->between;
    for (size_t k = 0; k < d->patches; k++)
    {
        DEM_TRY(to_streams(d, &d->patch[k]));
    }
    return DEM_OK;
}

static int find_patch(struct dem *d, const char *name, struct dem_patch **patch)
{
    size_t k = 0;

    while (k < d->patches && strcmp(d->patch[k].name, name) != 0)
    {
        k++;
    }
    if (k == d->patches)
    {
        DEM_REQUIRE(!d->checked, DEM_ERROR_STATE, "dem_patch: patch %s is new; it comes before dem_check", name);
        DEM_REQUIRE(strlen(name) < sizeof d->patch->name, DEM_ERROR_INPUT, "patch %s: a name longer than %zu letters; shorten it", name,
                    sizeof d->patch->name - 1);
        DEM_TRY(DEM_GROW(d->patch, d->patch_room, d->patches + 1));
        snprintf(d->patch[d->patches++].name, sizeof d->patch->name, "%s", name);
    }
    *patch = &d->patch[k];
    return DEM_OK;
}

int dem_patch(struct dem *d, const char *name, int64_t n, const double *triangles, const double *velocity)
{
    struct dem_patch *patch;
    double *mine;

    DEM_TRY(find_patch(d, name, &patch));
    DEM_TRY(DEM_NEW(mine, 12*(size_t)n + 1));
    for (size_t t = 0; t < (size_t)n; t++)
    {
        memcpy(mine + 12*t, triangles + 9*t, 9*sizeof *mine);
        if (velocity)
        {
            memcpy(mine + 12*t + 9, velocity + 3*t, 3*sizeof *mine);
        }
    }
    dem_memory_free(patch->triangles);
    patch->triangles = NULL;
    const int status = dem_door_gather(&d->parts, 12, (size_t)n, mine, &patch->triangles, &patch->n);

    dem_memory_free(mine);
    DEM_TRY(status);
    return d->checked ? to_streams(d, patch) : DEM_OK;
}

int dem_take_out(struct dem *d, const char *patch, int64_t n, const int64_t *id)
{
    const struct dem_streams *const s = &d->scene.streams;
    int outlet = 0;

    while (outlet < s->outlets && !(s->outlet[outlet].patch && strcmp(s->outlet[outlet].patch, patch) == 0))
    {
        outlet++;
    }
    DEM_REQUIRE(outlet < s->outlets, DEM_ERROR_INPUT, "dem_take_out: patch %s is no outlet of the scene; add outlets { NAME { patch %s; } }", patch,
                patch);
    for (int64_t k = 0; k < n; k++)
    {
        DEM_TRY(DEM_GROW(d->goer, d->goer_room, d->goers + 1));
        d->goer[d->goers++] = (struct dem_goer){.id = id[k], .flow = s->streams + outlet};
    }
    return DEM_OK;
}

int dem_let_through(struct dem *d, int *changed)
{
    fenv_t caller;

    DEM_REQUIRE(d->ready && d->between, DEM_ERROR_STATE, "dem_let_through comes after dem_ready, and dem_flow_between before it");
    DEM_REQUIRE(!d->parts.open, DEM_ERROR_STATE, "dem_let_through comes between two advances");
    feholdexcept(&caller);
    const int status = dem_flows_between(&d->parts, d->goers, d->goer, changed);

    fesetenv(&caller);
    d->goers = 0;
    return status;
}
