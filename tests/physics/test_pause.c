/*
 * test_pause.c -- mechanics paused at rest (time/pauseAtRest).
 *
 * A chain of spheres between two walls of given temperature, pressed by them. Its temperatures are
 * compared with those of the equations of conduction, integrated in steps so short that their error
 * is below 1e-9 K, once with mechanics running all the time and once paused. The chain is as soft and
 * conducts as well as is needed for the first to be short.
 *
 * - Paused, the chain has the temperatures of these equations up to the error of the explicit step:
 *   half the step, half the error. The energy balance has the kinetic energy that was removed.
 * - So it has where much is removed.
 * - A wall that moves for a while ends the pause; then the chain has the new overlaps, and pauses again.
 * - So do a stream, and a force that begins and ends.
 * - A condition of a wall that begins in a pause begins at its time.
 * - A run stopped within a pause continues with the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "energy.h"

#include <math.h>
#include <signal.h>

enum
{
    N = 5
};

static const double R = 3.2e-3, d0 = 6.4e-5, k = 420.0, c = 464.0, rho = 7800.0, E = 1e6;
static const double T_low = 300.0, T_high = 400.0, T_start = 320.0;

/* m  overlap at walls for that of pairs: the same force of Hertz, with R* = R instead of R/2 */
static double at_wall(double overlap)
{
    return overlap/cbrt(2.0);
}

static double span(double overlap)
{
    return 2.0*(R - at_wall(overlap)) + (N - 1)*(2.0*R - overlap);
}

/* of a scene; `more`: further groups of entries, in braces of walls, insert, ... merge with these */
static char *scene(const char *pause, const char *high, const char *more)
{
    char positions[64*N] = "";

    for (int n = 0; n < N; n++)
    {
        snprintf(positions + strlen(positions), 64, "(0 0 %.17g) ",
                 R - at_wall(d0) + n*(2.0*R - d0));
    }
    return world_text(
        "materials { steel { density %g; youngsModulus %g; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } dry { restitution 0.3; } mindlin { friction 0.3; } conduction { } }"
        "walls { low { type plane; point (0 0 0); normal (0 0 1); temperature { value %g; } }"
        "high { type plane; point (0 0 %.17g); normal (0 0 -1); temperature { value %g; } %s } }"
        "time { maxStartOverlap 0.1; %s }"
        "insert { chain { type list; diameter %g; positions (%s); temperature %g; } }"
        "%s",
        rho, E, k, c, T_low, span(d0), T_high, high, pause, 2.0*R, positions, T_start, more);
}

static const char at_rest[] = "pauseAtRest { speed 1e-5; lasting 0.01; moving 0; %s }";

/* ---- a run as that of `dem run` ---------------------------------------------------------------- */

/* 1: an advance in a pause is stopped after its first step */
static int stops_in_pauses;
static volatile sig_atomic_t stop;

struct told
{
    int pauses, resumptions;
    double first_pause, last_resumption;    /* s */
    char last[400];
};

static struct dem *begin(const char *text, int energy, const char *load)
{
    struct dem *const d = world_begin(text);
    int wanted;

    WORLD_TRY(dem_pause_enable(d, &wanted));
    if (load)
    {
        WORLD_TRY(dem_load(d, load));
    }
    if (energy)
    {
        WORLD_TRY(dem_energy_enable(d));
    }
    WORLD_TRY(dem_setup(d));
    return d;
}

