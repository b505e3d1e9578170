/*
 * loss_cause.c -- one clause where, one clause by whom, one clause why.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/loss_cause.h"
#include "base/vec.h"
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Who presses by less than this share of a diameter is no cause: packings rest at less. */
static const double worth_telling = 0.1;

static void say(char cause[DEM_CAUSE_SIZE], const char *format, ...) __attribute__((format(printf, 2, 3)));

static void say(char cause[DEM_CAUSE_SIZE], const char *format, ...)
{
    const size_t used = strlen(cause);
    va_list rest;

    va_start(rest, format);
    vsnprintf(cause + used, DEM_CAUSE_SIZE - used, format, rest);
    va_end(rest);
}

static const char *wall_name(const struct dem_parts *p, const struct dem_pair *q)
{
    return p->walls.wall[p->walls.region[p->pairs.wall_region[q->j]].wall].name;
}

/* ---- where --------------------------------------------------------------------------------------------------- */

/* The side that it went through: of those that it is beyond, the one that it crossed first. */
static void say_side(const struct dem_domain *d, const struct dem_particle *i, char cause[DEM_CAUSE_SIZE])
{
    double longest = -1.0;
    int axis = 0, high = 0;

    for (int k = 0; k < 6; k++)
    {
        const double out = k < 3 ? d->min[k] - i->x[k] : i->x[k - 3] - d->max[k - 3];
        const double speed = k < 3 ? -i->v[k] : i->v[k - 3], ago = speed > 0.0 ? out/speed : DBL_MAX;

        if (out > 0.0 && ago > longest)
        {
            longest = ago;
            axis = k%3;
            high = k/3;
        }
    }
    say(cause, "left through domain %s %c at %.3g m/s", high ? "max" : "min", 'x' + axis, dem_vec_norm(i->v));
}

/* The wall that it is deepest behind, or the nearest one in reach. */
static void say_wall(const struct dem_parts *p, size_t i, char cause[DEM_CAUSE_SIZE])
{
    const struct dem_contacts *const c = &p->contacts;
    const struct dem_pair *nearest = NULL;
    double least = DBL_MAX;

    for (uint32_t e = c->start[i]; e < c->start[i + 1]; e++)
    {
        const struct dem_pair *const q = &c->pair[c->entry[e] >> 1];

        if (q->wall)
        {
            const double distance = dem_wall_search_distance(&p->pairs.search, &p->walls, &p->pairs.search.near[q->j],
                                                             p->particles.record[i].x);

            nearest = distance < least ? q : nearest;
            least = fmin(least, distance);
        }
    }
    if (!nearest)
    {
        say(cause, ", no wall there");
    }
    else
    {
        say(cause, least < 0.0 ? ", %.3g m behind wall %s" : ", its centre %.3g m from wall %s", fabs(least), wall_name(p, nearest));
    }
}

/* ---- why ----------------------------------------------------------------------------------------------------- */

/* Of a row's partners [m]: with a wall as in the last sweep, else as they lie now. */
static double overlap_of(const struct dem_parts *p, uint32_t r)
{
    const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[r]];

    if (q->wall)
    {
        return dem_contacts_push(&p->contacts, r).arm;
    }
    const struct dem_particle *const i = &p->particles.record[q->i], *const j = &p->particles.record[q->j];
    double apart[3];

    for (int k = 0; k < 3; k++)
    {
        apart[k] = i->x[k] - j->x[k] + p->pairs.shift[q->shift][k];
    }
    return i->radius + j->radius - dem_vec_norm(apart);
}

/* The row of particle i with the largest overlap, other than `row`; DEM_ROW_NONE when none is worth it. */
static uint32_t worst_row(const struct dem_parts *p, size_t i, uint32_t row, double *overlap)
{
    const struct dem_contacts *const c = &p->contacts;
    uint32_t worst = DEM_ROW_NONE;

    *overlap = worth_telling;
    for (uint32_t e = c->near_start[i]; e < c->near_start[i + 1]; e++)
    {
        const uint32_t r = c->near_entry[e] >> DEM_ENTRY_ROW;

        if (r >= c->rows)
        {
            continue;
        }
        const struct dem_pair *const q = &c->pair[c->row_pair[r]];
        const double radius = p->particles.record[q->i].radius;
        const double least = q->wall ? radius : fmin(radius, p->particles.record[q->j].radius);
        const double share = 0.5*overlap_of(p, r)/least;

        if (r != row && share > *overlap)
        {
            *overlap = share;
            worst = r;
        }
    }
    return worst;
}

/* Returns 1 when there is something to say. */
static int say_why(const struct dem_parts *p, size_t i, uint32_t row, char cause[DEM_CAUSE_SIZE])
{
    const struct dem_particle *const q = &p->particles.record[i];
    const double radii = dem_vec_norm(q->v)*p->dt/q->radius;
    double overlap;

    if (radii > 0.5)
    {
        say(cause, ": it moves %.2g radii a step; reduce time/step", radii);
        return 1;
    }
    const uint32_t worst = worst_row(p, i, row, &overlap);

    if (worst != DEM_ROW_NONE)
    {
        const struct dem_pair *const pair = &p->contacts.pair[p->contacts.row_pair[worst]];

        if (pair->wall)
        {
            say(cause, ": squeezed, overlap %.3g %% with wall %s", 100.0*overlap, wall_name(p, pair));
        }
        else
        {
            say(cause, ": squeezed, overlap %.3g %% with particle %lld", 100.0*overlap,
                (long long)p->particles.record[pair->i == i ? pair->j : pair->i].id);
        }
        say(cause, "; use a stiffer material or a smaller time/step");
        return 1;
    }
    return 0;
}

void dem_loss_cause_outside(const struct dem_parts *p, size_t i, char cause[DEM_CAUSE_SIZE])
{
    cause[0] = 0;
    say_side(&p->domain, &p->particles.record[i], cause);
    if (p->stale < 2)                                     /* else there are no lists to look into */
    {
        say_wall(p, i, cause);
        say_why(p, i, DEM_ROW_NONE, cause);
    }
}

int dem_loss_note_passes(struct dem_parts *p)
{
    int status = DEM_OK;

    for (size_t k = 0; k < p->losses.passes && !status; k++)
    {
        const uint32_t row = p->losses.pass[k];
        const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[row]];
        const struct dem_particle *const i = &p->particles.record[q->i];
        char cause[DEM_CAUSE_SIZE] = "";

        say(cause, "passed wall %s at %.3g m/s", wall_name(p, q), dem_vec_norm(i->v));
        if (!say_why(p, q->i, row, cause))
        {
            say(cause, ": too fast or too heavy for the stiffness of their contact; use a stiffer material");
        }
        status = dem_losses_note(&p->losses, i, p->time, 0, cause);
    }
    p->losses.passes = 0;
    return status;
}
