/*
 * main_cost_tell.c -- the tables on the terminal, cost.csv, and the picture that a script beside the program draws of it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* readlink */
#include "main_cost.h"
#include "plan/text.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum
{
    CELL = 15                                             /* letters of a column */
};

/* ---- tables ---------------------------------------------------------------------------------------------------- */

static void tell_error(const struct dem_cost_ladder *l, const struct dem_cost_rung *r, int q)
{
    char text[48];

    if (r->runs == 0)
    {
        snprintf(text, sizeof text, "fails");
    }
    else if (!isfinite(r->error[q]))
    {
        snprintf(text, sizeof text, "-");
    }
    else if (l->judged[q].kind == DEM_LADDER_STATISTICS && r->unsure[q] > 0.0)
    {
        snprintf(text, sizeof text, "%.2g +-%.2g %%", 100.0*r->error[q], 100.0*r->unsure[q]);
    }
    else
    {
        const int below = r->error[q] < r->unsure[q];

        snprintf(text, sizeof text, "%s%.2g %%", below ? "<" : "", 100.0*(below ? r->unsure[q] : r->error[q]));
    }
    printf(" %*s", CELL, text);
}

/* Letters of the names of rungs. */
static int wide(const struct dem_cost_ladder *l)
{
    int most = 7;

    for (int k = 0; k < l->rungs; k++)
    {
        const int own = (int)strlen(l->rung[k].name) + (k == l->base ? 1 : 0);

        most = own > most ? own : most;
    }
    return most;
}

static void tell_head(const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    printf("%s: %s\n    %-*s    %-12s %-11s %6s", l->knob, l->says, wide(l), l->paired && l->base > 1 ? "" : "rung", "step", "processor", "times");
    for (int q = 0; q < c->quantities; q++)
    {
        if (l->told[q])
        {
            printf(" %*s", CELL, c->quantity[q].name);
        }
    }
    printf("\n");
}

static void tell_rungs(const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    for (int k = 0; k < l->rungs; k++)
    {
        const struct dem_cost_rung *const r = &l->rung[k];
        const double times = l->base >= 0 ? r->seconds/l->rung[l->base].seconds : NAN;
        char text[24];

        snprintf(text, sizeof text, "%.3g", times);
        printf("    %-*s%s %s %.4g s%*s %-11s %6s", wide(l), r->name, k == l->base ? "*" : " ", r->front ? "o" : " ", r->step,
               (int)(10 - snprintf(NULL, 0, "%.4g", r->step)), "", r->runs > 0 ? dem_text_time(r->seconds) : "-", isfinite(times) ? text : "-");
        for (int q = 0; q < c->quantities; q++)
        {
            if (l->told[q])
            {
                tell_error(l, r, q);
            }
        }
        printf("\n");
        if (r->runs == 0)
        {
            printf("%15s %s\n", "", r->failed);
        }
    }
}

/* Where the errors are counted from. */
static void tell_references(const struct dem_cost *c, const struct dem_cost_ladder *l)
{
    for (int q = 0; q < c->quantities && !l->paired; q++)
    {
        const struct dem_ladder *const j = &l->judged[q];

        if (!l->told[q])
        {
            continue;
        }
        const char *const unit = c->quantity[q].unit;

        printf("    %-12s %.6g%s%s, %s", c->quantity[q].name, j->reference, strcmp(unit, "1") ? " " : "", strcmp(unit, "1") ? unit : "",
               dem_ladder_kind_name(j->kind));
        if (j->kind != DEM_LADDER_CLOSED)
        {
            printf(", unsure by %.2g %%", 100.0*j->unsure/c->scale[q]);
        }
        if (isfinite(j->order))
        {
            printf(", observed order %.3g +- %.1g", j->order, j->order_unsure);
        }
        printf("\n");
    }
}

static void tell_what(const struct dem_cost *c)
{
    if (!c->request.scene)
    {
        printf("%s\n", c->title);
        return;
    }
    printf("cost of %s: a window of %.4g s from %.4g s on, of %.4g s to time/end; %.0f steps of %.4g s; %d runs a rung, %d look%s\n",
           c->request.scene, c->window, c->start, c->end - c->start, c->window/c->step, c->step, c->runs, c->looks, c->looks > 1 ? "s" : "");
}

