/*
 * main_energy.c -- rows of energy.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_energy.h"
#include "base/error.h"
#include "io/file.h"
#include "main_rows.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

int dem_energy_log_begin(struct dem_energy_log *log, const struct dem_program *prog, const struct dem_output *o, double start)
{
    *log = (struct dem_energy_log){.output = o, .interval = o->energy, .when = start};
    snprintf(log->path, sizeof log->path, "%s/energy.csv", o->folder);
    if (log->interval <= 0.0)
    {
        return DEM_OK;
    }
    return dem_program_together(prog, prog->rank == 0 ? dem_rows_begin(log->path, 0, start) : DEM_OK);
}

struct row
{
    double now, since;
    int n;
    const struct dem_energy_item *item;
};

static int write_row(const struct dem_energy_log *log, const struct row *r)
{
    const int new = !dem_file_exists(log->path);
    FILE *const f = fopen(log->path, "a");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't write %s: %s", log->path, strerror(errno));
    if (new)
    {
        fprintf(f, "time[s],since[s]");
        for (int k = 0; k < r->n; k++)
        {
            fprintf(f, ",%s[J]", r->item[k].name);
        }
        fprintf(f, "\n");
    }
    fprintf(f, "%.10g,%.10g", r->now, r->since);
    for (int k = 0; k < r->n; k++)
    {
        fprintf(f, ",%.12g", r->item[k].value + 0.0);            /* no minus zero */
    }
    fprintf(f, "\n");
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE, "can't write all of %s: %s", log->path, strerror(errno));
    return DEM_OK;
}

/* The last two terms are the total and the residual. */
static void note(struct dem_energy_log *log, const struct row *r)
{
    const double residual = r->item[r->n - 1].value;

    for (int k = 0; k < r->n - 2; k++)
    {
        log->largest = fmax(log->largest, fabs(r->item[k].value));
    }
    if (fabs(residual) > fabs(log->residual))
    {
        log->residual = residual;
        log->when = r->now;
    }
}

int dem_energy_log_tell(struct dem_energy_log *log, const struct dem_program *prog, struct dem *d, double now)
{
    struct row r = {.now = now};
    int status = DEM_OK;

    if (!dem_rows_are_due(log->interval, now))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_energy(d, &r.since, &r.n, &r.item));
    note(log, &r);
    if (prog->rank == 0)
    {
        status = dem_output_folder(log->output);
        status = status ? status : write_row(log, &r);
    }
    return dem_program_together(prog, status);
}

void dem_energy_log_end(const struct dem_energy_log *log, const struct dem_program *prog)
{
    if (log->interval > 0.0 && prog->rank == 0)
    {
        printf("energy: largest residual %.3g J at t %.6g s, %.2g %% of the largest term, %.4g J\n", log->residual, log->when,
               log->largest > 0.0 ? 100.0*fabs(log->residual)/log->largest : 0.0, log->largest);
    }
}
