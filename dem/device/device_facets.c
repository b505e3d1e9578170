/*
 * device_facets.c -- facets and triangles of walls on the device: what the host's lists know of them,
 * candidates for the device's lists, and the launch of the kernel of contacts with facets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "device/device_internal.h"
#include "device/program.h"
#include <math.h>
#include <string.h>

/* ---- constants --------------------------------------------------------------------------------- */

_Static_assert((int)DEM_DEVICE_MATERIALS == (int)DEM_MATERIALS &&
                   (int)DEM_DEVICE_CARRIED_OVER == (int)DEM_SCALAR_CARRIED_OVER &&
                   (int)DEM_DEVICE_DECAY == (int)DEM_SCALAR_DECAY, "shared.h repeats them");

/* A facet names the frame and the number of its wall. */
static int put_facets(struct dem_device *d, const struct dem_walls *w)
{
    const size_t bytes = (size_t)w->facets*sizeof *w->facet;
    struct dem_facet *facet;

    DEM_TRY(DEM_NEW(facet, w->facets + 1));
    memcpy(facet, w->facet, bytes);
    for (int k = 0; k < w->facets; k++)
    {
        const int wall = w->facet[k].wall;

        facet[k].wall = w->wall[wall].frame;
        facet[k].largest = (uint32_t)wall << 2 | (w->wall[wall].driven ? DEM_DEVICE_DRIVEN : 0) |
                           (w->wall[wall].absorbs ? DEM_DEVICE_ABSORBS : 0);
    }
    const int status = dem_opencl_put(d->cl, &d->facets, bytes, facet);

    dem_memory_free(facet);
    return status;
}

static int put_triangles(struct dem_device *d, const struct dem_walls *w)
{
    struct dem_device_triangle *triangle;

    DEM_TRY(DEM_NEW(triangle, w->triangles + 1));
    for (size_t k = 0; k < w->triangles; k++)
    {
        const struct dem_triangle *const t = &w->triangle[k];

        triangle[k] = (struct dem_device_triangle){.frame = w->wall[t->wall].frame,
                                                   .facet = (uint32_t)t->facet,
                                                   .rim = t->rim, .place = t->place};
        memcpy(triangle[k].corner, t->corner, sizeof t->corner);
    }
    const int status =
        dem_opencl_put(d->cl, &d->triangles, w->triangles*sizeof *triangle, triangle);

    dem_memory_free(triangle);
    return status;
}

/* The cells of triangles. */
static int put_grid(struct dem_device *d, const struct dem_wall_search *s)
{
    const size_t cells = (size_t)s->cells[0]*(size_t)s->cells[1]*(size_t)s->cells[2];

    DEM_TRY(DEM_GROW(d->word, d->words, cells + 1));
    for (size_t c = 0; c <= cells; c++)
    {
        d->word[c] = (uint32_t)s->start[c];
    }
    DEM_TRY(dem_opencl_put(d->cl, &d->grid_first, (cells + 1)*sizeof *d->word, d->word));
    return dem_opencl_put(d->cl, &d->grid, s->start[cells]*sizeof *s->entry, s->entry);
}

/* Where walls are in whole periods. */
static int put_images(struct dem_device *d, const struct dem_walls *w)
{
    struct dem_device_images *of;

    DEM_TRY(DEM_NEW(of, w->frames + 1));
    for (int k = 0; k < w->walls; k++)
    {
        struct dem_device_images *const i = &of[w->wall[k].frame + 1];

        i->triangles |= w->wall[k].shape == DEM_SHAPE_TRIANGLES;
        memcpy(i->period, dem_walls_period(w, w->wall[k].frame), sizeof i->period);
        dem_walls_turns(w, k, i->turns);
    }
    const int status =
        dem_opencl_put(d->cl, &d->images, ((size_t)w->frames + 1)*sizeof *of, of);

    dem_memory_free(of);
    return status;
}

