/*
 * test_absurd.c -- a snapshot with correct checksums and impossible contents is refused by a
 * sentence that names file, quantity, particle and value; with the value restored it is accepted.
 *
 * Source: the contract of records/snapshot_validate.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/hash.h"
#include "records/snapshot_header.h"

#include <unistd.h>

static const char scene[] =
    "materials { glass { density 2500; youngsModulus 1e6; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.6; } "
    "mindlin { friction 0.5; } }"
    "domain { min (-1 -1 -1); max (1 1 1); leaving remove; }"
    "walls { floor { type plane; point (0 0 0); normal (0.1 0 1); } }"
    "insert { grains { type list; diameter 1e-3; positions ((0 0 4.9e-4) (0 0 1.45e-3)); }"
    "         rain { type stream; material glass; rate 1e4; diameter 1e-3; min (0.1 0.1 0.1); "
    "max (0.11 0.11 0.11); } }"
    "averages { box { min (-1 -1 -1); max (1 1 1); interval 1e-5; } }";

enum
{
    MOST = 1 << 20,
    /* bytes before the sums, as in grid_averages_snapshot.c */
    MEANS = 248
};

static char folder[] = "/tmp/absurd.XXXXXX", good_path[64], bad_path[64];
static char good[MOST], bad[MOST];
static size_t size;

static size_t load(const char *path, char *to)
{
    FILE *const f = fopen(path, "rb");
    const size_t n = f ? fread(to, 1, MOST, f) : 0;

    if (!f || fclose(f) || n < sizeof(struct dem_snapshot_header) || n == MOST)
    {
        world_end(path);
    }
    return n;
}

/* Write the corrupted snapshot, with correct checksums. */
static void store(const char *path)
{
    struct dem_snapshot_header h;
    struct dem_hash beside;
    FILE *const f = fopen(path, "wb");

    memcpy(&h, bad, sizeof h);
    dem_hash_start(&beside, 'b');
    dem_hash_bytes(&beside, bad + dem_snapshot_caller_data_offset(&h), (size_t)h.caller_data);
    h.caller_data_checksum = dem_hash_value(&beside);
    h.checksum = dem_snapshot_checksum((const double *)(bad + sizeof h), (size_t)h.particles,
                                       dem_snapshot_particle_doubles(&h)) +
                 dem_snapshot_checksum((const double *)(bad + dem_snapshot_contacts_offset(&h)),
                                       (size_t)h.rows, dem_snapshot_contact_doubles(&h));
    h.head_checksum = dem_snapshot_header_checksum(&h);
    memcpy(bad, &h, sizeof h);
    if (!f || fwrite(bad, 1, size, f) != size || fclose(f))
    {
        world_end(path);
    }
}

static struct dem_snapshot_header head(void)
{
    struct dem_snapshot_header h;

    memcpy(&h, good, sizeof h);
    return h;
}

/* Offset of a particle's record or column, of a row, of the first sum of means. */
static size_t of_particle(int64_t k, size_t offset)
{
    const struct dem_snapshot_header h = head();

    return sizeof h + (size_t)k*dem_snapshot_particle_doubles(&h)*sizeof(double) + offset;
}

static size_t of_row(int64_t k, size_t offset)
{
    const struct dem_snapshot_header h = head();

    return dem_snapshot_contacts_offset(&h) +
           (size_t)k*dem_snapshot_contact_doubles(&h)*sizeof(double) + offset;
}

static size_t of_means(void)
{
    const struct dem_snapshot_header h = head();

    return dem_snapshot_caller_data_offset(&h) + MEANS;
}

/* ---- refused --------------------------------------------------------------------------------- */

static int can_start(void)
{
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, bad_path));
    return world_status(c);
}

static void expect(int status, const char *what, const char *words)
{
    const char *const text = dem_error_text();

    TAP_OK(status == DEM_ERROR_FILE && strstr(text, bad_path) && strstr(text, "is damaged") &&
               strstr(text, "use another one") && strstr(text, words),
           "%s: %s", what, status ? text : "accepted");
}

/* Replace eight bytes of the file. */
static void corrupt(const char *what, size_t at, const void *word, int hashes, const char *words)
{
    uint64_t hash;

    memcpy(bad, good, size);
    memcpy(bad + at, word, 8);
    store(bad_path);
    expect(can_start(), what, words);
    if (hashes)
    {
        expect(dem_snapshot_fingerprint(bad_path, &hash), "asked for its fingerprint", words);
    }
}

