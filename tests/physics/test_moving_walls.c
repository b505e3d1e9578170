/*
 * test_moving_walls.c -- walls that move, turn, oscillate or are round drive a sphere as
 * kinematics and Hertz's law say; friction continues over seams.
 *
 * Sources: statics and kinematics of rigid bodies; Hertz.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

static const double R = 1e-3, density = 2500.0, g = 9.81, E = 1e7;

static const char materials[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; }"
    " rigid { density 1; youngsModulus 1e30; } }";
static const char floor_plane[] = "type plane; material rigid; point (0 0 0); normal (0 0 1);";
static const char floor_mesh[] =
    "type triangles; material rigid; corners ((-0.1 -0.1 0) (0.1 -0.1 0) (0.1 0.1 0) (-0.1 -0.1 0)"
    " (0.1 0.1 0) (-0.1 0.1 0));";

/* overlap at which the Hertzian contact with a rigid wall carries this force; reduced radius r */
static double overlap_of(double force, double r)
{
    return pow(0.75*force*(1.0 - 0.09)/(E*sqrt(r)), 2.0/3.0);
}

static double rest_height(void)
{
    return R - overlap_of(world_sphere_mass(R, density)*g, R);
}

static struct dem *one(const char *walls, const char *effects, const double x[3], const double v[3])
{
    struct dem_new_particle seed = {.diameter = 2.0*R, .material = "glass"};
    char *const scene = world_text("%s effects { hertz {} %s } walls { %s } time { step 4e-6; }",
                                   materials, effects, walls);

    memcpy(seed.position, x, sizeof seed.position);
    memcpy(seed.velocity, v, sizeof seed.velocity);
    return world(scene, 1, &seed);
}

static const double still[3] = {0.0, 0.0, 0.0};

/* ---- friction -------------------------------------------------------------------------------- */

/* A sphere at rest on a floor that suddenly moves at V: it slides until V/(3.5 mu g), then rolls at
   2/7 V with backward spin. */
static void belt(const char *shape, const char *moves, const char *what)
{
    static const double V = 0.1, mu = 0.2;
    const double x[3] = {0.0, 0.0, rest_height()}, slides = V/(3.5*mu*g);
    char *const walls = world_text("floor { %s %s }", shape, moves);
    struct dem *const d = one(
        walls,
        "dry { restitution 0.5; } mindlin { friction 0.2; } gravity { acceleration (0 0 -9.81); }",
        x, still);

    world_run(d, 0.5*slides);
    struct world_particle p = world_at(d, 0);

    /* the spring is loaded to mu F/k first: 1e-7 m, or 1e-6 s */
    TAP_NEAR(p.v[0], mu*g*0.5*slides, 2e-3*V,
             "%s: at half of the sliding time it has the speed of sliding friction", what);
    TAP_NEAR(p.f[0], mu*world_sphere_mass(R, density)*g, 1e-6*mu*world_sphere_mass(R, density)*g,
             "%s: its friction is mu m g", what);
    world_run(d, 0.6*slides);
    p = world_at(d, 0);
    TAP_NEAR(p.v[0], 2.0/7.0*V, 2e-3*V,
             "%s: a little later than V/(3.5 mu g) it rolls at 2/7 V", what);
    TAP_NEAR(p.v[0] - p.w[1]*R, V, 5e-3*V, "%s: without slip", what);
    world_run(d, 0.05);
    p = world_at(d, 0);
    TAP_NEAR(p.v[0], 2.0/7.0*V, 2e-3*V, "%s: it continues to roll at 2/7 V", what);
    TAP_NEAR(p.x[2], rest_height(), 1e-9, "%s: its height does not change", what);
    dem_free(d);
}

/* ---- impacts --------------------------------------------------------------------------------- */

