/*
 * wall_wear.c -- find the triangle of each contact with a wall that wears, and sum; the sums in
 * snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/wall_wear.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include "records/wall_statistics.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* 1/m3: of the unit; a digit */
static const double units = 0x1p120, base = 0x1p32;

static const char mark[] = "@wear ";

/* The sums, then as many of the last backup. */
int dem_wall_wear_begin(struct dem_state *state)
{
    return state->walls.wearing > 0 ? DEM_NEW(state->wall_statistics->wear,
                                              2*dem_walls_count_triangles(&state->walls) + 1)
                                    : DEM_OK;
}

/* Each digit but the highest is less than 2^32 afterwards. */
static void carry_over(struct dem_wear_sum *s)
{
    for (int k = 0; k < DEM_WEAR_DIGITS - 1; k++)
    {
        s->digit[k + 1] += s->digit[k] >> 32;
        s->digit[k] &= 0xffffffff;
    }
}

/* All digits of a double are exact. */
static void add(struct dem_wear_sum *s, double volume)
{
    double rest = rint(volume*units), weight = base*base*base;

    for (int k = DEM_WEAR_DIGITS - 1; k >= 0; k--, weight /= base)
    {
        const double digit = floor(rest/weight);

        rest -= digit*weight;
        s->digit[k] += (int64_t)digit;
    }
    carry_over(s);
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
   the wall's frame; of equally near ones the lowest. The point lies on the facet but for round-off, so a
   radius is far enough. The last reach, a radius, is rounded and may be larger: so the loop goes to 2. */
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
    DEM_REQUIRE(isfinite(best), DEM_ERROR_NUMBER,
                "wall %s: no triangle is within a radius, %g m, of the contact at (%g %g %g) m that wears it; "
                "place the wall nearer to the origin, or leave out its wear",
                w->wall[w->facet[facet].wall].name, radius, x[0], x[1], x[2]);
    return DEM_OK;
}

/* f of wall_wear.h [m2/s2] */
static double finnie(double vn, double vt)
{
    return 3.0*vn <= vt ? vn*(2.0*vt - 3.0*vn) : vt*vt/3.0;
}

/* m f of a contact that begins in this step, else 0 [J]: the velocity of the centre over the wall. */
static double impact(const struct dem_contact_workspace *t, int c)
{
    const struct dem_contact_batch *const b = &t->batch;
    const double v[3] = {t->gathered.vx[c], t->gathered.vy[c], t->gathered.vz[c]},
                 n[3] = {b->hx[c], b->hy[c], b->hz[c]}, vn = -dem_vec_dot(v, n);
    double along[3];

    for (int k = 0; k < 3; k++)
    {
        along[k] = v[k] + vn*n[k];
    }
    return b->overlap[c] <= vn*b->dt ? b->reduced_mass[c]*finnie(vn, dem_vec_norm(along)) : 0.0;
}

/* F_n |v_t| dt [J] */
static double sliding(const struct dem_contact_batch *b, int c)
{
    return b->fn[c]*b->dt*sqrt(b->sx[c]*b->sx[c] + b->sy[c]*b->sy[c] + b->sz[c]*b->sz[c]);
}