static void number(const char *what, size_t at, double value, const char *words)
{
    corrupt(what, at, &value, 1, words);
}

static void whole(const char *what, size_t at, int64_t value, const char *words)
{
    corrupt(what, at, &value, 1, words);
}

/* offsets of a member of particle k's record, of a member of the header */
#define IN(k, member) of_particle(k, offsetof(struct dem_particle, member))
#define HEAD(member) offsetof(struct dem_snapshot_header, member)

static void particles(void)
{
    const size_t force = sizeof(struct dem_particle);     /* the first column */

    number("a position that is not a number", IN(1, x) + 8, NAN,
           "particle 1 has distance [m] from the origin nan");
    number("an infinite position", IN(0, x), -INFINITY, "particle 0 has distance [m] from the origin inf");
    number("a position too far to resolve overlaps", IN(1, x), 1e30,
           "particle 1 has distance [m] from the origin 1e+30");
    number("a velocity that is not a number", IN(0, v), NAN, "particle 0 has speed [m/s] nan");
    number("an infinite velocity", IN(0, v) + 16, INFINITY, "particle 0 has speed [m/s] inf");
    number("1e30 m/s", IN(1, v), 1e30, "particle 1 has speed [m/s] 1e+30");
    number("1e200 m/s, whose square is infinite", IN(1, v), 1e200, "particle 1 has speed [m/s] inf");
    number("a spin that is not a number", IN(1, w), NAN, "particle 1 has speed [m/s] of its surface nan");
    number("a surface faster than light", IN(1, w), 1e12,
           "particle 1 has speed [m/s] of its surface 5e+08");
    number("a radius that is not a number", IN(0, radius), NAN, "particle 0 has radius [m] nan");
    number("a mass that is not a number", IN(0, mass), NAN, "particle 0 has mass [kg] nan");
    number("an infinite inverse of the mass", IN(0, inverse_mass), INFINITY,
           "particle 0 has inverse mass [1/kg] inf");
    number("inverse mass 0 of a free particle", IN(0, inverse_mass), 0.0,
           "particle 0 has inverse mass [1/kg] 0");
    number("a negative inverse mass", IN(0, inverse_mass), -1.0, "particle 0 has inverse mass [1/kg] -1");
    number("another moment of inertia", IN(1, inverse_inertia), 1.0,
           "particle 1 has inverse moment of inertia [1/(kg m2)] 1");
    whole("a clump whose first id is below 0", IN(1, body), -1,
          "particle 1 has the first id of its clump -1");
    whole("a clump that begins behind its sphere", IN(1, body), 3,
          "particle 1 has the first id of its clump 3");
    number("a force that is not a number", of_particle(1, force), NAN, "particle 1 has force nan");
    number("an infinite torque", of_particle(1, force + 3*8), INFINITY, "particle 1 has torque inf");
    whole("an id below 0", IN(0, id), -1, "has id -1");
    whole("an id after which there is no other", IN(0, id), INT64_MAX, "has id 9.22337e+18");
    int64_t flags;

    memcpy(&flags, good + IN(0, material), sizeof flags);
    whole("unknown flags", IN(0, material), flags | 4 << 16, "particle 0 has flags 4");
    whole("driven, but not frozen", IN(0, material), flags | 2 << 16, "particle 0 has flags 2");
    whole("frozen, with inertia", IN(0, material), flags | 1 << 16, "particle 0 has inverse mass [1/kg]");
    const int64_t twin = 1;

    corrupt("a repeated id", IN(0, id), &twin, 0, "two of its particles have id 1");
}

