/*
 * run_tables.c -- tables of `dem run`, and their lines in the log.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/run_tables.h"
#include "core/error.h"
#include <math.h>
#include <stdio.h>

enum
{
    MAX_IDS = 10  /* on a line; all are in the file */
};

double dem_next_due(double interval, double now, double next)
{
    const double due = interval > 0.0 ? (floor(now/interval + 1e-6) + 1.0)*interval : next;

    return due < next*(1.0 - 1e-12) ? due : next;
}

int dem_is_due(double interval, double now)
{
    const double number = interval > 0.0 ? now/interval : 0.5;

    return fabs(number - floor(number + 0.5)) <= 1e-6;
}

/* ---- begin ----------------------------------------------------------------------------------- */

static int begin_all(const struct dem_run_tables *t, const struct dem *d)
{
    struct dem_table effects;

    dem_table_name(&effects, t->lost.folder, "effects.csv", t->lost.start);
    DEM_TRY(dem_table_begin(&effects, d, 0));
    DEM_TRY(dem_table_begin(&t->lost, d, 1));
    DEM_TRY(dem_table_begin(&t->flows, d, 0));
    DEM_TRY(dem_table_begin(&t->residence, d, 0));
    if (dem_has_bonds(d))
    {
        DEM_TRY(dem_table_begin(&t->bonds, d, 0));
    }
    DEM_TRY(t->cell_interval > 0.0 ? dem_table_begin(&t->cell, d, 0) : DEM_OK);
    return t->wall_interval > 0.0 ? dem_table_begin(&t->walls, d, 0) : DEM_OK;
}

int dem_run_tables_begin(struct dem_run_tables *t, const struct dem_program *prog,
                         const struct dem_output *o, struct dem *d)
{
    *t = (struct dem_run_tables){.wall_interval = o->walls, .wall_since = o->start, .cell_interval = o->cell};
    dem_table_name(&t->lost, o->folder, "lost.csv", o->start);
    dem_table_name(&t->bonds, o->folder, "bonds.csv", o->start);
    dem_table_name(&t->flows, o->folder, "flows.csv", o->start);
    dem_table_name(&t->residence, o->folder, "residence.csv", o->start);
    dem_table_name(&t->cell, o->folder, "cell.csv", o->start);
    dem_table_name(&t->walls, o->folder, "walls.csv", o->start);
    DEM_TRY(dem_flow_sums_set(&t->sums, d, o->start));
    if (o->walls > 0.0)
    {
        DEM_TRY(dem_wall_impulse_reset(d));
    }
    return dem_program_agree(prog, prog->rank == 0 ? begin_all(t, d) : DEM_OK);
}

/* ---- lost particles, broken bonds ------------------------------------------------------------ */

static void print_ids(int64_t n, const struct dem_loss *loss, int removed)
{
    int printed = 0;

    for (int64_t k = 0; k < n && printed <= MAX_IDS; k++)
    {
        if (loss[k].removed == removed && printed++ < MAX_IDS)
        {
            printf(" %lld", (long long)loss[k].id);
        }
    }
    printf(printed > MAX_IDS ? " ..." : "");
}

static void print_lost(struct dem_run_tables *t, int64_t n, const struct dem_loss *loss)
{
    int64_t removed = 0;

    for (int64_t k = 0; k < n; k++)
    {
        removed += loss[k].removed;
    }
    t->removed += removed;
    if (removed > 0)
    {
        printf("lost: %lld particle%s left the domain, %lld in this run, ids", (long long)removed,
               removed > 1 ? "s" : "", (long long)t->removed);
        print_ids(n, loss, 1);
        printf("\n");
    }
    if (removed < n)
    {
        printf("lost: %lld passage%s through walls, ids", (long long)(n - removed),
               n - removed > 1 ? "s" : "");
        print_ids(n, loss, 0);
        printf("\n");
    }
    printf("lost: where and why is in %s\n", t->lost.path);
    fflush(stdout);
}

