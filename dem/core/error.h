/*
 * error.h -- status codes and one error message per thread; macros to return on failure.
 *
 * A function that can fail returns a status; its results go through pointers. The message names the
 * thing, the value, the limit and the cure. It is valid in the thread that failed until that thread
 * fails again. Nothing is printed and nothing is allocated.
 *
 *     DEM_REQUIRE(dt <= max, DEM_ERROR_INPUT, "time step %g s exceeds %g s", dt, max);
 *     DEM_TRY(dem_walls_add(walls, triangles, n));
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"

enum
{
    DEM_ERROR_TEXT_SIZE = 4096  /* bytes stored of a message; a longer one ends in "..." */
};

/* Store the message and return the status. The arguments may point into dem_error_text(). */
int dem_error(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Put context in front of the stored message ("case.dem, line 12: " + message); return the
   status. With DEM_OK the message is unchanged. */
int dem_error_prefix(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The last message stored in this thread; empty before the first failure. Never null. */
const char *dem_error_text(void);

/* Return the status of a failed call from the calling function. */
#define DEM_TRY(call)                          \
    do                                         \
    {                                          \
        const int dem_try_status = (call);     \
        if (dem_try_status != DEM_OK)          \
        {                                      \
            return dem_try_status;             \
        }                                      \
    } while (0)

/* Return a status and store a message (format, ...) unless the condition holds. The status
   itself is returned, so that a compiler sees that this path is no success and that no result
   is read on it. */
#define DEM_REQUIRE(condition, status, ...)                   \
    do                                                        \
    {                                                         \
        if (!(condition))                                     \
        {                                                     \
            const int dem_require_status = (status);          \
            dem_error(dem_require_status, __VA_ARGS__);       \
            return dem_require_status;                        \
        }                                                     \
    } while (0)
