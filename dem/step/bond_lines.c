/*
 * bond_lines.c -- a line from partner to partner for each bond that holds.
 *
 * A line goes from the particle of the lower id to where its partner is from there: through a periodic face it leaves the box.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/bonds.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "io/vtk.h"
#include "step/parts.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* Collective: each rank its own, by ids. */
static int write_lines(const struct dem_writers *by, const char *folder, const char *file, struct line *l, int64_t n)
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
    char path[1200];

    dem_sort_by(l, (size_t)n, sizeof *l, by_ids);
    DEM_REQUIRE(strlen(folder) + strlen(file) + 16 < sizeof path, DEM_ERROR_INPUT, "path %s/%s is longer than %zu letters", folder, file,
                sizeof path - 17);
    snprintf(path, sizeof path, "%s/%s", folder, file);
    return dem_vtk_write_lines(by, path, n, columns, (int)(sizeof columns/sizeof columns[0]));
}

int dem_bonds_lines(struct dem_parts *p, const char *says, const char *folder, const char *file, double time)
{
    const struct dem_pieces *const q = &p->pieces;
    const struct dem_writers by = {.comm = q->ranks > 1 ? q->comm : MPI_COMM_NULL, .rank = q->rank, .says = says};
    struct line *lines;
    char path[1200];
    int64_t n = 0;

    if (p->stale == 2 && p->steps > 0)
    {
        return DEM_OK;
    }
    if (p->stale < 2)
    {
        DEM_TRY(dem_bonds_list(p, &n));
    }
    DEM_TRY(DEM_NEW(lines, n + 1));
    for (int64_t k = 0; k < n; k++)
    {
        lines[k] = drawn(&p->bonds.hold[k]);
    }
    const int status = write_lines(&by, folder, file, lines, n);

    dem_memory_free(lines);
    if (status || q->rank > 0)
    {
        return status;
    }
    snprintf(path, sizeof path, "%s/bonds.pvd", folder);
    return dem_vtk_collection_add(path, time, file);
}
