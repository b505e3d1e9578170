/*
 * test_capillary_force.c -- surface tension on a sphere at the interface of two fluids.
 *
 * - It is zero where a plane interface meets the sphere at the contact angle, with the stiffness
 *   2 pi sigma.
 * - The largest loads are 2 pi sigma R sin^2(theta/2) and 2 pi sigma R cos^2(theta/2).
 * - The work to pull the sphere into either fluid is 2/3 of the change of the surface energy.
 * - It is along the normal, and zero where the sphere does not reach the interface.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"
#include "laws/fluid/capillary_force.h"

static const double pi = 3.14159265358979324, R = 3e-4, sigma = 0.05;

static struct dem_capillary_force law;

/* Force along the normal z with the centre at this height. */
static double at(double height)
{
    static struct dem_body_batch b;

    memset(&b, 0, sizeof b);
    b.n = 1;
    b.radius[0] = R;
    b.tension_z[0] = sigma;
    b.interface_distance[0] = height;
    dem_capillary_force.apply_to_bodies(&law, &b);
    return b.fz[0];
}

int main(void)
{
    enum { STEPS = 200000 };
    static struct dem_body_batch b;

    TAP_TRAPS;
    for (int angle = 20; angle < 180; angle += 35)
    {
        const double theta = angle*pi/180.0, rest = -R*cos(theta), h = 1e-5*R;
        double up = 0.0, down = 0.0, work_down = 0.0, work_up = 0.0;

        law.contact_angle = angle;
        TAP_OK(dem_capillary_force.prepare(&law, NULL) == DEM_OK, "contact angle %d", angle);
        TAP_NEAR(at(rest)/(2.0*pi*sigma*R), 0.0, 1e-15, "%d: no force at the contact angle", angle);
        /* second order in h/R over the sine, at most 1e-9 */
        TAP_NEAR((at(rest - h) - at(rest + h))/(2.0*h)/(2.0*pi*sigma), 1.0, 1e-8,
                 "%d: the stiffness is 2 pi sigma", angle);
        for (int k = 0; k < STEPS; k++)
        {
            const double z = R*(-1.0 + 2.0*(k + 0.5)/STEPS), f = at(z);

            up = fmax(up, f), down = fmin(down, f);
            *(z < rest ? &work_down : &work_up) += f*2.0*R/STEPS;
        }
        const double half = sin(0.5*theta), other = cos(0.5*theta), energy = sigma*pi*R*R;

        /* a maximum among points 1e-5 R apart; the integral: roots at the ends */
        TAP_NEAR(up/(2.0*pi*sigma*R*half*half), 1.0, 1e-8, "%d: largest load towards phase 1", angle);
        TAP_NEAR(-down/(2.0*pi*sigma*R*other*other), 1.0, 1e-8, "%d: towards phase 2", angle);
        TAP_NEAR(work_down/(energy*4.0*half*half*half*half), 2.0/3.0, 1e-4, "%d: work into phase 1", angle);
        TAP_NEAR(-work_up/(energy*4.0*other*other*other*other), 2.0/3.0, 1e-4, "%d: work into phase 2", angle);
    }
    TAP_OK(at(R) == 0.0 && at(-R) == 0.0 && at(1.001*R) == 0.0 && at(-1e3*R) == 0.0 && at(1e300) == 0.0,
           "none where the sphere does not reach the interface");

    law.contact_angle = 0.0;
    (void)dem_capillary_force.prepare(&law, NULL);
    TAP_OK(at(-0.5*R) < 0.0 && at(0.5*R) < 0.0, "a sphere that phase 1 wets is drawn into it");
    law.contact_angle = 180.0;
    (void)dem_capillary_force.prepare(&law, NULL);
    TAP_OK(at(-0.5*R) > 0.0 && at(0.5*R) > 0.0, "one that it does not wet is expelled");

    b.n = 2;
    b.radius[0] = R;
    b.tension_x[0] = 0.6*sigma, b.tension_y[0] = -0.8*sigma;
    b.interface_distance[0] = -0.4*R;
    b.tension_x[1] = sigma;
    b.fx[0] = 1.0;
    dem_capillary_force.apply_to_bodies(&law, &b);
    TAP_NEAR((b.fx[0] - 1.0)/0.6 + b.fy[0]/0.8, 0.0, 1e-15, "along the normal, added to the force");
    TAP_OK(b.rx[0] == 0.0 && b.fx[1] == 0.0, "in no other column, and zero in an empty row");
    TAP_DONE;
}
