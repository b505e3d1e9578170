/*
 * time_table.c -- read quantities over time from a text file, and interpolate them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/time_table.h"
#include "core/error.h"
#include "core/hash.h"
#include "core/memory.h"
#include "input/text_table.h"
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

/* ---- reading --------------------------------------------------------------------------------- */

/* Times and values lie below it; more is a mistake. */
static const double limit = 1e15;

/* The time is the last of the names. */
static int check_names(const struct dem_text_table *t)
{
    DEM_REQUIRE(t->present[t->names - 1] && t->columns > 1, DEM_ERROR_INPUT,
                "%s, line %d: the first row names the columns: time, and at least one of the others",
                t->file, t->line);
    return DEM_OK;
}

static int take_row(struct dem_text_table *from, const double *number)
{
    struct dem_time_table *const t = from->data;
    double largest = 0.0;

    for (int k = 0; k < from->names; k++)
    {
        largest = fmax(largest, fabs(number[k]));
    }
    DEM_REQUIRE(largest < limit, DEM_ERROR_INPUT, "%s, line %d: %g; give numbers below %g", from->file,
                from->line, largest, limit);
    DEM_TRY(DEM_GROW(t->row, t->capacity, t->rows + 1));
    struct dem_time_row *const row = &t->row[t->rows++];

    *row = (struct dem_time_row){.time = number[from->names - 1]};
    memcpy(row->value, number, (size_t)(from->names - 1)*sizeof *number);
    DEM_REQUIRE(t->rows == 1 || row->time > row[-1].time, DEM_ERROR_INPUT,
                "%s, line %d: time %g s is not after %g s of the row before; sort the rows, and give "
                "each time once", from->file, from->line, row->time, row[-1].time);
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
    struct dem_time_table *t;
    struct dem_text_table from = {.file = file, .names = n + 1, .check = check_names, .take = take_row};

    *made = NULL;
    memcpy(from.name, name, (size_t)n*sizeof *name);
    from.name[n] = "time";
    DEM_TRY(DEM_NEW(t, 1));
    from.data = t;
    t->smooth = smooth;
    int status = dem_text_table_read(&from);

    if (!status && t->rows < 2)
    {
        status = dem_error(DEM_ERROR_INPUT, "%s has %zu rows of numbers; give at least two", file, t->rows);
    }
    if (status)
    {
        dem_time_table_free(t);
        return status;
    }
    fenv_t traps;

    /* rows so close that a slope is infinite end in the message about the wall's speed, not in a signal */
    feholdexcept(&traps);
    find_slopes(t);
    fesetenv(&traps);
    *made = t;
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
