/*
 * test_gravity.c -- the weight m g is added to the force, for any direction of g, in proportion to
 * the mass.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"

int main(void)
{
    static struct dem_body_batch b;
    static const double down[3] = {0.3, -0.2, -9.81};
    double settings[4] = {0};

    TAP_TRAPS;
    dem_settings_set_defaults(dem_gravity.settings, settings);
    TAP_OK(dem_settings_check_complete(dem_gravity.settings, settings, "gravity") ==
               DEM_ERROR_INPUT,
           "acceleration is a required setting");
    TAP_OK(dem_settings_set_number(dem_gravity.settings, settings, "gravity", "acceleration", down,
                                   3) == DEM_OK,
           "acceleration can be set");

    b.n = 3;
    for (int c = 0; c < 3; c++)
    {
        b.mass[c] = c;
        b.fx[c] = 1.0, b.fz[c] = 2.0;
    }
    dem_gravity.apply_to_bodies(settings, &b);
    TAP_OK(b.fx[0] == 1.0 && b.fy[0] == 0.0 && b.fz[0] == 2.0,
           "mass 0: the force is not changed");
    TAP_OK(b.fx[1] == 1.0 + 0.3 && b.fy[1] == -0.2 && b.fz[1] == 2.0 - 9.81, "1 kg");
    TAP_OK(b.fx[2] == 1.0 + 2.0*0.3 && b.fy[2] == -2.0*0.2 && b.fz[2] == 2.0 - 2.0*9.81, "2 kg");
    TAP_OK(b.drag[2] == 0.0 && b.drag_ux[2] == 0.0, "no drag");
    TAP_DONE;
}
