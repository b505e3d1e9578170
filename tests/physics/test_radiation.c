/*
 * test_radiation.c -- radiation between near spheres and walls has the view factors of rays and
 * the exchange of grey bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "world.h"

#include <float.h>
#include <math.h>

static const double c = 464.0, rho = 7800.0, sigma = 5.670374419e-8, a_T = 1000.0, b_T = 600.0;

static double temperature(struct dem *d, int64_t id)
{
    return world_scalar(d, "temperature", id);
}

/* Two spheres, or a sphere and a wall (L = 0), at the distance l: gain of a [W]. */
static double gain(double R, double L, double l, double e, const char *settings)
{
    const double dt = 1e-2, C = world_sphere_mass(R, rho)*c;
    char *const wall = L > 0.0 ? world_text(" ")
                               : world_text("walls { wall { type plane; point (%.17g 0 0); "
                                            "normal (-1 0 0); temperature { value %g; } } }", l, b_T);
    char *const other = L > 0.0 ? world_text("b { type list; frozen yes; diameter %.17g; positions "
                                             "((%.17g 0 0)); temperature %g; }", 2.0*L, l, b_T)
                                : world_text(" ");
    struct dem *const d = world(world_text(
        "materials { steel { density 7800; youngsModulus 1e7; heatCapacity 464; emissivity %g; } }"
        "effects { hertz { } radiation { %s } } time { step %g; force yes; } %s "
        "insert { a { type list; frozen yes; diameter %.17g; positions ((0 0 0)); temperature %g; } %s }",
        e, settings, dt, wall, 2.0*R, a_T, other),
        0, NULL);

    world_step(d);
    const double gained = C*(temperature(d, 0) - a_T)/dt;

    if (L > 0.0)
    {
        const double of_b = world_sphere_mass(L, rho)*c*(temperature(d, 1) - b_T)/dt;

        TAP_NEAR(gained + of_b, 0.0, 4.0*C*a_T*DBL_EPSILON/dt, "one receives the heat that the other loses");
    }
    dem_free(d);
    return gained;
}

/* Halton's sequence */
static double halton(int n, int base)
{
    double value = 0.0, part = 1.0;

    for (; n > 0; n /= base)
    {
        part /= base;
        value += part*(n%base);
    }
    return value;
}

/* The fraction of diffuse rays from a sphere of radius R that hit one of radius L at the distance l
   along x, or (L = 0) the plane there nearer than `far` to the centre. */
static double hits(double R, double L, double l, double far)
{
    enum { N = 1000000 };
    int hit = 0;

    for (int n = 1; n <= N; n++)
    {
        const double u = 1.0 - 2.0*halton(n, 2), w = 2.0*world_pi*halton(n, 3),
                     q = sqrt(1.0 - u*u), sine = sqrt(halton(n, 5)), cosine = sqrt(1.0 - sine*sine),
                     turn = 2.0*world_pi*halton(n, 7);
        const double normal[3] = {u, q*cos(w), q*sin(w)}, up[3] = {-q, u*cos(w), u*sin(w)},
                     side[3] = {0.0, -sin(w), cos(w)};
        double x[3], v[3], along = 0.0, square = 0.0;

        for (int k = 0; k < 3; k++)
        {
            x[k] = R*normal[k] - (k == 0 ? l : 0.0);
            v[k] = cosine*normal[k] + sine*(cos(turn)*up[k] + sin(turn)*side[k]);
            along += x[k]*v[k];
            square += x[k]*x[k];
        }
        if (L > 0.0)
        {
            hit += along < 0.0 && square - along*along < L*L;
        }
        else if (v[0] > 0.0)
        {
            const double t = -x[0]/v[0], y = x[1] + t*v[1], z = x[2] + t*v[2];

            hit += y*y + z*z + l*l < far*far;
        }
    }
    return (double)hit/N;
}

static double black(double R, double factor)
{
    return sigma*4.0*world_pi*R*R*factor*(pow(b_T, 4.0) - pow(a_T, 4.0));
}

static void views(void)
{
    const double R = 3e-3;

    TAP_NEAR(gain(R, R, 2.0*R, 1.0, "")/black(R, hits(R, R, 2.0*R, 0.0)), 1.0, 0.06,
             "touching: view factor 0.0756");
    TAP_NEAR(gain(R, R, 2.9*R, 1.0, "")/black(R, hits(R, R, 2.9*R, 0.0)), 1.0, 0.015,
             "1.45 diameters apart");
    TAP_NEAR(gain(R, 4.0*R, 6.0*R, 1.0, "")/black(R, hits(R, 4.0*R, 6.0*R, 0.0)), 1.0, 0.03,
             "a larger one");
    TAP_NEAR(gain(R, 0.0, 1.2*R, 1.0, "")/black(R, hits(R, 0.0, 1.2*R, 3.0*R)), 1.0, 0.005,
             /* scatter of the rays, and the size of the sphere: exact for rays from its centre */
             "a wall");
    TAP_NEAR(gain(R, 0.0, 1.2*R, 1.0, "")/black(R, 0.5*(1.0 - 1.2/3.0)), 1.0, 1e-8,
             "a wall: (1 - h/L)/2");
}

static void grey(void)
{
    const double R = 3e-3, e = 0.4, s = (1.0 - e)/e, A = 4.0*world_pi*R*R;
    const double l = 2.2*R, root = 1.0 + sqrt(1.0 - 1.0/(2.2*2.2)), F = R*R/(l*l*root*root);

    TAP_NEAR(gain(R, R, l, e, "")/(black(R, 1.0)/(2.0*s + 1.0/F)), 1.0, 1e-8, "grey spheres");
    TAP_NEAR(gain(R, 0.0, 1.2*R, e, "")/(sigma*(pow(b_T, 4.0) - pow(a_T, 4.0))/
                                           (s/A + 1.0/(0.3*A))), 1.0, 1e-8, "a grey one at a wall");
}

static void beyond(void)
{
    const double R = 3e-3;

    TAP_OK(gain(R, R, 3.001*R, 1.0, "") == 0.0 && gain(R, 0.0, 3.001*R, 1.0, "") == 0.0,
           "none beyond 1.5 diameters");
    TAP_OK(gain(R, R, 3.001*R, 1.0, "reach 2;") < 0.0, "unless the reach is longer");
}

int main(void)
{
    TAP_TRAPS;
    views();
    grey();
    beyond();
    TAP_DONE;
}
