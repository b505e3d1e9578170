/*
 * test_stages.c -- stages of a run: each begins when the one before has ended, all times that name it
 * follow, a restart goes on with the same bits, and what cannot work is refused.
 *
 * Source: kinematics; one sphere on a plane, k overlap^1.5 = m g (Hertz), energy 2/5 m g overlap.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"
#include <unistd.h>

#define GLASS "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } } effects { hertz {} dry { " \
              "restitution 0.5; } mindlin { friction 0.3; } gravity { acceleration (0 0 -10); } } "
#define FLOOR "floor { type plane; material glass; point (0 0 0); normal (0 0 1); "

static char file[] = "/tmp/stages.XXXXXX";

static double begin_of(const struct dem *d, int k)
{
    const char *why;
    double begin;

    (void)dem_run_stage(d, k, &begin, &why);
    return begin;
}

/* ---- times ----------------------------------------------------------------------------------- */

static void test_durations(void)
{
    struct dem *const d = world(
        GLASS "time { step 5e-6; } stages { wait { duration 0.01; } lift { duration 0.005; } hold {} } "
        "walls { " FLOOR "motion { type translation; velocity (0 0 0.01); start lift; end hold; } } } "
        "insert { ball { type list; diameter 1e-3; positions ((0 0 0.0005)); } } ", 0, NULL);

    world_run(d, 0.05);
    TAP_OK(begin_of(d, 0) == 0.0 && fabs(begin_of(d, 1) - 0.01) < 1e-12
               && fabs(begin_of(d, 2) - 0.015) < 1e-12, "stages of a duration begin at %.12g and %.12g s",
           begin_of(d, 1), begin_of(d, 2));
    TAP_OK(fabs(world_at(d, 0).x[2] - 0.00055) < 1e-6, "a motion from one stage to another lifts a ball by "
           "0.05 mm: to %.4g mm", 1e3*world_at(d, 0).x[2]);
    TAP_OK(!dem_stages_over(d), "the last stage, without an end, goes on");
    dem_free(d);
}

static void test_rest(void)
{
    struct dem *const d = world(
        GLASS "stages { fill { until quiet; } after { duration 0.01; } } walls { " FLOOR "} } "
        "insert { ball { type list; diameter 1e-3; positions ((0 0 0.0105)); } } ", 0, NULL);

    world_run(d, 0.5);
    /* falls for sqrt(2 h/g), and with restitution e rests after (1 + e)/(1 - e) of that */
    const double rest = 3.0*sqrt(2.0*0.01/10.0);

    TAP_OK(begin_of(d, 1) > rest && begin_of(d, 1) < rest + 0.1, "a ball that is dropped rests after "
           "%.3g s: the stage ends at %.3g s", rest, begin_of(d, 1));
    TAP_OK(dem_stages_over(d), "and the last one is over");
    dem_free(d);
}

/* A stream of 2.3 balls by mass ends after two, and rest is waited for from then on. */
static void test_stream(void)
{
    const double ball = 2500.0*4.0/3.0*acos(-1.0)*pow(0.5e-3, 3.0);
    struct dem *d;
    char scene[1024];
    struct dem_quiet quiet = {.wanted = 1, .kinetic = 1e-6, .moving = 0.01, .imbalance = 0.01};
    struct dem_totals totals;

    for (int staged = 0; staged < 2; staged++)
    {
        snprintf(scene, sizeof scene,
                 GLASS "%s walls { " FLOOR "} } insert { feed { type stream; start %g; massRate %.17g; mass %.17g; "
                 "diameter 1e-3; min (-0.005 -0.005 0.001); max (0.005 0.005 0.003); } } ",
                 staged ? "stages { fill { until quiet; } after { duration 0.01; } }" : "",
                 staged ? 0.0 : 0.05, 100.0*ball, 2.3*ball);
        d = world(scene, 0, NULL);
        double rest = 0.0;

        for (int k = 0; k < 100 && !staged && !quiet.reached; k++)
        {
            world_run(d, 0.01);
            WORLD_TRY(dem_totals(d, &totals));
            WORLD_TRY(dem_quiet_test(d, &quiet, &totals));
            rest = totals.time;
        }
        if (staged)
        {
            world_run(d, 0.5);
            rest = begin_of(d, 1);
        }
        WORLD_TRY(dem_totals(d, &totals));
        TAP_OK(totals.particles == 2 && rest > (staged ? 0.02 : 0.07) && rest < 0.4,
               "%s waits for a stream of 2.3 balls: %lld balls rest at %.3g s", staged ? "a stage" : "untilQuiet",
               (long long)totals.particles, rest);
        dem_free(d);
    }
}