void dem_cost_tell(const struct dem_cost *c)
{
    char buy[1024];

    tell_what(c);
    printf("* the %s as it is; o no other rung is both cheaper and better; times: of processor time of *; heights in mean diameters\n", c->noun);
    for (int n = 0; n < c->ladders; n++)
    {
        tell_head(c, &c->ladder[n]);
        tell_rungs(c, &c->ladder[n]);
        tell_references(c, &c->ladder[n]);
    }
    dem_cost_buy(c, buy, sizeof buy);
    printf("best buy: %s\n", buy);
    fflush(stdout);
}

/* ---- cost.csv -------------------------------------------------------------------------------------------------- */

static const char head[] = "ladder,rung,base,size,step[s],processor[s],spread,runs,quantity,unit,mean,scatter,reference,reference_unsure,kind,"
                           "scale,error,error_unsure,order,order_unsure,worst,front";

/* Rungs of the judged ladder are those that have the quantity: found by their size. */
static const struct dem_ladder_rung *find(const struct dem_ladder *j, const struct dem_cost_rung *r)
{
    for (int k = 0; k < j->rungs; k++)
    {
        if (j->rung[k].size == r->size)
        {
            return &j->rung[k];
        }
    }
    return NULL;
}

static void write_row(FILE *f, const struct dem_cost *c, const struct dem_cost_ladder *l, int k, int q)
{
    const struct dem_cost_rung *const r = &l->rung[k];
    const struct dem_ladder *const j = &l->judged[q];
    const struct dem_ladder_rung *const own = find(j, r);

    if (!own)
    {
        return;
    }
    fprintf(f, "%s,%s,%d,%.9g,%.9g,%.6g,%.4g,%d,%s,%s,%.12g,%.6g,%.12g,%.6g,%s,%.9g,%.6g,%.6g,%.4g,%.4g,%d,%d\n", l->knob, r->name, k == l->base,
            r->size, r->step, r->seconds, r->spread, r->runs, c->quantity[q].name, c->quantity[q].unit, own->mean, own->scatter, j->reference,
            j->unsure, l->paired ? "compared" : dem_ladder_kind_name(j->kind), c->scale[q], r->error[q], r->unsure[q], j->order, j->order_unsure,
            r->worst == q, r->front);
}

static int write_table(const struct dem_cost *c)
{
    char path[600];
    FILE *f;

    snprintf(path, sizeof path, "%s/cost.csv", c->folder);
    f = fopen(path, "w");
    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't write %s: %s", path, strerror(errno));
    fprintf(f, "%s\n", head);
    for (int n = 0; n < c->ladders; n++)
    {
        for (int k = 0; k < c->ladder[n].rungs; k++)
        {
            for (int q = 0; q < c->quantities; q++)
            {
                if (c->ladder[n].told[q] && c->ladder[n].rung[k].runs > 0)
                {
                    write_row(f, c, &c->ladder[n], k, q);
                }
            }
        }
    }
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE, "can't write all of %s: %s", path, strerror(errno));
    return DEM_OK;
}

/* ---- the picture ----------------------------------------------------------------------------------------------- */

/* The script lies beside the program, or beside the sources it was built from. Without it, or Python, or matplotlib: no picture,
   and a line that says so. */
static void draw(const struct dem_cost *c)
{
    char own[512], command[1400];
    const ssize_t n = readlink("/proc/self/exe", own, sizeof own - 1);
    const char *const python = getenv("SUNA_PYTHON");

    own[n > 0 ? n : 0] = '\0';
    char *const slash = strrchr(own, '/');

    snprintf(slash ? slash : own, 2, "%s", "");
    snprintf(command, sizeof command, "%s '%s/dem-plot' '%s/cost.csv' > /dev/null 2>&1", python && python[0] ? python : "python3", own, c->folder);
    fflush(stdout);
    if (strchr(own, '\'') || strchr(c->folder, '\'') || system(command) != 0)
    {
        printf("no picture: that takes python3 with matplotlib (or SUNA_PYTHON that names one), and dem-plot beside the program\n");
        return;
    }
    printf("and in cost.png, cost.svg beside it\n");
}

int dem_cost_write(const struct dem_cost *c)
{
    DEM_TRY(write_table(c));
    printf("all of it in %s/cost.csv\n", c->folder);
    draw(c);
    return DEM_OK;
}
