/*
 * test_averages.c -- means on a grid (solid fraction, velocity, granular temperature, stress,
 * particle scalars) have the values of closed forms, also across periodic faces.
 *
 * Sources: volume of a spherical cap; statics; kinetic theory of two streams.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include <unistd.h>

static const char material[] = "materials { glass { density 2500; youngsModulus 1e7; } }";
static char folder[] = "/tmp/averages.XXXXXX";

enum
{
    CELLS = 1000, NUMBERS = 32
};

static struct
{
    char name[NUMBERS][48];
    double value[CELLS][NUMBERS];
    int columns, rows;
} table;

static void read_table(struct dem *d, const char *name)
{
    char path[64], line[4096];
    FILE *f;

    WORLD_TRY(dem_averages(d, folder));
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    f = fopen(path, "r");
    table.rows = table.columns = 0;
    TAP_OK(f, "%s: a table", name);
    for (char *s = f && fgets(line, sizeof line, f) ? strtok(line, ",\n") : NULL; s;
         s = strtok(NULL, ",\n"))
    {
        snprintf(table.name[table.columns++], 48, "%.*s", (int)strcspn(s, "["), s);
    }
    while (f && fgets(line, sizeof line, f))
    {
        int k = 0;

        for (char *s = strtok(line, ",\n"); s; s = strtok(NULL, ",\n"))
        {
            table.value[table.rows][k++] = strtod(s, NULL);
        }
        table.rows++;
    }
    if (f)
    {
        fclose(f);
    }
    unlink(path);
    snprintf(path, sizeof path, "%s/%s.vti", folder, name);
    TAP_OK(unlink(path) == 0, "%s: %d cells, and an image", name, table.rows);
}

static double at(int row, const char *name)
{
    for (int k = 0; k < table.columns; k++)
    {
        if (strcmp(table.name[k], name) == 0)
        {
            return table.value[row][k];
        }
    }
    return NAN;
}

static double sum(const char *name)
{
    double s = 0.0;

    for (int r = 0; r < table.rows; r++)
    {
        s += at(r, name);
    }
    return s;
}

/* tables have nine digits */
static const double digits = 2e-9;

static void slab_volumes(void)
{
    const double R = 1e-3, V = 4.0/3.0*world_pi*R*R*R, z = 0.0013;
    const struct dem_new_particle seed[] = {
        {.position = {0.0, 0.0, z}, .diameter = 2.0*R, .id = 0, .material = "glass"}};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} } time { step 1e-6; }"
        "averages { slabs { min (-0.005 -0.005 -0.001); max (0.005 0.005 0.004); cells (1 1 10); "
        "interval 1e-6; }"
        "           all { min (-0.0027 -0.0031 -0.001); max (0.0053 0.0049 0.004); "
        "cells (10 10 10); interval 1e-6; } }",
        material), 1, seed);

    world_run(d, 3.5e-6);
    read_table(d, "slabs");
    for (int k = 0; k < 10; k++)
    {
        double cap[2];

        for (int side = 0; side < 2; side++)                  /* volume of the cap below a plane */
        {
            const double h = fmin(2.0*R, fmax(0.0, -0.001 + 5e-4*(k + side) - (z - R)));

            cap[side] = world_pi*h*h*(3.0*R - h)/3.0;
        }
        TAP_NEAR(at(k, "solidFraction"), (cap[1] - cap[0])/5e-8, digits,
                 "slab %d: volume between two planes", k);
    }
    TAP_NEAR(sum("bulkDensity"), 2500.0*V/5e-8, 2500.0*V/5e-8*digits, "mass of the slabs");
    read_table(d, "all");
    TAP_NEAR(sum("solidFraction")*3.2e-10, V, V*1e-7,
             "a thousand cells sum to the whole volume");     /* 9 digits of many small numbers */
    dem_free(d);
}

static void across_periodic_faces(void)
{
    const double R = 1e-3, V = 4.0/3.0*world_pi*R*R*R;
    const struct dem_new_particle seed[] = {
        {.position = {0.0002, 0.0098, 0.005}, .diameter = 2.0*R, .id = 0, .material = "glass"}};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} } time { step 1e-6; }"
        "domain { min (0 0 0); max (0.01 0.01 0.01); periodic (x y); }"
        "averages { all { min (0 0 0); max (0.01 0.01 0.01); cells (5 5 1); interval 1e-6; } }",
        material), 1, seed);

    world_run(d, 1e-6);
    read_table(d, "all");
    TAP_NEAR(sum("solidFraction")*4e-8, V, V*digits,
             "a sphere across two periodic faces: the whole volume");
    TAP_OK(at(0, "solidFraction") > 0.0 && at(4, "solidFraction") > 0.0 &&
               at(20, "solidFraction") > 0.0 && at(24, "solidFraction") > 0.0,
           "it is in the four corners of the box");
    dem_free(d);
}