static void bounce(const char *shape, const char *moves, double V, const char *what)
{
    const double v0 = -0.4, x[3] = {2e-3, 1e-3, 0.003}, v[3] = {0.0, 0.0, v0};
    char *const walls = world_text("floor { %s %s }", shape, moves);
    struct dem *const d = one(walls, "", x, v);
    double force[3], twist[3];

    WORLD_TRY(dem_wall_impulse_reset(d));
    world_run(d, 0.008);
    const struct world_particle p = world_at(d, 0);
    const double m = world_sphere_mass(R, density);

    WORLD_TRY(dem_wall_impulse(d, 0, force, twist));
    TAP_OK(world_tally(d).contacts == 0, "%s: collided and separated", what);
    TAP_NEAR(p.v[2], 2.0*V - v0, 1e-3*fabs(v0), "%s: returns with 2 V - v",
             what);   /* t_c/20 and less: see docs/theory-contact.md, accuracy */
    TAP_NEAR(force[2], -m*(p.v[2] - v0), 1e-12*m,
             "%s: the impulse on the wall is the momentum that the sphere has lost", what);
    TAP_NEAR(twist[0], 1e-3*force[2], 1e-9*m, "%s: the moment of this impulse", what);
    dem_free(d);
}

/* z = a sin(2 pi f t) under a sphere that rests on it, a (2 pi f)^2 > g: it leaves where the
   plate's acceleration is -g. */
static void shaker(void)
{
    static const double a = 5e-3, f = 10.0;
    const double turns = 2.0*world_pi*f, when = asin(g/(a*turns*turns))/turns,
                 speed = a*turns*cos(turns*when);
    const double x[3] = {0.0, 0.0, rest_height()}, v[3] = {0.0, 0.0, a*turns};
    char *const walls =
        world_text("floor { %s motion { type oscillation; amplitude (0 0 %g); frequency %g; } }",
                   floor_plane, a, f);
    struct dem *const d =
        one(walls, "dry { restitution 0.1; } gravity { acceleration (0 0 -9.81); }", x, v);
    double left = 0.0, at = 0.0, contact = 1.0;

    while (contact > 0.0 && world_tally(d).time < 0.02)
    {
        world_step(d);
        contact = (double)world_tally(d).contacts;
        left = world_tally(d).time;
        at = world_at(d, 0).v[2];
    }
    /* the contact unloads with its own period, 2 pi sqrt(m/k) with k = 1.5 m g/overlap: 1 ms, of
       which at most half is a delay */
    TAP_NEAR(left, when, 5e-4,
             "on a shaker: leaves when the plate falls away faster than g, at %.5f s", when);
    TAP_NEAR(at, speed, g*5e-4, "on a shaker: with the plate's speed then, %.4f m/s", speed);
    dem_free(d);
}

/* ---- turning --------------------------------------------------------------------------------- */

/* A sphere on a turntable for a turn. */
static void turntable(const char *shape, const char *what)
{
    static const double omega = 8.0, far = 0.01;
    const double x[3] = {far, 0.0, rest_height()}, v[3] = {0.0, omega*far, 0.0},
                 turn = 2.0*world_pi/omega;
    struct dem_new_particle seed = {
        .position = {x[0], x[1], x[2]}, .velocity = {v[0], v[1], v[2]}, .spin = {0.0, 0.0, omega},
        .diameter = 2.0*R, .material = "glass"};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.5; }"
        " gravity { acceleration (0 0 -9.81); } }"
        "walls { table { %s motion { type rotation; origin (0 0 0); axis (0 0 2); omega %g; } } }"
        "time { step 4e-6; }",
        materials, shape, omega), 1, &seed);

    /* a sphere that rolls without slip on a turntable describes a circle at 2/7 of the table's
       angular speed, about a centre that follows from its first position and velocity (Earnshaw
       1844): c = x + (7/(2 omega)) z x v = -5/2 x for one that starts with the table's velocity */
    world_run(d, turn);
    const struct world_particle p = world_at(d, 0);
    const double arm = rest_height()/R,
                 /* 2/7, with the lever arm of the contact */
                 slower = 0.4/(0.4 + arm*arm);
    const double angle = slower*omega*turn, centre = far*(1.0 - 1.0/slower);
    const double there[2] = {centre + (far - centre)*cos(angle), (far - centre)*sin(angle)};

    TAP_NEAR(p.x[0], there[0], 5e-4*far, "%s: on its circle after a turn, x", what);
    TAP_NEAR(p.x[1], there[1], 5e-4*far, "%s: on its circle after a turn, y", what);
    dem_free(d);
}

