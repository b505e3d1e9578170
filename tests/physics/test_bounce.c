/*
 * test_bounce.c -- linear springs with dashpots bounce, and oscillate in a gap, as the damped
 * oscillator does (DEM01 to DEM03 of the MFiX-DEM suite).
 *
 * Sources: Garg, Galvin, Li, Pannala, Powder Technol. 220 (2012) 122; bounce_spring.csv,
 * squeezed_pair.csv.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

enum
{
    COLUMNS = 6, MOST = 20
};

static const double R = 0.1, density = 2600.0, height = 0.5, g = 9.80665;

/* falls from rest; the rows of the table: stiffness, restitution, time, speed, apex, overlap */
static void bounce(const double *t, int by_coefficient)
{
    const double m = world_sphere_mass(R, density), k = t[0], L = -log(t[1]),
                 z = L/sqrt(world_pi*world_pi + L*L);
    const double step = world_pi*sqrt(m/k)/2000.0;
    const struct dem_new_particle seed = {
        .position = {0.0, 0.0, height}, .diameter = 2.0*R, .material = "b"};
    char damping[80];

    snprintf(damping, sizeof damping,
             by_coefficient ? "viscous { coefficient %.17g; }" : "dry { restitution %.17g; }",
             by_coefficient ? 2.0*z*sqrt(k*m) : t[1]);
    struct dem *const d = world(world_text(
        "materials { b { density %g; youngsModulus 1e7; } } effects { hooke { stiffness %g; } %s"
        "gravity { acceleration (0 0 -%.17g); } } time { step %.17g; }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }",
        density, k, damping, g, step), 1, &seed);
    struct world_particle before = world_at(d, 0), now = before;
    double time = 0.0, rebound = 0.0, speed = 0.0, apex = 0.0, deepest = 0.0;

    while (time < 1.0 && !(apex > 0.0))
    {
        before = now;
        world_step(d);
        time += step;
        now = world_at(d, 0);
        deepest = fmax(deepest, R - now.x[2]);
        if (rebound == 0.0 && before.x[2] < R && now.x[2] >= R)
        {
            const double share = (R - before.x[2])/(now.x[2] - before.x[2]);

            rebound = time - step*(1.0 - share);
            speed = before.v[2] + share*(now.v[2] - before.v[2]);
        }
        apex = rebound > 0.0 && now.v[2] <= 0.0 ? now.x[2] : 0.0;
    }
    const char *const what = by_coefficient ? "coefficient" : "restitution";

    /* a dashpot is of first order in the step: 1e-4 at t_c/2000 and e = 0.6 */
    TAP_NEAR(rebound/t[2], 1.0, 1e-3, "k %g N/m, e %g by %s: rebounds after %.6f s", k, t[1],
             what, rebound);
    TAP_NEAR(speed/t[3], 1.0, 1e-3, "k %g N/m, e %g by %s: at %.5f m/s", k, t[1], what, speed);
    TAP_NEAR(apex/t[4], 1.0, 1e-3, "k %g N/m, e %g by %s: to %.5f m", k, t[1], what, apex);
    TAP_NEAR(deepest/t[5], 1.0, 1e-3, "k %g N/m, e %g by %s: after %.5f m of overlap", k, t[1],
             what, deepest);
    dem_free(d);
}

/* ---- squeezed -------------------------------------------------------------------------------- */

/* A scene with overlaps of a tenth of a diameter is refused. The spheres start side by side; the
   test then moves them into the gap and applies the half kick of the springs, which the start
   lacks. */
