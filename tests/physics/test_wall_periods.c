/*
 * test_wall_periods.c -- the step that the core chooses resolves walls that oscillate or rotate
 * fast; the run warns of walls faster than impactSpeed before it starts.
 *
 * A sphere lies on a spring with a dashpot (hooke, dry) on a wall that shakes by A sin(w t). In the
 * steady state the wall does the work per time
 *
 *   P = c w^2 A^2/2 m^2 w^4/((k - m w^2)^2 + c^2 w^2)
 *
 * - The automatic step gives P within 1 % at three and ten times the natural frequency, and the
 *   energy balance closes within 1 % of the work.
 * - The limit names the wall, is 1/60 of the period of an oscillation and 1/360 of a revolution,
 *   and bounds a given step. Slow motions, translations, and motions that ended before the run set
 *   no limit.
 * - The warnings name a wall with a normal speed that makes impacts overlap by more than 5 %, but
 *   not a floor that slides in its plane or a drum that rotates about its axis.
 * - A scene with walls and driven particles, which do not feel them, is warned about.
 *
 * Source: the driven linear oscillator.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

static const double R = 5e-4, density = 2500.0, k = 1000.0, amplitude = 4e-9, g = 9.81;

static char *scene_of(const char *wall, const char *more)
{
    return world_text("materials { a { density 2500; youngsModulus 1e7; } } "
                      "effects { gravity { acceleration (0 0 -9.81); } hooke { stiffness %g; }"
                      " dry { restitution 0.7; } } walls { w { %s } } %s", k, wall, more);
}

static void shaken(double times, const char *what)
{
    const double m = world_sphere_mass(R, density), w0 = sqrt(k/m), w = times*w0,
                 l = log(0.7), c = 2.0*sqrt(k*m)*-l/sqrt(world_pi*world_pi + l*l),
                 stiff = k - m*w*w, damp = c*w, period = 2.0*world_pi/w,
                 power = 0.5*c*pow(w*amplitude*m*w*w, 2.0)/(stiff*stiff + damp*damp);
    const struct dem_new_particle seed = {
        .diameter = 2.0*R, .material = "a", .position = {0.0, 0.0, R - m*g/k}};
    char *const wall = world_text("type plane; point (0 0 0); normal (0 0 1); motion { type"
                                  " oscillation; amplitude (0 0 %g); frequency %.17g; }",
                                  amplitude, w/(2.0*world_pi));
    char *const scene = scene_of(wall, "");
    struct dem *const d = energy_world(scene, 1, &seed);
    const struct dem_step_limit step = dem_step_limit(d);

    TAP_OK(strstr(step.why, "1/60 of the period of wall w") != NULL, "%s: the limit is named",
           what);
    TAP_NEAR(step.used*60.0, period, 1e-9*period, "%s: a sixtieth of the period", what);
    world_run(d, 100.0/w0);          /* the start has died away to exp(-11) */
    const double work = energy_term(d, "work_walls"), residual = energy_term(d, "residual");

    world_run(d, 200.0*period);
    TAP_NEAR((energy_term(d, "work_walls") - work)/(200.0*period*power), 1.0, 0.01,
             "%s: power of the wall", what);
    TAP_NEAR((energy_term(d, "residual") - residual)/(200.0*period*power), 0.0, 0.01,
             "%s: the energy balance closes", what);
    dem_free(d);
}

/* The limit of the step with this wall has the name of the wall (1), or not. */
static void bounds(const char *wall, int named, const char *what)
{
    const struct dem_new_particle seed = {
        .diameter = 2.0*R, .material = "a", .position = {0.0, 0.0, R}};
    char *const scene = scene_of(wall, "");
    struct dem *const d = world(scene, 1, &seed);

    TAP_OK((strstr(dem_step_limit(d).why, "wall w") != NULL) == named, "%s", what);
    dem_free(d);
}

