/*
 * bond_pairs.c -- sort the list of pairs, look up each contact row in it, and check that each pair
 * was found on some rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/bond_pairs.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct listed_pair
{
    int64_t low, high;
};

static int compare(const void *a, const void *b)
{
    const struct listed_pair *const s = a, *const t = b;
    const int low = (s->low > t->low) - (s->low < t->low);

    return low ? low : (s->high > t->high) - (s->high < t->high);
}

/* Returns the number of different pairs. */
static size_t sort_list(const int64_t *ids, size_t pairs, struct listed_pair *list)
{
    size_t different = 0;

    for (size_t k = 0; k < pairs; k++)
    {
        const int64_t a = ids[2*k], b = ids[2*k + 1];

        list[k] = (struct listed_pair){.low = a < b ? a : b, .high = a < b ? b : a};
    }
    dem_sort_by(list, pairs, sizeof *list, compare);
    for (size_t k = 0; k < pairs; k++)
    {
        if (k == 0 || compare(&list[k], &list[different - 1]) != 0)
        {
            list[different++] = list[k];
        }
    }
    return different;
}

static void mark(struct dem_state *state, const struct listed_pair *list, size_t pairs, double *column,
                 uint8_t *found)
{
    const struct dem_contacts *const c = &state->contacts;

    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        const struct dem_pair *const q =
            c->rows.pair[r] == DEM_ROW_NONE ? NULL : dem_contacts_pair(c, r);

        if (q && !q->wall)
        {
            const struct listed_pair key = {.low = state->particles.record[q->i].id,
                                            .high = state->particles.record[q->j].id};
            const struct listed_pair *const hit = bsearch(&key, list, pairs, sizeof key, compare);

            if (hit)
            {
                column[r] = 1.0;
                found[hit - list] = 1;
            }
        }
    }
}

/* The chosen effect with a listed_column of that name, or with any if it is NULL; NULL: none. */
static const struct dem_effect *effect_of_column(const struct dem_interaction_table *r,
                                                 const char *column)
{
    for (int k = 0; k < r->chosen; k++)
    {
        const char *const listed = r->effect[k]->listed_column;

        if (listed && (!column || strcmp(listed, column) == 0))
        {
            return r->effect[k];
        }
    }
    return NULL;
}

struct ends    /* of a pair without a row, of the lower and the higher id */
{
    int64_t there[2], fixed[2], body[2];
    double radius[2], x[2][3];
};

/* Collective. */
static void find_ends(const struct dem_state *state, const struct listed_pair *pair, struct ends *e)
{
    *e = (struct ends){.there = {0, 0}};
    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];

        for (int k = 0; k < 2; k++)
        {
            if (q->id == (k == 0 ? pair->low : pair->high))
            {
                e->there[k] = 1;
                e->fixed[k] = (q->flags & DEM_PARTICLE_FROZEN) != 0;
                e->body[k] = q->body;
                e->radius[k] = q->radius;
                memcpy(e->x[k], q->x, sizeof e->x[k]);
            }
        }
    }
    dem_collect_sum_int64(&state->decomposition, e->there, 2);
    dem_collect_sum_int64(&state->decomposition, e->fixed, 2);
    dem_collect_sum_int64(&state->decomposition, e->body, 2);
    dem_collect_sum_double(&state->decomposition, e->radius, 2);
    dem_collect_sum_double(&state->decomposition, e->x[0], 3);
    dem_collect_sum_double(&state->decomposition, e->x[1], 3);
}

/* Between the centres, of the nearest images in a box that is not sheared [m]. */
static double distance_of(const struct dem_domain *d, const struct ends *e)
{
    double r[3];

    for (int k = 0; k < 3; k++)
    {
        r[k] = e->x[1][k] - e->x[0][k];
        r[k] -= d->length[k] > 0.0 ? d->length[k]*round(r[k]/d->length[k]) : 0.0;
    }
    return dem_vec_norm(r);
}

/* Collective. Why a pair of the list has no row. */
static int explain_missing(const struct dem_state *state, const struct listed_pair *pair)
{
    const struct dem_effect *const bond = effect_of_column(&state->interaction_table, NULL);
    const long long low = (long long)pair->low, high = (long long)pair->high;
    struct ends e;

    find_ends(state, pair, &e);
    DEM_REQUIRE(e.there[0] && e.there[1], DEM_ERROR_INPUT, "bonds/pairs: (%lld %lld), but there is no particle %lld; "
                "correct the list", low, high, e.there[0] ? high : low);
    DEM_REQUIRE(!e.fixed[0] || !e.fixed[1], DEM_ERROR_INPUT,
                "bonds/pairs: particles %lld and %lld are frozen or driven, so neither is free "
                "to move and a bond between them would do nothing; take the pair off the list, "
                "or set one of them free", low, high);
    DEM_REQUIRE(e.body[0] == 0 || e.body[0] != e.body[1], DEM_ERROR_INPUT,
                "bonds/pairs: particles %lld and %lld are spheres of one clump, which is rigid: a bond "
                "between them would do nothing; take the pair off the list", low, high);
    return dem_error(DEM_ERROR_INPUT,
                     "bonds/pairs: the centres of particles %lld and %lld are %.4g m apart, %.4g times the sum of "
                     "their radii, which is beyond makeDistance and breakDistance of %s; correct the list, or raise "
                     "both", low, high, distance_of(&state->domain, &e),
                     distance_of(&state->domain, &e)/(e.radius[0] + e.radius[1]), bond ? bond->name : "a bond");
}

static int check_found(const struct dem_state *state, const struct listed_pair *list, size_t pairs,
                       uint8_t *found)
{
    dem_collect_max_uint8(&state->decomposition, found, pairs);
    DEM_TRY(dem_collect_agree(&state->decomposition, DEM_OK));
    for (size_t k = 0; k < pairs; k++)
    {
        DEM_TRY(found[k] ? DEM_OK : explain_missing(state, &list[k]));
    }
    return DEM_OK;
}

static void mark_all(struct dem_state *state, const struct listed_pair *list, size_t pairs,
                     uint8_t *found)
{
    for (int m = 0; m < state->interaction_table.history_columns; m++)
    {
        if (effect_of_column(&state->interaction_table, state->interaction_table.history_name[m]))
        {
            mark(state, list, pairs, state->contacts.history.column[m], found);
        }
    }
}

int dem_bond_pairs_mark(struct dem_state *state, const int64_t *ids, size_t count)
{
    size_t pairs = count/2;

    struct listed_pair *list = NULL;
    uint8_t *found = NULL;
    int status = DEM_NEW(list, pairs + 1);

    status = status ? status : DEM_NEW(found, pairs + 1);
    status = dem_collect_agree(&state->decomposition, status);
    if (!status)
    {
        pairs = sort_list(ids, pairs, list);
        mark_all(state, list, pairs, found);
        status = check_found(state, list, pairs, found);
    }
    dem_memory_free(list);
    dem_memory_free(found);
    return status;
}
