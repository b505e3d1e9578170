/*
 * device_window.c -- contacts that stay on the device from one coupling window to the next.
 *
 * The device makes the last step of a window, too. The host gets the particles and the sums of their contact forces,
 * which the first half kick of the next window needs. It has no contact rows then, though its lists count as valid
 * (dem_state.contacts_on_device), and its ghosts belong to the device's lists. dem_device_return_contacts brings the
 * history back, as saved history: before a snapshot, a hash, an edit or arrivals and departures between windows
 * (dem/run), and in a step that the host makes (neighbor_update.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "ranks/agree.h"
#include "records/energy_balance.h"
#include "records/wall_statistics.h"
#include <math.h>
#include <string.h>

/* Energies, bonds and rows of all contacts are read on the host after that step, and so is the work of walls that
   move or are curved, as wall_statistics.c sums it. */
int dem_device_makes_last_step(const struct dem_state *state)
{
    return state->device->keeps && dem_column(&state->particles, DEM_COLUMN_FLUID_VELOCITY) &&
           !state->energy_balance->open && !state->contacts.forces.has_energy && !state->contacts.forces.all_rows &&
           state->walls.frames == 0 && state->walls.all_flat_static;
}

int dem_device_keep(struct dem_state *state)
{
    /* forces on walls come from the device in these sums only */
    DEM_TRY(state->wall_statistics->sum ? DEM_OK
                                        : dem_wall_statistics_begin(state->wall_statistics, state->walls.walls));
    state->device->keeps = 1;
    return DEM_OK;
}

/* ---- after the last step ------------------------------------------------------------------------ */

/* Forces and torques of contacts, and how many there are, from two double4 a particle. */
static int get_contact_sums(struct dem_device *d, struct dem_state *state)
{
    struct dem_particles *const p = &state->particles;
    double *const force = dem_column(p, DEM_COLUMN_FORCE), *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    double *sum;

    DEM_TRY(DEM_NEW(sum, 8*p->n + 1));
    const int status = dem_opencl_read(d->cl, &d->contact_sums, 0, 8*p->n*sizeof *sum, sum);

    for (size_t i = 0; !status && i < p->n; i++)
    {
        memcpy(force + 3*i, sum + 8*i, 3*sizeof *sum);
        memcpy(torque + 3*i, sum + 8*i + 4, 3*sizeof *sum);
        state->contacts.forces.touching += (int64_t)sum[8*i + 3];
    }
    dem_memory_free(sum);
    return status;
}

int dem_device_get_window(struct dem_device *d, struct dem_state *state)
{
    DEM_TRY(dem_device_get_particles(d, state));
    dem_device_drop_host_rows(&state->contacts);
    return get_contact_sums(d, state);
}

/* ---- forces on walls in the last step ----------------------------------------------------------- */

/* Add them, times `factor`, to the sums of each wall: the kernel multiplies by dt, as in a step that is not the last
   one of its window. */
static int sum_wall_forces(struct dem_device *d, struct dem_state *state, double factor, struct dem_binned_sum *to)
{
    struct dem_device_batch batch = {.dt = factor,
                                     .particles = (uint32_t)state->particles.n,
                                     .walls = d->list[d->at].walls,
                                     .limit = {INFINITY},
                                     .last = UINT32_MAX};
    const struct dem_device_report report = {.events = 0};

    DEM_TRY(dem_device_begin_sums(d, state, &batch));
    DEM_TRY(dem_opencl_write(d->cl, &d->batch, 0, sizeof batch, &batch));
    DEM_TRY(dem_opencl_write(d->cl, &d->report, 0, sizeof report, &report));
    DEM_TRY(dem_device_give_loads(d));
    DEM_TRY(dem_device_launch_loads(d, state, 0));
    return dem_device_add_sums(d, state, to);
}

int dem_device_kick_walls(struct dem_state *state, double kick)
{
    struct dem_wall_statistics *const b = state->wall_statistics;

    /* a backup may have saved them, summed and rounded; these are exact */
    dem_wall_statistics_drop_forces(b);
    return b->sum && kick > 0.0 ? sum_wall_forces(state->device, state, kick, b->sum) : DEM_OK;
}

