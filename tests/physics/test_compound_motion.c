/*
 * test_compound_motion.c -- walls that move by a table, or by several motions at a time, are where the
 * closed forms put them, have the velocity of the chord, and continue from a snapshot; tables and
 * motions that cannot work are refused with a sentence.
 *
 * Sources: kinematics of rigid bodies; Steffen, Astron. Astrophys. 239 (1990) 443, for the order of the
 * cubics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "walls/compound_motion.h"
#include <unistd.h>

static const char glass[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } "
    "rigid { density 1; youngsModulus 1e30; } } effects { hertz {} dry { restitution 0.5; } "
    "mindlin { friction 0.3; } gravity { acceleration (0 0 -9.81); } } ";
static const char plate[] = "type triangles; material rigid; corners ((-0.05 -0.05 0) (0.05 -0.05 0) "
                            "(0.05 0.05 0) (-0.05 -0.05 0) (0.05 0.05 0) (-0.05 0.05 0));";

static char folder[] = "/tmp/compound.XXXXXX";

static char *file_of(const char *name, const char *text)
{
    char *const path = world_text("%s/%s", folder, name);
    FILE *const f = fopen(path, "w");

    if (!f || fputs(text, f) < 0 || fclose(f))
    {
        printf("Bail out! cannot write %s\n", path);
        exit(1);
    }
    return path;
}

static const double f0 = 20.0, a0 = 2e-3;

/* z = a sin(2 pi f t) at n rows a period, over four periods; angle = slope times z */
static char *sine(const char *name, int n, double slope)
{
    char *text = world_text("time, z, angle\r\n");

    for (int k = 0; k <= 4*n; k++)
    {
        const double z = a0*sin(2.0*world_pi*k/n);

        text = world_text("%s%.17g, %.17g, %.17g\r\n", text, k/(n*f0), z, slope*z);
    }
    return file_of(name, text);
}

/* ---- tables ---------------------------------------------------------------------------------- */

/* The largest error of the interpolation in one period, of the amplitude. */
static double error_of(const char *path, int smooth)
{
    static const char *const columns[] = {"z", "angle"};
    struct dem_time_table *t;
    double worst = 0.0, at[DEM_TIME_TABLE_COLUMNS];

    WORLD_TRY(dem_time_table_read(&t, path, columns, 2, smooth));
    for (int k = 0; k <= 2000; k++)
    {
        dem_time_table_at(t, (1.0 + k*5e-4)/f0, at);
        worst = fmax(worst, fabs(at[0] - a0*sin(2.0*world_pi*k*5e-4))/a0);
    }
    dem_time_table_free(t);
    return worst;
}

/* Straight lines: h^2/8. Cubics: their slopes are wrong by h^2/6, by which the middle of a row moves by
   h^3/24 at most where slopes of both ends differ in their error; extrema are at rows. */
static void tables(void)
{
    const char *const coarse = sine("coarse.csv", 100, 0.0), *const fine = sine("fine.csv", 200, 0.0);
    const double h = 2.0*world_pi/200.0, line = error_of(fine, 0), cubic = error_of(fine, 1);

    TAP_NEAR(line/(h*h/8.0), 1.0, 1e-3, "linear: the error is h^2/8 of a sine with 200 rows a period");
    TAP_OK(cubic <= h*h*h/24.0, "smooth: its error, %.2g, is below h^3/24 = %.2g", cubic, h*h*h/24.0);
    TAP_OK(error_of(coarse, 1) > 7.0*cubic, "and falls at least with the third power of h: %.2g",
           error_of(coarse, 1));
}

