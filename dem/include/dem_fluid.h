/*
 * dem_fluid.h -- what a program needs that solves a fluid around the particles: columns of fluid
 * values at the particles, their forces on the fluid, the exchange of scalars such as heat, patches
 * through which particles enter and leave.
 *
 *     dem_case_add_patch, dem_case_flows_on_request, dem_case_fluid_... on the case; dem_start
 *     each fluid step:  dem_flow_apply; fill the columns of dem_fluid; dem_advance;
 *                       dem_fluid_reaction -> solve the fluid -> dem_fluid_correct
 *
 * dem.h has the rules for return values, ownership and collective calls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_FLUID_H
#define DEM_FLUID_H

#include "dem_query.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- case ------------------------------------------------------------------------------------ */

/* The fluid's continuity contains the void fraction, so that particles displace it; it has this
   density [kg/m3]. Where the scene has pressureGradient and a material of less than 10 times the
   density, the columns under_relaxation and owed_pressure_impulse exist: without under-relaxation
   dense suspensions of light particles oscillate from step to step. */
void dem_case_fluid_displaced(struct dem_case *, double density);

/* Without a snapshot the run begins at this time [s] of the fluid solver, not at 0. Before dem_start. */
void dem_case_start_time(struct dem_case *, double time);

/* The coupled fluid has this density [kg/m3] everywhere. The effect stokesDamping then counts added mass
   in its Stokes number. */
void dem_case_fluid_density(struct dem_case *, double density);

/* Effects see another fluid velocity and void fraction than the exchange, without the particle's own
   wake for example: the column own_wake exists. */
void dem_case_fluid_own_wake(struct dem_case *);

/* Before dem_case_check. The program exchanges this scalar of the scene's effects:
   dem_scalar_exchange gives columns also where no fluid effect of the scene exchanges it. */
int dem_case_exchange_scalar(struct dem_case *, const char *name);

/* Before dem_case_check, for a program that must know all particles before it advances them:
   streams and outlets act in dem_flow_apply only, and the scene may name patches of a mesh. */
int dem_case_flows_on_request(struct dem_case *);

/* Collective, after dem_start. Contacts may stay on the device of the run (dem_query.h) between two advances: it makes
   the last step of an advance, too, and only particles are copied to the host. The sums of dem_wall_impulse begin.
   Without a device, or where the host has to make that step, nothing changes. */
int dem_device_keep_contacts(struct dem *);

/* Collective, before dem_case_check, for each patch of the scene's `insert`. A patch through which
   particles enter: n triangles of this rank, 9 numbers each [m], corners counterclockwise as seen
   from outside the mesh, and the velocity of the fluid on each, 3 numbers [m/s], or NULL. */
int dem_case_add_patch(struct dem_case *, const char *name, int64_t n, const double *triangles,
                       const double *velocity);

/* ---- fluid columns --------------------------------------------------------------------------- */

/* columns of owned particles, contiguous: dem_fluid. The program writes the "in" ones before
   dem_advance and reads the "out" ones after it. Values stay with their particle when it changes
   its rank. Pointers are valid until the next collective call; all are NULL without fluid
   effects. */
struct dem_fluid
{
    size_t n;                            /* particles */
    double *velocity;                    /* in   m/s   3 each */
    double *pressure_gradient;           /* in   Pa/m  3 each, full, hydrostatic part included */
    double *void_fraction;               /* in   1 */
    double *density;                     /* in   kg/m3 */
    double *viscosity;                   /* in   Pa s */
    double *acceleration;                /* in   m/s2  3 each, Du/Dt; NULL, like the next six,
                                            unless an effect needs it */
    double *vorticity;                   /* in   1/s   3 each, curl u */
    double *stress;                      /* in   N/m3  3 each, div tau, viscous and turbulent */
    double *tension;                     /* in   N/m   3 each, surface tension times the unit normal of
                                            the interface of two fluids; 0: none */
    double *interface_distance;          /* in   m     height of the centre above it, along the normal */
    double *mean_diameter;               /* in   m     Sauter mean of the particles around */
    double *turbulence;                  /* in   m2/s2, m2/s3  2 each, k and epsilon */
    double *slip_factor;                 /* in   1     change of the slip by a particle's motion,
                                            relative to a fluid of given velocity; 1 unless set,
                                            1/e^2 where continuity makes the fluid displace
                                            (laws/fluid/particle_exchange.h) */
    double *location;                    /* in/out  2 each, for the program: its location in the
                                            mesh; -1 for a new particle */
    const double *drag_impulse;          /* out  N s   3 each, J: drag on the particle during the
                                            last advance */
    const double *other_impulse;         /* out  N s   3 each, of lift and added mass, less what
                                            `carried_over_impulse` will take back; NULL without
                                            them. The fluid gets the opposite of this and of J */
    const double *angular_impulse;       /* out  N m s 3 each, of rotational drag; NULL without.
                                            Not given to the fluid */
    const double *drag_integral;         /* out  kg    integral of the drag coefficient b, without
                                            slip_factor, over the last advance: sum of b h */
    const double *response;              /* out  kg    R: d(drag impulse)/d(fluid velocity),
                                            bounded for held particles */
    const double *displacement;          /* out  m     3 each, in the last advance */
    const double *transmitted_fraction;  /* out  1     fraction of a steady force that drag passed
                                            on to the fluid */
    const double *carried_over_impulse;  /* out  N s   3 each, impulse of dem_fluid_correct for the
                                            next advance */
    double *under_relaxation;            /* out  1     factor for pressure_gradient and acceleration,
                                            set by dem_fluid_under_relax; 0 for a new particle;
                                            NULL, like the next one, without light particles
                                            (dem_case_fluid_displaced) */
    double *owed_pressure_impulse;       /* in/out  N s  3 each, for the program: impulse of the
                                            pressure gradient, without its hydrostatic part, that
                                            the particle has not received yet */
    double *own_wake;                    /* in/out  11 each: part of `velocity` that effects do not
                                            see but the exchange does [m/s]; 6 numbers for the
                                            program; r - 1 [1], r the slip that effects see over
                                            the slip of the exchange: drag is multiplied by r,
                                            unless it is whole; part of `void_fraction`
                                            above the cells' [1]. NULL without
                                            dem_case_fluid_own_wake; 0 for a new particle */
};

