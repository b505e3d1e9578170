/*
 * size_distribution.c -- read a size distribution, tabulate its cumulative number fraction, and
 * draw diameters by inversion.
 *
 * A smooth distribution has 4096 nodes from min to max in equal steps of ln d, with the trapezoidal
 * rule for the cumulative fraction and numbers uniform in ln d between nodes. The error is of
 * second order in the step ln(max/min)/4096, below 1e-6 for the widths of real powders.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/size_distribution.h"
#include "core/error.h"
#include "core/math.h"
#include "core/memory.h"
#include "core/random.h"
#include "core/did_you_mean.h"
#include "core/file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    NODES = 4096,
    USE_SIZE = 301  /* stream of random numbers */
};

enum type
{
    UNIFORM,
    NORMAL,
    LOG_NORMAL,
    LIST,
    TABLE,
    TYPES
};
static const char *const types[TYPES] = {"uniform", "normal", "logNormal", "list", "table"};

/* largest over smallest diameter; a wider range is an error of input */
static const double max_ratio = 1e6;

/* of a smooth distribution, not normalised */
struct density
{
    enum type type;
    int by_volume;
    double middle, deviation;  /* m, m or 1 */
};

/* ---- tables ---------------------------------------------------------------------------------- */

static int allocate(struct dem_size_distribution *s, int n)
{
    s->n = n;
    DEM_TRY(DEM_NEW(s->diameter, n + 1));
    return DEM_NEW(s->below, n + 1);
}

/* number density per ln d, not normalised */
static double density_at(const struct density *f, double d)
{
    const double away = f->type == LOG_NORMAL ? dem_log(d/f->middle)/f->deviation
                      : f->type == NORMAL     ? (d - f->middle)/f->deviation
                                              : 0.0;
    const double per_diameter = dem_exp(-0.5*away*away)/(f->type == LOG_NORMAL ? d : 1.0);

    return per_diameter*d/(f->by_volume ? d*d*d : 1.0);
}

static int refuse_range(const struct dem_size_distribution *s, const char *where)
{
    DEM_REQUIRE(s->max <= max_ratio*s->min, DEM_ERROR_INPUT,
                "%s: diameters from %g to %g m, the largest more than %g times the smallest; "
                "narrow the range", where, s->min,
                s->max, max_ratio);
    return DEM_OK;
}

static int tabulate(struct dem_size_distribution *s, const struct density *f, const char *where)
{
    const double step = dem_log(s->max/s->min)/(NODES - 1);
    double total = 0.0, before = 0.0;

    DEM_TRY(allocate(s, NODES));
    s->smooth = 1;
    for (int k = 0; k < NODES; k++)
    {
        s->diameter[k] = k == 0 ? s->min : k == NODES - 1 ? s->max : s->min*dem_exp(step*k);
        /* in units of the smallest diameter, so that its cube does not underflow */
        const struct density scaled = {f->type, f->by_volume, f->middle/s->min,
                                       f->type == NORMAL ? f->deviation/s->min : f->deviation};
        const double here = density_at(&scaled, s->diameter[k]/s->min);

        total += k > 0 ? 0.5*(before + here) : 0.0;
        before = here;
        s->below[k] = total;
    }
    DEM_REQUIRE(total > 0.0, DEM_ERROR_INPUT,
                "%s: the distribution has practically no particle from %g to %g m; correct min and "
                "max, the mean or median, or the deviation",
                where, s->min, s->max);
    for (int k = 0; k < NODES; k++)
    {
        s->below[k] /= total;
    }
    return DEM_OK;
}

/* Weights of single diameters become cumulative number fractions. */
static int sum_weights(struct dem_size_distribution *s, const double *d, const double *weight,
                       const char *where, int by_volume)
{
    double total = 0.0;

    s->min = INFINITY;
    for (int k = 0; k < s->n; k++)
    {
        DEM_REQUIRE(isfinite(d[k]) && d[k] > 0.0 && isfinite(weight[k]) && weight[k] >= 0.0,
                    DEM_ERROR_INPUT,
                    "%s: diameter %g m with weight %g; give diameters above 0 and weights of 0 or "
                    "more",
                    where, d[k], weight[k]);
        const double scaled = d[k]/d[0];

        total += weight[k]/(by_volume ? scaled*scaled*scaled : 1.0);
        s->diameter[k] = d[k];
        s->below[k] = total;
        s->min = fmin(s->min, d[k]);
        s->max = fmax(s->max, d[k]);
    }
    DEM_REQUIRE(total > 0.0, DEM_ERROR_INPUT, "%s: all weights are 0; give one above 0", where);
    DEM_TRY(refuse_range(s, where));
    for (int k = 0; k < s->n; k++)
    {
        s->below[k] /= total;
    }
    return DEM_OK;
}