/* What walls give to scalars. */
static int put_conditions(struct dem_device *d, const struct dem_walls *w, int scalars)
{
    struct dem_device_condition *all;

    DEM_TRY(DEM_NEW(all, (size_t)w->walls*(size_t)scalars + 1));
    for (int k = 0; k < w->walls*scalars; k++)
    {
        const struct dem_wall_scalar *const s = w->wall[k/scalars].scalars;

        all[k].end = -INFINITY;
        if (s)
        {
            const struct dem_wall_scalar *const of = &s[k%scalars];

            all[k] = (struct dem_device_condition){.value = of->value, .flux = of->flux,
                                                   .film = of->film, .start = of->start,
                                                   .end = of->end, .given = of->given};
        }
    }
    const int status = dem_opencl_put(d->cl, &d->conditions,
                                      (size_t)w->walls*(size_t)scalars*sizeof *all, all);

    dem_memory_free(all);
    return status;
}

/* Classes of pairs by both materials; of walls by facet and material. */
static int put_classes(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_interaction_table *const t = &state->interaction_table;
    const struct dem_walls *const w = &state->walls;
    const size_t m = DEM_MATERIALS, pairs = m*m, walls = m*(size_t)w->facets;

    DEM_TRY(DEM_GROW(d->word, d->words, pairs + walls));
    for (size_t a = 0; a < m; a++)
    {
        for (size_t b = 0; b < m; b++)
        {
            d->word[a*m + b] = (uint32_t)t->class_of[DEM_PARTNER_PARTICLE][a][b];
        }
        for (size_t f = 0; f < (size_t)w->facets; f++)
        {
            const struct dem_wall *const wall = &w->wall[w->facet[f].wall];

            d->word[pairs + f*m + a] =
                (uint32_t)t->class_of[DEM_PARTNER_WALL + wall->frictionless][a][wall->material];
        }
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->pair_class, pairs*sizeof *d->word));
    DEM_TRY(dem_opencl_reserve(d->cl, &d->wall_class, walls*sizeof *d->word));
    DEM_TRY(dem_opencl_write(d->cl, &d->pair_class, 0, pairs*sizeof *d->word, d->word));
    return dem_opencl_write(d->cl, &d->wall_class, 0, walls*sizeof *d->word, d->word + pairs);
}

int dem_device_put_facets(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_walls *const w = &state->walls;

    d->selections = state->wall_store.selections;
    DEM_TRY(put_classes(d, state));
    DEM_TRY(put_facets(d, w));
    DEM_TRY(put_images(d, w));
    DEM_TRY(put_conditions(d, w, state->interaction_table.listed));
    DEM_TRY(put_triangles(d, w));
    return w->triangles > 0 ? put_grid(d, &state->pairs.wall_search) : DEM_OK;
}

int dem_device_begin_facets(struct dem_device *d, const struct dem_walls *w)
{
    DEM_TRY(dem_device_has_facets(w) ? dem_opencl_kernel(d->cl, "wall_contacts", &d->of_facets)
                                     : DEM_OK);
    if (dem_walls_count_triangles(w) == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_kernel(d->cl, "lists_triangles", &d->of_triangles));
    return dem_opencl_kernel(d->cl, "lists_near", &d->of_near);
}

/* ---- the host's lists up ----------------------------------------------------------------------- */

static uint32_t code_of(const int8_t n[3])
{
    return (uint32_t)((n[0] + 4) << 6 | (n[1] + 4) << 3 | (n[2] + 4));
}

uint32_t dem_device_facet_image(const struct dem_walls *w, const struct dem_facet *facet,
                                uint32_t code, uint32_t particle)
{
    const int8_t n[3] = {(int8_t)((int)(code >> 6 & 7) - 4), (int8_t)((int)(code >> 3 & 7) - 4),
                         (int8_t)((int)(code & 7) - 4)};
    int turns[3];

    dem_walls_turns(w, facet->wall, turns);
    return dem_facet_image(facet->distinct, turns, n, particle);
}

static int put_candidates(struct dem_device *d, const struct dem_wall_search *s)
{
    static const int8_t none[3] = {0, 0, 0};

    DEM_TRY(DEM_GROW(d->word, d->words, s->candidates));
    for (size_t c = 0; c < s->candidates; c++)
    {
        d->word[c] = s->candidate[c] | code_of(s->image ? s->image[c].n : none)
                                           << DEM_DEVICE_TRIANGLE_BITS;
    }
    return dem_opencl_put(d->cl, &d->candidates, s->candidates*sizeof *d->word, d->word);
}

