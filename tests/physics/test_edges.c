/*
 * test_edges.c -- at edges of flat walls forces are continuous in position, and elastic bounces
 * keep the kinetic energy to second order in the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"

enum
{
    THROWN = 24, PLACES = 1001
};

static const double R = 1e-3, density = 2500.0, E = 1e7;

static const char *const hertz = "hertz { impactSpeed 1; }", *const hooke = "hooke { impactSpeed 1; }";

/* two facets that meet on the y axis: one level where x < 0, the other rises at `angle` (degrees),
   or falls where that is negative */
static void add_facets(struct dem_case *made, double angle, double length)
{
    const double a = angle*world_pi/180.0, l = 20.0*R;
    const double c[6][3] = {{-l, -2.0*R, 0.0}, {0.0, -2.0*R, 0.0}, {0.0, length, 0.0},
                            {-l, length, 0.0}, {l*cos(a), -2.0*R, l*sin(a)},
                            {l*cos(a), length, l*sin(a)}};
    struct mesh m = {0};

    mesh_quad(&m, c[0], c[1], c[2], c[3]);
    mesh_quad(&m, c[1], c[4], c[5], c[2]);
    mesh_hand_over(made, "fold", "glass", &m);
}

static struct dem *fold(const char *law, double angle, int planes, double step, int64_t n,
                        const struct dem_new_particle *seed)
{
    const double a = angle*world_pi/180.0;
    char *const wall = world_text("walls { level { type plane; point (0 0 0); normal (0 0 1); } "
                                  "slope { type plane; point (0 0 0); normal (%.17g 0 %.17g); } }",
                                  -sin(a), cos(a));
    struct dem_case *const c = world_begin(world_text(
        "materials { glass { density %g; youngsModulus %g; } } "
        "effects { %s } %s %s",
        density, E, law,
        step > 0.0 ? world_text("time { step %.17g; }", step) : "",
        planes ? wall : ""));

    if (!planes)
    {
        add_facets(c, angle, 4.0*R*(double)n);
    }
    WORLD_TRY(dem_case_add_particles(c, n, seed));
    return world_start(c);
}

/* a row of spheres just off the fold, k/THROWN of the way from left to right of the edge, in three
   directions */
static void throw_at(double angle, struct dem_new_particle seed[THROWN])
{
    const double middle = 0.5*angle*world_pi/180.0;

    for (int k = 0; k < THROWN; k++)
    {
        const double along = 0.6*R*((double)(k/3)/(THROWN/3 - 1) - 0.5),
                     up = 1.02*R/cos(middle) + 0.02*R + fabs(along)*tan(fabs(middle)),
                     lean = middle + 0.35*(k%3 - 1);

        seed[k] = (struct dem_new_particle){
            .position = {along*cos(middle) - up*sin(middle), 4.0*R*k,
                         along*sin(middle) + up*cos(middle)},
            .velocity = {0.2*sin(lean), 0.0, -0.2*cos(lean)},
            .diameter = 2.0*R,
            .id = k,
            .material = "glass"};
    }
}

/* largest relative change of the kinetic energy of a sphere after its bounces; `untouched` counts
   those that did not bounce */
static double largest_gain(const char *law, double angle, int planes, double step, double *used,
                           int *untouched)
{
    struct dem_new_particle seed[THROWN];
    double worst = 0.0;

    throw_at(angle, seed);
    struct dem *const d = fold(law, angle, planes, step, THROWN, seed);

    *used = dem_step_limit(d).used;
    *untouched = 0;
    world_run(d, 0.012);
    for (int k = 0; k < THROWN; k++)
    {
        const struct world_particle p = world_at(d, k);
        double square = 0.0, before = 0.0, same = 1.0;

        for (int c = 0; c < 3; c++)
        {
            square += p.v[c]*p.v[c];
            before += seed[k].velocity[c]*seed[k].velocity[c];
            same *= p.v[c] == seed[k].velocity[c];
        }
        *untouched += same > 0.0;
        worst = fmax(worst, fabs(square/before - 1.0));
    }
    dem_free(d);
    return worst;
}

