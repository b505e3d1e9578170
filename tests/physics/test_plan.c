/*
 * test_plan.c -- the numbers of `dem plan` agree with calculation by hand, its bytes with the
 * allocator, its time with the clock.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include <malloc.h>
#include <time.h>

/* four of them are printed: half of the last is 5e-4 */
static const double digits = 6e-4;

/* The number after the words, anywhere in the text; not a number when they are not there. */
static double number_after(const char *text, const char *words)
{
    const char *const at = strstr(text, words);

    return at ? strtod(at + strlen(words), NULL) : NAN;
}

static const char *plan(struct dem *d, const struct dem_run_info *ahead)
{
    static const char *text;             /* of the library: valid until the next plan */

    WORLD_TRY(dem_plan(d, ahead, &text));
    return text;
}

static double sphere(double d)
{
    return world_pi/6.0*d*d*d;
}

/* ---- contacts, step, weight ------------------------------------------------------------------ */

static void test_cup(void)
{
    const double d = 1e-3, rho = 2500.0, E = 1e7, nu = 0.3, v = 0.7, m = rho*sphere(d),
                 reduced = E/(2.0*(1.0 - nu*nu));
    const double factor = 4.0*sqrt(world_pi)*tgamma(0.4)/(5.0*tgamma(0.9))*pow(15.0/16.0, 0.4);
    const double pair = factor*pow(0.25*m*m/(0.25*d*reduced*reduced*v), 0.2);
    const double wall = factor*pow(m*m/(0.5*d*reduced*reduced*v), 0.2);
    struct dem *const w = world(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { impactSpeed 0.7; }"
        "          dry { restitution 0.85; } mindlin { friction 0.25; } }"
        "walls { cup { type box; min (0 0 0); max (0.01 0.02 0.05); } }"
        "insert { grains { type lattice; count 1000; diameter 1e-3; min (0 0 0); "
        "max (0.01 0.02 0.05); } }",
        0, NULL);
    uint64_t before, after;

    WORLD_TRY(dem_hash(w, &before));
    const char *const text = plan(w, &(struct dem_run_info){.duration = 1.0});

    TAP_NEAR(number_after(text, "glass and glass: reduced modulus "), reduced, digits*reduced,
             "reduced modulus");
    TAP_NEAR(number_after(text, "contact time "), pair, digits*pair, "contact time of two");
    TAP_NEAR(number_after(strstr(text, "walls of glass"), "contact time "), wall, digits*wall,
             "contact time at a wall");
    TAP_NEAR(number_after(strstr(text, "Contacts"), "restitution "), 0.85, 0.0, "restitution");
    TAP_NEAR(number_after(strstr(text, "Contacts"), "friction "), 0.25, 0.0, "friction");
    TAP_NEAR(number_after(text, "the limit is "), pair/20.0, digits*pair/20.0, "the step's limit");
    TAP_NEAR(number_after(text, "next would be "), wall/20.0, digits*wall/20.0, "the next limit");
    TAP_OK(strstr(text, "attraction allowed, default") &&
               !strstr(text, "restitution 0.85, default"),
           "defaults are reported");
    TAP_OK(strstr(text, "cupMaxZ            plane, glass"), "walls are listed");
    TAP_NEAR(number_after(text, "weight "), 1000.0*m*9.81, digits*1000.0*m*9.81, "weight");
    TAP_NEAR(number_after(strstr(text, "weight "), ", "), 1000.0*m*9.81/2e-4,
             digits*1000.0*m*9.81/2e-4, "weight per area");
    TAP_NEAR(number_after(text, "1 s ahead: "), ceil(20.0/pair), digits*20.0/pair, "steps");
    WORLD_TRY(dem_hash(w, &after));
    TAP_OK(before == after, "the plan changes no particle");
    dem_free(w);
}

/* A weight per area needs a constant cross-section: "weight ... N, ... Pa over A m2"; nothing is
   reported where it is unknown. */
static double section(const char *walls)
{
    struct dem *const w = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { } } walls { %s }"
        "insert { grains { type lattice; count 10; diameter 1e-3; min (0 0 0); "
        "max (0.01 0.01 0.01); } }",
        walls), 0, NULL);
    const char *const text = plan(w, &(struct dem_run_info){.duration = 1.0});
    const double area = number_after(text, " Pa over ");

    dem_free(w);
    return area;
}

