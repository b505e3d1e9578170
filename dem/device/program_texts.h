/*
 * program_texts.h -- put texts of the core into the program of a device.
 *
 * The texts are those that the core itself is compiled from (texts.h): an #include of one of them is
 * replaced by the text, the first time; templates (.cl) each time. Headers that are not among them are
 * for the host, and left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/text.h"
#include "device/texts.h"
#include <stddef.h>

enum
{
    DEM_PROGRAM_TEXTS = 200    /* limit of the texts of a program */
};

struct dem_program_texts
{
    struct dem_text *out;
    const struct dem_device_text *included[DEM_PROGRAM_TEXTS];
    int n;
};

/* The text whose name ends in this, or NULL. */
const struct dem_device_text *dem_program_find_text(const char *name, size_t length);

/* Append a text, and what it includes, unless it is there already; NULL: nothing. DEM_ERROR_STATE: texts
   include each other in a circle. */
int dem_program_include(struct dem_program_texts *, const struct dem_device_text *);
int dem_program_include_name(struct dem_program_texts *, const char *name);