/* ---- round walls ----------------------------------------------------------------------------- */

/* An open tube along y of this number of facets, with their centres at `radius`. */
static char *tube(double radius, int facets, double start)
{
    const size_t capacity = 400*(size_t)facets + 100;
    char *const text = world_room(capacity);
    size_t used = (size_t)snprintf(text, capacity, "type triangles; material rigid; corners (");
    const double out = radius/cos(world_pi/facets);

    for (int k = 0; k < facets; k++)
    {
        const double a = start + 2.0*world_pi*k/facets, b = start + 2.0*world_pi*(k + 1)/facets;
        const double p[2] = {out*sin(a), -out*cos(a)}, q[2] = {out*sin(b), -out*cos(b)};

        used += (size_t)snprintf(text + used, capacity - used,
                                 "(%.17g -0.01 %.17g)(%.17g -0.01 %.17g)(%.17g 0.01 %.17g)"
                                 "(%.17g -0.01 %.17g)(%.17g 0.01 %.17g)(%.17g 0.01 %.17g)",
                                 p[0], p[1], q[0], q[1], q[0], q[1], p[0], p[1], q[0], q[1], p[0],
                                 p[1]);
    }
    snprintf(text + used, capacity - used, ");");
    return text;
}

/* A sphere at the bottom of a rotating tube, with the spin of rolling: it stays in place. */
static void drum(const char *shape, const char *what, double tolerance)
{
    static const double D = 0.02, omega = 3.0;
    const double r = D*R/(D - R),
                 x[3] = {0.0, 0.0, -D + R - overlap_of(world_sphere_mass(R, density)*g, sqrt(r*R))};
    const double spin = omega*D/R;
    struct dem_new_particle seed = {
        .position = {x[0], x[1], x[2]}, .spin = {0.0, spin, 0.0}, .diameter = 2.0*R,
        .material = "glass"};
    struct dem *const d = world(world_text(
        "%s effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.5; }"
        " gravity { acceleration (0 0 -9.81); } }"
        "walls { drum { %s motion { type rotation; origin (0 0 0); axis (0 1 0); omega %g; } } }"
        "time { step 4e-6; }",
        materials, shape, omega), 1, &seed);
    double most = 0.0;

    for (int k = 0; k < 30; k++)
    {
        world_run(d, 0.02);
        most = fmax(most, fabs(world_at(d, 0).x[0]));
    }
    const struct world_particle p = world_at(d, 0);

    TAP_NEAR(most, 0.0, tolerance*R,
             "%s: it rolls in place for a quarter of a turn, displaced by at most %.1e m", what, most);
    TAP_NEAR(p.w[1], spin, 1e-2*spin, "%s: with the spin of the wall's speed", what);
    dem_free(d);
}

/* Placed with an overlap of 1e-5 m; direction and magnitude of the force. */
static void curvature(const char *shape, double distance, double reduced, const char *what)
{
    const double d = 1e-5, push = 4.0/3.0*E/(1.0 - 0.09)*sqrt(reduced)*d*sqrt(d),
                 s = sqrt(0.5), x[3] = {s*distance, 0.003, -s*distance};
    char *const walls = world_text("round { %s }", shape);
    struct dem *const w = one(walls, "", x, still);
    const struct world_particle p = world_at(w, 0);
    const double sign = strstr(shape, "outside") ? s : -s;

    TAP_NEAR(p.f[0], sign*push, 1e-9*push, "%s: force by its curvature, x", what);
    TAP_NEAR(p.f[2], -sign*push, 1e-9*push, "%s: force by its curvature, z", what);
    TAP_OK(world_tally(w).contacts == 1, "%s: one contact", what);
    dem_free(w);
}

