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
        memcpy(text + sizeof text - 4, "...", 4);
    }
    memcpy(stored, text, sizeof stored);
    return status;
}

int dem_error_prefix(int status, const char *format, ...)
{
    char prefix[DEM_ERROR_TEXT_SIZE];
    va_list arguments;

    va_start(arguments, format);
    const int length = vsnprintf(prefix, sizeof prefix, format, arguments);
    va_end(arguments);
    return status == DEM_OK || length < 0 ? status : dem_error(status, "%s%s", prefix, stored);
}

const char *dem_error_text(void)
{
    return stored;
}
