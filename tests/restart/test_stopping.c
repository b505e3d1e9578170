/*
 * test_stopping.c -- a run that is asked to stop.
 *
 * - It ends after the current step, within its window.
 * - Saved and loaded there, or just advanced further, it has the bits of a run that was not
 *   stopped: positions, friction, drag, a moving wall, particles that cross periodic faces or
 *   leave, means.
 * - Continued with another step dt' it differs by at most half a kick: for a sphere in free fall g
 *   (dt - dt')/2.
 * - A file asks for it as a signal does, is looked for once a second, and is removed.
 * - A handler that a library puts in the place of the one that was asked for is put back.
 *
 * Source: the contract of dem_set_stop_flag in dem.h; the leapfrog is exact under constant
 * acceleration.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <sys/stat.h>
#include <unistd.h>

static const char heap[] =
    "materials { glass { density 2500; youngsModulus 5e5; } }"
    "effects { gravity { acceleration (0.5 0 -9.81); } hertz {} dry { restitution 0.6; } "
    "mindlin { friction 0.5; } gidaspow {} }"
    "fluid { density 1.2; viscosity 1.8e-5; velocity (3 0 0.5); voidFraction 0.6; }"
    "walls { floor { type plane; point (0 0 0); normal (0 0 1); motion { type oscillation; "
    "amplitude (0 0 2e-4); frequency 100; } } }"
    "domain { x (0 0.008); y (0 0.008); z (-1 0.011); periodic (x y); leaving remove; }"
    "insert { grains { type lattice; count 60; diameter 1e-3; min (0 0 3e-4); "
    "max (0.008 0.008 0.01); velocity (2 0 0.45); } }"
    "averages { box { min (0 0 0); max (0.008 0.008 0.01); cells (2 1 2); interval 1e-3; } }"
    "time { step 1.52587890625e-05; }";

static const double step = 1.0/65536.0, window = 700.0/65536.0;
static char folder[] = "/tmp/stopping.XXXXXX", file[64];
static volatile sig_atomic_t requested_signal;

static struct dem *load(const char *scene)
{
    struct dem_case *const c = world_begin(scene);

    WORLD_TRY(dem_case_load(c, file));
    return world_start(c);
}

/* The table of means as text, freed by the caller. */
static char *means(struct dem *d)
{
    char path[80], *const text = calloc(1, 10000);

    WORLD_TRY(dem_averages(d, folder));
    snprintf(path, sizeof path, "%s/box.csv", folder);
    FILE *const f = fopen(path, "r");

    if (!f || !text || fread(text, 1, 9999, f) == 0 || fclose(f))
    {
        world_end(path);
    }
    return text;
}

/* Three windows, with a stop after every `every` steps; after every second stop the run is loaded
   into a new simulation. */
static struct dem *with_stops(int every)
{
    struct dem *d = world(heap, 0, NULL);
    int stops = 0, steps = 0;

    while (world_tally(d).time < 3.0*window)
    {
        const double time = world_tally(d).time;

        /* each dem_advance makes one step */
        requested_signal = SIGTERM;
        dem_set_stop_flag(d, &requested_signal);
        WORLD_TRY(dem_advance(d, (floor(time/window) + 1.0)*window - time));
        if (dem_stopped(d) && ++steps%every == 0 && ++stops%2 == 0)
        {
            const uint64_t before = world_hash(d);

            WORLD_TRY(dem_save(d, file));
            dem_free(d);
            d = load(heap);
            if (world_hash(d) != before)
            {
                TAP_OK(0, "the loaded state is the saved one, at step %d", steps);
            }
        }
    }
    TAP_OK(stops > 10, "%d stops", stops);
    return d;
}

static void same_bits(void)
{
    struct dem *const whole = world(heap, 0, NULL);

    for (int k = 0; k < 3; k++)
    {
        world_run(whole, window);
    }
    const int64_t left = 60 - world_tally(whole).particles;
    char *const expected = means(whole);

    TAP_OK(left > 0 && left < 30, "%d particles leave", (int)left);
    for (int every = 23; every < 90; every += 40)
    {
        struct dem *const d = with_stops(every);
        char *const found = means(d);

        TAP_OK(world_hash(d) == world_hash(whole), "a stop every %d steps: the same bits", every);
        TAP_OK(world_tally(d).steps == world_tally(whole).steps, "the same number of steps");
        TAP_OK(strcmp(found, expected) == 0, "the same means, to the last digit");
        free(found);
        dem_free(d);
    }
    free(expected);
    dem_free(whole);
}

static void stop_reports(void)
{
    struct dem *const d = world(heap, 0, NULL);

    world_run(d, 5.0*step);
    TAP_OK(dem_stopped(d) == 0, "without a request: not stopped");
    requested_signal = 0;
    dem_set_stop_flag(d, &requested_signal);
    world_run(d, 5.0*step);
    TAP_OK(dem_stopped(d) == 0 && world_tally(d).steps == 10,
           "a flag without a signal: not stopped");
    requested_signal = SIGUSR1;
    world_run(d, 5.0*step);
    TAP_OK(dem_stopped(d) == SIGUSR1 && world_tally(d).steps == 11,
           "requested: stopped after one step, with the signal");
    requested_signal = 0;
    world_run(d, 4.0*step);
    TAP_OK(dem_stopped(d) == 0 && world_tally(d).steps == 15, "the rest of the window");
    requested_signal = SIGTERM;
    world_run(d, step);
    TAP_OK(dem_stopped(d) == 0 && dem_stop_requested(d) == SIGTERM,
           "after the last step of a window: not reported as stopped, but as requested");
    dem_free(d);
}

