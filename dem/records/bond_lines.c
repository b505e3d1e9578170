/*
 * bond_lines.c -- VTK file of the intact bonds, one line from partner to partner.
 *
 * A line begins at the particle of the lower id and ends where its partner is as seen from there; a
 * bond through a periodic face leaves the box.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/bonds.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "records/vtk.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct line                                               /* one bond as it is written */
{
    double ends[6], force[3], moment[3], tension, shear, stored;
    int64_t id[2];
};

static struct line line_of(const struct dem_bond *b)
{
    struct line l = {.stored = b->stored, .id = {b->id[0], b->id[1]}};
    double r2 = 0.0, along = 0.0, f2 = 0.0;

    for (int k = 0; k < 3; k++)
    {
        l.ends[k] = b->position[k];
        l.ends[3 + k] = b->position[k] - b->branch[k];
        r2 += b->branch[k]*b->branch[k];
        along += b->force[k]*b->branch[k];
        f2 += b->force[k]*b->force[k];
    }
    memcpy(l.force, b->force, sizeof l.force);
    memcpy(l.moment, b->moment, sizeof l.moment);
    l.tension = r2 > 0.0 ? -along/sqrt(r2) : 0.0;
    l.shear = sqrt(fmax(f2 - l.tension*l.tension, 0.0));
    return l;
}

static int by_ids(const void *a, const void *b)
{
    const struct line *const p = a, *const q = b;
    const int first = (p->id[0] > q->id[0]) - (p->id[0] < q->id[0]),
              second = (p->id[1] > q->id[1]) - (p->id[1] < q->id[1]);
    const int position = (p->ends[3] > q->ends[3]) - (p->ends[3] < q->ends[3]);

    return first ? first : second ? second : position;
}

/* Collective. Each rank writes its lines, sorted by ids. */
static int write_lines(const struct dem_file_ranks *by, const char *folder, const char *file,
                       struct line *l, int64_t n)
{
    const size_t stride = sizeof *l;
    const struct dem_vtk_column columns[] =
    {
        {"points", l->ends, stride, DEM_VTK_DOUBLE, 6},
        {"id", l->id, stride, DEM_VTK_INT64, 2},
        {"force", l->force, stride, DEM_VTK_FLOAT32, 3},
        {"moment", l->moment, stride, DEM_VTK_FLOAT32, 3},
        {"tension", &l->tension, stride, DEM_VTK_FLOAT32, 1},
        {"shear", &l->shear, stride, DEM_VTK_FLOAT32, 1},
        {"stored", &l->stored, stride, DEM_VTK_FLOAT32, 1},
    };
    char path[1200];
    const int length = snprintf(path, sizeof path, "%s/%s", folder, file);

    dem_sort_by(l, (size_t)n, sizeof *l, by_ids);
    DEM_REQUIRE(length > 0 && length + 16 < (int)sizeof path, DEM_ERROR_INPUT,
                "path %s/%s is longer than %zu characters", folder, file, sizeof path - 17);
    return dem_vtk_write_lines(by, path, n, columns, (int)(sizeof columns/sizeof columns[0]));
}

int dem_bonds_write_lines(struct dem_state *state, const char *says, const char *folder,
                          const char *file, double time)
{
    const struct dem_decomposition *const q = &state->decomposition;
    struct dem_file_ranks by = dem_file_ranks_of(q);
    struct line *lines = NULL;
    char path[1200];
    int64_t n = 0;
    int status = DEM_OK;

    by.comment = says;
    if (state->lists_state == DEM_NEIGHBORS_NONE && state->steps > 0)
    {
        return DEM_OK;
    }
    if (state->lists_state != DEM_NEIGHBORS_NONE)
    {
        status = dem_bonds_list(state, &n);
    }
    status = dem_collect_agree(q, status ? status : DEM_NEW(lines, n + 1));
    for (int64_t k = 0; k < n && !status; k++)
    {
        lines[k] = line_of(&state->bonds->intact[k]);
    }
    status = status ? status : write_lines(&by, folder, file, lines, n);
    dem_memory_free(lines);
    if (status || q->rank > 0)
    {
        return status;
    }
    snprintf(path, sizeof path, "%s/bonds.pvd", folder);
    return dem_vtk_collection_add(path, time, file);
}
