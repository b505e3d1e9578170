/*
 * text.h -- a text that grows line by line; the first error is stored in its status. Marked lines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stddef.h>

/* a growing text; all zero is an empty one */
struct dem_text
{
    char *text;  /* ends in a zero byte */
    size_t n, capacity;
    int status;  /* DEM_OK, or DEM_ERROR_MEMORY */
};

/* Append a formatted text. After a failure nothing more is added and status is not DEM_OK. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void dem_text_add(struct dem_text *, const char *format, ...);

/* A number of bytes or a time in a readable unit: "3.4 MB", "0.51 min". The returned text is valid
   until the eighth further call in this thread. */
const char *dem_text_bytes(double bytes);
const char *dem_text_time(double seconds);

/* ---- lines of a snapshot's text that begin with a mark: "@mark name words" ----

   The words behind the mark in the next line that begins with it; *at, which may be NULL, moves on to
   there. NULL: there is no more. */
const char *dem_text_marked(const char **at, const char *mark);

/* What follows the name and its blank; NULL when the words begin with another one. */
const char *dem_text_after(const char *words, const char *name);

/* Read up to `most` numbers of the line; returns how many there are. */
int dem_text_numbers(const char *words, double *number, int most);

/* Free the text; the struct is empty then. */
void dem_text_free(struct dem_text *);
