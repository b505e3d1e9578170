/*
 * name_index.c -- open addressing with linear probing, at most half full.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/name_index.h"

#include "core/error.h"
#include "core/hash.h"
#include "core/memory.h"

enum
{
    FIRST = 64  /* slots of the first table */
};

struct dem_name_slot
{
    uint64_t hash;  /* 0: empty */
    size_t value;
};

uint64_t dem_name_hash(const char *name, size_t length, uint64_t salt)
{
    const uint64_t hash = dem_hash_record(name, length, salt);

    return hash ? hash : 1;
}

static void put(struct dem_name_slot *slot, size_t slots, struct dem_name_slot new)
{
    size_t k = (size_t)new.hash & (slots - 1);

    while (slot[k].hash)
    {
        k = (k + 1) & (slots - 1);
    }
    slot[k] = new;
}

static int grow(struct dem_name_index *x)
{
    const size_t slots = x->slots ? 2*x->slots : FIRST;
    struct dem_name_slot *slot = NULL;

    DEM_TRY(DEM_NEW(slot, slots));
    for (size_t k = 0; k < x->slots; k++)
    {
        if (x->slot[k].hash)
        {
            put(slot, slots, x->slot[k]);
        }
    }
    dem_memory_free(x->slot);
    x->slot = slot;
    x->slots = slots;
    return DEM_OK;
}

int dem_name_index_add(struct dem_name_index *x, uint64_t hash, size_t value)
{
    if (2*x->used >= x->slots)
    {
        DEM_TRY(grow(x));
    }
    put(x->slot, x->slots, (struct dem_name_slot){hash, value});
    x->used++;
    return DEM_OK;
}

bool dem_name_index_next(const struct dem_name_index *x, uint64_t hash, size_t *at, size_t *value)
{
    for (; *at < x->slots; (*at)++)
    {
        const struct dem_name_slot *const s = &x->slot[((size_t)hash + *at) & (x->slots - 1)];

        if (!s->hash)
        {
            return false;
        }
        if (s->hash == hash)
        {
            *value = s->value;
            (*at)++;
            return true;
        }
    }
    return false;
}

void dem_name_index_free(struct dem_name_index *x)
{
    dem_memory_free(x->slot);
    *x = (struct dem_name_index){0};
}
