/*
 * test_bond_strength.c -- a bond breaks at the stress of its limit, within one increment of the
 * load, its elastic energy is reported as lost, and a relaxing bond loses force as exp(-eta t).
 *
 * Table: R = 1 mm, sigma_max = 1e7 Pa, tau_max = 5e6 Pa, phi = 30 degrees, from the section's
 * formulas in another program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/bonded.h"

static const char limits[] = "normalStrength 1e7; shearStrength 5e6;";

/* of particle 1, per step: along x, along y, about x, about z */
struct motion
{
    double along, across, twist, bend;
};

/* Particle 0 is fixed, 1 is moved. Returns the reaction in the last step before the bond breaks; 0:
   it did not break. */
static double break_by_motion(struct dem *d, struct motion m, int steps, struct world_particle *last)
{
    const double dt = dem_step_limit(d).used;

    for (int k = 0; k < steps; k++)
    {
        *last = world_at(d, 1);
        /* bent by an angle, the axis of the bond rotates by half of it: no slip and no
           elongation */
        const double half = 0.5*m.bend*(k + 1), bent = m.bend != 0.0 ? 1.0 : 0.0;
        const double v[3] = {(m.along + bent*(L*cos(half) - last->x[0]))/dt,
                             (m.across + bent*(L*sin(half) - last->x[1]))/dt, 0.0};
        const double w[3] = {m.twist/dt, 0.0, m.bend/dt}, none[3] = {0.0, 0.0, 0.0};

        chain_set(d, 1, v, w);
        chain_kick(d, 1, last->f, last->t,
                   -0.5*dt);      /* compensates the half kick to come: the motion is prescribed */
        world_step(d);
        if (world_tally(d).broken > 0.0)
        {
            return 1.0;
        }
        chain_set(d, 1, none, none);
    }
    return 0.0;
}

static struct dem *pair(const char *more, double time_step)
{
    struct dem_new_particle seed[2];

    chain_seeds(seed, 2, 1);
    return bonded(1.0, time_step, more, 2, seed);
}

static void limit(const char *what, const char *more, struct motion m, int steps, double expected)
{
    struct dem *const d = pair(more, 0.0);
    struct world_particle last;
    const double broke = break_by_motion(d, m, steps, &last);
    const double found = m.along != 0.0 ? fabs(last.f[0])
                         : m.across != 0.0 ? fabs(last.f[1])
                         : m.twist != 0.0 ? fabs(last.t[0])
                                           : fabs(last.t[2]);
    const struct dem_totals t = world_tally(d);

    TAP_OK(broke > 0.0 && t.bonds == 0 && t.stored == 0.0, "%s: breaks", what);
    /* one increment of 1/2000 of the limit before */
    TAP_NEAR(found, expected*(1.0 - 0.5/2000.0), 1.5/2000.0*expected, "%s: at %.4g", what,
             expected);
    TAP_OK(t.lost > 0.0, "%s: %.3g J lost", what, t.lost);
    dem_free(d);
}

static void limits_of_the_table(void)
{
    const double stretch = 2e-5/2000.0, slip = 2.5e-5/2000.0,
                 twist = 7.85398163e-3/(kt*J)/2000.0,
                 bend = 7.85398163e-3/(kn*I)/2000.0;

    limit("tension", limits, (struct motion){.along = stretch}, 3000, 31.4159265);
    limit("shear", "shearStrength 5e6;", (struct motion){.across = slip}, 3000, 15.7079633);
    limit("twist", limits, (struct motion){.twist = twist}, 3000, 7.85398163e-3);
    limit("bending", limits, (struct motion){.bend = bend}, 3000, 7.85398163e-3);
    limit("tension with a strength ratio", "normalStrength 1e7; strengthRatio 0.3;",
          (struct motion){.along = 0.3*stretch}, 3000, 9.42477796);
    limit("compression with absNormal", "normalStrength 1e7; absNormal yes;",
          (struct motion){.along = -stretch}, 3000, 31.4159265);
    limit("distance", "breakDistance 1.01;", (struct motion){.along = stretch}, 3000, kn*A*2e-5);

    struct dem *const d = pair("normalStrength 1e7;", 0.0);
    struct world_particle last;

    TAP_OK(break_by_motion(d, (struct motion){.along = -stretch}, 3000, &last) == 0.0,
           "compression does not break a bond");
    dem_free(d);
}

/* Twist under a stress along the axis [Pa], tension positive. */
static void drucker_prager(double stress, double expected)
{
    struct dem *const d = pair("shearStrength 5e6; internalFriction 0.57735026918962576;", 0.0);
    struct world_particle last;
    double broke = break_by_motion(d, (struct motion){.along = stress/kn/100.0}, 100, &last);

    TAP_OK(broke == 0.0, "%g Pa alone do not break it", stress);
    const double moment = expected*J/R;

    broke = break_by_motion(d, (struct motion){.twist = moment/(kt*J)/2000.0}, 3000, &last);
    TAP_OK(broke > 0.0, "under %g Pa a twist breaks it", stress);
    TAP_NEAR(fabs(last.t[0]), moment*(1.0 - 0.5/2000.0), 1.5/2000.0*moment, "at %.5g Pa", expected);
    dem_free(d);
}

static void no_shear_left(void)
{
    struct dem *const d = pair("shearStrength 5e6; internalFriction 0.57735026918962576;", 0.0);
    struct world_particle last;
    const double broke = break_by_motion(d, (struct motion){.along = 8660254.04/kn/2000.0}, 3000, &last);

    TAP_OK(broke > 0.0, "tension alone breaks it where the shear strength is zero");
    TAP_NEAR(fabs(last.f[0])/A, 8660254.04*(1.0 - 0.5/2000.0), 1.5/2000.0*8660254.04,
             "at 8.66 MPa");
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
    limits_of_the_table();
    drucker_prager(-2e6, 6154700.54);
    drucker_prager(2e6, 3845299.46);
    no_shear_left();
    root_of_a_chain();
    relaxation();
    TAP_DONE;
}
