/*
 * test_jkr.c -- adhesion of Johnson, Kendall and Roberts: pull-off forces, loss of energy per
 * contact, friction without load, and a bond that seals the contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

static const double R = 0.5e-3, density = 2500.0, E = 1e7,
                    w = 0.2;        /* of each sphere; R* = R/2, m* = m/2 */

static double reduced(void)
{
    return E/(2.0*(1.0 - 0.09));
}

static double loss(void)
{
    return 7.09*pow(pow(w, 5.0)*pow(0.5*R, 4.0)/(reduced()*reduced()), 1.0/3.0);
}

static struct dem *pair(double gap, double speed, double step)
{
    const struct dem_new_particle seed[2] = {
        {.position = {0, 0, 0}, .velocity = {0.5*speed, 0, 0}, .diameter = 2.0*R, .id = 0,
         .material = "clay"},
        {.position = {2.0*R + gap, 0, 0}, .velocity = {-0.5*speed, 0, 0}, .diameter = 2.0*R,
         .id = 1, .material = "clay"}};
    return world(world_text(
        "materials { clay { density %g; youngsModulus %g; poissonsRatio 0.3; } }"
        "effects { hertz { } jkr { workOfAdhesion %g; } } time { step %g; }",
        density, E, w, step), 2, seed);
}

/* Separated slowly from an overlap: both are moved, so that every distance is sampled. */
static void pulled(void)
{
    const double Rs = 0.5*R, a = pow(world_pi*w*Rs*Rs/(8.0*reduced()), 1.0/3.0),
                 unit = a*a/Rs, step = 1e-6;
    struct dem *const d = pair(-2.0*unit, 0.0, step);
    double most = 0.0, at_touch = 0.0, last = 0.0, separation = 0.0, before;

    for (int k = 0; k < 20000 && separation == 0.0; k++)
    {
        struct dem_view v;

        before = last;
        dem_view(d, &v);
        /* the view is const; this test casts that away to move them */
        for (size_t i = 0; i < v.n; i++)
        {
            double *const u = (double *)(uintptr_t)dem_at(v.velocity, v.stride, i);
            const double m = *dem_at(v.mass, v.stride, i), side = world_id(&v, i) ? 1.0 : -1.0;

            u[0] = side*0.5*unit*5e-4/step - 0.5*step*v.force[3*i]/m;
        }
        world_step(d);
        const struct world_particle p = world_at(d, 0), q = world_at(d, 1);
        const double gap = q.x[0] - p.x[0] - 2.0*R;

        last = p.f[0];
        most = fmax(most, last);
        at_touch = gap < 0.0 ? last : at_touch;
        separation = gap > 0.0 && last == 0.0 ? gap : 0.0;
        last = separation > 0.0 ? before : last;
    }
    /* steps of 1/2000 of the unit of length; the force is flat at its peak and falls by 1 in 0.02
       units^(1/2) at separation */
    TAP_NEAR(most, 1.5*world_pi*w*Rs, 1e-6*most, "largest attraction 3/2 pi w R*");
    TAP_NEAR(at_touch, 4.0/3.0*world_pi*w*Rs, 1e-3*most,
             "4/3 pi w R* where the surfaces just touch");
    TAP_NEAR(separation, 3.0*unit, 1.01e-3*unit, "separates at 3 a_t^2/R*");
    TAP_NEAR(last, 5.0/6.0*world_pi*w*Rs, 0.03*most, "force at separation 5/6 pi w R*");
    dem_free(d);
}

static void collide(double times)
{
    const double m = world_sphere_mass(R, density), stick = sqrt(2.0*loss()/(0.5*m)), speed = times*stick;
    struct dem *const d = pair(1e-7, speed, 1e-7);
    const double before = world_tally(d).kinetic;

    world_run(d, 4e-3);
    const struct dem_totals t = world_tally(d);
    const double left = t.kinetic/before;

    if (times > 1.0)
    {
        /* 7.09 has three digits; contact begins in the step after touching, at a depth of up to v
           dt: 1 % of the energy of the jump */
        TAP_NEAR(left, 1.0 - 1.0/(times*times), 0.01,
                 "at %g times the sticking speed %.2g of the energy is left", times, left);
        TAP_NEAR(t.lost, before - t.kinetic, 0.01*loss(), "the energy lost is reported");
        TAP_NEAR(t.lost, loss(), 0.01*loss(), "it is 7.09 (w^5 R*^4/E*^2)^(1/3)");
        TAP_OK(t.stored == 0.0, "nothing is stored");
    }
    else
    {
        const struct world_particle p = world_at(d, 0), q = world_at(d, 1);

        TAP_OK(t.stored < 0.0 && q.x[0] - p.x[0] < 2.001*R,
               "at %g times the sticking speed they stay together", times);
        TAP_NEAR(t.kinetic + t.stored + t.lost, before, 0.01*loss(), "energy of the pair that sticks");
    }
    dem_free(d);
}

