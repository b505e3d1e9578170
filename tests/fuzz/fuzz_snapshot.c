/*
 * fuzz_snapshot.c -- any bytes as a snapshot: corrected so that the reader does not refuse it
 * immediately, read, and advanced by one step.
 *
 * The checksums would exclude nearly all inputs. So magic, byte order, version and the three
 * checksums are corrected, and the file gets the length that its header describes, if that is below
 * 1 MB. In half of the cases bytes are changed by the mutator of this file: a whole word of the
 * header, of a particle or of a row becomes an extreme number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "fuzz.h"
#include "fuzz_snapshot.h"
#include "core/hash.h"
#include "records/snapshot_header.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most) __attribute__((weak));
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

static const char scene[] =
    "materials { rock { density 2500; youngsModulus 4e6; } clay { density 2000; "
    "youngsModulus 2e6; } } "
    "effects { hertz { } dry { restitution 0.8; } mindlin { friction 0.4; } "
    "rollingSpring { friction 0.1; } "
    "bondLinear { normalStiffness 4e9; shearStiffness 1.6e9; radius 0.8; makeDistance 1.02; } "
    "gravity { acceleration (0 0 -9.81); } } "
    "pairs { soft { between (clay clay); bondLinear { probability 0; } } } "
    "domain { min (0 0 -0.001); max (0.008 0.008 0.008); periodic (x); leaving remove; } "
    "walls { floor { type plane; material rock; point (0 0 0); normal (0 0 1); "
    "motion { type oscillation; amplitude (0 0 1e-4); frequency 200; } } } "
    "insert { %s rain { type stream; material clay; rate 1e4; diameter 1e-3; min (0 0 0.006); "
    "max (0.008 0.008 0.008); velocity (0 0 -1); } } "
    "outlets { hole { point (0 0.0075 0); normal (0 1 0); } } "
    "averages { box { min (0 0 0); max (0.008 0.008 0.008); cells (2 1 2); interval 1e-5; } } "
    "time { step 1e-6; }";

static const char grains[] =
    "block { type list; material rock; diameter 1e-3; "
    "positions ((0.001 0.004 0.0005) (0.002 0.004 0.0005) (0.0079 0.004 0.0005)); "
    "velocity (0.1 0 -0.1); } soft { type list; material clay; diameter 0.8e-3; "
    "positions ((0.004 0.002 0.00039) (0.0048 0.002 0.00039)); spin (0 50 0); } ";

static struct dem_case *begin(const char *insert)
{
    char text[sizeof scene + sizeof grains];
    struct dem_case *c = NULL;

    snprintf(text, sizeof text, scene, insert);
    return dem_case_create(&c, MPI_COMM_NULL) || dem_case_scene_text(c, text, "scene") ? NULL : c;
}

int fuzz_snapshot(const char *path, int steps)
{
    struct dem_case *c = begin(grains);
    struct dem *d = NULL;
    const int status =
        !c || dem_start(&c, &d) || (steps > 0 && dem_advance(d, 1e-6*steps)) || dem_save(d, path);

    dem_free(d);
    return status;
}

/* Length that the header describes; 0 if it is invalid or too large. */
static size_t described_length(const struct dem_snapshot_header *h)
{
    const int64_t most = 1 << 12;
    int good = h->particles >= 0 && h->particles < most && h->rows >= 0 && h->rows < most &&
               h->caller_data >= 0 && h->caller_data < most*16 && h->materials >= 0 &&
               h->columns >= 0 && h->memories >= 0 && h->materials < 64 && h->columns < 64 &&
               h->memories < 64 && h->materials + h->columns + h->memories <= DEM_SNAPSHOT_NAMES;

    for (int64_t c = 0; good && c < h->columns; c++)
    {
        good = h->list[h->materials + c].width >= 0 && h->list[h->materials + c].width < 64;
    }
    const size_t size = good ? dem_snapshot_caller_data_offset(h) + (size_t)h->caller_data : 0;

    return size < 1 << 20 ? size : 0;
}