/* Without a particle that can move a stage ends at once, unless a group or stream is to come in it. */
static void test_nothing_to_move(void)
{
    static const char *const scenes[][2] = {
        {"no particle", "insert { ball { type list; at drop; diameter 1e-3; positions ((0 0 0.0055)); } } "},
        {"a frozen particle", "insert { base { type list; frozen yes; diameter 1e-3; positions ((0.1 0 0.0005)); } "
         "ball { type list; at drop; diameter 1e-3; positions ((0 0 0.0055)); } } "},
        {"a driven particle", "insert { base { type list; driven yes; diameter 1e-3; velocity (0.1 0 0); "
         "positions ((0.1 0 0.0005)); } ball { type list; at drop; diameter 1e-3; positions ((0 0 0.0055)); } } "},
        {"no particle before 0.05 s",
         "insert { ball { type list; at 0.05; diameter 1e-3; positions ((0 0 0.0055)); } } "},
        {"a frozen particle before 0.05 s", "insert { base { type list; frozen yes; diameter 1e-3; positions ((0.1 0 "
         "0.0005)); } ball { type list; at 0.05; diameter 1e-3; positions ((0 0 0.0055)); } } "}};
    const double rest = 3.0*sqrt(2.0*0.005/10.0);

    for (size_t k = 0; k < sizeof scenes/sizeof *scenes; k++)
    {
        struct dem *const d = world(
            world_text(GLASS "time { step 5e-6; } stages { fill { until quiet; atMost 2; } drop { until quiet; } "
                       "after {} } walls { " FLOOR "} } %s", scenes[k][1]), 0, NULL);
        const int waits = k > 2;
        const char *why;
        double drop, after;

        world_run(d, 0.8);
        (void)dem_run_stage(d, 2, &after, &why);
        (void)dem_run_stage(d, 1, &drop, &why);
        TAP_OK(waits ? drop > 0.05 + rest && drop < 0.15 + rest : drop < 0.02 && strstr(why, "none is to come") != NULL,
               "%s: a stage that waits for rest ends at %.3g s, as %s", scenes[k][0], drop, why);
        /* a driven particle counts as one that moves */
        TAP_OK(waits || k == 2 || (after > rest && after < rest + 0.15), "and the next one %s: at %.3g s",
               waits ? "has the particle" : "waits for the ball that comes with it", after);
        dem_free(d);
    }
}

/* A plane comes down on a column of three balls until it is pressed with 10 mN. */
static void test_load(void)
{
    struct dem *const d = world(
        GLASS "time { step 2e-6; } stages { press { until { force lid; value 0.01; } } hold { } } walls { " FLOOR "} lid { type "
        "plane; material glass; point (0 0 0.0031); normal (0 0 -1); motion { type translation; velocity "
        "(0 0 -0.005); end hold; } } } "
        "insert { balls { type list; diameter 1e-3; positions ((0 0 0.0005) (0 0 0.0015) (0 0 0.0025)); } "
        "} ", 0, NULL);
    double force[3] = {0.0, 0.0, 0.0};

    world_run(d, 0.06);
    world_wall(d, "lid", force);
    TAP_OK(isfinite(begin_of(d, 1)) && force[2] > 0.0095 && force[2] < 0.0105,
           "a lid that stops at a load of 0.01 N carries %.4g N", force[2]);
    dem_free(d);
}

/* ---- walls ----------------------------------------------------------------------------------- */

/* A ball at rest on a gate that goes: what the spring held is lost, and it falls freely. */
static void test_gate(void)
{
    struct dem *const d = energy_world(
        GLASS "time { step 2e-6; } stages { settle { until quiet; } drop { } } walls { gate { type plane; material "
        "glass; point (0 0 0); normal (0 0 1); until drop; } } "
        "insert { ball { type list; diameter 1e-3; positions ((0 0 0.000499)); } } ", 0, NULL);

    while (!isfinite(begin_of(d, 1)))
    {
        world_run(d, 0.001);
    }
    const double now = world_tally(d).time, weight = 10.0*world_at(d, 0).mass;
    const double modulus = 1e7/(2.0*(1.0 - 0.09));
    const double spring = 0.4*weight*pow(weight/(4.0/3.0*modulus*sqrt(5e-4)), 2.0/3.0);

    TAP_OK(fabs(now - begin_of(d, 1)) < 0.001, "a gate goes when its stage begins, %.4g s", begin_of(d, 1));
    world_run(d, 0.02);
    const double fallen = world_tally(d).time - begin_of(d, 1);
    const double height = 0.5*10.0*fallen*fallen, start = world_at(d, 0).x[2] + height;

    TAP_OK(fabs(start - 0.000499) < 2e-6, "then the ball falls freely, from z = %.4g m", start);
    TAP_OK(fabs(energy_term(d, "lost_removed")/spring - 1.0) < 0.02,
           "the spring's %.3g J are lost: %.4g J", spring, energy_term(d, "lost_removed"));
    TAP_OK(fabs(energy_term(d, "residual")) < 0.05*spring, "and no energy is left over: %.2g J",
           energy_term(d, "residual"));
    dem_free(d);
}