/* ---- reading --------------------------------------------------------------------------------- */

static int read_smooth(struct dem_size_distribution *s, const struct dem_dict *dict,
                       struct density *f, const char *where)
{
    const char *const middle = f->type == NORMAL ? "mean" : "median";
    double low = 0.0, high = 0.0;

    if (f->type != UNIFORM)
    {
        DEM_TRY(dem_dict_number(dict, middle, "m", &f->middle));
        DEM_TRY(dem_dict_number(dict, "deviation", f->type == NORMAL ? "m" : "1", &f->deviation));
        DEM_REQUIRE(f->middle > 0.0 && f->deviation > 0.0, DEM_ERROR_INPUT,
                    "%s: %s %g m, deviation %g; give numbers above 0", where, middle, f->middle,
                    f->deviation);
        const double spread = f->type == NORMAL ? 3.0*f->deviation : dem_exp(3.0*f->deviation);

        low = f->type == NORMAL ? f->middle - spread : f->middle/spread;
        high = f->type == NORMAL ? f->middle + spread : f->middle*spread;
    }
    if (f->type == UNIFORM)
    {
        DEM_TRY(dem_dict_number(dict, "min", "m", &s->min));
        DEM_TRY(dem_dict_number(dict, "max", "m", &s->max));
    }
    else
    {
        DEM_TRY(dem_dict_number_or(dict, "min", "m", low, &s->min));
        DEM_TRY(dem_dict_number_or(dict, "max", "m", high, &s->max));
    }
    DEM_REQUIRE(s->min > 0.0 && s->min < s->max && isfinite(s->max), DEM_ERROR_INPUT,
                "%s: diameters from %g to %g m; give 0 < min < max%s", where, s->min, s->max,
                f->type == UNIFORM ? "" : ", or a deviation that makes such limits");
    DEM_TRY(refuse_range(s, where));
    return tabulate(s, f, where);
}

static int read_list(struct dem_size_distribution *s, const struct dem_dict *dict, int by_volume,
                     const char *where)
{
    const double *diameter, *weight;
    size_t n, m;

    DEM_TRY(dem_dict_numbers(dict, "diameters", "m", &diameter, &n));
    DEM_TRY(dem_dict_numbers(dict, "weights", "1", &weight, &m));
    DEM_REQUIRE(n > 0 && n == m, DEM_ERROR_INPUT,
                "%s: %zu diameters and %zu weights; give as many of each", where, n, m);
    DEM_TRY(allocate(s, (int)n));
    return sum_weights(s, diameter, weight, where, by_volume);
}

/* A row "diameter, weight", separated by a comma, a semicolon or blanks. Returns 1; 0 for an
   empty row or a comment; -1 for an error. */
static int read_row(const char *line, double *d, double *weight)
{
    char *end;

    line += strspn(line, " \t\r");
    if (!*line || *line == '#')
    {
        return 0;
    }
    *d = strtod(line, &end);
    const char *const second = end + strspn(end, " \t,;");

    if (end == line || second == end)
    {
        return -1;
    }
    *weight = strtod(second, &end);
    return end == second || end[strspn(end, " \t\r")] ? -1 : 1;
}

static int read_rows(struct dem_size_distribution *s, char *text, const char *file, int by_volume)
{
    double *d = NULL, *weight = NULL;
    size_t d_capacity = 0, weight_capacity = 0;
    int n = 0, line = 1, status = DEM_OK;

    for (char *next; text && !status; text = next, line++)
    {
        next = strchr(text, '\n');
        if (next)
        {
            *next++ = '\0';
        }
        status = DEM_GROW(d, d_capacity, n + 1);
        status = status ? status : DEM_GROW(weight, weight_capacity, n + 1);
        const int found = status ? 0 : read_row(text, &d[n], &weight[n]);

        /* the first row may name the columns */
        status = found < 0 && line > 1 ? dem_error(DEM_ERROR_INPUT, "%s, line %d: \"%.40s\" is not "
            "a row of diameter and weight", file, line, text)
                                       : status;
        n += found > 0;
    }
    status = status || n > 0
               ? status
               : dem_error(DEM_ERROR_INPUT, "%s: no row of diameter and weight", file);
    status = status ? status : allocate(s, n);
    status = status ? status : sum_weights(s, d, weight, file, by_volume);
    dem_memory_free(d);
    dem_memory_free(weight);
    return status;
}

