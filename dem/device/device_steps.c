/*
 * device_steps.c -- make steps on a device.
 *
 * A step is one kernel for contacts with facets, if there are several, one for each pair class and one
 * for the particles, in this order; the queue keeps it. After up to DEM_DEVICE_BATCH steps the host reads
 * a report. A step of which the lists might miss a contact is left out by the kernels themselves, and so
 * are all after it. Then displacements are measured, and lists are made anew if they are used up.
 *
 * Between coupling windows contacts may stay here (device_window.c).
 *
 * With several ranks the host exchanges the data of ghosts in each step, and all ranks make the same steps
 * (device_ghosts.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/device_steps.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "device/device_columns.h"
#include "device/device_internal.h"
#include "ranks/agree.h"
#include "records/wall_statistics.h"
#include <math.h>
#include <string.h>

enum
{
    LONGEST_WAIT = 255    /* steps that the host makes beyond an event that has come again */
};

/* ---- batches of steps -------------------------------------------------------------------------- */

/* All arguments but the number of the step, which is the third one. */
static int give_arguments(struct dem_device *d)
{
    struct dem_device_rows *const list = &d->list[d->at];

    DEM_TRY(dem_device_give_facets(d));
    DEM_TRY(dem_device_give_loads(d));
    for (int k = 0; k < d->classes; k++)
    {
        DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_rows[k], 0, &d->batch, &d->report));
        DEM_TRY(dem_opencl_give_number(d->cl, d->of_rows[k], 3, list->first[k]));
        DEM_TRY(dem_opencl_give_number(d->cl, d->of_rows[k], 4, list->count[k]));
        DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_rows[k], 5, &d->record, &list->partners, &d->shift,
                                &d->facets, &list->touch, &list->history, &d->force, &d->moment,
                                &d->energy, &d->frames, &d->columns, &d->drives, &d->contacts,
                                &d->conditions, &d->rates, &d->exact));
    }
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->bodies, 0, &d->batch, &d->report));
    return DEM_OPENCL_GIVE(d->cl, d->bodies, 3, &d->record, &list->touch, &d->force, &d->moment,
                           &d->energy, &list->start, &list->entry, &d->lost, &d->axes, &d->columns,
                           &d->rates, &d->applied, &d->ids, &d->exact, &d->contact_sums);
}

static int launch_step(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_device_rows *const list = &d->list[d->at];

    DEM_TRY(dem_device_launch_facets(d, state, s));
    for (int k = 0; k < d->classes; k++)
    {
        if (list->count[k] > 0)
        {
            DEM_TRY(dem_opencl_give_number(d->cl, d->of_rows[k], 2, s));
            DEM_TRY(dem_opencl_launch(d->cl, d->of_rows[k], list->count[k]));
        }
    }
    DEM_TRY(dem_device_launch_loads(d, state, s));
    DEM_TRY(dem_opencl_give_number(d->cl, d->bodies, 2, s));
    return dem_opencl_launch(d->cl, d->bodies, state->particles.n);
}

/* Copy what a batch changes; back: to where it was before the batch. */
static int copy_state(struct dem_device *d, const struct dem_state *state, int back)
{
    struct dem_device_rows *const list = &d->list[d->at];
    const size_t n = state->particles.n, all = n + state->particles.ghosts, rows = list->rows;
    const struct
    {
        struct dem_opencl_memory *now, *before;
        size_t bytes;
    } part[] = {{&d->record, &d->before_record, all*sizeof *state->particles.record},
                {&d->lost, &d->before_lost, n*sizeof(double)},
                {&d->columns, &d->before_columns,
                 all*dem_device_columns_width(&state->particles)*sizeof(double)},
                {&list->touch, &d->before_touch, rows},
                {&list->history, &d->before_history,
                 rows*(size_t)state->interaction_table.history_columns*sizeof(double)}};

    for (size_t k = 0; k < sizeof part/sizeof *part; k++)
    {
        DEM_TRY(dem_opencl_copy(d->cl, back ? part[k].before : part[k].now,
                                back ? part[k].now : part[k].before, part[k].bytes));
    }
    return DEM_OK;
}

