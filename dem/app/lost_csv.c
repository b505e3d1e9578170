/*
 * lost_csv.c -- write a row of lost.csv for each lost particle, and print their ids.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/lost_csv.h"
#include "core/error.h"
#include "app/csv_rows.h"
#include <stdio.h>

enum
{
    MAX_IDS = 10  /* on a line; all are in the file */
};

/* ---- file ------------------------------------------------------------------------------------ */

static int append(const struct dem_lost_log *log, const struct dem *d, int64_t n,
                  const struct dem_loss *loss)
{
    FILE *f;

    DEM_TRY(dem_csv_open(&f, log->path, log->output, d,
                         "id,time,x,y,z,vx,vy,vz,diameter,cause"));
    for (int64_t k = 0; k < n; k++)
    {
        const double *const x = loss[k].position, *const v = loss[k].velocity;

        fprintf(f, "%lld,%.10g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,\"%s\"\n", (long long)loss[k].id,
                loss[k].time, x[0], x[1], x[2], v[0], v[1], v[2], loss[k].diameter, loss[k].cause);
    }
    return dem_csv_close(f, log->path);
}

/* ---- log ------------------------------------------------------------------------------------- */

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

static void print(struct dem_lost_log *log, int64_t n, const struct dem_loss *loss)
{
    int64_t removed = 0;

    for (int64_t k = 0; k < n; k++)
    {
        removed += loss[k].removed;
    }
    log->removed += removed;
    if (removed > 0)
    {
        printf("lost: %lld particle%s left the domain, %lld in this run, ids", (long long)removed,
               removed > 1 ? "s" : "", (long long)log->removed);
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
    printf("lost: where and why is in %s\n", log->path);
    fflush(stdout);
}

/* ---- public ---------------------------------------------------------------------------------- */

int dem_lost_log_begin(struct dem_lost_log *log, const struct dem_program *prog,
                       const struct dem_output *o, const struct dem *d)
{
    *log = (struct dem_lost_log){.output = o};
    snprintf(log->path, sizeof log->path, "%s/lost.csv", o->folder);
    return dem_program_agree(prog,
                             prog->rank == 0 ? dem_csv_begin(log->path, 1, o, d) : DEM_OK);
}

int dem_lost_log_append(struct dem_lost_log *log, const struct dem_program *prog, struct dem *d)
{
    const struct dem_loss *loss;
    int64_t n;
    int status = DEM_OK;

    DEM_TRY(dem_lost(d, &n, &loss));
    if (n == 0)
    {
        return DEM_OK;
    }
    if (prog->rank == 0)
    {
        status = dem_output_folder(log->output);
        status = status ? status : append(log, d, n, loss);
        print(log, n, loss);
    }
    return dem_program_agree(prog, status);
}
