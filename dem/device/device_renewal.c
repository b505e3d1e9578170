/*
 * device_renewal.c -- when lists are used up: measure displacements, and have the device make new lists.
 *
 * With several ranks the host holds more ghosts and triangles than its own lists need, so that they serve many
 * lists of the device. When particles or walls have moved too far for that, the host makes the next step, in
 * which it finds new ones.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "device/device_internal.h"
#include "ranks/agree.h"
#include <math.h>

/* 1 when the ghosts and triangles of this rank suffice for lists with the skin: partners within a gap now were
   within the gap plus both displacements when the host found them. */
static int ghosts_suffice(const struct dem_state *state, const struct dem_device_progress *p)
{
    return state->decomposition.ranks == 1 ||
           state->pairs.reach + p->skin + p->before + fmax(p->before, p->walls_before) <= state->halo.reach;
}

/* Walls and images for new lists. *end: 1 when the host has to make the next step. */
static int begin_lists(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps,
                       struct dem_device_progress *p, int changed, int *end)
{
    static const double at_rest[3] = {0.0, 0.0, 0.0};
    struct dem_device_batch next = {.first = steps->first + steps->made};
    uint32_t one = 1;

    /* to the position of the next step, whose lists these are */
    DEM_TRY(dem_device_move_walls(d, state, steps, &next, &one, p->skin, 0));
    p->walls_before += dem_walls_max_displacement(&state->walls, DEM_LIST_OUTER, at_rest);
    *end = one == 0;
    if (!*end && !ghosts_suffice(state, p))
    {
        dem_request_rebuild(state);
        *end = 1;
    }
    if (*end)
    {
        return DEM_OK;
    }
    DEM_TRY(changed ? DEM_OK : dem_device_keep_images(d));
    if (state->walls.periodic)
    {
        DEM_TRY(dem_device_wrap_walls(d, state));
        DEM_TRY(dem_device_move_walls(d, state, steps, &next, &one, p->skin, 0));
    }
    for (enum dem_list l = 0; l < DEM_LISTS; l++)
    {
        dem_walls_reset_marks(&state->walls, l);
    }
    return DEM_OK;
}

int dem_device_new_lists(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps,
                         struct dem_device_progress *p, int changed, int *end)
{
    p->skin = dem_device_skin(d, d->last_speed, state->dt);
    p->before += p->moved;
    DEM_TRY(dem_agree(state, begin_lists(d, state, steps, p, changed, end)));
    if (*end)
    {
        return DEM_OK;
    }
    int status = dem_device_refresh_ghosts(d, state);

    status = status ? status : dem_device_make_lists(d, state, p->skin, end);
    double outside = *end;

    DEM_TRY(dem_agree_max(state, status, &outside, 1));
    *end = outside > 0.0;
    DEM_TRY(dem_device_select_ghosts(d, state));
    p->moved = 0.0;
    p->rest = 0.5*p->skin;
    return DEM_OK;
}

int dem_device_renew_lists(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps,
                           struct dem_device_progress *p, int *end)
{
    const int status = dem_device_displacement(d, state, &p->moved);

    DEM_TRY(dem_agree_max(state, status, &p->moved, 1));
    /* half of them are left: go on */
    return p->moved <= 0.5*p->rest ? DEM_OK : dem_device_new_lists(d, state, steps, p, 0, end);
}
