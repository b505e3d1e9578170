/*
 * device.c -- the state on the device: lists, particles and history up, steps, particles and history
 * down.
 *
 * A step is one kernel for each pair class and one for the particles, in this order; the queue keeps
 * it. After up to DEM_DEVICE_BATCH steps the host reads a report. A step of which the lists might
 * miss a contact is left out by the kernels themselves, and so are all after it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/device.h"
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "device/program.h"
#include "device/self_test.h"
#include "laws/effect.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    LIST_STEPS = 64    /* that lists last at the present largest speed, if skins allow */
};

/* ---- open and close ---------------------------------------------------------------------------- */

static int is_curved(const struct dem_state *state)
{
    return !state->walls.all_flat_static;
}

static int find_kernels(struct dem_device *d, const struct dem_interaction_table *table)
{
    for (int k = 0; k < table->classes; k++)
    {
        char name[32];

        snprintf(name, sizeof name, "rows_%d", k);
        DEM_TRY(table->list[k].entries > 0 ? dem_opencl_kernel(d->cl, name, &d->rows[k]) : DEM_OK);
    }
    DEM_TRY(dem_opencl_kernel(d->cl, "bodies", &d->bodies));
    return dem_opencl_kernel(d->cl, "clear_apart", &d->clear);
}

static int build(struct dem_device *d, const struct dem_state *state)
{
    struct dem_text text = {.text = NULL};
    uint64_t key = 0;
    int status = dem_device_program(&state->interaction_table, is_curved(state), &text);

    status = status ? status : dem_opencl_build(d->cl, text.text, &key);
    dem_text_free(&text);
    DEM_TRY(status);
    if (!dem_opencl_has_note(key, "tested"))
    {
        DEM_TRY(dem_device_self_test(d->cl, &state->interaction_table));
        dem_opencl_make_note(key, "tested");
    }
    return find_kernels(d, &state->interaction_table);
}

static int put_constants(struct dem_device *d, const struct dem_state *state)
{
    struct dem_device_axes axes;

    memset(&axes, 0, sizeof axes);
    for (int k = 0; k < 3; k++)
    {
        axes.round[k] = state->domain.round[k];
        axes.flat[k] = state->domain.flat[k];
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->axes, sizeof axes));
    DEM_TRY(dem_opencl_write(d->cl, &d->axes, 0, sizeof axes, &axes));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->shift, sizeof state->pairs.shift));
    DEM_TRY(dem_opencl_write(d->cl, &d->shift, 0, sizeof state->pairs.shift, state->pairs.shift));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->batch, sizeof(struct dem_device_batch)));
    return dem_opencl_reserve(d->cl, &d->report, sizeof(struct dem_device_report));
}

/* Candidates are all pairs, so that nothing is pruned. */
static void choose_skins(struct dem_device *d, struct dem_state *state)
{
    struct dem_skins *const s = &state->pairs.skins;
    const double outer = s->skin[DEM_LIST_OUTER], max = s->tuned ? s->max : outer;

    d->min_skin = outer;
    d->max_skin = fmax(max, outer);
    dem_skins_init(s, (const double[2]){outer, outer}, 0, outer, d->max_skin);
    state->stale = state->stale == 2 ? 2 : 1;
}

void dem_device_set_skins(struct dem_state *state, double speed)
{
    const struct dem_device *const d = state->device;
    const double skin = fmin(fmax(d->min_skin, 2.0*LIST_STEPS*speed*state->dt), d->max_skin);

    state->pairs.skins.skin[DEM_LIST_OUTER] = state->pairs.skins.skin[DEM_LIST_INNER] = skin;
}

void dem_device_count(const struct dem_device *d, struct dem_device_counts *c)
{
    *c = d->counts;
}

int dem_device_begin(struct dem_state *state, const char *wanted)
{
    struct dem_device *d;
    int status;

    DEM_TRY(DEM_NEW(d, 1));
    state->device = d;
    status = dem_opencl_open(&d->cl, wanted);
    status = status ? status : build(d, state);
    status = status ? status : put_constants(d, state);
    if (status)
    {
        dem_device_free(state);
        return status;
    }
    const struct dem_opencl_info *const info = dem_opencl_device(d->cl);

    snprintf(d->name, sizeof d->name, "%s (%s, driver %s)", info->name, info->platform,
             info->driver);
    choose_skins(d, state);
    return DEM_OK;
}