/* A sphere on a floor that shakes by the formula and by its table. */
static void shaken(void)
{
    static const double step = 4e-6;
    double z[2];

    for (int k = 0; k < 2; k++)
    {
        char *const motion =
            k == 0 ? world_text("type oscillation; amplitude (0 0 %g); frequency %g;", a0, f0)
                   : world_text("type table; file \"%s\";", sine("shake.csv", 200, 0.0));
        struct dem_new_particle seed = {.diameter = 2e-3, .material = "glass",
                                        .position = {0.0, 0.0, 1e-3}};
        struct dem *const d = world(
            world_text("%s walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); "
                       "motion { %s } } } time { step %g; }", glass, motion, step), 1, &seed);

        world_run(d, 3.3/f0);
        z[k] = world_at(d, 0).x[2];
        dem_free(d);
    }
    /* thrown and caught: an error of the floor's velocity of h^2/6 grows to some of it in position */
    TAP_NEAR((z[1] - z[0])/a0, 0.0, 1e-3, "a sphere thrown by a table lands as one thrown by the sine");
}

/* ---- superposition --------------------------------------------------------------------------- */

/* Rotation of the plane x y by an angle about a centre on x. */
static void turned(double angle, double centre, const double x[2], double out[2])
{
    const double c = cos(angle), s = sin(angle), u = x[0] - centre;

    out[0] = centre + c*u - s*x[1];
    out[1] = s*u + c*x[1];
}

static void planetary(void)
{
    static const double own = 30.0, orbit = -11.0, T = 0.1;
    struct dem *const d = world(
        world_text("%s walls { jar { %s motion ( { type rotation; origin (0.02 0 0); axis (0 0 1); "
                   "omega %g; } { type rotation; origin (0 0 0); axis (0 0 1); omega %g; } "
                   "{ type translation; velocity (0 0 0.03); } ); } } time { step 1e-5; }",
                   glass, plate, own, orbit), 0, NULL);
    double corner[18], worst = 0.0, was[18];
    struct dem_wall_info info;

    WORLD_TRY(dem_wall_corners(d, 0, was));
    world_run(d, T);
    WORLD_TRY(dem_wall_corners(d, 0, corner));
    dem_wall_info(d, 0, &info);
    for (int k = 0; k < 6; k++)
    {
        double first[2], second[2];

        turned(own*T, 0.02, was + 3*k, first);
        turned(orbit*T, 0.0, first, second);
        worst = fmax(worst, hypot(corner[3*k] - second[0], corner[3*k + 1] - second[1]));
        worst = fmax(worst, fabs(corner[3*k + 2] - 0.03*T));
    }
    TAP_OK(info.moves, "a wall with three motions moves");
    TAP_NEAR(worst, 0.0, 1e-15, "planetary motion along a helix: corners");
    dem_free(d);
}

/* The velocity of a point is its path over the step, exactly; a single rotation has the closed form. */
static void chords(void)
{
    static const double x[3] = {0.03, -0.02, 0.01}, t = 0.37, dt = 1e-5;
    const struct dem_motion spin = {.kind = DEM_MOTION_ROTATION, .end = INFINITY,
                                    .origin = {0.02, 0.0, 0.0}, .axis = {0.6, 0.0, 0.8}, .omega = 30.0};
    const struct dem_motion orbit = {.kind = DEM_MOTION_ROTATION, .end = INFINITY,
                                     .axis = {0.0, 0.0, 1.0}, .omega = -11.0};
    struct dem_compound_motion c = {.parts = 2, .part = {{.motion = spin}, {.motion = orbit}}};
    struct dem_wall_displacement d, exact;
    struct dem_pose now, before;
    double here[3], there[3], v[3], closed[3], worst = 0.0, off = 0.0;

    dem_compound_motion_pose(&c, t, &now);
    dem_compound_motion_pose(&c, t - dt, &before);
    dem_pose_point(&now, x, here);
    dem_pose_point(&before, x, there);
    dem_compound_motion_displacement(&c, t, dt, &d);
    dem_wall_displacement_velocity(&d, here, v);
    for (int k = 0; k < 3; k++)
    {
        worst = fmax(worst, fabs(v[k] - (here[k] - there[k])/dt));
    }
    /* round-off of a position, 1e-18 m, over dt */
    TAP_NEAR(worst, 0.0, 1e-11, "two rotations about different axes: the chord of the step");
    c.parts = 1;
    dem_compound_motion_displacement(&c, t, dt, &d);
    dem_motion_displacement(&spin, t, dt, &exact);
    dem_wall_displacement_velocity(&d, here, v);
    dem_wall_displacement_velocity(&exact, here, closed);
    for (int k = 0; k < 3; k++)
    {
        off = fmax(off, fabs(v[k] - closed[k]));
    }
    TAP_NEAR(off, 0.0, 1e-11, "one rotation: as its closed form");
    TAP_NEAR(d.sine, exact.sine, 1e-15, "and turns history by the same angle");
}

