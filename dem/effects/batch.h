/*
 * batch.h -- the batches that effects work on: contacts, and particles (bodies), in columns.
 *
 * One row of a contact batch is one contact. It is always seen from the partner with the lower id
 * ("i") to the partner with the higher id or the wall ("j"): every force and moment here acts on i,
 * and the opposite acts on j. One row of a body batch is one particle. An effect reads the
 * geometry and adds to the results; it sees no particle index, no rank and no storage.
 *
 * "Filled by the caller" means step/contact_batch.c and step/body_batch.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_BATCH_H
#define DEM_EFFECTS_BATCH_H

enum
{
    /* rows of a batch: the columns of contacts in use fit the L1 cache */
    DEM_BATCH_ROWS = 64,
    /* columns in which a drag law keeps its voidage factors */
    DEM_VOIDAGE_FACTORS = 2
};

#ifndef DEM_REAL
#define DEM_REAL double    /* a kernel file may be built in another precision */
#endif
typedef DEM_REAL dem_real;

struct dem_contact_batch
{
    /* rows in use, padded by the caller to whole SIMD vectors */
    int n;
    /* s      time step; 0 in the first evaluation of a run */
    dem_real dt;
    /* s      upper bound of all time steps of this run */
    dem_real max_dt;
    /* s      now, and at the previous evaluation; -infinity in the first */
    dem_real time, previous_time;

    /* ---- geometry, filled by the caller ---- */
    /* 1      unit normal from j to i, now */
    _Alignas(64) dem_real nx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real ny[DEM_BATCH_ROWS];
    _Alignas(64) dem_real nz[DEM_BATCH_ROWS];
    /* 1      unit normal half a step ago: unit(r - dt v/2) */
    _Alignas(64) dem_real hx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real hy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real hz[DEM_BATCH_ROWS];
    /* m      max(R_i + R_j - |r|, 0) */
    _Alignas(64) dem_real overlap[DEM_BATCH_ROWS];
    /* 1      1 in contact, 0 apart */
    _Alignas(64) dem_real touching[DEM_BATCH_ROWS];
    /* m      R_i R_j/(R_i + R_j); R_i at a wall */
    _Alignas(64) dem_real reduced_radius[DEM_BATCH_ROWS];
    /* kg     of the inertial masses; m_i at a wall */
    _Alignas(64) dem_real reduced_mass[DEM_BATCH_ROWS];
    /* m      the smaller of R_i and R_j; R_i at a wall */
    _Alignas(64) dem_real min_radius[DEM_BATCH_ROWS];
    /* m/s    (v_i - v_j).n, negative on approach */
    _Alignas(64) dem_real vn[DEM_BATCH_ROWS];
    /* m/s    slip velocity of i over j at the contact, normal to h */
    _Alignas(64) dem_real sx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real sy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real sz[DEM_BATCH_ROWS];
    /* 1/s    relative spin w_i - w_j (with DEM_NEEDS_SPIN) */
    _Alignas(64) dem_real wx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real wy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real wz[DEM_BATCH_ROWS];
    /* Pa s   of the fluid at the contact (with DEM_NEEDS_VISCOSITY) */
    _Alignas(64) dem_real viscosity[DEM_BATCH_ROWS];
    /* 1/s  mean spin of both partners along n: rotates history vectors about n (with
       DEM_NEEDS_NORMAL_SPIN) */
    _Alignas(64) dem_real normal_spin[DEM_BATCH_ROWS];

    /* ---- filled only for pair classes with an effect of stage BOND or FILM; there the lever arms of
       slip include the gap ---- */
    /* m      |r|; height over a wall */
    _Alignas(64) dem_real distance[DEM_BATCH_ROWS];
    /* m      |r| - R_i - R_j, negative in contact; |r| - R_i at a wall */
    _Alignas(64) dem_real gap[DEM_BATCH_ROWS];
    /* m/s    (v_i - v_j).h: rate of change of the distance, also while the pair turns */
    _Alignas(64) dem_real distance_rate[DEM_BATCH_ROWS];
    /* 1      0 where another facet of the wall owns this contact: no new bond or film */
    _Alignas(64) dem_real is_primary[DEM_BATCH_ROWS];
    /* 1      random number in 0 .. 1, of the two ids only (with DEM_NEEDS_RANDOM) */
    _Alignas(64) dem_real pair_random[DEM_BATCH_ROWS];
    /* 1      > 0 where a bond replaces the contact (no surface law acts); 2: since this step */
    _Alignas(64) dem_real bond_replaces[DEM_BATCH_ROWS];

