/*
 * test_full_disk.c -- files that cannot be written to their end.
 *
 * Where files may have 4 kB only, as on a full disk, a snapshot, the means of a grid and the rows of
 * a table fail with the file's name and the reason, and a snapshot of before stays.
 *
 * Source: the contracts in dem.h; setrlimit of POSIX.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <signal.h>
#include <sys/resource.h>

static const char heap[] =
    "materials { glass { density 2500; youngsModulus 2e6; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.6; } }"
    "walls { cup { type box; min (0 0 0); max (0.01 0.01 0.1); } }"
    "insert { grains { type lattice; count 60; diameter 2e-3; min (0 0 0); max (0.01 0.01 0.1); } }"
    "averages { grid { min (0 0 0); max (0.01 0.01 0.1); cells (10 10 10); interval 1e-3; } }"
    "time { step 1e-5; }";

static char folder[] = "/tmp/full_disk.XXXXXX";

static void limit(rlim_t bytes)
{
    struct rlimit l;

    const int known = getrlimit(RLIMIT_FSIZE, &l);

    l.rlim_cur = bytes;
    if (known != 0 || setrlimit(RLIMIT_FSIZE, &l) != 0)
    {
        world_end("the limit of the size of files cannot be set");
    }
}

/* What a call that writes returned, kept until the test may write its own results. */
struct outcome
{
    int status;
    char *text;
};

static struct outcome outcome(int status)
{
    return (struct outcome){status, world_text("%s", dem_error_text())};
}

static void fails(struct outcome o, const char *what, const char *file)
{
    TAP_OK(o.status == DEM_ERROR_FILE && strstr(o.text, file) && strstr(o.text, "File too large"),
           "%s: %s", what, o.text);
}

int main(void)
{
    TAP_TRAPS;
    if (!mkdtemp(folder))
    {
        world_end("mkdtemp");
    }
    signal(SIGXFSZ, SIG_IGN);    /* a write returns EFBIG instead */
    struct dem *const d = world(heap, 0, NULL);
    struct dem_table table;
    char file[64], *const rows = calloc(1, 8192);
    uint64_t before, after;

    snprintf(file, sizeof file, "%s/state.dem", folder);
    dem_table_name(&table, folder, "own.csv", 0.0);
    memset(rows, '1', 8190);
    rows[8190] = '\n';
    world_run(d, 0.01);
    WORLD_TRY(dem_save(d, file));
    WORLD_TRY(dem_snapshot_hash(file, &before));
    world_run(d, 0.01);
    limit(4096);
    const struct outcome saved = outcome(dem_save(d, file)), means = outcome(dem_averages(d, folder)),
                         appended = outcome(dem_table_append(&table, d, "a", rows));
    limit(RLIM_INFINITY);
    fails(saved, "a snapshot", "state.dem");
    fails(means, "means", "grid.csv");
    fails(appended, "a table", "own.csv");
    TAP_OK(dem_snapshot_hash(file, &after) == 0 && after == before, "the snapshot of before stays");
    WORLD_TRY(dem_save(d, file));
    TAP_OK(dem_snapshot_hash(file, &after) == 0 && after == world_hash(d),
           "with space again the run saves");
    free(rows);
    dem_free(d);
    if (system(NULL))
    {
        char *const command = world_text("rm -r %s", folder);

        TAP_OK(system(command) == 0, "the folder is removed");
    }
    TAP_DONE;
}
