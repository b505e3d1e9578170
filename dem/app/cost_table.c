/*
 * cost_table.c -- `dem cost -judge TABLE FOLDER`: errors, processor times and the best buy for
 * refinement series of runs that another program made (demCost: runs of an OpenFOAM case).
 *
 * TABLE has one statement a line, its words separated by commas. `ladder` and `rung` are accepted
 * for `series` and `level`.
 *
 *   title,TEXT                         first line of the report
 *   window,S                           simulated time of each run [s]
 *   target,E                           error that the best buy must not exceed [1]
 *   closed,QUANTITY,VALUE              exact value; reference of all series except compared ones
 *   series,KIND,NAME,ENTRY,TEXT        begins a series. KIND: step (one of its levels is the best
 *                                      buy), limit (the error of another model parameter, which no
 *                                      step removes), compared (changes against its last level, run
 *                                      by run). ENTRY: what a user changes. TEXT: description
 *   level,NAME,BASE,SIZE,STEP          begins a level of it, from coarse to fine. BASE 1: the case
 *                                      as it is. SIZE: what the error goes to zero with. STEP [s]
 *   run,STEPS,SECONDS                  begins a run of it: steps in the window, processor time
 *   value,QUANTITY,UNIT,SCALE,VALUE    of this run; errors are divided by SCALE, or by the
 *                                      reference if that is 0
 *   failed,TEXT                        error text of a level without runs
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* mkdir */
#include "app/cost.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct table
{
    const char *path;
    int line;
    char *word[6];  /* of the present line */
    struct dem_cost *cost;
};

/* ---- words ----------------------------------------------------------------------------------- */

/* Split the line at its first n - 1 commas; the last word is the rest. */
static int split(struct table *t, char *line, int n)
{
    line[strcspn(line, "\n")] = '\0';
    for (int k = 0; k < n; k++)
    {
        char *const comma = k < n - 1 ? strchr(line, ',') : NULL;

        DEM_REQUIRE(comma || k == n - 1, DEM_ERROR_INPUT, "%s, line %d: %d words where %s has %d",
                    t->path, t->line, k + 1, t->word[0], n);
        t->word[k] = line;
        if (comma)
        {
            *comma = '\0';
            line = comma + 1;
        }
    }
    return DEM_OK;
}

static int number(const struct table *t, int word, double min, double *value)
{
    char *end;

    *value = strtod(t->word[word], &end);
    DEM_REQUIRE(end != t->word[word] && !*end && isfinite(*value) && *value >= min, DEM_ERROR_INPUT,
                "%s, line %d: \"%s\" where %s has a number of at least %g", t->path, t->line,
                t->word[word], t->word[0], min);
    return DEM_OK;
}

/* Index of the quantity of this name, which is added if it is new. */
static int quantity_of(struct table *t, const char *name, const char *unit, int *q)
{
    struct dem_cost *const c = t->cost;

    for (*q = 0; *q < c->quantities && strcmp(c->quantity[*q].name, name) != 0; (*q)++)
    {
    }
    DEM_REQUIRE(*q < DEM_COST_MAX_QUANTITIES, DEM_ERROR_INPUT,
                "%s, line %d: more than %d quantities; leave some out", t->path, t->line,
                DEM_COST_MAX_QUANTITIES);
    if (*q == c->quantities)
    {
        DEM_REQUIRE(name[0] && strlen(name) < sizeof c->quantity[0].name, DEM_ERROR_INPUT,
                    "%s, line %d: quantity \"%s\"; give a name of 1 to %zu characters", t->path,
                    t->line, name, sizeof c->quantity[0].name - 1);
        c->quantities++;
        c->wanted[*q] = 1;
        snprintf(c->quantity[*q].name, sizeof c->quantity[0].name, "%s", name);
    }
    snprintf(c->quantity[*q].unit, sizeof c->quantity[0].unit, "%s",
             unit ? unit : c->quantity[*q].unit);
    return DEM_OK;
}

/* ---- lines ----------------------------------------------------------------------------------- */

static struct dem_cost_series *current_series(struct table *t)
{
    return t->cost->n_series > 0 ? &t->cost->series[t->cost->n_series - 1] : NULL;
}

static struct dem_cost_level *current_level(struct table *t)
{
    struct dem_cost_series *const l = current_series(t);

