/*
 * batch.h -- the batches that effects work on: contacts, and particles (bodies), in columns.
 *
 * One row of a contact batch is one contact. It is always seen from the partner with the lower id
 * ("i") to the partner with the higher id or the wall ("j"): every force and moment here acts on i,
 * and the opposite acts on j. One row of a body batch is one particle. An effect reads the
 * geometry and adds to the results; it sees no particle index, no rank and no storage.
 *
 * "Filled by the caller" means step/fill_batch.c and step/body_batch.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_BATCH_H
#define DEM_LAWS_BATCH_H

#include "laws/row.h"

enum
{
    /* rows of a batch: the columns of contacts in use fit the L1 cache */
    DEM_BATCH_ROWS = 64
};

struct dem_scalar_rows;       /* laws/scalar.h */
struct dem_scalar_bodies;

struct dem_contact_batch
{
    /* rows in use, padded by the caller to whole SIMD vectors */
    int n;
    /* s      time step; 0 in the first evaluation of a run */
    double dt;
    /* s      upper bound of all time steps of this run */
    double max_dt;
    /* s      now, and at the previous evaluation; -infinity in the first */
    double time, previous_time;
    /* particle scalars of the effect, in the order of its list; set before each effect */
    const struct dem_scalar_rows *scalars;

    /* ---- geometry, filled by the caller ---- */
    /* 1      unit normal from j to i, now */
    _Alignas(64) double nx[DEM_BATCH_ROWS];
    _Alignas(64) double ny[DEM_BATCH_ROWS];
    _Alignas(64) double nz[DEM_BATCH_ROWS];
    /* 1      unit normal half a step ago: unit(r - dt v/2) */
    _Alignas(64) double hx[DEM_BATCH_ROWS];
    _Alignas(64) double hy[DEM_BATCH_ROWS];
    _Alignas(64) double hz[DEM_BATCH_ROWS];
    /* m      max(R_i + R_j - |r|, 0) */
    _Alignas(64) double overlap[DEM_BATCH_ROWS];
    /* 1      1 in contact, 0 apart */
    _Alignas(64) double touching[DEM_BATCH_ROWS];
    /* m      R_i R_j/(R_i + R_j); R_i at a wall */
    _Alignas(64) double reduced_radius[DEM_BATCH_ROWS];
    /* kg     of the inertial masses; m_i at a wall */
    _Alignas(64) double reduced_mass[DEM_BATCH_ROWS];
    /* m      the smaller of R_i and R_j; R_i at a wall */
    _Alignas(64) double min_radius[DEM_BATCH_ROWS];
    /* m/s    (v_i - v_j).n, negative on approach */
    _Alignas(64) double vn[DEM_BATCH_ROWS];
    /* m/s    slip velocity of i over j at the contact, normal to h */
    _Alignas(64) double sx[DEM_BATCH_ROWS];
    _Alignas(64) double sy[DEM_BATCH_ROWS];
    _Alignas(64) double sz[DEM_BATCH_ROWS];
    /* 1/s    relative spin w_i - w_j (with DEM_NEEDS_SPIN) */
    _Alignas(64) double wx[DEM_BATCH_ROWS];
    _Alignas(64) double wy[DEM_BATCH_ROWS];
    _Alignas(64) double wz[DEM_BATCH_ROWS];
    /* Pa s   of the fluid at the contact (with DEM_NEEDS_VISCOSITY) */
    _Alignas(64) double viscosity[DEM_BATCH_ROWS];
    /* 1/s  mean spin of both partners along n: rotates history vectors about n (with
       DEM_NEEDS_NORMAL_SPIN) */
    _Alignas(64) double normal_spin[DEM_BATCH_ROWS];

    /* ---- filled only for pair classes with an effect of stage BOND or FILM; there the lever arms of
       slip include the gap ---- */
    /* m      |r|; height over a wall */
    _Alignas(64) double distance[DEM_BATCH_ROWS];
    /* m      |r| - R_i - R_j, negative in contact; |r| - R_i at a wall */
    _Alignas(64) double gap[DEM_BATCH_ROWS];
    /* m/s    (v_i - v_j).h: rate of change of the distance, also while the pair turns */
    _Alignas(64) double distance_rate[DEM_BATCH_ROWS];
    /* 1      0 where another facet of the wall owns this contact: no new bond or film */
    _Alignas(64) double is_primary[DEM_BATCH_ROWS];
    /* 1      random number in 0 .. 1, of the two ids only (with DEM_NEEDS_RANDOM) */
    _Alignas(64) double pair_random[DEM_BATCH_ROWS];
    /* 1      > 0 where a bond replaces the contact (no surface law acts); 2: since this step */
    _Alignas(64) double bond_replaces[DEM_BATCH_ROWS];