    /* ---- adhesion, set by its laws before friction; 0 without one ---- */
    /* scratch: from `set_adhesion` of a law to its `apply` */
    _Alignas(64) dem_real scratch[DEM_BATCH_ROWS];
    /* N      adhesive force A: the friction limit is mu max(fn + A, 0) */
    _Alignas(64) dem_real adhesive_force[DEM_BATCH_ROWS];

    /* ---- results, cleared by the caller, filled by the effects in the order of their stages ---- */
    /* N/m    secant normal stiffness, by NORMAL */
    _Alignas(64) dem_real kn[DEM_BATCH_ROWS];
    /* N/m    tangential stiffness, by TANGENT */
    _Alignas(64) dem_real kt[DEM_BATCH_ROWS];
    /* kg/s   normal damping coefficient, by DAMP */
    _Alignas(64) dem_real eta[DEM_BATCH_ROWS];
    /* N      normal force on i along n, repulsion positive */
    _Alignas(64) dem_real fn[DEM_BATCH_ROWS];
    /* N      tangential force on i */
    _Alignas(64) dem_real fx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real fy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real fz[DEM_BATCH_ROWS];
    /* N m    moment on i besides r x F (rolling, twisting, bending) */
    _Alignas(64) dem_real mx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real my[DEM_BATCH_ROWS];
    _Alignas(64) dem_real mz[DEM_BATCH_ROWS];

    /* scratch between the loops of one law */
    _Alignas(64) dem_real loop_scratch[6][DEM_BATCH_ROWS];

    /* ---- energy of stages BOND and FILM, cleared by the caller for such classes ---- */
    /* J      elastic energy of the row now */
    _Alignas(64) dem_real stored[DEM_BATCH_ROWS];
    /* J      dissipated in this step */
    _Alignas(64) dem_real lost[DEM_BATCH_ROWS];
    /* 1      intact bonds now */
    _Alignas(64) dem_real bonds[DEM_BATCH_ROWS];
    /* 1      bonds that broke in this step */
    _Alignas(64) dem_real broke[DEM_BATCH_ROWS];
    /* of breaking: 1 tension, 2 shear, 3 distance */
    _Alignas(64) dem_real cause[DEM_BATCH_ROWS];
};

/* energy of one effect: rows as in the contact batch */
struct dem_energy
{
    /* ---- filled by the caller ---- */
    /* m      overlap before the last drift, >= 0 */
    _Alignas(64) dem_real previous_overlap[DEM_BATCH_ROWS];
    /* N/m    secant normal stiffness then; 0 in a new contact */
    _Alignas(64) dem_real previous_kn[DEM_BATCH_ROWS];
    /* N      what this effect has added to fn, */
    _Alignas(64) dem_real normal_force[DEM_BATCH_ROWS];
    /* N m    and to the moment */
    _Alignas(64) dem_real mx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real my[DEM_BATCH_ROWS];
    _Alignas(64) dem_real mz[DEM_BATCH_ROWS];

    /* kg m2  1/(1/I_i + 1/I_j); I_i at a wall */
    _Alignas(64) dem_real inertia[DEM_BATCH_ROWS];
    /* kg     effective mass of a tangential force: 1/(1/m_i + 1/m_j + a_i^2/I_i + a_j^2/I_j) */
    _Alignas(64) dem_real slip_mass[DEM_BATCH_ROWS];

    /* ---- set by the effect; preset by the caller to what `apply` has just added to stored and lost
       of the batch (BOND and FILM) ---- */
    /* J      elastic energy that the row holds now by this effect */
    _Alignas(64) dem_real stored[DEM_BATCH_ROWS];
    /* J      dissipated in this step; < 0 where a law produces energy */
    _Alignas(64) dem_real lost[DEM_BATCH_ROWS];
};

