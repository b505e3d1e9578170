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
#include "device/device_internal.h"
#include "ranks/agree.h"
#include <math.h>

static size_t count_sent(const struct dem_halo *h)
{
    return h->send_ranks > 0 ? h->send[DEM_HALO_NEEDED].start[h->send_ranks] : 0;
}

static size_t count_received(const struct dem_halo *h)
{
    return h->receive_ranks > 0 ? h->receive[DEM_HALO_NEEDED].start[h->receive_ranks] : 0;
}

static size_t width_of(const struct dem_state *state)
{
    return DEM_HALO_WIDTH + (size_t)state->particles.ghost_step.n;
}

int dem_device_put_ghosts(struct dem_device *d, const struct dem_halo *h)
{
    DEM_TRY(dem_opencl_put(d->cl, &d->ghosts_out, count_sent(h)*sizeof(uint32_t),
                           h->send[DEM_HALO_NEEDED].index));
    return dem_opencl_put(d->cl, &d->ghosts_in, count_received(h)*sizeof(uint32_t),
                          h->receive[DEM_HALO_NEEDED].index);
}

static int pack(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_halo *const h = &state->halo;
    struct dem_opencl_kernel *const k = d->pack_ghosts;
    const size_t sent = count_sent(h), bytes = (sent*width_of(state) + 1)*sizeof(double);

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
    *fastest = status ? INFINITY : h->send_buffer[count_sent(h)*width_of(state)];
    /* a rank that has failed sends what is there: the others wait for it */
    dem_halo_post(h, DEM_HALO_NEEDED, (int)width_of(state));
    status = dem_agree_max(state, status, fastest, 1);
    dem_halo_wait(h);
    return status;
}

int dem_device_receive_ghosts(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_halo *const h = &state->halo;
    struct dem_opencl_kernel *const k = d->unpack_ghosts;
    const size_t received = count_received(h);

    DEM_TRY(dem_opencl_put(d->cl, &d->ghosts, received*width_of(state)*sizeof(double), h->receive_buffer));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 0, &d->batch));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 1, (uint32_t)received));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 2, &d->record, &d->columns, &d->ghosts_in, &d->ghosts));
    return dem_opencl_launch(d->cl, k, received);
}
