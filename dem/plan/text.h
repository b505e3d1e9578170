/*
 * text.h -- a text that grows line by line; an error is kept and told at the end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_TEXT_H
#define DEM_PLAN_TEXT_H

#include <stddef.h>

struct dem_text                                           /* all zero: empty */
{
    char *text;                                           /* ends in a zero byte */
    size_t n, room;
    int status;
};

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void dem_text_add(struct dem_text *, const char *format, ...);

/* A mass, a time or a number of bytes in a unit that reads well: "1.31 g", "0.51 ms", "3.4 MB". The text stays until
   this thread has asked eight times more. */
const char *dem_text_bytes(double bytes);
const char *dem_text_time(double seconds);

void dem_text_free(struct dem_text *);

#endif