/* ---- restart --------------------------------------------------------------------------------- */

static struct dem *mixed(const char *load, const char *motion)
{
    struct dem_case *const c = world_begin(world_text(
        "%s walls { floor { %s motion %s } } insert { some { type random; min (-0.02 -0.02 1e-3); "
        "max (0.02 0.02 0.01); count 50; diameter 2e-3; material glass; } } time { step 8e-6; }",
        glass, plate, motion));

    if (load)
    {
        WORLD_TRY(dem_case_load(c, load));
    }
    return world_start(c);
}

static void restart(void)
{
    char *const motion = world_text("( { type table; file \"%s\"; axis (0 0 1); origin (0.01 0 0); } { type "
                                    "translation; velocity (0.01 0 0); } );",
                                    sine("twist.csv", 100, 50.0));
    char *const path = world_text("%s/mixed.snapshot", folder);
    struct dem *d = mixed(NULL, motion);
    double corner[2][18], worst = 0.0;

    world_run(d, 0.04);
    WORLD_TRY(dem_save(d, path));
    world_run(d, 0.05);
    const uint64_t whole = world_hash(d);

    WORLD_TRY(dem_wall_corners(d, 0, corner[0]));
    dem_free(d);
    d = mixed(path, motion);
    world_run(d, 0.05);
    WORLD_TRY(dem_wall_corners(d, 0, corner[1]));
    TAP_OK(world_hash(d) == whole, "a table and a translation continue with the same bits");
    TAP_OK(memcmp(corner[0], corner[1], sizeof *corner) == 0, "the wall, too");
    dem_free(d);
    d = mixed(path, "{ type translation; velocity (0 0 1); }");
    WORLD_TRY(dem_wall_corners(d, 0, corner[0]));
    dem_free(d);
    d = mixed(path, motion);
    WORLD_TRY(dem_wall_corners(d, 0, corner[1]));
    dem_free(d);
    for (int k = 0; k < 18; k++)
    {
        worst = fmax(worst, fabs(corner[0][k] - corner[1][k]));
    }
    TAP_NEAR(worst, 0.0, 1e-16, "with another motion the wall goes on from where it stood");
}

/* ---- power ----------------------------------------------------------------------------------- */

/* A plate that turns under grains does work on them: less its angular velocity times the angular
   impulse of the grains on it about its axis. Friction begins as the grains land. */
static void power(const char *motion, const char *what)
{
    static const double omega = 20.0, origin[3] = {0.01, 0.0, 0.0};
    struct dem *const d = mixed(NULL, motion);
    double impulse[3], twist[3], work, at[3], axis[3];

    world_run(d, 0.02);
    WORLD_TRY(dem_wall_impulse_reset(d));
    world_run(d, 0.05);
    WORLD_TRY(dem_wall_impulse(d, 0, impulse, twist));
    WORLD_TRY(dem_wall_work(d, 0, &work));
    const double about = twist[2] - (origin[0]*impulse[1] - origin[1]*impulse[0]);

    TAP_OK(work > 1e-7, "%s: a turning plate does work on grains, %g J", what, work);
    /* the chord of a step leans from the tangent by omega dt/2, towards the axis */
    TAP_NEAR(-omega*about/work, 1.0, omega*4e-6, "%s: its torque times its angular velocity", what);
    if (dem_wall_axis(d, 0, at, axis))
    {
        TAP_OK(at[0] == origin[0] && axis[2] == 1.0, "%s: its axis", what);
    }
    dem_free(d);
}