static void test_columns(void)
{
    static const char tube[] =
        "t { type cylinder; point (0 0 0); axis (0 0 -2); radius 0.02; particles inside; }";
    static const char hall[] = "h { type box; min (-1 -1 0); max (1 1 1); }";
    const double disc = world_pi*4e-4;

    TAP_NEAR(section(tube), disc, digits*disc, "cross-section of a tube");
    TAP_NEAR(section(world_text("%s %s", tube, hall)), disc, digits*disc,
             "cross-section of a tube in a box");
    TAP_NEAR(section(hall), 4.0, digits*4.0, "cross-section of a box");
    TAP_OK(isnan(
               section(world_text("%s r { type plane; point (-0.1 0 0); normal (1 0 1); }", hall))),
           "none with a ramp");
    TAP_OK(isnan(
               section(world_text("%s f { type triangles; corners ((0.5 0 0) (1 0 1) (0.5 1 0)); }",
                                  hall))),
           "none with triangles");
    TAP_OK(isnan(section(
               "t { type cylinder; point (0 0 0); axis (0 1 0); radius 0.03; particles inside; }")),
           "none of a horizontal tube");
}

/* ---- fluidisation ---------------------------------------------------------------------------- */

/* Ergun: 3 pi mu d u (150 s + 1.75 e rho d u/mu)/(18 e) = e V (rho_p - rho) g, a quadratic in u;
   returns e u */
static double ergun(double d, double rho_p, double rho, double mu, double e)
{
    const double s = 1.0 - e;
    const double a = 1.75*e*rho*d/mu, b = 150.0*s,
                 c = e*sphere(d)*(rho_p - rho)*9.81*18.0*e/(3.0*world_pi*mu*d);

    return e*(-b + sqrt(b*b + 4.0*a*c))/(2.0*a);
}

/* The bed of Goldschmidt: 24750 glass beads of 2.5 mm on 150 x 15 mm; Wen and Yu's velocity and the
   pressure drop from a table computed elsewhere (spheres of 2526 kg/m3 in air of 1.2 kg/m3,
   1.2e-5 Pa s). */
static void test_bed_in_scene(void)
{
    struct dem *const w = world(
        "materials { glass { density 2526; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 -9.81 0); } hertz { } gidaspow { blend switch; } "
        "pressureGradient { } }"
        "fluid { density 1.2; viscosity 1.2e-5; }"
        "domain { min (0 0 0); max (0.15 1 0.015); periodic (x z); }"
        "insert { bed { type lattice; count 24750; spacing 1; jitter 0; diameter 2.5e-3;"
        "               min (0 0 0); max (0.15 0.17251 0.015); } }",
        0, NULL);
    const char *const text = plan(w, &(struct dem_run_info){.duration = 1.0});
    /* a simple cubic lattice of distance d. 10 and 90 % of the volume of its 69 layers lie 55
       layers apart; within a layer the volume below a height differs from a uniform one by at most
       (s - s^3)/4 = 0.096 of it */
    const double lattice = 1.0 - world_pi/6.0,
                 e = number_after(text, "for a bed of void fraction "),
                 ends = 2.0*0.0963/55.0*(1.0 - lattice);
    const double balance = ergun(2.5e-3, 2526.0, 1.2, 1.2e-5, e),
                 response = 2526.0*2.5e-3*2.5e-3/(18.0*1.2e-5);

    TAP_NEAR(number_after(text, "minimum fluidisation at "), 1.322415, digits*1.322415,
             "Wen and Yu");
    TAP_NEAR(number_after(text, "and at "), balance, digits*balance,
             "where Ergun's law carries the bed");
    TAP_NEAR(e, lattice, ends, "of its own void fraction");
    TAP_OK(strstr(text, ", of the particles as they are"), "which is reported to be its own");
    TAP_NEAR(number_after(text, "Archimedes number "), 3225037.5, digits*3225037.5,
             "Archimedes number");
    TAP_NEAR(number_after(text, "response time of a particle "), response, digits*response,
             "response time");
    TAP_NEAR(number_after(text, "together           24750, diameter 0.0025 m, "), 0.51147828,
             digits*0.511, "mass");
    TAP_NEAR(number_after(strstr(text, "less buoyancy"), " N, "), 2228.9859, digits*2229.0,
             "pressure drop");
    /* Newton's Cd = 0.44 above Re = 1000 (here 2.6e3): v^2 = 4 d g (rho_p - rho)/(3 Cd rho) */
    TAP_NEAR(number_after(text, "terminal velocity of a single particle "),
             sqrt(4.0*2.5e-3*9.81*2524.8/(3.0*0.44*1.2)), 0.01, "terminal velocity");
    dem_free(w);
}

