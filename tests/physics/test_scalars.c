/*
 * test_scalars.c -- particle scalars, with the temperature of `conduction`.
 *
 * - Four spheres in a ring: the difference of their temperatures decays as the explicit step says,
 *   to rounding; the mean stays.
 * - Walls: a given value, a film and a flux heat a sphere as the closed forms of the step say; a wall
 *   without an entry is insulated.
 * - The program's source and coefficient are integrated exactly, at any ratio of the step to the time
 *   of relaxation; what it receives is what the sphere gained; the response is bounded.
 * - Insertion: one value, a range, a list, a table; a value out of range is refused.
 * - A scene without scalars has no column, no rate and no ghost column for them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"
#include "api/internal.h"

#include <math.h>

enum
{
    RING = 4
};

static const double R = 3.2e-3, overlap = 6.4e-5, k = 42.0, c = 4.64, rho = 7800.0;

static struct dem *ring(const char *temperature)
{
    const double d = 2.0*R - overlap;
    char *const text = world_text(
        "materials { steel { density %g; youngsModulus 1e7; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } conduction { } }"
        "domain { min (0 -1 -1); max (%.17g 1 1); periodic (x); }"
        "time { step 1e-6; maxStartOverlap 0.1; }"
        "insert { ring { type list; diameter %g; %s"
        "positions ((%.17g 0 0) (%.17g 0 0) (%.17g 0 0) (%.17g 0 0)); } }",
        rho, k, c, RING*d, 2.0*R, temperature, 0.5*d, 1.5*d, 2.5*d, 3.5*d);
    struct dem *const s = world(text, 0, NULL);

    free(text);
    return s;
}

static double at(struct dem *d, int64_t id)
{
    struct dem_view v;
    const double *const T = dem_scalar(d, dem_scalar_index(d, "temperature"));

    dem_view(d, &v);
    for (size_t n = 0; n < v.n; n++)
    {
        if (world_id(&v, n) == id)
        {
            return T[n];
        }
    }
    return NAN;
}

static double mass(void)
{
    return rho*4.0/3.0*world_pi*R*R*R;
}

/* T_i' = T_i + dt H/C (T_i-1 + T_i+1 - 2 T_i): alternating differences shrink by 1 - 4 dt H/C */
static void test_ring(void)
{
    struct dem *const d = ring("temperatures (310 290 310 290); ");
    const double H = 2.0*k*sqrt(0.5*R*overlap), dt = 1e-6, steps = 20000;
    double mean = 0.0;

    world_run(d, steps*dt);
    for (int64_t id = 0; id < RING; id++)
    {
        mean += at(d, id)/RING;
    }
    const double expected = 10.0*pow(1.0 - 4.0*dt*H/(mass()*c), steps);

    TAP_NEAR(0.5*(at(d, 0) - at(d, 1)), expected, 1e-9*10.0,     /* overlaps are rounded */
             "a ring of four: difference after %g steps", steps);
    TAP_OK(expected < 9.0, "which has changed");
    TAP_NEAR(mean, 300.0, 1e-11*300.0, "the mean stays");        /* rounding of 20000 steps */
    dem_free(d);
}

/* a sphere on a wall with this condition, one step */
static double warmed(const char *condition, double dt)
{
    char *const text = world_text(
        "materials { steel { density %g; youngsModulus 1e7; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } conduction { } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); %s } }"
        "time { step %g; maxStartOverlap 0.1; }"
        "insert { one { type list; diameter %g; positions ((0 0 %.17g)); temperature 300; } }",
        rho, k, c, condition, dt, 2.0*R, R - overlap);
    struct dem *const d = world(text, 0, NULL);

    free(text);
    world_step(d);
    const double T = at(d, 0);

    dem_free(d);
    return T - 300.0;
}

static void test_walls(void)
{
    const double dt = 1e-7, C = mass()*c, area = world_pi*R*R;

    /* the sphere has not moved yet in the first half of the kick; rounding of T */
    TAP_NEAR(warmed("temperature { value 400; }", dt)*C/dt, 2.0*k*sqrt(R*overlap)*100.0,
             300.0*2e-16*C/dt + 1e-6*2.0*k*sqrt(R*overlap)*100.0, "wall of a given temperature");
    TAP_NEAR(warmed("temperature { flux 1e6; }", dt)*C/dt, 1e6*area, 300.0*2e-16*C/dt,
             "wall with a flux");
    TAP_NEAR(warmed("temperature { value 400; film 1e5; }", dt)*C/dt, 1e5*area*100.0,
             300.0*2e-16*C/dt, "wall with a film");
    TAP_OK(warmed("", dt) == 0.0, "a wall without an entry is insulated");
    TAP_OK(warmed("temperature { value 400; start 1; }", dt) == 0.0, "before its start, too");
}

