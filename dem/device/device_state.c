/*
 * device_state.c -- lists, particles and history between host and device.
 *
 * Rows, entries and history columns of the host's lists are copied as they are. When the device has
 * made lists of its own, the history comes back by key, as from a snapshot, and the host makes lists
 * in its next step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_columns.h"
#include "device/device_internal.h"
#include <string.h>

/* ---- the host's lists up ----------------------------------------------------------------------- */

/* Partners of each row; at a wall the second one is its facet. */
static int put_partners(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    struct dem_opencl_memory *const to = &d->list[d->at].partners;
    const size_t bytes = (size_t)rows->n*sizeof *rows->partners;

    DEM_TRY(DEM_GROW(d->word, d->words, 2*(size_t)rows->n));
    memcpy(d->word, rows->partners, bytes);
    for (uint32_t row = rows->walls; row < rows->n; row++)
    {
        const struct dem_pair *const q =
            rows->pair[row] == DEM_ROW_NONE ? NULL : dem_contacts_pair(&state->contacts, row);

        d->word[2*row + 1] =
            q && q->wall ? (uint32_t)dem_pairs_facet(&state->pairs, q->j) : 0;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, to, bytes));
    return dem_opencl_write(d->cl, to, 0, bytes, d->word);
}

/* Entries of each particle in the order of its sum: 2 row + side. Those without a row, which make up
   even numbers on the host, are left out: they add zero. */
static int put_entries(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    const struct dem_contact_forces *const forces = &state->contacts.forces;
    struct dem_device_rows *const list = &d->list[d->at];
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
    DEM_TRY(dem_opencl_reserve(d->cl, &list->start, (n + 1)*sizeof *start));
    DEM_TRY(dem_opencl_write(d->cl, &list->start, 0, (n + 1)*sizeof *start, start));
    DEM_TRY(dem_opencl_reserve(d->cl, &list->entry, at*sizeof *entry));
    return dem_opencl_write(d->cl, &list->entry, 0, at*sizeof *entry, entry);
}

/* Memory of the rows of the present lists, and of what the laws leave at them. */
int dem_device_reserve_rows(struct dem_device *d, const struct dem_state *state, uint32_t rows)
{
    const struct dem_interaction_table *const t = &state->interaction_table;
    struct dem_device_rows *const list = &d->list[d->at];
    const size_t number = 4*sizeof(double), n = rows;
    const size_t history = n*(size_t)t->history_columns*sizeof(double);

    DEM_TRY(dem_opencl_reserve(d->cl, &list->touch, n));
    DEM_TRY(dem_opencl_reserve(d->cl, &list->history, history));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->before_touch, n));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->before_history, history));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->force, 2*n*number));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->moment, t->moments ? n*number : 0));
    DEM_TRY(dem_opencl_reserve(
        d->cl, &d->rates, t->contact_scalars ? 2*n*(size_t)t->listed*sizeof(double) : 0));
    return dem_opencl_reserve(d->cl, &d->energy, t->past_touching ? n*number : 0);
}

static int put_lists(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    struct dem_device_rows *const list = &d->list[d->at];
    const int64_t lists = state->rebuilds + state->prunes;

    if (d->host_lists == lists && !d->own)
    {
        return DEM_OK;
    }
    DEM_TRY(d->selections != state->wall_store.selections ? dem_device_put_facets(d, state) : DEM_OK);
    DEM_TRY(dem_device_put_ghosts(d, &state->halo, DEM_HALO_NEEDED));
    DEM_TRY(put_partners(d, state));
    DEM_TRY(put_entries(d, state));
    DEM_TRY(dem_device_put_near(d, state));
    DEM_TRY(dem_device_reserve_rows(d, state, rows->n));
    list->rows = rows->n;
    list->walls = rows->walls;
    for (int k = 0; k < rows->classes; k++)
    {
        list->first[k] = rows->segment[k].first;
        list->count[k] = rows->segment[k].count;
    }
    list->first[rows->classes] = rows->n;
    d->host_lists = lists;
    d->own = 0;
    return DEM_OK;
}

/* ---- state up and down ------------------------------------------------------------------------- */