static struct dem_device_batch batch_of(const struct dem_device *d, const struct dem_state *state,
                                        const struct dem_device_steps *steps,
                                        const struct dem_device_progress *p)
{
    const int64_t first = steps->first + steps->made, last = steps->last - first;

    return (struct dem_device_batch){
        .dt = state->dt,
        .inverse_dt = 1.0/state->dt,
        .max_dt = state->max_dt,
        .window_start = state->window.start,
        .window = state->window.length,
        .over_window = state->window.length > 0.0 ? 1.0/state->window.length : 0.0,
        .first = first,
        .first_of_all = steps->first,
        .number = state->steps + steps->made,
        .applied = (uint32_t)state->applied_forces.n,
        /* a margin for rounding: the host decides */
        .overlap_limit = state->limits.overlap_limit*(1.0 - 0x1p-20),
        .overlap = (float)state->limits.overlap,
        .start = (float)(p->moved*(1.0 + 1e-6)),
        .particles = (uint32_t)state->particles.n,
        .stride = d->list[d->at].rows,
        .column = (uint32_t)(state->particles.n + state->particles.ghosts),
        .walls = d->list[d->at].walls,
        .last = last >= 0 && last < DEM_DEVICE_BATCH ? (uint32_t)last : UINT32_MAX};
}

/* The steps of a batch, which the kernels leave out themselves when lists are used up. *made: how many. */
static int make_alone(struct dem_device *d, const struct dem_state *state,
                      const struct dem_device_batch *batch, uint32_t n, uint32_t *made)
{
    for (uint32_t s = 0; s < n; s++)
    {
        DEM_TRY(launch_step(d, state, s));
    }
    DEM_TRY(dem_opencl_read(d->cl, &d->report, 0, sizeof d->seen, &d->seen));
    for (*made = 0; *made < n && d->seen.bound[*made] <= batch->limit[*made]; ++*made)
    {
    }
    return DEM_OK;
}

/* The same with several ranks, which agree in each step, so that all of them make the same ones. */
static int make_together(struct dem_device *d, struct dem_state *state,
                         const struct dem_device_batch *batch, uint32_t n, uint32_t *made)
{
    float fastest[DEM_DEVICE_BATCH];
    double bound = (double)batch->start, largest = 0.0;
    int status = DEM_OK;

    for (*made = 0; *made < n && bound <= (double)batch->limit[*made] && largest < INFINITY; ++*made)
    {
        status = status ? status : launch_step(d, state, *made);
        DEM_TRY(dem_device_send_ghosts(d, state, *made, status, &largest));
        status = dem_device_receive_ghosts(d, state);
        fastest[*made] = (float)largest;
        bound += sqrt(largest)*(state->dt*1.0001);
    }
    DEM_TRY(dem_agree(state, status ? status
                                    : dem_opencl_read(d->cl, &d->report, 0, sizeof d->seen, &d->seen)));
    memcpy(d->seen.fastest, fastest, *made*sizeof *fastest);
    d->seen.events = largest == INFINITY;
    d->seen.event_step = *made > 0 ? *made - 1 : 0;
    return DEM_OK;
}

/* What a batch needs on the device, and a copy of the state before it. */
static int begin_batch(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps,
                       struct dem_device_batch *batch, const struct dem_device_progress *p, uint32_t *n)
{
    DEM_TRY(dem_device_move_walls(d, state, steps, batch, n, p->skin,
                                  dem_device_has_wall_work(state)));
    DEM_TRY(copy_state(d, state, 0));
    DEM_TRY(dem_device_begin_sums(d, state, batch));
    struct dem_device_batch there = *batch;