static void check_assumed(const char *scene, double balance)
{
    struct dem *const w = world(scene, 0, NULL);
    const char *const text = plan(w, &(struct dem_run_info){.duration = 1.0});

    TAP_NEAR(number_after(text, "and at "), balance, digits*balance, "Wen and Yu's void fraction");
    TAP_OK(strstr(text, "assumed"), "which is reported to be assumed");
    dem_free(w);
}

/* The same spheres without walls that give the cross-section, and far apart: the void fraction of
   Wen and Yu is assumed. */
static void test_unknown_packing(void)
{
    static const char *const domain[2] = {"min (0 0 0); max (0.15 1 0.015); periodic (z);",
                                          "min (0 0 0); max (0.15 1 0.015); periodic (x z);"};
    const double e = pow(14.0, -1.0/3.0), balance = ergun(2.5e-3, 2526.0, 1.2, 1.2e-5, e);

    /* no section; spheres four diameters apart */
    for (int k = 0; k < 2; k++)
    {
        char *const scene = world_text(
            "materials { glass { density 2526; youngsModulus 1e7; } }"
            "effects { gravity { acceleration (0 -9.81 0); } hertz { } gidaspow { blend switch; } "
            "pressureGradient { } }"
            "fluid { density 1.2; viscosity 1.2e-5; } domain { %s }"
            "insert { bed { type lattice; count 500; spacing %d; jitter 0; diameter 2.5e-3;"
            "               min (0 0 0); max (0.15 1 0.015); } }",
            domain[k], k ? 4 : 1);

        check_assumed(scene, balance);
    }
}

/* Glass of 1 mm in water at 0.05 m/s. Schiller and Naumann alone, with Wen and Yu's e^-2.65 on the
   slip U/e, carries e (1 - ...) where 3 pi mu d f(Re) e^-2.65 U/e = e V (rho_p - rho) g, Re = rho U
   d/mu in this law; Richardson and Zaki take U = u_t e^(4.45 Re_t^-0.1). */
static void test_expansion(void)
{
    const double d = 1e-3, mu = 1e-3, rho = 1000.0, U = 0.05, weight = sphere(d)*1500.0*9.81,
                 stokes = 3.0*world_pi*mu*d;
    double e = 0.5, u = 0.1;
    struct dem *const w = world(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { } wenYu { } pressureGradient { } }"
        "fluid { density 1000; viscosity 1e-3; }"
        "domain { min (0 0 0); max (0.01 0.01 0.1); periodic (x y); }"
        "insert { bed { type lattice; count 1000; spacing 1; jitter 0; diameter 1e-3;"
        "               min (0 0 0); max (0.01 0.01 0.1); } }",
        0, NULL);
    const char *text = plan(w, &(struct dem_run_info){.duration = 1.0, .inflow = U});

    for (int k = 0; k < 200; k++)                         /* both contract */
    {
        const double f = 1.0 + 0.15*pow(rho*u*d/mu, 0.687);

        u = 0.5*(u + weight/(stokes*f));
        e = pow(stokes*(1.0 + 0.15*pow(rho*U*d/mu, 0.687))*U/weight, 1.0/4.65);
    }
    const double measured = pow(U/u, 1.0/(4.45*pow(rho*u*d/mu, -0.1)));

    TAP_NEAR(number_after(text, "wenYu to void fraction "), e, digits*e,
             "expansion by the law of drag");
    TAP_NEAR(number_after(text, "homogeneous; to "), measured, digits*measured,
             "expansion by Richardson and Zaki");
    TAP_NEAR(number_after(text, "Zaki (1954): "), 100.0*((1.0 - measured)/(1.0 - e) - 1.0),
             0.06*fabs(100.0*((1.0 - measured)/(1.0 - e) - 1.0)),
             "the difference in height, two digits");
    text = plan(w, &(struct dem_run_info){.duration = 1.0, .inflow = 1e-3});
    TAP_OK(strstr(text, "the inlet's 0.001 m/s (superficial) is below ")
           && strstr(text, "the bed stays packed"), "a bed below minimum fluidisation");
    text = plan(w, &(struct dem_run_info){.duration = 1.0, .inflow = 1e-3, .inflow_varies = 1});
    TAP_OK(strstr(text, "the inlet's 0.001 m/s at the start (superficial) is below "),
           "a velocity that may change is the start's");
    text = plan(w, &(struct dem_run_info){.duration = 1.0, .inflow = 1.0});
    TAP_OK(strstr(text, "are carried along"), "particles above their terminal velocity");
    dem_free(w);
}