/* A sphere adheres without load to a plate with a moving surface: friction at its limit drags it. */
static void dragged(const char *law, const char *more, double hertz)
{
    /* in balance at x^3 = 6: see jkr.c; at a wall R* = R */
    const double a = pow(world_pi*w*R*R/(8.0*reduced()), 1.0/3.0),
                 x = pow(6.0, 1.0/3.0), d0 = a*a/R*(x*x*x*x - 4.0*x);
    const double m = world_sphere_mass(R, density), mu = 0.3, pulloff = 1.5*world_pi*w*R;
    const double push = 4.0/3.0*reduced()*sqrt(R)*pow(d0, 1.5),
                 limit = mu*(hertz*push + (1.0 - hertz)*2.0*pulloff);
    const struct dem_new_particle seed = {
        .position = {0, 0, R - d0}, .diameter = 2.0*R, .id = 0, .material = "clay"};
    struct dem *const d = world(world_text(
        "materials { clay { density %g; youngsModulus %g; poissonsRatio 0.3; } }"
        "effects { hertz { } jkr { workOfAdhesion %g; } %s { friction %g; tangentialDamping no; "
        "%s } }"
        "walls { belt { type plane; point (0 0 0); normal (0 0 1); surfaceVelocity (10 0 0); } }"
        "time { step 1e-7; }",
        density, E, w, law, mu, more), 1, &seed);

    world_run(d, 1e-4);
    const struct world_particle p = world_at(d, 0);

    world_run(d, 1e-5);
    const struct world_particle q = world_at(d, 0);

    /* the equilibrium holds to rounding of the height: 1e-16 R over d0 */
    TAP_NEAR(q.f[2], 0.0, 1e-9*pulloff, "%s %s: no normal force", law, more);
    TAP_NEAR(q.f[0], limit, 1e-9*limit, "%s %s: friction is at its limit", law, more);
    TAP_NEAR((q.v[0] - p.v[0])/1e-5, limit/m, 1e-9*limit/m,
             "%s %s: it accelerates the sphere", law, more);
    TAP_NEAR(0.4*m*R*R*(q.w[1] - p.w[1])/1e-5, -limit*(R - d0), 1e-9*limit*R,
             "%s %s: it spins the sphere", law, more);
    dem_free(d);
}

/* Two spheres in balance (x^3 = 6 in jkr.c); at 1 us a bond replaces their contact. The adhesion
   holds -4.8 6^(4/3) pi w a_t^2/8 = -7.09 (w^5 R*^4/E*^2)^(1/3) 52.33/33.68; the bond books the
   part of hertz, 8/15 E* sqrt(R*) d^(5/2). */
static void sealed(void)
{
    const double Rs = 0.5*R, Es = reduced(), a = pow(world_pi*w*Rs*Rs/(8.0*Es), 1.0/3.0),
                 x = pow(6.0, 1.0/3.0), d0 = a*a/Rs*x*(x*x*x - 4.0);
    const double unit = world_pi*w*a*a/8.0, held = -4.8*x*x*x*x*unit,
                 hertz = 8.0/15.0*Es*sqrt(Rs)*pow(d0, 2.5);
    const struct dem_new_particle seed[2] = {
        {.position = {0, 0, 0}, .diameter = 2.0*R, .id = 0, .material = "clay"},
        {.position = {2.0*R - d0, 0, 0}, .diameter = 2.0*R, .id = 1, .material = "clay"}};
    struct dem *const d = energy_world(world_text(
        "materials { clay { density %g; youngsModulus %g; poissonsRatio 0.3; } }"
        "effects { hertz { } jkr { workOfAdhesion %g; } bondLinear { normalStiffness "
        "1e9; shearStiffness 1e9; make always; time 1e-6; } } time { step 1e-7; }",
        density, E, w), 2, seed);

    TAP_NEAR(energy_term(d, "elastic_hertz") + energy_term(d, "elastic_jkr"), held, 1e-9*-held,
             "two spheres in balance hold -52.33 pi w a_t^2/8");
    world_run(d, 2e-6);
    TAP_NEAR(energy_term(d, "lost_jkr"), held - hertz, 1e-6*-held,
             "a bond that seals them: jkr loses that without the part of hertz");
    TAP_NEAR(energy_term(d, "lost_bondLinear"), hertz, 1e-6*-held, "the bond loses that part");
    TAP_NEAR(energy_term(d, "residual"), 0.0, 1e-6*-held, "the balance is closed");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    dragged("mindlin", "", 0.0);
    dragged("mindlinIncremental", "", 0.0);
    dragged("linear", "", 0.0);
    dragged("mindlin", "adhesion no;", 1.0);
    dragged("linear", "adhesion no;", 1.0);
    pulled();
    sealed();
    collide(3.0);
    collide(1.2);
    collide(0.9);
    collide(0.1);
    TAP_DONE;
}