/* Forces of the scene on chosen particles. */
static int put_applied(struct dem_device *d, const struct dem_applied_forces *a)
{
    struct dem_device_applied *all;
    size_t ids = 0;
    int status = DEM_OK;

    for (int k = 0; k < a->n; k++)
    {
        ids += a->force[k].count;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->ids, ids*sizeof(int64_t)));
    DEM_TRY(DEM_NEW(all, a->n + 1));
    ids = 0;
    for (int k = 0; k < a->n; k++)
    {
        const struct dem_applied_force *const f = &a->force[k];

        all[k] = (struct dem_device_applied){.from = f->start, .until = f->end,
                                             .material = f->material, .all = !f->ids,
                                             .first = (uint32_t)ids,
                                             .end = (uint32_t)(ids + f->count)};
        memcpy(all[k].force, f->force, sizeof f->force);
        memcpy(all[k].torque, f->torque, sizeof f->torque);
        memcpy(all[k].min, f->min, sizeof f->min);
        memcpy(all[k].max, f->max, sizeof f->max);
        status = status ? status
                        : dem_opencl_write(d->cl, &d->ids, ids*sizeof(int64_t),
                                           f->count*sizeof(int64_t), f->ids);
        ids += f->count;
    }
    status = status ? status : dem_opencl_put(d->cl, &d->applied, (size_t)a->n*sizeof *all, all);
    dem_memory_free(all);
    return status;
}

int dem_device_put_particles(struct dem_device *d, const struct dem_state *state)
{
    const size_t n = state->particles.n, all = n + state->particles.ghosts,
                 records = all*sizeof *state->particles.record,
                 columns = all*dem_device_columns_width(&state->particles)*sizeof(double);
    const double *const lost = dem_column(&state->particles, DEM_COLUMN_LOST_ENERGY);

    DEM_TRY(dem_opencl_reserve(d->cl, &d->record, records));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->before_record, records));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->reference, 4*all*sizeof(double)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->contact_sums, d->keeps ? 8*n*sizeof(double) : 0));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->lost, n*sizeof *lost));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->before_lost, n*sizeof *lost));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->columns, columns));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->before_columns, columns));
    DEM_TRY(dem_device_put_columns(d->cl, &d->columns, &state->particles));
    DEM_TRY(dem_opencl_write(d->cl, &d->record, 0, records, state->particles.record));
    return lost ? dem_opencl_write(d->cl, &d->lost, 0, n*sizeof *lost, lost) : DEM_OK;
}

int dem_device_put_window(struct dem_device *d, const struct dem_state *state)
{
    DEM_TRY(dem_device_put_particles(d, state));
    return put_applied(d, &state->applied_forces);
}

/* History of rows that do not touch is zero on the host, so all rows count as touching before. Rows
   that make up whole batches repeat others; no entry and no kernel has them. */
int dem_device_put(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_history *const h = &state->contacts.history;

    DEM_TRY(put_lists(d, state));
    DEM_TRY(dem_device_put_window(d, state));
    struct dem_device_rows *const list = &d->list[d->at];
    const size_t column = list->rows*sizeof(double);

    for (int m = 0; m < h->columns; m++)
    {
        DEM_TRY(dem_opencl_write(d->cl, &list->history, (size_t)m*column, column, h->column[m]));
    }
    DEM_TRY(DEM_GROW(d->word, d->words, list->rows/sizeof *d->word + 1));
    memset(d->word, 1, list->rows);
    return dem_opencl_write(d->cl, &list->touch, 0, list->rows, d->word);
}

int dem_device_clear_apart(struct dem_device *d, int columns)
{
    struct dem_device_rows *const list = &d->list[d->at];

    DEM_TRY(dem_opencl_give_number(d->cl, d->clear, 0, list->rows));
    DEM_TRY(dem_opencl_give_number(d->cl, d->clear, 1, (uint32_t)columns));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->clear, 2, &list->touch, &list->history));
    return dem_opencl_launch(d->cl, d->clear, list->rows);
}

static int get_rows(struct dem_device *d, struct dem_contact_history *h)
{
    const struct dem_device_rows *const list = &d->list[d->at];
    const size_t column = list->rows*sizeof(double);

    for (int m = 0; m < h->columns; m++)
    {
        DEM_TRY(dem_opencl_read(d->cl, &list->history, (size_t)m*column, column, h->column[m]));
    }
    return DEM_OK;
}

