/*
 * cost_report.c -- print the tables, write cost.csv, and draw the picture with the script dem-plot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* readlink */
#include "app/cost.h"
#include "core/text.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum
{
    COLUMN_WIDTH = 15  /* characters */
};

/* ---- tables ---------------------------------------------------------------------------------- */

static void print_error(const struct dem_cost_series *l, const struct dem_cost_level *r, int q)
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
    else if (l->analysis[q].kind == DEM_REFINEMENT_STATISTICS && r->uncertainty[q] > 0.0)
    {
        snprintf(text, sizeof text, "%.2g +-%.2g %%", 100.0*r->error[q], 100.0*r->uncertainty[q]);
    }
    else
    {
        const int below = r->error[q] < r->uncertainty[q];

        snprintf(text, sizeof text, "%s%.2g %%", below ? "<" : "",
                 100.0*(below ? r->uncertainty[q] : r->error[q]));
    }
    printf(" %*s", COLUMN_WIDTH, text);
}

/* Width of the column of level names, in characters. */
static int name_width(const struct dem_cost_series *l)
{
    int max = 7;

    for (int k = 0; k < l->levels; k++)
    {
        const int width = (int)strlen(l->level[k].name) + (k == l->base ? 1 : 0);

        max = width > max ? width : max;
    }
    return max;
}

static void print_head(const struct dem_cost *c, const struct dem_cost_series *l)
{
    printf("%s: %s\n    %-*s    %-12s %-11s %6s", l->parameter, l->description, name_width(l),
           l->paired && l->base > 1 ? "" : "level", "step", "processor", "times");
    for (int q = 0; q < c->quantities; q++)
    {
        if (l->reported[q])
        {
            printf(" %*s", COLUMN_WIDTH, c->quantity[q].name);
        }
    }
    printf("\n");
}

static void print_levels(const struct dem_cost *c, const struct dem_cost_series *l)
{
    for (int k = 0; k < l->levels; k++)
    {
        const struct dem_cost_level *const r = &l->level[k];
        const double times = l->base >= 0 ? r->seconds/l->level[l->base].seconds : NAN;
        char text[24];

        snprintf(text, sizeof text, "%.3g", times);
        printf("    %-*s%s %s %.4g s%*s %-11s %6s", name_width(l), r->name,
               k == l->base ? "*" : " ", r->pareto ? "o" : " ", r->step,
               (int)(10 - snprintf(NULL, 0, "%.4g", r->step)), "",
               r->runs > 0 ? dem_text_time(r->seconds) : "-", isfinite(times) ? text : "-");
        for (int q = 0; q < c->quantities; q++)
        {
            if (l->reported[q])
            {
                print_error(l, r, q);
            }
        }
        printf("\n");
        if (r->runs == 0)
        {
            printf("%15s %s\n", "", r->failed);
        }
    }
}

/* The reference of each quantity: errors are differences from it. */
static void print_references(const struct dem_cost *c, const struct dem_cost_series *l)
{
    for (int q = 0; q < c->quantities && !l->paired; q++)
    {
        const struct dem_refinement_series *const j = &l->analysis[q];

        if (!l->reported[q])
        {
            continue;
        }
        const char *const unit = c->quantity[q].unit;

        printf("    %-12s %.6g%s%s, %s", c->quantity[q].name, j->reference,
               strcmp(unit, "1") ? " " : "", strcmp(unit, "1") ? unit : "",
               dem_refinement_kind_name(j->kind));
        if (j->kind != DEM_REFINEMENT_CLOSED)
        {
            printf(", unsure by %.2g %%", 100.0*j->uncertainty/c->scale[q]);
        }
        if (isfinite(j->order))
        {
            printf(", observed order %.3g +- %.1g", j->order, j->order_uncertainty);
        }
        printf("\n");
    }
}

static void print_title(const struct dem_cost *c)
{
    if (!c->request.scene)
    {
        printf("%s\n", c->title);
        return;
    }
    printf("cost of %s: a window of %.4g s from %.4g s on, of %.4g s to time/end; %.0f steps of "
           "%.4g s; %d runs of each level, %d sample%s\n",
           c->request.scene, c->window, c->start, c->end - c->start, c->window/c->step, c->step,
           c->runs, c->samples, c->samples > 1 ? "s" : "");
}

void dem_cost_report(const struct dem_cost *c)
{
    char best_buy[1024];

    print_title(c);
    printf("* the %s as it is; o no other level is both cheaper and better; times: processor time "
           "over that of *; heights in mean diameters\n",
           c->noun);
    for (int n = 0; n < c->n_series; n++)
    {
        print_head(c, &c->series[n]);
        print_levels(c, &c->series[n]);
        print_references(c, &c->series[n]);
    }
    dem_cost_best_buy(c, best_buy, sizeof best_buy);
    printf("best buy: %s\n", best_buy);
    fflush(stdout);
}