static void run_until(struct dem *d, double end, double interval, struct told *told)
{
    const int64_t tests = dem_pause_tests(d, interval);
    const double part = interval/(double)tests;
    struct dem_totals t = world_tally(d);
    const char *text;

    while (t.time < end*(1.0 - 1e-12) && !dem_stopped(d))
    {
        const double next = (floor(t.time/part + 1e-6) + 1.0)*part,
                     output = (floor(t.time/interval + 1e-6) + 1.0)*interval;
        const double to = fmin(fmin(dem_paused(d) ? output : next, dem_pause_until(d)), end);

        stop = stops_in_pauses && dem_paused(d);
        world_run(d, to - t.time);
        t = world_tally(d);
        WORLD_TRY(dem_pause_update(d, &t, &text));
        if (text[0])
        {
            printf("# %s\n", text);
            snprintf(told->last, sizeof told->last, "%s", text);
            told->first_pause = dem_paused(d) && told->pauses == 0 ? t.time : told->first_pause;
            told->last_resumption = dem_paused(d) ? told->last_resumption : t.time;
            told->pauses += dem_paused(d);
            told->resumptions += !dem_paused(d);
        }
    }
}

/* ---- the equations ----------------------------------------------------------------------------- */

static void rates(double overlap, double low, double high, const double *T, double *rate)
{
    const double pair = 2.0*k*sqrt(0.5*R*overlap), wall = 2.0*k*sqrt(R*at_wall(overlap));
    const double C = rho*4.0/3.0*world_pi*R*R*R*c;

    for (int n = 0; n < N; n++)
    {
        rate[n] = ((n > 0 ? pair*(T[n - 1] - T[n]) : wall*(low - T[n])) +
                   (n < N - 1 ? pair*(T[n + 1] - T[n]) : wall*(high - T[n])))/C;
    }
}

/* Runge-Kutta of fourth order: 1e3 steps a second. */
static void integrate(double overlap, double low, double high, double duration, double *T)
{
    const int steps = (int)ceil(1e3*duration);
    const double h = duration/steps;
    double a[N], b[N], e[N], f[N], u[N];

    for (int s = 0; s < steps; s++)
    {
        rates(overlap, low, high, T, a);
        for (int n = 0; n < N; n++) { u[n] = T[n] + 0.5*h*a[n]; }
        rates(overlap, low, high, u, b);
        for (int n = 0; n < N; n++) { u[n] = T[n] + 0.5*h*b[n]; }
        rates(overlap, low, high, u, e);
        for (int n = 0; n < N; n++) { u[n] = T[n] + h*e[n]; }
        rates(overlap, low, high, u, f);
        for (int n = 0; n < N; n++) { T[n] += h/6.0*(a[n] + 2.0*b[n] + 2.0*e[n] + f[n]); }
    }
}

static double worst(struct dem *d, const double *exact)
{
    double T[N + 1], most = 0.0;

    world_scalars(d, "temperature", T);
    for (int n = 0; n < N; n++)
    {
        most = fmax(most, fabs(T[n] - exact[n]));
    }
    return most;
}

static void start(double *T)
{
    for (int n = 0; n < N; n++)
    {
        T[n] = T_start;
    }
}

/* ---- tests ------------------------------------------------------------------------------------- */

/* K  error after so long, with steps of the pause no longer than `step`; 0: mechanics run */
static double error_of(double step, double duration, double *kinetic, int64_t *steps)
{
    char pause[160] = "", entry[64] = "";
    struct told told = {0};
    double exact[N];

    if (step > 0.0)
    {
        snprintf(entry, sizeof entry, "step %.17g;", step);
        snprintf(pause, sizeof pause, at_rest, entry);
    }
    char *const text = scene(pause, "", "");
    struct dem *const d = begin(text, 1, NULL);

    run_until(d, duration, 0.5, &told);
    start(exact);
    integrate(d0, T_low, T_high, duration, exact);
    const double error = worst(d, exact);

    *kinetic = step > 0.0 ? energy_value(d, "lost_pause") : 0.0;
    TAP_OK(step == 0.0 ? told.pauses == 0
                       : told.pauses == 1 && told.resumptions == 0 && told.first_pause < 0.1,
           "%s", step > 0.0 ? "it pauses once, soon" : "without the entry it never pauses");
    TAP_OK(step == 0.0 ? isnan(energy_value(d, "lost_pause")) : *kinetic >= 0.0 && *kinetic < 1e-15,
           "lost_pause %.3g J", *kinetic);
    TAP_NEAR(energy_value(d, "residual"), 0.0, 1e-9*energy_value(d, "heat_walls"), "the energy is kept");
    *steps = world_tally(d).steps;
    free(text);
    dem_free(d);
    return error;
}

