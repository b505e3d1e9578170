/*
 * test_table.c -- particles from tables, and large ids.
 *
 * - Particles have the positions and other columns of their rows, in any order of columns and with
 *   any separators.
 * - A missing row, column or number is refused with file, line and text, a zero byte with file and
 *   line.
 * - Ids beyond 2^31 and 2^53 are exact: from a table, a list and the caller, in lists of bonds, in
 *   the view and through a snapshot; ids are unique.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include <unistd.h>

#define START "materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz {} "

static char path[] = "/tmp/suna_table_XXXXXX";

static void write_table(const char *rows)
{
    FILE *const f = fopen(path, "w");

    if (f)
    {
        fputs(rows, f);
        fclose(f);
    }
    TAP_OK(f != NULL || !rows, "a table is written");
}

static struct dem_case *from_table(const char *rows, const char *entries)
{
    char *const text =
        world_text(START "} insert { t { type table; file \"%s\"; %s } }", path, entries);
    write_table(rows);
    struct dem_case *const c = world_begin(text);

    return c;
}

static void refused(const char *rows, const char *entries, const char *first, const char *second)
{
    struct dem_case *const c = from_table(rows, entries);
    const int status = dem_case_check(c);

    TAP_OK(status && strstr(dem_error_text(), first) && strstr(dem_error_text(), second),
           "refused, names \"%s\" and \"%s\"", first, second);
    if (status)
    {
        TAP_NOTE("%s", dem_error_text());
    }
    dem_case_free(c);
}

static void test_rows(void)
{
    struct dem *d = world_start(from_table(
        "# made by hand\n\n z; y;x ,diameter  wx,wy,wz\tvx vy vz\r\n0.3;0.2 "
        "0.1,2e-3,1,2,3,4,5,6\n\n#\n  3,2,1  1e-3;0;0;0;0;0;-1e0\n",
        ""));
    const struct world_particle a = world_at(d, 0), b = world_at(d, 1);

    TAP_OK(a.x[0] == 0.1 && a.x[1] == 0.2 && a.x[2] == 0.3 && a.radius == 1e-3,
           "columns in any order, any separators");
    TAP_OK(a.v[0] == 4.0 && a.v[1] == 5.0 && a.v[2] == 6.0 && a.w[0] == 1.0 && a.w[1] == 2.0 &&
               a.w[2] == 3.0,
           "velocities and spins");
    TAP_OK(b.x[0] == 1.0 && b.x[2] == 3.0 && b.v[2] == -1.0 && b.radius == 5e-4,
           "the last row is read");
    dem_free(d);
    d = world_start(from_table("x[m],y[m],z[m]\n0,0,0\n0,0,1",
                               "diameter 1e-3; velocity (0 0 7); frozen no;"));
    TAP_OK(world_at(d, 1).x[2] == 1.0 && world_at(d, 1).v[2] == 7.0 &&
               world_at(d, 1).radius == 5e-4,
           "values without a column come from the scene");
    dem_free(d);
}

static void test_faults(void)
{
    const char *const one = "diameter 1e-3;";

    refused("", one, path, "no row");
    refused("x,y,z\n", one, path, "no row");
    refused("0,0,0\n", one, "line 1", "column");
    refused("x,y,z,radius\n0,0,0,1\n", one, "line 1", "radius");
    refused("x,y,z,x\n0,0,0,1\n", one, "line 1", "twice");
    refused("x,z\n0,0\n", one, "line 1", "x, y, z");
    refused("x,y,z,vx\n0,0,0,0\n", one, "vx", "vy");
    refused("x,y,z\n0,0,0\n0,0\n", one, "line 3", "3 numbers");
    refused("x,y,z\n0,0,0,0\n", one, "line 2", "\"0,0,0,0\"");
    refused("x,y,z\n0,,0\n", one, "line 2", "\"0,,0\"");
    refused("x,y,z\n0,0,zero\n", one, "line 2", "zero");
    refused("x,y,z\n0,0,1e999\n", one, "line 2", "1e999");
    refused("x,y,z\n0,0,nan\n", one, "line 2", "nan");
    refused("x,y,z\n0,0,0\n", "", "needs", "diameter");
    refused("x,y,z,diameter\n0,0,0,1\n0,0,3,-1\n", "", "number 2", "-1");
    refused("id,x,y,z\n1.5,0,0,0\n", one, "line 2", "1.5");
    refused("id,x,y,z\n-1,0,0,0\n", one, "number 1", "-1");
    refused("id,x,y,z\n9223372036854775807,0,0,0\n", one, "9223372036854775807",
            "9223372036854775806");
    refused("id,x,y,z\n9223372036854775808,0,0,0\n", one, "line 2", "9223372036854775808");
    refused("id,x,y,z\n9007199254740993,0,0,0\n9007199254740993,0,0,1\n", one, "two particles",
            "9007199254740993");
}

/* A zero byte ends a string: the text after it must not be ignored silently. */
static void test_zero(void)
{
    static const char rows[] = "x,y,z\n0,0,0\n0,0,1\0\n0,0,2\n", sizes[] = "1e-3 1\n2e-3\0 1\n";
    const char *const scene = START "} insert { t { type %s; %s } }";

    for (int k = 0; k < 2; k++)
    {
        FILE *const f = fopen(path, "wb");
        char *const file = world_text("file \"%s\"; diameter 1e-3;", path);
        char *const table =
            world_text("count 2; min (0 0 0); max (1 1 1); sizes { type table; file \"%s\"; }",
                       path);
        char *const text = world_text(scene, k ? "random" : "table", k ? table : file);

        if (f)
        {
            fwrite(k ? sizes : rows, 1, k ? sizeof sizes - 1 : sizeof rows - 1, f);
            fclose(f);
        }
        struct dem_case *const c = world_begin(text);
        const int status = dem_case_check(c);

        TAP_OK(status && strstr(dem_error_text(), path) &&
                   strstr(dem_error_text(),
                          k ? "line 2: found a zero byte" : "line 3: found a zero byte"),
               "%s: %s", k ? "sizes" : "rows", status ? dem_error_text() : "taken");
        dem_case_free(c);
    }
}

