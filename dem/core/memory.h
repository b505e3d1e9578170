/*
 * memory.h -- zeroed, 64-byte aligned arrays that only grow, with error messages instead of null
 * pointers.
 *
 * 64 bytes is a cache line and the widest vector register. Sizes are rounded up to it, so a vector
 * loop may read up to the end of the last line (the values there are undefined). Allocate when a
 * simulation is created or set up and at rebuilds of the neighbor lists, never in a time step.
 *
 *     double *x = NULL;
 *     size_t capacity = 0;
 *     DEM_TRY(DEM_GROW(x, capacity, n));                           one array with its own capacity
 *
 *     size_t capacity = dem_memory_capacity(s->capacity, n);       columns that share one capacity
 *     DEM_TRY(DEM_RESIZE(s->x, s->capacity, capacity));
 *     DEM_TRY(DEM_RESIZE(s->y, s->capacity, capacity));
 *     s->capacity = capacity;
 *
 * On failure (DEM_ERROR_MEMORY) the array, its contents and its capacity are unchanged.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>

enum
{
    DEM_MEMORY_LINE = 64  /* alignment of every array [byte] */
};

/* Make *p hold count elements of size bytes: contents are kept, new bytes are zero, and the
   capacity grows by at least a factor of 1.5. */
int dem_memory_grow(void **p, size_t *capacity, size_t count, size_t size);

/* Capacity for count elements: the present one if they fit, else max(count, 1.5 capacity). */
size_t dem_memory_capacity(size_t capacity, size_t count);

/* Resize *p from `from` elements to `to`: contents are kept, new bytes are zero. Never shrinks. */
int dem_memory_resize(void **p, size_t from, size_t to, size_t size);

/* A new zeroed array in *p (an old array in *p is not freed); count 0 gives a valid, empty
   array. */
int dem_memory_new(void **p, size_t count, size_t size);

/* Free an array of the functions above; null is allowed. */
void dem_memory_free(void *p);

/* The same with the element size taken from the pointer. capacity is a size_t variable. */
#define DEM_GROW(pointer, capacity, count) \
    dem_memory_grow((void **)&(pointer), &(capacity), (size_t)(count), sizeof *(pointer))
#define DEM_RESIZE(pointer, from, to) \
    dem_memory_resize((void **)&(pointer), (size_t)(from), (size_t)(to), sizeof *(pointer))
#define DEM_NEW(pointer, count) \
    dem_memory_new((void **)&(pointer), (size_t)(count), sizeof *(pointer))
