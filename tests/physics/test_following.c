/*
 * test_following.c -- which particles follow the fluid: free ones of less than 10 times its density, clumps and
 * parcels by their solid. The response of a sphere that moves with its fluid does not depend on rounding.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"
#include <float.h>
#include <math.h>

static void which(const char *what, const char *more, const char *form, double density, const char *state,
                  double rho, double expected)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { solid { density %g; youngsModulus 1e6; } } %s effects { hertz {} stokesDrag {} }"
        "insert { one { type list; %s; positions ((0 0 0)); %s } } time { step 1e-6; }",
        density, more, form, state));
    struct dem *const w = world_start(c);
    struct dem_fluid f;
    double coefficient[2] = {3.0, 3.0};

    WORLD_TRY(dem_fluid(w, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.void_fraction[i] = 1.0, f.density[i] = rho, f.viscosity[i] = 1e-3;
    }
    world_run(w, 1e-5);
    dem_fluid_following(w, coefficient);
    TAP_OK(coefficient[0] == expected && (f.n == 1 || coefficient[1] == expected), "%s: %g", what, coefficient[0]);
    dem_free(w);
}

/* R over the integral of b of a light sphere at this velocity [m/s], in a fluid faster by this part of it;
   g: gravity across [m/s2]. */
static double response(double velocity, double slip, double g)
{
    struct dem_case *const c = world_begin(world_text(
        "materials { solid { density 1000; youngsModulus 1e6; } } effects { hertz {} stokesDrag {} "
        "gravity { acceleration (0 %g 0); } } "
        "insert { one { type list; diameter 1e-4; positions ((0 0 0)); velocity (%g 0 0); } } time { step 5e-7; }",
        g, velocity));
    struct dem *const w = world_start(c);
    struct dem_fluid f;

    WORLD_TRY(dem_fluid(w, &f));
    f.velocity[0] = velocity*(1.0 + slip), f.void_fraction[0] = 1.0, f.density[0] = 1000.0, f.viscosity[0] = 1e-3;
    world_run(w, 1e-3);
    WORLD_TRY(dem_fluid(w, &f));
    const double ratio = f.response[0]/f.drag_integral[0];
    dem_free(w);
    return ratio;
}

int main(void)
{
    TAP_TRAPS;

    static const char sphere[] = "diameter 1e-3", clump[] = "shape pair",
                      pair[] = "shapes { pair { spheres ((0 0 0 5e-4) (5e-4 0 0 5e-4)); } }",
                      parcels[] = "parcels { ratio 3; }";

    which("9.99 times the fluid's density", "", sphere, 9990.0, "", 1000.0, 3.0);
    which("10.01 times", "", sphere, 10010.0, "", 1000.0, 0.0);
    which("frozen", "", sphere, 1000.0, "frozen yes;", 1000.0, 0.0);
    which("in a gas", "", sphere, 1000.0, "", 1.2, 0.0);
    which("a parcel, 9.99 times", parcels, sphere, 9990.0, "", 1000.0, 3.0);
    which("a parcel, 10.01 times", parcels, sphere, 10010.0, "", 1000.0, 0.0);
    which("a clump, 9.99 times", pair, clump, 9990.0, "", 1000.0, 3.0);
    which("a clump, 10.01 times", pair, clump, 10010.0, "", 1000.0, 0.0);

    /* T/tau = 1e-3 18 mu/(rho d^2) = 1.8 */
    const double free_response = (1.0 - exp(-1.8))/1.8;
    TAP_OK(fabs(response(0.3, 1e-3, 0.0)/free_response - 1.0) < 1e-9, "free: %g of b T, closed form %g",
           response(0.3, 1e-3, 0.0), free_response);
    TAP_OK(fabs(response(0.0, 0.0, 0.0)/free_response - 1.0) < 1e-9, "all at rest: %g", response(0.0, 0.0, 0.0));
    for (double units = -8; units <= 8; units++)
    {
        const double r = response(0.3, units*DBL_EPSILON, 0.0), pulled = response(0.3, units*DBL_EPSILON, 9.81);

        TAP_OK(fabs(r/free_response - 1.0) < 1e-9, "%g roundings from the fluid's velocity: %g", units, r);
        TAP_OK(pulled == 1.0, "the same under gravity: %g", pulled);
    }
    for (int power = -14; power <= -9; power++)
    {
        const double r = response(0.3, pow(10.0, power), 0.0);

        TAP_OK(fabs(r/free_response - 1.0) < 0.02, "slip of 1e%d of the velocity: %g", power, r);
    }
    TAP_DONE;
}