static void refused(void)
{
    char *const scene = scene_of("type plane; point (0 0 0); normal (0 0 1); motion { type"
                                 " oscillation; amplitude (0 0 1e-9); frequency 1e5; }",
                                 "time { step 1e-6; }");
    const struct dem_new_particle seed = {
        .diameter = 2.0*R, .material = "a", .position = {0.0, 0.0, R}};
    struct dem_case *const c = world_begin(scene);

    TAP_OK(dem_case_add_particles(c, 1, &seed) || world_status(c), "a longer step is refused");
    TAP_OK(strstr(dem_error_text(), "1/60 of the period of wall w") != NULL, "by that limit");
}

/* The wall is in the list of warnings (1), or not. */
static void warned(const char *wall, int told, const char *what)
{
    const struct dem_run_info run = {.duration = 1.0};
    const struct dem_new_particle seed = {
        .diameter = 2.0*R, .material = "a", .position = {0.0, 0.0, 2.0*R}};
    struct dem *const d = world(world_text(
        "materials { a { density 2500; youngsModulus 1e7; } } effects "
        "{ hertz {} gravity { acceleration (0 0 -9.81); } } "
        "walls { w { %s } }", wall), 1, &seed);
    const char *text;

    WORLD_TRY(dem_warnings(d, &run, 0, NULL, &text));
    TAP_OK((strstr(text, "walls/w: ") != NULL && strstr(text, "impactSpeed")) == told, "%s", what);
    dem_free(d);
}

#define PLANE "type plane; point (0 0 0); normal (0 0 1); motion { type "
#define SHEET "type triangles; corners ((-1 -1 0) (1 -1 0) (0 1 0)); motion { type "
#define DRUM                                                                                      \
    "type cylinder; point (0 0 0); axis (0 1 0); radius 0.5; particles inside; motion { type "

/* One driven sphere above a floor, or without. */
static void driven(const char *walls, int told)
{
    const struct dem_run_info run = {.duration = 1.0};
    struct dem *const d = world(world_text(
        "materials { a { density 2500; youngsModulus 1e7; } } effects { hertz {} } walls { %s } "
        "insert { g { type list; diameter 1e-3; positions ((0 0 1)); velocity (0 0 -1); "
        "driven yes; } }", walls), 0, NULL);
    const char *text;

    WORLD_TRY(dem_warnings(d, &run, 0, NULL, &text));
    TAP_OK((strstr(text, "driven particles pass through walls") != NULL) == told,
           "a driven sphere %s a wall", told ? "and" : "without");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    shaken(3.0, "plane at three times the natural frequency");
    shaken(10.0, "plane at ten times");
    refused();
    bounds(PLANE "oscillation; amplitude (0 0 1e-6); frequency 50; }", 0, "50 Hz bounds no step");
    bounds(PLANE "translation; velocity (0 0 -1); start 0.1; end 0.1001; }", 0,
           "nor a translation");
    bounds(PLANE "oscillation; amplitude (0 0 1e-9); frequency 1e5; start -1; end 0; }", 0,
           "nor a motion that has ended");
    bounds(PLANE "rotation; origin (0 0 0); axis (0 0 1); omega 1e6; }", 1, "a turntable does");
    bounds(DRUM "rotation; origin (0 0 0); axis (0 1 0); omega 1e5; }", 1, "and a roller");
    warned(PLANE "translation; velocity (0 0 50); }", 1, "a plane that pushes at 50 m/s");
    warned(SHEET "translation; velocity (0 0 -50); }", 1, "triangles that push");
    warned(PLANE "oscillation; amplitude (0 0 0.1); frequency 100; }", 1, "a plane that shakes");
    warned(SHEET "rotation; origin (0 0 0); axis (1 0 0); omega 50; }", 1, "a paddle");
    warned(DRUM "translation; velocity (20 0 0); }", 1, "a cylinder that moves across its axis");
    warned(PLANE "translation; velocity (50 0 0); }", 0, "a floor that slides");
    warned(SHEET "translation; velocity (50 0 0); }", 0, "a floor of triangles that slides");
    warned(DRUM "rotation; origin (0 0 0); axis (0 1 0); omega 100; }", 0, "a drum");
    driven("w { type plane; point (0 0 0); normal (0 0 1); }", 1);
    driven("", 0);
    TAP_DONE;
}