/* Stokes' law at Re = 500: 3 pi mu d u over the weight. Schiller and Naumann would give 11 times as
   much. */
static void test_law_of_its_own(void)
{
    const double d = 1e-3, u = 9.0, fraction = 3.0*world_pi*1.8e-5*d*u/(sphere(d)*2500.0*9.81);
    struct dem *const w = world(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { impactSpeed 0.1; } "
        "stokesDrag { } }"
        "fluid { density 1; viscosity 1.8e-5; velocity (0 0 9); }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); } }",
        0, NULL);
    const char *const text = plan(w, &(struct dem_run_info){.duration = 1.0});

    /* two digits are printed */
    TAP_NEAR(number_after(strstr(text, "stokesDrag         on"), ": "), 100.0*fraction,
             0.06*100.0*fraction, "drag over weight, by the scene's own law");
    dem_free(w);
}

/* The bed of Mueller, with the fluid in the columns, as the coupling writes it. */
static void test_bed_by_columns(void)
{
    struct dem *const w =
        world("materials { bead { density 1000; youngsModulus 1e7; } }"
              "effects { gravity { acceleration (0 0 -9.81); } hertz { } wenYu { } }"
              "insert { bed { type lattice; count 9240; spacing 1; jitter 0; diameter 1.2e-3;"
              "               min (0 0 0); max (0.044 0.01 0.16); } }",
              0, NULL);
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(w, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.density[i] = 1.2;
        f.viscosity[i] = 1.8e-5;
    }
    const char *const text = plan(w, &(struct dem_run_info){
        .duration = 2.0,
        .window = 1e-4,
        .why = "deltaT",
        .cross_section = 4.4e-4});
    const double weight = 9240*1000.0*sphere(1.2e-3)*9.81/4.4e-4,
                 response = 1000.0*1.44e-6/(18.0*1.8e-5);
    const double limit = dem_step_limit(w).used;

    TAP_NEAR(number_after(text, "minimum fluidisation at "), 0.33849948, digits*0.338,
             "Wen and Yu");
    TAP_NEAR(number_after(strstr(text, "weight "), ", "), weight, digits*weight,
             "weight over the section that was given");
    TAP_NEAR(number_after(strstr(text, "less buoyancy"), " N, "), 186.16978, digits*186.2,
             "pressure drop");
    TAP_OK(strstr(text, "set by deltaT: "), "what sets the fluid's time step is reported");
    TAP_NEAR(number_after(text, "set by deltaT: "), ceil(1e-4/limit), 0.0,
             "DEM steps of a fluid step");
    TAP_NEAR(number_after(text, "over response time "), 1e-4/response, 6e-3*1e-4/response,
             "fluid step over response time, three digits");
    TAP_NEAR(number_after(text, "2 s ahead: "), 2e4*ceil(1e-4/limit), 2e4*ceil(1e-4/limit)*digits,
             "steps of the run");
    TAP_OK(strstr(text, "without pressureGradient"), "what carries the weight is reported");
    TAP_NEAR(number_after(text, "dense bed of "), 9240, 0.2*9240,
             "the timed block has as many spheres, to a lattice");

    const char *const grown = plan(w, &(struct dem_run_info){
        .duration = 2.0,
        .window = 1e-5,
        .why = "maxCo, towards which it grows",
        .reached_window = 1e-4,
        .reached_why = "maxCo",
        .cross_section = 4.4e-4});

    TAP_NEAR(number_after(grown, "it grows to "), 1e-4, 0.0,
             "the time step that the fluid will reach");
    TAP_NEAR(number_after(grown, "s, set by maxCo: "), ceil(1e-4/limit), 0.0,
             "the DEM steps in it");
    TAP_NEAR(number_after(grown, "2 s ahead: "), 2e4*ceil(1e-4/limit),
             2e4*ceil(1e-4/limit)*digits, "the steps of the run with it");
    dem_free(w);
}

/* ---- memory and time ------------------------------------------------------------------------- */

