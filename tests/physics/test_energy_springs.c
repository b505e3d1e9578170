/*
 * test_energy_springs.c -- the energy balance closes for oblique impacts with dashpots on
 * rotations, with added mass, and for bonds that break in the step in which they are made.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/energy.h"

static const double R = 1e-3, E = 1e7, nu = 0.3;

struct scene
{
    const char *effects, *more;                           /* laws; walls, fluid */
    double density;                                       /* kg/m3 */
};

static struct dem *start(const struct scene *s, double step, int n,
                         const struct dem_new_particle *seed)
{
    return energy_world(world_text(
        "materials { glass { density %g; youngsModulus 1e7; poissonsRatio 0.3; } } "
        "effects { %s } %s "
        "time { step %.17g; force yes; }",
        s->density, s->effects, s->more, step), n, seed);
}

static double kinetic(struct dem *d)
{
    return energy_term(d, "kinetic_translation") + energy_term(d, "kinetic_rotation");
}

/* ---- oblique impacts ------------------------------------------------------------------------- */

static double impact(double reduced_mass, double reduced_radius)
{
    return world_contact_time(reduced_mass, reduced_radius, 0.5*E/(1.0 - nu*nu), 1.0);
}

/* For impacts at 1 m/s at 5 to 65 degrees, spinning: mean residual over the energy at the start, and
   its largest. */
static void impacts(const struct scene *s, double step, double other, double result[2])
{
    int n = 0;

    result[0] = result[1] = 0.0;
    for (int angle = 5; angle <= 65; angle += 5)
    {
        const double a = angle*world_pi/180.0, phase = (n*0.618034 - floor(n*0.618034))*step;
        const struct dem_new_particle seed[2] = {
            {.position = {0.0, 0.0, R + phase}, .velocity = {sin(a), 0.0, -cos(a)},
             .spin = {200.0, -100.0, 300.0}, .diameter = 2.0*R, .id = -1, .material = "glass"},
            {.position = {0.0, 0.0, -other}, .diameter = 2.0*other, .id = -1, .material = "glass"}};
        struct dem *const d = start(s, step, other > 0.0 ? 2 : 1, seed);
        const double before = kinetic(d);

        world_run(d, 2.0*impact(world_sphere_mass(R, s->density), R) +
                         (s->density < 10.0 ? 6e-4 : 0.0));
        TAP_OK(world_at(d, 0).f[2] == 0.0, "it is over");
        const double residual = fabs(energy_term(d, "residual"))/before;

        result[0] += residual/13.0;
        result[1] = fmax(result[1], residual);
        n++;
        dem_free(d);
    }
}

static void oblique(const char *what, const struct scene *s, double other)
{
    const double m = world_sphere_mass(R, s->density), M = world_sphere_mass(other, s->density);
    const double tc = other > 0.0 ? impact(m*M/(m + M), R*other/(R + other)) : impact(m, R);
    double coarse[2], fine[2];

    impacts(s, tc/20.0, other, coarse);
    impacts(s, tc/80.0, other, fine);
    TAP_OK(coarse[1] < 1e-2,
           "%s: the balance reports the kinetic energy lost, to %.2g at worst at the "
           "automatic step", what,
           coarse[1]);
    /* dashpots are of first order: 4 expected, more with contributions of second order */
    TAP_OK(fine[0] < coarse[0]/3.0,
           "to %.2g on average over impacts, %.2g at a quarter of the step", coarse[0], fine[0]);
}

int main(void)
{
    static const char floor_at_0[] =
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }";
    static const char in_water[] =
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } } fluid { density 1000; "
        "viscosity 1e-6; }";
    const struct scene brittle = {
        "hertz {} dry { restitution 0.8; } mindlin { friction 0.3; } bondLinear { make always; "
        "normalStiffness 1e9; "
        "shearStiffness 1e9; shearStrength 1e-3; }",
        "", 2500.0};
    const struct scene bubble =
        {"hertz {} dry { restitution 0.8; } mindlin { friction 0.3; } virtualMass {}", in_water,
         1.2};
    const struct scene moments = {
        "hertz {} dry { restitution 0.8; } mindlin { friction 0.3; } "
        "rollingSpring { friction 0.2; damping 0.3; } "
        "twistingSpring { friction 0.3; damping 0.3; }",
        floor_at_0, 2500.0};

    TAP_TRAPS;
    oblique("a bubble in water", &bubble, 0.0);
    oblique("rolling and twisting", &moments, 0.0);

    /* At a quarter of the automatic step, where 0.0014 was found; at that step itself up to 0.016
       remain. The cause is not proved: the contact that replaces the bond begins with an overlap
       that it has not loaded. A bond taken as stretched by its whole length would give 1.4. */
    double broken[2];
    const double m = world_sphere_mass(R, brittle.density);

    impacts(&brittle, impact(0.5*m, 0.5*R)/80.0, R, broken);
    TAP_OK(
        broken[1] < 1e-2,
        "bonds that break in the step that makes them: the balance reports the kinetic energy "
        "lost, to %.2g at worst",
        broken[1]);
    TAP_DONE;
}
