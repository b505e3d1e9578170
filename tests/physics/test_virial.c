/*
 * test_virial.c -- the virial of contacts, dem_virial.
 *
 * A block of 3000 spheres, compressed between periodic faces along y and z, is drawn apart along x:
 * contacts open, and prunes of the lists leave fewer contact rows. With elastic repulsion alone a
 * pair gives
 *
 *     tr W = -F l,    F = 4/3 E* sqrt(R*) d^(3/2),    d = 2 R - l,    l: distance of the centres
 *
 * Reference: the sum of -F l over all pairs, from the positions. After an advance that failed it is
 * 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "case/simulation.h"

#include <math.h>

enum
{
    LONG = 50, WIDE = 12, HIGH = 5, COUNT = LONG*WIDE*HIGH,
    STEPS = 1000, EVERY = 100    /* steps of a run, between two comparisons */
};

static const double diameter = 1e-3;

static struct dem_case *block(void)
{
    struct dem_case *const c = world_begin(
        "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.3; } }"
        "effects { hertz { } }"
        "domain { x (-1 1); y (0 0.011988); z (0 0.004995); periodic (y z); }"
        "time { step 5e-6; }");
    struct dem_new_particle *const seed = calloc(COUNT, sizeof *seed);
    const double apart = 0.999*diameter;

    for (int k = 0; k < COUNT; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {apart*(k%LONG), apart*(k/LONG%WIDE), apart*(k/(LONG*WIDE))},
            .velocity = {0.02*(k%LONG - LONG/2), 0.0, 0.0}, .diameter = diameter,
            .id = k*7919%COUNT, .material = "glass"};
    }
    WORLD_TRY(dem_case_add_particles(c, COUNT, seed));
    free(seed);
    return c;
}

/* The shortest of the periodic distances. */
static double nearest(double distance, double period)
{
    return distance - period*nearbyint(distance/period);
}

/* -F l of all pairs */
static double of_pairs(const struct dem *d)
{
    const double modulus = 5e6/(2.0*(1.0 - 0.3*0.3)), radius = 0.25*diameter;
    struct dem_view v;
    double sum = 0.0;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        const double *const x = dem_at(v.position, v.stride, i);

        for (size_t j = i + 1; j < v.n; j++)
        {
            const double *const y = dem_at(v.position, v.stride, j);
            const double a = x[0] - y[0], b = nearest(x[1] - y[1], v.period[1]),
                         c = nearest(x[2] - y[2], v.period[2]), square = a*a + b*b + c*c;

            if (square < diameter*diameter)
            {
                const double l = sqrt(square), overlap = diameter - l;

                sum -= 4.0/3.0*modulus*sqrt(radius)*overlap*sqrt(overlap)*l;
            }
        }
    }
    return sum;
}

static double trace(struct dem *d)
{
    static double w[6*COUNT];
    double sum = 0.0;

    WORLD_TRY(dem_virial(d, w));
    for (int k = 0; k < COUNT; k++)
    {
        sum += w[6*k] + w[6*k + 1] + w[6*k + 2];
    }
    return sum;
}

/* A particle leaves the domain in a rebuild of the lists: the advance fails, and there are no contacts
   to be read. */
static void after_failure(void)
{
    struct dem_case *const c = world_begin(
        "materials { glass { density 2500; youngsModulus 5e6; poissonsRatio 0.3; } }"
        "effects { hertz { } }"
        "domain { x (-0.05 0.05); }"
        "time { step 5e-6; }");
    const struct dem_new_particle pair[] = {
        {.position = {0.0, 0.0, 0.0}, .diameter = diameter, .id = 0, .material = "glass"},
        {.position = {0.999e-3, 0.0, 0.0}, .velocity = {5.0, 0.0, 0.0}, .diameter = diameter,
         .id = 1, .material = "glass"}};
    double w[12] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}, sum = 0.0;

    WORLD_TRY(dem_case_add_particles(c, 2, pair));
    WORLD_TRY(dem_case_enable_virial(c));
    struct dem *const d = world_start(c);
    TAP_OK(dem_advance(d, 0.02) != 0, "a particle leaves: %s", dem_error_text());
    WORLD_TRY(dem_virial(d, w));
    for (int k = 0; k < 12; k++)
    {
        sum += fabs(w[k]);
    }
    TAP_OK(sum == 0.0, "then the virial is 0");
    dem_free(d);
}

static void not_asked_for(void)
{
    struct dem *const d = world_start(block());
    double values[6];

    TAP_OK(dem_virial(d, values) != 0 && strstr(dem_error_text(), "dem_case_enable_virial"),
           "dem_virial without dem_case_enable_virial: %s", dem_error_text());
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    after_failure();
    not_asked_for();
    struct dem_case *const made = block();

    WORLD_TRY(dem_case_enable_virial(made));
    struct dem *const d = world_start(made);

    const struct dem_contacts *const c = &d->state.contacts;
    int shrunk = 0;

    TAP_OK(c->forces.ring > 0, "contact forces go through the ring");
    for (int k = 0; k < STEPS; k++)
    {
        const int64_t rebuilds = d->state.rebuilds;
        const uint32_t rows = c->rows.n;

        world_run(d, 5e-6);
        shrunk += d->state.rebuilds == rebuilds && c->rows.n < rows;
        if (k%EVERY == 0)
        {
            const double expected = of_pairs(d);

            /* rounding: positions of up to 0.05 m are known to 7e-18 m, overlaps of 1e-6 m to 1e-11 */
            TAP_NEAR(trace(d), expected, 1e-10*fabs(expected), "step %d: the sum over all pairs", k);
        }
        else
        {
            trace(d);
        }
    }
    TAP_OK(shrunk > 0, "%d prunes left fewer rows than before", shrunk);
    dem_free(d);
    return tap_done();
}
