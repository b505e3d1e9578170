/*
 * test_belts.c -- a wall with a surface velocity drags a sphere along its face at the given speed,
 * whatever the inclination, the shape and the motion of the wall.
 *
 * Source: kinematics of rigid bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

static const double R = 1e-3, density = 2500.0, g = 9.81, E = 1e7, V = 0.1, mu = 0.2;

/* a face through a point with its normal towards the particle, and the direction of its belt */
struct face
{
    double point[3], normal[3], belt[3];
};

/* overlap at which the Hertzian contact with the rigid wall carries the weight */
static double overlap(void)
{
    return pow(0.75*world_sphere_mass(R, density)*g*(1.0 - 0.09)/(E*sqrt(R)), 2.0/3.0);
}

/* A sphere at rest on the face, with its weight towards the face. `push` [m/s]: velocity of the
   wall itself. Tolerances: the spring is loaded over 1e-6 s of 15 ms; the lever arm is shorter than
   R by the overlap, 4e-3 R. */
static void rolls(const char *wall, const struct face *f, const double push[3], const char *what)
{
    const double slides = V/(3.5*mu*g), weight = world_sphere_mass(R, density)*g;
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass"};
    double along = 0.0, out = 0.0;

    for (int k = 0; k < 3; k++)
    {
        seed.position[k] = f->point[k] + (R - overlap())*f->normal[k];
        seed.velocity[k] = push[k];
    }
    struct dem *const d = world(world_text(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
        " rigid { density 1; youngsModulus 1e30; } } "
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.2; }"
        " gravity { acceleration (%.17g %.17g %.17g); } } "
        "walls { w { material rigid; %s } } time { step 4e-6; }",
        -g*f->normal[0], -g*f->normal[1], -g*f->normal[2], wall), 1, &seed);

    world_run(d, 0.5*slides);
    struct world_particle p = world_at(d, 0);

    for (int k = 0; k < 3; k++)
    {
        const double across = p.f[k] - weight*f->normal[k] - mu*weight*f->belt[k];

        along += (p.v[k] - push[k])*f->belt[k];
        out += across*across;
    }
    TAP_NEAR(sqrt(out)/weight, 0.0, 1e-2, "%s: friction mu m g along the belt", what);
    TAP_NEAR(along, 0.5*V/3.5, 5e-3*V, "%s: half of the time of sliding, half of 2/7 V", what);
    world_run(d, 0.7*slides);
    p = world_at(d, 0);
    along = out = 0.0;
    for (int k = 0; k < 3; k++)
    {
        along += (p.v[k] - push[k])*f->belt[k];
        out += (p.v[k] - push[k])*(p.v[k] - push[k]);
    }
    TAP_NEAR(along, 2.0/7.0*V, 5e-3*V, "%s: then it rolls at 2/7 V", what);
    TAP_NEAR(sqrt(fmax(out - along*along, 0.0)), 0.0, 5e-3*V, "%s: along the belt", what);
    dem_free(d);
}

static const double still[3] = {0.0, 0.0, 0.0};

/* A face through 0 inclined by an angle about y; the belt velocity has the given direction in x. */
static void inclined(double degrees)
{
    const double a = degrees*world_pi/180.0, c = cos(a), s = sin(a);
    const struct face f = {.normal = {-s, 0.0, c}, .belt = {c, 0.0, s}};
    const struct face turned = {.normal = {0.0, -s, c}, .belt = {0.0, c, s}};
    const double push[3] = {0.0, 0.05, 0.0};
    char *const corners = world_text(
        "type triangles; corners ((%.17g -0.1 %.17g) (%.17g -0.1 %.17g) (%.17g 0.1 %.17g)"
        " (%.17g -0.1 %.17g) (%.17g 0.1 %.17g) (%.17g 0.1 %.17g)); surfaceVelocity (%g 0 0);",
        -0.1*c, -0.1*s, 0.1*c, 0.1*s, 0.1*c, 0.1*s, -0.1*c, -0.1*s, 0.1*c, 0.1*s, -0.1*c, -0.1*s,
        V);
    char *const plane = world_text(
        "type plane; point (0 0 0); normal (%.17g 0 %.17g); surfaceVelocity (%g 0 0);", -s, c, V);
    /* by the angle of a quarter before the run begins */
    char *const turn = world_text("%s motion { type rotation; origin (0 0 0); axis (0 0 1);"
                                  " omega %.17g; start -1; end 0; }", corners, 0.5*world_pi);
    char *const moves =
        world_text("%s motion { type translation; velocity (0 0.05 0); }", corners);
    char name[4][64];

    snprintf(name[0], sizeof name[0], "plane at %g degrees", degrees);
    snprintf(name[1], sizeof name[1], "triangles at %g degrees", degrees);
    snprintf(name[2], sizeof name[2], "triangles at %g degrees, turned", degrees);
    snprintf(name[3], sizeof name[3], "triangles at %g degrees that move", degrees);
    rolls(plane, &f, still, name[0]);
    rolls(corners, &f, still, name[1]);
    rolls(turn, &turned, still, name[2]);
    rolls(moves, &f, push, name[3]);
}

