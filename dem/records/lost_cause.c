/*
 * lost_cause.c -- compose the cause of a loss: where the particle left, past which wall, and why.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/lost_cause.h"
#include "core/error.h"
#include "core/vec.h"
#include "records/lost_particles.h"
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Overlaps below this fraction of the smaller diameter are not a cause: packings at rest have such
   overlaps. */
static const double min_overlap = 0.1;

static void append(char cause[DEM_LOST_CAUSE_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void append(char cause[DEM_LOST_CAUSE_SIZE], const char *format, ...)
{
    const size_t used = strlen(cause);
    va_list rest;

    va_start(rest, format);
    vsnprintf(cause + used, DEM_LOST_CAUSE_SIZE - used, format, rest);
    va_end(rest);
}

static const char *wall_name(const struct dem_state *state, const struct dem_pair *q)
{
    return state->walls.wall[state->walls.facet[dem_pairs_facet(&state->pairs, q->j)].wall].name;
}

/* ---- where ----------------------------------------------------------------------------------- */

/* The side of the domain that the particle left through: of those that it is beyond, the one that
   it crossed first. */
static void append_side(const struct dem_domain *d, const struct dem_particle *i,
                        char cause[DEM_LOST_CAUSE_SIZE])
{
    double longest = -1.0;
    int axis = 0, high = 0;

    for (int k = 0; k < 6; k++)
    {
        const double out = k < 3 ? d->min[k] - i->x[k] : i->x[k - 3] - d->max[k - 3];
        const double speed = k < 3 ? -i->v[k] : i->v[k - 3],
                     ago = speed > 0.0 ? out/speed : DBL_MAX;

        if (out > 0.0 && ago > longest)
        {
            longest = ago;
            axis = k%3;
            high = k/3;
        }
    }
    append(cause, "left through domain %s %c at %.3g m/s", high ? "max" : "min", 'x' + axis,
           dem_vec_norm(i->v));
}

/* The wall that the particle is farthest behind, or the nearest one in its list. */
static void append_wall(const struct dem_state *state, size_t i, char cause[DEM_LOST_CAUSE_SIZE])
{
    const struct dem_contacts *const c = &state->contacts;
    const struct dem_pair *nearest = NULL;
    double min = DBL_MAX;

    for (uint32_t e = c->pairs.start[i]; e < c->pairs.start[i + 1]; e++)
    {
        const struct dem_pair *const q = &c->pairs.pair[c->pairs.entry[e] >> 1];

        if (q->wall)
        {
            const double distance = dem_wall_search_distance(&state->pairs.wall_search, &state->walls,
                                                             &state->pairs.wall_search.neighbor[q->j],
                                                             state->particles.record[i].x);

            nearest = distance < min ? q : nearest;
            min = fmin(min, distance);
        }
    }
    if (!nearest)
    {
        append(cause, ", no wall there");
    }
    else
    {
        append(cause, min < 0.0 ? ", %.3g m behind wall %s" : ", its centre %.3g m from wall %s",
               fabs(min), wall_name(state, nearest));
    }
}

/* ---- why ------------------------------------------------------------------------------------- */

/* Overlap of a row's partners [m]: at a wall as in the last sweep, at a pair at the present
   positions. */
static double overlap_of(const struct dem_state *state, uint32_t r)
{
    const struct dem_pair *const q = dem_contacts_pair(&state->contacts, r);

    if (q->wall)
    {
        return dem_contacts_wall_force(&state->contacts, r)->arm;
    }
    const struct dem_particle *const i = &state->particles.record[q->i];
    const struct dem_particle *const j = &state->particles.record[q->j];
    double apart[3];

    for (int k = 0; k < 3; k++)
    {
        apart[k] = i->x[k] - j->x[k] + state->pairs.shift[q->shift][k];
    }
    return i->radius + j->radius - dem_vec_norm(apart);
}

/* The row of particle i with the largest overlap, other than `row`; DEM_ROW_NONE when all are below
   min_overlap. `overlap`: as a fraction of the smaller diameter. */
static uint32_t worst_row(const struct dem_state *state, size_t i, uint32_t row, double *overlap)
{
    const struct dem_contacts *const c = &state->contacts;
    uint32_t worst = DEM_ROW_NONE;

    *overlap = min_overlap;
    for (uint32_t e = c->rows.start[i]; e < c->rows.start[i + 1]; e++)
    {
        const uint32_t r =
            dem_contact_forces_row(&c->forces, &c->rows, i, c->rows.entry[e]);

        if (r >= c->rows.n)
        {
            continue;
        }
        const struct dem_pair *const q = dem_contacts_pair(c, r);
        const double radius = state->particles.record[q->i].radius;
        const double smaller = q->wall ? radius : fmin(radius, state->particles.record[q->j].radius);
        const double fraction = 0.5*overlap_of(state, r)/smaller;

        if (r != row && fraction > *overlap)
        {
            *overlap = fraction;
            worst = r;
        }
    }
    return worst;
}

/* Returns 1 when a reason was found. */
static int append_reason(const struct dem_state *state, size_t i, uint32_t row,
                         char cause[DEM_LOST_CAUSE_SIZE])
{
    const struct dem_particle *const q = &state->particles.record[i];
    const double radii = dem_vec_norm(q->v)*state->dt/q->radius;
    double overlap;

    if (radii > 0.5)
    {
        append(cause, ": it moves %.2g radii a step; reduce time/step", radii);
        return 1;
    }
    const uint32_t worst = worst_row(state, i, row, &overlap);

    if (worst != DEM_ROW_NONE)
    {
        const struct dem_pair *const pair = dem_contacts_pair(&state->contacts, worst);

        if (pair->wall)
        {
            append(cause, ": squeezed, overlap %.3g %% with wall %s", 100.0*overlap,
                   wall_name(state, pair));
        }
        else
        {
            append(cause, ": squeezed, overlap %.3g %% with particle %lld", 100.0*overlap,
                (long long)state->particles.record[pair->i == i ? pair->j : pair->i].id);
        }
        append(cause, "; use a stiffer material or a smaller time/step");
        return 1;
    }
    return 0;
}

void dem_lost_cause_outside(const struct dem_state *state, size_t i, char cause[DEM_LOST_CAUSE_SIZE])
{
    cause[0] = 0;
    append_side(&state->domain, &state->particles.record[i], cause);
    if (state->lists_state != DEM_NEIGHBORS_NONE && !state->contacts_on_device)
    {
        append_wall(state, i, cause);
        append_reason(state, i, DEM_ROW_NONE, cause);
    }
}

/* A wall with two sides turns its normal round where the centre passes. The overlap was half of a
   diameter then: where maxOverlap is not larger, the run ends, as at a wall with one side. */
static const double overlap_of_passage = 0.5*(1.0 + 0x1p-20);

int dem_lost_cause_record_crossings(struct dem_state *state)
{
    const struct dem_pair *lawless = NULL, *first = NULL;
    char reason[DEM_LOST_CAUSE_SIZE] = "";
    int status = DEM_OK;

    for (size_t k = 0; k < state->lost_particles->crossings && !status; k++)
    {
        const uint32_t row = state->lost_particles->crossed[k];
        const struct dem_pair *const q = dem_contacts_pair(&state->contacts, row);
        const struct dem_particle *const i = &state->particles.record[q->i];
        char cause[DEM_LOST_CAUSE_SIZE] = "";

        append(cause, "passed wall %s at %.3g m/s", wall_name(state, q), dem_vec_norm(i->v));
        const size_t length = strlen(cause);

        if (!dem_effect_list_has_law(&state->interaction_table.list[q->class]))
        {
            append(cause, ": no contact law acts between them");
            lawless = q;
        }
        else if (!append_reason(state, q->i, row, cause))
        {
            append(
                cause,
                ": too fast or too heavy for the stiffness of their contact; use a stiffer material");
        }
        if (!first)
        {
            first = q;
            snprintf(reason, sizeof reason, "%s", cause + length);
        }
        status = dem_lost_particles_add(state->lost_particles, i, state->time, 0, cause);
    }
    state->lost_particles->passages += (int64_t)state->lost_particles->crossings;
    state->lost_particles->crossings = 0;
    DEM_REQUIRE(
        status || !lawless, DEM_ERROR_LOST,
        "particle %lld has passed wall %s at time %g s: no contact law acts between them; add a normal law to effects, hertz {} "
        "for example",
        (long long)state->particles.record[lawless->i].id, wall_name(state, lawless), state->time);
    DEM_REQUIRE(
        status || !first || state->limits.overlap_limit > overlap_of_passage, DEM_ERROR_LOST,
        "particle %lld has passed wall %s at time %g s, with an overlap of half of a diameter; the limit time/maxOverlap is "
        "%g%s",
        (long long)state->particles.record[first->i].id, wall_name(state, first), state->time,
        state->limits.overlap_limit, reason);
    return status;
}
