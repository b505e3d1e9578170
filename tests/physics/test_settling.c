/*
 * test_settling.c -- a sphere in a uniform fluid settles as an independent integration does.
 *
 * Source: settling_liquid.csv, 0.1 mm in a liquid, Schiller and Naumann, Z. Ver. Dtsch. Ing. 77
 * (1933) 318.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    MOST = 64, LIQUID = 5
};

/* Schiller and Naumann with buoyancy; the table's step of the core's 1e-5 s. */
static void liquid(void)
{
    static const char scene[] =
        "materials { bead { density 3000; youngsModulus 1e7; } }"
        "effects { wenYu {} pressureGradient {} gravity { acceleration (0 0 -9.81); } }"
        "fluid { density 10; viscosity 1e-4; } time { step 1e-5; }"
        "insert { one { type list; diameter 1e-4; positions ((0 0 0)); } }";
    double table[LIQUID*MOST];
    const int rows = world_table("physics/settling_liquid.csv", LIQUID, MOST, table);
    struct dem *const d = world(scene, 0, NULL);
    double worst_v = 0.0, worst_x = 0.0;

    for (int k = 1; k < rows; k++)
    {
        world_run(d, table[LIQUID*k] - table[LIQUID*(k - 1)]);
        const struct world_particle p = world_at(d, 0);

        worst_v = fmax(worst_v, fabs(-p.v[2]/table[LIQUID*k + 1] - 1.0));
        worst_x = fmax(worst_x, fabs(-p.x[2]/table[LIQUID*k + 2] - 1.0));
    }
    const double last = -world_at(d, 0).v[2];

    /* drag is exact within a kick except for its coefficient, taken at the kick's start: some 1e-5
       at step/tau = 6e-4 */
    TAP_OK(rows == 21, "liquid: %d rows", rows);
    TAP_NEAR(worst_v, 0.0, 1e-4, "liquid: speed within %.1e of the reference at all times",
             worst_v);
    TAP_NEAR(worst_x, 0.0, 1e-4, "liquid: path within %.1e", worst_x);
    TAP_NEAR(last, 0.137337, 1e-5*last, "liquid: terminal speed %.6f m/s", last);
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    liquid();
    TAP_DONE;
}
