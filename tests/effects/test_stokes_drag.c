/*
 * test_stokes_drag.c -- Stokes' law: G = 1 for any slip and void fraction.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "drag_table.h"

int main(void)
{
    TAP_TRAPS;
    /* rounding of a product of five */
    for (double re = 0.0; re < 1e5; re = 10.0*re + 1e-3)
    {
        TAP_NEAR(body_drag(&dem_stokes_drag, NULL, 0.4, re), 1.0, 1e-15, "Re = %g, e = 0.4", re);
        TAP_NEAR(body_drag(&dem_stokes_drag, NULL, 1.0, re), 1.0, 1e-15, "Re = %g, e = 1", re);
    }
    drag_limits(&dem_stokes_drag, NULL);
    drag_form(&dem_stokes_drag, NULL);
    TAP_DONE;
}