    for (uint32_t s = 0; s < *n && state->decomposition.ranks > 1; s++)
    {
        there.limit[s] = INFINITY;    /* make_together checks the limits, for all ranks at once */
    }
    DEM_TRY(dem_opencl_write(d->cl, &d->batch, 0, sizeof there, &there));
    DEM_TRY(dem_opencl_write(d->cl, &d->report, 0, sizeof d->seen, &d->seen));
    return give_arguments(d);
}

/* A batch of up to *n steps; *made: how many. Its report is in d->seen. */
static int make_batch(struct dem_device *d, struct dem_state *state,
                      const struct dem_device_steps *steps, struct dem_device_progress *p, uint32_t *n,
                      uint32_t *made)
{
    struct dem_device_batch batch = batch_of(d, state, steps, p);

    memset(&d->seen, 0, sizeof d->seen);
    d->seen.overlap = batch.overlap;
    d->seen.event_step = UINT32_MAX;
    /* a rank that fails here may lack the limits by which all make the same steps */
    DEM_TRY(dem_agree(state, begin_batch(d, state, steps, &batch, p, n)));
    DEM_TRY(state->decomposition.ranks > 1 ? make_together(d, state, &batch, *n, made)
                                           : make_alone(d, state, &batch, *n, made));
    p->rest = *n > 0 ? (double)batch.limit[*made < *n ? *made : *n - 1] : 0.0;
    return DEM_OK;
}

/* The speeds of a batch. Returns 1 when a drift between two steps was too fast for the device. The
   last drift of all is checked by the host, which has its positions then. */
static int add_speeds(struct dem_device *d, const struct dem_device_steps *steps, uint32_t made,
                      double dt, struct dem_device_progress *p)
{
    int fast = made > 0 && steps->made > 0 && !(d->last_speed <= steps->max_speed);

    for (uint32_t s = 0; s < made; s++)
    {
        const double speed = sqrt((double)d->seen.fastest[s]);

        fast |= s + 1 < made && !(speed <= steps->max_speed);
        d->speed[steps->made + s] = speed;
        p->moved += speed*dt;
    }
    return fast;
}

/* Steps of the next batch, whose first one has this number: as many as the lists are likely to allow,
   none behind a check. */
static uint32_t batch_size(const struct dem_device *d, const struct dem_device_steps *steps,
                           const struct dem_device_progress *p, double dt, int64_t first)
{
    const double rest = fmax(p->rest - p->moved, 0.0),
                 likely = d->last_speed > 0.0 ? 1.05*rest/(d->last_speed*dt) + 2.0
                                              : DEM_DEVICE_BATCH;

    const int64_t most = steps->most - steps->made,
                  check = steps->check ? steps->check - first%steps->check : most;

    return (uint32_t)fmin(fmin(likely, DEM_DEVICE_BATCH), (double)(check < most ? check : most));
}

/* One batch. *end: 1 when the host has to go on, from the state before the batch. */
static int advance_batch(struct dem_device *d, struct dem_state *state,
                         struct dem_device_steps *steps, struct dem_device_progress *p, int *end)
{
    const uint32_t wanted = batch_size(d, steps, p, state->dt, state->steps + steps->made);
    uint32_t n = wanted, made;

    DEM_TRY(make_batch(d, state, steps, p, &n, &made));
    const int fast = n < wanted || add_speeds(d, steps, made, state->dt, p);

    if (d->seen.events || fast)
    {
        const uint32_t until = fast || d->seen.event_step >= n ? n : d->seen.event_step + 1;

        *end = 1;
        /* state->steps is the first step's */
        d->host_until = state->steps + steps->made + until - 1 + d->wait;
        d->wait = d->wait < LONGEST_WAIT ? 2*d->wait + 1 : LONGEST_WAIT;
        d->counts.repeated += until;
        return dem_agree(state, copy_state(d, state, 1));
    }
    DEM_TRY(dem_agree(state, dem_device_add_sums(d, state, state->wall_statistics->sum)));
    d->wait = made > 0 ? 0 : d->wait;
    d->last_speed = made > 0 ? d->speed[steps->made + made - 1] : d->last_speed;
    steps->made += made;
    state->limits.overlap = fmax(state->limits.overlap, (double)d->seen.overlap);
    return DEM_OK;
}

