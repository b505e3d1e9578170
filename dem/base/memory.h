/*
 * memory.h -- zeroed, 64-byte aligned arrays that only grow, and errors instead of null pointers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * 64 bytes is a cache line and the widest vector register; sizes are rounded up to it, so a vector loop may
 * read (not trust) up to the end of the last line. Allocate at create, ready and rebuild, never in a step.
 *
 *     double *x = NULL;  size_t room = 0;
 *     DEM_TRY(DEM_GROW(x, room, n));               one array with its own room
 *
 *     size_t room = dem_memory_room(s->room, n);   columns that share one room
 *     DEM_TRY(DEM_RESIZE(s->x, s->room, room));
 *     DEM_TRY(DEM_RESIZE(s->y, s->room, room));
 *     s->room = room;
 *
 * On failure the array, its contents and its room are what they were.
 */
#ifndef DEM_BASE_MEMORY_H
#define DEM_BASE_MEMORY_H

#include <stddef.h>

enum
{
    DEM_MEMORY_LINE = 64    /* alignment of every array [byte] */
};

/* Make *p hold count elements of size bytes: contents kept, new bytes zero, room at least 1.5 times the old. */
int dem_memory_grow(void **p, size_t *capacity, size_t count, size_t size);

/* Room to ask for so that count elements fit: capacity if they do, else max(count, 1.5 capacity). */
size_t dem_memory_room(size_t capacity, size_t count);

/* Move *p from `from` elements to `to`: contents kept, new bytes zero. It never shrinks. */
int dem_memory_resize(void **p, size_t from, size_t to, size_t size);

/* A fresh zeroed array in *p (whatever *p held is not freed); count 0 gives a valid, empty array. */
int dem_memory_new(void **p, size_t count, size_t size);

/* Give back an array of the functions above; null is fine. */
void dem_memory_free(void *p);

/* The same with the element's size taken from the pointer. capacity is a size_t variable. */
#define DEM_GROW(pointer, capacity, count) \
    dem_memory_grow((void **)&(pointer), &(capacity), (size_t)(count), sizeof *(pointer))
#define DEM_RESIZE(pointer, from, to) \
    dem_memory_resize((void **)&(pointer), (size_t)(from), (size_t)(to), sizeof *(pointer))
#define DEM_NEW(pointer, count) dem_memory_new((void **)&(pointer), (size_t)(count), sizeof *(pointer))

#endif
