/*
 * test_liquid_bridge.c -- liquid bridges have the published capillary and viscous forces, rupture
 * as published, lose the work of rupture, and conserve liquid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include <math.h>

static const double tension = 0.072, R = 1e-3, step = 1e-6;

/* liquid on particles that are in no bridge, of all and of one */
static double on_particles(struct dem *d, int64_t id)
{
    const double *const all = dem_scalar(d, dem_scalar_index(d, "liquidVolume"));
    struct dem_view v;
    double sum = 0.0;

    dem_view(d, &v);
    for (size_t n = 0; n < v.n; n++)
    {
        sum += id < 0 || world_id(&v, n) == id ? all[n] : 0.0;
    }
    return sum;
}

/* fraction of the solid angle that a touching sphere takes */
static double facing(double own, double other)
{
    return 0.5*(1.0 - cos(asin(other/(own + other))));
}

/* Rabinovich et al. (2005): 2 pi R g cos(theta)/(1 + H/2d), R the mean radius */
static double rabinovich(double mean, double V, double angle, double H)
{
    const double d = 0.5*H*(-1.0 + sqrt(1.0 + 2.0*V/(world_pi*mean*H*H)));

    return 2.0*world_pi*mean*tension*cos(angle*world_pi/180.0)/(1.0 + 0.5*H/d);
}

static double rupture_distance(double V, double angle)
{
    return (1.0 + 0.5*angle*world_pi/180.0)*cbrt(V);
}

/* ---- force over gap -------------------------------------------------------------------------- */

struct pulled    /* heavy spheres, or a sphere and a wall, that touch and are drawn apart */
{
    const char *name;
    double radius[2];    /* m   [1] 0: a wall */
    double film[2];      /* m3 */
    double angle;        /* degree */
    double max_volume;   /* 1 */
};

static struct dem *pull_apart(const struct pulled *w, double speed)
{
    const int wall = w->radius[1] == 0.0;
    char *const text = world_text(
        "materials { lead { density 1e9; youngsModulus 1e7; } }"
        "effects { liquidBridge { surfaceTension %.17g; contactAngle %.17g; maxVolume %.17g; } }"
        "time { step %.17g; force yes; } %s "
        "insert { a { type list; diameter %.17g; positions ((0 0 %.17g)); velocity (0 0 %.17g); "
        "liquidVolume %.17g; } %s }",
        tension, w->angle, w->max_volume, step,
        wall ? "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }" : "",
        2.0*w->radius[0], w->radius[0] - 2.0*speed*step, speed, w->film[0], "%s");
    char *const other = world_text(
        "b { type list; diameter %.17g; positions ((0 0 %.17g)); liquidVolume %.17g; }",
        2.0*w->radius[1], -w->radius[1], w->film[1]);
    return world(world_text(text, wall ? "" : other), 0, NULL);
}

static void test_force(const struct pulled *w)
{
    const int wall = w->radius[1] == 0.0;
    const double a = w->radius[0], b = wall ? a : w->radius[1],
                 least = fmin(a, b), mean = wall ? 2.0*a : 2.0*a*b/(a + b);
    const double wanted = facing(a, b)*w->film[0] + (wall ? 0.0 : facing(b, a)*w->film[1]),
                 V = fmin(wanted, w->max_volume*least*least*least);
    const double S = rupture_distance(V, w->angle), speed = 0.01*S/step/2.0;
    const double all = w->film[0] + (wall ? 0.0 : w->film[1]);
    struct dem *const d = pull_apart(w, speed);
    double worst = 0.0, liquid = 0.0, last = 0.0, after = 1.0;

    for (int k = 0; k < 250; k++)
    {
        world_step(d);
        const double gap = world_at(d, 0).x[2] - a
                           - (wall ? 0.0 : world_at(d, 1).x[2] + w->radius[1]);
        const double found = -world_at(d, 0).f[2];

        if (found != 0.0)
        {
            last = gap;
            worst = fmax(worst, fabs(found/rabinovich(mean, V, w->angle, fmax(gap, 1e-12)) - 1.0));
            liquid = fmax(liquid, fabs(on_particles(d, -1) + V - all));
        }
        after = gap > S ? fabs(found) : after;
    }
    /* gaps are rounded to 1e-19 m, of a force that changes over 1e-5 m and more; 1e-12 m for 0 */
    TAP_NEAR(worst, 0.0, 1e-6, "%s: the force of Rabinovich et al.", w->name);
    TAP_NEAR(last, S, 1.01*speed*step, "%s: ruptures at %.3g m", w->name, S);
    TAP_OK(after == 0.0, "%s: and no force after", w->name);
    TAP_NEAR(liquid, 0.0, 1e-14*all, "%s: liquid of particles and bridge is kept", w->name);
    TAP_NEAR(on_particles(d, -1), all, 1e-14*all, "%s: all is on the particles again", w->name);
    if (!wall)
    {
        const double scale = V/wanted;

        TAP_NEAR(on_particles(d, 0), w->film[0] - scale*facing(a, b)*w->film[0] + 0.5*V, 1e-14*all,
                 "%s: each gets half", w->name);
    }
    dem_free(d);
}

