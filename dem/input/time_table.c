/*
 * time_table.c -- read quantities over time from a text file, and interpolate them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/time_table.h"
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/memory.h"
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading --------------------------------------------------------------------------------- */

enum
{
    TIME = DEM_TIME_TABLE_COLUMNS,    /* what a column holds: a quantity, or the time */
    NAMES
};

/* Times and values lie below it, so that slopes are finite. */
static const double limit = 1e15;

struct reader
{
    struct dem_time_table *table;
    const char *file, *name[NAMES];
    int names, line, columns, what[NAMES], present[NAMES];
};

static const char *skip(const char *at)
{
    at += strspn(at, " \t\r");
    at += *at == ',' || *at == ';';
    return at + strspn(at, " \t\r");
}

static int read_name(struct reader *r, const char *at, size_t length)
{
    char word[32];
    int k = 0;

    snprintf(word, sizeof word, "%.*s", (int)(length < sizeof word ? length : sizeof word - 1), at);
    word[strcspn(word, "[")] = '\0';
    while (k < r->names && strcmp(word, r->name[k]) != 0)
    {
        k++;
    }
    if (k == r->names)
    {
        return dem_error_prefix(dem_did_you_mean_error("column", word, r->name, r->names),
                                "%s, line %d: ", r->file, r->line);
    }
    const int what = k == r->names - 1 ? TIME : k;

    DEM_REQUIRE(!r->present[what], DEM_ERROR_INPUT,
                "%s, line %d: column %s comes twice; remove one", r->file, r->line, word);
    r->present[what] = 1;
    r->what[r->columns++] = what;
    return DEM_OK;
}

static int read_names(struct reader *r, const char *line)
{
    for (const char *at = skip(line); *at; at = skip(at))
    {
        const size_t length = strcspn(at, " \t\r,;");

        DEM_TRY(read_name(r, at, length));
        at += length;
    }
    DEM_REQUIRE(r->present[TIME] && r->columns > 1, DEM_ERROR_INPUT,
                "%s, line %d: the first row names the columns: time, and at least one of the others",
                r->file, r->line);
    return DEM_OK;
}

static int read_row(struct reader *r, const char *line)
{
    struct dem_time_table *const t = r->table;
    const char *at = skip(line);
    int good = 1;

    DEM_TRY(DEM_GROW(t->row, t->capacity, t->rows + 1));
    struct dem_time_row *const row = &t->row[t->rows++];

    *row = (struct dem_time_row){.time = 0.0};
    for (int c = 0; c < r->columns && good; c++, at = skip(at))
    {
        double *const to = r->what[c] == TIME ? &row->time : &row->value[r->what[c]];
        char *end;

        *to = strtod(at, &end);
        good = end > at && isless(fabs(*to), limit) && (!*end || strchr(" \t\r,;", *end));
        at = end;
    }
    DEM_REQUIRE(good && !*at, DEM_ERROR_INPUT,
                "%s, line %d: \"%.40s\" is not a row of %d numbers below %g, one for each column",
                r->file, r->line, line, r->columns, limit);
    DEM_REQUIRE(t->rows == 1 || row->time > row[-1].time, DEM_ERROR_INPUT,
                "%s, line %d: time %g s is not after %g s of the row before; sort the rows, and give "
                "each time once", r->file, r->line, row->time, row[-1].time);
    return DEM_OK;
}

static int read_lines(struct reader *r, char *text)
{
    for (char *next; text; text = next)
    {
        next = strchr(text, '\n');
        if (next)
        {
            *next++ = '\0';
        }
        r->line++;
        const char first = text[strspn(text, " \t\r")];

        if (first && first != '#')
        {
            DEM_TRY(r->columns == 0 ? read_names(r, text) : read_row(r, text));
        }
    }
    DEM_REQUIRE(r->table->rows > 1, DEM_ERROR_INPUT,
                "%s has %zu rows of numbers; give at least two", r->file, r->table->rows);
    return DEM_OK;
}

/* ---- slopes ---------------------------------------------------------------------------------- */

static double chord(const struct dem_time_row *r, int k)
{
    return (r[1].value[k] - r[0].value[k])/(r[1].time - r[0].time);
}

/* At a row between two intervals with the slopes a and b. */
static double slope_between(const struct dem_time_row *r, double a, double b)
{
    const double before = r[0].time - r[-1].time, after = r[1].time - r[0].time;
    const double parabola = (a*after + b*before)/(before + after);
    const double least = fmin(fmin(fabs(a), fabs(b)), 0.5*fabs(parabola));

    return a*b > 0.0 ? (a > 0.0 ? 2.0*least : -2.0*least) : 0.0;
}

/* At the first or last row, where the slope is a in the interval of length h and b in the next one, of
   length g. */
static double slope_at_end(double a, double h, double b, double g)
{
    const double p = a + (a - b)*h/(h + g);

    return p*a <= 0.0 ? 0.0 : fabs(p) > 2.0*fabs(a) ? 2.0*a : p;
}

