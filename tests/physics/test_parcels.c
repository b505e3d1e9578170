/*
 * test_parcels.c -- parcels of l^3 grains scale as each law states; entries that have no rule are
 * refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"
#include "case/simulation.h"
#include "laws/effects.h"

#include <math.h>

static const double d = 1e-3, rho = 2500.0;

/* ---- contacts -------------------------------------------------------------------------------- */

struct impact
{
    double restitution, overlap, duration;    /* 1, 1 (of D), s */
};

/* two parcels at 0.1 m/s each; they touch within a step, not at its end */
static struct impact impact_of(const char *laws, double l)
{
    const double D = l*d, gap = 2.037e-4*D, dt = 2e-7*l;
    struct dem *const s = world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; } } effects { %s } parcels { ratio %g; }"
        "time { step %.17g; force yes; } insert { two { type list; diameter %g; "
        "positions ((0 0 0) (%.17g 0 0)); velocities ((0.1 0 0) (-0.1 0 0)); } }",
        rho, laws, l, dt, d, D + gap),
        0, NULL);
    struct impact found = {0};
    double x[2];
    int steps = 0;

    do
    {
        world_step(s);
        x[0] = world_at(s, 0).x[0], x[1] = world_at(s, 1).x[0];
        found.overlap = fmax(found.overlap, (D - (x[1] - x[0]))/D);
        found.duration += x[1] - x[0] < D ? dt : 0.0;
        steps++;
    } while (steps < 20000 && x[1] - x[0] < D + gap);
    found.restitution = (world_at(s, 1).v[0] - world_at(s, 0).v[0])/0.2;
    dem_free(s);
    return found;
}

static void test_impacts(void)
{
    static const char *const laws[] = {
        "hertz { } dry { restitution 0.7; }",
        "hertz { stiffness 1e7; } viscous { coefficient 1e-4; }",
        "hooke { stiffness 500; } viscous { coefficient 1e-3; }",
        "hooke { } dry { restitution 0.7; }",
        "hookeHysteresis { stiffness 500; unloading 3; adhesion 0.1; }",
        "hertz { } stokesDamping { restitution 0.95; viscosity 1e-3; fluidDensity 1000; }",
        "hertz { } dry { restitution 0.9; } jkr { workOfAdhesion 1e-3; }",
        "hertz { } dry { restitution 0.9; } sjkr { energyDensity 1e4; }"};

    for (int k = 0; k < (int)(sizeof laws/sizeof laws[0]); k++)
    {
        const struct impact grain = impact_of(laws[k], 1.0);

        TAP_OK(grain.restitution > 0.1 && grain.restitution < 0.99 && grain.overlap > 1e-4,
               "%s: grains return %g", laws[k], grain.restitution);
        for (double l = 2.0; l <= 3.0; l++)
        {
            const struct impact parcel = impact_of(laws[k], l);

            /* rounding of positions, 1e-16 D, in overlaps of 1e-3 D, over a thousand steps */
            TAP_NEAR(parcel.restitution, grain.restitution, 1e-9, "l = %g: as parcels do", l);
            TAP_NEAR(parcel.overlap/grain.overlap, 1.0, 1e-9, "the same overlap over diameter");
            TAP_NEAR(parcel.duration/grain.duration/l, 1.0, 1e-9, "%g times the duration", l);
        }
    }
}

/* rise of the temperature [K] in such an impact, by dissipation in the contact */
static double heated(double l)
{
    struct dem *const s = world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; heatCapacity 1e-3; } }"
        "effects { hertz { } dry { restitution 0.5; } frictionHeat { } } parcels { ratio %g; }"
        "time { step %.17g; force yes; } insert { two { type list; diameter %g; temperature 300; "
        "positions ((0 0 0) (%.17g 0 0)); velocities ((0.1 0 0) (-0.1 0 0)); } }",
        rho, l, 2e-7*l, d, l*d*(1.0 + 2.037e-4)), 0, NULL);

    for (int k = 0; k < 2000; k++)
    {
        world_step(s);
    }
    const double rise = dem_scalar(s, dem_scalar_index(s, "temperature"))[0] - 300.0;

    dem_free(s);
    return rise;
}

/* spin [of 0.2 m/s over l d] after 200 steps of a sphere that hits the floor, slides, or rolls and
   twists there, under g/l: lengths and times are l times as large, so accelerations are 1/l */