static void test_forces(void)
{
    const struct pulled cases[] = {
        {"equal spheres", {R, R}, {1e-11, 1e-11}, 0.0, 0.05},
        {"equal spheres, one dry, 40 degrees", {R, R}, {3e-11, 0.0}, 40.0, 0.05},
        {"unequal spheres", {R, 0.3*R}, {5e-12, 4e-12}, 20.0, 0.1},
        {"more liquid than a bridge takes", {R, R}, {1e-9, 1e-9}, 10.0, 0.02},
        {"sphere and wall", {R, 0.0}, {2e-11, 0.0}, 30.0, 0.05},
    };

    for (size_t k = 0; k < sizeof cases/sizeof *cases; k++)
    {
        test_force(&cases[k]);
    }
}

/* The table has force over 2 pi R g, by physics/young_laplace.py. */
static void test_young_laplace(void)
{
    double row[4*200], worst[3][2] = {{0.0}};
    const int rows = world_table("physics/liquid_bridge_young_laplace.csv", 4, 200, row);
    /* as on the page: 0, 20 and 40 degrees; gaps up to 0.3 and 0.6 of the rupture distance */
    const double limit[3][2] = {{0.21, 0.21}, {0.24, 0.28}, {0.33, 0.41}};

    for (int k = 0; k < rows; k++)
    {
        const double angle = row[4*k], V = row[4*k + 1], fraction = row[4*k + 2];
        const double S = fraction*rupture_distance(V, angle);
        const double ratio = rabinovich(1.0, V, angle, S)/(2.0*world_pi*tension)/row[4*k + 3] - 1.0;
        double *const of_angle = worst[(int)(angle/20.0)];

        of_angle[fraction > 0.3] = fmax(of_angle[fraction > 0.3], fabs(ratio));
    }
    TAP_OK(rows >= 36, "%d solutions of Young and Laplace", rows);
    for (int k = 0; k < 6; k++)
    {
        TAP_OK(worst[k/2][k%2] < limit[k/2][k%2],
               "%d degrees, %s of the rupture distance: within %.3f", 20*(k/2),
               k%2 ? "0.6" : "up to 0.3", worst[k/2][k%2]);
    }
}

/* ---- viscous force --------------------------------------------------------------------------- */

static const double mu = 0.1, roughness = 1e-6;

/* Heavy spheres, which the forces hardly slow; no surface tension. v: velocity of the first. */
static struct dem *viscous(const char *more, double gap, const double v[3])
{
    return world(world_text(
        "materials { lead { density 1e9; youngsModulus 1e7; } }"
        "effects { liquidBridge { surfaceTension 0; viscosity %.17g; roughness %.17g; %s } }"
        "time { step %.17g; force yes; }"
        "insert { a { type list; diameter %.17g; positions ((%.17g 0 0)); "
        "velocity (%.17g %.17g %.17g); liquidVolume 1e-11; }"
        "b { type list; diameter %.17g; positions ((0 0 0)); liquidVolume 1e-11; } }",
        mu, roughness, more, step, 2.0*R, 2.0*R + gap, v[0], v[1], v[2], 2.0*R), 0, NULL);
}

