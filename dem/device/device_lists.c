/*
 * device_lists.c -- new neighbor lists on the device (lists.cl), from where its particles are.
 *
 * The numbers of rows and entries are known after they have been counted, so the host reads them once
 * for each list.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include <math.h>
#include <string.h>

/* With particles more than SIZE_RATIO times the smallest, cells of one grid hold too many of the small; the
   radii of a level and the next differ by this factor. */
static const double SIZE_RATIO = 5.0, LEVEL_FACTOR = 3.0;

/* ---- constants --------------------------------------------------------------------------------- */

static int put_drives(struct dem_device *d, const struct dem_walls *w)
{
    const size_t size = sizeof(struct dem_wall_drive);

    DEM_TRY(dem_opencl_reserve(d->cl, &d->drives, (size_t)w->walls*size));
    for (int k = 0; k < w->walls; k++)
    {
        DEM_TRY(dem_opencl_write(d->cl, &d->drives, (size_t)k*size, size, &w->wall[k].drive));
    }
    return DEM_OK;
}

int dem_device_begin_lists(struct dem_device *d, const struct dem_state *state)
{
    const size_t most = UINT32_MAX/(size_t)d->classes;

    DEM_REQUIRE(state->particles.n < most, DEM_ERROR_MEMORY,
                "a rank has %zu particles, and lists on a device hold %zu; give more ranks",
                state->particles.n, most);
    DEM_TRY(dem_device_begin_facets(d, &state->walls));
    DEM_TRY(put_drives(d, &state->walls));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->lists, sizeof(struct dem_device_lists)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->largest, sizeof(uint32_t)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->former_place, sizeof(uint32_t)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->totals, ((size_t)d->classes + 2)*sizeof(uint32_t)));
    return dem_device_put_facets(d, state);
}

/* ---- the grid ---------------------------------------------------------------------------------- */

/* Extent [m] of the cells along an axis without period: of the particles when the host last had
   them. What is outside falls into the outermost cells. */
static void extent_of(const struct dem_state *state, int axis, double extent[2])
{
    extent[0] = INFINITY;
    extent[1] = -INFINITY;
    for (size_t i = 0; i < state->particles.n; i++)
    {
        extent[0] = fmin(extent[0], state->particles.record[i].x[axis]);
        extent[1] = fmax(extent[1], state->particles.record[i].x[axis]);
    }
}

/* Cells of a level that are not smaller than `edge` [m], no more than a few a particle. Returns their
   number. */
static uint32_t choose_cells(const struct dem_state *state, double extent[3][2], double edge,
                             struct dem_device_level *grid)
{
    double count;

    do
    {
        count = 1.0;
        for (int k = 0; k < 3; k++)
        {
            const double length = fmax(extent[k][1] - extent[k][0], 0.0);

            grid->cells[k] = (int)fmin(fmax(floor(length/edge), 1.0), 1 << 20);
            grid->over_edge[k] = length > 0.0 ? grid->cells[k]/length : 0.0;
            count *= grid->cells[k];
        }
        edge *= 1.2;
    }
    while (count > 4.0*(double)(state->particles.n + state->particles.ghosts) + 64.0);
    return (uint32_t)count;
}

double dem_device_smallest_radius(const struct dem_interaction_table *t)
{
    double min = INFINITY;

    for (int m = 0; m < t->materials; m++)
    {
        min = t->min_radius[m] > 0.0 ? fmin(min, t->min_radius[m]) : min;
    }
    return min;
}

/* Levels from the largest particles to the smallest. Returns the number of cells. */
static uint32_t choose_levels(const struct dem_state *state, struct dem_device_lists *l)
{
    const struct dem_domain *const domain = &state->domain;
    const double min = dem_device_smallest_radius(&state->interaction_table);
    double extent[3][2], radius = state->pairs.max_radius;
    uint32_t cells = 0;

    for (int k = 0; k < 3; k++)
    {
        extent_of(state, k, extent[k]);
        if (domain->periodic[k])
        {
            extent[k][0] = domain->min[k];
            extent[k][1] = domain->min[k] + domain->length[k];
        }
        l->origin[k] = extent[k][0];
    }
    do
    {
        struct dem_device_level *const grid = &l->level[l->levels++];

        grid->radius = radius;
        grid->first = cells;
        cells += choose_cells(state, extent, (2.0*radius + l->gap)*(1.0 + 1e-6), grid);
        radius /= LEVEL_FACTOR;
    }
    while (LEVEL_FACTOR*radius > SIZE_RATIO*min && l->levels < DEM_DEVICE_LEVELS);
    return cells;
}