static void scan(const char *law, const char *name, int planes)
{
    static const double angles[] = {-90.0, -30.0, -10.0, -1.0, 0.0, 0.01, 0.1, 1.0, 2.0, 3.0, 5.0,
                                    7.0, 10.0, 14.0, 19.0, 21.0, 30.0, 45.0, 60.0, 90.0};

    for (size_t k = 0; k < sizeof angles/sizeof *angles; k++)
    {
        double step;
        int untouched;

        if (planes && angles[k] < 0.0)
        {
            continue;       /* the spheres start behind one of them */
        }
        const double coarse = largest_gain(law, angles[k], planes, 0.0, &step, &untouched);
        const double fine = largest_gain(law, angles[k], planes, step/4.0, &step, &untouched);

        TAP_OK(coarse < 3e-3 && untouched == 0,
               "%s, two %s at %g degrees: elastic bounces keep the energy (%.1e)", name,
               planes ? "planes" : "facets", angles[k], coarse);
        /* the force of Hooke's law has a kink where it begins: an error by chance of 6e-5, also on a
           plane */
        TAP_OK(fine < coarse/8.0 || fine < (law == hooke ? 3e-4 : 2e-6),
               "... to second order in the step (%.1e with a quarter)", fine);
    }
}

/* forces on spheres at PLACES places up to `width` on both sides of where they are as far from one
   facet as from the other, 1 % of the radius deep in the nearer one: the largest difference of
   neighbors, over the largest force */
static double largest_jump(double angle, double width)
{
    const double a = angle*world_pi/180.0, h = 0.99*R;
    static struct dem_new_particle seed[PLACES];
    double worst = 0.0, largest = 0.0, before[3] = {0.0, 0.0, 0.0};

    for (int k = 0; k < PLACES; k++)
    {
        const double x = width*(2.0*k/(PLACES - 1) - 1.0) - h*tan(0.5*a);

        seed[k] = (struct dem_new_particle){
            .position = {x, 4.0*R*k, fmax(h, h/cos(a) + x*tan(a))}, .diameter = 2.0*R, .id = k,
            .material = "glass"};
    }
    struct dem *const d = fold(hertz, angle, 0, 1e-9, PLACES, seed);

    world_step(d);
    for (int k = 0; k < PLACES; k++)
    {
        const struct world_particle p = world_at(d, k);
        double square = 0.0, jump = 0.0;

        for (int c = 0; c < 3; c++)
        {
            jump += (p.f[c] - before[c])*(p.f[c] - before[c]);
            square += p.f[c]*p.f[c];
            before[c] = p.f[c];
        }
        worst = k > 0 ? fmax(worst, sqrt(jump)) : 0.0;
        largest = fmax(largest, sqrt(square));
    }
    dem_free(d);
    return worst/largest;
}

/* spheres that rest on a floor of two walls with a slit between them, at PLACES places across it:
   the largest deviation of the force from the weight, over it */
static double over_slit(double width, double friction)
{
    static struct dem_new_particle seed[PLACES];
    const double g = 9.81, modulus = E/(1.0 - 0.0625), l = 10.0*R,
                 weight = world_sphere_mass(R, density)*g,
                 rest = pow(0.75*weight/(modulus*sqrt(R)), 2.0/3.0);
    struct dem_case *const made = world_begin(world_text(
        "materials { ball { density %g; youngsModulus %g; poissonsRatio 0.25; } "
        "rigid { density 1; youngsModulus 1e30; } } "
        "effects { %s gravity { acceleration (0 0 -9.81); } mindlin { friction %g; } } "
        "time { step 1e-9; }", density, E, hertz, friction));
    double worst = 0.0;

    for (int k = 0; k < PLACES; k++)
    {
        seed[k] = (struct dem_new_particle){
            .position = {3.0*width*(2.0*k/(PLACES - 1) - 1.0), 4.0*R*k, R - rest},
            .diameter = 2.0*R, .id = k, .material = "ball"};
    }
    for (int side = -1; side <= 1; side += 2)
    {
        const double c[4][3] = {{0.5*side*width, -l, 0.0}, {side*l, -l, 0.0},
                                {side*l, 4.0*R*PLACES + l, 0.0},
                                {0.5*side*width, 4.0*R*PLACES + l, 0.0}};
        struct mesh m = {0};

        mesh_quad(&m, c[0], c[1], c[2], c[3]);
        mesh_hand_over(made, side < 0 ? "left" : "right", "rigid", &m);
    }
    WORLD_TRY(dem_case_add_particles(made, PLACES, seed));
    struct dem *const d = world_start(made);
    world_step(d);
    for (int k = 0; k < PLACES; k++)
    {
        const struct world_particle p = world_at(d, k);

        worst = fmax(worst, fmax(fabs(p.f[2]/weight - 1.0), fabs(p.f[0]/weight)));
    }
    dem_free(d);
    return worst;
}

