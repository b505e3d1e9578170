/*
 * wall_body.h -- a wall that is moved by force: free along chosen axes, on a hinge, or pressed by a
 * servo.
 *
 * One law for each free axis, and for the angle of a hinge with inertia and torque in place of mass
 * and force:
 *
 *   v+ = (m v + h (F + f))/(m + c h)
 *
 *   v, v+   velocity before and after a kick of length h                                [m/s]
 *   F       given force, and the weight                                                 [N]
 *   f       force of the particles in the last sweep                                    [N]
 *   m, c    mass, damping coefficient                                                   [kg], [kg/s]
 *
 * It is the leapfrog of the particles, backward in c, so that m = 0 is allowed. That is the servo:
 *
 *   v = (F + f + H)/c,  |v| <= maxSpeed,    dH/dt = (F + f)/tau,  tau = 4 (L/d) Z/K
 *   c = max(Z, 1.5 (D + K dt/2)),     Z = sum sqrt(k m_p),  K = sum k,  D = sum eta
 *
 *   k, eta  tangent stiffness and damping coefficient of a contact; m_p its particle's mass, in a clump
 *           the mass of the clump
 *   L, d    extent of the particles along the axis; mean diameter of those in contact
 *   H       makes up for c v of a wall that keeps moving; 0 without contact, and until |F + f| has been
 *           below F/10 for a passage of sound through the bed, tau/4
 *
 * c = Z is the impedance of a bed: a wave that arrives at the wall is not reflected. The lower bound
 * keeps the wall stable. Sums are over the contacts of the wall; tangential stiffness counts as normal
 * stiffness.
 *
 * The dashpots of the contacts are in f with the velocity v- of the last sweep. They are taken with v:
 *
 *   v = (F + f + H + D v-)/(c + D)
 *
 * With (F + f + H)/c a wall that meets a particle would jump by -D/c of its last jump in each step, to and
 * fro, and its contacts would dissipate several times the energy that they are given.
 *
 * Limits: free walls and hinges K dt^2 < 0.04 m in each sweep.
 *
 * A free wall may also rotate about its centre of mass: wall_rotation.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/binned_sum.h"
#include "input/time_table.h"
#include "walls/pose.h"

enum dem_wall_body_kind
{
    DEM_WALL_BODY_FREE,
    DEM_WALL_BODY_HINGE,
    DEM_WALL_BODY_SERVO
};

enum
{
    DEM_WALL_BODY_SUMS = 2,       /* binned sums of a sweep */
    DEM_WALL_BODY_TERMS = DEM_WALL_BODY_SUMS*DEM_BINNED_SUMS
};

/* sums over the contacts of a wall: force and torque about the origin, then these */
enum dem_wall_body_term
{
    DEM_WALL_BODY_STIFFNESS = DEM_BINNED_SUMS,  /* N/m     K; hinge: N m */
    DEM_WALL_BODY_IMPEDANCE,                    /* kg/s    Z; hinge: N m s */
    DEM_WALL_BODY_DASHPOT,                      /* kg/s    eta; N m s */
    DEM_WALL_BODY_CONTACTS,                     /* 1 */
    DEM_WALL_BODY_DIAMETERS,                    /* m */
    DEM_WALL_BODY_TURNING                       /* N m     K of the rotation of a free wall */
};

enum dem_wall_body_summed
{
    DEM_WALL_BODY_UNKNOWN,        /* the sums, before the first sweep */
    DEM_WALL_BODY_KICKED,         /* known, and the velocity of a servo follows from them */
    DEM_WALL_BODY_SWEPT           /* known; the velocity has not been updated since the sweep */
};

/* doubles only: a snapshot stores them as they are */
struct dem_wall_body_state
{
    double q[3], before[3];               /* m, rad: displacement along the axes; a step ago */
    double v[3];                          /* m/s, rad/s */
    double force[3];                      /* N, N m  of the particles along the axes */
    double stiffness, impedance, dashpot, contacts, diameter, turning;    /* the sums; mean diameter */
    double hold, height, near_time;       /* N, m, s  H; L, 0 before the target is near; for how long */
    double free_path, free_since;         /* m, s  path since the last contact, and when it began */
    double summed;                        /* enum dem_wall_body_summed */
    double rotation[4], rotation_before[4];       /* rotation of a free wall, a unit quaternion; a step ago */
    double momentum[3], torque[3];        /* kg m2/s, N m  about its centre; torque of the particles */
    double load[3], loaded;               /* N, N m  1: of the program, in place of the scene's */
};