int dem_wall_wear_add(struct dem_state *state, const struct dem_contact_workspace *t, uint32_t row, int rows)
{
    const struct dem_contact_batch *const b = &t->batch;

    for (int c = 0; c < rows; c++)
    {
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row + (uint32_t)c);
        const int facet = dem_pairs_facet(&state->pairs, q->j), wall = state->walls.facet[facet].wall;
        const struct dem_wall *const of = &state->walls.wall[wall];
        const double volume = of->wear > 0.0 && b->touching[c] > 0.0
                                ? of->wear*(of->wears_by_impact ? impact(t, c) : sliding(b, c))
                                : 0.0;
        uint32_t triangle = 0;
        double own[3];

        if (volume > 0.0 && isfinite(volume))
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

/* ---- reading --------------------------------------------------------------------------------- */

/* The sum of the first triangle of a wall; triangles are sorted by wall. */
static struct dem_wear_sum *sums_of(const struct dem_state *state, int wall)
{
    size_t first = 0;

    for (int k = 0; k < wall; k++)
    {
        first += state->walls.wall[k].triangles;
    }
    return state->wall_statistics->wear + first;
}

static void gather(struct dem_state *state, struct dem_wear_sum *sum, size_t n)
{
    dem_collect_sum_int64_to_first(&state->decomposition, sum[0].digit, n*DEM_WEAR_DIGITS);
    for (size_t k = 0; k < n; k++)
    {
        if (state->decomposition.rank > 0)
        {
            sum[k] = (struct dem_wear_sum){.digit = {0}};
        }
        carry_over(&sum[k]);
    }
}

void dem_wall_wear_gather(struct dem_state *state)
{
    if (state->wall_statistics->wear)
    {
        gather(state, state->wall_statistics->wear, dem_walls_count_triangles(&state->walls));
    }
}

int dem_wall_wear_volumes(struct dem_state *state, int wall, double *volume)
{
    const size_t n = state->walls.wall[wall].triangles;
    struct dem_wear_sum *const sum = state->wall_statistics->wear ? sums_of(state, wall) : NULL;

    if (sum)
    {
        gather(state, sum, n);
    }
    for (size_t k = 0; k < n && state->decomposition.rank == 0; k++)
    {
        volume[k] = sum ? value_of(&sum[k]) : 0.0;
    }
    return dem_collect_status(&state->decomposition);
}

/* ---- backups and snapshots ------------------------------------------------------------------- */

static void copy(struct dem_state *state, int back)
{
    struct dem_wear_sum *const now = state->wall_statistics->wear;
    const size_t n = dem_walls_count_triangles(&state->walls);

    if (now)
    {
        memcpy(back ? now : now + n, back ? now + n : now, n*sizeof *now);
    }
}

void dem_wall_wear_backup(struct dem_state *state)
{
    copy(state, 0);
}

void dem_wall_wear_restore(struct dem_state *state)
{
    copy(state, 1);
}

static int is_zero(const struct dem_wear_sum *s)
{
    int64_t any = 0;

    for (int k = 0; k < DEM_WEAR_DIGITS; k++)
    {
        any |= s->digit[k];
    }
    return any == 0;
}

void dem_wall_wear_describe(const struct dem_state *state, struct dem_text *t)
{
    for (int w = 0; w < state->walls.walls && state->wall_statistics->wear; w++)
    {
        const struct dem_wall *const wall = &state->walls.wall[w];
        const struct dem_wear_sum *const sum = sums_of(state, w);

        if (wall->wear <= 0.0)
        {
            continue;
        }
        dem_text_add(t, "%s%s", mark, wall->name);
        for (size_t k = 0; k < wall->triangles; k++)
        {
            if (!is_zero(&sum[k]))
            {
                dem_text_add(t, " %zu", k);
                for (int digit = 0; digit < DEM_WEAR_DIGITS; digit++)
                {
                    dem_text_add(t, " %lld", (long long)sum[k].digit[digit]);
                }
            }
        }
        dem_text_add(t, "\n");
    }
}

/* The next number of a line, from 0 to below `end`; *good becomes 0 without one. */
static int64_t take(const char **at, int64_t end, int *good)
{
    char *rest;
    const int ends = (*at)[strspn(*at, " ")] == '\n';
    const long long number = strtoll(*at, &rest, 10);

    *good &= !ends && rest != *at && number >= 0 && number < end;
    *at = rest;
    return *good ? number : 0;
}

int dem_wall_wear_resume(struct dem_state *state, int wall, const char *text, const char *path)
{
    const struct dem_wall *const of = &state->walls.wall[wall];
    struct dem_wear_sum *const sum = sums_of(state, wall);
    const char *words;
    int good = 1;

    while ((words = dem_text_marked(&text, mark)))
    {
        const char *at = dem_text_after(words, of->name);

        while (at && *at && *at != '\n' && good)
        {
            struct dem_wear_sum *const s = &sum[take(&at, (int64_t)of->triangles, &good)];

            for (int k = 0; k < DEM_WEAR_DIGITS; k++)
            {
                s->digit[k] = take(&at, k < DEM_WEAR_DIGITS - 1 ? INT64_C(1) << 32 : INT64_MAX, &good);
            }
        }
    }
    DEM_REQUIRE(good, DEM_ERROR_FILE, "%s is damaged: the wear of wall %s in it names no triangle or volume "
                "of this wall; use another one", path, of->name);
    return DEM_OK;
}
