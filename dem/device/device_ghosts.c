/*
 * device_ghosts.c -- the ghosts of other ranks in steps on devices (ghosts.cl): the device packs and unpacks,
 * the host sends and receives as halo_refresh.c does.
 *
 * Both owners of a pair compute it, as on the CPU. The ranks agree in each step on the largest speed, which
 * comes down with the ghosts, so that they use up their lists, and meet events, in the same step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "ranks/agree.h"
#include <math.h>

static size_t count_sent(const struct dem_halo *h, enum dem_halo_set set)
{
    return h->send_ranks > 0 ? h->send[set].start[h->send_ranks] : 0;
}

static size_t count_received(const struct dem_halo *h, enum dem_halo_set set)
{
    return h->receive_ranks > 0 ? h->receive[set].start[h->receive_ranks] : 0;
}

static size_t width_of(const struct dem_state *state)
{
    return DEM_HALO_WIDTH + (size_t)state->particles.ghost_step.n;
}

int dem_device_put_ghosts(struct dem_device *d, const struct dem_halo *h, enum dem_halo_set set)
{
    d->ghost_set = set;
    DEM_TRY(dem_opencl_put(d->cl, &d->ghosts_out, count_sent(h, set)*sizeof(uint32_t), h->send[set].index));
    return dem_opencl_put(d->cl, &d->ghosts_in, count_received(h, set)*sizeof(uint32_t),
                          h->receive[set].index);
}

static int pack(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_halo *const h = &state->halo;
    struct dem_opencl_kernel *const k = d->pack_ghosts;
    const size_t sent = count_sent(h, d->ghost_set), bytes = (sent*width_of(state) + 1)*sizeof(double);

    DEM_TRY(dem_opencl_reserve(d->cl, &d->ghosts, bytes));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 0, &d->batch, &d->report));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 2, s));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 3, (uint32_t)sent));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 4, &d->record, &d->columns, &d->ghosts_out, &d->ghosts));
    DEM_TRY(dem_opencl_launch(d->cl, k, sent + 1));
    return dem_opencl_read(d->cl, &d->ghosts, 0, bytes, h->send_buffer);
}

int dem_device_send_ghosts(struct dem_device *d, struct dem_state *state, uint32_t s, int status,
                           double *fastest)
{
    struct dem_halo *const h = &state->halo;

    status = status ? status : pack(d, state, s);
    *fastest = status ? INFINITY : h->send_buffer[count_sent(h, d->ghost_set)*width_of(state)];
    /* a rank that has failed sends what is there: the others wait for it */
    dem_halo_post(h, d->ghost_set, (int)width_of(state));
    status = dem_agree_max(state, status, fastest, 1);
    dem_halo_wait(h);
    return status;
}

int dem_device_receive_ghosts(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_halo *const h = &state->halo;
    struct dem_opencl_kernel *const k = d->unpack_ghosts;
    const size_t received = count_received(h, d->ghost_set);

    DEM_TRY(dem_opencl_put(d->cl, &d->ghosts, received*width_of(state)*sizeof(double), h->receive_buffer));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 0, &d->batch));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 1, (uint32_t)received));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 2, &d->record, &d->columns, &d->ghosts_in, &d->ghosts));
    return dem_opencl_launch(d->cl, k, received);
}

/* ---- with new lists ---------------------------------------------------------------------------- */

int dem_device_refresh_ghosts(struct dem_device *d, struct dem_state *state)
{
    const struct dem_device_batch b = {.particles = (uint32_t)state->particles.n,
                                       .column = (uint32_t)(state->particles.n + state->particles.ghosts)};
    double fastest;

    if (state->decomposition.ranks == 1)
    {
        return DEM_OK;
    }
    int status = dem_opencl_write(d->cl, &d->batch, 0, sizeof b, &b);

    status = status ? status : dem_device_put_ghosts(d, &state->halo, DEM_HALO_ALL);
    DEM_TRY(dem_agree(state, status));
    DEM_TRY(dem_device_send_ghosts(d, state, 0, DEM_OK, &fastest));
    return dem_device_receive_ghosts(d, state);
}

/* Which ghosts are in rows. */
static int mark_ghosts(struct dem_device *d, const struct dem_state *state)
{
    const size_t n = state->particles.ghosts;
    const struct dem_device_rows *const list = &d->list[d->at];
    struct dem_opencl_kernel *const k = d->of_lists[DEM_LISTS_NEEDED];

    DEM_TRY(dem_device_clear(d, &d->needed, n));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 0, list->walls));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 1, (uint32_t)state->particles.n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 2, &list->partners, &d->needed));
    DEM_TRY(dem_opencl_launch(d->cl, k, list->walls));
    DEM_TRY(DEM_GROW(d->word, d->words, n + 1));
    DEM_TRY(dem_opencl_read(d->cl, &d->needed, 0, n*sizeof *d->word, d->word));
    for (size_t g = 0; g < n; g++)
    {
        state->halo.needed_here[g] = d->word[g] != 0;
    }
    return DEM_OK;
}

int dem_device_select_ghosts(struct dem_device *d, struct dem_state *state)
{
    if (state->decomposition.ranks == 1)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_agree(state, mark_ghosts(d, state)));
    dem_halo_select_marked(&state->halo);
    return dem_agree(state, dem_device_put_ghosts(d, &state->halo, DEM_HALO_NEEDED));
}
