/*
 * grid_averages_snapshot.c -- save time averages in a snapshot and restore them after a restart.
 *
 * For each grid, and for each scalar on it: a record (struct dem_grid_average_record, stored raw),
 * the block sums, the sums of all samples; cells times columns numbers each. The record of a scalar
 * is named SCALAR/GRID; no grid has a / in its name. Numbers are stored in the machine's format,
 * as in the whole snapshot, which also has the checksum.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "records/snapshot_header.h"
#include "records/grid_averages.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    SPANS = 3    /* of a grid or a scalar on it: record, block sums, sums of all samples */
};

static const int64_t max_samples = (int64_t)1 << 53;
/* SI: max_samples times the largest sample, grid_averages.c */
static const double max_sum = 1e80;

struct dem_grid_average_record
{
    char name[128];
    double min[3], max[3], start, interval;
    int64_t cells[3], columns, samples, length, full;
};

/* scalar: its name; "" for the sums of all else. */
static struct dem_grid_average_record describe(const struct dem_averages_entry *entry,
                                               const char *scalar,
                                               const struct dem_block_means *blocks)
{
    struct dem_grid_average_record out = {.start = entry->start,
                                          .interval = entry->interval,
                                          .columns = (int64_t)blocks->columns,
                                          .samples = blocks->samples,
                                          .length = blocks->length,
                                          .full = blocks->full};

    snprintf(out.name, sizeof out.name, "%s%s%s", scalar, scalar[0] ? "/" : "", entry->name);
    for (int k = 0; k < 3; k++)
    {
        out.min[k] = entry->min[k];
        out.max[k] = entry->max[k];
        out.cells[k] = entry->cells[k];
    }
    return out;
}

/* Blocks in use, including the one that is being filled. */
static size_t used_of(const struct dem_grid_average_record *g)
{
    return (size_t)(g->full < DEM_BLOCK_MEANS_MAX_BLOCKS ? g->full + 1 : g->full);
}

static void span_of(struct dem_grid_average_record *record, const struct dem_block_means *b,
                    struct dem_span *s)
{
    s[0] = (struct dem_span){record, sizeof *record};
    s[1] = (struct dem_span){b->sum, used_of(record)*b->columns*sizeof *b->sum};
    s[2] = (struct dem_span){b->total, b->columns*sizeof *b->total};
}

int dem_grid_averages_spans(const struct dem_grid_averages *a,
                            struct dem_grid_average_record **record, struct dem_span **span, int *n)
{
    int sets = 0, at = 0;

    for (int k = 0; k < a->grids; k++)
    {
        sets += 1 + a->grid[k].scalars;
    }
    *n = SPANS*sets;
    DEM_TRY(DEM_NEW(*record, sets + 1));
    DEM_TRY(DEM_NEW(*span, *n + 1));
    for (int k = 0; k < a->grids; k++)
    {
        const struct dem_grid_average *const g = &a->grid[k];

        (*record)[at] = describe(&g->entry, "", &g->sums.blocks);
        span_of(&(*record)[at], &g->sums.blocks, *span + SPANS*at);
        at++;
        for (int s = 0; s < g->scalars; s++, at++)
        {
            (*record)[at] = describe(&g->entry, g->scalar[s].name, &g->scalar[s].sums.blocks);
            span_of(&(*record)[at], &g->scalar[s].sums.blocks, *span + SPANS*at);
        }
    }
    return DEM_OK;
}

static int same_grid(const struct dem_grid_average_record *a,
                     const struct dem_grid_average_record *b)
{
    return strncmp(a->name, b->name, sizeof a->name) == 0 && a->columns == b->columns &&
           memcmp(a->min, b->min, sizeof a->min) == 0 &&
           memcmp(a->max, b->max, sizeof a->max) == 0 &&
           memcmp(a->cells, b->cells, sizeof a->cells) == 0 &&
           memcmp(&a->start, &b->start, sizeof a->start) == 0 &&
           memcmp(&a->interval, &b->interval, sizeof a->interval) == 0;
}

static void restore_set(const struct dem_averages_entry *entry, const char *scalar,
                        struct dem_block_means *b, const struct dem_grid_average_record *g,
                        const char *numbers)
{
    const size_t sums = used_of(g)*(size_t)g->columns*sizeof(double);
    const struct dem_grid_average_record mine = describe(entry, scalar, b);

    if (same_grid(&mine, g))
    {
        dem_block_means_restore(b, g->samples, g->length);
        memcpy(b->sum, numbers, sums);
        memcpy(b->total, numbers + sums, (size_t)g->columns*sizeof *b->total);
    }
}

static void restore_sums(struct dem_grid_averages *a, const struct dem_grid_average_record *g,
                         const char *numbers)
{
    for (int k = 0; k < a->grids; k++)
    {
        struct dem_grid_average *const mine = &a->grid[k];

        restore_set(&mine->entry, "", &mine->sums.blocks, g, numbers);
        for (int s = 0; s < mine->scalars; s++)
        {
            restore_set(&mine->entry, mine->scalar[s].name, &mine->scalar[s].sums.blocks, g,
                        numbers);
        }
    }
}

/* 1 when the record is consistent and the `left` bytes after it contain its numbers. */
static int is_consistent(const struct dem_grid_average_record *g, size_t left)
{
    return dem_snapshot_is_name(g->name, sizeof g->name) && g->length > 0 && g->samples >= 0 &&
           g->samples <= max_samples && g->full == g->samples/g->length &&
           g->full <= DEM_BLOCK_MEANS_MAX_BLOCKS && g->columns > 0 &&
           (uint64_t)g->columns <= left/(used_of(g) + 1)/sizeof(double);
}

/* Check the block sums, then the sums of all samples. */
static int check_sums(const char *path, const struct dem_grid_average_record *g,
                      const char *numbers)
{
    const size_t n = (used_of(g) + 1)*(size_t)g->columns;

    for (size_t k = 0; k < n; k++)
    {
        double sum;

        memcpy(&sum, numbers + k*sizeof sum, sizeof sum);
        DEM_REQUIRE(
            isless(fabs(sum), max_sum), DEM_ERROR_FILE,
            "%s is damaged: sum %zu of %zu of its averages %s is %g, the limit is %g; use another one",
            path, k + 1, n, g->name, sum, max_sum);
    }
    return DEM_OK;
}

int dem_grid_averages_restore(struct dem_grid_averages *a, const char *path, const char *bytes,
                              size_t size)
{
    struct dem_grid_average_record g;

    for (size_t at = 0; at < size;
         at += sizeof g + (used_of(&g) + 1)*(size_t)g.columns*sizeof(double))
    {
        DEM_REQUIRE(size - at >= sizeof g, DEM_ERROR_FILE,
                    "%s is damaged: its averages are incomplete; use another one", path);
        memcpy(&g, bytes + at, sizeof g);
        DEM_REQUIRE(is_consistent(&g, size - at - sizeof g), DEM_ERROR_FILE,
                    "%s is damaged: its averages have %lld samples of %lld columns, in %lld "
                    "full blocks of %lld, in %zu bytes, or an invalid name; use another one",
                    path, (long long)g.samples, (long long)g.columns, (long long)g.full,
                    (long long)g.length, size - at - sizeof g);
        DEM_TRY(check_sums(path, &g, bytes + at + sizeof g));
        restore_sums(a, &g, bytes + at + sizeof g);
    }
    return DEM_OK;
}
