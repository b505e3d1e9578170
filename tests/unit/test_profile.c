/*
 * test_profile.c -- the profile of a run: phases add up to the clock, processor time is that of the
 * process, counts agree with a known scene, measuring changes nothing, and the largest overlap agrees
 * with Hertz.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/clock.h"

/* n separate spheres at rest on a floor: one contact row each. */
static struct dem *make(int n)
{
    struct dem_new_particle *const seed = calloc((size_t)n, sizeof *seed);

    for (int k = 0; k < n; k++)
    {
        seed[k] = (struct dem_new_particle){.position = {2e-3*(k%100), 2e-3*(k/100), 0.5e-3},
                                            .diameter = 1e-3, .id = k, .material = "glass"};
    }
    struct dem *const d = world(
        "materials { glass { density 2500; youngsModulus 1e6; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.5; } "
        "mindlin { friction 0.3; } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "neighbours { outerSkin 0.2; innerSkin 0.1; }", n, seed);

    free(seed);
    return d;
}

static void run(struct dem *d, int steps)
{
    world_run(d, steps*dem_step_limit(d).used);
}

static void wait_for(double seconds)
{
    const double start = dem_clock_wall();

    while (dem_clock_wall() - start < seconds)
    {
    }
}

static void times(int n, int steps)
{
    const double before = dem_clock_wall(), busy_before = dem_clock_processor();
    struct dem *const d = make(n);
    const double ready = dem_clock_wall(), busy_ready = dem_clock_processor();
    struct dem_profile f;
    double sum = 0.0;

    run(d, steps);
    const double between = dem_clock_wall();

    wait_for(0.02);
    const double requested = dem_clock_wall(), busy_requested = dem_clock_processor();

    TAP_OK(dem_profile(d, &f) == 0, "%d spheres: a profile", n);
    const double reported = dem_clock_wall(), busy_reported = dem_clock_processor();

    for (int k = 0; k < DEM_PROFILE_PHASES; k++)
    {
        TAP_OK(f.phase[k].mean >= 0.0 && f.phase[k].mean == f.phase[k].max,
               "%d spheres: %s: %.3g s of the only rank", n, f.phase[k].name, f.phase[k].mean);
        sum += f.phase[k].mean;
    }
    TAP_NEAR(sum, f.wall, 1e-12*f.wall, "%d spheres: phases add up to the total", n);          /* rounding */
    TAP_OK(f.wall >= requested - ready && f.wall <= reported - before,
           "%d spheres: %.4g s: between %.4g and %.4g "
           "s", n, f.wall, requested - ready, reported - before);
    TAP_OK(f.outside >= 0.02, "%d spheres: 0.02 s of waiting are counted as outside", n);
    /* rounding of the sum of many differences of one clock: 1e-9 s is a thousand times that */
    TAP_OK(f.wall - f.outside <= between - before + 1e-9 && f.wall - f.outside > 0.0,
           "%d spheres: the remainder is the time of the advance", n);
    TAP_OK(f.processor >= busy_requested - busy_ready && f.processor <= busy_reported - busy_before,
           "%d spheres: %.4g s of processor time: between %.4g and %.4g s", n, f.processor,
           busy_requested - busy_ready, busy_reported - busy_before);
    TAP_OK(f.imbalance == 1.0 && f.ranks == 1, "%d spheres: one rank, busy", n);
    dem_free(d);
}

static void counts(int n, int steps)
{
    struct dem *const d = make(n);
    struct dem_profile f;
    struct dem_totals t;
    const char *text;

    run(d, steps);
    dem_profile(d, &f);
    dem_totals(d, &t);
    TAP_OK(f.steps == t.steps && f.particles == n && f.contacts == t.contacts,
           "%lld steps, %lld particles, %lld contacts", (long long)f.steps, (long long)f.particles,
           (long long)f.contacts);
    TAP_OK(f.particle_steps == (int64_t)n*steps && f.row_steps == (int64_t)n*steps,
           "%lld particle-steps, as many contact rows", (long long)f.particle_steps);
    TAP_OK(f.rebuilds == 1 && f.prunes == 1, "the lists of the start are not counted as rebuilds of the run");
    /* rounding */
    TAP_NEAR(f.outer_skin/f.diameter, 0.2, 1e-12, "the outer skin");
    TAP_NEAR(f.inner_skin/f.diameter, 0.1, 1e-12, "the inner skin");
    TAP_OK(f.messages == 0 && f.rebuild_messages == 0 && f.agreements == 0, "alone: no messages");
    TAP_OK(f.bytes > 128.0*n, "a particle has 128 bytes and more, %g", f.bytes/n);
    TAP_OK(dem_profile_text(d, &text) == 0 && strstr(text, "contacts") &&
           strstr(text, "particle-steps/s") && strstr(text, "skins 0.2 and 0.1"), "as text");
    dem_free(d);
}

static void measuring_changes_nothing(void)
{
    struct dem *const a = make(50), *const b = make(50);
    struct dem_profile f;
    uint64_t first, second;

    for (int k = 0; k < 5; k++)
    {
        run(a, 20);
        run(b, 20);
        dem_profile(b, &f);
    }
    dem_hash(a, &first);
    dem_hash(b, &second);
    TAP_OK(first == second, "measuring changes no bits");
    dem_free(a);
    dem_free(b);
}

/* 40 pairs that meet head on at the speed v, at evenly spaced fractions of a step after the second:
   a contact lasts 2.9432 d_max/v (Hertz; Johnson, Contact Mechanics, 11.4), as many steps or one
   more or less. */
static void largest_overlap(double steps, double v)
{
    enum { PAIRS = 40 };
    const double pi = 3.14159265358979324, R = 0.5e-3, rho = 2500.0, E = 1e7/(2.0*(1.0 - 0.09)),
                 m = 2.0/3.0*pi*R*R*R*rho;
    const double contact = 2.9432*pow(15.0*m*v*v/(16.0*E*sqrt(0.5*R)), 0.4)/v, dt = contact/steps;
    struct dem_new_particle seed[2*PAIRS];
    struct dem_profile f;

    memset(seed, 0, sizeof seed);
    for (int k = 0; k < 2*PAIRS; k++)
    {
        const double gap = v*dt*(2.0 + (k/2 + 0.5)/PAIRS), sign = k%2 ? 1.0 : -1.0;

        seed[k] =
            (struct dem_new_particle){
                .position = {sign*(R + 0.5*gap), 4.0*R*(k/2), 0.0},
                .velocity = {-0.5*sign*v, 0.0, 0.0}, .diameter = 2.0*R, .id = k,
                .material = "ball"};
    }
    struct dem *const d = world(world_text(
        "materials { ball { density 2500; youngsModulus 1e7; } } effects { hertz {} } "
        "time { step %.17g; force yes; }", dt), 2*PAIRS, seed);

    world_run(d, fmin(250.0, 3.0*steps)*dt);
    WORLD_TRY(dem_profile(d, &f));
    const double peak = 0.5*pow(15.0*m*v*v/(16.0*E*sqrt(0.5*R)), 0.4)/R;

    /* sampled at steps: below the peak by at most (pi/2 of half a step in steps)^2/2; 1e-3 is the
       error of the leapfrog at t_c/20 */
    TAP_NEAR(f.largest_overlap/peak, 1.0, 0.5*pow(0.5*pi/steps, 2.0) + 1e-3, "the largest overlap");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    times(20, 2000);
    times(6000, 20);
    counts(300, 40);
    measuring_changes_nothing();
    largest_overlap(10.0, 1.0);
    largest_overlap(20.0, 0.5);
    largest_overlap(90.0, 0.5);
    largest_overlap(200.0, 0.5);
    TAP_DONE;
}
