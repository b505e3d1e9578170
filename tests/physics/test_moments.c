/*
 * test_moments.c -- resistance to rolling and twisting.
 *
 * - An oblique impact of two unequal spinning spheres conserves momentum and angular momentum, has
 *   the same result in rotated axes, and loses energy.
 * - A sphere rolls 7 v^2/(10 mu_r g) over a plane and over a floor of triangles.
 * - On a slope below mu_r the rolling spring holds it; above it rolls down with 5/7 g (sin - mu_r
 *   cos).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

static const double R = 5e-4, density = 1e4, g = 9.80665, E = 1e7;

static void rotate(const double A[3][3], const double v[3], double out[3])
{
    for (int k = 0; k < 3; k++)
    {
        out[k] = A[k][0]*v[0] + A[k][1]*v[1] + A[k][2]*v[2];
    }
}

/* ---- an impact ------------------------------------------------------------------------------- */

static const double unit[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* momentum, angular momentum about the origin, and the kinetic energy */
static void totals(const struct world_particle p[2], double out[7])
{
    memset(out, 0, 7*sizeof *out);
    for (int i = 0; i < 2; i++)
    {
        const double inertia = 0.4*p[i].mass*p[i].radius*p[i].radius;

        for (int k = 0; k < 3; k++)
        {
            const int l = (k + 1) % 3, m = (k + 2) % 3;

            out[k] += p[i].mass*p[i].v[k];
            out[3 + k] += p[i].mass*(p[i].x[l]*p[i].v[m] - p[i].x[m]*p[i].v[l]) + inertia*p[i].w[k];
            out[6] += 0.5*(p[i].mass*p[i].v[k]*p[i].v[k] + inertia*p[i].w[k]*p[i].w[k]);
        }
    }
}

static void collide(const double A[3][3], const char *law, struct world_particle before[2],
                    struct world_particle after[2])
{
    const double x[2][3] = {{0.0, 0.0, 0.0}, {1.2e-3, 0.4e-3, -0.85e-3}},
                 v[2][3] = {{0.3, 0.1, -0.2}, {-0.4, -0.15, 0.3}};
    const double w[2][3] = {{100.0, -300.0, 200.0}, {-150.0, 50.0, 400.0}};
    struct dem_new_particle seed[2];

    memset(seed, 0, sizeof seed);
    for (int i = 0; i < 2; i++)
    {
        seed[i].diameter = i ? 1.2e-3 : 1.8e-3;
        seed[i].id = i;
        seed[i].material = "b";
        rotate(A, x[i], seed[i].position);
        rotate(A, v[i], seed[i].velocity);
        rotate(A, w[i], seed[i].spin);
    }
    char *const scene = world_text(
        "materials { b { density 2500; youngsModulus 1e7; } } "
        "effects { hertz {} dry { restitution 0.8; }"
        "mindlin { friction 0.3; } %s } time { step 1e-6; }",
        law);
    struct dem *const d = world(scene, 2, seed);

    world_all(d, before);
    world_run(d, 1e-3);
    world_all(d, after);
    TAP_OK(world_tally(d).contacts == 0, "%s: collided and separated", law[0] ? law : "friction alone");
    free(scene);
    dem_free(d);
}

static void impact(const char *law)
{
    const double s = sin(0.7), c = cos(0.7), t = sin(1.9), u = cos(1.9);
    const double turned[3][3] = {{c, -s*u, s*t}, {s, c*u, -c*t}, {0.0, t, u}};
    struct world_particle before[2], after[2], other[2], plain[2];
    double then[7], now[7], there[3];
    double worst = 0.0, change = 0.0;

    collide(unit, "", before, plain);
    collide(unit, law, before, after);
    totals(before, then);
    totals(after, now);
    for (int k = 0; k < 3; k++)
    {
        /* rounding of 1000 steps */
        TAP_NEAR(now[k], then[k], 1e-13*before[0].mass, "%s: momentum %d", law, k);
        TAP_NEAR(now[3 + k], then[3 + k], 1e-12*before[0].mass*1e-3, "%s: angular momentum %d",
                 law, k);
        change = fmax(change, fabs(after[0].w[k] - plain[0].w[k]));
    }
    TAP_OK(now[6] < then[6], "%s: %.3g of the energy is lost", law, 1.0 - now[6]/then[6]);
    TAP_OK(change > 1.0, "%s: the law changes the spin by %g 1/s", law, change);

    collide(turned, law, before, other);
    for (int i = 0; i < 2; i++)
    {
        rotate(turned, after[i].v, there);
        for (int k = 0; k < 3; k++)
        {
            worst = fmax(worst, fabs(there[k] - other[i].v[k])/0.5);
        }
        rotate(turned, after[i].w, there);
        for (int k = 0; k < 3; k++)
        {
            worst = fmax(worst, fabs(there[k] - other[i].w[k])/400.0);
        }
    }
    TAP_NEAR(worst, 0.0, 1e-10, "%s: the same in randomly rotated axes",
             law);        /* rounding, grown by the impact */
}

/* ---- on a plane ------------------------------------------------------------------------------ */

/* overlap at which a Hertzian contact with a rigid floor (nu 0.3) carries this acceleration of the
   sphere */
static double rest_overlap(double pull)
{
    return pow(0.75*world_sphere_mass(R, density)*pull/(E/0.91*sqrt(R)), 2.0/3.0);
}

/* a sphere that rolls with `speed` along x on z = 0 for `time`; gravity is inclined by `angle` */
static struct world_particle roll(const char *law, double speed, double angle, double time,
                                  int triangles)
{
    const struct dem_new_particle seed = {.position = {0.0, 0.0, R - rest_overlap(g*cos(angle))},
                                          .diameter = 2.0*R,
                                          .material = "b",
                                          .velocity = {speed, 0.0, 0.0},
                                          .spin = {0.0, speed/R, 0.0}};
    char *const scene = world_text(
        "materials { b { density %g; youngsModulus %g; poissonsRatio 0.3; }"
        "rigid { density 1; youngsModulus 1e30; } } effects { hertz { impactSpeed 0.1; }"
        "dry { restitution 0.9; } mindlin { friction 0.8; } %s"
        "gravity { acceleration (%.17g 0 %.17g); } } %s",
        density, E, law, g*sin(angle), -g*cos(angle),
        triangles
            ? ""
            : "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }");
    struct dem_case *const c = world_begin(scene);

    if (triangles)
    {
        mesh_add_floor(c, "floor", "rigid", -4.0*R, 40.0*R, 3.0*R);
    }
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *const d = world_start(c);
    world_run(d, time);
    const struct world_particle p = world_at(d, 0);

    free(scene);
    dem_free(d);
    return p;
}

static void rest(void)
{
    static const char *const laws[] = {"rollingConstant { friction 0.05; }",
                                       "rollingSpring { friction 0.05; damping 0.3; }"};
    const double v = 0.1, way = 0.7*v*v/(0.05*g);

    for (int k = 0; k < 2; k++)
    {
        const struct world_particle p = roll(laws[k], v, 0.0, 0.4, k);

        /* the springs elongate over some 1e-3 of the distance before they hold; the lever arm is R
           - d and the moment has R: 1e-3 */
        TAP_NEAR(p.x[0]/way, 1.0, 3e-3, "%s: rolls %.5f m", laws[k], p.x[0]);
        TAP_NEAR(p.v[0]/v, 0.0, 1e-9, "%s: then rests, %g m/s", laws[k], p.v[0]);
        TAP_NEAR(fabs(p.x[1]), 0.0, 1e-12, "%s: on a straight path", laws[k]);
    }
    const double T = 1.4*R/(1e-4*g), time = 0.4;
    const struct world_particle p = roll("rollingViscous { time 1e-4; }", v, 0.0, time, 0);

    TAP_NEAR(p.v[0]/v, exp(-time/T), 2e-3*exp(-time/T),
             "rollingViscous: slows as e^(-t/T), T = %g s", T);    /* as above */
}

static void slope(void)
{
    const double time = 0.05;

    for (int k = 0; k < 2; k++)
    {
        const double tangent = k ? 0.3 : 0.09, angle = atan(tangent),
                     down = 5.0/7.0*g*(sin(angle) - 0.1*cos(angle));
        const struct world_particle p =
            roll("rollingSpring { friction 0.1; damping 0.5; }", 0.0, angle, time, 0);

        if (k)
        {
            /* the springs elongate before they slip: 0.1 ms of 50 ms; lever arm R - d */
            TAP_NEAR(p.v[0]/(down*time), 1.0, 5e-3, "slope 0.3, mu_r 0.1: rolls down, %.4f m/s",
                     p.v[0]);
        }
        else
        {
            TAP_NEAR(p.v[0], 0.0, 1e-6, "slope 0.09, mu_r 0.1: holds, %g m/s", p.v[0]);
            /* its spring elongates by 0.09 d/K = 2.3e-8 m; released at once it overshoots to the
               limit, where 0.01 of its weight is left to stop the motion due to 0.09 of it: some
               five times as far, and as much for the friction spring */
            TAP_NEAR(p.x[0], 0.0, 3e-7, "it has moved by %g m", p.x[0]);
        }
    }
}

int main(void)
{
    TAP_TRAPS;
    impact("rollingConstant { friction 0.2; }");
    impact("rollingSpring { friction 0.2; damping 0; }");
    impact("rollingSpring { friction 0.2; damping 0.5; }");
    impact("rollingViscous { time 1e-3; }");
    impact("twistingSpring { friction 0.3; lever reduced; damping 0.2; }");
    impact("rollingSpring { friction 0.2; stiffness 0.09; damping 0; } twistingSpring { friction 5; }");
    rest();
    slope();
    TAP_DONE;
}
