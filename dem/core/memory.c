/*
 * memory.c -- zeroed, aligned arrays; sizes are checked for overflow before they are multiplied.
 *
 * A pointer is read and written through memcpy: the caller's variable is a double *, a struct x *
 * and so on, not the void * of the signature, so a direct access would break C's aliasing rule.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/memory.h"
#include "core/error.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of count elements, rounded up to whole cache lines, at least one line. */
static int bytes_of(size_t count, size_t size, size_t *bytes)
{
    const size_t line = DEM_MEMORY_LINE, limit = PTRDIFF_MAX - line;

    DEM_REQUIRE(size == 0 || count <= limit/size, DEM_ERROR_MEMORY,
                "%zu elements of %zu bytes exceed the largest array (%zu bytes); use fewer",
                count, size, limit);
    *bytes = (count*size + line - 1)/line*line;
    *bytes = *bytes > 0 ? *bytes : line;
    return DEM_OK;
}

int dem_memory_new(void **p, size_t count, size_t size)
{
    size_t bytes;

    DEM_TRY(bytes_of(count, size, &bytes));

    void *fresh = aligned_alloc(DEM_MEMORY_LINE, bytes);

    DEM_REQUIRE(fresh, DEM_ERROR_MEMORY,
                "no memory for %zu bytes (%zu elements of %zu bytes); use fewer particles or more "
                "ranks",
                bytes, count, size);
    memset(fresh, 0, bytes);
    memcpy(p, &fresh, sizeof fresh);
    return DEM_OK;
}

int dem_memory_resize(void **p, size_t from, size_t to, size_t size)
{
    void *old, *fresh;

    memcpy(&old, p, sizeof old);
    if (old && to <= from)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_memory_new(&fresh, to > from ? to : from, size));
    if (old && from > 0)
    {
        memcpy(fresh, old, from*size);
    }
    free(old);
    memcpy(p, &fresh, sizeof fresh);
    return DEM_OK;
}

size_t dem_memory_capacity(size_t capacity, size_t count)
{
    const size_t half = capacity/2;
    const size_t more = capacity <= SIZE_MAX - half ? capacity + half : SIZE_MAX;

    return count <= capacity ? capacity : count > more ? count : more;
}

int dem_memory_grow(void **p, size_t *capacity, size_t count, size_t size)
{
    const size_t larger = dem_memory_capacity(*capacity, count);

    DEM_TRY(dem_memory_resize(p, *capacity, larger, size));
    *capacity = larger;
    return DEM_OK;
}

void dem_memory_free(void *p)
{
    free(p);
}