/* Steps and lists, until all are made or the host has to go on. */
static int make_steps(struct dem_device *d, struct dem_state *state,
                      struct dem_device_steps *steps)
{
    struct dem_device_progress *const p = &d->progress;
    int end = 0;

    p->checked = 0;
    if (steps->last > 0 && !d->own)
    {
        /* contacts can stay here in lists made here */
        DEM_TRY(dem_device_new_lists(d, state, steps, p, 0, &end));
    }
    while (!end && steps->made < steps->most)
    {
        const int64_t before = steps->made;
        int changed = 0;

        DEM_TRY(steps->ends(state, before, &end));
        if (!end && before > p->checked)
        {
            p->checked = before;
            DEM_TRY(dem_device_check(d, state, steps, p->skin, &changed, &end));
        }
        if (changed)
        {
            DEM_TRY(dem_device_new_lists(d, state, steps, p, 1, &end));
        }
        else if (!end && p->moved <= p->rest)
        {
            DEM_TRY(advance_batch(d, state, steps, p, &end));
        }
        if (!end && !changed && steps->made < steps->most &&
            (p->moved > p->rest || steps->made == before))
        {
            DEM_TRY(dem_device_renew_lists(d, state, steps, p, &end));
        }
    }
    return DEM_OK;
}

int dem_device_waits(const struct dem_state *state)
{
    return state->steps <= state->device->host_until;
}

/* State and lists of the host to the device, or what has changed since the last window. */
static int begin_advance(struct dem_device *d, struct dem_state *state, const struct dem_device_steps *steps)
{
    const struct dem_displacement *const since = &state->pairs.displacement[DEM_LIST_OUTER];

    DEM_TRY(DEM_GROW(d->speed, d->speeds, steps->most));
    if (state->contacts_on_device)
    {
        DEM_TRY(dem_device_put_window(d, state));
        return dem_device_displacement(d, state, &d->progress.moved);
    }
    d->progress = (struct dem_device_progress){
        .rest = steps->rest(state), .before = since->spread + sqrt(dem_vec_dot(since->centre, since->centre))};
    DEM_TRY(dem_device_put(d, state));
    return dem_device_refer(d, state);
}

/* No step was made. The host's rows go on, if it has them; else records have the images of the device's rows. */
static int leave_unmade(struct dem_device *d, struct dem_state *state)
{
    const size_t all = state->particles.n + state->particles.ghosts;

    return state->contacts_on_device
               ? dem_agree(state, dem_opencl_read(d->cl, &d->record, 0, all*sizeof *state->particles.record,
                                                  state->particles.record))
               : DEM_OK;
}

int dem_device_advance(struct dem_state *state, struct dem_device_steps *steps)
{
    struct dem_device *const d = state->device;
    const int64_t lists = d->counts.lists;

    steps->made = 0;
    const int begun = begin_advance(d, state, steps);

    DEM_TRY(dem_agree_max(state, begun, &d->progress.moved, 1));
    steps->speed = d->speed;
    DEM_TRY(make_steps(d, state, steps));
    dem_device_leave_walls(state, steps);
    steps->lists = d->counts.lists > lists;
    if (steps->made == 0)
    {
        return leave_unmade(d, state);
    }
    d->counts.steps += steps->made;
    d->counts.parts++;
    const int ended = steps->last > 0 && steps->first + steps->made > steps->last;

    DEM_TRY(dem_agree(state, ended ? dem_device_get_window(d, state) : dem_device_get(d, state)));
    state->contacts_on_device = ended;
    return DEM_OK;
}
