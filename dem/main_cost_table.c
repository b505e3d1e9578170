/*
 * main_cost_table.c -- `dem cost -judge TABLE FOLDER`: ladders of runs that another program made (demCost: runs of an OpenFOAM case),
 * judged and told like those of a scene.
 *
 * TABLE has a line for each thing, its words with commas between:
 *
 *   title,TEXT                         first line of what is told
 *   window,S                           s of simulated time of each run
 *   target,E                           the error to be bought
 *   closed,QUANTITY,VALUE              what must come out; errors of all ladders but compared ones are counted from there
 *   ladder,KIND,NAME,ENTRY,SAYS        opens a ladder. KIND: step (one of them is the best buy), limit (of another model: what no step
 *                                      mends), compared (changes against its last rung, run by run). ENTRY: what a user writes
 *   rung,NAME,BASE,SIZE,STEP           opens a rung of it, from coarse to fine. BASE 1: the case as it is. SIZE: what the error goes to 0
 *                                      with. STEP: s
 *   run,STEPS,SECONDS                  opens a run of it: steps in the window, processor time
 *   value,QUANTITY,UNIT,SCALE,VALUE    of this run; errors are shares of SCALE, 0: of the reference
 *   failed,TEXT                        why the rung has no runs
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* mkdir */
#include "main_cost.h"
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
    char *word[6];                                        /* of the line at hand */
    struct dem_cost *cost;
};

/* ---- words ------------------------------------------------------------------------------------------------------- */

/* The first n - 1 commas part words; the last word is the rest. */
static int split(struct table *t, char *line, int n)
{
    line[strcspn(line, "\n")] = '\0';
    for (int k = 0; k < n; k++)
    {
        char *const comma = k < n - 1 ? strchr(line, ',') : NULL;

        DEM_REQUIRE(comma || k == n - 1, DEM_ERROR_INPUT, "%s, line %d: %d words where %s has %d", t->path, t->line, k + 1, t->word[0], n);
        t->word[k] = line;
        if (comma)
        {
            *comma = '\0';
            line = comma + 1;
        }
    }
    return DEM_OK;
}

static int number(const struct table *t, int word, double least, double *value)
{
    char *end;

    *value = strtod(t->word[word], &end);
    DEM_REQUIRE(end != t->word[word] && !*end && isfinite(*value) && *value >= least, DEM_ERROR_INPUT, "%s, line %d: \"%s\" where %s has a "
                "number of at least %g", t->path, t->line, t->word[word], t->word[0], least);
    return DEM_OK;
}

