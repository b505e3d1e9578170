/*
 * test_bond_strength.c -- in a run a bond breaks within one increment of the load at its limit and its
 * energy is lost, a loaded chain breaks at its root, and a relaxing bond loses force as exp(-eta t). All
 * criteria of strength: effects/test_bond_linear.c.
 *
 * Numbers: R = 1 mm, sigma_max = 1e7 Pa, from the section's formulas in another program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/bonded.h"

static struct dem *pair(const char *more, double time_step)
{
    struct dem_new_particle seed[2];

    chain_seeds(seed, 2, 1);
    return bonded(1.0, time_step, more, 2, seed);
}

/* Particle 0 is fixed, 1 is moved along the bond by 1/2000 of the elongation at the limit in each step. */
static void limit_in_tension(void)
{
    struct dem *const d = pair("normalStrength 1e7; shearStrength 5e6;", 0.0);
    const double dt = dem_step_limit(d).used, none[3] = {0.0, 0.0, 0.0},
                 v[3] = {2e-5/2000.0/dt, 0.0, 0.0}, expected = 31.4159265;
    struct world_particle last;

    for (int k = 0; k < 3000 && world_tally(d).broken == 0.0; k++)
    {
        last = world_at(d, 1);
        chain_set(d, 1, v, none);
        /* compensates the half kick to come: the motion is prescribed */
        chain_kick(d, 1, last.f, last.t, -0.5*dt);
        world_step(d);
    }
    const struct dem_totals t = world_tally(d);

    TAP_OK(t.broken > 0.0 && t.bonds == 0 && t.stored == 0.0, "tension: breaks");
    /* one increment of 1/2000 of the limit before */
    TAP_NEAR(fabs(last.f[0]), expected*(1.0 - 0.5/2000.0), 1.5/2000.0*expected, "at %.4g N", expected);
    TAP_OK(t.lost > 0.0, "%.3g J lost", t.lost);
    dem_free(d);
}

/* A tenth of the table's strength and load, so that the tip moves by 0.7 % of the length: large
   rotations change 3e-5. */
static void root_of_a_chain(void)
{
    const int bonds = 10;
    struct dem_new_particle seed[MAX_CHAIN];

    for (int over = 0; over < 2; over++)
    {
        const double force[3] = {0.0, 0.0, 0.0413367454*(over ? 1.001 : 0.999)},
                     none[3] = {0.0, 0.0, 0.0};

        chain_seeds(seed, bonds + 1, 1);
        struct dem *const d =
            bonded(1.0, 0.0, "normalStrength 1e6; dampingRatio 0.5;", bonds + 1, seed);

        /* a sudden load would overshoot to twice its value: it rises over twelve periods */
        for (int k = 0; k < 50000 && world_tally(d).broken == 0.0; k++)
        {
            const double now[3] = {0.0, 0.0, chain_ramp(k, 48000)*force[2]};

            chain_load(d, bonds, now, none);
        }
        TAP_OK((world_tally(d).broken > 0.0) == over, "a chain at %s of its strength %s",
               over ? "1.001" : "0.999", over ? "breaks" : "holds");
        if (over)
        {
            const struct world_particle p = world_at(d, 0);

            TAP_OK(world_tally(d).bonds == bonds - 1 &&
                       vector_dot(p.f, p.f) + vector_dot(p.t, p.t) == 0.0,
                   "it breaks at its root");
        }
        dem_free(d);
    }
}

/* Exact at fixed ends: F = F_0 exp(-eta t), E_el = E_0 exp(-2 eta t), E_el + E_d = E_0. */
static void relaxation(void)
{
    static const double times[] = {2e-4, 5e-4, 1e-3, 2e-3},
                        forces[] = {1.28605926, 0.952736132, 0.577863675, 0.212584166};
    static const double stored[] = {5.26468133e-07, 2.88931837e-07, 1.06292083e-07, 1.43850691e-08};
    struct dem *const d = pair("relaxation 1e3;", 5e-7);
    const double dt = dem_step_limit(d).used, none[3] = {0.0, 0.0, 0.0},
                 fast[3] = {1e-6/dt, 0.0, 0.0};
    double time = 0.0;
    int next = 0;

    chain_set(d, 1, fast, none);
    world_step(d);
    chain_set(d, 1, none, none);
    /* the step of the elongation relaxes it, too */
    for (time = dt; next < 4; time += dt)
    {
        struct world_particle p = world_at(d, 1);

        if (time > times[next] - 0.5*dt)
        {
            const struct dem_totals t = world_tally(d);

            TAP_NEAR(fabs(p.f[0]), forces[next], 1e-6*forces[next], "force after %g s",
                     times[next]);        /* eight digits, and the */
            TAP_NEAR(t.stored, stored[next], 1e-6*stored[next],
                     "stored");                                   /* moves of half kicks   */
            TAP_NEAR(t.stored + t.lost, 7.85398163e-7, 1e-6*7.85398163e-7,
                     "stored and lost together");
            next++;
        }
        chain_kick(d, 1, p.f, p.t, -0.5*dt);
        world_step(d);
        chain_set(d, 1, none, none);
    }
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    limit_in_tension();
    root_of_a_chain();
    relaxation();
    TAP_DONE;
}
