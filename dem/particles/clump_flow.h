/*
 * clump_flow.h -- rigid bodies of several spheres in a fluid: shares of its forces, the kick with drag,
 * impulses on the fluid.
 *
 * The laws of the fluid act on the volume-equivalent sphere of the body in the fluid at each sphere of
 * it, and the sphere takes its share w_k of the force (clump_shape.h). So in a fluid that is the same
 * at all spheres the body has the force of the law, and spheres that see another slip than the body,
 * because it turns or the flow is sheared, turn it.
 *
 *   D   = sum d_k,  d_k = b_k (u_k - v_k),  B = sum b_k,  z = B h/M
 *   v'  = v + phi(z) h/M (F + D)            phi(z) = (1 - exp(-z))/z
 *   J_k = h (phi d_k - (1 - phi) b_k/B F)   sum J_k = M (v' - v) - h F
 *   L'  = L + h phi(z_r) (T + sum R r_k x (f_k + d_k) + sum t_k (o_k - w))
 *   z_r = h (sum b_k r_k^2 + sum t_k)/I_min
 *
 *   b_k, u_k   w_k times the drag coefficient of the law, fluid velocity               [kg/s], [m/s]
 *   v_k        velocity of sphere k                                                    [m/s]
 *   F, f_k     all forces but drag; the same on sphere k, without contacts             [N]
 *   T          moment of the contacts about the centre                                 [N m]
 *   t_k, o_k   w_k times the rotational drag coefficient, its target      [kg m2/s], [1/s]
 *   J_k        impulse of drag on sphere k, whose opposite acts on the fluid           [N s]
 *
 * step/clump_batch.c fills the rows.
 *
 * As for spheres (step/sweep_bodies.c) the kick is bounded for any h, and exact if only the body moves.
 * The fluid receives the exact opposite of the linear momentum; angular momentum is exchanged to O(z_r).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/clump.h"
#include "particles/clump_form.h"

/* what the fluid does to a sphere of a body in this kick, by its share; in fours, for vector registers */
struct dem_clump_flow_row
{
    _Alignas(64) double force[3];         /* N  f_k */
    double drag;                          /* kg/s  b_k */
    double slip_force[3], particle_drag;  /* N, kg/s  d_k; b_k without the slip factor */
};
struct dem_clump_flow_rest                /* 0 where no law has it */
{
    _Alignas(64) double reaction[3];      /* N  part of f_k whose opposite acts on the fluid */
    double spin_drag;                     /* kg m2/s  t_k */
    double spin_torque[3], spare;         /* N m */
};

struct dem_clump_part                 /* a sphere of a body: what stays the same */
{
    const struct dem_clump_form *form;    /* NULL: a single sphere */
    int which;                        /* number of the form; -1: a single sphere */
    double share, mass;               /* 1, kg  w_k; M */
    double surface;                   /* 1  w_k times the surface of the body over the surface of the sphere of its
                                            volume, A/(pi d^2) */
    const double *q;                  /* R of the body */
};

struct dem_clump_flow
{
    const struct dem_clump_shapes *shapes;
    struct dem_clump_form *form;      /* of each shape */
    struct dem_clump_flow_row *row;   /* of each particle, valid for bodies in a kick */
    struct dem_clump_flow_rest *rest; /* likewise */
    struct dem_clump_part *part;      /* of each particle */
    size_t capacity, rest_capacity, part_capacity;
    double *own, *before;             /* for the energy balance, step/clump_energy.c */
    struct dem_clump_flow_sums *sums; /* likewise: in the last kick, of bodies by their place; NULL: not kept */
    size_t own_capacity, before_capacity, sums_capacity;
};

struct dem_clump_flow_sums            /* over the spheres of a body */
{
    double force[3], torque[3];       /* N, N m  F; T and all moments */
    double slip_force[3];             /* N  D */
    double drag;                      /* kg/s  B */
    double phi, phi_spin;             /* 1  phi(z), phi(z_r) */
};

/* `areas` 1: a law takes projected areas. To be freed also after a failure. */
int dem_clump_flow_begin(struct dem_clump_flow *, const struct dem_clump_shapes *, int areas);
void dem_clump_flow_free(struct dem_clump_flow *);

/* After dem_clumps_index: rows of the particles, and what stays the same. */
int dem_clump_flow_index(struct dem_clump_flow *, const struct dem_clumps *, const struct dem_particles *);

/* dem_clumps_kick in a fluid: the bodies by their rows, and the columns of impulses on the fluid. */
void dem_clump_flow_kick(struct dem_clump_flow *, struct dem_clumps *, struct dem_particles *, double h);

/* J_k of a sphere. */
void dem_clump_flow_drag(const struct dem_clump_flow_row *, const struct dem_clump_flow_sums *, double h,
                         double J[3]);

/* At the end of a window: the spheres of each body have its decay factor; divide 1 - decay among them in
   proportion to the `integral` of each sphere's coefficient over the window, so that the response of the body
   (step/body_window.c) is the sum over them.
   `per_mass`: times the mass of the body over the sphere's, where the response is per mass of the sphere. */
void dem_clump_share_decay(const struct dem_clumps *, const struct dem_particles *, const double *integral,
                           double *decay, int per_mass);
void dem_clump_flow_end_window(const struct dem_clumps *, struct dem_particles *);