static double allocated(void)
{
    const struct mallinfo2 m = mallinfo2();

    return (double)m.uordblks + (double)m.hblkhd;
}

static double bytes_after(const char *text, const char *words)
{
    const char *const at = strstr(text, words);
    char unit[8] = "", *end;

    if (!at)
    {
        return NAN;
    }
    const double number = strtod(at + strlen(words), &end);

    sscanf(end, "%7s", unit);
    return number*(unit[0] == 'k' ? 1e3 : unit[0] == 'M' ? 1e6 : 1.0);
}

static void test_cost(void)
{
    const double before = allocated();
    struct dem *const w = world(
        "materials { glass { density 2500; youngsModulus 1e6; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { } dry { restitution 0.3; } "
        "mindlin { friction 0.3; } }"
        "walls { cup { type box; min (0 0 0); max (0.01 0.03 0.05); } }"
        "insert { grains { type lattice; count 3000; diameter 1e-3; min (0 0 0); "
        "max (0.01 0.03 0.05); } }",
        0, NULL);
    const double at_start = allocated() - before;
    const char *text = plan(w, &(struct dem_run_info){.duration = 1.0});
    const double start_reported = bytes_after(text, "now "),
                 bed_reported = bytes_after(text, "dense bed ");
    struct dem_totals a, b;

    world_run(w, 0.08);
    WORLD_TRY(dem_totals(w, &a));
    const clock_t begin = clock();

    world_run(w, 0.01);
    const double spent = (double)(clock() - begin)/CLOCKS_PER_SEC;

    WORLD_TRY(dem_totals(w, &b));
    const double each = 1e6*spent/(3000.0*(double)(b.steps - a.steps)),
                 settled = allocated() - before;

    text = plan(w, &(struct dem_run_info){.duration = 1.0});
    const double reported_time = number_after(text, "Time\n    "),
                 settled_reported = bytes_after(text, "now "),
                 copy_reported = bytes_after(text, "a particle), and ");

    WORLD_TRY(dem_backup_every(w, 0));
    const double copy = allocated() - before - settled;

    /* 7 to 9 contact rows a particle at rest, which differs from a gas; the plan states a factor of
       2 */
    TAP_OK(reported_time > 0.5*each && reported_time < 2.0*each,
           "time of a particle and step within a factor of 2: estimated %g us, measured %g us",
           reported_time, each);
    if (at_start > 0.0)
    {
        /* the walls, the scene's text and scratch memory of a rebuild are not counted: a few per
           cent of 2 MB */
        TAP_NEAR(start_reported, at_start, 0.1*at_start, "bytes at the start");
        TAP_NEAR(settled_reported, settled, 0.1*settled, "bytes of the settled bed");
        /* the number of contacts a particle is an estimate */
        TAP_NEAR(copy_reported, copy, 0.15*copy, "bytes of its copy");
        /* the capacity of lists is an estimate */
        TAP_NEAR(bed_reported, settled, 0.1*settled,
                 "bytes of the settled bed, estimated at the start");
    }
    dem_free(w);
}

/* Two boulders make long steps: a block of such spheres that is timed must not fall. Cells of a mesh are compared with
   their diameter. */
static void test_boulders(void)
{
    struct dem *const w = world(
        "materials { rock { density 2700; youngsModulus 1e7; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { } dry { restitution 0.3; } }"
        "walls { bin { type box; min (0 0 0); max (1 1 2); } }"
        "insert { rocks { type lattice; count 2; diameter 0.3; min (0 0 0); max (1 1 2); } }",
        0, NULL);
    const char *text = plan(w, &(struct dem_run_info){.duration = 1.0});

    TAP_OK(number_after(text, "Time\n    ") > 0.0, "the time of two boulders is estimated: %g us a step",
           number_after(text, "Time\n    "));
    WORLD_TRY(dem_warnings(w, &(struct dem_run_info){.cell = 0.1, .resolution = 0.1}, 0, NULL, &text));
    TAP_OK(strstr(text, "the smallest cell, 0.1 m") && strstr(text, "less than 3/4 of a particle of 0.3 m"),
           "cells smaller than particles: a warning");
    WORLD_TRY(dem_warnings(w, &(struct dem_run_info){.cell = 400.0, .resolution = 400.0}, 0, NULL, &text));
    TAP_OK(strstr(text, "1.33e+03 diameters") && strstr(text, "scale 0.001"), "a mesh in mm: a warning");
    WORLD_TRY(dem_warnings(w, &(struct dem_run_info){.cell = 0.1, .resolution = 0.45}, 0, NULL, &text));
    TAP_OK(!strstr(text, "smallest cell"), "small cells with a wide kernel: none");
    dem_free(w);
}