/* 2^32 + 5; 2^53 + 1, which a double cannot represent; the largest id */
#define FIRST "4294967301"
#define SECOND "9007199254740993"
#define LAST "9223372036854775806"

static void are_there(struct dem *d, const char *where)
{
    TAP_OK(world_at(d, 4294967301).x[2] == 0.1 && world_at(d, 9007199254740993).x[2] == 0.101,
           "%s: ids past 2^31 and 2^53", where);
    TAP_OK(world_at(d, 9007199254740994).x[2] == 0.2, "%s: the next free id", where);
}

static void test_ids(void)
{
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, 0.2}, .diameter = 1e-3, .id = -1, .material = "glass"};
    const char *const scene = START
        "bondLinear { normalStiffness 1e9; shearStiffness 1e9; make listed; makeDistance 1.1; "
        "breakDistance 1.2; } }"
        "insert { l { type list; diameter 1e-3; ids (" FIRST " " SECOND
        "); positions ((0 0 0.1) (0 0 0.101)); } }"
        "bonds { pairs (" SECOND " " FIRST "); }";
    struct dem_case *c = world_begin(scene);
    const struct dem_bond *bond;
    int64_t bonds;

    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *d = world_start(c);
    are_there(d, "a list and the program");
    WORLD_TRY(dem_bonds(d, &bonds, &bond));
    TAP_OK(bonds == 1 && bond[0].id[0] == 4294967301 && bond[0].id[1] == 9007199254740993,
           "a bond between them");
    WORLD_TRY(dem_save(d, path));
    const uint64_t hash = world_hash(d);

    dem_free(d);
    c = world_begin(
        START
        "bondLinear { normalStiffness 1e9; shearStiffness 1e9; make once; makeDistance 1.1; "
        "breakDistance 1.2; } }");
    WORLD_TRY(dem_case_load(c, path));
    d = world_start(c);
    are_there(d, "a snapshot");
    TAP_OK(world_hash(d) == hash, "a snapshot: the same bits");
    dem_free(d);
    d = world_start(from_table("id,x,y,z\n" SECOND ",0,0,0.101\n" FIRST
                   ",0,0,0.1\n9007199254740994,0,0,0.2\n" LAST ",0,0,0.3\n",
                   "diameter 1e-3;"));
    are_there(d, "a table");
    TAP_OK(world_at(d, INT64_MAX - 1).x[2] == 0.3, "a table: the largest id");
    dem_free(d);
}

/* ids of the scene and of the caller together */
static void test_repeated_ids(void)
{
    const char *const scene =
        START "} insert { a { type list; diameter 1e-3; ids (7 5); positions ((0 0 0) (0 0 1)); }"
              "b { type list; diameter 1e-3; positions ((0 1 0) (0 1 1)); } }";
    struct dem_new_particle seed = {
        .position = {0.0, 0.0, 0.5}, .diameter = 1e-3, .material = "glass"};

    for (int64_t id = 4; id <= 10; id++)
    {
        struct dem_case *const c = world_begin(scene);
        const int taken = id == 5 || (id >= 7 && id <= 9);

        seed.id = id;
        WORLD_TRY(dem_case_add_particles(c, 1, &seed));
        TAP_OK((world_status(c) != 0) == taken &&
                   (!taken || strstr(dem_error_text(), "two particles")),
               "id %d is %s", (int)id, taken ? "refused" : "accepted");
    }
    struct dem_case *const c = world_begin(
        START "} insert { b { type list; diameter 1e-3; positions ((0 1 0) (0 1 1)); }"
              "a { type list; diameter 1e-3; ids (1 5); positions ((0 0 0) (0 0 1)); } }");

    TAP_OK(dem_case_check(c) && strstr(dem_error_text(), "id 1"), "an id of a group before");
    dem_case_free(c);
}

int main(void)
{
    const int file = mkstemp(path);

    TAP_TRAPS;
    if (file >= 0)
    {
        close(file);
    }
    test_rows();
    test_faults();
    test_zero();
    test_ids();
    test_repeated_ids();
    remove(path);
    TAP_DONE;
}
