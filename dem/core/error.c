/*
 * error.c -- the error message of each thread, stored whole or truncated with "...".
 *
 * A new message is formatted in a local buffer and then copied, so its arguments may quote the old
 * one. Nothing is allocated, because running out of memory is one of the errors to report.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static _Thread_local char stored[DEM_ERROR_TEXT_SIZE];

/* a truncated message ends in "..." */
static void mark_truncated(char *text, size_t size)
{
    memcpy(text + size - 4, "...", 4);
}

int dem_error(int status, const char *format, ...)
{
    char text[DEM_ERROR_TEXT_SIZE];
    va_list arguments;

    va_start(arguments, format);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);

    if (length < 0)
    {
        snprintf(text, sizeof text, "%s", format);
    }
    else if ((size_t)length >= sizeof text)
    {
        mark_truncated(text, sizeof text);
    }
    memcpy(stored, text, sizeof stored);
    return status;
}

int dem_error_prefix(int status, const char *format, ...)
{
    char text[DEM_ERROR_TEXT_SIZE];
    va_list arguments;

    if (status == DEM_OK)
    {
        return DEM_OK;
    }
    va_start(arguments, format);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);

    if (length < 0)
    {
        return status;
    }

    const size_t used = strlen(text), more = strlen(stored);

    if (used + more >= sizeof text)
    {
        memcpy(text + used, stored, sizeof text - used);
        mark_truncated(text, sizeof text);
    }
    else
    {
        memcpy(text + used, stored, more + 1);
    }
    memcpy(stored, text, sizeof stored);
    return status;
}

const char *dem_error_text(void)
{
    return stored;
}
