/*
 * averages_file.c -- means that go on after a restart: the sums of all grids in a file beside the snapshot, by the first rank.
 *
 * The head; then for each grid what it is, and the sums of its blocks and of all samples, as many numbers as it has cells and
 * columns each. Bits as the machine has them, like the snapshot's. A grid goes on when name, box, cells, start and interval are
 * those of the file, and begins anew otherwise.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "io/file.h"
#include "io/hash.h"
#include "step/averages.h"
#include <stdio.h>
#include <string.h>

struct head
{
    char magic[16];
    double time;                                              /* s: of the snapshot */
    int64_t grids;
    uint64_t check;                                           /* of all that follows */
};

struct grid
{
    char name[128];
    double min[3], max[3], start, interval;
    int64_t cells[3], columns, samples, length, full;
};

static const char magic[16] = "Suna means 1";

static struct grid describe(const struct dem_average *g)
{
    struct grid out = {.start = g->plan.start, .interval = g->plan.interval, .columns = (int64_t)g->blocks.columns,
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
static size_t used_of(const struct grid *g)
{
    return (size_t)(g->full < DEM_BLOCKS ? g->full + 1 : g->full);
}

static size_t numbers_of(const struct grid *g)
{
    return (used_of(g) + 1)*(size_t)g->columns;
}

/* ---- writing --------------------------------------------------------------------------------------------------- */

static void stir(const struct dem_averages *a, struct dem_hash *h)
{
    for (int k = 0; k < a->grids; k++)
    {
        const struct dem_blocks *const b = &a->grid[k].blocks;
        const struct grid g = describe(&a->grid[k]);

        dem_hash_bytes(h, &g, sizeof g);
        dem_hash_bytes(h, b->sum, used_of(&g)*b->columns*sizeof *b->sum);
        dem_hash_bytes(h, b->total, b->columns*sizeof *b->total);
    }
}

static int write_all(const struct dem_averages *a, double time, FILE *to)
{
    struct head head = {.time = time, .grids = a->grids};
    struct dem_hash h;

    memcpy(head.magic, magic, sizeof magic);
    dem_hash_start(&h, 'm');
    stir(a, &h);
    head.check = dem_hash_value(&h);
    fwrite(&head, sizeof head, 1, to);
    for (int k = 0; k < a->grids; k++)
    {
        const struct dem_blocks *const b = &a->grid[k].blocks;
        const struct grid g = describe(&a->grid[k]);

        fwrite(&g, sizeof g, 1, to);
        fwrite(b->sum, sizeof *b->sum, used_of(&g)*b->columns, to);
        fwrite(b->total, sizeof *b->total, b->columns, to);
    }
    return DEM_OK;
}

int dem_averages_keep(const struct dem_averages *a, double time, const char *path)
{
    struct dem_file f;

    DEM_TRY(dem_file_begin(&f, path));
    return dem_file_finish(&f, write_all(a, time, f.stream));
}

/* ---- reading --------------------------------------------------------------------------------------------------- */

/* 1 when a grid of the file may be one of the run's. */
static int same_grid(const struct grid *a, const struct grid *b)
{
    return strncmp(a->name, b->name, sizeof a->name) == 0 && a->columns == b->columns && memcmp(a->min, b->min, sizeof a->min) == 0
        && memcmp(a->max, b->max, sizeof a->max) == 0 && memcmp(a->cells, b->cells, sizeof a->cells) == 0
        && memcmp(&a->start, &b->start, sizeof a->start) == 0 && memcmp(&a->interval, &b->interval, sizeof a->interval) == 0;
}

static void go_on(struct dem_averages *a, const struct grid *g, const char *numbers)
{
    for (int k = 0; k < a->grids; k++)
    {
        struct dem_blocks *const b = &a->grid[k].blocks;
        const struct grid mine = describe(&a->grid[k]);
        const size_t sums = used_of(g)*(size_t)g->columns*sizeof *b->sum;

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

static int read_all(struct dem_averages *a, double time, const char *path, const char *bytes, size_t n)
{
    struct head head;
    struct grid g;
    size_t at = sizeof head;

    DEM_REQUIRE(n >= sizeof head && memcmp(bytes, magic, sizeof magic) == 0, DEM_ERROR_INPUT, "%s is no file of means; remove it, and they "
                "begin anew", path);
    memcpy(&head, bytes, sizeof head);
    DEM_REQUIRE(dem_hash_record(bytes + at, n - at, 'm') == head.check, DEM_ERROR_INPUT, "the means in %s are damaged or cut short; remove "
                "the file, and they begin anew", path);
    DEM_REQUIRE(!(head.time < time || head.time > time), DEM_ERROR_INPUT, "the means in %s are of time %.9g s, the particles of %.9g s; "
                "remove the file, and they begin anew", path, head.time, time);
    for (int64_t k = 0; k < head.grids; k++)
    {
        memcpy(&g, bytes + at, sizeof g);
        go_on(a, &g, bytes + at + sizeof g);
        at += sizeof g + numbers_of(&g)*sizeof(double);
    }
    return DEM_OK;
}

int dem_averages_resume(struct dem_averages *a, double time, const char *path)
{
    char *bytes;
    size_t n;

    if (!dem_file_exists(path))
    {
        return DEM_OK;
    }
    DEM_TRY(dem_file_load(path, &bytes, &n));
    const int status = read_all(a, time, path, bytes, n);

    dem_memory_free(bytes);
    return status;
}
