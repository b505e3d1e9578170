/*
 * test_settling.c -- a sphere in a uniform fluid settles as an independent integration does, and
 * follows a fluid of any viscosity without oscillation.
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

/* tau = m/b from 1e-8 s to 1e-3 of that, steps of 1e-5 s. */
static void stiff(double viscosity)
{
    struct dem *const d = world(world_text(
        "materials { bead { density 1000; youngsModulus 1e7; } } effects { wenYu {} }"
        "fluid { density 1000; viscosity %g; velocity (0.3 0 -0.1); } time { step 1e-5; }"
        "insert { two { type list; diameter 1.9e-5; positions ((0 0 0) (1 0 0));"
        "velocities ((0 0 0) (50 -20 3)); } }",
        viscosity), 0, NULL);
    double worst = 0.0;

    for (int k = 0; k < 100; k++)
    {
        world_run(d, 1e-5*(k%3 + 1));
        for (int i = 0; i < 2; i++)
        {
            const struct world_particle p = world_at(d, i);

            worst = fmax(worst, fabs(p.v[0] - 0.3) + fabs(p.v[1]) + fabs(p.v[2] + 0.1));
        }
    }
    TAP_NEAR(worst, 0.0, 1e-12,
             "step/tau = %.0e: with the fluid within %.0e m/s after one step, and stays",
             1e-5/ (1000.0*1.9e-5*1.9e-5/(18.0*viscosity)), worst);
    dem_free(d);
}

static void frozen(void)
{
    static const char scene[] =
        "materials { bead { density 2000; youngsModulus 1e7; } }"
        "effects { wenYu {} gravity { acceleration (0 0 -9.81); } }"
        "fluid { density 1000; viscosity 1e-3; velocity (1 0 0); } time { step 1e-4; }"
        "insert { one { type list; diameter 1e-3; positions ((0 0 0)); frozen yes; } }";
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 0.1);
    const struct world_particle p = world_at(d, 0);

    TAP_OK(p.x[0] == 0.0 && p.x[2] == 0.0 && p.v[0] == 0.0 && p.v[2] == 0.0,
           "a frozen sphere stays in a stream");
    dem_free(d);
}

static void floating(void)
{
    static const char scene[] =
        "materials { bead { density 1000; youngsModulus 1e7; } }"
        "effects { wenYu {} pressureGradient {} gravity { acceleration (3 -4 -9.81); } }"
        "fluid { density 1000; viscosity 1e-3; } time { step 1e-4; }"
        "insert { one { type list; diameter 2e-3; positions ((0 0 0)); } }";
    struct dem *const d = world(scene, 0, NULL);

    world_run(d, 1.0);
    const struct world_particle p = world_at(d, 0);

    /* weight and buoyancy cancel to round-off, 1e-16 g for a second */
    TAP_NEAR(fabs(p.v[0]) + fabs(p.v[1]) + fabs(p.v[2]), 0.0, 1e-12,
             "as dense as the fluid: floats");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    liquid();
    stiff(2.0);
    stiff(2e3);
    stiff(2e5);
    frozen();
    floating();
    TAP_DONE;
}