static double spin_of(const char *law, double start, double l)
{
    struct dem *const s = world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; } }"
        "effects { hertz { } dry { restitution 0.5; } %s gravity { acceleration (0 0 %.17g); } }"
        "parcels { ratio %g; } walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "time { step %.17g; force yes; } insert { one { type list; diameter %g; "
        "positions ((0 0 %.17g)); velocity (0.05 0 -0.05); spin (0 %.17g %.17g); } }",
        rho, law, -9.81/l, l, 1e-6*l, d, 0.500003*l*d, start/(l*d), start/(l*d)), 0, NULL);

    for (int k = 0; k < 200; k++)
    {
        world_step(s);
    }
    const double rest = (world_at(s, 0).w[1] + world_at(s, 0).w[2])*l*d/0.2;

    dem_free(s);
    return rest;
}

static void test_heating(void)
{
    const double grain = heated(1.0);

    /* (1 - e^2) v^2/(2 c), v of each; damping at 700 steps of an impact is within 1 % */
    TAP_NEAR(grain, 0.75*0.01/(2.0*1e-3), 0.05, "an impact heats a grain by %g K", grain);
    TAP_NEAR(heated(3.0)/grain, 1.0, 1e-9, "and a parcel of l = 3");             /* as above */
}

static void test_rolling(void)
{
    static const char *const laws[] = {"mindlin { friction 0.3; }",
                                       "mindlinIncremental { friction 0.3; }",
                                       "linear { friction 0.3; stiffness 300; }",
                                       "linear { friction 0.3; }",
                                       "rollingConstant { friction 0.1; }",
                                       "rollingSpring { friction 0.1; }",
                                       "rollingViscous { time 1e-4; }",
                                       "twistingSpring { friction 0.3; }"};

    for (int k = 0; k < (int)(sizeof laws/sizeof laws[0]); k++)
    {
        const double start = k < 4 ? 0.0 : 0.1, grain = spin_of(laws[k], start, 1.0);

        TAP_OK(fabs(grain - start/0.1) > 1e-4, "%s: the spin of a grain changes to %g", laws[k],
               grain);
        TAP_NEAR(spin_of(laws[k], start, 3.0), grain, 1e-9, "as a parcel of l = 3 does");    /* as above */
    }
}

/* ---- fluid ----------------------------------------------------------------------------------- */

struct fallen
{
    double v[3], temperature, impulse[3], response, mass;
};

/* a particle falls in a stream for 20 windows of 1 ms; l = 0: in a scene without parcels */
static struct fallen fall(const char *law, double l)
{
    char parcels[64] = "";

    if (l > 0.0)
    {
        snprintf(parcels, sizeof parcels, "parcels { ratio %g; }", l);
    }
    struct dem *const s = world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; heatCapacity 10; } }"
        "effects { %s pressureGradient { } gravity { acceleration (0 0 -9.81); } }"
        "%s time { step 1e-4; } insert { one { type list; diameter %g; positions ((0 0 0)); "
        "velocity (0.1 0 0); } }",
        rho, law, parcels, d), 0, NULL);
    struct fallen found = {.temperature = NAN};
    struct dem_fluid f;
    const int T = dem_scalar_index(s, "temperature");

    for (int k = 0; k < 20; k++)
    {
        WORLD_TRY(dem_fluid(s, &f));
        f.velocity[0] = 0.02, f.velocity[1] = 0.3, f.velocity[2] = 0.1;
        f.void_fraction[0] = 0.7, f.density[0] = 900.0, f.viscosity[0] = 2e-3;
        f.pressure_gradient[2] = -9.81*900.0;
        if (f.vorticity)
        {
            f.vorticity[0] = 20.0, f.vorticity[2] = -10.0;
        }
        if (f.mean_diameter)
        {
            f.mean_diameter[0] = 1.3*fmax(l, 1.0)*d;
        }
        if (T >= 0)
        {
            dem_scalar(s, dem_scalar_index(s, "fluidTemperature"))[0] = 350.0;
            dem_scalar(s, dem_scalar_index(s, "fluidConductivity"))[0] = 0.6;
            dem_scalar(s, dem_scalar_index(s, "fluidHeatCapacity"))[0] = 4000.0;
        }
        world_run(s, 1e-3);
    }
    const struct world_particle p = world_at(s, 0);

    WORLD_TRY(dem_fluid(s, &f));
    memcpy(found.v, p.v, sizeof found.v);
    memcpy(found.impulse, f.drag_impulse, sizeof found.impulse);
    found.response = f.response[0];
    found.mass = p.mass;
    if (T >= 0)
    {
        found.temperature = dem_scalar(s, T)[0];
    }
    dem_free(s);
    return found;
}

