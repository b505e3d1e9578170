/*
 * bond_pairs.c -- sort the list, look every near row up in it, and see that each pair was found by somebody.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/bond_pairs.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include <stdlib.h>
#include <string.h>

struct asked
{
    int64_t low, high;
};

static int compare(const void *a, const void *b)
{
    const struct asked *const s = a, *const t = b;
    const int low = (s->low > t->low) - (s->low < t->low);

    return low ? low : (s->high > t->high) - (s->high < t->high);
}

static void take_list(const int64_t *ids, size_t pairs, struct asked *list)
{
    for (size_t k = 0; k < pairs; k++)
    {
        const int64_t a = ids[2*k], b = ids[2*k + 1];

        list[k] = (struct asked){.low = a < b ? a : b, .high = a < b ? b : a};
    }
    dem_sort_by(list, pairs, sizeof *list, compare);
}

static void mark(struct dem_parts *p, const struct asked *list, size_t pairs, double *column, uint8_t *found)
{
    const struct dem_contacts *const c = &p->contacts;

    for (uint32_t r = 0; r < c->rows; r++)
    {
        const struct dem_pair *const q = c->row_pair[r] == DEM_ROW_NONE ? NULL : &c->pair[c->row_pair[r]];

        if (q && !q->wall)
        {
            const struct asked key = {.low = p->particles.record[q->i].id, .high = p->particles.record[q->j].id};
            const struct asked *const hit = bsearch(&key, list, pairs, sizeof key, compare);

            if (hit)
            {
                column[r] = 1.0;
                found[hit - list] = 1;
            }
        }
    }
}

static int see(const struct dem_parts *p, const struct asked *list, size_t pairs, uint8_t *found)
{
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, found, (int)pairs, MPI_UINT8_T, MPI_MAX, p->pieces.comm);
    }
    for (size_t k = 0; k < pairs; k++)
    {
        const int twin = k > 0 && compare(&list[k], &list[k - 1]) == 0;

        DEM_REQUIRE(found[k] || twin, DEM_ERROR_INPUT,
                    "bonds/pairs: particles %lld and %lld are not there or farther apart than breakDistance of bondLinear; correct "
                    "the list, or raise makeDistance and breakDistance", (long long)list[k].low, (long long)list[k].high);
    }
    return DEM_OK;
}

int dem_bond_pairs_ask(struct dem_parts *p, const int64_t *ids, size_t count)
{
    const size_t pairs = count/2;

    DEM_REQUIRE(pairs <= INT32_MAX, DEM_ERROR_INPUT, "bonds/pairs: %zu pairs; the limit is %d, make bonds by nearness or chance", pairs, INT32_MAX);
    struct asked *list;
    uint8_t *found;

    DEM_TRY(DEM_NEW(list, pairs + 1));
    DEM_TRY(DEM_NEW(found, pairs + 1));
    take_list(ids, pairs, list);
    for (int m = 0; m < p->recipe.memories; m++)
    {
        if (strcmp(p->recipe.memory[m], "bond_asked") == 0)
        {
            mark(p, list, pairs, p->contacts.memory[m], found);
        }
    }
    const int status = see(p, list, pairs, found);

    dem_memory_free(list);
    dem_memory_free(found);
    return status;
}