static struct dem_device_lists constants_of(const struct dem_device *d,
                                            const struct dem_state *state, double skin,
                                            uint32_t *cells)
{
    const struct dem_domain *const domain = &state->domain;
    const struct dem_device_rows *const old = &d->list[d->at];
    struct dem_device_lists l;

    memset(&l, 0, sizeof l);
    l.gap = state->pairs.reach + skin;
    *cells = choose_levels(state, &l);
    for (int k = 0; k < 3; k++)
    {
        l.periodic[k] = domain->periodic[k];
        l.min[k] = domain->min[k];
        l.max[k] = domain->max[k];
        l.length[k] = domain->length[k];
        l.unit[k] = domain->unit[k];
        l.grid_origin[k] = state->pairs.wall_search.origin[k];
        l.grid_cells[k] = state->pairs.wall_search.cells[k];
    }
    l.particles = (uint32_t)state->particles.n;
    l.all = (uint32_t)(state->particles.n + state->particles.ghosts);
    l.frames = state->walls.frames;
    while ((int)l.facets < state->walls.facets &&
           state->walls.facet[l.facets].shape != DEM_SHAPE_TRIANGLES)
    {
        l.facets++;
    }
    l.grid_edge = state->pairs.wall_search.edge;
    l.materials = DEM_MATERIALS;
    l.columns = (uint32_t)state->interaction_table.history_columns;
    l.old_stride = old->rows;
    l.old_walls = old->walls;
    l.renumbered = d->renumbered;
    l.keep_all = state->interaction_table.past_touching;
    l.keep_frozen = state->interaction_table.contact_scalars;
    return l;
}

/* ---- the lists --------------------------------------------------------------------------------- */

int dem_device_keep_images(struct dem_device *d)
{
    struct dem_opencl_kernel *const k = d->of_lists[DEM_LISTS_IMAGES];
    struct dem_device_rows *const list = &d->list[d->at];

    DEM_TRY(dem_opencl_reserve(d->cl, &d->image, (size_t)list->rows*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 0, list->rows));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 1, list->walls));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 2, &d->record, &list->partners, &d->image, &d->facets,
                            &d->images, &list->near));
    return dem_opencl_launch(d->cl, k, list->rows);
}

/* Particles wrapped, and ordered by cell. */
static int sort_particles(struct dem_device *d, size_t n, size_t cells)
{
    struct dem_opencl_kernel *const *const k = d->of_lists;

    DEM_TRY(dem_opencl_reserve(d->cl, &d->cell, n*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->place, n*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->order, n*sizeof(uint32_t)));
    DEM_TRY(dem_device_clear(d, &d->first, cells));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_CELLS], 0, &d->lists, &d->record, &d->reference,
                            &d->cell, &d->place, &d->first, &d->largest));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_CELLS], n));
    DEM_TRY(dem_device_scan(d, &d->first, cells));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_ORDER], 0, &d->lists, &d->cell, &d->place, &d->first,
                            &d->order));
    return dem_opencl_launch(d->cl, k[DEM_LISTS_ORDER], n);
}

/* Count rows and entries; the host reads their numbers, and memory for them is reserved. */
static int count(struct dem_device *d, const struct dem_state *state, struct dem_device_rows *list)
{
    struct dem_opencl_kernel *const *const k = d->of_lists;
    const size_t n = state->particles.n, classes = (size_t)d->classes;
    uint32_t entries;

    DEM_TRY(dem_device_clear(d, &list->start, n));
    DEM_TRY(dem_device_clear(d, &d->row_first, classes*n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_COUNT], 0, &d->lists, &d->record, &d->first,
                            &d->order, &d->pair_class, &d->wall_class, &d->facets, &d->frames,
                            &d->triangles, &d->candidate_start, &d->candidates, &list->start,
                            &d->row_first));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_COUNT], n));
    DEM_TRY(dem_device_scan(d, &list->start, n));
    DEM_TRY(dem_device_scan(d, &d->row_first, classes*n));
    DEM_TRY(dem_opencl_give_number(d->cl, k[DEM_LISTS_TOTALS], 0, (uint32_t)n));
    DEM_TRY(dem_opencl_give_number(d->cl, k[DEM_LISTS_TOTALS], 1, (uint32_t)classes));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_TOTALS], 2, &d->row_first, &list->start, &d->totals));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_TOTALS], classes + 1));
    DEM_TRY(dem_opencl_read(d->cl, &d->totals, 0, (classes + 1)*sizeof *list->first, list->first));
    DEM_TRY(dem_opencl_read(d->cl, &d->totals, (classes + 1)*sizeof entries, sizeof entries,
                            &entries));
    list->rows = list->first[classes];
    list->walls = list->rows;
    for (size_t c = 0; c < classes; c++)
    {
        list->count[c] = list->first[c + 1] - list->first[c];
    }
    for (int c = d->classes - 1; c >= 0 && state->interaction_table.list[c].pair.with_wall; c--)
    {
        list->walls = list->first[c];
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &list->entry, entries*sizeof(uint32_t)));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->partner, entries*sizeof(uint32_t)));
    return dem_opencl_reserve(d->cl, &list->partners, 2*(size_t)list->rows*sizeof(uint32_t));
}