static void compare_falls(const char *name, const char *law)
{
    const struct fallen grain = fall(law, 0.0);

    for (double l = 1.0; l < 3.5; l += 1.0)
    {
        const struct fallen parcel = fall(law, l);
        const double n = l*l*l, size = hypot(hypot(grain.v[0], grain.v[1]), grain.v[2]);

        /* rounding of 200 steps */
        for (int k = 0; k < 3; k++)
        {
            TAP_NEAR(parcel.v[k], grain.v[k], 1e-12*size, "%s, l = %g: velocity %c of a grain", name,
                     l, 'x' + k);
            TAP_NEAR(parcel.impulse[k]/n, grain.impulse[k], 1e-12*grain.mass*size,
                     "impulse l^3 times a grain's");
        }
        TAP_NEAR(parcel.response/n/grain.mass, grain.response/grain.mass, 1e-12, "response too");
        TAP_NEAR(isnan(grain.temperature) ? 0.0 : parcel.temperature/grain.temperature - 1.0, 0.0,
                 1e-12, "temperature of a grain");
    }
}

static void test_fluid(void)
{
    char law[128];

    for (int k = 0; dem_effects[k]; k++)
    {
        if (dem_effects[k]->parcels == DEM_PARCELS_GRAINS)
        {
            snprintf(law, sizeof law, "%s { } %s", dem_effects[k]->name,
                     dem_effects[k]->drag ? "" : "stokesDrag { }");
            compare_falls(dem_effects[k]->name, law);
        }
    }
    compare_falls("beetstra around", "beetstra { mean around; }");
    compare_falls("added mass", "virtualMass { } gidaspow { }");
}

/* ---- conduction ------------------------------------------------------------------------------ */

/* resistance [m2 K/W] of a row of n particles, frozen, between walls of 400 and 300 K */
static double resistance(int n, double l)
{
    const double D = l*d, overlap = 1e-3*D, length = n*D - (n + 1)*overlap, dt = 3e-5*l*l;
    char at[4096];
    int used = 0;

    for (int k = 0; k < n; k++)
    {
        used += snprintf(at + used, sizeof at - (size_t)used, "(%.17g 0 0) ",
                         0.5*D - overlap + k*(D - overlap));
    }
    struct dem *const s = world(world_text(
        "materials { glass { density 100; youngsModulus 1e7; conductivity 10; heatCapacity 1; } }"
        "effects { hertz { } conduction { } } parcels { ratio %g; }"
        "walls { hot { type plane; point (0 0 0); normal (1 0 0); temperature { value 400; } }"
        "cold { type plane; point (%.17g 0 0); normal (-1 0 0); temperature { value 300; } } }"
        "time { step %.17g; maxStartOverlap 0.1; force yes; }"
        "insert { row { type list; diameter %g; frozen yes; positions (%s); temperature 350; } }",
        l, length, dt, d, at), 0, NULL);

    world_run(s, 8000*dt);
    /* the heat of the wall's contact, in the steady state */
    const double T = dem_scalar(s, dem_scalar_index(s, "temperature"))[0],
                 heat = 2.0*10.0*sqrt(0.5*D*overlap)*(400.0 - T);

    dem_free(s);
    return 100.0*D*D/heat;
}

/* longer rows have the same contacts at walls: the difference belongs to 8 grains or 4 parcels */
static void test_conduction(void)
{
    const double of_grains = resistance(16, 1.0) - resistance(8, 1.0),
                 of_parcels = resistance(8, 2.0) - resistance(4, 2.0);

    /* rounding of positions in overlaps of 1e-3 D; what is left of the start */
    TAP_NEAR(of_parcels/of_grains, 1.0, 1e-8, "8 mm of parcels conduct as 8 mm of grains");
}

/* ---- entries --------------------------------------------------------------------------------- */

static const char physics[] = "materials { glass { density 2500; youngsModulus 1e7; heatCapacity 800; "
                              "conductivity 1; emissivity 0.5; } } ";

