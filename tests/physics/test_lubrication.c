/*
 * test_lubrication.c -- the lubrication film takes the speed of the closed form, whatever the
 * stiffness and the skins of the lists.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double mu = 0.02, roughness = 2e-6, cut_off = 1e-4;
static const double six_pi = 18.8495559215387594;

static struct dem *film(double step, const char *more, int n, const struct dem_new_particle *seed)
{
    return world(world_text(
        "materials { ball { density 2500; youngsModulus 1e8; } rigid { density 1; "
        "youngsModulus 1e30; } }"
        "effects { lubrication { viscosity %.17g; roughness %.17g; cutOff %.17g; } }"
        "time { step %.17g; } %s",
        mu, roughness, cut_off, step, more), n, seed);
}

/* (c_0/m*) (ln(h_c/h_r) - 1 + h_r/h_c) */
static double stopped_speed(double R, double m)
{
    return six_pi*mu*R*R/m*(log(cut_off/roughness) - 1.0 + roughness/cut_off);
}

/* Approach from beyond the cut-off until the gap equals the roughness. Returns the loss of relative
   speed. */
static double approach(double step, int wall)
{
    const double radius = 1e-3, other = 0.6e-3;
    struct dem_new_particle seed[2] = {
        {.position = {0.0, 0.0, radius + 1.01*cut_off}, .velocity = {0.0, 0.0, -0.2},
         .diameter = 2.0*radius, .id = 0, .material = "ball"},
        {.position = {0.0, 0.0, -other}, .diameter = 2.0*other, .id = 1, .material = "ball"}};
    struct dem *const d =
        film(step,
             wall ? "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }"
                  : "",
             wall ? 1 : 2, seed);
    const struct dem_totals before = world_tally(d);
    double gap, v[2];

    do
    {
        world_step(d);
        const struct world_particle a = world_at(d, 0), b = wall ? a : world_at(d, 1);

        gap = wall ? a.x[2] - radius : a.x[2] - b.x[2] - radius - other;
        v[0] = a.v[2];
        v[1] = wall ? 0.0 : b.v[2];
    } while (gap > roughness && v[0] < v[1]);
    const struct dem_totals after = world_tally(d);
    double kinetic = 0.0;

    for (int k = 0; k < (wall ? 1 : 2);
         k++)              /* the totals are ahead by the half kick that is still to come */
    {
        const struct world_particle p = world_at(d, k);
        const double speed = p.v[2] + 0.5*step*p.f[2]/p.mass;

        kinetic += 0.5*p.mass*speed*speed;
    }
    TAP_NEAR(after.lost, before.kinetic - kinetic, 1e-12*before.kinetic,
             "the loss is reported");     /* round-off of 5000 steps */
    if (!wall)
    {
        TAP_NEAR(after.momentum[2], before.momentum[2], 1e-13*fabs(before.momentum[2]),
                 "momentum");    /* likewise */
    }
    dem_free(d);
    return 0.2 + v[0] - v[1];
}

static void squeezed(int wall)
{
    const double R = wall ? 1e-3 : 1e-3*0.6e-3/1.6e-3, ma = world_sphere_mass(1e-3, 2500.0),
                 mb = world_sphere_mass(0.6e-3, 2500.0);
    const double expected = stopped_speed(R, wall ? ma : ma*mb/(ma + mb));
    const char *const what = wall ? "sphere and wall" : "two spheres";
    const double coarse = approach(1e-7, wall), fine = approach(0.5e-7, wall);

    /* the force lags by half a step, in which the gap changes by 1e-8 m: 0.5 % of the roughness at
       the end of the path, 0.03 % of the whole; the last step may exceed the roughness by as much
       again */
    TAP_NEAR(fine, expected, 1e-3*expected, "%s: the film reduces the speed by %.4g m/s", what,
             expected);
    TAP_OK(fabs(fine - expected) < 0.7*fabs(coarse - expected) + 1e-5*expected,
           "%s: half the step, about half the error", what);
}

/* m dv/dt = m g - c(h) v along the fall, so m g t = m v + c_0 (ln(h_0/h) - (h_0 - h)/h_c), inertia
   included. */
static void sinking(void)
{
    const double radius = 1e-3, g = 9.81, thick = 0.2, m = world_sphere_mass(radius, 2500.0),
                 start = 5e-5;
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, radius + start}, .diameter = 2.0*radius, .id = 0,
        .material = "ball"};
    struct dem *const d = world(world_text(
        "materials { ball { density 2500; youngsModulus 1e8; } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
        "effects { gravity { acceleration (0 0 %g); } lubrication { viscosity %g; "
        "roughness 9e-6; cutOff %g; } }"
        "time { step 5e-7; }",
        -g, thick, cut_off), 1, &seed);
    struct world_particle p;

    do
    {
        world_run(d, 1e-4);
        p = world_at(d, 0);
    } while (p.x[2] - radius > 1e-5);
    const struct dem_totals t = world_tally(d);
    const double h = p.x[2] - radius, film_impulse = six_pi*thick*radius*radius*
                                                     (log(start/h) - (start - h)/cut_off);

    TAP_OK(t.time > 0.02, "sinks from %g to %.3g um in %.3g s", start*1e6, h*1e6, t.time);
    /* the force lags by half a step, in which the gap changes by 1e-10 m: 1e-5 of it */
    TAP_NEAR(t.time, (film_impulse - m*p.v[2])/(m*g), 2e-5*t.time,
             "in the time of the closed form");
    /* the loss is evaluated with the speed of half a step before: an error of c dt/(2 m), 0.8 % at
       the end of the path, 0.1 % at its start */
    TAP_NEAR(t.lost + t.kinetic, m*g*(start - h), 5e-3*m*g*start,
             "the work of gravity is the loss plus the kinetic energy");
    dem_free(d);
}

