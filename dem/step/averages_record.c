/*
 * averages_record.c -- means that go on after a restart: what stands of them in a snapshot.
 *
 * For each grid what it is, then the sums of its blocks and of all samples, as many numbers as it has cells and columns each. Bits
 * as the machine has them, like all of the snapshot, which also checks them. A grid goes on when name, box, cells, start and interval
 * are those of the record, and begins anew otherwise.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "io/snapshot_head.h"
#include "step/averages.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    SPANS = 3                                                 /* of a grid: what it is, sums of blocks, of all samples */
};

static const int64_t most_samples = (int64_t)1 << 53;
static const double most_sum = 1e80;                          /* SI: so many samples of the largest that one takes, see averages.c */

struct dem_average_record
{
    char name[128];
    double min[3], max[3], start, interval;
    int64_t cells[3], columns, samples, length, full;
};

static struct dem_average_record describe(const struct dem_average *g)
{
    struct dem_average_record out = {.start = g->plan.start, .interval = g->plan.interval, .columns = (int64_t)g->blocks.columns,
                                     .samples = g->blocks.samples, .length = g->blocks.length, .full = g->blocks.full};

    snprintf(out.name, sizeof out.name, "%s", g->plan.name);
    for (int k = 0; k < 3; k++)
    {
        out.min[k] = g->plan.min[k];
        out.max[k] = g->plan.max[k];
        out.cells[k] = g->plan.cells[k];
    }
    return out;
}

/* Blocks in use, the one that is being filled included. */
static size_t used_of(const struct dem_average_record *g)
{
    return (size_t)(g->full < DEM_BLOCKS ? g->full + 1 : g->full);
}

int dem_averages_spans(const struct dem_averages *a, struct dem_average_record **record, struct dem_span **span, int *n)
{
    *n = SPANS*a->grids;
    DEM_TRY(DEM_NEW(*record, a->grids + 1));
    DEM_TRY(DEM_NEW(*span, *n + 1));
    for (int k = 0; k < a->grids; k++)
    {
        const struct dem_blocks *const b = &a->grid[k].blocks;
        struct dem_span *const s = *span + SPANS*k;

        (*record)[k] = describe(&a->grid[k]);
        s[0] = (struct dem_span){&(*record)[k], sizeof **record};
        s[1] = (struct dem_span){b->sum, used_of(&(*record)[k])*b->columns*sizeof *b->sum};
        s[2] = (struct dem_span){b->total, b->columns*sizeof *b->total};
    }
    return DEM_OK;
}

static int same_grid(const struct dem_average_record *a, const struct dem_average_record *b)
{
    return strncmp(a->name, b->name, sizeof a->name) == 0 && a->columns == b->columns && memcmp(a->min, b->min, sizeof a->min) == 0
        && memcmp(a->max, b->max, sizeof a->max) == 0 && memcmp(a->cells, b->cells, sizeof a->cells) == 0
        && memcmp(&a->start, &b->start, sizeof a->start) == 0 && memcmp(&a->interval, &b->interval, sizeof a->interval) == 0;
}

static void go_on(struct dem_averages *a, const struct dem_average_record *g, const char *numbers)
{
    const size_t sums = used_of(g)*(size_t)g->columns*sizeof(double);

    for (int k = 0; k < a->grids; k++)
    {
        struct dem_blocks *const b = &a->grid[k].blocks;
        const struct dem_average_record mine = describe(&a->grid[k]);

        if (same_grid(&mine, g))
        {
            b->samples = g->samples;
            b->length = g->length;
            b->full = (int)g->full;
            memcpy(b->sum, numbers, sums);
            memcpy(b->total, numbers + sums, (size_t)g->columns*sizeof *b->total);
        }
    }
}

/* 1 when the numbers that it tells of are there, in `left` bytes behind it. */
static int holds(const struct dem_average_record *g, size_t left)
{
    return dem_snapshot_is_name(g->name, sizeof g->name) && g->length > 0 && g->samples >= 0 && g->samples <= most_samples && g->full == g->samples/g->length && g->full <= DEM_BLOCKS && g->columns > 0
        && (uint64_t)g->columns <= left/(used_of(g) + 1)/sizeof(double);
}

/* Sums over blocks, then over all samples. */
static int judge_sums(const char *path, const struct dem_average_record *g, const char *numbers)
{
    const size_t n = (used_of(g) + 1)*(size_t)g->columns;

    for (size_t k = 0; k < n; k++)
    {
        double sum;

        memcpy(&sum, numbers + k*sizeof sum, sizeof sum);
        DEM_REQUIRE(isless(fabs(sum), most_sum), DEM_ERROR_FILE, "%s is damaged: sum %zu of %zu of its means %s is %g, the limit is %g; use another one",
                    path, k + 1, n, g->name, sum, most_sum);
    }
    return DEM_OK;
}

int dem_averages_resume(struct dem_averages *a, const char *path, const char *bytes, size_t size)
{
    struct dem_average_record g;

    for (size_t at = 0; at < size; at += sizeof g + (used_of(&g) + 1)*(size_t)g.columns*sizeof(double))
    {
        DEM_REQUIRE(size - at >= sizeof g, DEM_ERROR_FILE, "%s is damaged: its means end in the middle; use another one", path);
        memcpy(&g, bytes + at, sizeof g);
        DEM_REQUIRE(holds(&g, size - at - sizeof g), DEM_ERROR_FILE, "%s is damaged: its means tell of %lld samples of %lld columns, in %lld "
                    "full blocks of %lld, in %zu bytes, or have a name that is none; use another one", path, (long long)g.samples, (long long)g.columns, (long long)g.full,
                    (long long)g.length, size - at - sizeof g);
        DEM_TRY(judge_sums(path, &g, bytes + at + sizeof g));
        go_on(a, &g, bytes + at + sizeof g);
    }
    return DEM_OK;
}