int dem_device_save_wall_forces(struct dem_state *state)
{
    struct dem_wall_statistics *const b = state->wall_statistics;

    if (!state->contacts_on_device || b->saved)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(b->saved, b->walls + 1));
    for (int w = 0; w < b->walls; w++)
    {
        dem_binned_sum_clear(&b->saved[w]);
    }
    return sum_wall_forces(state->device, state, 1.0, b->saved);
}

/* ---- contacts back to the host ------------------------------------------------------------------ */

static int get_contacts(struct dem_state *state, int between)
{
    struct dem_device *const d = state->device;
    const int columns = state->contacts.history.columns;
    const int64_t touching = state->contacts.forces.touching;

    DEM_TRY(between ? dem_device_save_wall_forces(state) : DEM_OK);
    DEM_TRY(columns > 0 ? dem_device_clear_apart(d, columns) : DEM_OK);
    DEM_TRY(dem_device_get_saved(d, state, &d->list[d->at], state->walls.facet));
    state->contacts.forces.touching = touching;    /* the number outlives the rows */
    return DEM_OK;
}

int dem_device_return_contacts(struct dem_state *state, int between)
{
    return state->contacts_on_device ? dem_agree(state, get_contacts(state, between)) : DEM_OK;
}

/* ---- the backup --------------------------------------------------------------------------------- */

static int copy(struct dem_device *d, const struct dem_opencl_memory *from, struct dem_opencl_memory *to, size_t bytes)
{
    DEM_TRY(dem_opencl_reserve(d->cl, to, bytes));
    return dem_opencl_copy(d->cl, from, to, bytes);
}

/* Rows name facets by their place, and a rebuild may hold other triangles. */
static int copy_facets(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_walls *const w = &state->walls;

    if (d->backup.facet && d->backup.selections == state->wall_store.selections)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(d->backup.facet, d->backup.facets, (size_t)w->facets + 1));
    memcpy(d->backup.facet, w->facet, (size_t)w->facets*sizeof *w->facet);
    d->backup.selections = state->wall_store.selections;
    return DEM_OK;
}

int dem_device_backup(struct dem_state *state)
{
    struct dem_device *const d = state->device;

    d->backup.list.rows = 0;
    if (!state->contacts_on_device)
    {
        return DEM_OK;
    }
    struct dem_device_rows *const list = &d->list[d->at], *const to = &d->backup.list;
    const size_t rows = list->rows, columns = (size_t)state->contacts.history.columns,
                 ghosts = state->particles.ghosts;

    DEM_TRY(columns > 0 ? dem_device_clear_apart(d, (int)columns) : DEM_OK);
    DEM_TRY(copy(d, &list->partners, &to->partners, 2*rows*sizeof(uint32_t)));
    DEM_TRY(copy(d, &list->history, &to->history, columns*rows*sizeof(double)));
    DEM_TRY(copy(d, &list->near, &to->near, d->of_near ? 4*(rows - list->walls)*sizeof(uint32_t) : 0));
    DEM_TRY(DEM_GROW(d->backup.ghost, d->backup.capacity, ghosts + 1));
    memcpy(d->backup.ghost, state->particles.record + state->particles.n, ghosts*sizeof *d->backup.ghost);
    d->backup.ghosts = ghosts;
    DEM_TRY(copy_facets(d, state));
    to->walls = list->walls;
    to->rows = list->rows;
    return DEM_OK;
}

int dem_device_restore(struct dem_state *state)
{
    struct dem_device *const d = state->device;

    state->contacts_on_device = 0;
    if (d->backup.list.rows == 0)
    {
        return DEM_OK;
    }
    const size_t n = state->particles.n;

    DEM_TRY(dem_particles_grow(&state->particles, n + d->backup.ghosts));
    memcpy(state->particles.record + n, d->backup.ghost, d->backup.ghosts*sizeof *d->backup.ghost);
    return dem_device_get_saved(d, state, &d->backup.list, d->backup.facet);
}
