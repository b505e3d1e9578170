/*
 * restart_notes.c -- sentences on what differs between a scene and the one of its snapshot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int dem_sim_note(struct dem *d, const char *format, ...)
{
    char text[1024];
    va_list arguments;

    va_start(arguments, format);
    const int n = vsnprintf(text, sizeof text, format, arguments);

    va_end(arguments);
    DEM_TRY(DEM_GROW(d->note, d->note_capacity, d->notes + 1));
    DEM_TRY(DEM_NEW(d->note[d->notes], sizeof text));
    memcpy(d->note[d->notes++], text, n < 0 ? 1 : sizeof text);
    return DEM_OK;
}