    return l && l->levels > 0 ? &l->level[l->levels - 1] : NULL;
}

static int read_title(struct table *t)
{
    snprintf(t->cost->title, sizeof t->cost->title, "%s", t->word[1]);
    return DEM_OK;
}

static int read_window(struct table *t)
{
    return number(t, 1, 1e-300, &t->cost->window);
}

static int read_target(struct table *t)
{
    return number(t, 1, 1e-12, &t->cost->target);
}

static int read_closed(struct table *t)
{
    int q;

    DEM_TRY(quantity_of(t, t->word[1], NULL, &q));
    t->cost->has_closed_form[q] = 1;
    return number(t, 2, -INFINITY, &t->cost->closed_form[q]);
}

static int read_series(struct table *t)
{
    static const char *const kinds[] = {"step", "limit", "compared"};
    struct dem_cost *const c = t->cost;
    int kind = 0;

    while (kind < 3 && strcmp(kinds[kind], t->word[1]) != 0)
    {
        kind++;
    }
    DEM_REQUIRE(kind < 3, DEM_ERROR_INPUT,
                "%s, line %d: a series of kind \"%s\"; give step, limit or compared", t->path,
                t->line, t->word[1]);
    DEM_REQUIRE(c->n_series < DEM_COST_MAX_SERIES, DEM_ERROR_INPUT,
                "%s, line %d: more than %d series", t->path, t->line, DEM_COST_MAX_SERIES);
    struct dem_cost_series *const l = &c->series[c->n_series++];

    snprintf(l->parameter, sizeof l->parameter, "%s", t->word[2]);
    snprintf(l->entry, sizeof l->entry, "%s", t->word[3]);
    snprintf(l->description, sizeof l->description, "%s", t->word[4]);
    l->base = -1;
    l->exact = kind == 0;
    l->paired = kind == 2;
    return DEM_OK;
}

static int read_level(struct table *t)
{
    struct dem_cost_series *const l = current_series(t);
    double base;

    DEM_REQUIRE(l && l->levels < DEM_REFINEMENT_LEVELS, DEM_ERROR_INPUT,
                "%s, line %d: a level without a series, or more than %d in it", t->path, t->line,
                DEM_REFINEMENT_LEVELS);
    struct dem_cost_level *const r = &l->level[l->levels++];

    snprintf(r->name, sizeof r->name, "%s", t->word[1]);
    DEM_TRY(number(t, 2, 0.0, &base));
    DEM_TRY(number(t, 3, 1e-300, &r->size));
    DEM_TRY(number(t, 4, 1e-300, &r->step));
    l->base = base > 0.0 ? l->levels - 1 : l->base;
    DEM_REQUIRE(l->levels < 2 || r->size < r[-1].size, DEM_ERROR_INPUT,
                "%s, line %d: level %s of size %g after %g; from coarse to fine the size falls",
                t->path, t->line, r->name, r->size, r[-1].size);
    return DEM_OK;
}

static int read_run(struct table *t)
{
    struct dem_cost_level *const r = current_level(t);
    double steps;

    DEM_REQUIRE(r && r->runs < DEM_REFINEMENT_RUNS, DEM_ERROR_INPUT,
                "%s, line %d: a run without a level, or more than %d in it", t->path, t->line,
                DEM_REFINEMENT_RUNS);
    struct dem_cost_run *const run = &r->run[r->runs++];

    DEM_TRY(number(t, 1, 1.0, &steps));
    run->steps = (int64_t)steps;
    for (int q = 0; q < DEM_COST_MAX_QUANTITIES; q++)
    {
        run->value[q] = NAN;
    }
    t->cost->runs = r->runs > t->cost->runs ? r->runs : t->cost->runs;
    return number(t, 2, 0.0, &run->seconds);
}

static int read_value(struct table *t)
{
    struct dem_cost_level *const r = current_level(t);
    int q;

    DEM_REQUIRE(r && r->runs > 0, DEM_ERROR_INPUT, "%s, line %d: a value without a run", t->path,
                t->line);
    DEM_TRY(quantity_of(t, t->word[1], t->word[2], &q));
    DEM_TRY(number(t, 3, 0.0, &t->cost->scale[q]));
    return number(t, 4, -INFINITY, &r->run[r->runs - 1].value[q]);
}