static void test_chain(void)
{
    double kinetic, exact[N], Q[N];
    int64_t moving, paused[3];
    const double whole = error_of(0.0, 5.0, &kinetic, &moving);
    const double h = error_of(0.05, 5.0, &kinetic, &paused[0]),
                 half = error_of(0.025, 5.0, &kinetic, &paused[1]),
                 fine = error_of(0.0025, 5.0, &kinetic, &paused[2]);

    printf("# K at 5 s of 100 K, in steps: moving %.3g in %lld, paused %.3g in %lld, %.3g in %lld, %.3g in %lld\n",
           whole, (long long)moving, h, (long long)paused[0], half, (long long)paused[1], fine,
           (long long)paused[2]);
    TAP_OK(whole < 0.01, "mechanics running: %.3g K off", whole);
    TAP_OK(h < 1.0 && h > 1.8*half && h < 2.3*half, "paused: %.3g K, half of it in half the step",
           h);
    TAP_OK(fine < 0.1*half*1.5 && fine > 0.1*half/1.5, "a tenth of it in a tenth of the step");

    /* steady: resistances in series */
    char pause[160];
    struct told told = {0};

    snprintf(pause, sizeof pause, at_rest, "");
    char *const text = scene(pause, "", "");
    struct dem *const d = begin(text, 0, NULL);
    const double pair = 1.0/sqrt(0.5*R*d0), wall = 1.0/sqrt(R*at_wall(d0)),
                 all = 2.0*wall + (N - 1)*pair;

    run_until(d, 1000.0, 100.0, &told);
    for (int n = 0; n < N; n++)
    {
        exact[n] = T_low + (T_high - T_low)*(wall + n*pair)/all;
    }
    world_scalars(d, "temperature", Q);
    TAP_NEAR(worst(d, exact), 0.0, 1e-3, "after 1000 s in the longest step: resistances in series, "
             "%lld steps", (long long)world_tally(d).steps);
    TAP_OK(dem_step_limit(d).used > 0.05, "a step of %g s", dem_step_limit(d).used);
    free(text);
    dem_free(d);
}

/* Particles that fly are at rest by a careless speed: their kinetic energy is in the balance. */
static void test_energy(void)
{
    char *const text = scene("pauseAtRest { speed 10; lasting 1e-3; moving 0; imbalance 1; }",
                             "point (0 0 0.2);",
                             "insert { chain { velocity (0.02 -0.01 0.04); spin (3 -2 1); } }");
    struct dem *const d = begin(text, 1, NULL);
    struct dem_totals t;
    const char *said;
    double kinetic = 0.0, total = 0.0;

    while (!dem_paused(d))
    {
        world_run(d, 1e-3);
        t = world_tally(d);
        kinetic = t.kinetic;
        total = energy_value(d, "total");
        WORLD_TRY(dem_pause_update(d, &t, &said));
    }
    TAP_OK(kinetic > 1e-6 && fabs(energy_value(d, "lost_pause")/kinetic - 1.0) < 1e-12,
           "a pause removes %.3g J, which are in lost_pause", kinetic);
    TAP_OK(world_tally(d).kinetic == 0.0, "nothing moves then");
    TAP_NEAR(energy_value(d, "total"), total, 1e-14, "the total does not change");
    WORLD_TRY(dem_resume(d));
    TAP_OK(!dem_paused(d), "the program may resume at any time");
    world_run(d, 1e-3);
    TAP_OK(world_tally(d).kinetic > 0.0, "then they move again");
    free(text);
    dem_free(d);
}