static void test_viscous(void)
{
    const double V = 2.0*facing(R, R)*1e-11, reduced = 0.5*R;
    const double apart[3] = {0.5, 0.0, 0.0}, along[3] = {0.5, 0.2, 0.0}, in[3] = {-0.1, 0.0, 0.0};
    struct dem *d = viscous("", -1e-6, apart);

    world_run(d, 101.0*step);
    const double h = world_at(d, 0).x[0] - world_at(d, 1).x[0] - 2.0*R,
                 X = 1.0 - 1.0/sqrt(1.0 + 2.0*V/(world_pi*R*h*h));

    /* it slows them by 1e-6 */
    TAP_NEAR(world_at(d, 0).f[0]/(-1.5*world_pi*mu*R*R*X*X/h*0.5), 1.0, 1e-5,
             "normal force of Pitois et al. at %.3g m", h);
    dem_free(d);

    d = viscous("", -1e-6, along);
    world_run(d, 21.0*step);
    const struct world_particle a = world_at(d, 0), b = world_at(d, 1);
    const double x = a.x[0] - b.x[0], y = a.x[1] - b.x[1], r = sqrt(x*x + y*y), gap = r - 2.0*R;
    const double slip = (-y*0.5 + x*0.2)/r, tangential = (-y*a.f[0] + x*a.f[1])/r;

    TAP_NEAR(tangential/(-6.0*world_pi*mu*reduced*(8.0/15.0*log(reduced/gap) + 0.9588)*slip), 1.0,
             2e-3, "tangential force of Goldman et al.");    /* slip of half a step ago */
    dem_free(d);

    d = viscous("", -1e-6, in);
    world_run(d, 2.0*step);
    TAP_OK(world_at(d, 0).f[0] == 0.0, "it rests in contact");
    dem_free(d);
    d = viscous("contact acts;", -1e-6, in);
    world_run(d, 2.0*step);
    const double thin = 1.0 - 1.0/sqrt(1.0 + 2.0*V/(world_pi*R*roughness*roughness));

    TAP_NEAR(world_at(d, 0).f[0]/(1.5*world_pi*mu*R*R*thin*thin/roughness*0.1), 1.0, 1e-6,
             "and acts at the roughness when asked");
    dem_free(d);
}

/* ---- energy ---------------------------------------------------------------------------------- */

/* Work from contact to rupture, the integral of the force. */
static double work(double mean, double V, double angle)
{
    const double S = rupture_distance(V, angle), c = 2.0*V/(world_pi*mean);

    return 2.0*world_pi*mean*tension*cos(angle*world_pi/180.0)*(S + sqrt(c) - sqrt(S*S + c));
}

static struct dem *collide(double speed, double dt)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { hertz { } liquidBridge { surfaceTension %.17g; contactAngle 20; } }"
        "time { step %.17g; }"
        "insert { a { type list; diameter %.17g; positions ((0 0 0)); velocity (%.17g 0 0); "
        "liquidVolume 1e-11; }"
        "b { type list; diameter %.17g; positions ((%.17g 0 0)); velocity (%.17g 0 0); "
        "liquidVolume 1e-11; } }",
        tension, dt, 2.0*R, 0.5*speed, 2.0*R, 2.0*R + 2e-5, -0.5*speed));

    WORLD_TRY(dem_case_enable_energy(c));
    return world_start(c);
}

static void test_loop(void)
{
    const double V = 2.0*facing(R, R)*1e-11, W = work(R, V, 20.0),
                 m = 0.5*world_sphere_mass(R, 2500.0), slowest = sqrt(2.0*W/m),
                 speed = 2.0*slowest, dt = 5e-7;
    struct dem *d = collide(speed, dt);

    world_run(d, 2e-5/speed - 2.0*dt);
    TAP_OK(world_at(d, 0).f[0] == 0.0, "no force before contact");
    world_run(d, 0.02);
    const double rebound = world_at(d, 1).v[0] - world_at(d, 0).v[0];

    /* the force begins and ends within a step */
    TAP_NEAR(0.5*m*(speed*speed - rebound*rebound)/W, 1.0, 0.01,
             "a bounce loses the work of rupture");
    TAP_NEAR(energy_term(d, "lost_liquidBridge")/W, 1.0, 0.01, "and the energy balance says so");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-3*W, "and is closed");
    TAP_NEAR(on_particles(d, 0), 1e-11, 1e-25, "liquid is back on the particles");
    dem_free(d);

    d = collide(0.98*slowest, dt);
    world_run(d, 0.05);
    TAP_OK(world_at(d, 1).x[0] - world_at(d, 0).x[0] < 2.0*R + rupture_distance(V, 20.0),
           "below the work of rupture they stay together");
    dem_free(d);
    d = collide(1.02*slowest, dt);
    world_run(d, 0.05);
    TAP_OK(world_at(d, 1).x[0] - world_at(d, 0).x[0] > 2.0*R + rupture_distance(V, 20.0),
           "above it they part");
    dem_free(d);
}

/* ---- many ------------------------------------------------------------------------------------ */