static struct dem *squeezed(double e, double share)
{
    const double m[2] = {world_sphere_mass(5e-4, 2e4), world_sphere_mass(5e-4, 1e4)},
                 step = world_pi*sqrt(m[0]/3.0/1e3)*share;
    const double height[2] = {4.5e-4, 1.35e-3}, push[2] = {1e3*(5e-5 - 1e-4), 1e3*(1e-4 - 5e-5)};
    const struct dem_new_particle seed[2] =
        {{.position = {0.0, 0.0, 9e-4}, .diameter = 1e-3, .id = 0, .material = "heavy"},
         {.position = {1.05e-3, 0.0, 9e-4}, .diameter = 1e-3, .id = 1, .material = "light"}};
    struct dem *const d = world(world_text(
        "materials { heavy { density 2e4; youngsModulus 1e7; } light { density 1e4; "
        "youngsModulus 1e7; } }"
        "effects { hooke { stiffness 1000; } dry { restitution %g; } "
        "gravity { acceleration (0 0 -%.17g); } }"
        "time { step %.17g; } neighbours { outerSkin 2; innerSkin 2; }"
        "walls { floor { type plane; material heavy; point (0 0 0); normal (0 0 1); }"
        " lid { type plane; material heavy; point (0 0 1.8e-3); normal (0 0 -1); } }",
        e, g, step), 2, seed);
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const size_t i = (size_t)world_id(&v, k);
        double *const x = (double *)(uintptr_t)dem_at(v.position, v.stride, k);

        x[0] = 0.0, x[2] = height[i];
        ((double *)(uintptr_t)dem_at(v.velocity, v.stride, k))[2] = 0.5*step*push[i]/m[i];
    }
    return d;
}

/* rows of one restitution: restitution, time, heights of both */
static void squeeze(const double *row, int rows, double share)
{
    struct dem *const d = squeezed(row[0], share);
    struct world_particle before[2], now[2];
    double time = 0.0, worst = 0.0;

    world_all(d, now);
    for (int k = 0; k < rows; k++)
    {
        const double *const t = row + 4*k;

        memcpy(before, now, sizeof now);
        while (time < t[1])
        {
            memcpy(before, now, sizeof now);
            world_step(d);
            world_all(d, now);
            time += dem_step_limit(d).used;
        }
        const double part = (time - t[1])/dem_step_limit(d).used;

        for (int i = 0; i < 2; i++)
        {
            worst =
                fmax(worst,
                     fabs((1.0 - part)*now[i].x[2] + part*before[i].x[2] - t[2 + i])/1e-3);
        }
    }
    /* second order in the step without a dashpot, t_c/50 then; first order with one, t_c/2000 */
    TAP_NEAR(worst, 0.0, 5e-4, "squeezed pair, e %g: %d positions of both", row[0], rows);
    dem_free(d);
}

static void squeezes(void)
{
    double table[80*4];
    const int rows = world_table("physics/squeezed_pair.csv", 4, 80, table);

    TAP_OK(rows == 66, "%d rows in squeezed_pair.csv", rows);
    for (int k = 0; k + 11 <= rows; k += 11)
    {
        squeeze(table + 4*k, 11, table[4*k] == 1.0 ? 0.02 : 5e-4);
    }
    struct dem *const d = squeezed(0.5, 0.02);

    world_run(d, 0.05);
    const double lower = world_at(d, 0).x[2], upper = world_at(d, 1).x[2];

    /* three springs, compressed by 0.2 mm in all, and two weights; digits as printed */
    TAP_NEAR(5e-4 - lower, 66.752e-6, 1e-9, "at rest: %.3f um at the floor", 1e6*(5e-4 - lower));
    TAP_NEAR(1e-3 - upper + lower, 66.650e-6, 1e-9, "%.3f um between them",
             1e6*(1e-3 - upper + lower));
    TAP_NEAR(upper + 5e-4 - 1.8e-3, 66.598e-6, 1e-9, "%.3f um at the lid",
             1e6*(upper + 5e-4 - 1.8e-3));
    dem_free(d);
}

int main(void)
{
    double table[COLUMNS*MOST];
    const int rows = world_table("physics/bounce_spring.csv", COLUMNS, MOST, table);

    TAP_TRAPS;
    TAP_OK(rows == 15, "%d bounces", rows);
    for (int k = 0; k < rows; k++)
    {
        bounce(table + COLUMNS*k, 0);
    }
    bounce(table + COLUMNS*(rows - 1), 1);
    squeezes();
    TAP_DONE;
}
