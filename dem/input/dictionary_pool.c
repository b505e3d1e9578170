/*
 * dictionary_pool.c -- the memory pool that holds all of a dictionary's tree.
 *
 * Copies made for macros are counted: `b $a $a; c $b $b; ...` doubles with every line, and must end
 * in an error message before memory is full.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"
#include "core/memory.h"

#include <stdalign.h>
#include <string.h>

enum
{
    CHUNK = 1 << 14,      /* smallest allocation [byte] */
    MAX_FILES = 1000,     /* that one tree includes, each as often as it is read */
    MAX_COPIES = 4000000  /* entries and words that macros may copy: 100 MB */
};

/* bytes of included files: more than any list of positions that memory holds */
static const size_t max_bytes = (size_t)1 << 30;

enum
{
    LINK_SIZE =
        (sizeof(char *) + alignof(max_align_t) - 1)/alignof(max_align_t)*alignof(max_align_t)
};

static int new_chunk(struct dem_dict_pool *pool, size_t size)
{
    const size_t bytes = LINK_SIZE + (size > CHUNK ? size : CHUNK);
    char *chunk = NULL;

    const int status = DEM_NEW(chunk, bytes);

    pool->failed = pool->failed || status;
    DEM_TRY(status);
    memcpy(chunk, &pool->chunk, sizeof pool->chunk);
    pool->chunk = chunk;
    pool->capacity = bytes;
    pool->used = LINK_SIZE;
    return DEM_OK;
}

int dem_dict_pool_alloc(struct dem_dict_pool *pool, size_t size, void **p)
{
    const size_t step = alignof(max_align_t);

    DEM_REQUIRE(size < SIZE_MAX/4, DEM_ERROR_MEMORY,
                "a dictionary asks for %zu bytes at once; shorten its lists", size);
    size = (size + step - 1)/step*step;
    if (!pool->chunk || pool->capacity - pool->used < size)
    {
        DEM_TRY(new_chunk(pool, size));
    }
    *p = pool->chunk + pool->used;
    pool->used += size;
    return DEM_OK;
}

int dem_dict_pool_copy(struct dem_dict_pool *pool, const char *text, size_t length,
                       const char **copy)
{
    void *p;

    DEM_TRY(dem_dict_pool_alloc(pool, length + 1, &p));
    if (length > 0)
    {
        memcpy(p, text, length);
    }
    *copy = p;
    return DEM_OK;
}

int dem_dict_pool_grow(struct dem_dict_pool *pool, void **array, size_t *capacity, size_t count,
                       size_t size)
{
    const size_t larger = 2**capacity > count ? 2**capacity : (count > 4 ? count : 4);
    void *p;

    if (count <= *capacity)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_dict_pool_alloc(pool, larger*size, &p));
    if (*capacity > 0)
    {
        memcpy(p, *array, *capacity*size);
    }
    *array = p;
    *capacity = larger;
    return DEM_OK;
}

int dem_dict_count_copy(struct dem_dict_pool *pool)
{
    DEM_REQUIRE(++pool->copies <= MAX_COPIES, DEM_ERROR_INPUT,
                "macros copy more than %d words; write the long list once, or read it from a file "
                "of its own",
                MAX_COPIES);
    return DEM_OK;
}

int dem_dict_count_file(struct dem_dict_pool *pool, size_t bytes)
{
    DEM_REQUIRE(++pool->files <= MAX_FILES, DEM_ERROR_INPUT,
                "more than %d files are included; does one include another many times?", MAX_FILES);
    pool->bytes += bytes;
    DEM_REQUIRE(pool->bytes <= max_bytes, DEM_ERROR_INPUT,
                "included files have more than %zu bytes together; include each once, or insert "
                "particles with type table",
                max_bytes);
    return DEM_OK;
}

void dem_dict_pool_free(struct dem_dict_pool *pool)
{
    while (pool->chunk)
    {
        char *previous;

        memcpy(&previous, pool->chunk, sizeof previous);
        dem_memory_free(pool->chunk);
        pool->chunk = previous;
    }
    dem_name_index_free(&pool->names);
    dem_memory_free(pool->entry);
    dem_memory_free(pool);
}
