/*
 * test_moments.c -- resistance to rolling stops a sphere after 7 v^2/(10 mu_r g) and holds it on a
 * slope below mu_r. Symmetry and conservation are in test_symmetry.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/mesh.h"
#include "physics/world.h"

static const double R = 5e-4, density = 1e4, g = 9.80665, E = 1e7;

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
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, R - rest_overlap(g*cos(angle))}, .diameter = 2.0*R, .material = "b",
        .velocity = {speed, 0.0, 0.0}, .spin = {0.0, speed/R, 0.0}};
    struct dem_case *const c = world_begin(world_text(
        "materials { b { density %g; youngsModulus %g; poissonsRatio 0.3; }"
        "rigid { density 1; youngsModulus 1e30; } } effects { hertz { impactSpeed 0.1; }"
        "dry { restitution 0.9; } mindlin { friction 0.8; } %s"
        "gravity { acceleration (%.17g 0 %.17g); } } %s",
        density, E, law, g*sin(angle), -g*cos(angle),
        triangles
        ? ""
        : "walls { floor { type plane; material rigid; point (0 0 0); normal (0 0 1); } }"));

    if (triangles)
    {
        mesh_add_floor(c, "floor", "rigid", -4.0*R, 40.0*R, 3.0*R);
    }
    WORLD_TRY(dem_case_add_particles(c, 1, &seed));
    struct dem *const d = world_start(c);
    world_run(d, time);
    const struct world_particle p = world_at(d, 0);

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
    rest();
    slope();
    TAP_DONE;
}