/* One sphere and its images in one cell: the largest number of contributions that a sum can get. */
static void images(void)
{
    const double R = 1e-3, V = 4.0/3.0*world_pi*R*R*R;
    const struct dem_new_particle seed[] = {
        {.position = {0.005, 0.005, 0.005}, .diameter = 2.0*R, .id = 0, .material = "glass"}};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} } time { step 1e-6; }"
        "domain { min (0 0 0); max (0.01 0.01 0.01); periodic (x y z); }"
        "averages { all { min (-0.01 -0.01 -0.01); max (0.02 0.02 0.02); interval 1e-6; } }",
        material), 1, seed);

    world_run(d, 1e-6);
    read_table(d, "all");
    TAP_NEAR(sum("solidFraction")*2.7e-5, 27.0*V, 27.0*V*digits,
             "a sphere and 26 images in one cell: their volume");
    TAP_NEAR(sum("bulkDensity")*2.7e-5, 27.0*V*2500.0, 27.0*V*2500.0*digits, "and mass");
    dem_free(d);
}

/* two layers that slide past each other, apart */
static void streams(void)
{
    struct dem_new_particle seed[50];
    const double v[3] = {0.3, -0.2, 0.1}, R = 1e-3;
    char *const scene = world_text("%s effects { hertz {} } time { step 1e-5; }"
        "domain { min (0 0 0); max (0.02 0.02 0.02); periodic (x y z); }"
        "averages { box { min (0 0 0); max (0.02 0.02 0.02); interval 1e-4; } }", material);

    for (int k = 0; k < 50; k++)
    {
        const double side = k < 25 ? 1.0 : -1.0;

        seed[k] = (struct dem_new_particle){
            .position = {0.002 + 0.004*(k%5), 0.002 + 0.004*(k/5%5), k < 25 ? 0.006 : 0.014},
            .diameter = 2.0*R, .velocity = {side*v[0], side*v[1], 0.0}, .id = k,
            .material = "glass"};
    }
    struct dem *d = world(scene, 50, seed);
    const double rho = 50.0*2500.0*4.0/3.0*world_pi*R*R*R/8e-6;

    world_run(d, 1e-3);
    read_table(d, "box");
    TAP_NEAR(at(0, "velocityX"), 0.0, 1e-9, "two equal streams: mean velocity 0");
    TAP_NEAR(at(0, "temperature"), (v[0]*v[0] + v[1]*v[1])/3.0, 1e-9,
             "two equal streams: temperature");
    TAP_NEAR(at(0, "stressXX"), -rho*v[0]*v[0], rho*1e-9,
             "two equal streams: normal stress along x");
    TAP_NEAR(at(0, "stressXY"), -rho*v[0]*v[1], rho*1e-9, "two equal streams: shear stress");
    dem_free(d);

    for (int k = 0; k < 50; k++)
    {
        memcpy(seed[k].velocity, v, sizeof v);
    }
    d = world(scene, 50, seed);
    world_run(d, 1e-3);
    read_table(d, "box");
    TAP_NEAR(at(0, "velocityX"), v[0], 1e-9, "one stream: velocity x");
    TAP_NEAR(at(0, "velocityZ"), v[2], 1e-9, "one stream: velocity z");
    TAP_NEAR(at(0, "temperature"), 0.0, 1e-12, "one stream: temperature 0");
    TAP_NEAR(at(0, "stressXX"), 0.0, rho*1e-12, "one stream: stress 0");
    TAP_OK(at(0, "velocityX_ci95") < 1e-12, "one stream: 95 %% interval of width 0");
    dem_free(d);
}