static int fill(struct dem_device *d, const struct dem_state *state, struct dem_device_rows *list,
                struct dem_device_rows *old)
{
    struct dem_opencl_kernel *const *const k = d->of_lists;
    const size_t n = state->particles.n;

    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_FIND], 0, &d->lists, &d->record, &d->first,
                            &d->order, &d->pair_class, &d->wall_class, &d->facets, &d->frames,
                            &d->triangles, &d->candidate_start, &d->candidates, &list->start,
                            &d->partner));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_FIND], n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_ROWS], 0, &d->lists, &d->record, &d->pair_class,
                            &d->wall_class, &list->start, &d->partner, &d->row_first,
                            &list->partners, &list->entry));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_ROWS], n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_ENTRIES], 0, &d->lists, &d->record, &list->start,
                            &d->partner, &list->entry));
    DEM_TRY(dem_opencl_launch(d->cl, k[DEM_LISTS_ENTRIES], n));
    DEM_TRY(dem_device_find_near(d, state));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k[DEM_LISTS_HISTORY], 0, &d->lists, &d->record, &list->start,
                            &d->partner, &list->entry, &old->start, &old->entry, &old->partners,
                            &d->image, &old->touch, &old->history, &list->touch, &list->history,
                            &d->facets, &d->images, &list->near, &d->former_place));
    return dem_opencl_launch(d->cl, k[DEM_LISTS_HISTORY], n);
}

int dem_device_make_lists(struct dem_device *d, const struct dem_state *state, double skin,
                          int *outside)
{
    struct dem_device_rows *const old = &d->list[d->at], *const list = &d->list[1 - d->at];
    uint32_t left = 0, cells;
    struct dem_device_lists l = constants_of(d, state, skin, &cells);

    DEM_TRY(dem_opencl_write(d->cl, &d->lists, 0, sizeof l, &l));
    DEM_TRY(dem_opencl_write(d->cl, &d->largest, 0, sizeof left, &left));
    DEM_TRY(sort_particles(d, l.all, cells));
    DEM_TRY(dem_device_find_candidates(d, state));
    DEM_TRY(count(d, state, list));
    DEM_TRY(dem_opencl_read(d->cl, &d->largest, 0, sizeof left, &left));
    /* with `leaving remove` the next check removes them */
    *outside = left != 0 && !state->domain.remove;
    d->at = 1 - d->at;
    DEM_TRY(dem_device_reserve_rows(d, state, list->rows));
    l.stride = list->rows;
    l.walls = list->walls;
    DEM_TRY(dem_opencl_write(d->cl, &d->lists, 0, sizeof l, &l));
    d->own = 1;
    d->renumbered = 0;
    d->counts.lists++;
    return fill(d, state, list, old);
}

/* ---- displacements ----------------------------------------------------------------------------- */

int dem_device_displacement(struct dem_device *d, const struct dem_state *state, double *moved)
{
    struct dem_opencl_kernel *const k = d->of_lists[DEM_LISTS_DISPLACEMENT];
    uint32_t bits = 0;
    float square;

    DEM_TRY(dem_opencl_write(d->cl, &d->largest, 0, sizeof bits, &bits));
    DEM_TRY(dem_opencl_give_number(d->cl, k, 0, (uint32_t)state->particles.n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 1, &d->record, &d->reference, &d->largest));
    DEM_TRY(dem_opencl_launch(d->cl, k, state->particles.n));
    DEM_TRY(dem_opencl_read(d->cl, &d->largest, 0, sizeof bits, &bits));
    memcpy(&square, &bits, sizeof square);
    *moved = sqrt((double)square);
    return DEM_OK;
}

int dem_device_refer(struct dem_device *d, const struct dem_state *state)
{
    struct dem_opencl_kernel *const k = d->of_lists[DEM_LISTS_REFER];
    const size_t n = state->particles.n;

    DEM_TRY(dem_opencl_give_number(d->cl, k, 0, (uint32_t)n));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, k, 1, &d->record, &d->reference));
    return dem_opencl_launch(d->cl, k, n);
}
