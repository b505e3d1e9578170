/*
 * bonded.h -- chains of bonded spheres, loads and motions put on them step by step, for the tests of
 * bonds.
 *
 * The reference chain: R = 1 mm, L = 2 mm, lambda = 1, E = 1e9 Pa, nu = 0.25, rho = 2500 kg/m3, k_n
 * = E/L, k_t = G/L.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "physics/world.h"

enum
{
    MAX_CHAIN = 64                                             /* particles of a chain */
};

static const double R = 1e-3, L = 2e-3, kn = 5e11, kt = 2e11;
static const double A = 3.14159265358979324e-6, J = 1.57079632679489662e-12,
                    I = 7.8539816339744831e-13;

static inline void vector_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1]*b[2] - a[2]*b[1];
    out[1] = a[2]*b[0] - a[0]*b[2];
    out[2] = a[0]*b[1] - a[1]*b[0];
}

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

/* n spheres along x, the first one frozen if wanted */
static inline void chain_seeds(struct dem_new_particle *seed, int n, int clamped)
{
    memset(seed, 0, (size_t)n*sizeof *seed);
    for (int k = 0; k < n; k++)
    {
        seed[k] = (struct dem_new_particle){.position = {L*k, 0.0, 0.0},
                                            .diameter = 2.0*R,
                                            .id = k,
                                            .material = "rock",
                                            .frozen = clamped && k == 0};
    }
}

/* stiffness times `soft`; a step of 0 is the automatic one; `more` goes into bondLinear */
static inline struct dem *bonded(double soft, double step, const char *more, int n,
                                 const struct dem_new_particle *seed)
{
    const char *const own = step > 0.0 ? world_text("step %.17g;", step) : "";

    return world(world_text(
        "materials { rock { density 2500; youngsModulus 1e9; poissonsRatio 0.25; } }"
        "effects { bondLinear { normalStiffness %.17g; shearStiffness %.17g; %s } }"
        "time { maxOverlap 1; %s }",
        kn*soft, kt*soft, more, own), n, seed);
}

/* The view is const; this test casts that away to impose velocities. NULL leaves a velocity
   unchanged. */
static inline void chain_set(struct dem *d, int64_t id, const double *velocity, const double *spin)
{
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        double *const u = (double *)(uintptr_t)dem_at(v.velocity, v.stride, k);
        double *const w = (double *)(uintptr_t)dem_at(v.spin, v.stride, k);

        if (id < 0 || world_id(&v, k) == id)
        {
            memcpy(u, velocity ? velocity : u, velocity ? 3*sizeof *u : 0);
            memcpy(w, spin ? spin : w, spin ? 3*sizeof *w : 0);
        }
    }
}

static inline void chain_kick(struct dem *d, int64_t id, const double force[3],
                              const double moment[3], double dt)
{
    struct world_particle p = world_at(d, id);
    const double inertia = 0.4*p.mass*p.radius*p.radius;

    for (int k = 0; k < 3; k++)
    {
        p.v[k] += dt*force[k]/p.mass;
        p.w[k] += dt*moment[k]/inertia;
    }
    chain_set(d, id, p.v, p.w);
}

/* One step under a force and a moment on one particle: half a kick before and after the step. */
static inline void chain_load(struct dem *d, int64_t id, const double force[3],
                              const double moment[3])
{
    chain_kick(d, id, force, moment, 0.5*dem_step_limit(d).used);
    world_step(d);
    chain_kick(d, id, force, moment, 0.5*dem_step_limit(d).used);
}

static inline double chain_kinetic(const struct dem *d)
{
    struct dem_view v;
    double sum = 0.0;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        const double *const u = dem_at(v.velocity, v.stride, k), *const w =
                                                                     dem_at(v.spin, v.stride, k);
        const double m = *dem_at(v.mass, v.stride, k), a = *dem_at(v.radius, v.stride, k);

        sum += 0.5*m*vector_dot(u, u) + 0.2*m*a*a*vector_dot(w, w);
    }
    return sum;
}

/* Static equilibrium under the load (kinetic damping): all velocities are set to zero at each peak
   of the kinetic energy, until a peak is negligible. */
static inline void chain_relax(struct dem *d, int64_t id, const double force[3],
                               const double moment[3])
{
    const double rest[3] = {0.0, 0.0, 0.0};
    double before = 0.0, most = 0.0;

    for (int k = 0; k < 200000; k++)
    {
        chain_load(d, id, force, moment);
        const double now = chain_kinetic(d);

        most = fmax(most, now);
        if (now < before)
        {
            /* 1e-5 of the speeds, and of the way to go */
            if (before < 1e-10*most)
            {
                return;
            }
            chain_set(d, -1, rest, rest);
            before = 0.0;
        }
        else
        {
            before = now;
        }
    }
    TAP_OK(0, "comes to rest");
}

/* Linear momentum, angular momentum about the origin, and kinetic energy. */
static inline void chain_totals(const struct dem *d, int n, double momentum[3], double angular[3],
                                double *kinetic)
{
    struct world_particle p[MAX_CHAIN];

    memset(momentum, 0, 3*sizeof *momentum);
    memset(angular, 0, 3*sizeof *angular);
    *kinetic = 0.0;
    world_all(d, p);
    for (int i = 0; i < n; i++)
    {
        const double inertia = 0.4*p[i].mass*p[i].radius*p[i].radius;
        double arm[3];

        vector_cross(p[i].x, p[i].v, arm);
        for (int k = 0; k < 3; k++)
        {
            momentum[k] += p[i].mass*p[i].v[k];
            angular[k] += p[i].mass*arm[k] + inertia*p[i].w[k];
        }
        *kinetic += 0.5*p[i].mass*vector_dot(p[i].v, p[i].v) +
                    0.5*inertia*vector_dot(p[i].w, p[i].w);
    }
}

/* From 0 to 1 while k goes from 0 to n, with rates and accelerations of 0 at both ends: overshoots
   by 60/(w T)^3. */
static inline double chain_ramp(int k, int n)
{
    const double s = k < n ? (double)k/n : 1.0;

    return s*s*s*(10.0 - 15.0*s + 6.0*s*s);
}
