/*
 * wall_wear.c -- find the triangle of each sliding contact with a wall that wears, and sum.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/wall_wear.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include "records/wall_statistics.h"
#include <math.h>
#include <string.h>

/* 1/m3: of the unit; a digit */
static const double units = 0x1p120, base = 0x1p32;

int dem_wall_wear_begin(struct dem_state *state)
{
    return state->walls.wearing > 0 ? DEM_NEW(state->wall_statistics->wear,
                                              dem_walls_count_triangles(&state->walls) + 1)
                                    : DEM_OK;
}

/* All digits of a double are exact. */
static void add(struct dem_wear_sum *s, double volume)
{
    double rest = rint(volume*units), weight = base*base*base;
    int64_t carry = 0;

    for (int k = DEM_WEAR_DIGITS - 1; k >= 0; k--, weight /= base)
    {
        const double digit = floor(rest/weight);

        rest -= digit*weight;
        s->digit[k] += (int64_t)digit;
    }
    for (int k = 0; k < DEM_WEAR_DIGITS - 1; k++)
    {
        s->digit[k] += carry;
        carry = s->digit[k] >> 32;
        s->digit[k] -= carry << 32;
    }
    s->digit[DEM_WEAR_DIGITS - 1] += carry;
}

static double value_of(const struct dem_wear_sum *s)
{
    double value = 0.0;

    for (int k = DEM_WEAR_DIGITS - 1; k >= 0; k--)
    {
        value = value*base + (double)s->digit[k];
    }
    return value/units;
}

/* The index, among the triangles of all ranks, of the triangle of a facet that is nearest to a point of
   the wall's frame; of equally near ones the lowest. The search widens from a point on the facet. */
static int find_triangle(struct dem_state *state, int facet, const double x[3], double radius,
                         uint32_t *index)
{
    struct dem_wall_search *const s = &state->pairs.wall_search;
    const struct dem_walls *const w = &state->walls;
    const size_t first = s->candidates;
    double best = INFINITY, on[3], moved[3];

    for (double reach = 1e-3*radius; reach <= 2.0*radius && !isfinite(best); reach *= 10.0)
    {
        DEM_TRY(dem_wall_search_gather(s, w, w->wall[w->facet[facet].wall].frame, x, reach));
        for (size_t c = first; c < s->candidates; c++)
        {
            const struct dem_triangle *const t = &w->triangle[s->candidate[c]];
            const double away = dem_triangle_nearest(
                t, dem_wall_from_candidate(s, w, (uint32_t)c, x, moved), on);

            if (t->facet == facet && (away < best || (away <= best && t->index < *index)))
            {
                best = away;
                *index = t->index;
            }
        }
        s->candidates = first;
    }
    return DEM_OK;
}

int dem_wall_wear_add(struct dem_state *state, const struct dem_contact_batch *b, uint32_t row, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row + (uint32_t)c);
        const int facet = dem_pairs_facet(&state->pairs, q->j), wall = state->walls.facet[facet].wall;
        const double speed = sqrt(b->sx[c]*b->sx[c] + b->sy[c]*b->sy[c] + b->sz[c]*b->sz[c]);
        const double volume = state->walls.wall[wall].wear*b->fn[c]*speed*b->dt;
        uint32_t triangle = 0;
        double own[3];

        if (b->touching[c] > 0.0 && volume > 0.0 && isfinite(volume))
        {
            DEM_TRY(find_triangle(state, facet,
                                  dem_walls_to_frame(&state->walls, wall,
                                                     state->touches.touch[q->j].point, own),
                                  b->min_radius[c], &triangle));
            add(&state->wall_statistics->wear[triangle], volume);
        }
    }
    return DEM_OK;
}

int dem_wall_wear_volumes(const struct dem_state *state, int wall, double *volume)
{
    const struct dem_walls *const w = &state->walls;
    const size_t n = w->wall[wall].triangles;
    struct dem_wear_sum *sum;
    size_t first = 0;

    /* triangles are sorted by wall */
    for (int k = 0; k < wall; k++)
    {
        first += w->wall[k].triangles;
    }
    DEM_TRY(dem_collect_agree(&state->decomposition, DEM_NEW(sum, n + 1)));
    if (state->wall_statistics->wear)
    {
        memcpy(sum, state->wall_statistics->wear + first, n*sizeof *sum);
    }
    dem_collect_sum_int64_to_first(&state->decomposition, sum[0].digit, n*DEM_WEAR_DIGITS);
    for (size_t k = 0; k < n && state->decomposition.rank == 0; k++)
    {
        volume[k] = value_of(&sum[k]);
    }
    dem_memory_free(sum);
    return dem_collect_status(&state->decomposition);
}
