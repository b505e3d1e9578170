/*
 * block.h -- the two trays that the house hands to the effects: one of contacts, one of bodies.
 *
 * A row of a contact tray is one contact, always seen from the partner with the lower id ("i") to the one with the
 * higher id or the wall ("j"): every force and moment here acts on i, its opposite acts on j. A row of a body tray is
 * one particle. An effect reads the geometry, adds to the results, and never sees an index, a rank or a store.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_BLOCK_H
#define DEM_EFFECTS_BLOCK_H

enum
{
    DEM_BLOCK = 64,                                      /* rows of a tray: a contact tray in use stays in the L1 cache */
    DEM_SWARM = 2                                         /* columns that a law of drag has for itself */
};

#ifndef DEM_REAL
#define DEM_REAL double                                   /* a kernel file may be built in another precision */
#endif
typedef DEM_REAL dem_real;

struct dem_block
{
    int n;                                                /* rows in use, padded to whole vectors by the house */
    dem_real dt;                                          /* s    */
    dem_real longest;                                     /* s    no step of this run is longer (dt is 0 in the first sweep) */
    dem_real time, since;                                 /* s    now, and at the last sweep; -infinite in the first */

    /* geometry, filled by the house */
    _Alignas(64) dem_real nx[DEM_BLOCK];                  /* 1    unit normal from j to i, now */
    _Alignas(64) dem_real ny[DEM_BLOCK];
    _Alignas(64) dem_real nz[DEM_BLOCK];
    _Alignas(64) dem_real hx[DEM_BLOCK];                  /* 1    the same half a step ago: unit(r - dt v/2) */
    _Alignas(64) dem_real hy[DEM_BLOCK];
    _Alignas(64) dem_real hz[DEM_BLOCK];
    _Alignas(64) dem_real overlap[DEM_BLOCK];             /* m    R_i + R_j - |r|; positive in contact, never negative here */
    _Alignas(64) dem_real touching[DEM_BLOCK];            /* 1 in contact, 0 apart */
    _Alignas(64) dem_real reduced_radius[DEM_BLOCK];      /* m    R_i R_j/(R_i + R_j); R_i at a wall */
    _Alignas(64) dem_real reduced_mass[DEM_BLOCK];        /* kg   of the inertial masses; m_i at a wall */
    _Alignas(64) dem_real least_radius[DEM_BLOCK];        /* m    the smaller of R_i and R_j; R_i at a wall */
    _Alignas(64) dem_real vn[DEM_BLOCK];                  /* m/s  (v_i - v_j).n, negative on approach */
    _Alignas(64) dem_real sx[DEM_BLOCK];                  /* m/s  slip of the contact point of i over j, in the half-step plane */
    _Alignas(64) dem_real sy[DEM_BLOCK];
    _Alignas(64) dem_real sz[DEM_BLOCK];
    _Alignas(64) dem_real wx[DEM_BLOCK];                  /* 1/s  relative spin w_i - w_j (filled if an effect needs DEM_NEEDS_SPIN) */
    _Alignas(64) dem_real wy[DEM_BLOCK];
    _Alignas(64) dem_real wz[DEM_BLOCK];
    _Alignas(64) dem_real viscosity[DEM_BLOCK];           /* Pa s of the fluid at the contact (filled if DEM_NEEDS_VISCOSITY) */
    _Alignas(64) dem_real swing[DEM_BLOCK];               /* 1/s  mean spin of both along n: what turns the frame of the pair (if DEM_NEEDS_SWING) */

    /* filled only for classes with an effect of the stages BOND or FILM; there slip counts the gap in the arms, too */
    _Alignas(64) dem_real distance[DEM_BLOCK];            /* m    |r|; height over a wall */
    _Alignas(64) dem_real gap[DEM_BLOCK];                 /* m    |r| - R_i - R_j, negative in contact; |r| - R_i at a wall */
    _Alignas(64) dem_real rate[DEM_BLOCK];                /* m/s  (v_i - v_j).h: how fast the distance grows, also while the pair turns */
    _Alignas(64) dem_real counts[DEM_BLOCK];              /* 1    0 where another region of the wall has this contact: nothing new here */
    _Alignas(64) dem_real chance[DEM_BLOCK];              /* 1    0 to 1, of the two ids only (filled if DEM_NEEDS_CHANCE) */
    _Alignas(64) dem_real sealed[DEM_BLOCK];              /* above 0 where a bond stands in place of the surfaces: nothing of them acts; 2: since now */

