/*
 * device_walls.c -- frames of moving walls in the steps of a batch, and how far particles may move
 * until the lists are used up, which depends on how far walls have moved.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include <math.h>

static double time_of(const struct dem_state *state, int64_t step)
{
    return state->window.start + (double)step*state->dt;
}

/* Displacement [m] that a particle may have in this position of the walls. skin: of lists of the
   device [m], 0: of the host's. */
static double rest_of_lists(const struct dem_state *state, const struct dem_device_steps *steps,
                            double skin)
{
    static const double at_rest[3] = {0.0, 0.0, 0.0};

    return skin == 0.0
               ? steps->rest(state)
               : fmin(0.5*skin, skin - dem_walls_max_displacement(&state->walls, DEM_LIST_OUTER,
                                                                  at_rest));
}

/* The frames and limits of the n steps of a batch. *n is less when a wall moves too fast for the
   device. */
int dem_device_move_walls(struct dem_device *d, struct dem_state *state,
                          const struct dem_device_steps *steps, struct dem_device_batch *batch,
                          uint32_t *n, double skin, int next)
{
    struct dem_walls *const w = &state->walls;
    const size_t frames = (size_t)w->frames;
    float limit = INFINITY;

    batch->frames = (uint32_t)frames;
    DEM_TRY(DEM_GROW(d->frame, d->frames_capacity, frames*(*n + 1) + 1));
    if (frames > 0)
    {
        /* where they are before the first step: an earlier batch may have moved them further */
        dem_walls_move(w, time_of(state, batch->first - 1), state->dt);
    }
    for (uint32_t s = 0; s < *n + (uint32_t)(next && frames > 0); s++)
    {
        if (frames > 0)
        {
            dem_walls_move(w, time_of(state, batch->first + s), state->dt);
        }
        for (size_t k = 0; k < frames; k++)
        {
            d->frame[s*frames + k] = (struct dem_device_frame){
                .pose = w->frame[k].pose, .displacement = w->frame[k].displacement};
        }
        if (s == *n)
        {
            break;
        }
        *n = w->displacement <= steps->max_displacement ? *n : s;
        /* a margin for rounding to float */
        limit = fminf(limit, (float)(rest_of_lists(state, steps, skin)*(1.0 - 1e-6)));
        batch->limit[s] = limit;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->frames, frames*(DEM_DEVICE_BATCH + 1)*sizeof *d->frame));
    return dem_opencl_write(d->cl, &d->frames, 0, frames*(*n + (uint32_t)next)*sizeof *d->frame, d->frame);
}

/* Leave the walls where they are in the last step made, or in the first, which the host makes. */
void dem_device_leave_walls(struct dem_state *state, const struct dem_device_steps *steps)
{
    const int64_t last = steps->first + (steps->made > 0 ? steps->made - 1 : 0);

    for (int64_t step = last - 1; state->walls.frames > 0 && step <= last; step++)
    {
        dem_walls_move(&state->walls, time_of(state, step), state->dt);
    }
}
