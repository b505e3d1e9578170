/*
 * test_conservation.c -- a thousand colliding spheres keep momentum and angular momentum, also through
 * periodic faces, and gain no energy.
 *
 * Bounds: round-off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "physics/world.h"

#include "core/random.h"

enum
{
    SIDE = 10, N = SIDE*SIDE*SIDE
};

static const double R = 1e-3, E = 1e7, nu = 0.3, speed = 0.5;

static const char material[] =
    "materials { glass { density 2500; youngsModulus 1e7; poissonsRatio 0.3; } }";

/* A cubic lattice of this pitch, with random velocities and spins, and a velocity towards the
   centre in proportion to the distance [1/s]. */
static void random_lattice(struct dem_new_particle *seed, double pitch, double inward)
{
    for (int k = 0; k < N; k++)
    {
        const int at[3] = {k%SIDE, k/SIDE%SIDE, k/(SIDE*SIDE)};

        seed[k] = (struct dem_new_particle){.diameter = 2.0*R, .id = k, .material = "glass"};
        for (int a = 0; a < 3; a++)
        {
            seed[k].position[a] = pitch*(at[a] + 0.5);
            seed[k].velocity[a] = speed*(2.0*dem_random_unit(7, (uint64_t)k, 0, (uint64_t)a) - 1.0)
                                - inward*(seed[k].position[a] - 0.5*pitch*SIDE);
            seed[k].spin[a] = speed/R*(2.0*dem_random_unit(7, (uint64_t)k, 1, (uint64_t)a) - 1.0);
        }
    }
}

static struct dem *start(const char *effects, const char *domain, double pitch, double inward)
{
    static struct dem_new_particle seed[N];
    char *const scene = world_text("%s effects { hertz {} %s } %s", material, effects, domain);

    random_lattice(seed, pitch, inward);
    return world(scene, N, seed);
}

/* kg m/s, kg m2/s, their scales (sums of magnitudes), J: kinetic and of all Hertzian contacts */
struct totals
{
    double p[3], L[3], p_scale, L_scale, energy, kinetic;
};

static double elastic_energy(const struct world_particle *q)
{
    const double k = 4.0/3.0*0.5*E/(1.0 - nu*nu)*sqrt(0.5*R);
    double sum = 0.0;

    for (int a = 0; a < N; a++)
    {
        for (int b = a + 1; b < N; b++)
        {
            const double dx = q[a].x[0] - q[b].x[0], dy = q[a].x[1] - q[b].x[1],
                         dz = q[a].x[2] - q[b].x[2];
            const double square = dx*dx + dy*dy + dz*dz,
                         overlap = square < 4.0*R*R ? 2.0*R - sqrt(square) : 0.0;

            sum += 0.4*k*overlap*overlap*sqrt(overlap);
        }
    }
    return sum;
}

static struct totals totals_of(const struct dem *d)
{
    static struct world_particle q[N];
    struct totals s = {.energy = 0.0};

    world_all(d, q);
    for (int k = 0; k < N; k++)
    {
        const double m = q[k].mass, inertia = 0.4*m*R*R;

        for (int a = 0; a < 3; a++)
        {
            const int b = (a + 1)%3, c = (a + 2)%3;
            const double lever = m*(q[k].x[b]*q[k].v[c] - q[k].x[c]*q[k].v[b]) + inertia*q[k].w[a];

            s.p[a] += m*q[k].v[a];
            s.L[a] += lever;
            s.p_scale += fabs(m*q[k].v[a]);
            s.L_scale += fabs(lever);
            s.kinetic += 0.5*m*q[k].v[a]*q[k].v[a] + 0.5*inertia*q[k].w[a]*q[k].w[a];
        }
    }
    s.energy = s.kinetic + elastic_energy(q);
    return s;
}

static double largest(const double a[3], const double b[3])
{
    return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

/* Spheres fill a fifth of the periodic box: many contacts at any time. */
static void periodic_momentum(void)
{
    static const char box[] =
        "domain { min (0 0 0); max (0.0275 0.0275 0.0275); periodic (x y z); }";
    struct dem *const d =
        start("mindlin { friction 0.3; } dry { restitution 0.8; }", box, 0.00275, 0.0);
    const struct totals before = totals_of(d);

    world_run(d, 0.01);
    const struct totals after = totals_of(d);
    const struct dem_totals t = world_tally(d);

    TAP_OK(t.contacts > 50 && t.rebuilds > 3, "periodic: %lld contacts, %lld rebuilds",
           (long long)t.contacts, (long long)t.rebuilds);
    TAP_OK(after.kinetic < 0.9*before.kinetic,
           "periodic: they collide, %.0f %% of the energy is left",
           100*after.kinetic/before.kinetic);
    /* 1000 spheres, some 1000 kicks of round-off 1e-16 each of a share of the sum: a random walk */
    TAP_NEAR(largest(after.p, before.p), 0.0, 1e-13*before.p_scale, "periodic: momentum is kept");
    /* the exact sum of the totals against this test's sum */
    TAP_NEAR(largest(t.momentum, after.p), 0.0, 1e-14*before.p_scale,
             "periodic: the reported totals have the same momentum");
    dem_free(d);
}

/* The same in open space, with velocities towards the centre. */
static void angular_momentum(void)
{
    struct dem *const d =
        start("mindlin { friction 0.3; } dry { restitution 0.8; }", "", 0.00205, 100.0);
    const struct totals before = totals_of(d);
    int64_t most = 0;
    double energy = before.energy;
    int grew = 0;

    for (int k = 0; k < 40; k++)
    {
        world_run(d, 2e-4);
        const struct totals now = totals_of(d);
        const int64_t contacts = world_tally(d).contacts;

        most = contacts > most ? contacts : most;
        /* friction springs store energy that this sum leaves out, and return it: up to 0.1 % */
        grew += now.energy > energy*(1.0 + 1e-3);
        energy = now.energy;
    }
    const struct totals after = totals_of(d);

    TAP_OK(most > 300, "open: %lld contacts at once", (long long)most);
    TAP_NEAR(largest(after.p, before.p), 0.0, 1e-13*before.p_scale, "open: momentum is kept");
    TAP_NEAR(largest(after.L, before.L), 0.0, 1e-12*before.L_scale,
             "open: angular momentum is kept");
    TAP_OK(grew == 0 && after.energy < 0.8*before.energy, "open: energy only decreases, to %.0f %%",
           100.0*after.energy/before.energy);
    dem_free(d);
}

int main(void)
{
    TAP_TRAPS;
    periodic_momentum();
    angular_momentum();
    TAP_DONE;
}
