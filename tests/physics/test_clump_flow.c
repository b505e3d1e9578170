/*
 * test_clump_flow.c -- rigid bodies of several spheres in a fluid: areas of their form, terminal velocity,
 * shares of their spheres, resting and turning bodies; a body of one sphere moves as the sphere.
 *
 * Closed forms for two touching spheres of radius R, a the angle between slip and axis:
 *
 * - V = 8/3 pi R^3, S = 8 pi R^2, so phi = pi d^2/S = 2^(2/3)/2;
 *   A(a) = 2 pi R^2 - R^2 (pi - 2 a - sin 2 a), by the lens of two discs 2 R sin a apart;
 *   along the axis A_l = A(pi/2) = 2 pi R^2; across it A_l is the mean of A over a = 0 .. pi/2,
 *   R^2 (3/2 pi + 2/pi).
 * - Linear drag b (u - v) on both spheres, half each: spin about an axis across decays at the rate
 *   b R^2/I, I = 7/5 M R^2, so at 5/7 of the rate b/M of the velocity.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

#include "case/simulation.h"
#include "core/vec.h"
#include "input/dictionary.h"
#include "particles/clump_flow.h"
#include <math.h>

static const char *const materials =
    "materials { glass { density 2500; youngsModulus 1e8; poissonsRatio 0.25; } }";
static const char *const pair = "shapes { s { spheres ((-1e-3 0 0 1e-3) (1e-3 0 0 1e-3)); } }";
static const char *const bent =
    "shapes { s { spheres ((0 0 0 1e-3) (1.2e-3 0 0 0.8e-3) (1.2e-3 1e-3 0 0.6e-3)); } }";

/* ---- form ------------------------------------------------------------------------------------ */

static void along(const struct dem_clump_form *f, const double n[3], double *crosswise, double *lengthwise)
{
    double column[3][DEM_BATCH_ROWS];

    for (int a = 0; a < 3; a++)
    {
        column[a][0] = n[a];
    }
    dem_clump_forms_along(f, (const int[1]){0}, column, 1, crosswise, lengthwise);
}

static const struct dem_clump_shape *shape(const char *text, struct dem_clump_shapes *s,
                                           struct dem_dict **dict)
{
    *s = (struct dem_clump_shapes){.n = 0};
    WORLD_TRY(dem_dict_read_text(dict, text, "shapes"));
    WORLD_TRY(dem_clump_shapes_read(s, *dict));
    return &s->shape[0];
}

static void areas(void)
{
    struct dem_clump_shapes all;
    struct dem_dict *dict;
    const struct dem_clump_shape *const s = shape(pair, &all, &dict);
    static struct dem_clump_form f;
    const double R = 1e-3, disc = world_pi*pow(2.0, 2.0/3.0)*R*R;
    double axis[3], worst = 0.0, cusp = 0.0, crosswise, lengthwise;

    dem_clump_form_make(&f, s, 1);
    TAP_NEAR(f.radius/R, pow(2.0, 1.0/3.0), 1e-14, "pair: radius of the sphere of its volume");
    TAP_NEAR(f.sphericity, 0.5*pow(2.0, 2.0/3.0), 1e-4, "pair: sphericity");
    dem_vec_minus(s->offset[1], s->offset[0], axis);
    for (int k = 0; k <= 90; k++)
    {
        const double a = k*world_pi/180.0;
        const double exact = R*R*(world_pi + 2.0*a + sin(2.0*a));
        double n[3], across[3], unit[3] = {0.6, -0.64, 0.48};

        dem_vec_cross(axis, unit, across);
        for (int c = 0; c < 3; c++)
        {
            n[c] = cos(a)*axis[c]/dem_vec_norm(axis) + sin(a)*across[c]/dem_vec_norm(across);
        }
        along(&f, n, &crosswise, &lengthwise);
        cusp = fmax(cusp, fabs(disc/crosswise/exact - 1.0));
        worst = a > 0.2 ? fmax(worst, fabs(disc/crosswise/exact - 1.0)) : 0.0;
        if (k == 0)
        {
            TAP_NEAR(0.5*f.surface/(R*R) - disc/lengthwise/(R*R), 2.0*world_pi, 0.01,
                     "pair: lengthwise area along its axis");
        }
        if (k == 90)
        {
            TAP_NEAR(0.5*f.surface/(R*R) - disc/lengthwise/(R*R), 1.5*world_pi + 2.0/world_pi, 0.01,
                     "pair: lengthwise area across it");
        }
    }
    /* A = pi R^2 (1 + 4 a/pi) near the axis; bilinear in a square of 1/12: +0.15/12*4/pi */
    TAP_OK(worst < 3e-3 && cusp < 1.6e-2, "pair: projected area along 91 directions, to %.2g, %.2g at its cusp",
           worst, cusp);
    dem_clump_shapes_free(&all);
    dem_dict_free(dict);
}

