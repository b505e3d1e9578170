/*
 * relevance.h -- numbers of a scene by which each effect tells whether the scene needs it.
 *
 * `dem plan` computes struct dem_regime (advisor/regime.c) and asks each effect for a struct
 * dem_relevance (advisor/verdicts.c). An effect is needed if it changes the quantity it acts on by
 * more than a threshold, 1 % unless noted otherwise; formula and source are in its file.
 *
 * Spheres of the Sauter diameter, and the first pair of materials, represent all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_RELEVANCE_H
#define DEM_LAWS_RELEVANCE_H

/* What an effect models. `dem plan` judges in this order; those before REPULSION are judged in a
   fluid only, those after it only where materials have a modulus. */
enum dem_mechanism
{
    DEM_MECHANISM_PRESSURE,
    DEM_MECHANISM_INERTIA,
    DEM_MECHANISM_STRESS,
    DEM_MECHANISM_LIFT,
    DEM_MECHANISM_TORQUE,
    DEM_MECHANISM_FILM,
    DEM_MECHANISM_REPULSION,
    DEM_MECHANISM_ADHESION,
    DEM_MECHANISM_YIELDING,
    DEM_MECHANISM_ROLLING,
    DEM_MECHANISM_TWISTING,
    DEM_MECHANISMS
};

struct dem_suspension    /* equal spheres in a uniform fluid */
{
    double diameter, density;         /* m, kg/m3 */
    double fluid_density, viscosity;  /* kg/m3, Pa s */
    double gravity;                   /* m/s2 */
    int feels_gradient;               /* 1: the pressure gradient acts on particles */
};

struct dem_regime                                         /* 0: unknown, unless noted otherwise */
{
    int fluid;                                            /* 1: the scene has a fluid */
    int uniform;                                          /* 1: from the entry `fluid`, not coupled */
    /* of equal spheres of the Sauter diameter */
    struct dem_suspension suspension;
    double particles;                                     /* 1    number */
    /* 1  volume of particles over volume of the domain */
    double solid_fraction;
    double flow;                                          /* m/s  fluid velocity */
    /* m/s, 1, 1: slip, its Reynolds number, drag over Stokes drag */
    double slip, reynolds, drag_factor;
    double response;                                      /* s    relaxation time at that slip */
    double vorticity, stress;                             /* 1/s, N/m3 */
    double width;                                         /* m    smallest width of the domain */
    double cell;                                          /* m    smallest cell of a mesh */
    double mass, radius, modulus;                         /* kg, m, Pa: m*, R*, E* */
    /* 1  p of the normal law in use, F ~ d^p; 0 without one */
    double exponent;
    /* m/s, 1: impactSpeed of the normal law, and its Stokes number */
    double speed, stokes;
    /* m/s, s: relative speed of collisions, and time between them */
    double collision_speed, collision_time;
    /* 1  largest overlap of an elastic impact at `speed`, over R* */
    double overlap;
    /* 1  coefficient of friction; 0 without a law */
    double friction;
    /* 1  of the damping law in use: 1 without one, 0 if it has no such setting */
    double restitution;
    int has_restitution;                                  /* 1: it has that setting */
    int adhesive;                                         /* 1: an effect in use holds particles together */
    double weight;                                        /* N    of one sphere */
    /* m/s  slowest impact that yields, if materials have a yieldStrength */
    double yield_speed;
};

struct dem_relevance
{
    double fraction;              /* 1  fraction of the quantity that is due to the effect */
    double threshold;             /* 1  above it the effect is needed; preset to 0.01 */
    const char *quantity;         /* continues "12 % ...": the quantity, and the source in brackets */
    const char *missing_setting;  /* what the user must give if the effect is not in use; preset to
                                     NULL: nothing */
};

#endif
