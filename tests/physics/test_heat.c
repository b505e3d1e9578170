/*
 * test_heat.c -- conduction in chains and pairs has the closed forms of the explicit step; frozen
 * particles conduct as before.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"

#include <math.h>

enum
{
    N = 10
};

static const double R = 3.2e-3, overlap = 3.2e-5, k = 42.0, c = 464.0, rho = 7800.0;

static double mass(double density)
{
    return density*4.0/3.0*world_pi*R*R*R;
}

/* Frozen spheres along z between walls at z = 0 and above. Walls overlap by twice as much as pairs:
   with R* = R there their conductance is 2 H. */
static struct dem *chain(double low, double high, const double T[N], double step)
{
    const double pitch = 2.0*R - overlap, first = R - 2.0*overlap;
    char positions[64*N] = "", values[32*N] = "";

    for (int n = 0; n < N; n++)
    {
        snprintf(positions + strlen(positions), 64, "(0 0 %.17g) ", first + n*pitch);
        snprintf(values + strlen(values), 32, "%.17g ", T[n]);
    }
    return world(world_text(
        "materials { steel { density %g; youngsModulus 1e7; conductivity %g; heatCapacity %g; } }"
        "effects { hertz { } dry { restitution 0.9; } mindlin { friction 0.3; } conduction { } }"
        "walls { low { type plane; point (0 0 0); normal (0 0 1); temperature { value %g; } }"
        "high { type plane; point (0 0 %.17g); normal (0 0 -1); temperature { value %g; } } }"
        "time { step %.17g; force yes; maxStartOverlap 0.1; }"
        "insert { chain { type list; frozen yes; diameter %g; positions (%s); temperatures (%s); } }",
        rho, k, c, low, 2.0*first + (N - 1)*pitch, high, step, 2.0*R, positions, values),
        0, NULL);
}

static void test_chain(void)
{
    const double H = 2.0*k*sqrt(0.5*R*overlap), C = mass(rho)*c, dt = 0.2*C/(4.0*H);
    double T[N], worst = 0.0;

    for (int n = 0; n < N; n++)
    {
        T[n] = 300.0;
    }
    struct dem *d = chain(300.0, 400.0, T, dt);

    world_run(d, 20000.0*dt);
    world_scalars(d, "temperature", T);
    for (int n = 0; n < N; n++)
    {
        worst = fmax(worst, fabs(T[n] - (300.0 + 100.0*(n + 0.5)/N)));
    }
    TAP_NEAR(worst, 0.0, 1e-8, "steady: resistances 1/2H, 1/H, ..., 1/2H in series");    /* overlaps
                                                                        are rounded to 1e-11 */
    dem_free(d);

    /* sin(m pi (n + 1/2)/N) is an eigenvector of the chain, of 4 H sin^2(m pi/2N) */
    for (int m = 1; m <= 3; m += 2)
    {
        const double steps = 100.0, s = sin(0.5*m*world_pi/N);
        const double decay = pow(1.0 - dt/C*4.0*H*s*s, steps);

        worst = 0.0;
        for (int n = 0; n < N; n++)
        {
            T[n] = 350.0 + 50.0*sin(m*world_pi*(n + 0.5)/N);
        }
        d = chain(350.0, 350.0, T, dt);
        world_run(d, steps*dt);
        world_scalars(d, "temperature", T);
        for (int n = 0; n < N; n++)
        {
            worst = fmax(worst, fabs(T[n] - 350.0 - 50.0*decay*sin(m*world_pi*(n + 0.5)/N)));
        }
        TAP_NEAR(worst, 0.0, 50.0*1e-9, "mode %d decays to %.3g in %g steps", m, decay, steps);
        TAP_NEAR(decay, exp(-steps*dt/C*4.0*H*s*s), m == 1 ? 0.01 : 0.05,
                 "near to the exponential of continuous time");
        dem_free(d);
    }
}