void dem_device_free(struct dem_state *state)
{
    struct dem_device *const d = state->device;

    if (d)
    {
        struct dem_opencl_memory *const all[] = {
            &d->axes, &d->shift, &d->batch, &d->report, &d->partners, &d->start, &d->entry,
            &d->facets, &d->record, &d->lost, &d->touch, &d->history, &d->force, &d->moment,
            &d->energy};

        for (size_t k = 0; d->cl && k < sizeof all/sizeof *all; k++)
        {
            dem_opencl_release(d->cl, all[k]);
        }
        dem_opencl_close(d->cl);
        dem_memory_free(d->word);
        dem_memory_free(d->speed);
    }
    dem_memory_free(d);
    state->device = NULL;
}

const char *dem_device_name(const struct dem_device *d)
{
    return d->name;
}

/* ---- lists up ---------------------------------------------------------------------------------- */

/* Partners of each row; at a wall the second one is its facet. */
static int put_partners(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;

    DEM_TRY(DEM_GROW(d->word, d->words, 2*(size_t)rows->n));
    memcpy(d->word, rows->partners, (size_t)rows->n*sizeof *rows->partners);
    for (uint32_t row = rows->walls; row < rows->n; row++)
    {
        const struct dem_pair *const q =
            rows->pair[row] == DEM_ROW_NONE ? NULL : dem_contacts_pair(&state->contacts, row);

        d->word[2*row + 1] =
            q && q->wall ? (uint32_t)dem_pairs_facet(&state->pairs, q->j) : 0;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->partners, 2*(size_t)rows->n*sizeof *d->word));
    return dem_opencl_write(d->cl, &d->partners, 0, 2*(size_t)rows->n*sizeof *d->word, d->word);
}

/* Entries of each particle in the order of its sum: 2 row + side. Those without a row, which make up
   even numbers on the host, are left out: they add zero. */
static int put_entries(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    const struct dem_contact_forces *const forces = &state->contacts.forces;
    const size_t n = state->particles.n;
    uint32_t at = 0;

    DEM_TRY(DEM_GROW(d->word, d->words, n + 1 + rows->start[n]));
    uint32_t *const start = d->word, *const entry = d->word + n + 1;

    for (size_t i = 0; i < n; i++)
    {
        start[i] = at;
        for (uint32_t e = rows->start[i]; e < rows->start[i + 1]; e++)
        {
            const uint32_t row = dem_contact_forces_row(forces, rows, i, rows->entry[e]);

            entry[at] = 2*row + (rows->entry[e] & DEM_ENTRY_SIDE);
            at += row < rows->n;
        }
    }
    start[n] = at;
    DEM_TRY(dem_opencl_reserve(d->cl, &d->start, (n + 1)*sizeof *start));
    DEM_TRY(dem_opencl_write(d->cl, &d->start, 0, (n + 1)*sizeof *start, start));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->entry, at*sizeof *entry));
    return dem_opencl_write(d->cl, &d->entry, 0, at*sizeof *entry, entry);
}

static int put_facets(struct dem_device *d, const struct dem_walls *w)
{
    const size_t bytes = (size_t)w->facets*sizeof *w->facet;

    DEM_TRY(dem_opencl_reserve(d->cl, &d->facets, bytes));
    return dem_opencl_write(d->cl, &d->facets, 0, bytes, w->facet);
}

/* Memory of what the laws leave at the rows. Rows that past touching laws have no energy of are
   zero. */
static int reserve_rows(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_interaction_table *const t = &state->interaction_table;
    const size_t rows = state->contacts.rows.n, number = 4*sizeof(double);

    DEM_TRY(dem_opencl_reserve(d->cl, &d->touch, rows));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->force, 2*rows*number));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->moment, t->moments ? rows*number : 0));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->energy, t->past_touching ? rows*number : 0));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->history,
                               rows*(size_t)t->history_columns*sizeof(double)));
    return dem_opencl_reserve(d->cl, &d->lost, state->particles.n*sizeof(double));
}

static int put_lists(struct dem_device *d, const struct dem_state *state)
{
    const int64_t lists = state->rebuilds + state->prunes;

    if (d->lists == lists)
    {
        return DEM_OK;
    }
    DEM_TRY(put_partners(d, state));
    DEM_TRY(put_entries(d, state));
    DEM_TRY(put_facets(d, &state->walls));
    DEM_TRY(reserve_rows(d, state));
    d->lists = lists;
    return DEM_OK;
}

/* ---- state up and down ------------------------------------------------------------------------- */

static size_t bytes_of_column(const struct dem_state *state)
{
    return (size_t)state->contacts.rows.n*sizeof(double);
}