/* Start and end of motions, and a whole turn, detected by a sphere at rest that the wall just
   touches. */
static void timing(void)
{
    const double x[3] = {5e-3, 0.0, R + 2e-3};
    char *const walls = world_text(
        "riser { %s motion { type translation; velocity (0 0 1); start 0.001; end 0.0025; } }"
        "wheel { type triangles; material rigid; "
        "corners ((1e-2 -1e-2 4e-3)(1.2e-2 -1e-2 4e-3)(1.1e-2 1e-2 4e-3));"
        " motion { type rotation; origin (0 0 4e-3); axis (0 0 1); omega %.17g; start 0.02; } }",
        floor_plane, 2.0*world_pi/0.01);
    struct dem *const d = one(walls, "", x, still);

    world_run(d, 0.0025);
    TAP_NEAR(world_at(d, 0).v[2], 0.0, 0.0,
             "a motion: 1.5 mm when it ends, no contact at 2 mm");
    world_run(d, 0.003);
    TAP_NEAR(world_at(d, 0).v[2], 0.0, 0.0, "a motion: the wall then stays");
    dem_free(d);

    char *const late =
        world_text("riser { %s motion { type translation; velocity (0 0 1); start 0.001; } }",
                   floor_plane);
    struct dem *const e = one(late, "", x, still);

    world_run(e, 0.00299);
    TAP_NEAR(world_at(e, 0).v[2], 0.0, 0.0,
             "a motion without end: at 2.99 ms it has not reached the sphere 2 mm away");
    world_run(e, 0.001);
    TAP_OK(world_at(e, 0).v[2] > 1.0, "a motion without end: soon after it has");
    dem_free(e);
}

/* Reported corners of walls: one rotated by w t about an axis, one at rest, and a plane, which has
   none. */
static void corners(void)
{
    static const double from[9] = {1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 0.0, 3.0};
    const double omega = 4.0, t = 0.3, c = cos(omega*t), s = sin(omega*t),
                 turned[9] = {c, s, 0.0, 2.0*c, 2.0*s, 0.0, c, s, 3.0};
    struct dem *const d = world(
        "materials { g { density 2500; youngsModulus 1e7; } } effects { hertz {} } walls {"
        " rest { type triangles; corners ((1 0 0) (2 0 0) (1 0 3)); }"
        " turn { type triangles; corners ((1 0 0) (2 0 0) (1 0 3)); motion { type rotation; "
        "origin (0 0 0); axis (0 0 1); omega 4; } }"
        " floor { type plane; point (0 0 -9); normal (0 0 1); } }"
        "insert { a { type list; diameter 0.01; positions ((9 9 9)); } }",
        0, NULL);
    struct dem_wall_info facts[3];
    double at[2][9], off[2] = {0.0, 0.0};

    world_run(d, t);
    for (int w = 0; w < 3; w++)
    {
        dem_wall_info(d, w, &facts[w]);
    }
    TAP_OK(facts[0].triangles == 1 && facts[1].triangles == 1 && facts[2].triangles == 0,
           "corners: the walls report their triangles");
    TAP_OK(!facts[0].moves && facts[1].moves && !facts[2].moves,
           "corners: they report which walls move");
    for (int w = 0; w < 2; w++)
    {
        TAP_OK(dem_wall_corners(d, w, at[w]) == DEM_OK, "corners: of wall %d", w);
        for (int k = 0; k < 9; k++)
        {
            off[w] = fmax(off[w], fabs(at[w][k] - (w ? turned[k] : from[k])));
        }
    }
    TAP_NEAR(off[0], 0.0, 0.0, "corners: at rest as they were given");
    /* rounding */
    TAP_NEAR(off[1], 0.0, 1e-14, "corners: rotated by w t");
    dem_free(d);
}

