/*
 * contact_history.c -- history columns of the rows, and saved history by key.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/contact_history.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "contacts/contact_rows.h"
#include <stdlib.h>
#include <string.h>

void dem_contact_history_free(struct dem_contact_history *h)
{
    dem_contact_history_clear(h);
    dem_contact_history_forget(h);
}

size_t dem_contact_history_bytes(const struct dem_contact_history *h)
{
    return h->capacity*(size_t)(h->columns + 1)*sizeof *h->scratch +
           h->saved_capacity*sizeof *h->saved_key + h->saved_value_capacity*sizeof *h->saved_value;
}

/* ---- columns --------------------------------------------------------------------------------- */

int dem_contact_history_resize(struct dem_contact_history *h, size_t capacity)
{
    DEM_TRY(DEM_RESIZE(h->scratch, h->capacity, capacity));
    for (int m = 0; m < h->columns; m++)
    {
        DEM_TRY(DEM_RESIZE(h->column[m], h->capacity, capacity));
    }
    h->capacity = capacity;
    return DEM_OK;
}

void dem_contact_history_move(struct dem_contact_history *h, uint32_t rows, const uint32_t *from)
{
    for (int m = 0; m < h->columns; m++)
    {
        double *const old = h->column[m], *const new = h->scratch;

        for (uint32_t r = 0; r < rows; r++)
        {
            new[r] = from[r] == DEM_ROW_NONE ? 0.0 : old[from[r]];
        }
        h->column[m] = new;
        h->scratch = old;
    }
}

void dem_contact_history_clear(struct dem_contact_history *h)
{
    dem_memory_free(h->scratch);
    h->scratch = NULL;
    for (int m = 0; m < h->columns; m++)
    {
        dem_memory_free(h->column[m]);
        h->column[m] = NULL;
    }
    h->capacity = 0;
}

int dem_contact_history_any(const struct dem_contact_history *h, uint32_t row)
{
    int some = 0;

    for (int m = 0; m < h->columns; m++)
    {
        some |= h->column[m][row] != 0.0;
    }
    return some;
}

void dem_contact_history_get(const struct dem_contact_history *h, uint32_t row, double *values)
{
    for (int m = 0; m < h->columns; m++)
    {
        values[m] = h->column[m][row];
    }
}

/* ---- saved history --------------------------------------------------------------------------- */

int dem_contact_history_reserve(struct dem_contact_history *h, size_t more)
{
    DEM_TRY(DEM_GROW(h->saved_key, h->saved_capacity, h->saved + more));
    return DEM_GROW(h->saved_value, h->saved_value_capacity,
                    (h->saved + more)*(size_t)h->columns);
}

int dem_contact_history_append(struct dem_contact_history *h, const struct dem_contact_key *key,
                               const double *values)
{
    DEM_TRY(dem_contact_history_reserve(h, 1));
    h->saved_key[h->saved] = *key;
    memcpy(h->saved_value + h->saved*(size_t)h->columns, values,
           (size_t)h->columns*sizeof *values);
    h->saved++;
    return DEM_OK;
}

static size_t slot_of(const struct dem_contact_key *key, size_t mask)
{
    return dem_random_bits((uint64_t)key->low, (uint64_t)key->high, key->image, 0) & mask;
}

static int same_key(const struct dem_contact_key *a, const struct dem_contact_key *b)
{
    return a->low == b->low && a->high == b->high && a->image == b->image;
}

int dem_contact_history_hash(const struct dem_contact_history *h, struct dem_contact_hash *hash)
{
    hash->mask = 15;
    while (hash->mask < 2*h->saved)
    {
        hash->mask = 2*hash->mask + 1;
    }
    DEM_TRY(DEM_NEW(hash->slot, hash->mask + 1));
    for (size_t k = 0; k < h->saved; k++)
    {
        size_t slot = slot_of(&h->saved_key[k], hash->mask);

        while (hash->slot[slot])
        {
            slot = (slot + 1) & hash->mask;
        }
        hash->slot[slot] = (uint32_t)k + 1;
    }
    return DEM_OK;
}

void dem_contact_history_take(struct dem_contact_history *h, const struct dem_contact_hash *hash,
                              const struct dem_contact_key *key, uint32_t row)
{
    size_t slot = slot_of(key, hash->mask);

    while (hash->slot[slot] && !same_key(&h->saved_key[hash->slot[slot] - 1], key))
    {
        slot = (slot + 1) & hash->mask;
    }
    for (int m = 0; hash->slot[slot] && m < h->columns; m++)
    {
        h->column[m][row] = h->saved_value[(hash->slot[slot] - 1)*(size_t)h->columns + (size_t)m];
    }
}

static int compare_ids(const void *a, const void *b)
{
    const int64_t p = *(const int64_t *)a, q = *(const int64_t *)b;

    return (p > q) - (p < q);
}

void dem_contact_history_drop(struct dem_contact_history *h, const int64_t *id, size_t n)
{
    const size_t columns = (size_t)h->columns;
    size_t kept = 0;

    for (size_t k = 0; k < h->saved && n > 0; k++)
    {
        const struct dem_contact_key *const key = &h->saved_key[k];

        if (!bsearch(&key->low, id, n, sizeof *id, compare_ids) &&
            !bsearch(&key->high, id, n, sizeof *id, compare_ids))
        {
            h->saved_key[kept] = *key;
            memmove(h->saved_value + kept*columns, h->saved_value + k*columns,
                    columns*sizeof *h->saved_value);
            kept++;
        }
    }
    h->saved = n > 0 ? kept : h->saved;
}

void dem_contact_history_forget(struct dem_contact_history *h)
{
    dem_memory_free(h->saved_key);
    dem_memory_free(h->saved_value);
    h->saved_key = NULL;
    h->saved_value = NULL;
    h->saved = h->saved_capacity = h->saved_value_capacity = 0;
}
