/*
 * test_viscous_stress.c -- the force V div tau on a particle, with its reaction on the fluid.
 *
 * In steady flow through a straight tube, where div tau = grad p, it cancels the pressure gradient:
 * a sphere that moves with the fluid has no net force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

int main(void)
{
    static struct dem_body_batch b;

    TAP_TRAPS;
    b.n = 2;
    b.volume[0] = 2e-9;
    b.sx[0] = 1e4, b.sy[0] = -2e4, b.sz[0] = 3e4;
    b.rx[0] = 1.0;
    dem_viscous_stress.apply_to_bodies(NULL, &b);
    TAP_OK(b.rx[0] == 1.0 + 2e-9*1e4 && b.ry[0] == -2e-9*2e4 && b.rz[0] == 2e-9*3e4,
           "adds V div tau");
    TAP_OK(b.fx[0] == 0.0 && b.rx[1] == 0.0, "in no other column, and zero in an empty row");
    TAP_OK(dem_viscous_stress.needs == (DEM_NEEDS_FLUID | DEM_NEEDS_STRESS), "it needs the stress");

    memset(&b, 0, sizeof b);
    b.n = 1;
    b.volume[0] = sphere_volume(1e-3);
    b.gx[0] = b.sx[0] = -37.0;
    dem_viscous_stress.apply_to_bodies(NULL, &b);
    dem_pressure_gradient.apply_to_bodies(NULL, &b);
    TAP_OK(b.fx[0] + b.rx[0] == 0.0, "tube: the two cancel");
    TAP_DONE;
}