struct dem_body_batch
{
    /* rows in use, padded to whole SIMD vectors */
    int n;
    /* s      length of the kick that follows */
    dem_real dt;

    /* ---- the particle ---- */
    /* m       */
    _Alignas(64) dem_real radius[DEM_BATCH_ROWS];
    /* kg      */
    _Alignas(64) dem_real mass[DEM_BATCH_ROWS];
    /* m3      */
    _Alignas(64) dem_real volume[DEM_BATCH_ROWS];
    /* m/s    velocity */
    _Alignas(64) dem_real vx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real vy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real vz[DEM_BATCH_ROWS];
    /* 1/s    spin (angular velocity) */
    _Alignas(64) dem_real wx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real wy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real wz[DEM_BATCH_ROWS];

    /* ---- the fluid at the particle (with DEM_NEEDS_FLUID) ---- */
    /* m/s    fluid velocity, interstitial */
    _Alignas(64) dem_real ux[DEM_BATCH_ROWS];
    _Alignas(64) dem_real uy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real uz[DEM_BATCH_ROWS];
    /* Pa/m   full pressure gradient, hydrostatic part included */
    _Alignas(64) dem_real gx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real gy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real gz[DEM_BATCH_ROWS];
    /* 1      of the fluid */
    _Alignas(64) dem_real void_fraction[DEM_BATCH_ROWS];
    /* kg/m3  of the fluid */
    _Alignas(64) dem_real density[DEM_BATCH_ROWS];
    /* Pa s   of the fluid */
    _Alignas(64) dem_real viscosity[DEM_BATCH_ROWS];
    /* m/s2   fluid acceleration Du/Dt (with DEM_NEEDS_ACCELERATION) */
    _Alignas(64) dem_real ax[DEM_BATCH_ROWS];
    _Alignas(64) dem_real ay[DEM_BATCH_ROWS];
    _Alignas(64) dem_real az[DEM_BATCH_ROWS];
    /* 1/s    vorticity, curl u (with DEM_NEEDS_VORTICITY) */
    _Alignas(64) dem_real ox[DEM_BATCH_ROWS];
    _Alignas(64) dem_real oy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real oz[DEM_BATCH_ROWS];
    /* N/m3   div tau of viscous and turbulent stress (with DEM_NEEDS_STRESS) */
    _Alignas(64) dem_real sx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real sy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real sz[DEM_BATCH_ROWS];
    /* m      Sauter mean of the surrounding particles (with DEM_NEEDS_MEAN_DIAMETER) */
    _Alignas(64) dem_real mean_diameter[DEM_BATCH_ROWS];
    /* voidage factors of the drag law, set at the start of a coupling window */
    _Alignas(64) dem_real voidage_factor[DEM_VOIDAGE_FACTORS][DEM_BATCH_ROWS];
    /* kg     added mass, set at the start of a coupling window */
    _Alignas(64) dem_real added_mass[DEM_BATCH_ROWS];

    /* ---- results, cleared by the caller: force = f + r + bu - b v, integrated exactly in v ---- */
    /* N      explicit force */
    _Alignas(64) dem_real fx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real fy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real fz[DEM_BATCH_ROWS];
    /* kg/s   drag coefficient, >= 0 */
    _Alignas(64) dem_real b[DEM_BATCH_ROWS];
    /* N      drag coefficient times its target velocity */
    _Alignas(64) dem_real bux[DEM_BATCH_ROWS];
    _Alignas(64) dem_real buy[DEM_BATCH_ROWS];
    _Alignas(64) dem_real buz[DEM_BATCH_ROWS];
    /* N      explicit force whose opposite acts on the fluid (effects that `react`) */
    _Alignas(64) dem_real rx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real ry[DEM_BATCH_ROWS];
    _Alignas(64) dem_real rz[DEM_BATCH_ROWS];
    /* N m s  rotational drag coefficient, >= 0, integrated exactly in the spin */
    _Alignas(64) dem_real t[DEM_BATCH_ROWS];
    /* N m    rotational drag coefficient times its target spin */
    _Alignas(64) dem_real tx[DEM_BATCH_ROWS];
    _Alignas(64) dem_real ty[DEM_BATCH_ROWS];
    _Alignas(64) dem_real tz[DEM_BATCH_ROWS];
};

#endif
