/*
 * Arrays grow without losing or inventing a byte, are aligned and zeroed, and impossible sizes are refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/memory.h"

#include <stdint.h>
#include <string.h>

/* let the address sanitizer return null for what can't be had, as every other allocator does */
const char *__asan_default_options(void);
const char *__asan_default_options(void)
{
    return "allocator_may_return_null=1";
}

static int aligned(const void *p)
{
    return (uintptr_t)p%DEM_MEMORY_LINE == 0;
}

static void growing(void)
{
    double *x = NULL;
    size_t room = 0, moves = 0;
    int kept = 1, zeroed = 1, lined_up = 1, failed = 0;

    for (size_t n = 1; n <= 20000; n++)
    {
        const size_t before = room;

        failed |= DEM_GROW(x, room, n);
        if (room != before)
        {
            moves++;
            lined_up &= aligned(x);
            for (size_t i = 0; i < room; i++)
            {
                kept &= i >= n - 1 || x[i] == (double)i + 1.0;
                zeroed &= i < n - 1 || x[i] == 0.0;
            }
        }
        x[n - 1] = (double)n;
    }
    TAP_OK(!failed && room >= 20000, "an array grows to 20000 elements");
    TAP_OK(kept, "what was written is kept at every move");
    TAP_OK(zeroed, "what is new is zero");
    TAP_OK(lined_up, "every array is aligned to %d bytes", DEM_MEMORY_LINE);
    /* 1.5^k >= 20000 from k = 25 on; the first few moves gain less than half because rooms are whole */
    TAP_OK(moves <= 28, "by halves more each time: %zu moves", moves);

    double *const same = x;
    const size_t full = room;

    TAP_OK(DEM_GROW(x, room, 5) == DEM_OK && x == same && room == full,
           "asking for less moves nothing");
    TAP_OK(DEM_GROW(x, room, SIZE_MAX/2) == DEM_ERROR_MEMORY
           && x == same && room == full && x[19999] == 20000.0,
           "a failed growth leaves array and room alone: %s", dem_error_text());
    dem_memory_free(x);
}

static void columns(void)
{
    struct wide
    {
        char byte[3];
    } *a = NULL;
    int *b = NULL;
    size_t room = dem_memory_capacity(0, 10);

    TAP_OK(room == 10 && dem_memory_capacity(10, 11) == 15 && dem_memory_capacity(10, 40) == 40
           && dem_memory_capacity(10, 9) == 10,
           "the room to ask for is what is needed, half more, or what there is");
    TAP_OK(dem_memory_capacity(SIZE_MAX - 1, SIZE_MAX) == SIZE_MAX, "it does not wrap round");
    TAP_OK(DEM_RESIZE(a, 0, room) == DEM_OK && DEM_RESIZE(b, 0, room) == DEM_OK,
           "two columns share one room");
    memset(a, 7, 10*sizeof *a);
    b[9] = 9;
    TAP_OK(DEM_RESIZE(a, room, 1000) == DEM_OK && DEM_RESIZE(b, room, 1000) == DEM_OK,
           "and grow together");
    TAP_OK(a[9].byte[2] == 7 && a[10].byte[0] == 0 && a[999].byte[2] == 0
           && b[9] == 9 && b[10] == 0 && b[999] == 0,
           "contents kept, the rest zero");
    dem_memory_free(a);
    dem_memory_free(b);
}

static void fresh(void)
{
    char *c = NULL;
    double *empty = NULL, *huge = NULL;
    int zero = 1;

    TAP_OK(DEM_NEW(c, 1001) == DEM_OK && aligned(c), "a new array is aligned");
    for (int i = 0; i < 1024; i++)
    {
        zero &= c[i] == 0;    /* 1001 bytes fill 16 lines of 64 */
    }
    TAP_OK(zero, "and zero to the end of its last line");
    TAP_OK(DEM_NEW(empty, 0) == DEM_OK && empty && aligned(empty), "an empty array is an array");
    TAP_OK(DEM_NEW(huge, SIZE_MAX/8 + 2) == DEM_ERROR_MEMORY && !huge,
           "a size that wraps round is refused: %s",
           dem_error_text());
    TAP_OK(DEM_NEW(huge, (size_t)1 << 58) == DEM_ERROR_MEMORY
           && !huge && strstr(dem_error_text(), "2305843009213693952"),
           "memory that is not there is an error with its bytes: %s", dem_error_text());
    dem_memory_free(c);
    dem_memory_free(empty);
    dem_memory_free(NULL);
}

int main(void)
{
    TAP_TRAPS;
    growing();
    columns();
    fresh();
    TAP_DONE;
}