/* A face across the belt's velocity: no friction. */
static void across(void)
{
    struct dem_new_particle seed = {
        .diameter = 2.0*R, .material = "glass", .position = {0.0, 0.0, R - overlap()}};
    struct dem *const d = world(
        "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
        " rigid { density 1; youngsModulus 1e30; } } "
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.2; }"
        " gravity { acceleration (0 0 -9.81); } } "
        "walls { w { type triangles; material rigid; corners ((-1 -1 0) (1 -1 0) (0 1 1e-9));"
        " surfaceVelocity (0 0 0.1); } } time { step 4e-6; }",
        1, &seed);

    world_run(d, 0.01);
    TAP_NEAR(hypot(world_at(d, 0).v[0], world_at(d, 0).v[1])/V, 0.0, 1e-6,
             "a face across the velocity, to the error of an STL file, stays at rest");
    dem_free(d);
}

/* A belt around two pulleys, in the plane of x and z about the axis y: a strand, half of a
   twelve-sided pulley at each end. Forward on top is the sense of the axis: axis x normal. */
static void loop(void)
{
    enum { SIDES = 6 };

    const double half = 0.03, radius = 0.02, step = world_pi/SIDES;
    double at[2*SIDES + 2][2];
    char *corners = world_text("%s", "");

    for (int k = 0; k <= 2*SIDES + 1; k++)
    {
        const int first = k <= SIDES;
        const double a = 0.5*world_pi - step*(first ? k : k - 1);

        at[k][0] = (first ? half : -half) + radius*cos(a);
        at[k][1] = radius*sin(a);
    }
    for (int k = 0; k <= 2*SIDES + 1; k++)
    {
        const double *const p = at[k], *const q = at[(k + 1)%(2*SIDES + 2)];
        char *const more = world_text(
            "%s (%.17g -0.02 %.17g) (%.17g -0.02 %.17g) (%.17g 0.02 %.17g)"
            " (%.17g -0.02 %.17g) (%.17g 0.02 %.17g) (%.17g 0.02 %.17g)", corners,
            p[0], p[1], q[0], q[1], q[0], q[1], p[0], p[1], q[0], q[1], p[0], p[1]);

        corners = more;
    }
    char *const wall = world_text("type triangles; corners (%s); surfaceRotation { origin (0 0 0);"
                                  " axis (0 3 0); speed %g; }", corners, V);

    for (int k = 0; k <= 2*SIDES + 1; k += 3)
    {
        const double *const p = at[k], *const q = at[(k + 1)%(2*SIDES + 2)];
        const double size = hypot(q[0] - p[0], q[1] - p[1]),
                     along[2] = {(q[0] - p[0])/size, (q[1] - p[1])/size};
        struct face f = {.point = {0.5*(p[0] + q[0]), 0.0, 0.5*(p[1] + q[1])},
                         .normal = {-along[1], 0.0, along[0]},
                         .belt = {along[0], 0.0, along[1]}};
        char name[64];

        snprintf(name, sizeof name, "facet %d of a belt around two pulleys", k);
        rolls(wall, &f, still, name);
    }
    struct face inside = {.point = {0.0, 0.0, -radius}, .normal = {0.0, 0.0, 1.0},
                          .belt = {-1.0, 0.0, 0.0}};

    rolls(wall, &inside, still, "inside of the lower strand");
}

/* Round walls of 1 m, on which the weight stays across the face. */
static void rounds(void)
{
    static const char *const shape[] = {"sphere; centre (0 0 0)",
                                        "cylinder; point (0 0 0); axis (0 1 0)"};
    const double a = 0.7, A = 1.0;
    const struct face f = {.point = {A*sin(a), 0.0, A*cos(a)}, .normal = {sin(a), 0.0, cos(a)},
                           .belt = {cos(a), 0.0, -sin(a)}};

    for (int k = 0; k < 2; k++)
    {
        char *const wall = world_text(
            "type %s; radius %g; particles outside;"
            " surfaceRotation { origin (0 0 0); axis (0 1 0); speed %g; }", shape[k], A, V);

        rolls(wall, &f, still, k ? "roller" : "sphere");
    }
}

int main(void)
{
    TAP_TRAPS;
    inclined(30.0);
    inclined(80.0);
    across();
    loop();
    rounds();
    TAP_DONE;
}