/* Spheres of one place, and one inside another: the form of a sphere; the centre of the shares. */
static void shares(void)
{
    struct dem_clump_shapes all;
    struct dem_dict *dict;
    static struct dem_clump_form f;
    const struct dem_clump_shape *s =
        shape("shapes { a { spheres ((0 0 0 1) (0 0 0 1) (0.2 0 0 0.5)); } }", &all, &dict);
    double crosswise, lengthwise, sum = 0.0, centre[3] = {0.0, 0.0, 0.0};

    dem_clump_form_make(&f, s, 1);
    along(&f, (const double[3]){0.3, 0.7, -0.2}, &crosswise, &lengthwise);
    TAP_OK(fabs(f.sphericity - 1.0) < 1e-4 && fabs(crosswise - 1.0) < 1e-3 && fabs(lengthwise - 1.0) < 1e-3,
           "hidden spheres do not count: %.6g, %.6g, %.6g", f.sphericity, crosswise, lengthwise);
    dem_clump_shapes_free(&all);
    dem_dict_free(dict);
    s = shape(bent, &all, &dict);
    for (size_t k = 0; k < 3; k++)
    {
        sum += s->share[k];
        for (int a = 0; a < 3; a++)
        {
            centre[a] += s->share[k]*s->offset[k][a];
        }
    }
    TAP_OK(fabs(sum - 1.0) < 1e-15 && dem_vec_norm(centre) < 1e-14*s->reach,
           "shares have the centre of the union, to %.2g of its size", dem_vec_norm(centre)/s->reach);
    dem_clump_shapes_free(&all);
    dem_dict_free(dict);
}

/* ---- motion ---------------------------------------------------------------------------------- */

/* Drag law, pressure gradient and torque on a sphere, and on a body of one. */
static void single(const char *law)
{
    const char *const scene =
        "%s effects { hertz { } dry { restitution 0.7; } mindlin { friction 0.3; }"
        " gravity { acceleration (0 0 -9.81); } %s {} pressureGradient {} viscousTorque {} } %s"
        "fluid { density 900; viscosity 2e-3; velocity (0.02 0 0.01); voidFraction 0.7; }"
        "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }"
        "insert { one { type list; material glass; %s positions ((0 0 0.0015)); velocity (0.2 0.1 -0.3);"
        " spin (30 -200 50); } }";
    struct dem *const sphere = world(world_text(scene, materials, law, "", "diameter 2e-3;"), 0, NULL),
               *const body = world(world_text(scene, materials, law, "shapes { s { spheres ((0 0 0 1e-3)); } }",
                                              "shape s;"), 0, NULL);
    double worst = 0.0;

    for (int k = 0; k < 40; k++)
    {
        world_run(sphere, 1e-3);
        world_run(body, 1e-3);
        const struct world_particle a = world_at(sphere, 0), b = world_at(body, 0);

        for (int c = 0; c < 3; c++)
        {
            worst = fmax(worst, fmax(fabs(a.x[c] - b.x[c])/1e-3, 1e-3*fabs(a.w[c] - b.w[c])));
        }
        for (int c = 0; c < 3; c++)
        {
            const enum dem_column_name out[] = {DEM_COLUMN_DRAG_IMPULSE, DEM_COLUMN_RESPONSE,
                                                DEM_COLUMN_TRANSMITTED_FRACTION};
            const double of[2] = {dem_column(&sphere->state.particles, out[c])[0],
                                  dem_column(&body->state.particles, out[c])[0]};

            worst = fmax(worst, fabs(of[0] - of[1])/(fabs(of[0]) + 1e-12));
        }
    }
    TAP_OK(worst < 1e-9, "%s: one sphere moves as a body of one and drags the fluid as it, to %.2g", law, worst);
    dem_free(sphere);
    dem_free(body);
}

