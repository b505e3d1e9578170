/*
 * test_pressure_gradient.c -- the force -V grad p.
 *
 * In a fluid at rest it is Archimedes' buoyancy: under gravity a body as dense as the fluid floats.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

int main(void)
{
    static struct dem_body_batch b;
    static const double g[3] = {0.0, 0.0, -9.81};
    double gravity[3] = {g[0], g[1], g[2]};

    TAP_TRAPS;
    b.n = 2;
    b.volume[0] = 2e-9;
    b.gx[0] = 1e4, b.gy[0] = -2e4, b.gz[0] = 3e4;
    b.fx[0] = 1.0;
    dem_pressure_gradient.apply_to_bodies(NULL, &b);
    TAP_OK(b.fx[0] == 1.0 - 2e-9*1e4 && b.fy[0] == 2e-9*2e4 && b.fz[0] == -2e-9*3e4,
           "adds -V grad p");
    TAP_OK(b.fx[1] == 0.0 && b.fy[1] == 0.0 && b.fz[1] == 0.0, "an empty row has no force");
    TAP_OK(dem_pressure_gradient.needs & DEM_NEEDS_FLUID, "it needs the fluid");

    memset(&b, 0, sizeof b);
    b.n = 1;
    b.volume[0] = sphere_volume(1e-3);
    b.mass[0] = 1000.0*b.volume[0];
    b.gz[0] = 1000.0*g[2];
    dem_pressure_gradient.apply_to_bodies(NULL, &b);
    dem_gravity.apply_to_bodies(gravity, &b);
    /* two products rounded in a different order: two units in the last place of 5 uN */
    TAP_NEAR(b.fz[0], 0.0, 4.0*5.2e-6*0x1p-53, "a sphere as dense as the fluid floats");
    TAP_DONE;
}