/* The upper wall presses the chain from the overlap d0 to 1.5 d0 between 2 and 2.05 s. */
static void test_wall(void)
{
    const double d1 = 1.5*d0, speed = (span(d0) - span(d1))/0.05;
    char pause[160], motion[160];
    double exact[N], error[2], residual[2];
    struct told told[2] = {0};

    snprintf(motion, sizeof motion, "motion { type translation; velocity (0 0 %.17g); start 2; "
             "end 2.05; }", -speed);
    for (int pauses = 0; pauses < 2; pauses++)
    {
        snprintf(pause, sizeof pause, at_rest, "step 0.001;");
        char *const text = scene(pauses ? pause : "", motion, "");
        struct dem *const d = begin(text, 1, NULL);

        run_until(d, 2.0, 10.0, &told[pauses]);
        /* half the way in the time of the motion: an error of the reference below a kelvin */
        run_until(d, 2.5, 10.0, &told[pauses]);
        start(exact);
        integrate(d0, T_low, T_high, 2.0, exact);
        integrate(0.5*(d0 + d1), T_low, T_high, 0.05, exact);
        integrate(d1, T_low, T_high, 0.45, exact);
        error[pauses] = worst(d, exact);
        TAP_NEAR(world_at(d, N - 1).x[2], span(d1) - (R - at_wall(d1)), 1e-3*(d1 - d0),
                 "%s: the chain is where the wall has pressed it", pauses ? "paused" : "moving");
        residual[pauses] = energy_value(d, "residual")/energy_value(d, "work_walls");
        free(text);
        dem_free(d);
    }
    TAP_NEAR(residual[1], residual[0], 2e-3, "pauses add nothing to the residual of the work, %.3g",
             residual[0]);
    TAP_OK(told[1].pauses == 2 && told[1].resumptions == 1, "it resumes, and pauses again");
    TAP_NEAR(told[1].last_resumption, 2.0, 1e-12, "at the time at which the wall begins to move");
    TAP_OK(error[0] < 0.2 && error[1] < 0.2, "temperatures: %.3g K off, moving %.3g K", error[1],
           error[0]);
}

/* A sphere that enters above the chain, which is open there, and a force on the last one. */
static void test_others(void)
{
    char pause[160];
    struct told told = {0};
    const char *const open =
        "effects { gravity { acceleration (0 0 -9.81); } rollingSpring { friction 0.3; } } "
        "walls { high { point (0 0 0.2); } pipe { type cylinder; point (0 0 0); axis (0 0 1); "
        "radius 3.3e-3; particles inside; } } "
        "insert { feed { type stream; rate 100; start 2.5; count 1; diameter 6.4e-3; temperature "
        "500; min (-3.3e-3 -3.3e-3 0.034); max (3.3e-3 3.3e-3 0.05); } } "
        "forces { push { force (0 0 -0.01); ids (4); start 4.25; end 5.125; } }";

    snprintf(pause, sizeof pause, at_rest, "step 0.01;");
    char *const text = scene(pause, "", open);
    struct dem *const d = begin(text, 0, NULL);

    run_until(d, 2.4, 10.0, &told);
    TAP_OK(told.pauses == 1 && dem_paused(d) && world_tally(d).particles == N, "paused at 2.4 s");
    run_until(d, 4.2, 10.0, &told);
    TAP_OK(told.resumptions == 1 && told.last_resumption == 2.5, "a stream ends the pause at 2.5 s");
    TAP_OK(world_tally(d).particles == N + 1, "its particle is there");
    TAP_OK(told.pauses == 2 && dem_paused(d), "after it has come to rest, a pause");
    const double before = world_at(d, 4).x[2];

    run_until(d, 5.1, 10.0, &told);
    TAP_OK(told.resumptions == 2 && told.last_resumption == 4.25 && dem_paused(d),
           "a force ends the pause when it begins; under it, it pauses again");
    const double under = world_at(d, 4).x[2];

    run_until(d, 10.0, 10.0, &told);
    TAP_OK(told.resumptions == 3 && told.last_resumption == 5.125 && dem_paused(d),
           "and when it ends");
    TAP_OK(before - under > 1e-5 && world_at(d, 4).x[2] - under > 0.9*(before - under),
           "the sphere yields by %.3g m under the force, and comes back", before - under);
    free(text);
    dem_free(d);
}