/* History of rows that do not touch is zero on the host, so all rows count as touching before. */
static int put_state(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_history *const h = &state->contacts.history;
    const size_t n = state->particles.n, rows = state->contacts.rows.n;
    const double *const lost = dem_column(&state->particles, DEM_COLUMN_LOST_ENERGY);

    DEM_TRY(dem_opencl_reserve(d->cl, &d->record, n*sizeof *state->particles.record));
    DEM_TRY(dem_opencl_write(d->cl, &d->record, 0, n*sizeof *state->particles.record,
                             state->particles.record));
    for (int m = 0; m < h->columns; m++)
    {
        DEM_TRY(dem_opencl_write(d->cl, &d->history, (size_t)m*bytes_of_column(state),
                                 bytes_of_column(state), h->column[m]));
    }
    DEM_TRY(DEM_GROW(d->word, d->words, rows/sizeof *d->word + 1));
    memset(d->word, 1, rows);
    DEM_TRY(dem_opencl_write(d->cl, &d->touch, 0, rows, d->word));
    return lost ? dem_opencl_write(d->cl, &d->lost, 0, n*sizeof *lost, lost) : DEM_OK;
}

static int get_state(struct dem_device *d, struct dem_state *state)
{
    const struct dem_contact_history *const h = &state->contacts.history;
    const size_t n = state->particles.n;
    double *const lost = dem_column(&state->particles, DEM_COLUMN_LOST_ENERGY);

    DEM_TRY(dem_opencl_read(d->cl, &d->record, 0, n*sizeof *state->particles.record,
                            state->particles.record));
    if (h->columns > 0)
    {
        DEM_TRY(dem_opencl_give(d->cl, d->clear, 0, &d->batch));
        DEM_TRY(dem_opencl_give_number(d->cl, d->clear, 1, state->contacts.rows.n));
        DEM_TRY(dem_opencl_give_number(d->cl, d->clear, 2, (uint32_t)h->columns));
        DEM_TRY(dem_opencl_give(d->cl, d->clear, 3, &d->touch));
        DEM_TRY(dem_opencl_give(d->cl, d->clear, 4, &d->history));
        DEM_TRY(dem_opencl_launch(d->cl, d->clear, state->contacts.rows.n));
    }
    for (int m = 0; m < h->columns; m++)
    {
        DEM_TRY(dem_opencl_read(d->cl, &d->history, (size_t)m*bytes_of_column(state),
                                bytes_of_column(state), h->column[m]));
    }
    return lost ? dem_opencl_read(d->cl, &d->lost, 0, n*sizeof *lost, lost) : DEM_OK;
}

/* ---- steps ------------------------------------------------------------------------------------- */

static int give_all(struct dem_device *d, struct dem_opencl_kernel *kernel, int from,
                    const struct dem_opencl_memory *const *memory, int n)
{
    for (int k = 0; k < n; k++)
    {
        DEM_TRY(dem_opencl_give(d->cl, kernel, from + k, memory[k]));
    }
    return DEM_OK;
}

/* All arguments but the number of the step, which is the third one. */
static int give_arguments(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_opencl_memory *const first[] = {&d->batch, &d->report};
    const struct dem_opencl_memory *const of_rows[] = {
        &d->record, &d->partners, &d->shift, &d->facets, &d->touch,
        &d->history, &d->force, &d->moment, &d->energy};
    const struct dem_opencl_memory *const of_bodies[] = {
        &d->record, &d->partners, &d->facets, &d->touch, &d->force, &d->moment,
        &d->energy, &d->start, &d->entry, &d->lost, &d->axes};

    for (int k = 0; k < state->contacts.rows.classes; k++)
    {
        const struct dem_segment *const segment = &state->contacts.rows.segment[k];

        if (d->rows[k])
        {
            DEM_TRY(give_all(d, d->rows[k], 0, first, 2));
            DEM_TRY(dem_opencl_give_number(d->cl, d->rows[k], 3, segment->first));
            DEM_TRY(dem_opencl_give_number(d->cl, d->rows[k], 4, segment->count));
            DEM_TRY(give_all(d, d->rows[k], 5, of_rows, (int)(sizeof of_rows/sizeof *of_rows)));
        }
    }
    DEM_TRY(give_all(d, d->bodies, 0, first, 2));
    return give_all(d, d->bodies, 3, of_bodies, (int)(sizeof of_bodies/sizeof *of_bodies));
}

static int launch_step(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    for (int k = 0; k < state->contacts.rows.classes; k++)
    {
        if (d->rows[k] && state->contacts.rows.segment[k].count > 0)
        {
            DEM_TRY(dem_opencl_give_number(d->cl, d->rows[k], 2, s));
            DEM_TRY(dem_opencl_launch(d->cl, d->rows[k], state->contacts.rows.segment[k].count));
        }
    }
    DEM_TRY(dem_opencl_give_number(d->cl, d->bodies, 2, s));
    return dem_opencl_launch(d->cl, d->bodies, state->particles.n);
}