static void test_lid_that_comes(void)
{
    struct dem *d = world(
        GLASS "time { step 5e-6; } walls { " FLOOR "} lid { type plane; material glass; point (0 0 0.002); "
        "normal (0 0 -1); from 0.004; } } "
        "insert { ball { type list; diameter 1e-3; velocity (0 0 -1); positions ((0 0 0.004)); } } ", 0,
        NULL);
    double top = 0.0;

    world_run(d, 0.0039);
    const int passed = world_at(d, 0).x[2] < 0.002;

    for (int k = 0; k < 300; k++)
    {
        world_run(d, 1e-4);
        top = fmax(top, world_at(d, 0).x[2]);
    }
    TAP_OK(passed && top > 0.0008 && top < 0.0016, "a lid that comes holds the ball below it: at most z = "
           "%.3g m", top);
    dem_free(d);
    d = world(GLASS "time { step 5e-6; } walls { " FLOOR "from 0.001; } } "
              "insert { ball { type list; diameter 1e-3; positions ((0 0 0)); } } ", 0, NULL);
    TAP_OK(dem_advance(d, 0.01) == DEM_ERROR_INPUT && strstr(dem_error_text(), "wall floor appears"),
           "a wall that comes inside a particle: %s", dem_error_text());
    dem_free(d);
}

/* ---- groups ---------------------------------------------------------------------------------- */

#define GROUPS GLASS "time { step 5e-6; } stages { first { duration 0.01; } second { duration 0.01; } third {} } " \
               "walls { " FLOOR "} } domain { x (0 0.01); y (0 0.01); periodic (x y); } "

static void test_groups(void)
{
    struct dem *const d = world(
        GROUPS "insert { bed { type random; count 20; diameter 1e-3; min (0 0 0); max (0.01 0.01 0.004); } "
        "more { type random; at second; solidFraction 0.05; diameter 1e-3; min (0 0 0.01); max (0.01 0.01 "
        "0.02); velocity (0 0 -0.5); } shot { type list; at 0.015; diameter 2e-3; velocity (0 0 -2); "
        "positions ((0.005 0.005 0.03)); } } ", 0, NULL);
    const int64_t expected = llround(0.05*1e-6/(world_pi/6.0*1e-9));

    world_run(d, 0.0099);
    TAP_OK(world_tally(d).particles == 20, "before their stage groups are not there");
    world_run(d, 0.0006);
    TAP_OK(world_tally(d).particles == 20 + expected && world_flow(d, 0).particles == expected,
           "%lld particles of solidFraction 0.05 come at their stage: %lld", (long long)expected,
           (long long)world_flow(d, 0).particles);
    world_run(d, 0.005);
    TAP_OK(world_flow(d, 1).particles == 1, "a list comes at its time");
    const struct world_particle shot = world_at(d, 20 + expected);

    TAP_OK(shot.x[2] > 0.0289 && shot.x[2] < 0.0293 && fabs(shot.x[0] - 0.005) < 1e-12, "where and as fast as it says: z = %.4g "
           "m", shot.x[2]);
    dem_free(d);
}

/* ---- restart --------------------------------------------------------------------------------- */

static const char all[] =
    GLASS "time { step 5e-6; } stages { fill { until { moving 0.05; lasting 0.002; } atMost 0.03; } open { "
    "until { moving 0.05; } atMost 0.02; } more { duration 0.004; } end {} } walls { " FLOOR "} gate { "
    "type plane; material glass; point (0 0 0.005); normal (0 0 1); until open; } } "
    "domain { x (0 0.006); y (0 0.006); periodic (x y); } insert { bed { type random; count 60; diameter "
    "1e-3; min (0 0 0.005); max (0.006 0.006 0.012); } late { type random; at more; count 30; diameter "
    "1e-3; min (0 0 0.006); max (0.006 0.006 0.02); velocity (0 0 -0.2); } } ";

