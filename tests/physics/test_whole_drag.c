/*
 * test_whole_drag.c -- whole drag (set III of the averaged equations) is the law's drag over the
 * void fraction, and the same force as drag and pressure gradient together.
 *
 * Source: Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482. In a uniform steady flow e grad p =
 * -n f_d, so with n V = 1 - e the force is f_d + V n f_d/e = f_d/e.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double e = 0.5, mu = 1e-3, rho = 1000.0, d = 1e-4, rho_p = 2500.0, g = 9.81;

static double volume(void)
{
    return world_pi/6.0*d*d*d;
}

/* `gradient` is Pa/m along z */
static void give_fluid(struct dem *w, double velocity, double gradient)
{
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(w, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.velocity[3*i] = f.velocity[3*i + 1] = f.pressure_gradient[3*i] =
            f.pressure_gradient[3*i + 1] = 0.0;
        f.velocity[3*i + 2] = velocity;
        f.pressure_gradient[3*i + 2] = gradient;
        f.void_fraction[i] = e;
        f.density[i] = rho;
        f.viscosity[i] = mu;
    }
}

static struct dem *sphere(const char *more)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density %g; youngsModulus 1e6; } }"
        "effects { gravity { acceleration (0 0 %g); } hertz {} stokesDrag {} pressureGradient {} }"
        "insert { one { type list; diameter %g; positions ((0 0 0)); %s } } time { step 1e-6; }",
        rho_p, -g, d, more));
    struct dem_fluid f;

    struct dem *const w = world_start(c);
    WORLD_TRY(dem_fluid(w, &f));
    return w;
}

/* Impulse of drag, and the sum of b h. */
static double frozen(int whole, double *drag_integral)
{
    struct dem *const w = sphere("frozen yes;");
    struct dem_fluid f;

    dem_fluid_whole_drag(w, whole);
    give_fluid(w, 0.01, -rho*g);
    world_run(w, 1e-3);
    WORLD_TRY(dem_fluid(w, &f));
    const double impulse = f.drag_impulse[2];

    *drag_integral = f.drag_integral[0];
    dem_free(w);
    return impulse;
}

static double falling(int whole, double gradient)
{
    struct dem *const w = sphere("");

    dem_fluid_whole_drag(w, whole);
    give_fluid(w, 0.0, gradient);
    /* 29 relaxation times rho_p d^2/(18 mu) */
    world_run(w, 0.04);
    const double v = world_at(w, 0).v[2];

    dem_free(w);
    return v;
}

/* Impulse of lift on a frozen sphere in a shear. */
static double lift(int whole)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e6; } } "
        "effects { hertz {} saffmanMei {} }"
        "insert { one { type list; diameter 1e-4; positions ((0 0 0)); frozen yes; } } "
        "time { step 1e-6; }";
    struct dem_case *const c = world_begin(scene);
    struct dem_fluid f;

    struct dem *const w = world_start(c);
    dem_fluid_whole_drag(w, whole);
    give_fluid(w, 0.01, 0.0);
    WORLD_TRY(dem_fluid(w, &f));
    f.vorticity[0] = 0.0, f.vorticity[1] = 30.0, f.vorticity[2] = 0.0;
    world_run(w, 1e-3);
    WORLD_TRY(dem_fluid(w, &f));
    const double impulse = f.other_impulse[0];

    dem_free(w);
    return impulse;
}

int main(void)
{
    TAP_TRAPS;

    const double b = 3.0*world_pi*mu*d, weight = (rho_p - rho)*volume()*g;
    double own, whole;
    const double less = frozen(0, &own), more = frozen(1, &whole);

    TAP_NEAR(less, b*0.01*1e-3, 1e-12*less, "the law's own drag on a frozen sphere");
    TAP_NEAR(more, less/e, 1e-14*more, "whole drag: over the void fraction");
    TAP_NEAR(whole, own/e, 1e-14*whole, "whole drag: so is its coefficient");
    TAP_OK(lift(0) < 0.0, "lift of slip along z in a vorticity along y is along -x");
    TAP_NEAR(lift(1)/lift(0), 1.0/e, 1e-13, "whole drag: lift over the void fraction");

    /* the pressure gradient of a suspension that its drag carries: e dp/dz = e rho g (downwards)
       less n f_d, n V = 1 - e */
    const double fall = -e*weight/b, dynamic = (1.0 - e)/e*b*fall/volume();

    TAP_NEAR(falling(1, -rho*g), fall, 1e-9*-fall,
             "whole drag alone carries the weight less Archimedes' force");
    TAP_NEAR(falling(0, -rho*g + dynamic), fall, 1e-9*-fall,
             "drag and pressure gradient of that flow together carry it, too");
    TAP_DONE;
}