/* n spheres on a floor under gravity: contact k carries the weight of those above it */
static void column(void)
{
    enum { HIGH = 5 };
    struct dem_new_particle seed[HIGH];
    const double R = 1e-3, g = 9.81, m = 2500.0*4.0/3.0*world_pi*R*R*R, volume = 0.004*0.004*0.012;
    char *const scene = world_text(
        "%s effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.1; } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "averages { box { min (-0.002 -0.002 0); max (0.002 0.002 0.012); start 0.2; "
        "interval 0.001; }"
        "           later { min (-0.002 -0.002 0); max (0.002 0.002 0.012); start 5; "
        "interval 0.001; } }",
        material);
    double expected = 0.0;

    for (int k = 0; k < HIGH; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {0.0, 0.0, R*(2*k + 1)}, .diameter = 2.0*R, .id = k, .material = "glass"};
    }
    struct dem *const d = world(scene, HIGH, seed);

    world_run(d, 0.25);
    for (int k = 0; k < HIGH;
         /* the branch from the contact below to the centre, and the half above */
         k++)
    {
        const struct world_particle q = world_at(d, k), below = world_at(d, k ? k - 1 : 0);

        expected -= (HIGH - k)*m*g*(k ? q.x[2] - below.x[2] : q.x[2]);
    }
    read_table(d, "box");
    /* the bounce has decayed to 1e-5 of the weight */
    TAP_NEAR(at(0, "stressZZ"), expected/volume, 1e-5*fabs(expected)/volume,
             "column: sum of forces times branches");
    TAP_NEAR(at(0, "stressXX"), 0.0, 1e-9*fabs(expected)/volume, "column: no stress across");
    WORLD_TRY(dem_averages(d, folder));
    TAP_OK(access(strcat(strcpy((char[64]){0}, folder), "/later.csv"), F_OK) != 0,
           "no samples: no file is written");
    unlink(strcat(strcpy((char[64]){0}, folder), "/box.csv"));
    unlink(strcat(strcpy((char[64]){0}, folder), "/box.vti"));
    dem_free(d);
}

/* A sphere slides on a wall across axis k, friction mu N at the lever R - d: shear stress in both
   planes that hold k. */
static void wall_friction(int k)
{
    static const char *const shear[3] = {"stressXY", "stressYZ", "stressZX"};
    const double R = 1e-3, g = 9.81, mu = 0.3, stiffness = 1000.0,
                 m = 2500.0*4.0/3.0*world_pi*R*R*R, d = m*g/stiffness,
                 volume = 8e-6;
    const int next = (k + 1)%3, last = (k + 2)%3;
    double up[3] = {0.0};
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass"};

    up[k] = 1.0;
    seed.position[k] = R - d;
    seed.velocity[next] = 0.8;
    seed.velocity[last] = -0.6;
    struct dem *const w = world(world_text(
        "%s effects { gravity { acceleration (%g %g %g); } hooke { stiffness %g; } "
        "linear { friction %g; stiffness 1000; } }"
        "walls { floor { type plane; point (0 0 0); normal (%g %g %g); } }"
        "averages { box { min (-0.01 -0.01 -0.01); max (0.01 0.01 0.01); start 0.001; "
        "interval 0.0005; } }",
        material, -g*up[0], -g*up[1], -g*up[2], stiffness, mu, up[0], up[1], up[2]), 1, &seed);
    const double push =
        (R - d)*m*g/
        /* Pa: of the weight; friction lies against the velocity (0.8, -0.6) */
        volume;

    world_run(w, 0.005);
    read_table(w, "box");
    /* half of force times branch, as the tensor is made symmetric; 1e-4: the spin changes the
       direction meanwhile */
    TAP_NEAR(at(0, shear[k]), 0.5*push*mu*0.8, 1e-4*push,
             "friction on a wall across axis %d: %s", k, shear[k]);
    TAP_NEAR(at(0, shear[last]), -0.5*push*mu*0.6, 1e-4*push, "and %s", shear[last]);
    TAP_NEAR(at(0, shear[next]), 0.0, 1e-2*push,
             "none in the plane of the wall");     /* velocities change by 0.01 m/s: m/V dv dv */
    dem_free(w);
}

static void set_scalar(struct dem *d, const char *name, const double *value, size_t n)
{
    const int64_t *id;
    double *const all = dem_scalar(d, dem_scalar_index(d, name));
    struct dem_view v;

    dem_view(d, &v);
    TAP_OK(all && v.n == n, "%s: a scalar of %zu particles", name, n);
    id = v.id;
    for (size_t k = 0; k < v.n; k++, id = (const int64_t *)((const char *)id + v.stride))
    {
        all[k] = value[*id];
    }
}

static int columns_named(const char *name)
{
    int found = 0;

    for (int k = 0; k < table.columns; k++)
    {
        found += strcmp(table.name[k], name) == 0;
    }
    return found;
}

/* Three spheres, two of steel and one of wax; the first is cut in half by the face of the two lower cells, the second
   is whole in cell 1, the third as well. Cell 2 is empty. */
static void scalars(void)
{
    enum { N = 3 };
    const double d[N] = {2e-3, 3e-3, 4e-3}, rho[N] = {7800.0, 7800.0, 900.0}, c[N] = {464.0, 464.0, 2100.0},
                 z[N] = {0.01, 0.013, 0.017}, later[N] = {450.0, 310.0, 280.0};
    const double T[N] = {400.0, 300.0, 350.0}, L[N] = {1e-12, 5e-12, 3e-12};
    double heat[2][2] = {{0.0}}, amount[2] = {0.0}, number[2] = {0.0};
    struct dem_new_particle seed[N];
    char *const scene = world_text(
        "materials { steel { density 7800; youngsModulus 1e7; conductivity 42; heatCapacity 464; }"
        "            wax { density 900; youngsModulus 1e7; conductivity 0.3; heatCapacity 2100; } }"
        "effects { hertz {} conduction {} liquidBridge { surfaceTension 0.07; contactAngle 0; } }"
        "time { step 1e-6; }"
        "averages { box { min (-0.005 -0.005 0); max (0.005 0.005 0.03); cells (1 1 3); interval 1e-6; } }");

    for (int k = 0; k < N; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {0.0, 0.0, z[k]}, .diameter = d[k], .id = k,
            .material = k < 2 ? "steel" : "wax"};
        for (int cell = 0; cell < 2; cell++)
        {
            const double part = k ? (double)cell : 0.5, C = part*rho[k]*world_pi/6.0*d[k]*d[k]*d[k]*c[k];

            heat[cell][0] += C;
            heat[cell][1] += C*(0.75*T[k] + 0.25*later[k]);
            amount[cell] += part*L[k];
            number[cell] += part;
        }
    }
    struct dem *const w = world(scene, N, seed);

    set_scalar(w, "temperature", T, N);
    set_scalar(w, "liquidVolume", L, N);
    world_run(w, 6e-6);
    set_scalar(w, "temperature", later, N);
    world_run(w, 2e-6);
    read_table(w, "box");
    TAP_NEAR(at(0, "particleTemperature"), heat[0][1]/heat[0][0], 400.0*digits, "cell of one half sphere: its temperature");
    TAP_NEAR(at(1, "particleTemperature"), heat[1][1]/heat[1][0], 400.0*digits, "cell of 2.5 spheres: the mixed temperature");
    TAP_NEAR(at(1, "liquidVolume"), amount[1]/number[1], 5e-12*digits, "an amount: mean per particle");
    TAP_NEAR(at(0, "liquidVolume"), 1e-12, 1e-12*digits, "and of the half sphere alone");
    TAP_OK(at(2, "particleTemperature") == 0.0 && at(2, "liquidVolume") == 0.0, "0 in an empty cell");
    TAP_OK(at(1, "particleTemperature_ci95") > 0.0 && at(1, "temperature") < 1e-12 && at(1, "liquidVolume_ci95") < 1e-20,
           "an interval where it changed in time; granular temperature beside it");
    TAP_OK(columns_named("temperature") == 1 && columns_named("particleTemperature") == 1, "each name once");
    dem_free(w);
}

