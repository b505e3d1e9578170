/*
 * bonds_csv.c -- write bonds.csv, a row for each bond that broke, and the VTK files of the intact
 * bonds.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/bonds_csv.h"
#include "core/error.h"
#include "app/csv_rows.h"
#include <stdio.h>

/* ---- broken bonds ---------------------------------------------------------------------------- */

int dem_bond_rows_begin(const struct dem_program *prog, const struct dem *d,
                        const struct dem_output *o)
{
    char path[640];

    snprintf(path, sizeof path, "%s/bonds.csv", o->folder);
    return dem_program_agree(prog, prog->rank == 0 && dem_has_bonds(d)
                                       ? dem_csv_begin(path, 0, o, d)
                                       : DEM_OK);
}

static int append(const char *path, const struct dem_output *o, const struct dem *d, int64_t n,
                  const struct dem_broken_bond *b)
{
    FILE *f;

    DEM_TRY(dem_csv_open(&f, path, o, d, "time,id1,id2,x,y,z,cause,energy"));
    for (int64_t k = 0; k < n; k++)
    {
        const double *const x = b[k].position;

        fprintf(f, "%.10g,%lld,%lld,%.9g,%.9g,%.9g,%s,%.9g\n", b[k].time, (long long)b[k].id[0],
                (long long)b[k].id[1], x[0], x[1], x[2], dem_broken_bond_cause(b[k].cause),
                b[k].energy);
    }
    return dem_csv_close(f, path);
}

int dem_bond_rows_append(const struct dem_program *prog, struct dem *d, const struct dem_output *o)
{
    const struct dem_broken_bond *broke;
    char path[640];
    int64_t n = 0;
    int status = DEM_OK;

    if (dem_has_bonds(d))
    {
        DEM_TRY(dem_broken_bonds(d, &n, &broke));
    }
    if (n == 0)
    {
        return DEM_OK;
    }
    if (prog->rank == 0)
    {
        snprintf(path, sizeof path, "%s/bonds.csv", o->folder);
        status = dem_output_folder(o);
        status = status ? status : append(path, o, d, n, broke);
    }
    return dem_program_agree(prog, status);
}

/* ---- intact bonds ---------------------------------------------------------------------------- */

int dem_bonds_write_vtk(struct dem *d, const char *folder, int64_t number, double time)
{
    char file[64];

    if (!dem_has_bonds(d))
    {
        return DEM_OK;
    }
    snprintf(file, sizeof file, "bonds_%06lld.vtp", (long long)number);
    return dem_bonds_draw(d, folder, file, time);
}