/* T -> T* + (T - T*) exp(-b t/C) + q/b (1 - exp(-b t/C)) */
static void test_exchange(void)
{
    struct dem *d;
    struct dem_scalar_exchange x;
    const double C = mass()*c, t = 1e-4;
    const double stiff[] = {1e-3, 1.0, 1e3};

    for (int n = 0; n < 3; n++)
    {
        const double b = stiff[n]*C/t, q = 0.5*b*20.0, T0 = 300.0, target = 350.0;

        d = world_begin("materials { steel { density 7800; youngsModulus 1e7; conductivity 42; "
                        "heatCapacity 4.64; } } effects { hertz { } conduction { } }"
                        "time { step 1e-5; }"
                        "insert { one { type list; diameter 6.4e-3; positions ((0 0 0)); "
                        "temperature 300; } }");
        WORLD_TRY(dem_scalar_exchange_enable(d, "temperature"));
        WORLD_TRY(dem_setup(d));
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));
        x.source[0] = q, x.coefficient[0] = b, x.target[0] = target;
        world_run(d, t);
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));

        const double rest = exp(-stiff[n]);
        const double exact = target + (T0 - target)*rest + q/b*(1.0 - rest);

        /* ten steps of rounding */
        TAP_NEAR(at(d, 0), exact, 1e-12*exact, "b t/C = %g: exact", stiff[n]);
        TAP_NEAR(x.received[0] + q*t, C*(at(d, 0) - T0), 1e-10*C*50.0,
                 "received and source make the gain");
        TAP_OK(x.response[0] > 0.0 && x.response[0] <= b*t*(1.0 + 1e-12)
                   && x.response[0] >= C*(1.0 - rest)*(1.0 - 1e-12),
               "response between that of a free value and of a held one");
        /* the partner's value rises by 1: the particle gets R in the next advance */
        const double one = target + 1.0, R_ = x.response[0], before = at(d, 0);

        WORLD_TRY(dem_scalar_correct(d, 0, &one));
        WORLD_TRY(dem_scalar_exchange(d, 0, &x));
        x.source[0] = x.coefficient[0] = 0.0;
        world_run(d, t);
        TAP_NEAR(C*(at(d, 0) - before), R_, 1e-9*R_ + 1e-12*C*300.0, "the correction arrives");
        dem_free(d);
    }
}

static void refused(const char *entry, const char *words)
{
    char *const text = world_text(
        "materials { steel { density 7800; youngsModulus 1e7; conductivity 42; heatCapacity 4.64; } }"
        "effects { hertz { } conduction { } } insert { a { type list; diameter 1e-3; "
        "positions ((0 0 0)); %s } }", entry);
    struct dem *const d = world_begin(text);

    TAP_OK(dem_setup(d) == DEM_ERROR_INPUT && strstr(dem_error_text(), words),
           "%s is refused: %s", entry, dem_error_text());
    free(text);
    dem_free(d);
}

static void test_insertion(void)
{
    struct dem *const d = ring("temperature { min 290; max 310; } ");
    double min = INFINITY, max = 0.0;

    for (int64_t id = 0; id < RING; id++)
    {
        min = fmin(min, at(d, id));
        max = fmax(max, at(d, id));
    }
    TAP_OK(min >= 290.0 && max <= 310.0 && min < max, "a range: from %g to %g K", min, max);
    dem_scalar(d, 0)[0] = 777.0;
    TAP_OK(at(d, 0) == 777.0 || at(d, 1) == 777.0 || at(d, 2) == 777.0 || at(d, 3) == 777.0,
           "the program may write values");
    dem_free(d);
    refused("temperature -1;", "from 2.22507e-308 to 100000");
    refused("temperature { min 300; max 200; }", "min 300 K is above max 200 K");
    refused("temperatures (300 310);", "1 positions, but 2 temperatures");
    refused("temperature warm;", "temperature");
    refused("liquid 1;", "liquid");
}

static void test_nothing(void)
{
    struct dem *const d = world("materials { steel { density 7800; youngsModulus 1e7; } }"
                                "effects { hertz { } } insert { a { type lattice; diameter 1e-3; "
                                "min (0 0 0); max (4e-3 4e-3 4e-3); spacing 1; jitter 0; } }",
                                0, NULL);
    const struct dem_state *const p = &d->state;

    world_step(d);
    TAP_OK(dem_scalar_count(d) == 0 && p->particles.columns == DEM_COLUMNS
               && p->particles.ghost_step.n == 0 && p->particles.ghost_window.n == 0,
           "without an effect that names one there is no column");
    TAP_OK(p->contacts.forces.rates == 0 && !p->contacts.forces.rate, "and no rate of contacts");
    /* record, force, torque */
    TAP_OK(dem_particles_bytes_per_particle(&p->particles) == 128 + 48, "a particle has 176 bytes");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    test_ring();
    test_walls();
    test_exchange();
    test_insertion();
    test_nothing();
    TAP_DONE;
}