static double cd(double re, double phi, double along, double across)
{
    return 8.0/re/sqrt(along) + 16.0/re/sqrt(phi) + 3.0/sqrt(re)/pow(phi, 0.75) +
           0.42*pow(10.0, 0.4*pow(-log10(phi), 0.2))/across;
}

/* A pair falls in water, its axis along or across the fall: weight in the fluid = drag by bisection. */
static void terminal(int upright)
{
    const double R = 1e-3, rho = 1000.0, mu = 1e-3, d = 2.0*R*pow(2.0, 1.0/3.0), disc = 0.25*world_pi*d*d,
                 phi = 0.5*pow(2.0, 2.0/3.0);
    const double surface = 8.0*world_pi*R*R,
                 across = disc/(upright ? world_pi*R*R : 2.0*world_pi*R*R),
                 along = disc/(0.5*surface - R*R*(upright ? 2.0*world_pi : 1.5*world_pi + 2.0/world_pi));
    const double weight = 1500.0*9.81*world_pi/6.0*d*d*d;
    double low = 1e-3, high = 2.0;
    struct dem *const w = world(
        world_text("%s %s effects { hertz {} gravity { acceleration (0 0 -9.81); } pressureGradient {}"
                   " hoelzerSommerfeld {} } fluid { density 1000; viscosity 1e-3; }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0)); orientation (%s); } }"
                   "time { step 1e-4; force yes; }", materials, pair,
                   upright ? "0.70710678118654752 0 0.70710678118654752 0" : "1 0 0 0"), 0, NULL);

    for (int k = 0; k < 100; k++)
    {
        const double v = 0.5*(low + high);
        const int slow = cd(rho*v*d/mu, phi, along, across)*0.5*rho*v*v*disc < weight;

        low = slow ? v : low;
        high = slow ? high : v;
    }
    world_run(w, 3.0);
    TAP_NEAR(-world_at(w, 0).v[2]/low, 1.0, 1e-3, "a pair %s falls at %.4g m/s",
             upright ? "on end" : "on its side", low);
    TAP_OK(dem_vec_norm(world_at(w, 0).w) < 1e-9, "and does not turn");
    dem_free(w);
}

/* Without a floor: in a linear law the spin decays at 5/7 of the rate of the velocity. */
static void spin(void)
{
    struct dem *const d = world(
        world_text("%s %s effects { hertz {} stokesDrag {} } fluid { density 1; viscosity 2e-3; }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0)); velocity (0.1 0 0);"
                   " orientation (1 0 0 0); spin (0 0 10); } } time { step 1e-5; force yes; }", materials, pair),
        0, NULL);
    double v, w, e = 0.0;

    world_run(d, 0.2);
    v = 0.5*(world_at(d, 0).v[0] + world_at(d, 1).v[0]);
    w = world_at(d, 0).w[2];
    e = 3.0*world_pi*2e-3*2e-3*pow(2.0, 1.0/3.0)*0.2/(2500.0*8.0/3.0*world_pi*1e-9);
    TAP_NEAR(-log(v/0.1)/e, 1.0, 1e-9, "Stokes' drag on the sphere of the same volume");
    TAP_NEAR(log(w/10.0)/log(v/0.1), 5.0/7.0, 1e-4, "the spin decays at 5/7 of the rate");
    dem_free(d);
}

