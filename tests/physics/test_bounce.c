/*
 * Claims: a sphere that falls on a linear spring with a dashpot rebounds at the time, with the speed and to the height of the
 * damped oscillator under its weight (0.1 %), with the dashpot given by restitution and by
 * coefficient; three spheres in a row of Newton's cradle on linear springs part with the speeds of the exact solution.
 *
 * Set: DEM01 of the MFiX-DEM suite, Garg, Galvin, Li, Pannala, Powder Technol. 220 (2012) 122; bounce_spring.csv.
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
    const double m = world_ball(R, density), k = t[0], L = -log(t[1]), z = L/sqrt(world_pi*world_pi + L*L);
    const double step = world_pi*sqrt(m/k)/2000.0;
    const struct dem_seed seed = {.position = {0.0, 0.0, height}, .diameter = 2.0*R, .material = "b"};
    char damping[80];

    snprintf(damping, sizeof damping, by_coefficient ? "viscous { coefficient %.17g; }" : "dry { restitution %.17g; }",
             by_coefficient ? 2.0*z*sqrt(k*m) : t[1]);
    char *const scene = world_text("materials { b { density %g; youngsModulus 1e7; } } effects { hooke { stiffness %g; } %s"
                                   "gravity { acceleration (0 0 -%.17g); } } time { step %.17g; }"
                                   "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }", density, k, damping, g, step);
    struct dem *const d = world(scene, 1, &seed);
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
    TAP_NEAR(rebound/t[2], 1.0, 1e-3, "k %g N/m, e %g by %s: rebounds after %.6f s", k, t[1], what, rebound);
    TAP_NEAR(speed/t[3], 1.0, 1e-3, "k %g N/m, e %g by %s: at %.5f m/s", k, t[1], what, speed);
    TAP_NEAR(apex/t[4], 1.0, 1e-3, "k %g N/m, e %g by %s: to %.5f m", k, t[1], what, apex);
    TAP_NEAR(deepest/t[5], 1.0, 1e-3, "k %g N/m, e %g by %s: after %.5f m of overlap", k, t[1], what, deepest);
    free(scene);
    dem_free(d);
}

/* equal spheres that just touch, the first comes at 1 m/s: speeds of the linear chain, from its independent integration */
static void cradle(void)
{
    static const double parted[3] = {-0.130263, 0.150218, 0.980045};
    struct dem_seed seed[3];
    const double m = world_ball(1e-3, 2500.0), k = 1e4, v = 0.1, step = world_pi*sqrt(0.5*m/k)/400.0;
    char *const scene = world_text("materials { b { density 2500; youngsModulus 1e7; } } effects { hooke { stiffness %g; } }"
                                   "time { step %.17g; }", k, step);

    memset(seed, 0, sizeof seed);
    for (int i = 0; i < 3; i++)
    {
        seed[i] = (struct dem_seed){.position = {2e-3*i, 0.0, 0.0}, .diameter = 2e-3, .id = i, .material = "b",
                                    .velocity = {i ? 0.0 : v, 0.0, 0.0}};
    }
    struct dem *const d = world(scene, 3, seed);

    world_run(d, 10.0*world_pi*sqrt(m/k));
    for (int i = 0; i < 3; i++)
    {
        /* six digits printed; second order in the step, 1/400, and the start of contacts within a step */
        TAP_NEAR(world_at(d, i).v[0]/v, parted[i], 2e-3, "cradle: sphere %d leaves with %.4f", i, world_at(d, i).v[0]/v);
    }
    free(scene);
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
    cradle();
    TAP_DONE;
}
