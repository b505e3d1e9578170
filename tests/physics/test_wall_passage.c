/*
 * test_wall_passage.c -- a wall with two sides that passes through a particle ends the run, as a
 * plane does. An impact at v overlaps by (5/4 m v^2/(4/3 E* sqrt R))^(2/5): at 50 m/s by 0.9 of a
 * diameter, at 10 by a quarter.
 *
 * Source: Johnson, Contact Mechanics (1985), section 11.4.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double R = 5e-4;

#define SHEET(z) "type triangles; corners ((-0.01 -0.01 " z ")(0.01 -0.01 " z ")(-0.01 0.01 " z ")" \
                 "(0.01 -0.01 " z ")(0.01 0.01 " z ")(-0.01 0.01 " z "));"
#define PLANE "type plane; point (0 0 0); normal (0 0 1);"
#define UP(speed) " motion { type translation; velocity (0 0 " speed "); }"

static struct dem *begin(const char *walls, const char *time, const double x[3], double v)
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "a", .velocity = {0.0, 0.0, v}};
    char *const scene = world_text("materials { a { density 2500; youngsModulus 1e7; } } "
                                   "effects { hertz {} dry { restitution 0.9; } } "
                                   "walls { %s } time { step 5e-6; %s }", walls, time);

    memcpy(seed.position, x, sizeof seed.position);
    return world(scene, 1, &seed);
}

static const double above[3] = {1e-4, 2e-4, 1.02*5e-4};

/* 1 ms; `words`: of the sentence that ends the run, NULL: it does not end */
static void run(const char *walls, const char *time, const double x[3], double v,
                const char *words, const char *what)
{
    struct dem *const d = begin(walls, time, x, v);
    const int status = dem_advance(d, 1e-3);

    TAP_OK((status != DEM_OK) == (words != NULL), "%s: %s", what, words ? "ends" : "continues");
    if (words)
    {
        TAP_OK(status && strstr(dem_error_text(), words), "%s: says %s", what, words);
    }
    dem_free(d);
}

/* A sheet that the program moves by 1 mm in windows of 20 us: 50 m/s. */
static void follows(void)
{
    double corner[18] = {-0.01, -0.01, 0.0, 0.01,  -0.01, 0.0, -0.01, 0.01, 0.0,
                         0.01,  -0.01, 0.0, 0.01, 0.01,  0.0, -0.01, 0.01, 0.0};
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "a"};
    struct dem_case *const made = world_begin("materials { a { density 2500; youngsModulus 1e7; } } "
                                      "effects { hertz {} dry { restitution 0.9; } } "
                                      "time { step 5e-6; }");
    int status = DEM_OK;

    memcpy(seed.position, above, sizeof seed.position);
    WORLD_TRY(dem_case_add_wall(made, "sheet", "a", 2, corner));
    WORLD_TRY(dem_case_add_particles(made, 1, &seed));
    struct dem *const d = world_start(made);
    for (int k = 0; k < 10 && !status; k++)
    {
        for (int c = 2; c < 18; c += 3)
        {
            corner[c] += 1e-3;
        }
        status = dem_wall_move(d, "sheet", 2, corner);
        status = status ? status : dem_advance(d, 2e-5);
    }
    TAP_OK(status && strstr(dem_error_text(), "half of a diameter"),
           "a sheet that the program moves: ends");
    dem_free(d);
}

int main(void)
{
    static const char half[] = "half of a diameter";
    const double between[3] = {0.0, 0.0, 6e-4}, far[3] = {0.0, 0.0, 2.1e-3},
                 tip[3] = {5e-3, 0.0, 6e-4}, rim[3] = {0.0101, 0.0, 4.99e-4};

    TAP_TRAPS;
    run("w { " PLANE UP("10") " }", "", above, 0.0, NULL, "a plane at 10 m/s");
    run("w { " SHEET("0") UP("10") " }", "", above, 0.0, NULL, "triangles at 10 m/s");
    run("w { " PLANE UP("50") " }", "", above, 0.0, "limit is 0.5", "a plane at 50 m/s");
    run("w { " SHEET("0") UP("50") " }", "", above, 0.0, half, "triangles at 50 m/s");
    run("w { " SHEET("0") " }", "", above, -50.0, half, "a sphere at 50 m/s on triangles");
    run("w { " SHEET("0") " motion { type rotation; origin (-0.045 0 0); axis (0 -1 0); "
        "omega 1e3; } }", "", tip, 0.0, half, "a paddle with a blade at 50 m/s there");
    run("w { type cylinder; point (0 0 0); axis (0 1 0); radius 1e-4; particles outside;"
        UP("50") " }", "", between, 0.0, half, "a wire at 50 m/s");
    run("low { " SHEET("0") UP("20") " } high { " SHEET("0.0012") UP("-20") " }", "", between, 0.0,
        half, "two sheets that close");
    run("w { " SHEET("0") UP("50") " }", "maxOverlap 1;", above, 0.0, NULL,
        "a larger maxOverlap");
    run("w { " SHEET("0") UP("90") " }", "", far, -90.0, "limit of the sum",
        "both at 0.9 radii a step");
    run("w { " SHEET("0") " }", "", rim, -0.5, NULL, "past the rim of a sheet");
    follows();
    TAP_DONE;
}
