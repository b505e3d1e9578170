/*
 * refusal.c -- what keeps the steps of a run from a device: the first thing that has no text there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/device_steps.h"
#include "device/program.h"
#include "device/shared.h"
#include <stdio.h>

static int refuse_effects(const struct dem_effect_list *list, char *why, size_t size)
{
    for (int k = 0; k < list->entries; k++)
    {
        const char *const reason = dem_device_effect_refusal(list->entry[k].effect);

        if (reason)
        {
            snprintf(why, size, "%s %s", list->entry[k].effect->name, reason);
            return 1;
        }
    }
    return 0;
}

static int refuse_laws(const struct dem_interaction_table *t, char *why, size_t size)
{
    int refused = refuse_effects(&t->bodies, why, size);

    for (int k = 0; k < t->classes && !refused; k++)
    {
        refused = refuse_effects(&t->list[k], why, size);
    }
    return refused;
}

static const char *wall_reason(const struct dem_wall *w)
{
    return w->follows_mesh                       ? "follows a mesh"
           : w->wear > 0.0                       ? "wears"
           : w->triangles > DEM_DEVICE_TRIANGLES ? "has more than 8 million triangles"
                                                 : NULL;
}

static int refuse_walls(const struct dem_walls *walls, char *why, size_t size)
{
    for (int k = 0; k < walls->walls; k++)
    {
        const char *const reason = dem_walls_body(walls, k) ? "is moved by force"
                                                            : wall_reason(&walls->wall[k]);

        if (reason)
        {
            snprintf(why, size, "wall %s %s", walls->wall[k].name, reason);
            return 1;
        }
    }
    return 0;
}

/* What else of the run a device cannot do. */
static const char *run_reason(const struct dem_state *state)
{
    const struct dem_particles *const p = &state->particles;

    return p->batch.n > 1                          ? "the fluid has scalars besides the viscosity"
           : dem_column(p, DEM_COLUMN_CLUMP)       ? "particles form clumps (shapes)"
           : state->cell.active                    ? "the cell deforms (domain/cell)"
           : state->walls.passing > 0              ? "walls come or go (from, until)"
                                                   : NULL;
}

void dem_device_refusal(const struct dem_state *state, char *why, size_t size)
{
    why[0] = '\0';
    if (refuse_laws(&state->interaction_table, why, size) || refuse_walls(&state->walls, why, size))
    {
        return;
    }
    const char *const reason = run_reason(state);

    if (reason)
    {
        snprintf(why, size, "%s", reason);
    }
}
