/*
 * error.c -- one sentence per thread, written whole or not at all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A new sentence is made beside the old one and copied over it, so that it may quote the old one. No memory
 * is asked for: running out of it is one of the things to be told.
 */
#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static _Thread_local char kept[DEM_ERROR_TEXT_SIZE];

/* a sentence cut short says so */
static void mark_cut(char *text, size_t size)
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
        mark_cut(text, sizeof text);
    }
    memcpy(kept, text, sizeof kept);
    return status;
}

int dem_error_prefix(int status, const char *format, ...)
{
    char text[DEM_ERROR_TEXT_SIZE];
    va_list arguments;

    va_start(arguments, format);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);

    if (length < 0)
    {
        return status;
    }

    const size_t used = strlen(text), more = strlen(kept);

    if (used + more >= sizeof text)
    {
        memcpy(text + used, kept, sizeof text - used);
        mark_cut(text, sizeof text);
    }
    else
    {
        memcpy(text + used, kept, more + 1);
    }
    memcpy(kept, text, sizeof kept);
    return status;
}

const char *dem_error_text(void)
{
    return kept;
}