    /* ---- adhesion, set by its laws before friction; 0 without one ---- */
    /* scratch: from `set_adhesion` of a law to its `apply` */
    _Alignas(64) double scratch[DEM_BATCH_ROWS];
    /* N      adhesive force A: the friction limit is mu max(fn + A, 0) */
    _Alignas(64) double adhesive_force[DEM_BATCH_ROWS];

    /* ---- results, cleared by the caller, filled by the effects in the order of their stages ---- */
    /* N/m    secant normal stiffness, by NORMAL */
    _Alignas(64) double kn[DEM_BATCH_ROWS];
    /* N/m    tangential stiffness, by TANGENT */
    _Alignas(64) double kt[DEM_BATCH_ROWS];
    /* kg/s   normal damping coefficient, by DAMP */
    _Alignas(64) double eta[DEM_BATCH_ROWS];
    /* N      normal force on i along n, repulsion positive */
    _Alignas(64) double fn[DEM_BATCH_ROWS];
    /* N      tangential force on i */
    _Alignas(64) double fx[DEM_BATCH_ROWS];
    _Alignas(64) double fy[DEM_BATCH_ROWS];
    _Alignas(64) double fz[DEM_BATCH_ROWS];
    /* N m    moment on i besides r x F (rolling, twisting, bending) */
    _Alignas(64) double mx[DEM_BATCH_ROWS];
    _Alignas(64) double my[DEM_BATCH_ROWS];
    _Alignas(64) double mz[DEM_BATCH_ROWS];

    /* ---- energy of stages BOND and FILM, cleared by the caller for such classes ---- */
    /* J      elastic energy of the row now */
    _Alignas(64) double stored[DEM_BATCH_ROWS];
    /* J      dissipated in this step */
    _Alignas(64) double lost[DEM_BATCH_ROWS];
    /* 1      intact bonds now */
    _Alignas(64) double bonds[DEM_BATCH_ROWS];
    /* 1      bonds that broke in this step */
    _Alignas(64) double broke[DEM_BATCH_ROWS];
    /* of breaking: 1 tension, 2 shear, 3 distance */
    _Alignas(64) double cause[DEM_BATCH_ROWS];

    /* J      dissipated in this step by the effects before, as the energy balance counts it (with
              DEM_NEEDS_DISSIPATION) */
    _Alignas(64) double dissipated[DEM_BATCH_ROWS];
};

/* energy of one effect: rows as in the contact batch */
struct dem_energy
{
    /* ---- filled by the caller ---- */
    /* m      overlap before the last drift, >= 0 */
    _Alignas(64) double previous_overlap[DEM_BATCH_ROWS];
    /* N/m    secant normal stiffness then; 0 in a new contact */
    _Alignas(64) double previous_kn[DEM_BATCH_ROWS];
    /* N      what this effect has added to fn, */
    _Alignas(64) double normal_force[DEM_BATCH_ROWS];
    /* N m    and to the moment */
    _Alignas(64) double mx[DEM_BATCH_ROWS];
    _Alignas(64) double my[DEM_BATCH_ROWS];
    _Alignas(64) double mz[DEM_BATCH_ROWS];

    /* kg m2  1/(1/I_i + 1/I_j); I_i at a wall */
    _Alignas(64) double inertia[DEM_BATCH_ROWS];
    /* kg     effective mass of a tangential force: 1/(1/m_i + 1/m_j + a_i^2/I_i + a_j^2/I_j) */
    _Alignas(64) double slip_mass[DEM_BATCH_ROWS];

    /* ---- set by the effect; preset by the caller to what `apply` has just added to stored and lost
       of the batch (BOND and FILM) ---- */
    /* J      elastic energy that the row holds now by this effect */
    _Alignas(64) double stored[DEM_BATCH_ROWS];
    /* J      dissipated in this step; < 0 where a law produces energy */
    _Alignas(64) double lost[DEM_BATCH_ROWS];
};

struct dem_body_batch
{
    /* rows in use, padded to whole SIMD vectors */
    int n;
    /* s      length of the kick that follows */
    double dt;
    /* particle scalars of the effect, in the order of its list; set before each effect */
    const struct dem_scalar_bodies *scalars;

    /* ---- the particle ---- */
    /* m       */
    _Alignas(64) double radius[DEM_BATCH_ROWS];
    /* kg      */
    _Alignas(64) double mass[DEM_BATCH_ROWS];
    /* m3      */
    _Alignas(64) double volume[DEM_BATCH_ROWS];
    /* 1      sphericity: of the surface; crosswise and lengthwise, of projected areas along the slip
              (particles/clump_form.h); 1 for spheres (with DEM_NEEDS_FORM) */
    _Alignas(64) double sphericity[DEM_BATCH_ROWS];
    _Alignas(64) double crosswise[DEM_BATCH_ROWS];
    _Alignas(64) double lengthwise[DEM_BATCH_ROWS];
    /* m/s    velocity */
    _Alignas(64) double vx[DEM_BATCH_ROWS];
    _Alignas(64) double vy[DEM_BATCH_ROWS];
    _Alignas(64) double vz[DEM_BATCH_ROWS];
    /* 1/s    spin (angular velocity) */
    _Alignas(64) double wx[DEM_BATCH_ROWS];
    _Alignas(64) double wy[DEM_BATCH_ROWS];
    _Alignas(64) double wz[DEM_BATCH_ROWS];