static int read_failed(struct table *t)
{
    struct dem_cost_level *const r = current_level(t);

    DEM_REQUIRE(r, DEM_ERROR_INPUT, "%s, line %d: a failure without a level", t->path, t->line);
    snprintf(r->failed, sizeof r->failed, "%s", t->word[1]);
    r->runs = 0;
    return DEM_OK;
}

static const struct
{
    const char *name;
    int words;
    int (*read)(struct table *);
} lines[] =
{
    {"title", 2, read_title}, {"window", 2, read_window}, {"target", 2, read_target},
    {"closed", 3, read_closed}, {"series", 5, read_series}, {"ladder", 5, read_series},
    {"level", 5, read_level}, {"rung", 5, read_level}, {"run", 3, read_run},
    {"value", 5, read_value}, {"failed", 2, read_failed},
};

/* ---- the table ------------------------------------------------------------------------------- */

static int read_line(struct table *t, char *text)
{
    for (size_t k = 0; k < sizeof lines/sizeof lines[0]; k++)
    {
        const size_t n = strlen(lines[k].name);

        if (strncmp(text, lines[k].name, n) == 0 && text[n] == ',')
        {
            t->word[0] = text;
            DEM_TRY(split(t, text, lines[k].words));
            return lines[k].read(t);
        }
    }
    return dem_error(DEM_ERROR_INPUT,
                     "%s, line %d: begins with none of title, window, target, closed, series, "
                     "level, run, value, failed",
                     t->path, t->line);
}

static int read_lines(struct table *t, FILE *f)
{
    char text[1024];

    while (fgets(text, sizeof text, f))
    {
        t->line++;
        DEM_TRY(read_line(t, text));
    }
    return DEM_OK;
}

/* Requirements of advisor/refinement_series.h and of the comparison run by run. */
static int check(const struct table *t)
{
    const struct dem_cost *const c = t->cost;

    DEM_REQUIRE(c->window > 0.0 && c->n_series > 0, DEM_ERROR_INPUT, "%s: no window or no series",
                t->path);
    for (int n = 0; n < c->n_series; n++)
    {
        const struct dem_cost_series *const l = &c->series[n];

        DEM_REQUIRE(l->base >= 0 && l->level[l->base].runs > 0, DEM_ERROR_INPUT,
                    "%s: series %s lacks the case as it is%s%s", t->path, l->parameter,
                    l->base >= 0 ? ", which failed: " : "",
                    l->base >= 0 ? l->level[l->base].failed : "");
        for (int k = 0; k < l->levels && l->paired; k++)
        {
            DEM_REQUIRE(l->base == l->levels - 1
                            && (l->level[k].runs == 0
                                || l->level[k].runs == l->level[l->base].runs),
                        DEM_ERROR_INPUT,
                        "%s: series %s is compared run by run; give the case as it is last, and as "
                        "many runs in all levels",
                        t->path, l->parameter);
        }
    }
    return DEM_OK;
}

int dem_cost_report_table(struct dem_cost *c, int argc, char **argv)
{
    struct table t = {.path = argc > 1 ? argv[1] : NULL, .cost = c};

    DEM_REQUIRE(argc == 3, DEM_ERROR_INPUT,
                "dem cost -judge takes a table and a folder; see dem cost -help");
    DEM_REQUIRE(strlen(argv[2]) < sizeof c->folder, DEM_ERROR_INPUT,
                "a folder's name of %zu characters; give one of at most %zu", strlen(argv[2]),
                sizeof c->folder - 1);
    FILE *const f = fopen(t.path, "r");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "cannot read %s: %s", t.path, strerror(errno));
    c->noun = "case";
    c->limit = INFINITY;
    c->target = 0.01;
    int status = read_lines(&t, f);

    fclose(f);
    status = status ? status : check(&t);
    DEM_TRY(status);
    for (int n = 0; n < c->n_series; n++)
    {
        memcpy(c->series[n].reported, c->wanted, sizeof c->series[n].reported);
    }
    snprintf(c->folder, sizeof c->folder, "%s", argv[2]);
    DEM_REQUIRE(mkdir(c->folder, 0777) == 0 || errno == EEXIST, DEM_ERROR_FILE,
                "cannot make the folder %s: %s", c->folder, strerror(errno));
    dem_cost_find_errors(c);
    dem_cost_report(c);
    return dem_cost_write(c);
}
