/*
 * device_open.c -- open a device for a run: program, self-test, constants; close it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/device_steps.h"
#include "core/error.h"
#include "core/memory.h"
#include "device/device_columns.h"
#include "device/device_internal.h"
#include "device/program.h"
#include "device/self_test.h"
#include "laws/effect.h"
#include "ranks/agree.h"
#include "ranks/collect.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    BED_ROWS = 8,      /* pairs a particle in a dense bed of equal spheres, with usual skins */
    LIST_STEPS = 64    /* steps that lists last at the present largest speed, if skins allow */
};

/* ---- open and close ---------------------------------------------------------------------------- */

static int find_kernels(struct dem_device *d)
{
    static const char *const lists[DEM_LISTS_KERNELS] = {
        "lists_images", "lists_cells", "lists_order", "lists_count", "lists_find", "lists_rows",
        "lists_entries", "lists_history", "lists_displacement", "lists_refer", "scan_clear",
        "scan_blocks", "scan_sums", "scan_finish", "lists_totals", "lists_needed"};

    for (int k = 0; k < d->classes; k++)
    {
        char name[32];

        snprintf(name, sizeof name, "rows_%d", k);
        DEM_TRY(dem_opencl_kernel(d->cl, name, &d->of_rows[k]));
    }
    for (int k = 0; k < DEM_LISTS_KERNELS; k++)
    {
        DEM_TRY(dem_opencl_kernel(d->cl, lists[k], &d->of_lists[k]));
    }
    DEM_TRY(dem_opencl_kernel(d->cl, "bodies", &d->bodies));
    DEM_TRY(dem_opencl_kernel(d->cl, "ghosts_pack", &d->pack_ghosts));
    DEM_TRY(dem_opencl_kernel(d->cl, "ghosts_unpack", &d->unpack_ghosts));
    DEM_TRY(dem_opencl_kernel(d->cl, "wall_loads", &d->of_loads));
    return dem_opencl_kernel(d->cl, "clear_apart", &d->clear);
}

static int build(struct dem_device *d, const struct dem_state *state)
{
    struct dem_text text = {.text = NULL};
    uint64_t key = 0;
    int status = dem_device_program(&state->interaction_table, &state->particles, &state->walls,
                                    state->energy_balance, &text);

    status = status ? status : dem_opencl_build(d->cl, text.text, &key);
    dem_text_free(&text);
    DEM_TRY(status);
    if (!dem_opencl_has_note(key, "tested"))
    {
        DEM_TRY(dem_device_self_test(d->cl, &state->interaction_table));
        dem_opencl_make_note(key, "tested");
    }
    return find_kernels(d);
}

