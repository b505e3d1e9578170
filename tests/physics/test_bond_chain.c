/*
 * test_bond_chain.c -- a chain of bonds, clamped at one end, has the deflections and frequencies
 * of its matrices, and approaches Timoshenko's beam; an end moment closes it to a polygon.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/bonded.h"

struct line                                               /* m, rad, m, Hz */
{
    int bonds;
    double longer, twist, bend, f_axial, f_torsion, f_bending;
};

static const struct line table[] = {
    {1, 6.36619772e-07, 0.000318309886, 4.13802852e-09, 61640.4444, 43586.3762, 22401.0583},
    {2, 1.27323954e-06, 0.000636619772, 2.86478898e-08, 38095.8897, 26937.862, 8439.1645},
    {5, 3.18309886e-06, 0.00159154943, 4.28126797e-07, 17544.6998, 12405.9762, 1781.02506},
    {10, 6.36619772e-06, 0.00318309886, 3.40273268e-06, 9212.79236, 6514.42795, 490.681656},
    {20, 1.27323954e-05, 0.00636619772, 2.71772981e-05, 4721.99505, 3338.95472, 128.875598},
};

enum load
{
    AXIAL,
    TORSION,
    BENDING
};

/* Displacement under the load. Particles keep no angle, so the twist follows from the bond energy:
   E = T twist/2. */
static double response(struct dem *d, int bonds, enum load load)
{
    const struct world_particle p = world_at(d, bonds);

    return load == AXIAL ? p.x[0] - L*bonds
           : load == BENDING ? p.x[2]
                             : 2.0*world_tally(d).stored/1e-4;
}

/* The oscillating quantity: a position, or the angle of the end, integrated from its spin. */
static double oscillating(struct dem *d, int bonds, enum load load, double angle[2])
{
    const struct world_particle p = world_at(d, bonds);

    angle[0] += 0.5*dem_step_limit(d).used*(angle[1] + p.w[0]);
    angle[1] = p.w[0];
    return load == AXIAL ? p.x[0] - L*bonds : load == BENDING ? p.x[2] : angle[0];
}

enum
{
    PERIODS = 20
};

/* Hz, over many periods between upward crossings */
static double frequency(struct dem *d, int bonds, enum load load)
{
    const double dt = dem_step_limit(d).used;
    double angle[2] = {load == TORSION ? response(d, bonds, load) : 0.0, 0.0}, first = 0.0;
    double before = load == TORSION ? angle[0] : response(d, bonds, load);
    int crossings = 0;

    for (int k = 1; k < 2000000; k++)
    {
        world_step(d);
        const double now = oscillating(d, bonds, load, angle);

        if (before < 0.0 && now >= 0.0)
        {
            const double at = dt*(k - now/(now - before));

            first = crossings == 0 ? at : first;
            if (crossings++ == PERIODS)
            {
                return PERIODS/(at - first);
            }
        }
        before = now;
    }
    return 0.0;
}

static void chain(const struct line *t, enum load load)
{
    static const char *const names[] = {"extension", "twist", "deflection"};
    const double force[3] = {load == AXIAL ? 1.0 : 0.0, 0.0, load == BENDING ? 1e-3 : 0.0};
    const double moment[3] = {load == TORSION ? 1e-4 : 0.0, 0.0, 0.0};
    const double expected = load == AXIAL ? t->longer : load == TORSION ? t->twist : t->bend;
    const double f = load == AXIAL ? t->f_axial : load == TORSION ? t->f_torsion : t->f_bending;
    struct dem_new_particle seed[MAX_CHAIN];

    chain_seeds(seed, t->bonds + 1, 1);
    struct dem *const d = bonded(1.0, 0.0, "", t->bonds + 1, seed);

    chain_relax(d, t->bonds, force, moment);
    TAP_NEAR(response(d, t->bonds, load), expected, 1e-3*expected, "%d bonds: %s", t->bonds,
             names[load]);
    /* higher modes shift the crossings; the step of 0.2 of the limit raises all frequencies by 0.7
       % at most */
    TAP_NEAR(frequency(d, t->bonds, load), f, 5e-3*f, "%d bonds: frequency of %s", t->bonds,
             names[load]);
    dem_free(d);
}

/* M = k_n I 2 pi/n bends each bond by 2 pi/n: the end returns to the clamp. */
static void polygon(void)
{
    const int bonds = 12;
    const double turn = 2.0*world_pi/bonds, rest[3] = {0.0, 0.0, 0.0};
    struct dem_new_particle seed[MAX_CHAIN];

    chain_seeds(seed, bonds + 1, 1);
    /* the moment rises from 0 over some 20 periods of the slowest mode; bonds are damped, and soft
       for long steps */
    struct dem *const d = bonded(1e-2, 0.0, "dampingRatio 1;", bonds + 1, seed);
    const int steps = 100000;

    for (int k = 0; k < steps + 1000; k++)
    {
        const double moment[3] = {0.0, 1e-2*kn*I*turn*chain_ramp(k, steps), 0.0};

        chain_load(d, bonds, rest, moment);
    }
    const struct world_particle p = world_at(d, bonds);
    const double energy = 0.5*1e-2*kn*I*turn*turn*bonds;

    TAP_NEAR(sqrt(vector_dot(p.x, p.x)), 0.0, 0.01*L, "an end moment closes a chain of %d bonds",
             bonds);
    TAP_NEAR(world_tally(d).stored, energy, 0.01*energy, "the polygon has the energy of its bending");
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    for (size_t k = 0; k < sizeof table/sizeof *table; k++)
    {
        chain(&table[k], AXIAL);
        chain(&table[k], TORSION);
        chain(&table[k], BENDING);
    }
    polygon();
    TAP_DONE;
}
