/*
 * machine.c -- clock rate and memory bandwidth of one core.
 *
 *     machine prints the clock [GHz], then for each working set its size [bytes] and bandwidth
 *     [GB/s]
 *
 * The clock rate comes from a chain of dependent additions, one a cycle. The bandwidth comes from
 * McCalpin's triad, a(i) = b(i) + s c(i), with 32 bytes an element, as a line that is written is
 * read first: two arrays in, one in and out. Best of several repetitions.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _DEFAULT_SOURCE

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

static double clock_rate(void)
{
    const long turns = 100000000;
    double best = 1e9;

    for (int k = 0; k < 5; k++)
    {
        const double start = seconds();
        unsigned long x = (unsigned long)k;

        for (long i = 0; i < turns; i++)
        {
            /* neither removed nor merged with the next */
            __asm__ volatile("" : "+r"(x));
            x += 12345;
        }
        __asm__ volatile("" : : "r"(x));
        const double taken = seconds() - start;

        best = taken < best ? taken : best;
    }
    return 1e-9*(double)turns/best;
}

/* GB/s of a triad with three arrays of `size` bytes in all */
static double bandwidth(size_t size)
{
    const size_t n = size/(3*sizeof(double));
    const int turns = (int)(1e9/(double)size) + 1;
    double *const a = malloc(3*n*sizeof *a), *const b = a + n, *const c = b + n, best = 1e9;

    if (!a)
    {
        return 0.0;
    }
    for (size_t i = 0; i < 3*n; i++)
    {
        a[i] = (double)i;
    }
    for (int k = 0; k < 5; k++)
    {
        const double start = seconds();

        for (int turn = 0; turn < turns; turn++)
        {
            for (size_t i = 0; i < n; i++)
            {
                a[i] = b[i] + 0.5*c[i];
            }
            __asm__ volatile("" : : "r"(a) : "memory");
        }
        const double taken = (seconds() - start)/turns;

        best = taken < best ? taken : best;
    }
    free(a);
    return 32e-9*(double)n/best;
}

int main(void)
{
    static const size_t sizes[] = {24u << 10, 512u << 10, 4u << 20,
                                   16u << 20, 64u << 20, 768u << 20};

    printf("clock %.3f\n", clock_rate());
    for (size_t k = 0; k < sizeof sizes/sizeof *sizes; k++)
    {
        printf("triad %zu %.2f\n", sizes[k], bandwidth(sizes[k]));
    }
    return 0;
}