static void claim_sizes(const char *what, const char *rest, double smallest, double largest,
                        double mass)
{
    struct dem *const s = world(world_text(
        "%s effects { hertz { } } time { step 1e-6; } %s", physics, rest), 0, NULL);
    struct dem_view v;
    double min = INFINITY, max = 0.0, sum = 0.0;

    world_run(s, 2e-4);
    dem_view(s, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const struct world_particle p = world_take(&v, k);

        min = fmin(min, 2.0*p.radius);
        max = fmax(max, 2.0*p.radius);
        sum += p.mass;
    }
    TAP_OK(v.n > 0 && min >= smallest*(1.0 - 1e-12) && max <= largest*(1.0 + 1e-12),
           "%s: parcels of %g to %g m", what, min, max);
    if (mass > 0.0)
    {
        /* at most half of the last particle */
        TAP_NEAR(sum, mass, 0.5*world_sphere_mass(0.5*largest, rho), "of the mass that was given");
    }
    dem_free(s);
}

static void test_sizes(void)
{
    FILE *const f = fopen("test_parcels.csv", "w");

    fprintf(f, "x, y, z, diameter, parcelRatio\n0, 0, 0, 1e-3, 2\n0.01, 0, 0, 2e-3, 1.5\n");
    fclose(f);
    claim_sizes("lattice", "parcels { ratio 2; } insert { a { type lattice; diameter 1e-3; "
                "mass 1e-3; min (0 0 0); max (0.02 0.02 0.02); } }", 2e-3, 2e-3, 1e-3);
    claim_sizes("random", "parcels { ratio 1; } insert { a { type random; sizes { type uniform; min "
                "1e-3; max 2e-3; } parcelRatio 2; mass 1e-3; min (0 0 0); max (0.02 0.02 0.02); } }",
                2e-3, 4e-3, 1e-3);
    claim_sizes("list", "parcels { ratio 3; } insert { a { type list; diameters (1e-3 2e-3); "
                "positions ((0 0 0) (0.01 0 0)); } }", 3e-3, 6e-3,
                world_sphere_mass(1.5e-3, rho) + world_sphere_mass(3e-3, rho));
    claim_sizes("list of ratios", "parcels { ratio 3; } insert { a { type list; diameter 1e-3; "
                "parcelRatios (1 2); positions ((0 0 0) (0.01 0 0)); } }", 1e-3, 2e-3,
                world_sphere_mass(0.5e-3, rho) + world_sphere_mass(1e-3, rho));
    claim_sizes("table", "parcels { ratio 3; } insert { a { type table; file "
                "\"test_parcels.csv\"; } }", 2e-3, 3e-3,
                world_sphere_mass(1e-3, rho) + world_sphere_mass(1.5e-3, rho));
    claim_sizes("stream", "parcels { ratio 2; } insert { a { type stream; diameter 1e-3; rate 1e5; "
                "min (0 0 0); max (0.02 0.02 0.02); } }", 2e-3, 2e-3, 0.0);
    (void)remove("test_parcels.csv");
}

static void refused(const char *scene, const char *words)
{
    world_refused(world_text("%s %s", physics, scene), words);
}