/* The chain at T_low; the upper wall is heated from 3.3 s on: with steps of 0.02 s. */
static void test_condition(void)
{
    char pause[160];
    double exact[N];
    struct told told = {0};

    snprintf(pause, sizeof pause, at_rest, "step 0.02;");
    char *const text = scene(pause, "temperature { start 3.3; }", "insert { chain { temperature 300; } }");
    struct dem *const d = begin(text, 0, NULL);

    run_until(d, 3.3, 10.0, &told);
    for (int n = 0; n < N; n++)
    {
        exact[n] = T_low;
    }
    TAP_OK(worst(d, exact) == 0.0 && told.resumptions == 0, "nothing flows before a wall is heated");
    run_until(d, 4.3, 10.0, &told);
    integrate(d0, T_low, T_high, 1.0, exact);
    TAP_OK(told.resumptions == 0 && worst(d, exact) < 1.0,
           "a wall is heated from its time on, in the pause: %.3g K off", worst(d, exact));
    free(text);
    dem_free(d);
}

/* Stopped after each of a few steps within the pause, saved, and continued in another simulation. */
static void test_stop(void)
{
    char pause[160];
    double whole[N], T[N];
    int64_t stops = 0;
    struct told told = {0};

    snprintf(pause, sizeof pause, at_rest, "step 0.01;");
    char *const text = scene(pause, "motion { type translation; velocity (0 0 -1e-4); start 0.7; "
                                    "end 0.71; }", "");
    struct dem *d = begin(text, 0, NULL);

    run_until(d, 1.0, 0.5, &told);
    const uint64_t hash = world_hash(d);

    world_scalars(d, "temperature", whole);
    dem_free(d);

    d = begin(text, 0, NULL);
    stops_in_pauses = 1;
    for (double time = 0.0; time < 1.0*(1.0 - 1e-12);)
    {
        dem_set_stop_flag(d, &stop);
        run_until(d, 1.0, 0.5, &told);
        stops += dem_stopped(d) != 0;
        time = world_tally(d).time;
        WORLD_TRY(dem_save(d, "test_pause.dem"));
        dem_free(d);
        d = begin(text, 0, "test_pause.dem");
    }
    stops_in_pauses = 0;
    world_scalars(d, "temperature", T);
    TAP_OK(stops > 20 && world_hash(d) == hash && memcmp(T, whole, sizeof T) == 0,
           "stopped %lld times within pauses and continued: the same bits", (long long)stops);
    dem_free(d);

    /* a run without the entry goes on in motion */
    char *const moving = scene("", "", "");

    d = begin(text, 0, NULL);
    run_until(d, 0.5, 0.5, &told);
    TAP_OK(dem_paused(d), "a snapshot of a pause");
    WORLD_TRY(dem_save(d, "test_pause.dem"));
    dem_free(d);
    d = begin(moving, 0, "test_pause.dem");
    TAP_OK(!dem_paused(d) && world_at(d, 0).mass > 0.0, "without the entry it continues in motion");
    world_run(d, 0.01);
    TAP_OK(fabs(world_at(d, 0).v[2]) > 0.0, "and its spheres move again");
    free(moving);
    free(text);
    dem_free(d);
    (void)remove("test_pause.dem");
}

int main(void)
{
    TAP_TRAPS;
    test_chain();
    test_energy();
    test_wall();
    test_others();
    test_condition();
    test_stop();
    TAP_DONE;
}