/* The file with corrected marks and checksums; *n becomes its length. The caller frees it. */
static uint8_t *corrected(const uint8_t *data, size_t *n)
{
    struct dem_snapshot_header h;

    memset(&h, 0, sizeof h);
    memcpy(&h, data, *n < sizeof h ? *n : sizeof h);
    const size_t fit = described_length(&h), size = fit ? fit : *n < sizeof h ? sizeof h : *n;
    uint8_t *const file = calloc(size, 1);

    memcpy(file, data, size < *n ? size : *n);
    memcpy(h.magic, dem_snapshot_magic, sizeof h.magic);
    h.order = dem_snapshot_order;
    h.version = DEM_SNAPSHOT_VERSION;
    if (fit)
    {
        const double *const particle = (const double *)(file + sizeof h),
                            *const row = (const double *)(file + dem_snapshot_contacts_offset(&h));
        struct dem_hash beside;

        dem_hash_start(&beside, 'b');
        dem_hash_bytes(&beside, file + dem_snapshot_caller_data_offset(&h), (size_t)h.caller_data);
        h.caller_data_checksum = dem_hash_value(&beside);
        h.checksum = dem_snapshot_checksum(particle, (size_t)h.particles,
                                           dem_snapshot_particle_doubles(&h)) +
                     dem_snapshot_checksum(row, (size_t)h.rows, dem_snapshot_contact_doubles(&h));
    }
    h.head_checksum = dem_snapshot_header_checksum(&h);
    memcpy(file, &h, sizeof h);
    *n = size;
    return file;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t n = size;
    uint8_t *const file = corrected(data, &n);
    const char *const path = fuzz_file(file, n);
    struct dem_case *c = begin("");
    struct dem *d = NULL;
    uint64_t fingerprint;

    free(file);
    fuzz_trap();
    if (c)
    {
        int status = dem_case_load(c, path);

        status = status ? status : dem_start(&c, &d);
        status = status ? status : dem_advance(d, 1e-6);
        fuzz_judge(status);
        dem_case_free(c);
        dem_free(d);
        fuzz_judge(dem_snapshot_fingerprint(path, &fingerprint));
        fuzz_judge(status);
    }
    fuzz_untrap();
    return 0;
}

/* ---- mutation ---------------------------------------------------------------------------- */

static uint64_t draw(uint64_t *state)                     /* splitmix64 */
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;

    z = (z ^ z >> 30)*0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27)*0x94d049bb133111ebu;
    return z ^ z >> 31;
}

static uint64_t extreme_number(uint64_t *state, uint64_t old)
{
    static const double real[] = {0.0, -0.0, 1.0, -1.0, NAN, INFINITY,
                                  -INFINITY, DBL_MAX, -DBL_MAX, DBL_MIN, 5e-324, 1e-300,
                                  1e300, 1e30, 1e-3, 1e9, 0.5};
    static const int64_t whole[] = {0,
                                    1,
                                    2,
                                    3,
                                    5,
                                    24,
                                    25,
                                    32,
                                    33,
                                    127,
                                    128,
                                    129,
                                    4096,
                                    65535,
                                    INT32_MAX,
                                    (int64_t)1 << 32,
                                    (int64_t)1 << 53,
                                    INT64_MAX,
                                    INT64_MAX - 1,
                                    INT64_MIN,
                                    -1,
                                    -2,
                                    -128,
                                    INT64_MAX/8,
                                    INT64_MAX/16,
                                    INT64_MIN/8};
    const uint64_t how = draw(state)%4, which = draw(state);
    uint64_t word = old;

    switch (how)
    {
    case 0:
        memcpy(&word, &real[which%(sizeof real/sizeof *real)], sizeof word);
        return word;
    case 1:
        return (uint64_t)whole[which%(sizeof whole/sizeof *whole)];
    case 2:
        return old + which%17 - 8;
    default:
        return old ^ (uint64_t)1 << which%64;
    }
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    struct dem_snapshot_header h;
    uint64_t state = seed, word;
    const size_t flows = offsetof(struct dem_snapshot_header, flow)/8,
                 names = offsetof(struct dem_snapshot_header, materials)/8;

    if (size < sizeof h || draw(&state)%4 == 0)
    {
        return LLVMFuzzerMutate(data, size, most);
    }
    for (uint64_t k = 0, n = 1 + draw(&state)%3; k < n; k++)
    {
        const size_t words = size/8, part = draw(&state)%8;
        size_t at = (size_t)draw(&state);

        at = part < 1 ? 6 + at%(flows - 6)
             : part < 2 ? flows + at%(2*sizeof h.flow[0]/8)
             : part < 3 ? names + at%(3 + 20*7)
             : sizeof h/8 < words ? sizeof h/8 + at%(words - sizeof h/8)
                                    : at%words;
        memcpy(&word, data + 8*at, 8);
        word = extreme_number(&state, word);
        memcpy(data + 8*at, &word, 8);
    }
    return size;
}