/* A bent body of overlapping spheres in a still fluid and its own density: no force, no moment. Falling,
   momentum that it loses is what the fluid gets. */
static void budget(void)
{
    struct dem *const still = world(
        world_text("%s %s effects { hertz {} gravity { acceleration (3 2 -9.81); } pressureGradient {}"
                   " hoelzerSommerfeld {} } fluid { density 2500; viscosity 1e-3; pressureGradient (7500 5000 -24525); }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0)); } }"
                   "time { step 1e-5; force yes; }", materials, bent), 0, NULL);
    struct dem *const falls = world(
        world_text("%s %s effects { hertz {} gravity { acceleration (0 0 -9.81); } hoelzerSommerfeld {}"
                   " viscousTorque {} } fluid { density 1000; viscosity 1e-2; velocity (0.3 0.1 0);"
                   " pressureGradient (0 0 0); vorticity (10 -20 5); }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0)); velocity (0 0 0.4);"
                   " spin (100 20 -40); } } time { step 1e-5; force yes; }", materials, bent), 0, NULL);
    double J[3] = {0.0, 0.0, 0.0}, before[3], response = 0.0;
    const struct dem_particles *const p = &falls->state.particles;

    world_run(still, 0.05);
    TAP_OK(dem_vec_norm(world_at(still, 0).v) < 1e-12 && dem_vec_norm(world_at(still, 0).w) < 1e-9,
           "a body in a fluid of its density rests: %.2g m/s, %.2g 1/s", dem_vec_norm(world_at(still, 0).v),
           dem_vec_norm(world_at(still, 0).w));
    memcpy(before, dem_clump_at(p, 0)->v, sizeof before);
    world_run(falls, 0.02);
    for (size_t k = 0; k < 3; k++)
    {
        for (size_t a = 0; a < 3; a++)
        {
            J[a] += dem_column(p, DEM_COLUMN_DRAG_IMPULSE)[3*k + a];
        }
        response += dem_column(p, DEM_COLUMN_RESPONSE)[k];
    }
    const struct dem_clump *const b = dem_clump_at(p, 0);
    double worst = 0.0, spheres = 0.0;

    for (int a = 0; a < 3; a++)
    {
        double sum = 0.0;

        for (size_t k = 0; k < 3; k++)
        {
            sum += p->record[k].mass*p->record[k].v[a];
        }
        worst = fmax(worst, fabs(b->mass*(b->v[a] - before[a] - (a == 2 ? -9.81*0.02 : 0.0)) - J[a]));
        spheres = fmax(spheres, fabs(sum - b->mass*b->v[a]));
    }
    TAP_OK(worst < 1e-13*b->mass*0.4, "the impulse of the fluid is the sum over the spheres, to %.2g of M v",
           worst/(b->mass*0.4));
    TAP_OK(spheres < 1e-13*b->mass*0.4, "spheres have the momentum of their body, to %.2g", spheres/(b->mass*0.4));
    TAP_OK(response > 0.0 && response < b->mass, "response of the body %.2g of its mass", response/b->mass);
    dem_free(still);
    dem_free(falls);
}

/* ---- energy ---------------------------------------------------------------------------------- */

/* Two bodies spin in a sheared stream. Four spheres at the corners of a tetrahedron have one moment of inertia: their
   free rotation keeps the energy to round-off. Gravity does its work in the drift, to the second order of the step.
   Returns the residual over what drag dissipates. */