static uint64_t continued(double at, double end)
{
    struct dem *d = world(all, 0, NULL);
    uint64_t hash;

    for (int k = 1; k <= (int)(end*1e3 + 0.5); k++)
    {
        world_run(d, 1e-3*k - world_tally(d).time);
        if (k == (int)(at*1e3 + 0.5))
        {
            struct dem_case *c = world_begin(all);

            WORLD_TRY(dem_save(d, file));
            dem_free(d);
            WORLD_TRY(dem_case_load(c, file));
            d = world_start(c);
        }
    }
    hash = world_hash(d);
    TAP_OK(isfinite(begin_of(d, 3)), "saved and continued at %g s: the last stage begins at %.6g s", at,
           begin_of(d, 3));
    dem_free(d);
    return hash;
}

static void test_restart(void)
{
    const double end = 0.06;
    const uint64_t one = continued(0.02, end), two = continued(0.038, end), three = continued(0.053, end);
    struct dem *const d = world(all, 0, NULL);

    for (int k = 1; k <= 60; k++)
    {
        world_run(d, 1e-3*k - world_tally(d).time);
        if (k == 20 || k == 38 || k == 53)
        {
            WORLD_TRY(dem_save(d, file));    /* lists are made anew after it */
        }
    }
    TAP_OK(world_hash(d) == one && one == two && two == three,
           "in whatever stage it is continued: the same bits, %016llx %016llx %016llx %016llx",
           (unsigned long long)world_hash(d), (unsigned long long)one, (unsigned long long)two,
           (unsigned long long)three);
    dem_free(d);
}

/* Stages that wait for what does not come, and what waits for them. */
static void test_left(void)
{
    struct dem *const d = world(
        GLASS "time { step 5e-6; } stages { a { until { force floor; value 1e6; } } b { duration 1; } c {} } "
        "walls { " FLOOR "motion { type translation; velocity (0 0 1); start b; } } } "
        "insert { later { type list; at b; diameter 1e-3; positions ((0 0 0.01)); } "
        "ball { type list; diameter 1e-3; positions ((0 0 0.0005)); } } ", 0, NULL);
    const char *text;

    world_run(d, 1e-3);
    WORLD_TRY(dem_stages_left_text(d, &text));
    TAP_OK(strcmp(text, "stage b never began: a waits for 1e+06 N on wall floor; for it waited group later, the "
                        "motion of wall floor\nstage c never began: b lasts 1 s\n") == 0,
           "stages that have not begun, and what waits for them: %.60s ...", text);
    dem_free(d);
}

/* ---- refusals -------------------------------------------------------------------------------- */

static void test_refusals(void)
{
    static const char *const cases[][2] = {
        {"walls { " FLOOR "until b; } }", "until: stage b, but the scene has no stages"},
        {"stages { a { duration 1; } } walls { " FLOOR "until b; } }", "unknown stage \"b\""},
        {"stages { a { duration 1; } } walls { " FLOOR "from a; until a; } }", "give a later one"},
        {"stages { a { } b { } }", "never begins"},
        {"stages { a { until quiet; duration 1; } }", "keep one"},
        {"stages { a { atMost 1; } }", "give duration"},
        {"stages { a { until rest; } }", "until rest"},
        {"stages { a { until { force lid; value 1; } } }", "no such wall"},
        {"stages { a { duration 1; } } insert { b { type lattice; at a; diameter 1e-3; min (0 0 0); max (1 1 "
         "1); } }", "type random or list"},
        {"stages { a { duration 1; } b {} } insert { b { type stream; start b; end a; rate 1; diameter 1e-3; "
         "min (0 0 0); max (1 1 1); } }", "end a is not after start b"},
        {"stages { a { until { force f; value 1; } } b {} } walls { f { type plane; point (0 0 0); normal (0 0 1); "
         "from b; } }", "stages/a waits for a force on wall f, which comes only with stages/b"},
        {"stages { a { duration 1; } b { until { force f; value 1; } } } walls { f { type plane; point (0 0 0); "
         "normal (0 0 1); until b; } }", "stages/b waits for a force on wall f, which goes with stages/b"},
        {"stages { a { until { force f; } } b {} } walls { f { type plane; point (0 0 0); normal (0 0 1); "
         "motion { type servo; force 1; maxSpeed 1; start b; } } }", "whose servo starts only with stages/b"}};

    for (size_t k = 0; k < sizeof cases/sizeof *cases; k++)
    {
        world_refused(world_text(GLASS "%s", cases[k][0]), cases[k][1]);
    }
    world_refused("materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz {} } "
                  "stages { a { until quiet; } b {} }", "no gravity");
}

int main(void)
{
    world_make_file(file);
    test_durations();
    test_rest();
    test_stream();
    test_nothing_to_move();
    test_load();
    test_gate();
    test_lid_that_comes();
    test_groups();
    test_restart();
    test_left();
    test_refusals();
    unlink(file);
    TAP_DONE;
}