int dem_device_put_near(struct dem_device *d, const struct dem_state *state)
{
    const struct dem_contact_rows *const rows = &state->contacts.rows;
    const struct dem_wall_search *const s = &state->pairs.wall_search;
    const size_t n = rows->n - rows->walls;

    if (!d->of_near)
    {
        return DEM_OK;
    }
    /* the host has wrapped walls when it made these lists */
    DEM_TRY(put_images(d, &state->walls));
    DEM_TRY(put_candidates(d, s));
    DEM_TRY(DEM_GROW(d->word, d->words, 4*n));
    memset(d->word, 0, 4*n*sizeof *d->word);
    for (uint32_t row = rows->walls; row < rows->n; row++)
    {
        const struct dem_pair *const q =
            rows->pair[row] == DEM_ROW_NONE ? NULL : dem_contacts_pair(&state->contacts, row);

        if (q && q->wall)
        {
            const struct dem_wall_neighbor *const near = &s->neighbor[q->j];
            uint32_t *const to = d->word + 4*(size_t)(row - rows->walls);

            to[0] = near->first;
            to[1] = near->count;
            to[2] = near->open;
            to[3] = code_of(near->image);
        }
    }
    return dem_opencl_put(d->cl, &d->list[d->at].near, 4*n*sizeof *d->word, d->word);
}

/* ---- the device's lists ------------------------------------------------------------------------ */

int dem_device_wrap_walls(struct dem_device *d, struct dem_state *state)
{
    dem_walls_wrap(&state->walls);
    return put_images(d, &state->walls);
}

int dem_device_find_candidates(struct dem_device *d, const struct dem_state *state)
{
    const size_t n = state->particles.n;
    uint32_t candidates = 0;

    if (!d->of_triangles)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_device_clear(d, &d->candidate_start, n));
    for (uint32_t counting = 1;; counting = 0)
    {
        DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_triangles, 0, &d->lists));
        DEM_TRY(dem_opencl_give_number(d->cl, d->of_triangles, 1, counting));
        DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_triangles, 2, &d->record, &d->triangles, &d->facets,
                                &d->frames, &d->images, &d->grid_first, &d->grid,
                                &d->candidate_start, &d->candidates));
        DEM_TRY(dem_opencl_launch(d->cl, d->of_triangles, n));
        if (!counting)
        {
            return DEM_OK;
        }
        DEM_TRY(dem_device_scan(d, &d->candidate_start, n));
        DEM_TRY(dem_opencl_read(d->cl, &d->candidate_start, n*sizeof candidates, sizeof candidates,
                                &candidates));
        DEM_TRY(dem_opencl_reserve(d->cl, &d->candidates, candidates*sizeof candidates));
    }
}

int dem_device_find_near(struct dem_device *d, const struct dem_state *state)
{
    struct dem_device_rows *const list = &d->list[d->at];

    if (!d->of_near)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &list->near,
                               4*(size_t)(list->rows - list->walls)*sizeof *d->word));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_near, 0, &d->lists, &d->record, &d->triangles, &d->facets,
                            &d->frames, &d->images, &list->start, &list->entry, &list->partners,
                            &d->candidate_start, &d->candidates, &list->near));
    return dem_opencl_launch(d->cl, d->of_near, state->particles.n);
}

/* ---- steps ------------------------------------------------------------------------------------- */

int dem_device_give_facets(struct dem_device *d)
{
    struct dem_device_rows *const list = &d->list[d->at];

    if (!d->of_facets)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_reserve(d->cl, &d->contacts,
                               8*(size_t)(list->rows - list->walls)*sizeof(double)));
    DEM_TRY(DEM_OPENCL_GIVE(d->cl, d->of_facets, 0, &d->batch, &d->report));
    DEM_TRY(dem_opencl_give_number(d->cl, d->of_facets, 3, DEM_MATERIALS));
    return DEM_OPENCL_GIVE(d->cl, d->of_facets, 4, &d->record, &list->partners, &d->facets,
                           &d->frames, &list->start, &list->entry, &list->touch, &list->history,
                           &list->near, &d->candidates, &d->triangles, &d->images, &d->wall_class,
                           &d->contacts);
}

int dem_device_launch_facets(struct dem_device *d, const struct dem_state *state, uint32_t s)
{
    const struct dem_device_rows *const list = &d->list[d->at];

    if (!d->of_facets || list->rows == list->walls)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_opencl_give_number(d->cl, d->of_facets, 2, s));
    return dem_opencl_launch(d->cl, d->of_facets, state->particles.n);
}