static double residual(const char *shape, double step, const char *gravity, const char *more)
{
    struct dem *const d = energy_world(
        world_text("%s %s effects { hertz {} mindlin { friction 0.3; } %s"
                   " hoelzerSommerfeld {} pressureGradient {} viscousTorque {} viscousStress {} }"
                   "fluid { density 1000; viscosity 1e-2; velocity (0.3 0.1 0); pressureGradient (300 0 -9810);"
                   " vorticity (10 -20 5); viscousStress (0.1 0.2 0.3); }"
                   "insert { two { type list; material glass; shape s; positions ((0 0 0.004) (0.0005 0.0005 0.01));"
                   " velocity (0 0 -0.1); spin (100 20 -40); } } %s time { step %g; force yes; }",
                   materials, shape, gravity, more, step), 0, NULL);

    for (int k = 0; k < 7; k++)
    {
        world_run(d, 0.01);
    }
    const double lost = energy_term(d, "lost_hoelzerSommerfeld"), left = energy_term(d, "residual");

    TAP_OK(lost > 0.0 && fabs(energy_term(d, "work_hoelzerSommerfeld")) > 1e-2*lost &&
               fabs(energy_term(d, "work_viscousTorque")) > 1e-4*lost &&
               fabs(energy_term(d, "work_pressureGradient")) > 1e-2*lost, "drag, pressure and a torque do work");
    dem_free(d);
    return fabs(left/lost);
}

static void energy(void)
{
    const char *const even = "shapes { s { spheres ((1e-3 1e-3 1e-3 1.2e-3) (1e-3 -1e-3 -1e-3 1.2e-3)"
                             " (-1e-3 1e-3 -1e-3 1.2e-3) (-1e-3 -1e-3 1e-3 1.2e-3)); } }",
               *const weight = "gravity { acceleration (0 0 -9.81); }",
               *const floor = "walls { floor { type plane; material glass; point (0 0 0); normal (0 0 1); } }";
    const double free = residual(even, 2e-5, "", ""),
                 top[2] = {residual(bent, 2e-5, "", ""), residual(bent, 1e-5, "", "")},
                 bed[2] = {residual(bent, 4e-6, weight, floor), residual(bent, 2e-6, weight, floor)};

    TAP_OK(free < 1e-12, "energy balance of bodies in a fluid: closed to %.2g of what drag dissipates", free);
    TAP_NEAR(top[0]/top[1], 4.0, 0.3, "with three moments of inertia: second order of the rotation, %.2g", top[0]);
    TAP_OK(bed[0] < 1e-4 && bed[1] < 0.7*bed[0], "falling on a floor: to %.2g, %.2g at half the step", bed[0], bed[1]);
}

/* 1/s  of one body in a stream, after a window */
static double relaxation(const char *more)
{
    struct dem *const d = world(
        world_text("%s %s effects { hertz {} gidaspow {} } fluid { density 1; viscosity 1e-5; velocity (1 0 0); }"
                   "insert { one { type list; material glass; shape s; positions ((0 0 0)); %s } }",
                   materials, pair, more), 0, NULL);

    world_run(d, 1e-3);
    const double rate = dem_fluid_relaxation(d);

    dem_free(d);
    return rate;
}

static void refused(void)
{
    static const char *const laws[] = {"virtualMass {}", "magnus {}", "saffmanMei {}", "turbulentDispersion {}",
                                       "beetstra { mean around; }"};

    for (size_t k = 0; k < sizeof laws/sizeof *laws; k++)
    {
        world_refused(world_text("%s %s effects { hertz { } %s } fluid { density 1; viscosity 1e-5; }"
                                 "insert { g { type lattice; material glass; shape s; min (0 0 0);"
                                 " max (0.01 0.01 0.01); } }", materials, pair, laws[k]), "shapes");
    }
}

int main(void)
{
    TAP_TRAPS;
    areas();
    shares();
    single("gidaspow");
    single("hoelzerSommerfeld");
    terminal(1);
    terminal(0);
    spin();
    budget();
    energy();
    TAP_OK(relaxation("") > 0.0 && relaxation("frozen yes;") == 0.0, "a free body follows the fluid, a frozen one does not");
    refused();
    TAP_DONE;
}