static struct dem_device_batch batch_of(const struct dem_state *state,
                                        const struct dem_device_steps *steps, double moved)
{
    return (struct dem_device_batch){
        .dt = state->dt,
        .inverse_dt = 1.0/state->dt,
        .max_dt = state->max_dt,
        .window_start = state->window.start,
        .first = steps->first + steps->made,
        /* a margin for rounding: the host decides */
        .max_overlap = state->limits.limit*(1.0 - 0x1p-20),
        .overlap = (float)state->limits.overlap,
        .start = (float)(moved*(1.0 + 1e-6)),
        .limit = (float)(steps->displacement*(1.0 - 1e-6)),
        .particles = (uint32_t)state->particles.n,
        .stride = state->contacts.rows.n,
        .walls = state->contacts.rows.walls};
}

/* A batch of up to n steps; *made: how many. Its report is in d->seen. */
static int make_batch(struct dem_device *d, const struct dem_state *state,
                      const struct dem_device_steps *steps, double moved, uint32_t n,
                      uint32_t *made)
{
    const struct dem_device_batch batch = batch_of(state, steps, moved);

    memset(&d->seen, 0, sizeof d->seen);
    d->seen.overlap = batch.overlap;
    DEM_TRY(dem_opencl_write(d->cl, &d->batch, 0, sizeof batch, &batch));
    DEM_TRY(dem_opencl_write(d->cl, &d->report, 0, sizeof d->seen, &d->seen));
    for (uint32_t s = 0; s < n; s++)
    {
        DEM_TRY(launch_step(d, state, s));
    }
    DEM_TRY(dem_opencl_read(d->cl, &d->report, 0, sizeof d->seen, &d->seen));
    for (*made = 0; *made < n && d->seen.bound[*made] <= batch.limit; ++*made)
    {
    }
    return DEM_OK;
}

/* Add the speeds of a batch. Returns 1 when a drift between two of its steps was too fast for the
   device. */
static int add_speeds(struct dem_device *d, const struct dem_device_steps *steps, uint32_t made,
                      int64_t before, double dt, double *moved)
{
    int fast = 0;

    for (uint32_t s = 0; s < made; s++)
    {
        const double speed = sqrt((double)d->seen.fastest[s]);

        /* the last drift of all is checked by the host, which has its positions then */
        fast |= before > 0 && s == 0 && !(d->speed[before - 1] <= steps->max_speed);
        fast |= s + 1 < made && !(speed <= steps->max_speed);
        d->speed[before + s] = speed;
        *moved += speed*dt;
    }
    return fast;
}

/* The largest overlap is the only thing of a row that the host reports of steps between outputs. */
static void keep_overlap(const struct dem_device *d, struct dem_state *state)
{
    state->limits.overlap = fmax(state->limits.overlap, (double)d->seen.overlap);
}

/* Steps of the next batch: as many as the lists are likely to allow. */
static uint32_t batch_size(const struct dem_device *d, const struct dem_device_steps *steps,
                           double moved, double dt)
{
    const double speed = steps->made > 0 ? d->speed[steps->made - 1] : d->last_speed,
                 rest = steps->displacement - moved,
                 likely = speed > 0.0 ? 1.05*rest/(speed*dt) + 2.0 : DEM_DEVICE_BATCH;

    return (uint32_t)fmin(fmin(likely, DEM_DEVICE_BATCH), (double)(steps->most - steps->made));
}

int dem_device_advance(struct dem_state *state, struct dem_device_steps *steps)
{
    struct dem_device *const d = state->device;
    double moved = 0.0;

    steps->made = 0;
    if (state->steps <= d->host_until)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(d->speed, d->speeds, steps->most));
    steps->speed = d->speed;
    DEM_TRY(put_lists(d, state));
    DEM_TRY(put_state(d, state));
    DEM_TRY(give_arguments(d, state));
    while (steps->made < steps->most && moved <= steps->displacement)
    {
        const uint32_t n = batch_size(d, steps, moved, state->dt);
        uint32_t made;

        DEM_TRY(make_batch(d, state, steps, moved, n, &made));
        const int fast = add_speeds(d, steps, made, steps->made, state->dt, &moved);

        if (d->seen.events || fast)
        {
            /* the host makes these steps from the state that it has */
            d->host_until = state->steps + steps->made + n;
            d->counts.repeated += steps->made + n;
            steps->made = 0;
            return DEM_OK;
        }
        steps->made += made;
        keep_overlap(d, state);
        if (made < n)
        {
            break;
        }
    }
    d->last_speed = d->speed[steps->made - 1];
    d->counts.steps += steps->made;
    d->counts.parts++;
    return get_state(d, state);
}