/* The axis of a table that only turns is fixed; one that also moves has none. */
static void axes(void)
{
    for (int moves = 0; moves < 2; moves++)
    {
        char *const rows = file_of("axis.csv", moves ? "time, z, angle\n0, 0, 0\n1, 1e-3, 1\n"
                                                     : "time, angle\n0, 0\n1, 1\n");
        struct dem *const d = world(
            world_text("%s walls { w { %s motion { type table; file \"%s\"; origin (0.01 0 0); axis (1 0 0); } } } "
                       "time { step 1e-5; }", glass, plate, rows), 0, NULL);
        double at[3], axis[3];
        const int fixed = dem_wall_axis(d, 0, at, axis);

        TAP_OK(fixed == !moves && (moves || (at[0] == 0.01 && axis[0] == 1.0)), "a table that %s has %s",
               moves ? "turns and moves" : "only turns", fixed ? "its axis" : "no fixed axis");
        dem_free(d);
    }
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void refuse(const char *wall, const char *motion, const char *words)
{
    world_refused(world_text("%s walls { w { %s motion %s } } insert { a { type list; positions "
                             "((0 0 0.5)); diameter 2e-3; material glass; } } time { step 8e-6; }",
                             glass, wall, motion), words);
}

static void refuse_table(const char *rows, const char *words)
{
    refuse(plate, world_text("{ type table; file \"%s\"; }", file_of("bad.csv", rows)), words);
}

static void refusals(void)
{
    char *const twist = world_text("{ type table; file \"%s\"; origin (0 0 0); axis (1 0 0); }",
                                   sine("bad-twist.csv", 100, 1.0));

    TAP_OK(dem_time_table_read(&(struct dem_time_table *){NULL}, "nowhere.csv", (const char *[]){"z"}, 1, 1)
               == DEM_ERROR_FILE && strstr(dem_error_text(), "nowhere.csv"), "refused: %s", dem_error_text());
    refuse_table("time, z\n0, 0\n0.1, 0.2\n0.1, 0.3\n", "line 4: time 0.1 s is not after 0.1 s");
    refuse_table("time, z\n0, 0\n0.1\n", "is not a row of 2 numbers");
    refuse_table("time, z\n0, 0\n0.1, nan\n", "is not a row of 2 numbers");
    refuse_table("time, height\n0, 0\n1, 1\n", "unknown column \"height\"");
    refuse_table("\xef\xbb\xbf" "time, z\n0, 0\n", "give at least two");
    refuse_table("z\n0\n1\n", "names the columns: time");
    refuse_table("time, z\n0, 0\n", "give at least two");
    refuse_table("time, z\n0, 0\n2e-5, 0\n1, 1\n",
                 "wall w: the rows of 0 and 2e-05 s of its motion are nearer than 4 steps");
    refuse_table("time, z\n0, 0\n1e-3, 1\n1, 1\n", "its motion reaches");
    refuse_table("time, angle\n0, 0\n1, 1\n", "origin");
    refuse("type plane; material rigid; point (0 0 0); normal (0 0 1);", twist, "would tilt it");
    refuse(plate, "( { type rest; } );", "type of motion");
    refuse(plate, "5;", "is a dictionary, or a list of some");
    refuse(plate, "( { type translation; velocity (0 0 0); } { type translation; velocity (0 0 0); } "
                  "{ type translation; velocity (0 0 0); } { type translation; velocity (0 0 0); } "
                  "{ type translation; velocity (0 0 0); } );", "at most 4 motions");
    refuse(plate, "( { type translation; velocity (0 0 0); speed 3; } );", "unknown entry \"speed\"");
}

int main(void)
{
    if (!mkdtemp(folder))
    {
        printf("Bail out! no folder in /tmp\n");
        return 1;
    }
    tables();
    shaken();
    planetary();
    chords();
    restart();
    power("{ type rotation; origin (0.01 0 0); axis (0 0 1); omega 20; }", "a rotation");
    power("( { type rotation; origin (0.01 0 0); axis (0 0 1); omega 20; } { type translation; velocity "
          "(0 0 0); } );", "a rotation and rest");
    axes();
    refusals();
    (void)!system(world_text("rm -r %s", folder));
    TAP_DONE;
}