static int read_table(struct dem_size_distribution *s, const struct dem_dict *dict, int by_volume)
{
    const char *file;
    char *text;

    DEM_TRY(dem_dict_text(dict, "file", &file));
    DEM_TRY(dem_file_load_text(file, &text));
    const int status = read_rows(s, text, file, by_volume);

    dem_memory_free(text);
    return status;
}

static int read_sizes(struct dem_size_distribution *s, const struct dem_dict *dict)
{
    static const char *const ways[] = {"number", "volume"};
    const char *type, *by;
    struct density f = {.type = TYPES};
    char where[256];

    snprintf(where, sizeof where, "%s: %s", dem_dict_where(dict), dem_dict_path(dict));
    DEM_TRY(dem_dict_word(dict, "type", &type));
    DEM_TRY(dem_dict_word_or(dict, "by", ways[0], &by));
    f.by_volume = strcmp(by, ways[1]) == 0;
    if (!f.by_volume && strcmp(by, ways[0]) != 0)
    {
        return dem_error_prefix(dem_did_you_mean_error("way of counting", by, ways, 2),
                                "%s/by: ", where);
    }
    for (int k = 0; k < TYPES; k++)
    {
        f.type = strcmp(type, types[k]) == 0 ? (enum type)k : f.type;
    }
    switch (f.type)
    {
    case LIST:
        return read_list(s, dict, f.by_volume, where);
    case TABLE:
        return read_table(s, dict, f.by_volume);
    case TYPES:
        return dem_error_prefix(dem_did_you_mean_error("type of sizes", type, types, TYPES),
                                "%s/type: ", where);
    default:
        return read_smooth(s, dict, &f, where);
    }
}

static int read_diameters(struct dem_size_distribution *s, const struct dem_dict *group)
{
    const struct dem_dict *dict;

    DEM_TRY(dem_dict_sub_if(group, "sizes", &dict));
    DEM_REQUIRE(!dict || !dem_dict_has(group, "diameter"), DEM_ERROR_INPUT,
                "%s: both diameter and sizes; keep one", dem_dict_where(group));
    if (dict)
    {
        return read_sizes(s, dict);
    }
    DEM_TRY(dem_dict_number(group, "diameter", "m", &s->min));
    DEM_REQUIRE(s->min > 0.0, DEM_ERROR_INPUT, "%s: diameter %g m; give a number above 0",
                dem_dict_where(group), s->min);
    s->max = s->min;
    return DEM_OK;
}

int dem_size_distribution_read(struct dem_size_distribution *s, const struct dem_dict *group,
                               double factor)
{
    memset(s, 0, sizeof *s);
    DEM_TRY(read_diameters(s, group));
    s->min *= factor;
    s->max *= factor;
    for (int k = 0; k < s->n; k++)
    {
        s->diameter[k] *= factor;
    }
    return DEM_OK;
}

void dem_size_distribution_free(struct dem_size_distribution *s)
{
    dem_memory_free(s->diameter);
    dem_memory_free(s->below);
    memset(s, 0, sizeof *s);
}

/* ---- drawing --------------------------------------------------------------------------------- */

double dem_size_distribution_mean_volume(const struct dem_size_distribution *s)
{
    double mean = s->n > 0 ? 0.0 : s->min*s->min*s->min;

    for (int k = 0; k < s->n; k++)
    {
        const double fraction = k > 0 ? s->below[k] - s->below[k - 1] : s->below[0];
        const double d =
            s->smooth && k > 0 ? 0.5*(s->diameter[k] + s->diameter[k - 1]) : s->diameter[k];

        mean += fraction*d*d*d;
    }
    return 3.14159265358979323846/6.0*mean;
}

double dem_size_distribution_draw(const struct dem_size_distribution *s, uint64_t seed,
                                  uint64_t number)
{
    const double u = s->n > 0 ? dem_random_unit(seed, number, 0, USE_SIZE) : 0.0;
    int low = 0, high = s->n - 1;    /* the first node with u < below */

    while (low < high)
    {
        const int middle = (low + high)/2;

        low = u < s->below[middle] ? low : middle + 1;
        high = u < s->below[middle] ? middle : high;
    }
    if (s->n == 0)
    {
        return s->min;
    }
    if (!s->smooth || low == 0)
    {
        return s->diameter[low];
    }
    const double fraction = (u - s->below[low - 1])/(s->below[low] - s->below[low - 1]);

    return s->diameter[low - 1]*dem_exp(fraction*dem_log(s->diameter[low]/s->diameter[low - 1]));
}
