/*
 * flows_csv.c -- write the rows of flows.csv and print the totals of streams and outlets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/flows_csv.h"
#include "core/error.h"
#include "app/csv_rows.h"
#include <stdio.h>

static const char head[] = "time[s],name,way,particles,mass[kg],px[Ns],py[Ns],pz[Ns],energy[J],"
                           "waiting,rate[1/s],massRate[kg/s]";

static const char *direction(const struct dem_flow *f)
{
    return f->enters ? "in" : "out";
}

static int write_rows(const struct dem_flow_log *log, const struct dem *d, int n,
                      const struct dem_flow *flow, double now)
{
    const double over = now > log->since ? 1.0/(now - log->since) : 0.0;
    FILE *f;

    DEM_TRY(dem_csv_open(&f, log->path, log->output, d, head));
    for (int k = 0; k < n; k++)
    {
        const struct dem_flow *const w = &flow[k];

        fprintf(f, "%.10g,%s,%s,%lld,%.9g,%.9g,%.9g,%.9g,%.9g,%lld,%.9g,%.9g\n", now, w->name,
                direction(w), (long long)w->particles, w->mass,
                w->momentum[0], w->momentum[1], w->momentum[2], w->energy, (long long)w->waiting,
                over*((double)w->particles - log->particles[k]), over*(w->mass - log->mass[k]));
    }
    return dem_csv_close(f, log->path);
}

static void print(int n, const struct dem_flow *flow)
{
    int64_t in = 0, out = 0, waiting = 0;

    for (int k = 0; k < n; k++)
    {
        *(flow[k].enters ? &in : &out) += flow[k].particles;
        waiting += flow[k].waiting;
    }
    printf("        %lld inserted, %lld removed, %lld wait for free space\n", (long long)in,
           (long long)out, (long long)waiting);
    fflush(stdout);
}

static void remember(struct dem_flow_log *log, int n, const struct dem_flow *flow, double now)
{
    log->since = now;
    for (int k = 0; k < n; k++)
    {
        log->particles[k] = (double)flow[k].particles;
        log->mass[k] = flow[k].mass;
    }
}

int dem_flow_log_begin(struct dem_flow_log *log, const struct dem_program *prog,
                       const struct dem_output *o, struct dem *d)
{
    const struct dem_flow *flow;
    int n;

    *log = (struct dem_flow_log){.output = o};
    snprintf(log->path, sizeof log->path, "%s/flows.csv", o->folder);
    DEM_TRY(dem_flows(d, &n, &flow));
    remember(log, n, flow, o->start);
    return dem_program_agree(prog,
                             prog->rank == 0 ? dem_csv_begin(log->path, 0, o, d) : DEM_OK);
}

int dem_flow_log_append(struct dem_flow_log *log, const struct dem_program *prog, struct dem *d,
                        double now)
{
    const struct dem_flow *flow;
    int n, status = DEM_OK;

    DEM_TRY(dem_flows(d, &n, &flow));
    if (n == 0)
    {
        return DEM_OK;
    }
    if (prog->rank == 0)
    {
        print(n, flow);
        status = dem_output_folder(log->output);
        status = status ? status : write_rows(log, d, n, flow, now);
    }
    remember(log, n, flow, now);
    return dem_program_agree(prog, status);
}

void dem_flow_log_print(const struct dem_program *prog, struct dem *d)
{
    const struct dem_flow *flow;
    int n;

    if (prog->rank > 0 || dem_flows(d, &n, &flow))
    {
        return;
    }
    for (int k = 0; k < n; k++)
    {
        printf("flow: %s %s %lld particles, %.6g kg, momentum (%.4g %.4g %.4g) kg m/s",
               flow[k].name, direction(&flow[k]), (long long)flow[k].particles, flow[k].mass,
               flow[k].momentum[0], flow[k].momentum[1], flow[k].momentum[2]);
        if (flow[k].waiting > 0)
        {
            printf("; %lld wait for free space", (long long)flow[k].waiting);
        }
        printf("\n");
    }
}