/* facets: of all walls; near: of a wall row, or NULL. */
static struct dem_contact_key key_of(const struct dem_state *state, const uint32_t partners[2], int wall,
                                     const struct dem_facet *facets, const uint32_t *near)
{
    const struct dem_particle *const record = state->particles.record,
                              *const i = &record[partners[0]];
    struct dem_contact_key key = {.low = i->id, .counted = partners[0] < state->particles.n};

    if (wall)
    {
        const struct dem_facet *const facet = &facets[partners[1]];

        key.high = -1 - facet->number;
        key.image = near ? dem_device_facet_image(&state->walls, facet, near[3], i->image) : 0;
    }
    else
    {
        const struct dem_particle *const j = &record[partners[1] & (DEM_PARTNER_LIMIT - 1)];

        key.high = j->id;
        key.image = dem_image_of_pair((int)(partners[1] >> DEM_PARTNER_SHIFT), i->image, j->image);
    }
    return key;
}

/* History of the device's own rows as saved history of the host, which has no lists then. */
static int save_rows(struct dem_device *d, struct dem_state *state, const struct dem_device_rows *list,
                     const struct dem_facet *facets, const double *history)
{
    struct dem_contact_history *const h = &state->contacts.history;
    double values[DEM_HISTORY_COLUMNS];

    for (uint32_t row = 0; row < list->rows; row++)
    {
        int some = 0;

        for (int m = 0; m < h->columns; m++)
        {
            values[m] = history[(size_t)m*list->rows + row];
            some |= values[m] != 0.0;
        }
        if (some)
        {
            const int wall = row >= list->walls;
            const struct dem_contact_key key =
                key_of(state, d->word + 2*(size_t)row, wall, facets,
                       wall && d->of_near ? d->word + 2*(size_t)list->rows +
                                                4*(size_t)(row - list->walls)
                                          : NULL);

            DEM_TRY(dem_contact_history_append(h, &key, values));
        }
    }
    return DEM_OK;
}

void dem_device_drop_host_rows(struct dem_contacts *c)
{
    dem_contact_forces_release(&c->forces);
    dem_contact_rows_clear(&c->rows);
    dem_contact_history_clear(&c->history);
    dem_contact_forces_clear(&c->forces);
}

int dem_device_get_saved(struct dem_device *d, struct dem_state *state, const struct dem_device_rows *list,
                         const struct dem_facet *facets)
{
    const size_t numbers = (size_t)state->contacts.history.columns*list->rows;
    double *history;

    dem_device_drop_host_rows(&state->contacts);
    state->lists_state = DEM_NEIGHBORS_NONE;
    state->contacts_on_device = 0;
    DEM_TRY(DEM_NEW(history, numbers + 1));
    const size_t near = d->of_near ? 4*(size_t)(list->rows - list->walls) : 0;
    int status = DEM_GROW(d->word, d->words, 2*(size_t)list->rows + near);

    status = status ? status
                    : dem_opencl_read(d->cl, &list->history, 0, numbers*sizeof *history, history);
    status = status ? status
                    : dem_opencl_read(d->cl, &list->partners, 0,
                                      2*(size_t)list->rows*sizeof *d->word, d->word);
    status = status ? status
                    : dem_opencl_read(d->cl, &list->near, 0, near*sizeof *d->word,
                                      d->word + 2*(size_t)list->rows);
    status = status ? status : save_rows(d, state, list, facets, history);
    dem_memory_free(history);
    return status;
}

int dem_device_get_particles(struct dem_device *d, struct dem_state *state)
{
    const size_t n = state->particles.n, all = n + state->particles.ghosts;
    double *const lost = dem_column(&state->particles, DEM_COLUMN_LOST_ENERGY);

    DEM_TRY(dem_opencl_read(d->cl, &d->record, 0, all*sizeof *state->particles.record,
                            state->particles.record));
    DEM_TRY(dem_device_get_columns(d->cl, &d->columns, &state->particles));
    return lost ? dem_opencl_read(d->cl, &d->lost, 0, n*sizeof *lost, lost) : DEM_OK;
}

int dem_device_get(struct dem_device *d, struct dem_state *state)
{
    struct dem_contact_history *const h = &state->contacts.history;

    DEM_TRY(dem_device_get_particles(d, state));
    DEM_TRY(h->columns > 0 ? dem_device_clear_apart(d, h->columns) : DEM_OK);
    return d->own ? dem_device_get_saved(d, state, &d->list[d->at], state->walls.facet) : get_rows(d, h);
}