/* A sphere that rolls to and fro in a round tube at rest: a pendulum of 7/5 of the length; friction
   is 2/7 of the weight's component along the wall. */
static void pendulum(void)
{
    static const double D = 0.02, start = 0.25;
    const double m = world_sphere_mass(R, density), far = D - R + overlap_of(m*g, R),
                 x[3] = {far*sin(start), 0.0, -far*cos(start)};
    struct dem *const d = one(
        "drum { type cylinder; material rigid; point (0 0 0); axis (0 1 0); radius 0.02; "
        "particles inside; }",
        "dry { restitution 0.3; } mindlin { friction 0.5; } gravity { acceleration (0 0 -9.81); }",
        x, still);
    double off = 0.0, all = 0.0, last = 0.0, quarter = 0.0;

    for (int k = 0; k < 15000; k++)
    {
        world_run(d, 1.2e-5);
        const struct world_particle p = world_at(d, 0);
        const double angle = atan2(p.x[0], -p.x[2]),
                     friction = p.f[0]*cos(angle) + p.f[2]*sin(angle),
                     due = 2.0/7.0*m*g*sin(angle);

        off +=
            /* when the transient has decayed */
            k > 1000 ? (friction - due)*(friction - due) : 0.0;
        all += k > 1000 ? due*due : 0.0;
        quarter = last > 0.0 && p.x[0] <= 0.0 && quarter <= 0.0 ? world_tally(d).time : quarter;
        last = p.x[0];
    }
    /* amplitude 0.25: period longer by 1 + 0.25^2/16; the overlap adds 1e-4 to the length and to
       the lever arm */
    const double period = 2.0*world_pi*sqrt(1.4*(D - R)/g)*(1.0 + start*start/16.0);

    TAP_NEAR(4.0*quarter, period, 1e-3*period,
             "in a round tube: the period belongs to 7/5 of the length");
    TAP_NEAR(sqrt(off/all), 0.0, 2e-3,
             "in a round tube: friction is 2/7 of the weight's component along the wall");
    dem_free(d);
}

/* ---- seams ----------------------------------------------------------------------------------- */

/* Down a slope cut into strips of 0.7 mm, alternately of two walls, each tilted by `bend` against
   the one before. Friction is 2/7 of the weight's component along the strip throughout; it would
   drop to zero at each seam if its spring were lost. At a bend the normal velocity changes by v
   bend, which gives oscillations of v bend sqrt(k m) in the forces: up to 7 %. */
