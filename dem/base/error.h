/*
 * error.h -- a failure is a status and a sentence that names the thing, the value, the limit and the cure.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A function that can fail returns a status; its results go through pointers. The sentence lives in the
 * thread that failed until that thread fails again; nothing is printed and nothing is allocated.
 *
 *     DEM_REQUIRE(dt <= most, DEM_ERROR_INPUT, "time step %g s exceeds %g s; use at most that", dt, most);
 *     DEM_TRY(dem_walls_add(walls, triangles, n));
 */
#ifndef DEM_BASE_ERROR_H
#define DEM_BASE_ERROR_H

enum
{
    DEM_OK = 0,
    DEM_ERROR_INPUT,     /* what the user wrote: a word, a value, a range                 */
    DEM_ERROR_MEMORY,    /* an allocation failed or its size overflows                    */
    DEM_ERROR_FILE,      /* a file can't be opened, read or written, or is not what it claims */
    DEM_ERROR_STATE,     /* a call out of order, or a promise between rooms is broken     */
    DEM_ERROR_LOST,      /* particles left the domain or passed through a wall            */
    DEM_ERROR_NUMBER,    /* a not-a-number, an infinity or an absurd value in the physics */
    DEM_ERROR_MPI        /* the message layer failed                                      */
};

enum
{
    DEM_ERROR_TEXT_SIZE = 4096    /* bytes kept of a sentence; a longer one ends in "..." */
};

/* Store the sentence, return the status. The arguments may point into dem_error_text(). */
int dem_error(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Put context in front of the stored sentence ("case.dem, line 12: " + sentence), return the status. */
int dem_error_prefix(int status, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The last sentence stored in this thread; empty before the first failure. Never null. */
const char *dem_error_text(void);

/* Leave the calling function with the status of a call that failed. */
#define DEM_TRY(call)                          \
    do                                         \
    {                                          \
        const int dem_try_status = (call);     \
        if (dem_try_status != DEM_OK)          \
        {                                      \
            return dem_try_status;             \
        }                                      \
    } while (0)

/* Leave the calling function with a status and a sentence (format, ...) unless the condition holds. The status
   is returned by itself so that a compiler sees that it is no success, and that no result is read after it. */
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

#endif
