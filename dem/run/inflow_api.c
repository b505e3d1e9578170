/*
 * inflow_api.c -- streams and outlets on patches of a mesh, driven by the program between two
 * advances.
 *
 * Particles that the program has seen leave are removed in the next dem_flow_apply.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_fluid.h"
#include "core/error.h"
#include "core/memory.h"
#include "device/device_steps.h"
#include <fenv.h>
#include <string.h>

int dem_flow_patch(struct dem *d, const char *name, int64_t n, const double *triangles,
                   const double *velocity)
{
    struct dem_flow_patch *const patch = dem_sim_find_patch(d, name);
    int status = dem_sim_require_count("dem_flow_patch", "triangles", n);

    status = status ? status
           : patch  ? DEM_OK
                    : dem_error(DEM_ERROR_INPUT, "dem_flow_patch: there is no patch %s of "
                                "dem_case_add_patch", name);
    DEM_TRY(dem_sim_gather_patch(d, status, patch, n, triangles, velocity));
    return dem_sim_agree(d, dem_sim_give_patch(d, patch));
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
    DEM_TRY(dem_sim_require_count("dem_flow_remove", "ids", n));
    for (int64_t k = 0; k < n; k++)
    {
        DEM_TRY(DEM_GROW(d->outgoing, d->outgoing_capacity, d->outgoing_count + 1));
        d->outgoing[d->outgoing_count++] =
            (struct dem_outgoing_particle){.id = id[k], .flow = s->streams + outlet};
    }
    return DEM_OK;
}

static int take_contacts_back(struct dem_state *state)
{
    return dem_device_return_contacts(state, 1);
}

int dem_flow_apply(struct dem *d, int *changed)
{
    fenv_t caller;

    DEM_REQUIRE(d->flow_on_request, DEM_ERROR_STATE, "dem_flow_apply: streams and outlets act in "
                "dem_advance; call dem_case_flows_on_request before dem_start");
    DEM_REQUIRE(!d->state.window.half_step_ahead, DEM_ERROR_STATE,
                "dem_flow_apply comes between two advances");
    DEM_TRY(dem_sim_require_sound(d, "dem_flow_apply"));
    feholdexcept(&caller);
    const int status =
        dem_flows_between_windows(&d->state, d->outgoing_count, d->outgoing, take_contacts_back, changed);

    fesetenv(&caller);
    d->outgoing_count = 0;
    return status;
}