/* A scalar without a capacity: the fluid's temperature at the particles, and the ratio of parcels. */
static void scalars_by_mass(void)
{
    struct dem_new_particle seed[2];
    const double d[2] = {1e-3, 2e-3}, T[2] = {300.0, 390.0}, m[2] = {1.0, 8.0};
    char *scene = world_text(
        "materials { glass { density 2500; youngsModulus 1e7; conductivity 1; heatCapacity 800; } }"
        "effects { hertz {} gidaspow {} gunn {} pressureGradient {} } time { step 1e-6; }"
        "fluid { density 1.2; viscosity 1.8e-5; velocity (0 0 0); temperature 300; conductivity 0.026; heatCapacity 1007; }"
        "averages { box { min (-0.005 -0.005 0); max (0.005 0.005 0.03); interval 1e-6; } }");

    for (int k = 0; k < 2; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {0.0, 0.0, 0.01 + 0.01*k}, .diameter = d[k], .id = k, .material = "glass"};
    }
    struct dem *w = world(scene, 2, seed);

    set_scalar(w, "fluidTemperature", T, 2);
    world_run(w, 2e-6);
    read_table(w, "box");
    TAP_NEAR(at(0, "fluidTemperature"), (m[0]*T[0] + m[1]*T[1])/9.0, 400.0*digits, "without a capacity: by mass");
    TAP_OK(columns_named("fluidConductivity") == 0, "a scalar that is not written has no mean");
    dem_free(w);

    scene = world_text(
        "%s effects { hertz {} } parcels { ratio 2; }"
        "insert { two { type list; diameters (1e-3 2e-3); parcelRatios (3 1.5); positions ((0 0 0.01) (0 0 0.02)); } }"
        "time { step 1e-6; } averages { box { min (-0.005 -0.005 0); max (0.005 0.005 0.03); interval 1e-6; } }",
        material);
    w = world(scene, 0, NULL);
    world_run(w, 2e-6);
    read_table(w, "box");
    TAP_NEAR(at(0, "parcelRatio"), 2.25, 3.0*digits, "ratio of two parcels of one mass");
    dem_free(w);
}