static void strips(double bend, double pull, const char *what, double tolerance)
{
    static const double wide = 7e-4, press = 7.0;
    const double m = world_sphere_mass(R, density), x[3] = {-1e-3, 0.0, R - overlap_of(m*press, R)},
                 arm = x[2]/R;
    const double part = 0.4/(0.4 + arm*arm)*m, speed = sqrt(10.0/7.0*pull*10.0*wide);
    char *text[2];
    size_t used[2] = {0, 0};
    const size_t capacity = 40000;
    double worst = 0.0, at[2] = {-4e-3, 0.0}, to[2], begins[60];

    for (int w = 0; w < 2; w++)
    {
        text[w] = world_room(capacity);
        used[w] = (size_t)snprintf(text[w], capacity, "type triangles; material rigid; corners (");
    }
    for (int k = 0; k < 60; k++)
    {
        const int w = k & 1;
        const double slope = k > 5 ? (k - 5)*bend : 0.0;

        begins[k] = at[0];
        to[0] = at[0] + wide*cos(slope), to[1] = at[1] + wide*sin(slope);
        used[w] += (size_t)snprintf(text[w] + used[w], capacity - used[w],
                                    "(%.17g -0.01 %.17g)(%.17g -0.01 %.17g)(%.17g 0.01 %.17g)"
                                    "(%.17g -0.01 %.17g)(%.17g 0.01 %.17g)(%.17g 0.01 %.17g)",
                                    at[0], at[1], to[0], to[1], to[0], to[1], at[0], at[1], to[0],
                                    to[1], at[0], at[1]);
        memcpy(at, to, sizeof at);
    }
    char *const walls = world_text("even { %s ); } odd { %s ); }", text[0], text[1]);
    char *const effects = world_text(
        "dry { restitution 0.3; } mindlin { friction 0.5; } gravity { acceleration (%g 0 %g); }",
        pull, -press);
    struct dem *const d = one(walls, effects, x, still);

    for (int k = 0; k < 60000 && world_at(d, 0).x[0] < 10.0*wide - 1e-3; k++)
    {
        world_step(d);
        const struct world_particle p = world_at(d, 0);

        int strip = 0;

        while (strip < 59 && begins[strip + 1] < p.x[0])
        {
            strip++;
        }
        const double slope = strip > 5 ? (strip - 5)*bend : 0.0,
                     due = part*(pull*cos(slope) - press*sin(slope));
        const double friction = -p.f[0]*cos(slope) - p.f[2]*sin(slope);

        worst = k > 1500 ? fmax(worst, fabs(friction - due)/due)
                         : worst;   /* 6 ms: the start has died away */
    }
    TAP_NEAR(world_at(d, 0).v[0], speed, 0.1*speed, "%s: speed after ten seams", what);
    TAP_NEAR(worst, 0.0, tolerance, "%s: friction does not change at any seam", what);
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    belt(floor_plane, "motion { type translation; velocity (0.1 0 0); }", "moving plane");
    belt(floor_mesh, "motion { type translation; velocity (0.1 0 0); }", "moving triangles");
    bounce(floor_plane, "motion { type translation; velocity (0 0 0.2); }", 0.2,
           "elastic, towards a plane");
    bounce(floor_mesh, "motion { type translation; velocity (0 0 0.2); }", 0.2,
           "elastic, towards triangles");
    bounce(floor_plane, "motion { type translation; velocity (0 0 -0.1); }", -0.1,
           "elastic, from a receding plane");
    shaker();
    corners();
    turntable(floor_plane, "turntable, plane");
    turntable(floor_mesh, "turntable, triangles");
    drum(
        "type cylinder; material rigid; point (0 0 0); axis (0 1 0); radius 0.02; "
        "particles inside;",
        "round tube", 1e-2);
    char *const facets = tube(0.02, 120, 0.01);

    drum(facets, "tube of 120 facets", 1.0);
    pendulum();
    curvature(
        "type cylinder; material rigid; point (0 5 0); axis (0 -3 0); radius 0.004; "
        "particles inside;",
        0.004 - R + 1e-5, R/sqrt(0.75), "inside a cylinder");
    curvature(
        "type cylinder; material rigid; point (0 5 0); axis (0 -3 0); radius 0.004; "
        "particles outside;",
        0.004 + R - 1e-5, R/sqrt(1.25), "outside of a cylinder");
    curvature("type sphere; material rigid; centre (0 0.003 0); radius 0.004; particles inside;",
              0.004 - R + 1e-5, R/0.75, "inside a sphere");
    curvature("type sphere; material rigid; centre (0 0.003 0); radius 0.004; particles outside;",
              0.004 + R - 1e-5, R/1.25, "outside of a sphere");
    timing();
    strips(0.0, 7.0, "strips in a plane", 1e-6);
    strips(-1e-4, 7.0, "strips round a hill", 0.1);
    strips(1e-4, 7.0, "strips in a hollow", 0.1);
    strips(1e-3, 0.5, "strips in a hollow, slow", 0.1);
    TAP_DONE;
}
