/*
 * main_bonds.c -- a line from partner to partner for each bond, and a row for each that broke.
 *
 * A line goes from the particle of the lower id to where its partner is from there: through a periodic face it leaves the box.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_bonds.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/file.h"
#include "io/vtk.h"
#include "main_rows.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- those that broke ---------------------------------------------------------------------------------------- */

int dem_bond_rows_begin(const struct dem_program *prog, const struct dem *d, const char *folder, double start)
{
    char path[640];

    snprintf(path, sizeof path, "%s/bonds.csv", folder);
    return dem_program_together(prog, prog->rank == 0 && dem_has_bonds(d) ? dem_rows_begin(path, 0, start) : DEM_OK);
}

static int append(const char *path, int64_t n, const struct dem_break *b)
{
    static const char *const causes[] = {"unknown", "tension", "shear", "distance"};
    const int new = !dem_file_exists(path);
    FILE *const f = fopen(path, "a");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't write %s: %s", path, strerror(errno));
    if (new)
    {
        fprintf(f, "time,id1,id2,x,y,z,cause,energy\n");
    }
    for (int64_t k = 0; k < n; k++)
    {
        const double *const x = b[k].position;

        fprintf(f, "%.10g,%lld,%lld,%.9g,%.9g,%.9g,%s,%.9g\n", b[k].time, (long long)b[k].id[0], (long long)b[k].id[1], x[0], x[1], x[2],
                causes[b[k].cause], b[k].energy);
    }
    const int bad = ferror(f) != 0;

    DEM_REQUIRE(fclose(f) == 0 && !bad, DEM_ERROR_FILE, "can't write all of %s: %s", path, strerror(errno));
    return DEM_OK;
}

int dem_bond_rows_tell(const struct dem_program *prog, struct dem *d, const struct dem_output *o)
{
    const struct dem_break *broke;
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
        status = status ? status : append(path, n, broke);
    }
    return dem_program_together(prog, status);
}

/* ---- those that hold ----------------------------------------------------------------------------------------- */

struct line                                               /* as it is written */
{
    double ends[6], force[3], moment[3], tension, shear, stored;
    int64_t id[2];
};

static struct line drawn(const struct dem_bond *b)
{
    struct line l = {.stored = b->stored, .id = {b->id[0], b->id[1]}};
    double r = 0.0, along = 0.0, all = 0.0;

    for (int k = 0; k < 3; k++)
    {
        l.ends[k] = b->position[k];
        l.ends[3 + k] = b->position[k] - b->branch[k];
        r += b->branch[k]*b->branch[k];
        along += b->force[k]*b->branch[k];
        all += b->force[k]*b->force[k];
    }
    memcpy(l.force, b->force, sizeof l.force);
    memcpy(l.moment, b->moment, sizeof l.moment);
    l.tension = r > 0.0 ? -along/sqrt(r) : 0.0;
    l.shear = sqrt(fmax(all - l.tension*l.tension, 0.0));
    return l;
}

static int by_ids(const void *a, const void *b)
{
    const struct line *const p = a, *const q = b;
    const int first = (p->id[0] > q->id[0]) - (p->id[0] < q->id[0]), second = (p->id[1] > q->id[1]) - (p->id[1] < q->id[1]);
    const int place = (p->ends[3] > q->ends[3]) - (p->ends[3] < q->ends[3]);

    return first ? first : second ? second : place;
}

/* All on the first rank. */
static int gather(const struct dem_program *prog, struct line **all, int64_t *n)
{
    struct line *const mine = *all;
    int *count, *start, total = 0;
    const int here = (int)*n;
    MPI_Datatype one;

    DEM_TRY(DEM_NEW(count, prog->ranks));
    DEM_TRY(DEM_NEW(start, prog->ranks));
    MPI_Gather(&here, 1, MPI_INT, count, 1, MPI_INT, 0, prog->comm);
    for (int k = 0; k < prog->ranks && prog->rank == 0; k++)
    {
        start[k] = total;
        total += count[k];
    }
    DEM_TRY(DEM_NEW(*all, total + 1));
    MPI_Type_contiguous((int)sizeof *mine, MPI_BYTE, &one);
    MPI_Type_commit(&one);
    MPI_Gatherv(mine, here, one, *all, count, start, one, 0, prog->comm);
    MPI_Type_free(&one);
    *n = total;
    dem_memory_free(mine);
    dem_memory_free(count);
    dem_memory_free(start);
    return DEM_OK;
}

static int write_lines(const char *folder, struct line *l, int64_t n, int64_t number, double time)
{
    const size_t stride = sizeof *l;
    const struct dem_vtk_column columns[] =
    {
        {"points", l->ends, stride, DEM_VTK_DOUBLE, 6},
        {"id", l->id, stride, DEM_VTK_INT64, 2},
        {"force", l->force, stride, DEM_VTK_NARROW, 3},
        {"moment", l->moment, stride, DEM_VTK_NARROW, 3},
        {"tension", &l->tension, stride, DEM_VTK_NARROW, 1},
        {"shear", &l->shear, stride, DEM_VTK_NARROW, 1},
        {"stored", &l->stored, stride, DEM_VTK_NARROW, 1},
    };
    char file[64], path[720];

    qsort(l, (size_t)n, sizeof *l, by_ids);
    snprintf(file, sizeof file, "bonds_%06lld.vtp", (long long)number);
    snprintf(path, sizeof path, "%s/%s", folder, file);
    DEM_TRY(dem_vtk_write_lines(path, n, columns, (int)(sizeof columns/sizeof columns[0])));
    snprintf(path, sizeof path, "%s/bonds.pvd", folder);
    return dem_vtk_collection_add(path, time, file);
}

int dem_bond_picture(const struct dem_program *prog, struct dem *d, const char *folder, int64_t number, double time)
{
    const struct dem_bond *bond;
    struct line *lines;
    int64_t n;

    if (!dem_has_bonds(d))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_bonds(d, &n, &bond));
    DEM_TRY(DEM_NEW(lines, n + 1));
    for (int64_t k = 0; k < n; k++)
    {
        lines[k] = drawn(&bond[k]);
    }
    if (prog->comm != MPI_COMM_NULL)
    {
        DEM_TRY(gather(prog, &lines, &n));
    }
    const int status = prog->rank == 0 ? write_lines(folder, lines, n, number, time) : DEM_OK;

    dem_memory_free(lines);
    return status;
}
