/*
 * test_wall_mass.c -- a free wall that is too light for the time step is named before the run, with the mass that a
 * run accepts.
 *
 * - One sphere hits a plate at impactSpeed: a run with the mass that the warning asks for passes, one with 0.95 of it
 *   ends at the limit of the step.
 * - One sphere hits the end of a flap on a hinge, and of a plate that rotates freely, with inertia in place of mass.
 * - A plate is pressed on a layer of spheres: the warning counts those that fit, and 0.95 of its mass is too little.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    SIDE = 5
};

static const double R = 0.5e-3, step = 2e-6, speed = 0.5;

/* n x n spheres on a floor that move up at `speed`, below a plate. */
static struct dem *plate_above(int n, double up, double mass, double force)
{
    struct dem_new_particle seed[SIDE*SIDE];
    const double side = 2.0*n*R, z = 2.0*R;

    for (int k = 0; k < n*n; k++)
    {
        seed[k] = (struct dem_new_particle){.diameter = 2.0*R, .material = "glass", .id = k, .velocity = {0.0, 0.0, up},
                                            .position = {(2*(k%n) + 1)*R, (2*(k/n) + 1)*R, R}};
    }
    return world(world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
                            "effects { hertz { impactSpeed %g; } } walls { floor { type plane; point (0 0 0); "
                            "normal (0 0 1); } lid { type triangles; corners ((0 0 %g) (%g 0 %g) (%g %g %g) (0 0 %g) "
                            "(%g %g %g) (0 %g %g)); motion { type free; axes (z); mass %.17g; force (0 0 %.17g); } } } "
                            "time { step %g; }", speed, z, side, z, side, side, z, z, side, side, z, side, z, mass, -force,
                            step), n*n, seed);
}

/* The mass that the list of warnings asks for [kg]; 0: the wall is not in it. */
static double wanted(struct dem *d, const char *words)
{
    const struct dem_run_info run = {.duration = 1.0};
    const char *text;

    WORLD_TRY(dem_warnings(d, &run, 0, NULL, &text));
    const char *const at = strstr(text, "walls/lid/motion: "), *const mass = at ? strstr(at, "at least ") : NULL;

    if (!mass)
    {
        return 0.0;
    }
    TAP_OK(strstr(at, words) != NULL, "warned: %.*s", (int)strcspn(at, "\n"), at);
    return atof(mass + strlen("at least "));
}

/* 1 if a run of 300 steps passes, 0 when it ends at the limit of the mass. */
static int passes(int n, double up, double mass, double force)
{
    struct dem *const d = plate_above(n, up, mass, force);
    int status = DEM_OK;

    for (int k = 0; k < 300 && !status; k++)
    {
        status = dem_advance(d, step);
    }
    const int light = status == DEM_ERROR_NUMBER && strstr(dem_error_text(), "wall lid") != NULL;

    TAP_OK(!status || light, "%.3g kg: %s", mass, status ? dem_error_text() : "passes");
    dem_free(d);
    return !status;
}

/* A triangle from an edge along y at x = 0 to its tip at x = 0.1 m, where a sphere hits it at `speed`. */
static struct dem *struck(const char *motion, double inertia)
{
    const struct dem_new_particle ball = {.diameter = 2.0*R, .material = "glass", .position = {0.1, 0.0, -1.001*R},
                                          .velocity = {0.0, 0.0, speed}};

    return world(world_text("materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } "
                            "effects { hertz { impactSpeed %g; } } walls { lid { type triangles; corners ((0 -0.05 0) "
                            "(0 0.05 0) (0.1 0 0)); motion { %s inertia %s%.17g%s; } } } time { step %g; }",
                            speed, motion, strstr(motion, "free") ? "(1 " : "", inertia,
                            strstr(motion, "free") ? " 1)" : "", step), 1, &ball);
}

static void inertia_is_named(const char *motion)
{
    struct dem *d = struck(motion, 1e-12);
    const double least = wanted(d, "the impact of one particle at impactSpeed, 0.5 m/s, meets");

    dem_free(d);
    for (int light = 0; light < 2; light++)
    {
        d = struck(motion, (light ? 0.95 : 1.01)*least);
        int status = DEM_OK;

        TAP_OK(light || wanted(d, "") == 0.0, "%g kg m2 are enough: no warning", least);
        for (int k = 0; k < 300 && !status; k++)
        {
            status = dem_advance(d, step);
        }
        TAP_OK(least > 0.0 && (light ? status && strstr(dem_error_text(), "kg m2 on contacts") : !status), "%s: %s",
               light ? "0.95 of it ends the run" : "and with it the run passes", status ? dem_error_text() : "");
        dem_free(d);
    }
}

static void is_named(int n, double up, double force, const char *words)
{
    struct dem *d = plate_above(n, up, 1e-9, force);
    const double least = wanted(d, words);

    dem_free(d);
    d = plate_above(n, up, 1.01*least, force);
    TAP_OK(least > 0.0 && wanted(d, "") == 0.0, "%g kg are enough: no warning", least);
    dem_free(d);
    TAP_OK(!passes(n, up, 0.95*least, force), "0.95 of it ends the run");
    if (n == 1)    /* the pressed plate: only the failing side */
    {
        TAP_OK(passes(n, up, 1.01*least, force), "and with it the run passes");
    }
}

int main(void)
{
    is_named(1, speed, 0.0, "the impact of one particle at impactSpeed, 0.5 m/s, meets");
    is_named(SIDE, 0.0, 0.5, "its load, 0.5 N on 25 contacts");
    inertia_is_named("type hinge; origin (0 0 0); axis (0 1 0);");
    inertia_is_named("type free; rotations (y); centre (0 0 0); mass 1;");
    TAP_DONE;
}