static double pair_conductance(const char *extra, const char *area, double modulus)
{
    struct dem *const d = world(world_text(
        "materials { a { density 7800; youngsModulus %g; poissonsRatio 0.3; conductivity 42; "
        "heatCapacity 464; %s } b { density 2500; youngsModulus %g; poissonsRatio 0.3; "
        "conductivity 1.2; heatCapacity 800; %s } }"
        "effects { hertz { } conduction { %s } }"
        "time { step 1e-3; force yes; maxStartOverlap 0.1; }"
        "insert { a { type list; material a; frozen yes; diameter %g; positions ((0 0 0)); "
        "temperature 400; }"
        "b { type list; material b; frozen yes; diameter %g; positions ((%.17g 0 0)); "
        "temperature 300; } }",
        modulus, extra, modulus, extra, area, 2.0*R, 2.0*R, 2.0*R - overlap), 0, NULL);
    const double Ca = mass(7800.0)*464.0, Cb = mass(2500.0)*800.0;
    double T[2];

    world_step(d);
    world_scalars(d, "temperature", T);
    const double H = Ca*(400.0 - T[0])/(1e-3*100.0);

    TAP_NEAR(Ca*T[0] + Cb*T[1], Ca*400.0 + Cb*300.0, 1e-15*(Ca*400.0 + Cb*300.0)*2.0,
             "a pair keeps its energy");
    dem_free(d);
    return H;
}

static void test_pair(void)
{
    const double plain = pair_conductance("", "", 1e7);
    const double exact = 4.0*42.0*1.2/(42.0 + 1.2)*sqrt(0.5*R*overlap);

    /* the change of temperature of one step, about 1e-3 K, is rounded to 6e-14 K */
    TAP_NEAR(plain/exact, 1.0, 1e-8, "conductance 4 k_a k_b/(k_a + k_b) a");
    TAP_NEAR(pair_conductance("realModulus 1e10;", "", 1e7)/plain, 0.1, 1e-8,
             "1000 times softer: a tenth of the radius under the same force");
    TAP_NEAR(pair_conductance("realModulus 1e10;", "area impact;", 1e7)/plain, pow(1e-3, 0.2), 1e-8,
             "and (1/1000)^(1/5) of it in an impact");
    TAP_NEAR(pair_conductance("realModulus 1e10;", "area overlap;", 1e7)/plain, 1.0, 1e-8,
             "no correction when asked");
}

/* a pair that pushes itself apart: frozen from its snapshot it stays, and heat limits its step */
static void test_frozen_start(void)
{
    static const char *const physics =
        "materials { steel { density 7800; youngsModulus 1e7; conductivity 42; heatCapacity 464; } }"
        "effects { hertz { } conduction { } } time { maxStartOverlap 0.1; } ";
    struct dem_view v;
    double T[2];
    char *text = world_text("%s insert { two { type list; diameter %g; "
                            "positions ((0 0 0) (%.17g 0 0)); temperatures (400 300); } }",
                            physics, 2.0*R, 2.0*R - overlap);
    struct dem *d = world(text, 0, NULL);

    WORLD_TRY(dem_save(d, "test_heat.dem"));
    const double moving = dem_step_limit(d).used;

    dem_free(d);
    text = world_text("%s start { snapshot \"test_heat.dem\"; frozen yes; }", physics);
    d = world(text, 0, NULL);
    const double step = dem_step_limit(d).used, C = mass(7800.0)*464.0,
                 H = 84.0*sqrt(0.5*R*overlap);

    world_run(d, step);
    world_scalars(d, "temperature", T);
    dem_view(d, &v);
    TAP_OK(step > 1e3*moving, "step %g s instead of %g s", step, moving);
    TAP_NEAR(T[0] - T[1], 100.0*(1.0 - 2.0*step*H/C), 1e-8*100.0, "it conducts in this step");
    TAP_OK(fabs(fabs(world_at(d, 0).x[0] - world_at(d, 1).x[0]) - (2.0*R - overlap)) < 1e-15,
           "and does not move");

    /* the plan times spheres of its own at this step: they are frozen, too */
    const char *report;

    TAP_OK(dem_plan(d, &(struct dem_run_info){.duration = 1.0}, &report) == DEM_OK,
           "its plan is made at this step: %s", dem_error_text());
    dem_free(d);
    text = world_text("%s start { snapshot \"test_heat.dem\"; temperature 350; }", physics);
    d = world(text, 0, NULL);
    world_scalars(d, "temperature", T);
    TAP_OK(T[0] == 350.0 && T[1] == 350.0, "start may give other temperatures");
    dem_free(d);
    (void)remove("test_heat.dem");
}

int main(void)
{
    TAP_TRAPS;
    test_chain();
    test_pair();
    test_frozen_start();
    TAP_DONE;
}