static void test_refusals(void)
{
    static const char one[] = "insert { a { type list; diameter 1e-3; positions ((0 0 0)); } }";
    static const char mixed[] = "parcels { ratio 1; } insert { a { type list; diameter 1e-3; "
                                "positions ((0 0 0) (1 0 0)); parcelRatios (1 2); } }";
    static const char *const wrong[] = {"", "many", "1 2", "(1 2)", "nan", "inf", "0", "-2", "1e300",
                                        "1e400", "0.999", "1001", "\"2\""};
    char text[1024], words[128];
    int laws = 0;

    for (int k = 0; dem_effects[k]; k++)
    {
        const struct dem_effect *const e = dem_effects[k];

        if (e->parcels == DEM_PARCELS_REFUSED)
        {
            snprintf(text, sizeof text, "effects { hertz { } %s { %s } } parcels { ratio 2; } %s",
                     e->name, e->example ? e->example : "", one);
            snprintf(words, sizeof words, "%s has no rule for parcels", e->name);
            refused(text, words);
            laws++;
        }
    }
    TAP_OK(laws > 0, "%d laws have no rule", laws);
    snprintf(text, sizeof text, "effects { hertz { } } parcels { ratio 0.5; } %s", one);
    refused(text, "parcelRatio 0.5 1; give a number from 1 to 1000");
    snprintf(text, sizeof text, "effects { hertz { } } parcels { } %s", one);
    refused(text, "ratio");
    for (int k = 0; k < (int)(sizeof wrong/sizeof wrong[0]); k++)
    {
        snprintf(text, sizeof text, "effects { hertz { } } parcels { ratio %s; } %s", wrong[k], one);
        refused(text, "atio");
        snprintf(text, sizeof text, "effects { hertz { } } parcels { ratio 1; } insert { a { type list; "
                 "diameter 1e-3; positions ((0 0 0)); parcelRatio %s; } }", wrong[k]);
        refused(text, "atio");
    }
    snprintf(text, sizeof text, "effects { hertz { } } parcels { ratio 2; grains 8; } %s", one);
    refused(text, "grains");
    refused("effects { hertz { } } parcels { ratio 2; } insert { a { type list; diameter 1e-3; "
            "positions ((0 0 0)); parcelRatio { min 1; max 2; } } }", "give one number");
    refused("effects { hertz { } } insert { a { type list; diameter 1e-3; positions ((0 0 0)); "
            "parcelRatio 2; } }", "parcelRatio");
    snprintf(text, sizeof text, "effects { hooke { stiffness 100; } } %s", mixed);
    refused(text, "hooke: stiffness is multiplied by the ratio of the parcels, which is 1 to 2");
    snprintf(text, sizeof text, "effects { hertz { } beetstra { mean around; } } %s", mixed);
    refused(text, "beetstra needs the mean diameter of the grains");
    snprintf(text, sizeof text, "effects { hooke { } dry { restitution 0.9; } gidaspow { } } %s%s",
             "fluid { density 1; viscosity 1e-5; } ", mixed);
    struct dem *const s = world(world_text("%s %s", physics, text), 0, NULL);

    world_step(s);
    TAP_OK(dem_scalar_index(s, "parcelRatio") >= 0, "laws that need no ratio have mixed ones");
    dem_free(s);
}

/* ---- snapshots ------------------------------------------------------------------------------- */

static void test_snapshots(void)
{
    static const char scene[] =
        "effects { hertz { } dry { restitution 0.9; } gidaspow { } gravity { acceleration (0 0 -9.81); } } "
        "fluid { density 1; viscosity 1e-5; velocity (0 0 1); } parcels { ratio 2; } "
        "time { step 1e-6; } ";
    char *text = world_text("%s %s insert { a { type lattice; diameter 1e-3; parcelRatio 3; count 20; "
                            "min (0 0 0); max (0.02 0.02 0.02); } }", physics, scene);
    struct dem *whole = world(text, 0, NULL), *half = world(text, 0, NULL);

    world_run(whole, 1e-4);
    world_run(whole, 1e-4);
    world_run(half, 1e-4);
    WORLD_TRY(dem_save(half, "test_parcels.dem"));
    dem_free(half);
    struct dem_case *c = world_begin(text);
    WORLD_TRY(dem_case_load(c, "test_parcels.dem"));
    half = world_start(c);
    TAP_OK(dem_scalar(half, 0)[0] == 3.0, "a snapshot has the ratios");
    world_run(half, 1e-4);
    TAP_OK(world_hash(half) == world_hash(whole), "a restart has the same bits");
    dem_free(half);
    dem_free(whole);

    world_refused(world_text("%s effects { hertz { } } start { snapshot \"test_parcels.dem\"; }",
                             physics), "particles are parcels");

    text = world_text("%s effects { hertz { } } insert { a { type list; diameter 1e-3; positions "
                      "((0 0 0)); } }", physics);
    half = world(text, 0, NULL);
    TAP_OK(half->state.particles.columns == DEM_COLUMNS && !half->state.interaction_table.bodies.grains,
           "a scene without parcels has no column for them");
    WORLD_TRY(dem_save(half, "test_parcels.dem"));
    dem_free(half);
    world_refused(world_text("%s effects { hertz { } } parcels { ratio 2; } start { snapshot "
                             "\"test_parcels.dem\"; }", physics), "has no parcelRatio");
    (void)remove("test_parcels.dem");
}

int main(void)
{
    TAP_TRAPS;
    test_impacts();
    test_heating();
    test_rolling();
    test_fluid();
    test_conduction();
    test_sizes();
    test_refusals();
    test_snapshots();
    TAP_DONE;
}
