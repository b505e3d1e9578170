/*
 * test_memory.c -- arrays grow without losing or altering a byte, are aligned and zeroed, and
 * impossible sizes are refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/memory.h"

#include <stdint.h>
#include <string.h>

/* let the address sanitizer return null for impossible sizes, as other allocators do */
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
    size_t capacity = 0, moves = 0;
    int kept = 1, zeroed = 1, lined_up = 1, failed = 0;

    for (size_t n = 1; n <= 20000; n++)
    {
        const size_t before = capacity;

        failed |= DEM_GROW(x, capacity, n);
        if (capacity != before)
        {
            moves++;
            lined_up &= aligned(x);
            for (size_t i = 0; i < capacity; i++)
            {
                kept &= i >= n - 1 || x[i] == (double)i + 1.0;
                zeroed &= i < n - 1 || x[i] == 0.0;
            }
        }
        x[n - 1] = (double)n;
    }
    TAP_OK(!failed && capacity >= 20000, "an array grows to 20000 elements");
    TAP_OK(kept, "contents are kept in every move");
    TAP_OK(zeroed, "new elements are zero");
    TAP_OK(lined_up, "every array is aligned to %d bytes", DEM_MEMORY_LINE);
    /* 1.5^k >= 20000 from k = 25 on; the first moves gain less than half because capacities are
       whole numbers */
    TAP_OK(moves <= 28, "each growth is by half: %zu moves", moves);

    double *const same = x;
    const size_t full = capacity;

    TAP_OK(DEM_GROW(x, capacity, 5) == DEM_OK && x == same && capacity == full,
           "a smaller request moves nothing");
    TAP_OK(DEM_GROW(x, capacity, SIZE_MAX/2) == DEM_ERROR_MEMORY
           && x == same && capacity == full && x[19999] == 20000.0,
           "a failed growth changes neither array nor capacity: %s", dem_error_text());
    dem_memory_free(x);
}

static void columns(void)
{
    struct wide
    {
        char byte[3];
    } *a = NULL;
    int *b = NULL;
    size_t capacity = dem_memory_capacity(0, 10);

    TAP_OK(capacity == 10 && dem_memory_capacity(10, 11) == 15 && dem_memory_capacity(10, 40) == 40
           && dem_memory_capacity(10, 9) == 10,
           "the capacity is the number needed, half more, or the present one");
    TAP_OK(dem_memory_capacity(SIZE_MAX - 1, SIZE_MAX) == SIZE_MAX, "the capacity does not overflow");
    TAP_OK(DEM_RESIZE(a, 0, capacity) == DEM_OK && DEM_RESIZE(b, 0, capacity) == DEM_OK,
           "two columns share one capacity");
    memset(a, 7, 10*sizeof *a);
    b[9] = 9;
    TAP_OK(DEM_RESIZE(a, capacity, 1000) == DEM_OK && DEM_RESIZE(b, capacity, 1000) == DEM_OK,
           "columns grow together");
    TAP_OK(a[9].byte[2] == 7 && a[10].byte[0] == 0 && a[999].byte[2] == 0
           && b[9] == 9 && b[10] == 0 && b[999] == 0,
           "contents are kept, the rest is zero");
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
    TAP_OK(zero, "it is zero to the end of its last cache line");
    TAP_OK(DEM_NEW(empty, 0) == DEM_OK && empty && aligned(empty), "an array of 0 elements is allocated");
    TAP_OK(DEM_NEW(huge, SIZE_MAX/8 + 2) == DEM_ERROR_MEMORY && !huge,
           "a size that overflows is refused: %s",
           dem_error_text());
    TAP_OK(DEM_NEW(huge, (size_t)1 << 58) == DEM_ERROR_MEMORY
           && !huge && strstr(dem_error_text(), "2305843009213693952"),
           "a failed allocation is an error that names the bytes: %s", dem_error_text());
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
