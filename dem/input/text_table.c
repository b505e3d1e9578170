/*
 * text_table.c -- read a table of numbers from a text file: see text_table.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/text_table.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/file.h"
#include "core/memory.h"
#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *skip(const char *at)
{
    at += strspn(at, " \t\r");
    at += *at == ',' || *at == ';';
    return at + strspn(at, " \t\r");
}

static int read_name(struct dem_text_table *t, const char *at, size_t length)
{
    char word[32];
    int k = 0;

    snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : sizeof word - 1), at);
    word[strcspn(word, "[")] = '\0';
    while (k < t->names && strcmp(word, t->name[k]) != 0)
    {
        k++;
    }
    if (k == t->names)
    {
        return dem_error_prefix(dem_did_you_mean_error("column", word, t->name, t->names),
                                "%s, line %d: ", t->file, t->line);
    }
    DEM_REQUIRE(!t->present[k], DEM_ERROR_INPUT, "%s, line %d: column %s comes twice; remove one",
                t->file, t->line, word);
    t->present[k] = 1;
    t->what[t->columns++] = k;
    return DEM_OK;
}

static int read_names(struct dem_text_table *t, const char *line)
{
    for (const char *at = skip(line); *at; at = skip(at))
    {
        const size_t length = strcspn(at, " \t\r,;");

        DEM_TRY(read_name(t, at, length));
        at += length;
    }
    return t->check(t);
}

static int read_row(struct dem_text_table *t, const char *line)
{
    double number[DEM_TEXT_TABLE_COLUMNS] = {0.0};
    const char *at = skip(line);
    int good = 1;

    for (int c = 0; c < t->columns && good; c++, at = skip(at))
    {
        double *const to = &number[t->what[c]];
        char *end;

        errno = 0;
        if (t->what[c] == t->whole && t->whole > 0)
        {
            t->integer = strtoll(at, &end, 10);
            good = end > at && errno == 0;
        }
        else
        {
            *to = strtod(at, &end);
            good = end > at && isfinite(*to);
        }
        good = good && (!*end || strchr(" \t\r,;", *end));
        at = end;
    }
    DEM_REQUIRE(good && !*at, DEM_ERROR_INPUT, "%s, line %d: \"%.40s\" is not a row of %d numbers, "
                "one for each column", t->file, t->line, line, t->columns);
    return t->take(t, number);
}

static int read_lines(struct dem_text_table *t, char *text)
{
    for (char *next; text; text = next)
    {
        next = strchr(text, '\n');
        if (next)
        {
            *next++ = '\0';
        }
        t->line++;
        const char first = text[strspn(text, " \t\r")];

        if (first && first != '#')
        {
            DEM_TRY(t->columns == 0 ? read_names(t, text) : read_row(t, text));
        }
    }
    return DEM_OK;
}

int dem_text_table_read(struct dem_text_table *t)
{
    char *text;
    fenv_t traps;

    DEM_TRY(dem_file_load_text(t->file, &text));
    feholdexcept(&traps);    /* a number that overflows ends in a message, not in a signal */
    /* behind the byte order mark that some editors write */
    const int status = read_lines(t, strncmp(text, "\xef\xbb\xbf", 3) == 0 ? text + 3 : text);

    fesetenv(&traps);
    dem_memory_free(text);
    return status;
}