    /* adhesion, set by its laws before friction; 0 without one */
    _Alignas(64) dem_real note[DEM_BLOCK];                /*      what the law keeps for its act */
    _Alignas(64) dem_real grip[DEM_BLOCK];                /* N    what friction holds by besides fn: its limit is mu max(fn + grip, 0) */

    /* results, cleared by the house, filled by the effects in the order of their stages */
    _Alignas(64) dem_real kn[DEM_BLOCK];                  /* N/m  secant normal stiffness, by NORMAL */
    _Alignas(64) dem_real kt[DEM_BLOCK];                  /* N/m  tangential stiffness, by TANGENT */
    _Alignas(64) dem_real eta[DEM_BLOCK];                 /* kg/s normal damping coefficient, by DAMP */
    _Alignas(64) dem_real fn[DEM_BLOCK];                  /* N    normal force on i along n, repulsion positive */
    _Alignas(64) dem_real fx[DEM_BLOCK];                  /* N    tangential force on i */
    _Alignas(64) dem_real fy[DEM_BLOCK];
    _Alignas(64) dem_real fz[DEM_BLOCK];
    _Alignas(64) dem_real mx[DEM_BLOCK];                  /* N m  moment of the pair on i (rolling, twisting) */
    _Alignas(64) dem_real my[DEM_BLOCK];
    _Alignas(64) dem_real mz[DEM_BLOCK];

    _Alignas(64) dem_real between[6][DEM_BLOCK];          /*      what a law keeps from one of its loops to the next */

    /* the books of stages BOND and FILM, cleared by the house for such classes */
    _Alignas(64) dem_real stored[DEM_BLOCK];              /* J    elastic energy of the row now */
    _Alignas(64) dem_real lost[DEM_BLOCK];                /* J    turned to heat in this step */
    _Alignas(64) dem_real bonds[DEM_BLOCK];               /* 1    bonds that hold now */
    _Alignas(64) dem_real broke[DEM_BLOCK];               /* 1    bonds that broke in this step */
    _Alignas(64) dem_real cause[DEM_BLOCK];               /*      where one did: 1 tension, 2 shear, 3 distance */
};

struct dem_energy                                         /* the ledger's tray: rows as in struct dem_block */
{
    /* filled by the house */
    _Alignas(64) dem_real was[DEM_BLOCK];                 /* m    overlap before the last drift, never negative */
    _Alignas(64) dem_real kn_was[DEM_BLOCK];              /* N/m  secant normal stiffness then; 0 in a new contact */
    _Alignas(64) dem_real push[DEM_BLOCK];                /* N    what this effect has added to fn, */
    _Alignas(64) dem_real mx[DEM_BLOCK];                  /* N m  and to the moment */
    _Alignas(64) dem_real my[DEM_BLOCK];
    _Alignas(64) dem_real mz[DEM_BLOCK];

    _Alignas(64) dem_real inertia[DEM_BLOCK];             /* kg m2  1/(1/I_i + 1/I_j); I_i at a wall */
    _Alignas(64) dem_real slip_mass[DEM_BLOCK];           /* kg   what a force in the contact plane moves: 1/(1/m_i + 1/m_j + a_i^2/I_i + a_j^2/I_j) */

    /* told by the effect; the house puts in what act has just added to the tray's books (stages BOND and FILM) */
    _Alignas(64) dem_real stored[DEM_BLOCK];              /* J    elastic energy that the row holds now by this effect */
    _Alignas(64) dem_real lost[DEM_BLOCK];                /* J    turned to heat in this step, below 0 where a law gives energy */
};

struct dem_body_block
{
    int n;                                                /* rows in use, padded to whole vectors */
    dem_real dt;                                          /* s      length of the kick that follows */

