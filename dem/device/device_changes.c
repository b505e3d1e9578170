/*
 * device_changes.c -- particles that enter or leave (streams, outlets, sides of the domain) while the
 * device has the state.
 *
 * In a step that checks them the records come down, and the host decides; some such steps it makes itself
 * (step/steps_on_device.c). If particles enter or
 * leave, the columns come down too, the host changes the particles, and all go up again. Rows and
 * history stay on the device: new lists follow, which find the old rows of a particle through its
 * former place.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "ranks/agree.h"

/* The place that each particle had among the n with these ids; UINT32_MAX: it is new. Those that stay keep
   their order. */
static int put_places(struct dem_device *d, const struct dem_state *state, const int64_t *id, size_t n)
{
    const struct dem_particles *const p = &state->particles;
    size_t at = 0;

    DEM_TRY(DEM_GROW(d->word, d->words, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        size_t k = at;

        while (k < n && id[k] != p->record[i].id)
        {
            k++;
        }
        d->word[i] = k < n ? (uint32_t)k : UINT32_MAX;
        at = k < n ? k + 1 : n;    /* new ones are behind all others */
    }
    d->renumbered = 1;
    return dem_opencl_put(d->cl, &d->former_place, p->n*sizeof *d->word, d->word);
}

static int change(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps)
{
    const size_t n = state->particles.n;
    int64_t *id;

    DEM_TRY(dem_device_keep_images(d));
    DEM_TRY(dem_device_get_particles(d, state));
    DEM_TRY(DEM_NEW(id, n + 1));
    for (size_t i = 0; i < n; i++)
    {
        id[i] = state->particles.record[i].id;
    }
    int status = steps->change(state);

    status = status ? status : put_places(d, state, id, n);
    dem_memory_free(id);
    return status ? status : dem_device_put_particles(d, state);
}

int dem_device_check(struct dem_device *d, struct dem_state *state,
                     const struct dem_device_steps *steps, double skin, int *changes, int *end)
{
    const int64_t number = state->steps;
    const double time = state->time;
    struct dem_device_batch next = {.first = steps->first + steps->made};
    uint32_t one = 1;

    *changes = 0;
    if (steps->check == 0 || (number + steps->made)%steps->check != 0)
    {
        return DEM_OK;
    }
    /* the walls of this step; a wall that moves too fast is the host's */
    int status = dem_device_move_walls(d, state, steps, &next, &one, skin, 0);

    status = status ? status
                    : dem_opencl_read(d->cl, &d->record, 0,
                                      state->particles.n*sizeof *state->particles.record,
                                      state->particles.record);
    DEM_TRY(dem_agree(state, status));
    *end = one == 0;
    if (*end)
    {
        return DEM_OK;
    }
    state->steps += steps->made;
    state->time = state->window.start + (double)next.first*state->dt;
    status = steps->enter_or_leave(state, changes, end);
    status = status || !*changes ? status : change(d, state, steps);
    state->steps = number;
    state->time = time;
    return status;
}