/* A sphere moves through the film to the wall and back to its start: v_back/v, with the film
   inactive in contact (rests) or active (acts). */
static double rebound(const char *contact, double modulus, double v)
{
    const double radius = 1e-3, start = 1.01*cut_off;
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, radius + start}, .velocity = {0.0, 0.0, -v}, .diameter = 2.0*radius,
        .id = 0, .material = "ball"};
    struct dem *const d = world(world_text(
        "materials { ball { density 2500; youngsModulus %g; } rigid { density 1; "
        "youngsModulus 1e30; } }"
        "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }"
        "effects { hertz {} dry { restitution 0.9; } lubrication { viscosity %.17g; "
        "roughness %.17g; cutOff %.17g;"
        "contact %s; } } time { step 2e-8; }",
        modulus, mu, roughness, cut_off, contact), 1, &seed);

    do
    {
        world_run(d, 1e-5);
    } while (world_at(d, 0).x[2] - radius < start && world_tally(d).time < 5e-3);
    const double back = world_at(d, 0).v[2];

    dem_free(d);
    return back/v;
}

/* With an inactive film in contact e (v - v_t) - v_t comes back, whatever the stiffness; an active
   one takes more in a softer contact. */
static void touching(void)
{
    const double v = 0.5,
                 taken =
                     six_pi*mu*1e-6/world_sphere_mass(1e-3, 2500.0)*log(cut_off/roughness)/v,
                 expected = 0.9*(1.0 - taken) - taken;
    const double soft = rebound("rests", 1e8, v), stiff = rebound("rests", 1e10, v);

    /* the film's force lags by half a step, 1e-8 m of its 2e-6: 0.25 %; restitution in steps of
       t_c/400 and less: 0.1 % */
    TAP_NEAR(soft, expected, 5e-3*expected,
             "inactive in a soft contact: %.4f of the speed comes back", soft);
    TAP_NEAR(stiff, expected, 5e-3*expected, "inactive in a stiff contact: %.4f", stiff);
    const double longer = rebound("acts", 1e8, v), shorter = rebound("acts", 1e10, v);

    TAP_OK(longer < shorter && shorter < stiff,
           "active: %.4f of the speed in a soft contact, %.4f in a stiff one", longer, shorter);
}

/* A cloud of spheres that pass through the films of others, at speeds at which lists are rebuilt
   often. */
static uint64_t cloud(const char *neighbours, double viscosity, double *kinetic, double *most)
{
    struct dem *const d = world(world_text(
        "materials { ball { density 2500; youngsModulus 1e6; } }"
        "effects { hertz { } dry { restitution 0.8; } lubrication { viscosity %g; "
        "roughness 1e-5; cutOff 4e-4; } }"
        "walls { box { type box; min (0 0 0); max (0.008 0.008 0.008); } }"
        "insert { left { type random; count 45; diameter 1e-3; min (0 0 0); "
        "max (0.004 0.008 0.008); velocity (1 0.5 0.3); seed 1; }"
        " right { type random; count 45; diameter 1e-3; min (0.004 0 0); "
        "max (0.008 0.008 0.008); velocity (-1 0.3 -0.2); seed 2; } }"
        "time { step 4e-6; force yes; } neighbours { %s }",
        viscosity, neighbours), 0, NULL);
    struct dem_view v;
    uint64_t hash;

    world_run(d, 4e-3);
    hash = world_hash(d);
    *kinetic = world_tally(d).kinetic;
    *most = 0.0;
    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const double *const u = dem_at(v.velocity, v.stride, k);

        *most = fmax(*most, sqrt(u[0]*u[0] + u[1]*u[1] + u[2]*u[2]));
    }
    dem_free(d);
    return hash;
}

int main(void)
{
    const double start = 45.0*0.5*world_sphere_mass(0.5e-3, 2500.0)*(1.34 + 1.13);
    double kinetic, most, thick;

    TAP_TRAPS;
    squeezed(1);
    squeezed(0);
    sinking();
    touching();

    const uint64_t usual = cloud("", 0.01, &kinetic, &most);

    TAP_OK(kinetic < 0.5*start, "a cloud with films slows down: %.3g of %.3g J are left", kinetic,
           start);
    TAP_OK(cloud("innerSkin 0.005; outerSkin 0.1;", 0.01, &kinetic, &most) == usual,
           "narrow skins: the same bits");
    TAP_OK(cloud("innerSkin 0.3; outerSkin 0.3;", 0.01, &kinetic, &most) == usual,
           "wide skins: the same bits");
    cloud("", 1e6, &thick, &most);
    TAP_OK(thick < kinetic && most < 1.16,
           "extreme viscosity, step far too long: %.3g J, no particle is faster than at the start",
           thick);
    TAP_DONE;
}