static void find_slopes(struct dem_time_table *t)
{
    const size_t last = t->rows - 1;
    struct dem_time_row *const r = t->row;

    for (int k = 0; k < DEM_TIME_TABLE_COLUMNS; k++)
    {
        for (size_t i = 1; i < last; i++)
        {
            r[i].slope[k] = slope_between(&r[i], chord(&r[i - 1], k), chord(&r[i], k));
        }
        if (last == 1)
        {
            r[0].slope[k] = r[1].slope[k] = chord(r, k);
            continue;
        }
        r[0].slope[k] = slope_at_end(chord(r, k), r[1].time - r[0].time, chord(r + 1, k),
                                     r[2].time - r[1].time);
        r[last].slope[k] =
            slope_at_end(chord(r + last - 1, k), r[last].time - r[last - 1].time,
                         chord(r + last - 2, k), r[last - 1].time - r[last - 2].time);
    }
}

int dem_time_table_read(struct dem_time_table **made, const char *file, const char *const *name,
                        int n, int smooth)
{
    struct reader r = {.file = file, .names = n + 1};
    char *text;
    fenv_t traps;

    *made = NULL;
    memcpy(r.name, name, (size_t)n*sizeof *name);
    r.name[n] = "time";
    DEM_TRY(dem_file_load_text(file, &text));
    int status = DEM_NEW(r.table, 1);

    if (!status)
    {
        feholdexcept(&traps);    /* a number that overflows ends in a message, not in a signal */
        r.table->smooth = smooth;
        status = read_lines(&r, text);
        if (!status)
        {
            find_slopes(r.table);
        }
        fesetenv(&traps);
    }
    dem_memory_free(text);
    if (status)
    {
        dem_time_table_free(r.table);
        return status;
    }
    *made = r.table;
    return DEM_OK;
}

void dem_time_table_free(struct dem_time_table *t)
{
    if (t)
    {
        dem_memory_free(t->row);
        dem_memory_free(t);
    }
}

/* ---- interpolation --------------------------------------------------------------------------- */

/* The interval of a time between the first and the last row. */
static const struct dem_time_row *find(const struct dem_time_table *t, double time)
{
    size_t from = 0, to = t->rows - 1;

    while (to - from > 1)
    {
        const size_t middle = from + (to - from)/2;

        from = t->row[middle].time <= time ? middle : from;
        to = t->row[middle].time <= time ? to : middle;
    }
    return &t->row[from];
}

void dem_time_table_at(const struct dem_time_table *t, double time, double *value)
{
    const double first = t->row[0].time, last = t->row[t->rows - 1].time;
    const double at = time < first ? first : time > last ? last : time;
    const struct dem_time_row *const r = find(t, at);
    const double h = r[1].time - r[0].time, s = (at - r[0].time)/h;

    for (int k = 0; k < DEM_TIME_TABLE_COLUMNS; k++)
    {
        const double d = chord(r, k), a = r[0].slope[k], b = r[1].slope[k];

        value[k] = s == 1.0     ? r[1].value[k]
                   : t->smooth ? r[0].value[k] + h*s*(a + s*((3.0*d - 2.0*a - b) + s*(a + b - 2.0*d)))
                               : r[0].value[k] + h*s*d;
    }
}

/* The slope of a cubic is a parabola: it is largest at an end or at the vertex. */
static double steepest(const struct dem_time_row *r, int k)
{
    const double d = chord(r, k), a = r[0].slope[k], b = r[1].slope[k];
    const double linear = 3.0*d - 2.0*a - b, cubic = 3.0*(a + b - 2.0*d);
    const double vertex = cubic != 0.0 ? -linear/cubic : 0.0;
    const double inside = vertex > 0.0 && vertex < 1.0 ? a + linear*vertex : 0.0;

    return fmax(fmax(fabs(a), fabs(b)), fabs(inside));
}

void dem_time_table_rates(const struct dem_time_table *t, double *rate)
{
    for (int k = 0; k < DEM_TIME_TABLE_COLUMNS; k++)
    {
        rate[k] = 0.0;
        for (size_t i = 0; i + 1 < t->rows; i++)
        {
            rate[k] = fmax(rate[k], t->smooth ? steepest(&t->row[i], k) : fabs(chord(&t->row[i], k)));
        }
    }
}

double dem_time_table_shortest(const struct dem_time_table *t)
{
    double shortest = DBL_MAX;

    for (size_t i = 0; i + 1 < t->rows; i++)
    {
        shortest = fmin(shortest, t->row[i + 1].time - t->row[i].time);
    }
    return shortest;
}

uint64_t dem_time_table_hash(const struct dem_time_table *t)
{
    struct dem_hash hash;

    dem_hash_start(&hash, (uint64_t)t->smooth);
    dem_hash_bytes(&hash, t->row, t->rows*sizeof *t->row);
    return dem_hash_value(&hash);
}
