/*
 * test_snapshot.c -- snapshots that are damaged, truncated, or cannot be written.
 *
 * - A snapshot is refused when any bit is flipped, when it is truncated at any byte, or when it is
 *   longer by one byte; the sentence names the file.
 * - A failed write leaves the old file unchanged.
 * - Offsets beyond 4 GB are written and read.
 *
 * Source: the contract of records/snapshot.h and ranks/parallel_file.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "records/snapshot.h"
#include "ranks/parallel_file.h"

#include <unistd.h>

static const char scene[] =
    "materials { glass { density 2500; youngsModulus 1e6; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.6; } "
    "mindlin { friction 0.5; } }"
    "walls { floor { type plane; point (0 0 0); normal (0.1 0 1); } }"
    "insert { grains { type list; diameter 1e-3; positions ((0 0 4.9e-4) (0 0 1.45e-3)); } }"
    "averages { box { min (-1 -1 -1); max (1 1 1); interval 1e-5; } }";

static char folder[] = "/tmp/snapshot.XXXXXX", good[64], bad[64];

static char *read_all(size_t *size)
{
    FILE *const f = fopen(good, "rb");
    char *const bytes = calloc(1, 1 << 20);

    if (!f || !bytes)
    {
        world_end(good);
    }
    *size = fread(bytes, 1, 1 << 20, f);
    fclose(f);
    return bytes;
}

static void write_all(const char *bytes, size_t size)
{
    FILE *const f = fopen(bad, "wb");

    if (!f || fwrite(bytes, 1, size, f) != size || fclose(f))
    {
        world_end(bad);
    }
}

/* In place, as writing a new file 10000 times would load the disk. */
static void put_byte(size_t place, char byte)
{
    FILE *const f = fopen(bad, "r+b");

    if (!f || fseek(f, (long)place, SEEK_SET) || fputc(byte, f) == EOF || fclose(f))
    {
        world_end(bad);
    }
}

static void cut(size_t size)
{
    if (truncate(bad, (off_t)size))
    {
        world_end(bad);
    }
}

/* Refused with the file's name when asked for its fingerprint, and when a run is to continue from
   it. */
static int is_refused(int load)
{
    uint64_t hash;
    int refused =
        dem_snapshot_fingerprint(bad, &hash) != 0 && strstr(dem_error_text(), bad) != NULL;

    if (load)
    {
        struct dem_case *const c = world_begin(scene);

        WORLD_TRY(dem_case_load(c, bad));
        refused = world_status(c) != 0 && refused && strstr(dem_error_text(), bad);
    }
    return refused;
}

static void damage(void)
{
    size_t size, flips = 0, cuts = 0;
    char *const bytes = read_all(&size);

    write_all(bytes, size);
    for (size_t k = 0; k < size; k++)
    {
        put_byte(k, (char)(bytes[k] ^ (1 << k%8)));
        flips += (size_t)is_refused(k%101 == 0);
        put_byte(k, bytes[k]);
    }
    TAP_OK(flips == size, "%zu of %zu bytes with one bit flipped are refused", flips, size);
    for (size_t k = size; k > 0; k--)
    {
        cut(k - 1);
        cuts += (size_t)is_refused(k%101 == 0);
    }
    TAP_OK(cuts == size, "%zu of %zu truncated lengths are refused", cuts, size);
    write_all(bytes, size + 1);                            /* calloc left a zero after it */
    TAP_OK(is_refused(1), "one byte too long: %s", dem_error_text());
    free(bytes);
}

/* Holes take no space on the disk. */
static void large_offsets(void)
{
    const struct dem_file_ranks alone = {.comm = MPI_COMM_NULL};
    const size_t place = ((size_t)5 << 30) + 3;
    struct dem_parallel_file s;
    char there[8] = "", here[8] = "";

    WORLD_TRY(dem_parallel_file_create(&s, &alone, bad, 1));
    dem_parallel_file_write_all(&s, place, "beyond", 7);
    dem_parallel_file_write(&s, 0, "before", 7);
    TAP_OK(dem_parallel_file_close(&s) == 0, "a file of 5 GB is written: %s", dem_error_text());
    WORLD_TRY(dem_parallel_file_open(&s, &alone, bad));
    dem_parallel_file_read(&s, place, there, 7);
    dem_parallel_file_read(&s, 0, here, 7);
    TAP_OK(dem_parallel_file_size(&s) == place + 7 && strcmp(there, "beyond") == 0 &&
               strcmp(here, "before") == 0,
           "a file of 5 GB is read back");
    dem_parallel_file_read(&s, place, there, 8);
    TAP_OK(dem_parallel_file_close(&s) != 0 && strstr(dem_error_text(), "cut short"),
           "reading beyond its end: %s", dem_error_text());
}

static void failing(struct dem *d)
{
    uint64_t before, after;
    char nowhere[96], *const block = world_text("mkdir %s.part", good),
                             *const unblock = world_text("rmdir %s.part", good);

    snprintf(nowhere, sizeof nowhere, "%s/nowhere/a.dem", folder);
    TAP_OK(dem_save(d, nowhere) != 0 && strstr(dem_error_text(), "folder"), "no folder: %s",
           dem_error_text());
    WORLD_TRY(dem_snapshot_fingerprint(good, &before));
    world_run(d, 1e-3);
    TAP_OK(system(block) == 0 && dem_save(d, good) != 0, "the new file cannot be written: %s",
           dem_error_text());
    TAP_OK(system(unblock) == 0 && dem_snapshot_fingerprint(good, &after) == 0 && before == after,
           "the old file is unchanged");
    WORLD_TRY(dem_save(d, good));
    TAP_OK(dem_snapshot_fingerprint(good, &after) == 0 && after == world_hash(d),
           "it is replaced when writing succeeds again");
}

int main(void)
{
    TAP_TRAPS;
    if (!mkdtemp(folder))
    {
        world_end("mkdtemp");
    }
    snprintf(good, sizeof good, "%s/good.dem", folder);
    snprintf(bad, sizeof bad, "%s/bad.dem", folder);
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 1e-4);
    WORLD_TRY(dem_save(d, good));
    damage();
    large_offsets();
    failing(d);
    dem_free(d);
    char *const command = world_text("rm -r %s", folder);

    TAP_OK(system(command) == 0, "the folder is removed");
    TAP_DONE;
}