/* ---- cost.csv -------------------------------------------------------------------------------- */

static const char header[] = "ladder,rung,base,size,step[s],processor[s],spread,runs,quantity,unit,"
                             "mean,scatter,reference,reference_unsure,kind,"
                             "scale,error,error_unsure,order,order_unsure,worst,front";

/* The analysis has only the levels that have the quantity: find a level in it by its size. */
static const struct dem_refinement_level *find(const struct dem_refinement_series *j,
                                               const struct dem_cost_level *r)
{
    for (int k = 0; k < j->levels; k++)
    {
        if (j->level[k].size == r->size)
        {
            return &j->level[k];
        }
    }
    return NULL;
}

static void write_row(FILE *f, const struct dem_cost *c, const struct dem_cost_series *l, int k,
                      int q)
{
    const struct dem_cost_level *const r = &l->level[k];
    const struct dem_refinement_series *const j = &l->analysis[q];
    const struct dem_refinement_level *const level = find(j, r);

    if (!level)
    {
        return;
    }
    fprintf(f,
            "%s,%s,%d,%.9g,%.9g,%.6g,%.4g,%d,%s,%s,"
            "%.12g,%.6g,%.12g,%.6g,%s,%.9g,%.6g,%.6g,%.4g,%.4g,%d,%d\n",
            l->parameter, r->name, k == l->base, r->size, r->step, r->seconds, r->spread, r->runs,
            c->quantity[q].name, c->quantity[q].unit, level->mean, level->scatter, j->reference,
            j->uncertainty, l->paired ? "compared" : dem_refinement_kind_name(j->kind), c->scale[q],
            r->error[q], r->uncertainty[q], j->order, j->order_uncertainty, r->worst == q,
            r->pareto);
}

static int write_table(const struct dem_cost *c)
{
    char path[600];
    FILE *f;

    snprintf(path, sizeof path, "%s/cost.csv", c->folder);
    f = fopen(path, "w");
    DEM_REQUIRE(f, DEM_ERROR_FILE, "cannot write %s: %s", path, strerror(errno));
    fprintf(f, "%s\n", header);
    for (int n = 0; n < c->n_series; n++)
    {
        for (int k = 0; k < c->series[n].levels; k++)
        {
            for (int q = 0; q < c->quantities; q++)
            {
                if (c->series[n].reported[q] && c->series[n].level[k].runs > 0)
                {
                    write_row(f, c, &c->series[n], k, q);
                }
            }
        }
    }
    const int failed = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !failed, DEM_ERROR_FILE, "cannot write all of %s: %s", path,
                strerror(errno));
    return DEM_OK;
}

/* ---- the picture ----------------------------------------------------------------------------- */

/* The folder of the program; 0: it cannot be found, or its name is too long. */
static int find_program_folder(char *folder, size_t size)
{
    const ssize_t n = readlink("/proc/self/exe", folder, size);

    if (n <= 0 || (size_t)n >= size)
    {
        return 0;
    }
    folder[n] = '\0';
    char *const slash = strrchr(folder, '/');

    if (!slash)
    {
        return 0;
    }
    *slash = '\0';
    return 1;
}

/* Run the script, which is in the folder of the program. Names go into a shell command in single
   quotes. Returns 0 when there is no picture. */
static int run_script(const struct dem_cost *c)
{
    const char *const python = getenv("SUNA_PYTHON");
    char program[512], command[2048];

    if (!find_program_folder(program, sizeof program) || strchr(program, '\'')
        || strchr(c->folder, '\''))
    {
        return 0;
    }
    const int n =
        snprintf(command, sizeof command, "%s '%s/dem-plot' '%s/cost.csv' > /dev/null 2>&1",
                 python && python[0] ? python : "python3", program, c->folder);

    return n > 0 && (size_t)n < sizeof command && system(command) == 0;
}

/* Without the script, Python or matplotlib there is no picture, and a line reports that. */
static void draw(const struct dem_cost *c)
{
    fflush(stdout);
    if (!run_script(c))
    {
        printf("no picture: it needs python3 with matplotlib (or one that SUNA_PYTHON names), and "
               "dem-plot in the folder of the program\n");
        return;
    }
    printf("picture: cost.png, cost.svg in the same folder\n");
}

int dem_cost_write(const struct dem_cost *c)
{
    DEM_TRY(write_table(c));
    printf("table: %s/cost.csv\n", c->folder);
    draw(c);
    return DEM_OK;
}
