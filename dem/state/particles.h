/*
 * particles.h -- the particles of one rank: packed records where contacts gather, columns where loops stream.
 *
 * Owned particles are [0, n), copies of other ranks' particles [n, n + ghosts). Records of both are kept; columns only
 * of owned ones. The store owns its arrays and knows nothing of space, contacts or ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_PARTICLES_H
#define DEM_STATE_PARTICLES_H

#include <stddef.h>
#include <stdint.h>

struct dem_particle                                       /* 128 bytes, two cache lines: all that a contact needs */
{
    double x[3], radius;                                  /* m, m           */
    double v[3], inverse_mass;                            /* m/s, 1/kg: of the inertial mass, 0 when frozen */
    double w[3], inverse_inertia;                         /* 1/s, 1/(kg m2) */
    double mass;                                          /* kg: what gravity pulls */
    int64_t id;
    uint16_t material, flags;
    uint32_t image;                                       /* how often it crossed each periodic face, 10 bits an axis */
    double viscosity;                                     /* Pa s of the fluid here */
};
_Static_assert(sizeof(struct dem_particle) == 128, "a particle record is two cache lines");

static const double dem_particle_most_speed = 299792458.0;    /* m/s: of light; nothing is faster */

enum dem_particle_flag
{
    DEM_PARTICLE_FROZEN = 1
};

enum dem_column_group                                     /* a column is there when the scene has all of its groups */
{
    DEM_GROUP_FLUID = 1,                                  /* effects that need a fluid */
    DEM_GROUP_BOOKS = 2,                                  /* effects past touching, which keep books */
    DEM_GROUP_SWARM = 4,                                  /* laws of drag with open_bodies */
    DEM_GROUP_TURNED = 8,                                 /* runs that ask for orientations */
    DEM_GROUP_ACCELERATION = 16,                          /* effects that need the fluid's acceleration, */
    DEM_GROUP_VORTICITY = 32,                             /* its vorticity, */
    DEM_GROUP_STRESS = 64,                                /* its stress, */
    DEM_GROUP_MEAN_DIAMETER = 128,                        /* the mean diameter around */
    DEM_GROUP_REACTS = 256,                               /* effects that the fluid feels besides drag */
    DEM_GROUP_ADDED = 512,                                /* effects of inertia */
    DEM_GROUP_TURNS = 1024                                /* effects with a rotational drag */
};

enum dem_column_name
{
    DEM_COLUMN_FORCE,                                     /* N    contact force            */
    DEM_COLUMN_TORQUE,                                    /* N m  contact torque           */
    DEM_COLUMN_FLUID_VELOCITY,
    DEM_COLUMN_PRESSURE_GRADIENT,
    DEM_COLUMN_VOID_FRACTION,
    DEM_COLUMN_FLUID_DENSITY,
    DEM_COLUMN_FLUID_VISCOSITY,
    DEM_COLUMN_FLUID_ACCELERATION,
    DEM_COLUMN_VORTICITY,
    DEM_COLUMN_STRESS,
    DEM_COLUMN_MEAN_DIAMETER,
    DEM_COLUMN_COUNTERFLOW,                               /* 1    see step/sweep_bodies.c   */
    DEM_COLUMN_PLACE,                                     /* the coupling's own            */
    DEM_COLUMN_DRAG_IMPULSE,                              /* N s  J of this window         */
    DEM_COLUMN_KEPT,                                      /* 1    product of exp(-b dt/m)  */
    DEM_COLUMN_DRAG_TIME,                                 /* kg   sum of b dt              */
    DEM_COLUMN_START_VELOCITY,                            /* m/s  at the window's start    */
    DEM_COLUMN_WAY,                                       /* m    position at the window's start; once it is closed the way since then */
    DEM_COLUMN_RESPONSE,                                  /* kg   R of this window         */
    DEM_COLUMN_PASSED,                                    /* 1    of a steady force, by drag to the fluid */
    DEM_COLUMN_PENDING,                                   /* N s  impulse for this window, from the last exchange */
    DEM_COLUMN_SWARM_FIRST,                               /* 1    of the fluid alone, for this window: effects/block.h */
    DEM_COLUMN_SWARM_SECOND,
    DEM_COLUMN_ADDED_MASS,                                /* kg   of this window            */
    DEM_COLUMN_FLUID_CHANGE,                              /* m/s2 of the fluid's velocity here, over the last window */
    DEM_COLUMN_FORESEEN,                                  /* N s  of the added mass's answer to it, see step/sweep_bodies.c */
    DEM_COLUMN_OTHER_IMPULSE,                             /* N s  of this window, of forces that react */
    DEM_COLUMN_TURN_IMPULSE,                              /* N m s  of this window, of rotational drag */
    DEM_COLUMN_LOST,                                      /* J    lost so far to bonds and films: half of each pair's, all at a wall */
    DEM_COLUMN_BROKEN,                                    /* 1    bonds broken so far, halves as well */
    DEM_COLUMN_ORIENTATION,                               /* 1    unit quaternion, see step/orientation.h */
    DEM_COLUMNS
};

struct dem_column
{
    const char *name;
    int width;                                            /* numbers per particle */
    unsigned group;                                       /* enum dem_column_group, or-ed */
    double *data;                                         /* NULL when not in use */
};

struct dem_particles
{
    size_t n, ghosts, room;
    unsigned groups;                                      /* whose columns are in use */
    struct dem_particle *record;
    struct dem_column column[DEM_COLUMNS];
};

void dem_particles_init(struct dem_particles *, unsigned groups);
void dem_particles_free(struct dem_particles *);

/* Room for `count` records and columns, contents kept. */
int dem_particles_grow(struct dem_particles *, size_t count);

/* The owned particles of another store and their columns; what was in this one is gone. A store that only holds copies
   (all zero before the first) gets no room to reorder. */
int dem_particles_copy(struct dem_particles *, const struct dem_particles *from);

/* Put owned particle order[k] at place k, for k in [0, count), where it lies: no second store. Either all n are named, in any order,
   or fewer, in rising order, and the others are dropped. Ghosts are dropped, and what `order` held. */
void dem_particles_reorder(struct dem_particles *, uint32_t *order, size_t count);

/* One particle with all columns in use, as `dem_particles_packed_size` doubles. */
size_t dem_particles_packed_size(const struct dem_particles *);
void dem_particles_pack(const struct dem_particles *, size_t particle, double *out);
int dem_particles_append(struct dem_particles *, const double *packed);

/* A new one behind the owned ones, whose columns are all 0. */
int dem_particles_add(struct dem_particles *, const struct dem_particle *);

/* A record of given diameter [m] and density [kg/m3] at rest. */
struct dem_particle dem_particle_sphere(int64_t id, const double x[3], double diameter, double density, int material);

/* Bytes held, and bytes that one particle takes. */
size_t dem_particles_bytes(const struct dem_particles *);
size_t dem_particles_each(const struct dem_particles *);

static inline double dem_sphere_volume(double radius)
{
    return 4.0/3.0*3.14159265358979323846*radius*radius*radius;
}

static inline double dem_particle_volume(const struct dem_particle *p)
{
    return dem_sphere_volume(p->radius);
}

static inline double *dem_column(const struct dem_particles *p, enum dem_column_name c)
{
    return p->column[c].data;
}

#endif
