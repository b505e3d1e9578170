/*
 * test_fuzz.c -- the harnesses of tests/fuzz with the plain build.
 *
 * - The harnesses for scenes, snapshots, tables and surfaces end with success or one sentence, with
 *   floating-point traps on, for each seed file and for 200 mutations of it.
 * - A snapshot with a header that describes more than the file has, with corrected checksums, is
 *   refused as damaged.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#define LLVMFuzzerTestOneInput dem_fuzz_snapshot
#include "fuzz/fuzz_snapshot.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput dem_fuzz_table
#include "fuzz/fuzz_table.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput dem_fuzz_stl
#include "fuzz/fuzz_stl.c"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput dem_fuzz_scene
#include "fuzz/fuzz_scene.c"
#undef LLVMFuzzerTestOneInput
#include "fuzz/fuzz.c"

enum
{
    MOST = 1 << 16,
    /* after name, box, start, interval and cells */
    MEANS_COLUMNS = 216,
    MEANS_LENGTH = 232,
    MEANS_FULL = 240
};

static uint8_t good[MOST], bad[MOST];

static size_t load(const char *path)
{
    FILE *const f = fopen(path, "rb");
    const size_t n = f ? fread(good, 1, MOST, f) : 0;

    TAP_OK(n > 0 && n < MOST, "%s can be read", path);
    return f && fclose(f) ? 0 : n;
}

/* The complete file, then with up to four bytes changed, then truncated. */
static void mutate(int (*reader)(const uint8_t *, size_t), const char *path)
{
    const size_t n = load(path);
    uint64_t state = 1;
    int refused = 0;

    reader(good, n);
    TAP_OK(fuzz_status() == 0, "%s: the seed is accepted: %s", path,
           fuzz_status() ? dem_error_text() : "");
    for (int k = 0; k < 200 && n > 0; k++)
    {
        memcpy(bad, good, n);
        for (uint64_t m = draw(&state)%4; m > 0; m--)
        {
            bad[draw(&state)%n] = (uint8_t)draw(&state);
        }
        reader(bad, k%5 ? n : draw(&state)%n);
        refused += fuzz_status() != 0;
    }
    TAP_OK(refused > 0, "%s: %d of 200 mutations are refused, each with one sentence", path,
           refused);
}

static void refuse_header(size_t at, int64_t value, size_t n, const char *what)
{
    memcpy(bad, good, n);
    memcpy(bad + at, &value, sizeof value);
    dem_fuzz_snapshot(bad, n);
    TAP_OK(fuzz_status() == DEM_ERROR_FILE && strstr(dem_error_text(), "is damaged"), "%s %lld: %s",
           what, (long long)value, dem_error_text());
}

int main(void)
{
    static char path[] = "/tmp/fuzz_snapshot_XXXXXX";
    const int fd = mkstemp(path);

    TAP_OK(fd >= 0 && fuzz_snapshot(path, 40) == 0, "a snapshot is written");
    mutate(dem_fuzz_snapshot, path);
    const size_t n = load(path);

    for (int k = 0; k < 3; k++)
    {
        const int64_t value = (const int64_t[]){-1, 1 << 20, INT64_MAX/8}[k];

        refuse_header(offsetof(struct dem_snapshot_header, particles), value, n, "particles");
        refuse_header(offsetof(struct dem_snapshot_header, rows), value, n, "rows");
        refuse_header(offsetof(struct dem_snapshot_header, materials), value, n, "materials");
        refuse_header(offsetof(struct dem_snapshot_header, columns), value, n, "columns");
        refuse_header(offsetof(struct dem_snapshot_header, memories), value, n, "memories");
        refuse_header(offsetof(struct dem_snapshot_header, flows), value, n, "flows");
    }
    const double nowhen = NAN;
    int64_t bits;

    memcpy(&bits, &nowhen, sizeof bits);
    refuse_header(offsetof(struct dem_snapshot_header, time), bits, n, "a time of bits");
    struct dem_snapshot_header head;

    memcpy(&head, good, sizeof head);
    TAP_OK(head.caller_data > MEANS_LENGTH + 8, "it has means");
    for (int k = 0; k < 3; k++)                           /* as grid_averages_snapshot.c has them */
    {
        const int64_t value = (const int64_t[]){-1, 1 << 20, INT64_MAX/8}[k];

        refuse_header(dem_snapshot_caller_data_offset(&head) + MEANS_COLUMNS, value, n,
                    "columns of means");
        refuse_header(dem_snapshot_caller_data_offset(&head) + MEANS_FULL, value, n,
                    "blocks of means");
    }
    refuse_header(dem_snapshot_caller_data_offset(&head) + MEANS_LENGTH, 0, n,
                "samples in a block of means");
    unlink(path);
    mutate(dem_fuzz_scene, "input/base.dem");
    mutate(dem_fuzz_scene, "parallel/streams.dem");
    mutate(dem_fuzz_scene, "parallel/all.dem");
    mutate(dem_fuzz_table, "fuzz/seeds/table/ids.csv");
    mutate(dem_fuzz_table, "fuzz/seeds/table/marks.csv");
    mutate(dem_fuzz_stl, "fuzz/seeds/stl/two.stl");
    mutate(dem_fuzz_stl, "fuzz/seeds/stl/three.bin.stl");
    TAP_DONE;
}
