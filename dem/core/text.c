/*
 * text.c -- printf to the end of a growing text; marked lines; numbers in readable units.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/text.h"
#include "core/memory.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void dem_text_add(struct dem_text *t, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    const int more = vsnprintf(NULL, 0, format, arguments);

    va_end(arguments);
    if (more < 0 || t->status)
    {
        return;
    }
    t->status = DEM_GROW(t->text, t->capacity, t->n + (size_t)more + 1);
    if (!t->status)
    {
        va_start(arguments, format);
        vsnprintf(t->text + t->n, (size_t)more + 1, format, arguments);
        va_end(arguments);
        t->n += (size_t)more;
    }
}

const char *dem_text_marked(const char **at, const char *mark)
{
    const size_t head = strlen(mark);
    const char *line = *at;

    while (line && strncmp(line, mark, head) != 0)
    {
        line = strchr(line, '\n');
        line = line ? line + 1 : NULL;
    }
    *at = line ? line + head : NULL;
    return *at;
}

const char *dem_text_after(const char *words, const char *name)
{
    const size_t n = strlen(name);

    return strncmp(words, name, n) == 0 && words[n] == ' ' ? words + n + 1 : NULL;
}

int dem_text_numbers(const char *words, double *number, int most)
{
    int n = 0;
    char *rest;

    for (; n < most; n++, words = rest)
    {
        words += strspn(words, " \t");
        if (*words == '\n')
        {
            break;
        }
        number[n] = strtod(words, &rest);
        if (rest == words)
        {
            break;
        }
    }
    return n;
}

void dem_text_free(struct dem_text *t)
{
    dem_memory_free(t->text);
    memset(t, 0, sizeof *t);
}

/* One of eight buffers of this thread, in turn. */
static char *next_buffer(void)
{
    static _Thread_local char text[8][32];
    static _Thread_local unsigned next;

    return text[next++%8];
}

const char *dem_text_bytes(double bytes)
{
    static const char *const unit[] = {"B", "kB", "MB", "GB", "TB"};
    char *const text = next_buffer();
    int k = 0;

    for (; bytes >= 999.5 && k < 4; k++)
    {
        bytes /= 1000.0;
    }
    snprintf(text, sizeof(char[32]), "%.3g %s", bytes, unit[k]);
    return text;
}

const char *dem_text_time(double seconds)
{
    char *const text = next_buffer();

    if (seconds < 120.0)
    {
        snprintf(text, sizeof(char[32]), "%.3g s", seconds);
    }
    else if (seconds < 7200.0)
    {
        snprintf(text, sizeof(char[32]), "%.3g min", seconds/60.0);
    }
    else
    {
        snprintf(text, sizeof(char[32]), "%.3g h", seconds/3600.0);
    }
    return text;
}