/* A sphere and its twelve neighbors in a dense packing, which the overlaps then drive apart. */
static void test_twelve(void)
{
    char positions[2048] = "(0 0 0) ";
    const double overlap = 5e-5, pitch = (2.0*R - overlap)/sqrt(2.0), film = 1e-11;

    for (int k = 0; k < 12; k++)
    {
        const int axis = k/4;
        double x[3] = {0.0};

        x[(axis + 1)%3] = k & 1 ? pitch : -pitch;
        x[(axis + 2)%3] = k & 2 ? pitch : -pitch;
        snprintf(positions + strlen(positions), 128, "(%.17g %.17g %.17g) ", x[0], x[1], x[2]);
    }
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { hertz { } liquidBridge { surfaceTension %.17g; } } time { step 1e-6; }"
        "insert { a { type list; diameter %.17g; positions (%s); liquidVolume %.17g; } }",
        tension, 2.0*R, positions, film), 0, NULL);

    TAP_NEAR(on_particles(d, -1), 13.0*film, 1e-25, "at first all liquid is on the particles");
    world_run(d, 2e-6);
    TAP_NEAR(on_particles(d, 0)/film, 1.0 - 12.0*facing(R, R), 1e-12,
             "twelve bridges take 12 f = %.3f of a film", 12.0*facing(R, R));
    world_run(d, 1e-3);
    TAP_NEAR(on_particles(d, -1), 13.0*film, 1e-14*13.0*film,
             "all of it is back when the bridges have broken");
    dem_free(d);
}

/* Two unequal spheres meet off centre, with friction and a viscous liquid; residual of the energy
   balance over the loss. */
static double oblique(double dt, int tell)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { hertz { } dry { restitution 0.9; } mindlin { friction 0.3; } "
        "liquidBridge { surfaceTension 0.072; contactAngle 30; viscosity 0.01; roughness 1e-5; } }"
        "time { step %.17g; }"
        "insert { a { type list; diameter 2e-3; positions ((0 0 0)); velocity (0.4 0.1 0); "
        "liquidVolume 2e-11; }"
        "b { type list; diameter 1.4e-3; positions ((1.4e-3 1e-3 2e-4)); "
        "velocity (-0.2 -0.1 -0.1); liquidVolume 1e-11; } }", dt));

    WORLD_TRY(dem_case_enable_energy(c));
    struct dem *const d = world_start(c);

    world_run(d, 5e-3);
    TAP_OK(!tell || on_particles(d, -1) < 3e-11, "they hold together");
    const double residual = energy_term(d, "residual")/energy_term(d, "lost_liquidBridge");

    dem_free(d);
    return fabs(residual);
}

static void test_oblique(void)
{
    const double coarse = oblique(4e-7, 1), fine = oblique(1e-7, 0);

    /* dampers are of first order */
    TAP_OK(coarse < 1e-3 && fine < 0.4*coarse,
           "residual %.2g of the loss, %.2g at a quarter of the step", coarse, fine);
}

/* more: further entries, with the place of `entry` */
static void refused(const char *effects, const char *more, const char *entry, const char *words)
{
    char *const text = world_text("materials { glass { density 2500; youngsModulus 1e7; } } "
                                  "effects { hertz { } %s } %s", effects, more),
               *const scene = world_text(text, entry);
    struct dem_case *c;
    struct dem *d;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    TAP_OK((dem_case_scene_text(c, scene, "scene") || dem_start(&c, &d)) && strstr(dem_error_text(), words),
           "refused: %s", dem_error_text());
    dem_free(d);
}

static void test_refused(void)
{
    const char *const bridge = "liquidBridge { surfaceTension 0.072; }",
               *const one = "insert { a { type list; diameter 1e-3; positions ((0 0 0)); %s } }";

    refused("liquidBridge { surfaceTension 0.072; viscosity 1e-3; }", one, "", "needs roughness");
    refused("liquidBridge { surfaceTension 0.072; contactAngle 75; }", one, "", "contactAngle");
    refused("liquidBridge { surfaceTension 0.072; } jkr { workOfAdhesion 0.1; }", one, "",
            "choose only one");
    refused("liquidBridge { surfaceTension 0.072; } stokesDamping { restitution 0.9; }", one, "",
            "choose only one");
    refused("", one, "liquidVolume 1e-12;", "liquidVolume");
    refused(bridge, one, "liquidVolume -1e-12;", "from 0 to");
    refused(bridge, "walls { floor { type plane; point (0 0 0); normal (0 0 1); %s } }",
            "liquidVolume { value 1e-12; }", "give flux");
}

int main(void)
{
    TAP_TRAPS;
    test_forces();
    test_young_laplace();
    test_viscous();
    test_loop();
    test_twelve();
    test_oblique();
    test_refused();
    TAP_DONE;
}
