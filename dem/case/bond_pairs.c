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
#include "ranks/collect.h"
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

static void sort_list(const int64_t *ids, size_t pairs, struct listed_pair *list)
{
    for (size_t k = 0; k < pairs; k++)
    {
        const int64_t a = ids[2*k], b = ids[2*k + 1];

        list[k] = (struct listed_pair){.low = a < b ? a : b, .high = a < b ? b : a};
    }
    dem_sort_by(list, pairs, sizeof *list, compare);
}

static void mark(struct dem_state *p, const struct listed_pair *list, size_t pairs, double *column,
                 uint8_t *found)
{
    const struct dem_contacts *const c = &p->contacts;

    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        const struct dem_pair *const q =
            c->rows.pair[r] == DEM_ROW_NONE ? NULL : dem_contacts_pair(c, r);

        if (q && !q->wall)
        {
            const struct listed_pair key = {.low = p->particles.record[q->i].id,
                                            .high = p->particles.record[q->j].id};
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

/* Collective: both particles of a pair are frozen or driven. */
static int neither_is_free(const struct dem_state *p, const struct listed_pair *pair)
{
    int64_t fixed = 0;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        fixed += (q->id == pair->low || q->id == pair->high) && q->flags & DEM_PARTICLE_FROZEN;
    }
    dem_collect_sum_int64(&p->decomposition, &fixed, 1);
    return fixed == 2;
}

/* Collective. */
static int are_of_one_clump(const struct dem_state *p, const struct listed_pair *pair)
{
    int64_t body[2] = {0, 0};

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const q = &p->particles.record[i];

        body[0] += q->id == pair->low ? q->body : 0;
        body[1] += q->id == pair->high ? q->body : 0;
    }
    dem_collect_sum_int64(&p->decomposition, body, 2);
    return body[0] != 0 && body[0] == body[1];
}

static int check_found(const struct dem_state *p, const struct listed_pair *list, size_t pairs,
                       uint8_t *found)
{
    dem_collect_max_uint8(&p->decomposition, found, pairs);
    DEM_TRY(dem_collect_agree(&p->decomposition, DEM_OK));
    const struct dem_effect *const e = effect_of_column(&p->interaction_table, NULL);

    for (size_t k = 0; k < pairs; k++)
    {
        const int duplicate = k > 0 && compare(&list[k], &list[k - 1]) == 0;

        DEM_REQUIRE(found[k] || duplicate || !neither_is_free(p, &list[k]), DEM_ERROR_INPUT,
                    "bonds/pairs: particles %lld and %lld are frozen or driven, so neither is free "
                    "to move and a bond between them would do nothing; take the pair off the list, "
                    "or set one of them free", (long long)list[k].low, (long long)list[k].high);
        DEM_REQUIRE(found[k] || duplicate || !are_of_one_clump(p, &list[k]), DEM_ERROR_INPUT,
                    "bonds/pairs: particles %lld and %lld are spheres of one clump, which is rigid: a bond "
                    "between them would do nothing; take the pair off the list",
                    (long long)list[k].low, (long long)list[k].high);
        DEM_REQUIRE(found[k] || duplicate, DEM_ERROR_INPUT,
                    "bonds/pairs: particles %lld and %lld do not exist or are farther apart than "
                    "breakDistance of %s; correct the list, or raise makeDistance and "
                    "breakDistance",
                    (long long)list[k].low, (long long)list[k].high, e ? e->name : "a bond");
    }
    return DEM_OK;
}

static void mark_all(struct dem_state *p, const int64_t *ids, struct listed_pair *list,
                     size_t pairs, uint8_t *found)
{
    sort_list(ids, pairs, list);
    for (int m = 0; m < p->interaction_table.history_columns; m++)
    {
        if (effect_of_column(&p->interaction_table, p->interaction_table.history_name[m]))
        {
            mark(p, list, pairs, p->contacts.history.column[m], found);
        }
    }
}

int dem_bond_pairs_mark(struct dem_state *p, const int64_t *ids, size_t count)
{
    const size_t pairs = count/2;

    struct listed_pair *list = NULL;
    uint8_t *found = NULL;
    int status = DEM_NEW(list, pairs + 1);

    status = status ? status : DEM_NEW(found, pairs + 1);
    status = dem_collect_agree(&p->decomposition, status);
    if (!status)
    {
        mark_all(p, ids, list, pairs, found);
        status = check_found(p, list, pairs, found);
    }
    dem_memory_free(list);
    dem_memory_free(found);
    return status;
}