    /* ---- the fluid at the particle (with DEM_NEEDS_FLUID) ---- */
    /* m/s    fluid velocity, interstitial */
    _Alignas(64) double ux[DEM_BATCH_ROWS];
    _Alignas(64) double uy[DEM_BATCH_ROWS];
    _Alignas(64) double uz[DEM_BATCH_ROWS];
    /* Pa/m   full pressure gradient, hydrostatic part included */
    _Alignas(64) double gx[DEM_BATCH_ROWS];
    _Alignas(64) double gy[DEM_BATCH_ROWS];
    _Alignas(64) double gz[DEM_BATCH_ROWS];
    /* 1      of the fluid */
    _Alignas(64) double void_fraction[DEM_BATCH_ROWS];
    /* kg/m3  of the fluid */
    _Alignas(64) double density[DEM_BATCH_ROWS];
    /* Pa s   of the fluid */
    _Alignas(64) double viscosity[DEM_BATCH_ROWS];
    /* m/s2   fluid acceleration Du/Dt (with DEM_NEEDS_ACCELERATION) */
    _Alignas(64) double ax[DEM_BATCH_ROWS];
    _Alignas(64) double ay[DEM_BATCH_ROWS];
    _Alignas(64) double az[DEM_BATCH_ROWS];
    /* 1/s    vorticity, curl u (with DEM_NEEDS_VORTICITY) */
    _Alignas(64) double ox[DEM_BATCH_ROWS];
    _Alignas(64) double oy[DEM_BATCH_ROWS];
    _Alignas(64) double oz[DEM_BATCH_ROWS];
    /* N/m3   div tau of viscous and turbulent stress (with DEM_NEEDS_STRESS) */
    _Alignas(64) double sx[DEM_BATCH_ROWS];
    _Alignas(64) double sy[DEM_BATCH_ROWS];
    _Alignas(64) double sz[DEM_BATCH_ROWS];
    /* N/m    surface tension times the unit normal of the interface of two fluids, and
       m      height of the centre above it along that normal (with DEM_NEEDS_INTERFACE) */
    _Alignas(64) double tension_x[DEM_BATCH_ROWS];
    _Alignas(64) double tension_y[DEM_BATCH_ROWS];
    _Alignas(64) double tension_z[DEM_BATCH_ROWS];
    _Alignas(64) double interface_distance[DEM_BATCH_ROWS];
    /* m      Sauter mean of the surrounding particles (with DEM_NEEDS_MEAN_DIAMETER) */
    _Alignas(64) double mean_diameter[DEM_BATCH_ROWS];
    /* voidage factors of the drag law, set at the start of a coupling window */
    _Alignas(64) double voidage_factor[DEM_VOIDAGE_FACTORS][DEM_BATCH_ROWS];
    /* kg     added mass, set at the start of a coupling window */
    _Alignas(64) double added_mass[DEM_BATCH_ROWS];

    /* ---- results, cleared by the caller ---- */
    /* N      explicit force */
    _Alignas(64) double fx[DEM_BATCH_ROWS];
    _Alignas(64) double fy[DEM_BATCH_ROWS];
    _Alignas(64) double fz[DEM_BATCH_ROWS];
    /* kg/s   drag coefficient, >= 0: drag force = drag_u - drag v, integrated exactly in v */
    _Alignas(64) double drag[DEM_BATCH_ROWS];
    /* N      drag coefficient times its target velocity */
    _Alignas(64) double drag_ux[DEM_BATCH_ROWS];
    _Alignas(64) double drag_uy[DEM_BATCH_ROWS];
    _Alignas(64) double drag_uz[DEM_BATCH_ROWS];
    /* N      explicit force whose opposite acts on the fluid (effects that `react`) */
    _Alignas(64) double rx[DEM_BATCH_ROWS];
    _Alignas(64) double ry[DEM_BATCH_ROWS];
    _Alignas(64) double rz[DEM_BATCH_ROWS];
    /* N m s  rotational drag coefficient, >= 0, integrated exactly in the spin likewise */
    _Alignas(64) double spin_drag[DEM_BATCH_ROWS];
    /* N m    rotational drag coefficient times its target spin */
    _Alignas(64) double spin_drag_wx[DEM_BATCH_ROWS];
    _Alignas(64) double spin_drag_wy[DEM_BATCH_ROWS];
    _Alignas(64) double spin_drag_wz[DEM_BATCH_ROWS];
};

#endif