/* The quantity of this name, which is new when it was not there. */
static int quantity_of(struct table *t, const char *name, const char *unit, int *q)
{
    struct dem_cost *const c = t->cost;

    for (*q = 0; *q < c->quantities && strcmp(c->quantity[*q].name, name) != 0; (*q)++)
    {
    }
    DEM_REQUIRE(*q < DEM_COST_QUANTITIES, DEM_ERROR_INPUT, "%s, line %d: more than %d quantities; leave some out", t->path, t->line,
                DEM_COST_QUANTITIES);
    if (*q == c->quantities)
    {
        DEM_REQUIRE(name[0] && strlen(name) < sizeof c->quantity[0].name, DEM_ERROR_INPUT, "%s, line %d: quantity \"%s\"; give a name of 1 to %zu "
                    "letters", t->path, t->line, name, sizeof c->quantity[0].name - 1);
        c->quantities++;
        c->wanted[*q] = 1;
        snprintf(c->quantity[*q].name, sizeof c->quantity[0].name, "%s", name);
    }
    snprintf(c->quantity[*q].unit, sizeof c->quantity[0].unit, "%s", unit ? unit : c->quantity[*q].unit);
    return DEM_OK;
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

static struct dem_cost_ladder *ladder_at_hand(struct table *t)
{
    return t->cost->ladders > 0 ? &t->cost->ladder[t->cost->ladders - 1] : NULL;
}

static struct dem_cost_rung *rung_at_hand(struct table *t)
{
    struct dem_cost_ladder *const l = ladder_at_hand(t);

    return l && l->rungs > 0 ? &l->rung[l->rungs - 1] : NULL;
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
    t->cost->closed[q] = 1;
    return number(t, 2, -INFINITY, &t->cost->form[q]);
}

static int read_ladder(struct table *t)
{
    static const char *const kinds[] = {"step", "limit", "compared"};
    struct dem_cost *const c = t->cost;
    int kind = 0;

    while (kind < 3 && strcmp(kinds[kind], t->word[1]) != 0)
    {
        kind++;
    }
    DEM_REQUIRE(kind < 3, DEM_ERROR_INPUT, "%s, line %d: a ladder of kind \"%s\"; give step, limit or compared", t->path, t->line, t->word[1]);
    DEM_REQUIRE(c->ladders < DEM_COST_MOST_LADDERS, DEM_ERROR_INPUT, "%s, line %d: more than %d ladders", t->path, t->line, DEM_COST_MOST_LADDERS);
    struct dem_cost_ladder *const l = &c->ladder[c->ladders++];

    snprintf(l->knob, sizeof l->knob, "%s", t->word[2]);
    snprintf(l->entry, sizeof l->entry, "%s", t->word[3]);
    snprintf(l->says, sizeof l->says, "%s", t->word[4]);
    l->base = -1;
    l->exact = kind == 0;
    l->paired = kind == 2;
    return DEM_OK;
}

static int read_rung(struct table *t)
{
    struct dem_cost_ladder *const l = ladder_at_hand(t);
    double base;

    DEM_REQUIRE(l && l->rungs < DEM_LADDER_RUNGS, DEM_ERROR_INPUT, "%s, line %d: a rung without a ladder, or more than %d in it", t->path, t->line,
                DEM_LADDER_RUNGS);
    struct dem_cost_rung *const r = &l->rung[l->rungs++];

    snprintf(r->name, sizeof r->name, "%s", t->word[1]);
    DEM_TRY(number(t, 2, 0.0, &base));
    DEM_TRY(number(t, 3, 1e-300, &r->size));
    DEM_TRY(number(t, 4, 1e-300, &r->step));
    l->base = base > 0.0 ? l->rungs - 1 : l->base;
    DEM_REQUIRE(l->rungs < 2 || r->size < r[-1].size, DEM_ERROR_INPUT, "%s, line %d: rung %s of size %g after %g; from coarse to fine the size falls",
                t->path, t->line, r->name, r->size, r[-1].size);
    return DEM_OK;
}

static int read_run(struct table *t)
{
    struct dem_cost_rung *const r = rung_at_hand(t);
    double steps;

    DEM_REQUIRE(r && r->runs < DEM_LADDER_RUNS, DEM_ERROR_INPUT, "%s, line %d: a run without a rung, or more than %d in it", t->path, t->line,
                DEM_LADDER_RUNS);
    struct dem_cost_run *const run = &r->run[r->runs++];

    DEM_TRY(number(t, 1, 1.0, &steps));
    run->steps = (int64_t)steps;
    for (int q = 0; q < DEM_COST_QUANTITIES; q++)
    {
        run->value[q] = NAN;
    }
    t->cost->runs = r->runs > t->cost->runs ? r->runs : t->cost->runs;
    return number(t, 2, 0.0, &run->seconds);
}

static int read_value(struct table *t)
{
    struct dem_cost_rung *const r = rung_at_hand(t);
    int q;

    DEM_REQUIRE(r && r->runs > 0, DEM_ERROR_INPUT, "%s, line %d: a value without a run", t->path, t->line);
    DEM_TRY(quantity_of(t, t->word[1], t->word[2], &q));
    DEM_TRY(number(t, 3, 0.0, &t->cost->scale[q]));
    return number(t, 4, -INFINITY, &r->run[r->runs - 1].value[q]);
}

static int read_failed(struct table *t)
{
    struct dem_cost_rung *const r = rung_at_hand(t);

    DEM_REQUIRE(r, DEM_ERROR_INPUT, "%s, line %d: a failure without a rung", t->path, t->line);
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
    {"title", 2, read_title}, {"window", 2, read_window}, {"target", 2, read_target}, {"closed", 3, read_closed}, {"ladder", 5, read_ladder},
    {"rung", 5, read_rung}, {"run", 3, read_run}, {"value", 5, read_value}, {"failed", 2, read_failed},
};

/* ---- the table --------------------------------------------------------------------------------------------------- */

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
    return dem_error(DEM_ERROR_INPUT, "%s, line %d: begins with none of title, window, target, closed, ladder, rung, run, value, failed", t->path,
                     t->line);
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

/* What plan/ladder.h and the comparison run by run stand on. */
static int check(const struct table *t)
{
    const struct dem_cost *const c = t->cost;

    DEM_REQUIRE(c->window > 0.0 && c->ladders > 0, DEM_ERROR_INPUT, "%s: no window or no ladder", t->path);
    for (int n = 0; n < c->ladders; n++)
    {
        const struct dem_cost_ladder *const l = &c->ladder[n];

        DEM_REQUIRE(l->base >= 0 && l->rung[l->base].runs > 0, DEM_ERROR_INPUT, "%s: ladder %s lacks the case as it is%s%s", t->path, l->knob,
                    l->base >= 0 ? ", which failed: " : "", l->base >= 0 ? l->rung[l->base].failed : "");
        for (int k = 0; k < l->rungs && l->paired; k++)
        {
            DEM_REQUIRE(l->base == l->rungs - 1 && (l->rung[k].runs == 0 || l->rung[k].runs == l->rung[l->base].runs), DEM_ERROR_INPUT, "%s: ladder "
                        "%s is compared run by run; give the case as it is last, and as many runs in all rungs", t->path, l->knob);
        }
    }
    return DEM_OK;
}

int dem_cost_judge_table(struct dem_cost *c, int argc, char **argv)
{
    struct table t = {.path = argc > 1 ? argv[1] : NULL, .cost = c};

    DEM_REQUIRE(argc == 3, DEM_ERROR_INPUT, "dem cost -judge takes a table and a folder; dem cost -help tells how");
    FILE *const f = fopen(t.path, "r");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't read %s: %s", t.path, strerror(errno));
    c->noun = "case";
    c->limit = INFINITY;
    c->target = 0.01;
    int status = read_lines(&t, f);

    fclose(f);
    status = status ? status : check(&t);
    DEM_TRY(status);
    for (int n = 0; n < c->ladders; n++)
    {
        memcpy(c->ladder[n].told, c->wanted, sizeof c->ladder[n].told);
    }
    snprintf(c->folder, sizeof c->folder, "%s", argv[2]);
    DEM_REQUIRE(mkdir(c->folder, 0777) == 0 || errno == EEXIST, DEM_ERROR_FILE, "can't make the folder %s: %s", c->folder, strerror(errno));
    dem_cost_judge(c);
    dem_cost_tell(c);
    return dem_cost_write(c);
}
