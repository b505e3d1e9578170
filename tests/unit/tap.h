/*
 * tap.h -- tests in C that print TAP, the Test Anything Protocol that prove reads.
 *
 *      int main(void)
 *      {
 *          TAP_TRAPS; invalid, division by zero, overflow end the test
 *          TAP_OK(n == 3, "three contacts, found %d", n);   a condition
 *          TAP_NEAR(e, 0.9, 1e-4, "restitution of glass"); |value - expected| <= tolerance, never
 *          true for a nan
 *          TAP_DONE; the plan; returns 0 if a test ran and all passed
 *      }
 *
 * The first comment of a test states its claim; each tolerance has its reason beside it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#ifndef _GNU_SOURCE
#define _GNU_SOURCE    /* feenableexcept is glibc's own; effective if this is the first header */
#endif

#include <fenv.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

static struct
{
    int run, failed;
} tap_count;

__attribute__((format(printf, 4, 5)))
static inline int tap_ok(int holds, const char *file, int line, const char *format, ...)
{
    va_list arguments;

    printf("%sok %d - ", holds ? "" : "not ", ++tap_count.run);
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    printf("\n");
    if (!holds)
    {
        tap_count.failed++;
        printf("#   at %s:%d\n", file, line);
    }
    fflush(stdout);
    return holds;
}

/* quiet comparisons: a nan fails instead of trapping */
static inline int tap_is_near(double value, double expected, double tolerance)
{
    return value == expected || (isfinite(value) && islessequal(fabs(value - expected), tolerance));
}

static inline int tap_done(void)
{
    printf("1..%d\n", tap_count.run);
    fflush(stdout);
    return tap_count.failed > 0 || tap_count.run == 0;
}

#define TAP_OK(condition, ...) tap_ok((condition) ? 1 : 0, __FILE__, __LINE__, __VA_ARGS__)

#define TAP_NEAR(value, expected, tolerance, ...)                                                          \
    do                                                                                                     \
    {                                                                                                      \
        const double tap_value = (value), tap_expected = (expected), tap_tolerance = (tolerance);          \
        if (!TAP_OK(tap_is_near(tap_value, tap_expected, tap_tolerance), __VA_ARGS__))                     \
        {                                                                                                  \
            printf("#   found %.17g, expected %.17g, off by %.3g, allowed %.3g\n", tap_value, tap_expected, \
                   fabs(tap_value - tap_expected), tap_tolerance);                                         \
        }                                                                                                  \
    } while (0)

#define TAP_NOTE(...) (printf("# "), printf(__VA_ARGS__), printf("\n"))

#define TAP_TRAPS feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)

#define TAP_DONE return tap_done()