/* A bed that is too soft for its weight fails in the block that is timed, not in the plan. */
static void test_soft(void)
{
    struct dem *const w = world(
        "materials { rock { density 2700; youngsModulus 1e3; } }"
        "effects { gravity { acceleration (0 0 -9.81); } hertz { } dry { restitution 0.4; } mindlin { friction 0.6; } }"
        "walls { bin { type box; min (0 0 0); max (1 1 2); } }"
        "insert { rocks { type random; count 20; diameter 0.15; min (0 0 0); max (1 1 2); } }",
        0, NULL);

    TAP_OK(strstr(plan(w, &(struct dem_run_info){.duration = 2.0}), "Time\n    unknown: particles of a dense bed"),
           "a bed too soft for its weight: the plan says that its time is unknown");
    dem_free(w);
}

/* No particles yet: the steps are known. */
static void test_stream(void)
{
    struct dem *const w = world(
        "materials { glass { density 2500; youngsModulus 1e7; } } effects { hertz { } } time { step 1e-6; } "
        "insert { feed { type stream; rate 10; diameter 1e-3; min (0 0 0); max (0.01 0.01 0.01); } }",
        0, NULL);

    TAP_NEAR(number_after(plan(w, &(struct dem_run_info){.duration = 0.25}), "s ahead: "), 2.5e5, 1.0,
             "the steps of a run that begins with a stream");
    dem_free(w);
}

/*
 * Spheres of 1 mm, 2500 kg/m3, E 1e7 Pa, nu 0.3, k_m/k = 5, phi 0.05. At 1 m/s k = 1090.8212625 N/m
 * and d_lim = 6.25e-5 m (equations (1) and (2) of Open DEM Japan 2025 by hand). v_lim = d_lim
 * sqrt(k/m*) = 0.9021 m/s; restitutions integrated numerically, four digits, for v/v_lim and k_c/k.
 */
static void test_yielding(void)
{
    static const double table[][3] = {
        {0.1, 0.0, 0.8452}, {0.3, 0.2, 0.6325}, {0.5, 0.2, 0.5}, {1.0, 0.0, 0.4472},
        {1.2, 0.2, 0.5991}, {2.0, 1.0, 0.8165}, {5.0, 5.0, 0.9508}, {1.0, 1.0, -1.0},
    };
    const double m = 0.5*sphere(2e-3)*2500.0, k = 1090.8212625, limit = 6.25e-5;

    for (size_t t = 0; t < sizeof table/sizeof *table; t++)
    {
        const double v = table[t][0]*limit*sqrt(k/m);
        struct dem *const w = world(world_text(
            "materials { clay { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }"
            "effects { hookeHysteresis { unloading 5; plasticDepth 0.05; adhesion %g; stiffness %.17g; "
            "impactSpeed %.17g; } }"
            "insert { two { type list; diameter 2e-3; positions ((0 0 0) (0 0 2.1e-3)); } }",
            table[t][1], t == 0 ? 0.0 : k, t == 0 ? 1.0 : v),
            0, NULL);
        const char *const text = strstr(plan(w, &(struct dem_run_info){.duration = 1.0}), "Contacts");

        /* five digits are printed */
        TAP_NEAR(number_after(text, "stiffness "), k, 6e-5*k, "hookeHysteresis: stiffness");
        TAP_NEAR(number_after(text, "limit overlap "), limit, 6e-5*limit, "... limit overlap");
        if (table[t][2] < 0.0)
        {
            TAP_OK(strstr(text, "sticks at") != NULL, "... sticks");
        }
        else if (t > 0)
        {
            TAP_NEAR(number_after(text, "restitution by yielding "), table[t][2], 1e-4,
                     "... restitution at %g v_lim, k_c/k %g", table[t][0], table[t][1]);
        }
        dem_free(w);
    }
}

int main(void)
{
    TAP_TRAPS;
    test_cup();
    test_columns();
    test_bed_in_scene();
    test_unknown_packing();
    test_expansion();
    test_law_of_its_own();
    test_boulders();
    test_soft();
    test_stream();
    test_yielding();
    test_bed_by_columns();
    test_cost();
    TAP_DONE;
}