static void other_contents(void)
{
    const struct dem_snapshot_header h = head();
    const size_t window = HEAD(window),
                 flow = HEAD(flow);
    int64_t name;

    TAP_OK(h.rows >= 2 && h.memories >= 3 && h.flows >= 1 && h.caller_data > MEANS,
           "it has contact history, flow counters and means");
    number("a history value that is not a number", of_row(0, sizeof(struct dem_contact_key)), NAN,
           "history shear_x nan");
    number("an infinite history value", of_row(1, sizeof(struct dem_contact_key) + 8), -INFINITY,
           "history shear_y -inf");
    whole("more steps than can be counted", HEAD(steps), INT64_MAX, "9223372036854775807 steps");
    whole("a window with more steps done than it has",
          window + offsetof(struct dem_snapshot_window, done), 5, "of which 5 are done");
    whole("a window of a negative number of steps",
          window + offsetof(struct dem_snapshot_window, ahead), INT64_MIN,
          "a window of -9223372036854775808 steps");
    number("an inserted mass that is not a number", flow + offsetof(struct dem_snapshot_flow, mass), NAN,
           "the flow record of rain is nan");
    number("an infinite mass due", flow + offsetof(struct dem_snapshot_flow, owed), INFINITY,
           "the flow record of rain is inf");
    memcpy(&name, "two\nway", sizeof name);
    whole("a name of two lines", flow, name, "or has invalid names");
    whole("a count below 0", flow + offsetof(struct dem_snapshot_flow, count), -1,
          "the flow record of rain has -1 particles");
    for (int k = 0; k < 2; k++)
    {
        const double value = k ? 1e300 : NAN;

        corrupt("a sum of means", of_means(), &value, 0,
              k ? "of its averages box is 1e+300" : "of its averages box is nan");
    }
    const int64_t samples = INT64_MAX;

    corrupt("more samples than can be counted", of_means() - 24, &samples, 0,
            "its averages have 9223372036854775807 samples");
    memcpy(bad, good, size);
    store(bad_path);
    TAP_OK(can_start() == 0, "the original snapshot is accepted");
}

/* The skin tuning is not part of the state: invalid values are ignored, and the run has the same
   bits as without. */
static void skin_tuning(void)
{
    uint64_t hash[2] = {0};

    for (int k = 0; k < 2; k++)
    {
        const double nothing = NAN;
        struct dem_case *const c = world_begin(scene);

        memcpy(bad, good, size);
        for (int at = 3; k && at < 7; at++)
        {
            memcpy(bad + offsetof(struct dem_snapshot_header, skin_tuning) + 8*(size_t)at,
                   &nothing, sizeof nothing);
        }
        store(bad_path);
        WORLD_TRY(dem_case_load(c, bad_path));
        struct dem *const d = world_start(c);
        world_run(d, 1e-4);
        hash[k] = world_hash(d);
        dem_free(d);
    }
    TAP_OK(hash[0] == hash[1], "skin tuning that is not a number is ignored: the same bits");
}

/* ---- for many ranks -------------------------------------------------------------------------- */

static int write_fault(const char *path, const char *slip)
{
    const struct dem_snapshot_header h = head();
    const int64_t last = h.particles - 1;
    const double fast = 1e30, none = NAN;

    memcpy(bad, good, size);
    if (strcmp(slip, "speed") == 0)
    {
        memcpy(bad + of_particle(last, offsetof(struct dem_particle, v)), &fast, 8);
    }
    else if (strcmp(slip, "force") == 0)
    {
        memcpy(bad + of_particle(last, sizeof(struct dem_particle)), &none, 8);
    }
    else if (strcmp(slip, "memory") == 0)
    {
        memcpy(bad + of_row(h.rows - 1, sizeof(struct dem_contact_key)), &none, 8);
    }
    else
    {
        memcpy(bad + of_particle(last, offsetof(struct dem_particle, id)),
               good + of_particle(0, offsetof(struct dem_particle, id)), 8);
    }
    store(path);
    return 0;
}

int main(int argc, char **argv)
{
    if (argc == 5 && strcmp(argv[1], "-spoil") == 0)
    {
        size = load(argv[2], good);
        return write_fault(argv[3], argv[4]);
    }
    TAP_TRAPS;
    if (!mkdtemp(folder))
    {
        world_end("mkdtemp");
    }
    snprintf(good_path, sizeof good_path, "%s/good.dem", folder);
    snprintf(bad_path, sizeof bad_path, "%s/bad.dem", folder);
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 1e-4);
    WORLD_TRY(dem_save(d, good_path));
    dem_free(d);
    size = load(good_path, good);
    particles();
    other_contents();
    skin_tuning();
    unlink(good_path);
    unlink(bad_path);
    TAP_OK(rmdir(folder) == 0, "the folder is removed");
    TAP_DONE;
}