enum
{
    DEM_WALL_BODY_WORDS = sizeof(struct dem_wall_body_state)/sizeof(double)
};

struct dem_wall_rotation                      /* rotation of a free wall, see wall_rotation.h */
{
    int axes;                             /* 0: none, 1: about `axis`, 3: about all */
    double axis[3];                       /* unit */
    double centre[3], tensor[3][3];       /* m, kg m2  of mass, where the wall is given; about it */
    double density;                       /* kg/m3  of the solid whose surface the wall is; 0: mass,
                                             centre and tensor are given */
    double spin[3];                       /* 1/s  at the start */
    double torque[3], damping;            /* N m, N m s/rad */
    struct dem_time_table *table;         /* of the torque instead, or NULL */
    double origin[3];                     /* m  the centre without displacement, */
    double inertia[3], principal[4];      /* kg m2  moments; rotation from principal axes to space */
};

struct dem_wall_body
{
    enum dem_wall_body_kind kind;
    int16_t stage[2];                     /* of the scene that begin then, from 1; 0: none */
    double start, end;                    /* s  it rests before and after */
    int axes;                             /* number of free axes */
    double axis[3][3], origin[3];         /* unit, orthogonal; m  of a hinge */
    double mass, damping;                 /* kg or kg m2, kg/s or N m s/rad; damping < 0: not given */
    double weighs;                        /* kg  for the weight; 0: none */
    int weight_given;                     /* 1: the scene says whether it has weight */
    double centre[3];                     /* m   of mass, in the wall's frame: for a hinge */
    double force[3];                      /* N; N m; a servo's target N */
    struct dem_time_table *table;         /* of it instead, or NULL */
    double area;                          /* m2  target = pressure times area; 1 for a force */
    double max_speed, stops[2];           /* m/s; rad */
    struct dem_wall_rotation rotation;
    struct dem_wall_body_state state, backup;
    struct dem_binned_sum sum[DEM_WALL_BODY_SUMS];    /* of this rank and sweep */
};

void dem_wall_body_free(struct dem_wall_body *);    /* NULL is allowed */

/* The pose of its frame now; `before`: a step ago. */
void dem_wall_body_pose(const struct dem_wall_body *, int before, struct dem_pose *);

/* The point about which it rotates [m]: on the axis of a hinge, the centre of mass of a free wall. */
void dem_wall_body_centre(const struct dem_wall_body *, double centre[3]);

/* The given load at a time [s]: of the program, from the table, or of the scene. */
void dem_wall_body_load(const struct dem_wall_body *, double time, double load[DEM_TIME_TABLE_COLUMNS]);

/* 1 when the force of the particles on a servo is near its target [N]. */
int dem_wall_body_is_near(const struct dem_wall_body *, double target);

struct dem_wall_body_kick
{
    double time, h, dt;                   /* s: present; of the kick; of the step */
    int rests;                            /* 1: the wall does not move now */
    double gravity[3], centre[3];         /* m/s2; m, global */
};

struct dem_wall_body_work                 /* J, in a kick */
{
    double loads, lost;                   /* by given forces; in the damping and at stops */
    double contacts;                      /* by the particles on the wall */
};

/* v becomes v+. Adds to the work; a servo does not: it is a wall of given motion in the energy
   balance. */
void dem_wall_body_kick(struct dem_wall_body *, const struct dem_wall_body_kick *,
                        struct dem_wall_body_work *);

/* q += dt v, up to a stop. */
void dem_wall_body_drift(struct dem_wall_body *, double dt, struct dem_wall_body_work *);

double dem_wall_body_kinetic(const struct dem_wall_body *);    /* J */