int dem_run_tables_losses(struct dem_run_tables *t, const struct dem_program *prog, struct dem *d)
{
    const struct dem_loss *loss;
    const struct dem_broken_bond *broke = NULL;
    int64_t n, bonds = 0;
    int status = DEM_OK;

    DEM_TRY(dem_lost(d, &n, &loss));
    if (n > 0 && prog->rank == 0)
    {
        status = dem_table_add_losses(&t->lost, d, n, loss, 0.0, NULL);
        print_lost(t, n, loss);
    }
    DEM_TRY(dem_program_agree(prog, status));
    if (dem_has_bonds(d))
    {
        DEM_TRY(dem_broken_bonds(d, &bonds, &broke));
    }
    return dem_program_agree(prog, bonds > 0 && prog->rank == 0
                                       ? dem_table_add_bonds(&t->bonds, d, bonds, broke, 0.0)
                                       : DEM_OK);
}

/* ---- streams and outlets --------------------------------------------------------------------- */

static void print_sums(int n, const struct dem_flow *flow)
{
    int64_t in = 0, out = 0, waiting = 0;

    for (int k = 0; k < n; k++)
    {
        in += flow[k].enters == DEM_FLOW_WAY_IN ? flow[k].particles : 0;
        out += flow[k].enters == DEM_FLOW_WAY_OUT ? flow[k].particles : 0;
        waiting += flow[k].waiting;
    }
    printf("        %lld inserted, %lld removed, %lld wait for free space\n", (long long)in,
           (long long)out, (long long)waiting);
    fflush(stdout);
}

int dem_run_tables_flows(struct dem_run_tables *t, const struct dem_program *prog, struct dem *d,
                         double now)
{
    const struct dem_flow *flow;
    int n;

    DEM_TRY(dem_flows(d, &n, &flow));
    if (n == 0)
    {
        return DEM_OK;
    }
    if (prog->rank == 0)
    {
        print_sums(n, flow);
    }
    DEM_TRY(dem_program_agree(prog, prog->rank == 0 ? dem_table_add_residence(&t->residence, d, now)
                                                    : DEM_OK));
    return dem_program_agree(
        prog, dem_table_add_flows(prog->rank == 0 ? &t->flows : NULL, d, now, &t->sums));
}

void dem_run_tables_print_flows(const struct dem_program *prog, struct dem *d)
{
    static const char *const way[] = {"out", "in", "forth", "back"};
    const struct dem_flow *flow;
    int n;

    if (prog->rank > 0 || dem_flows(d, &n, &flow))
    {
        return;
    }
    for (int k = 0; k < n; k++)
    {
        printf("flow: %s %s %lld particles, %.6g kg, momentum (%.4g %.4g %.4g) kg m/s",
               flow[k].name, way[flow[k].enters], (long long)flow[k].particles,
               flow[k].mass, flow[k].momentum[0], flow[k].momentum[1], flow[k].momentum[2]);
        if (flow[k].waiting > 0)
        {
            printf("; %lld wait for free space", (long long)flow[k].waiting);
        }
        printf("\n");
    }
}

/* ---- walls ----------------------------------------------------------------------------------- */

int dem_run_tables_walls(struct dem_run_tables *t, const struct dem_program *prog, struct dem *d,
                         double now)
{
    if (dem_is_due(t->cell_interval, now))
    {
        DEM_TRY(dem_program_agree(prog,
                                  dem_table_add_cell(prog->rank == 0 ? &t->cell : NULL, d, now)));
    }
    if (!dem_is_due(t->wall_interval, now))
    {
        return DEM_OK;
    }
    const double elapsed = now - t->wall_since;

    t->wall_since = now;
    return dem_program_agree(
        prog, dem_table_add_walls(prog->rank == 0 ? &t->walls : NULL, d, now, elapsed));
}