    /* the particle */
    _Alignas(64) dem_real radius[DEM_BLOCK];              /* m      */
    _Alignas(64) dem_real mass[DEM_BLOCK];                /* kg     */
    _Alignas(64) dem_real volume[DEM_BLOCK];              /* m3     */
    _Alignas(64) dem_real vx[DEM_BLOCK];                  /* m/s    */
    _Alignas(64) dem_real vy[DEM_BLOCK];
    _Alignas(64) dem_real vz[DEM_BLOCK];
    _Alignas(64) dem_real wx[DEM_BLOCK];                  /* 1/s    */
    _Alignas(64) dem_real wy[DEM_BLOCK];
    _Alignas(64) dem_real wz[DEM_BLOCK];

    /* the fluid seen by it (filled if an effect needs DEM_NEEDS_FLUID) */
    _Alignas(64) dem_real ux[DEM_BLOCK];                  /* m/s    fluid velocity */
    _Alignas(64) dem_real uy[DEM_BLOCK];
    _Alignas(64) dem_real uz[DEM_BLOCK];
    _Alignas(64) dem_real gx[DEM_BLOCK];                  /* Pa/m   full pressure gradient, hydrostatic part included */
    _Alignas(64) dem_real gy[DEM_BLOCK];
    _Alignas(64) dem_real gz[DEM_BLOCK];
    _Alignas(64) dem_real void_fraction[DEM_BLOCK];       /* 1      of the fluid */
    _Alignas(64) dem_real density[DEM_BLOCK];             /* kg/m3  of the fluid */
    _Alignas(64) dem_real viscosity[DEM_BLOCK];           /* Pa s   of the fluid */
    _Alignas(64) dem_real ax[DEM_BLOCK];                  /* m/s2   Du/Dt (if DEM_NEEDS_ACCELERATION) */
    _Alignas(64) dem_real ay[DEM_BLOCK];
    _Alignas(64) dem_real az[DEM_BLOCK];
    _Alignas(64) dem_real ox[DEM_BLOCK];                  /* 1/s    vorticity, curl u (if DEM_NEEDS_VORTICITY) */
    _Alignas(64) dem_real oy[DEM_BLOCK];
    _Alignas(64) dem_real oz[DEM_BLOCK];
    _Alignas(64) dem_real sx[DEM_BLOCK];                  /* N/m3   div tau, of viscous and turbulent stress (if DEM_NEEDS_STRESS) */
    _Alignas(64) dem_real sy[DEM_BLOCK];
    _Alignas(64) dem_real sz[DEM_BLOCK];
    _Alignas(64) dem_real mean_diameter[DEM_BLOCK];       /* m      Sauter mean of the particles around (if DEM_NEEDS_MEAN_DIAMETER) */
    _Alignas(64) dem_real swarm[DEM_SWARM][DEM_BLOCK];    /* what the law of drag made of the fluid when the window opened */
    _Alignas(64) dem_real added[DEM_BLOCK];               /* kg     added mass, told when the window opened by effects of inertia */

    /* results, cleared by the house: force = f + r + bu - b v, integrated exactly in v */
    _Alignas(64) dem_real fx[DEM_BLOCK];                  /* N      explicit force */
    _Alignas(64) dem_real fy[DEM_BLOCK];
    _Alignas(64) dem_real fz[DEM_BLOCK];
    _Alignas(64) dem_real b[DEM_BLOCK];                   /* kg/s   drag coefficient, >= 0 */
    _Alignas(64) dem_real bux[DEM_BLOCK];                 /* N      drag coefficient times its target velocity */
    _Alignas(64) dem_real buy[DEM_BLOCK];
    _Alignas(64) dem_real buz[DEM_BLOCK];
    _Alignas(64) dem_real rx[DEM_BLOCK];                  /* N      explicit force whose opposite the fluid gets (effects that react) */
    _Alignas(64) dem_real ry[DEM_BLOCK];
    _Alignas(64) dem_real rz[DEM_BLOCK];
    _Alignas(64) dem_real t[DEM_BLOCK];                   /* N m s  rotational drag, >= 0, integrated exactly in the spin (effects that turn) */
    _Alignas(64) dem_real tx[DEM_BLOCK];                  /* N m    rotational drag times its target spin */
    _Alignas(64) dem_real ty[DEM_BLOCK];
    _Alignas(64) dem_real tz[DEM_BLOCK];
};

#endif