/* ---- clumps ---------------------------------------------------------------------------------- */

/* A bed of clumps at rest between two planes, without weight and friction: the mean stress over its room is minus force times
   height over volume, with branches from the centres of the clumps only. Sides at rest carry theirs likewise. */
static void clumps(void)
{
    static const double side = 6.6e-3, F = 0.02;
    struct dem *const d = world(world_text(
        "%s effects { hertz {} dry { restitution 0.1; } } "
        "shapes { nut { spheres ((0 0 0 0.5e-3) (0.6e-3 0 0 0.4e-3) (0.9e-3 0.4e-3 0 0.3e-3)); } } "
        "walls { box { type box; min (0 0 0); max (%g %g 20e-3); } lid { type plane; point (0 0 9e-3); normal (0 0 -1); "
        "motion { type servo; force %g; maxSpeed 0.3; } } } "
        "insert { nuts { type lattice; shape nut; count 30; spacing 1.02; min (0 0 0); max (%g %g 8.9e-3); seed 3; } } "
        "averages { room { min (-0.001 -0.001 -0.001); max (0.007 0.007 0.011); start 0.3; interval 1; } } ",
        material, side, side, F, side, side), 0, NULL);
    double force[3], torque[3], mass = 0.0, lowest, height;
    struct dem_wall_position lid;
    const double room = 8e-3*8e-3*12e-3;

    world_run(d, 0.3);
    read_table(d, "room");
    for (int64_t id = 0; id < 90; id++)
    {
        mass += world_at(d, id).mass;
    }
    TAP_NEAR(at(0, "solidFraction")*room*2500.0/mass, 1.0, digits, "clumps: their volumes");
    TAP_NEAR(at(0, "bulkDensity")*room/mass, 1.0, digits, "and masses");
    WORLD_TRY(dem_wall_load(d, 6, force, torque));
    dem_wall_position(d, 6, &lid);
    height = 9e-3 + lid.shift[2];
    TAP_OK(force[2] > 0.9*F, "they carry %g N", force[2]);
    TAP_NEAR(at(0, "stressZZ")*room/(-force[2]*height), 1.0, 1e-3, "the mean stress is force times height");
    lowest = 0.0;
    for (int wall = 0; wall < 6; wall++)
    {
        WORLD_TRY(dem_wall_load(d, wall, force, torque));
        lowest += strstr(dem_wall_name(d, wall), "boxMaxX") ? force[0]*side : 0.0;
    }
    TAP_NEAR(at(0, "stressXX")*room/-lowest, 1.0, 1e-2, "and across likewise");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    if (!mkdtemp(folder))
    {
        printf("Bail out! no folder in /tmp\n");
        return 1;
    }
    slab_volumes();
    across_periodic_faces();
    images();
    streams();
    column();
    for (int k = 0; k < 3; k++)
    {
        wall_friction(k);
    }
    scalars();
    scalars_by_mass();
    clumps();
    rmdir(folder);
    TAP_DONE;
}