/* Height and velocity at 1 s of a sphere that is stopped at step 301 of 1000 and continues with
   another step. */
static struct world_particle fall(double other)
{
    static const char text[] =
        "materials { glass { density 2500; youngsModulus 1e6; } } "
        "effects { gravity { acceleration (0 0 -10); } }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); } } time { step %.17g; "
        "force yes; }";
    char *const first = world_text(text, 1e-3), *const second = world_text(text, other);
    struct dem *d = world(first, 0, NULL);

    requested_signal = SIGTERM;
    dem_set_stop_flag(d, &requested_signal);
    for (int k = 0; k < 301; k++)
    {
        WORLD_TRY(dem_advance(d, 1.0 - world_tally(d).time));
    }
    WORLD_TRY(dem_save(d, file));
    dem_free(d);
    d = load(second);
    WORLD_TRY(dem_advance(d, 1.0 - world_tally(d).time));
    const struct world_particle p = world_at(d, 0);

    dem_free(d);
    return p;
}

static void other_steps(void)
{
    /* 1e-12: 1000 sums of numbers of 10, round-off */
    TAP_NEAR(fall(1e-3).x[2], -5.0, 1e-12, "the same step: height");
    TAP_NEAR(fall(2e-3).v[2], -10.0, 1e-12, "longer steps: velocity");
    TAP_NEAR(fall(2e-3).x[2], -5.0, 1e-12, "longer steps: height");
    TAP_NEAR(fall(0.5e-3).v[2], -10.0, 10.0*0.25e-3 + 1e-12,
             "shorter steps: velocity error at most g (dt - dt')/2");
    TAP_NEAR(fall(0.5e-3).x[2], -5.0, 0.7*10.0*0.25e-3 + 1e-12,
             "shorter steps: height error at most that times the remaining time");
}

static int make(const char *path)
{
    FILE *const f = fopen(path, "w");

    return f && fclose(f) == 0;
}

static void stop_file(void)
{
    const volatile sig_atomic_t *const caught = dem_catch_signals(NULL, 0);
    char path[80];
    int found;

    snprintf(path, sizeof path, "%s/stop", folder);
    TAP_OK(dem_stop_file_clear(path, &found) == DEM_OK && !found, "no file before the start");
    dem_stop_file_look(path);
    TAP_OK(*caught == 0, "no file: nothing is asked for");
    TAP_OK(make(path), "a file is made");
    dem_stop_file_look(path);
    TAP_OK(*caught == 0 && access(path, F_OK) == 0, "within a second there is no second look");
    sleep(1);
    dem_stop_file_look(path);
    TAP_OK(*caught == DEM_STOP_FILE && access(path, F_OK) != 0, "after a second it is seen and removed");
    TAP_OK(strcmp(dem_signal_name(*caught), "the file stop") == 0, "its name in messages");
    TAP_OK(make(path) && dem_stop_file_clear(path, &found) == DEM_OK && found && access(path, F_OK) != 0,
           "one from before the start is removed");
    snprintf(path, sizeof path, "%s/stop/", folder);
    TAP_OK(mkdir(path, 0700) == 0, "a folder of that name");
    snprintf(path, sizeof path, "%s/stop/x", folder);
    TAP_OK(make(path), "that is not empty");
    snprintf(path, sizeof path, "%s/stop", folder);
    TAP_OK(dem_stop_file_clear(path, &found) == DEM_ERROR_FILE && found
               && strstr(dem_error_text(), "cannot be removed"), "what cannot be removed is an error");
}

static void of_a_library(int number)
{
    (void)number;
}

static void kept_signals(void)
{
    static const int except = SIGUSR1;
    const volatile sig_atomic_t *const caught = dem_catch_signals(&except, 1);

    signal(SIGTERM, of_a_library);
    signal(SIGUSR1, of_a_library);
    dem_keep_signals();
    raise(SIGTERM);
    TAP_OK(*caught == SIGTERM, "a handler that was replaced is put back");
    raise(SIGUSR1);
    TAP_OK(*caught == SIGTERM, "one that was not asked for stays the other's");
    raise(SIGINT);
    TAP_OK(*caught == SIGINT, "SIGINT is caught");
    dem_keep_signals();
    struct sigaction present;

    TAP_OK(sigaction(SIGINT, NULL, &present) == 0 && present.sa_handler == SIG_DFL,
           "the second SIGINT ends the program, as before");
    signal(SIGTERM, SIG_DFL);
}

int main(void)
{
    TAP_TRAPS;
    if (!mkdtemp(folder))
    {
        world_end("mkdtemp");
    }
    snprintf(file, sizeof file, "%s/stop.dem", folder);
    same_bits();
    stop_reports();
    other_steps();
    stop_file();
    kept_signals();
    if (system(NULL))
    {
        char *const command = world_text("rm -r %s", folder);

        TAP_OK(system(command) == 0, "the folder is removed");
    }
    TAP_DONE;
}