/* 1 when an effect of the scene needs a fluid. */
int dem_needs_fluid(const struct dem *);

/* DEM_ERROR_INPUT when an effect needs a fluid, and neither the scene nor dem_fluid gives one. */
int dem_require_fluid(const struct dem *);

/* The columns. From the first call on the run counts as coupled; an error when the scene has its
   own `fluid`. */
int dem_fluid(struct dem *, struct dem_fluid *);

/* yes: drag is the law's b over the void fraction, the whole force of a steady uniform flow, which
   contains the force of its pressure gradient (set III of Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661
   (2010) 482, "simplified model B"); the pressure gradient column must then be the hydrostatic one.
   no: the law's own b. Holds until the next call; not saved in snapshots. */
void dem_fluid_whole_drag(struct dem *, int yes);

/* After an advance, where the column exists: set under_relaxation for the next one
   (laws/fluid/particle_exchange.h). Returns the smallest factor of this rank, 1 without. */
double dem_fluid_under_relax(struct dem *);

/* A value for the column slip_factor where continuity makes the fluid displace and particles get
   the correction for its new velocity: 1/e^2, or 1/e with whole drag; e limited to 0.1 and above
   (laws/fluid/particle_exchange.h). */
double dem_fluid_slip_factor(const struct dem *, double void_fraction);

/* A value for the column mean_diameter [m], the Sauter mean: from sum V [m3] and sum V/d [m2] of
   the particles around; 0 where there are none. */
double dem_sauter_diameter(double volume, double per_diameter);

/* The force of each particle on the fluid after an advance by `window` [s]: F - K u, with u the
   fluid's new velocity at the particle. `coefficient` gets K [kg/s], 1 each, `force` gets F [N],
   3 each. */
int dem_fluid_reaction(const struct dem *, double window, double *coefficient, double *force);

/* After an advance: sets K of dem_fluid_reaction, 1 each, to 0 for particles that do not follow the fluid:
   frozen ones and those with at least 10 times its density. */
void dem_fluid_following(const struct dem *, double *coefficient);

/* The force on each particle [N], 3 each, of effects at the interface of two fluids, for the columns tension and
   interface_distance as they are now. The interface gets the opposite; dem_fluid_reaction does not contain it. */
void dem_fluid_interface_force(const struct dem *, double *force);

/* The largest rate at which drag takes up the slip of a particle of this rank [1/s]: b/(m + a),
   with b the mean drag coefficient over the last advance in a fluid of given velocity and a the
   added mass; 0 for frozen particles. */
double dem_fluid_relaxation(const struct dem *);

/* After the fluid is solved, with its new velocity u' and full pressure gradient grad p' at the
   particles (3 each, in the order of the columns): leave the impulse R (u' - u) + q V T (grad p'
   - grad p) for the next advance, with R `response`, q `transmitted_fraction`, V the particle's
   volume, T the window. The fluid must get its opposite. */
int dem_fluid_correct(struct dem *, const double *velocity, const double *pressure_gradient);

/* ---- exchange of a particle scalar ----------------------------------------------------------- */

/* exchange of a scalar s with a fluid or the program over an advance: C ds/dt = q + B (s* - s),
   with the capacity C and B the sum of the coefficients of effects and of the program. Columns of
   owned particles, contiguous; in: the program writes them before dem_advance, they stay until it
   does so again; out: it reads them after. docs/adding-an-effect.md */
struct dem_scalar_exchange
{
    size_t n;                    /* particles */
    double *source;              /* in   unit C/s  part of q */
    double *coefficient;         /* in   C/s       part of B */
    double *target;              /* in   unit      its s* */
    const double *received;      /* out  unit C    J: what B has given; the partner gets its opposite */
    const double *coefficient_time;  /* out  C     sum of B h over the steps */
    const double *response;      /* out  C         R = dJ/ds*, bounded for particles whose s is held */
    const double *carried_over;  /* out  unit C    of dem_scalar_correct, for the next advance */
};

/* The columns of the exchange of scalar k. DEM_ERROR_STATE when it is not exchanged. */
int dem_scalar_exchange(struct dem *, int k, struct dem_scalar_exchange *);

/* After the partner of the exchange is solved, with its new value s*' at the particles: leave
   R (s*' - s*) for the next advance, s* the mean target of the last one. The partner must get its
   opposite. */
int dem_scalar_correct(struct dem *, int k, const double *target);

/* ---- streams and outlets --------------------------------------------------------------------- */

/* Collective. A patch of dem_case_add_patch whose triangles or velocities have changed. */
int dem_flow_patch(struct dem *, const char *name, int64_t n, const double *triangles,
                   const double *velocity);

/* Particles of this rank that have crossed the patch of an outlet: they are removed in the next
   dem_flow_apply. */
int dem_flow_remove(struct dem *, const char *patch, int64_t n, const int64_t *id);

/* Collective, between two advances. Remove the particles of dem_flow_remove and those inside an
   outlet of the scene, and insert those that are due. *changed: 1 when any rank has lost or
   gained a particle. Then views and fluid columns must be fetched again; `location` of new
   particles is -1. */
int dem_flow_apply(struct dem *, int *changed);

#ifdef __cplusplus
}
#endif
#endif