static int put_constants(struct dem_device *d, const struct dem_state *state)
{
    struct dem_device_axes axes;

    memset(&axes, 0, sizeof axes);
    for (int k = 0; k < 3; k++)
    {
        axes.round[k] = state->domain.round[k];
        axes.min[k] = state->domain.min[k];
        axes.length[k] = state->domain.length[k];
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
    /* with wider ones small particles would have too many partners */
    d->max_skin = fmax(outer, fmin(max, 4.0*dem_device_smallest_radius(&state->interaction_table)));
    dem_skins_init(s, (const double[2]){outer, outer}, 0, outer, d->max_skin);
    dem_request_rebuild(state);
}

double dem_device_skin(const struct dem_device *d, double speed, double dt)
{
    return fmin(fmax(d->min_skin, 2.0*LIST_STEPS*speed*dt), d->max_skin);
}

void dem_device_set_skins(struct dem_state *state, double speed)
{
    const struct dem_device *const d = state->device;
    const double skin = dem_device_skin(d, speed, state->dt);

    state->pairs.skins.skin[DEM_LIST_OUTER] = state->pairs.skins.skin[DEM_LIST_INNER] = skin;
}

/* A particle may cross half of it before the host has to find new ones. */
double dem_device_ghost_reach(const struct dem_state *state)
{
    return 2.0*state->pairs.max_radius + state->pairs.skins.skin[DEM_LIST_OUTER];
}

void dem_device_count(const struct dem_device *d, struct dem_device_counts *c)
{
    *c = d->counts;
}

int64_t dem_device_rows_of(const struct dem_device *d, int class)
{
    return d->list[d->at].count[class];
}

static void name_device(struct dem_device *d, const struct dem_state *state, int fitting)
{
    const struct dem_opencl_info *const info = dem_opencl_device(d->cl);
    const int n = snprintf(d->name, sizeof d->name, "%s (%s, driver %s)", info->name, info->platform,
                           info->driver);

    if (state->decomposition.ranks > 1)
    {
        snprintf(d->name + n, sizeof d->name - (size_t)n, "; the ranks of a machine share %d such device%s",
                 fitting, fitting > 1 ? "s" : "");
    }
}

/* The first rank of a machine builds the program, the others find it in the cache. */
static int open_in_turn(struct dem_device *d, struct dem_state *state, const char *wanted, int *fitting)
{
    const int rank = dem_collect_machine_rank(&state->decomposition);
    int status;

    d->classes = state->interaction_table.classes;
    status = dem_opencl_open(&d->cl, wanted, rank, fitting);

    for (int turn = 0; turn < 2; turn++)
    {
        status = status || (rank > 0) != turn ? status : build(d, state);
        DEM_TRY(dem_agree(state, status));
    }
    status = put_constants(d, state);
    return dem_agree(state, status ? status : dem_device_begin_lists(d, state));
}

int dem_device_begin(struct dem_state *state, const char *wanted)
{
    int fitting = 0, status = dem_agree(state, DEM_NEW(state->device, 1));

    status = status ? status : open_in_turn(state->device, state, wanted, &fitting);
    if (status)
    {
        dem_device_free(state);
        return status;
    }
    name_device(state->device, state, fitting);
    choose_skins(state->device, state);
    return DEM_OK;
}

struct dem_opencl_memory *dem_device_memory_of(struct dem_device *d, size_t k)
{
    struct dem_device_rows *const a = &d->list[0], *const b = &d->list[1];
    struct dem_opencl_memory *const all[] = {
        &d->axes, &d->shift, &d->facets, &d->frames, &d->drives, &d->pair_class, &d->wall_class,
        &d->batch, &d->report, &d->ghosts_out, &d->ghosts_in, &d->ghosts, &d->needed, &d->triangles,
        &d->grid_first, &d->grid, &d->images, &d->contacts, &d->exact, &d->conditions,
        &d->rates, &d->applied, &d->ids,
        &d->candidate_start, &d->candidates, &a->near, &b->near, &d->contact_sums,
        &d->backup.list.partners, &d->backup.list.history, &d->backup.list.near,
        &d->record, &d->lost, &d->columns, &d->before_record, &d->before_lost,
        &d->before_columns, &d->force, &d->moment,
        &d->energy, &d->before_touch, &d->before_history, &d->lists, &d->reference, &d->cell,
        &d->place, &d->first, &d->order, &d->row_first, &d->sums, &d->partner, &d->image,
        &d->totals, &d->largest, &d->former_place,
        &a->partners, &a->start, &a->entry, &a->touch, &a->history,
        &b->partners, &b->start, &b->entry, &b->touch, &b->history};

    return k < sizeof all/sizeof *all ? all[k] : NULL;
}

void dem_device_free(struct dem_state *state)
{
    struct dem_device *const d = state->device;

    if (d)
    {
        for (size_t k = 0; d->cl && dem_device_memory_of(d, k); k++)
        {
            dem_opencl_release(d->cl, dem_device_memory_of(d, k));
        }
        dem_opencl_close(d->cl);
        dem_memory_free(d->word);
        dem_memory_free(d->frame);
        dem_memory_free(d->speed);
        dem_memory_free(d->backup.ghost);
        dem_memory_free(d->backup.facet);
    }
    dem_memory_free(d);
    state->device = NULL;
}

const char *dem_device_name(const struct dem_device *d)
{
    return d->name;
}

/* Lists, history and the state before a batch are held twice or thrice; with a fluid, contacts of a backup, too. */
double dem_device_memory(const struct dem_state *state)
{
    const struct dem_interaction_table *const t = &state->interaction_table;
    const double n = (double)state->particles.n,
                 rows = fmax((double)state->contacts.rows.n, BED_ROWS*n);
    const size_t columns = dem_device_columns_width(&state->particles),
                 history = (size_t)t->history_columns;
    const int fluid = dem_column(&state->particles, DEM_COLUMN_FLUID_VELOCITY) != NULL;
    const size_t particle = 2*sizeof(struct dem_particle) + (7 + (size_t)t->classes)*sizeof(uint32_t) +
                            (4 + 2 + 2*columns + (fluid ? 8 : 0))*sizeof(double);
    const size_t row = 3 + (fluid ? 13 : 11)*sizeof(uint32_t) +
                       (8 + 4*(size_t)(t->moments + t->past_touching) + (fluid ? 4 : 3)*history +
                        2*(size_t)(t->contact_scalars ? t->listed : 0))*sizeof(double);

    return n*(double)particle + rows*(double)row + (double)sizeof(struct dem_device_batch) +
           (double)sizeof(struct dem_device_report);
}
