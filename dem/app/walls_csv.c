/*
 * walls_csv.c -- write the rows of walls.csv: mean and present forces and torques on walls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/walls_csv.h"
#include "core/error.h"
#include "core/memory.h"
#include "app/csv_rows.h"
#include <stdio.h>

static const char head[] = "time[s],wall,fx[N],fy[N],fz[N],tx[Nm],ty[Nm],tz[Nm],fx_now[N],fy_now[N]"
                           ",fz_now[N],tx_now[Nm],ty_now[Nm],"
                           "tz_now[Nm]";

int dem_wall_log_begin(struct dem_wall_log *log, const struct dem_program *prog,
                       const struct dem_output *o, struct dem *d)
{
    *log = (struct dem_wall_log){.output = o, .interval = o->walls, .since = o->start};
    snprintf(log->path, sizeof log->path, "%s/walls.csv", o->folder);
    if (log->interval <= 0.0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_wall_impulse_reset(d));
    return dem_program_agree(prog,
                             prog->rank == 0 ? dem_csv_begin(log->path, 0, o, d) : DEM_OK);
}

static int write_rows(const struct dem_wall_log *log, const struct dem *d, double now,
                      double (*value)[12])
{
    FILE *f;

    DEM_TRY(dem_csv_open(&f, log->path, log->output, d, head));
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        fprintf(f, "%.10g,%s", now, dem_wall_name(d, w));
        for (int k = 0; k < 12; k++)
        {
            fprintf(f, ",%.9g", value[w][k]);
        }
        fprintf(f, "\n");
    }
    return dem_csv_close(f, log->path);
}

static int measure(const struct dem_wall_log *log, struct dem *d, double now, double (*value)[12])
{
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        DEM_TRY(dem_wall_impulse(d, w, value[w], value[w] + 3));
        DEM_TRY(dem_wall_load(d, w, value[w] + 6, value[w] + 9));
        for (int k = 0; k < 6; k++)
        {
            value[w][k] /= now - log->since;
        }
    }
    return dem_wall_impulse_reset(d);
}

int dem_wall_log_append(struct dem_wall_log *log, const struct dem_program *prog, struct dem *d,
                        double now)
{
    double (*value)[12] = NULL;

    if (!dem_csv_is_due(log->interval, now))
    {
        return DEM_OK;
    }
    int status = dem_program_agree(prog, DEM_NEW(value, dem_wall_count(d) + 1));

    status = status ? status : measure(log, d, now, value);
    log->since = now;
    if (prog->rank == 0 && !status)
    {
        status = dem_output_folder(log->output);
        status = status ? status : write_rows(log, d, now, value);
    }
    dem_memory_free(value);
    return dem_program_agree(prog, status);
}