/* largest relative change of the kinetic energy of a sphere, free of forces between its bounces, in
   a tube of 36 facets, until it has flown 100 radii of the tube */
static double in_tube(double step, double *used)
{
    enum
    {
        SIDES = 36
    };
    const double inside = 6.0*R, speed = 0.3, z[2] = {-2.0*R, 2.0*R};
    const struct dem_new_particle seed = {
        .position = {2.3*R, 0.7*R, 0.0}, .velocity = {0.28*speed, 0.96*speed, 0.0},
        .diameter = 2.0*R, .material = "glass"};
    struct dem_case *const made = world_begin(world_text(
        "materials { glass { density %g; youngsModulus %g; } } effects { %s } %s", density, E, hertz,
        step > 0.0 ? world_text("time { step %.17g; }", step) : ""));
    struct mesh m = {0};
    double worst = 0.0;

    for (int k = 0; k < SIDES; k++)
    {
        double c[4][3];

        for (int n = 0; n < 4; n++)
        {
            const double a = 2.0*world_pi*(k + (n == 1 || n == 2))/SIDES;

            c[n][0] = inside*cos(a);
            c[n][1] = inside*sin(a);
            c[n][2] = z[n/2];
        }
        mesh_quad(&m, c[0], c[1], c[2], c[3]);
    }
    mesh_hand_over(made, "tube", "glass", &m);
    WORLD_TRY(dem_case_add_particles(made, 1, &seed));
    struct dem *const d = world_start(made);
    *used = dem_step_limit(d).used;
    for (int k = 0; k < 4000; k++)
    {
        world_run(d, 100.0*inside/speed/4000);

        const struct world_particle p = world_at(d, 0);
        const double square = p.v[0]*p.v[0] + p.v[1]*p.v[1] + p.v[2]*p.v[2];

        if (p.f[0] == 0.0 && p.f[1] == 0.0)
        {
            worst = fmax(worst, fabs(square/(speed*speed) - 1.0));
        }
    }
    dem_free(d);
    return worst;
}

int main(void)
{
    static const double angles[] = {0.1, 1.0, 5.0, 10.0, 19.0};

    TAP_TRAPS;
    scan(hertz, "hertz", 0);
    scan(hooke, "hooke", 0);
    scan(hertz, "hertz", 1);
    for (size_t k = 0; k < sizeof angles/sizeof *angles; k++)
    {
        const double far = largest_jump(angles[k], 0.2*R), near = largest_jump(angles[k], 0.01*R);

        TAP_OK(near < far/8.0, "the force has no jump across an edge of %g degrees: %.1e between "
               "places 0.4 um apart, %.1e of 0.02 um", angles[k], far, near);
    }

    static const double widths[] = {1e-12, 1e-10, 1e-9, 1e-8, 1e-7};

    for (size_t k = 0; k < sizeof widths/sizeof *widths; k++)
    {
        const double kick = over_slit(widths[k], 0.5);

        TAP_OK(kick < 0.01, "spheres rest on a slit of %g m between two walls: the force changes by "
               "%.1e of the weight", widths[k], kick);
    }

    double step;
    const double coarse = in_tube(0.0, &step), fine = in_tube(step/4.0, &step);

    TAP_OK(coarse < 0.02, "a sphere in a tube of 36 facets keeps its energy (%.1e)", coarse);
    TAP_OK(fine < coarse/8.0, "... to second order in the step (%.1e with a quarter)", fine);
    TAP_DONE;
}
