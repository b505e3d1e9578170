/*
 * particles.h -- the particles of one rank: one record per particle for contacts, one array
 * (column) per further quantity.
 *
 * Owned particles are [0, n), ghosts (copies of other ranks' particles) are [n, n + ghosts). Ghosts
 * have a record, and the columns that contacts read (ghost_step, ghost_window). The struct owns its
 * arrays; it depends neither on the domain nor on contacts or ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"
#include <stddef.h>
#include <stdint.h>

/* 128 bytes, two cache lines: all that contacts gather */
struct dem_particle
{
    double x[3], radius;           /* m, m */
    double v[3], inverse_mass;     /* m/s, 1/kg: of the inertial mass, 0 when frozen */
    double w[3], inverse_inertia;  /* 1/s, 1/(kg m2) */
    double mass;                   /* kg: gravitational mass */
    int64_t id;
    uint16_t material, flags;
    uint32_t image;                /* crossings of periodic faces, 10 bits per axis */
    int64_t body;                  /* 1 + id of the first sphere of its clump; 0: none (clump.h) */
};
_Static_assert(sizeof(struct dem_particle) == 128, "a particle record is two cache lines");

/* m/s: upper limit of particle speeds, the speed of light */
static const double dem_particle_max_speed = 299792458.0;

enum dem_particle_flag
{
    DEM_PARTICLE_FROZEN = 1,         /* no force moves it; its velocity and spin stay */
    DEM_PARTICLE_DRIVEN = 2,         /* besides frozen: with a velocity or spin of its own */
    DEM_PARTICLE_NEW = 8,            /* inserted at a restart, during the set-up only */
    DEM_PARTICLE_ABSORBED = 0xff00,  /* 1 + the index of the outlet of the wall that has absorbed it,
                                        until it is removed; 0: none */
    DEM_PARTICLE_ABSORBED_SHIFT = 8
};

/* a column exists when the scene has all its groups */
enum dem_column_group
{
    DEM_GROUP_FLUID = 1,              /* effects that need a fluid */
    DEM_GROUP_PAIR_ENERGY = 2,        /* effects past touching, with an energy per pair */
    DEM_GROUP_VOIDAGE_FACTOR = 4,     /* drag laws with a voidage factor (prepare_bodies) */
    DEM_GROUP_ORIENTATION = 8,        /* runs that request orientations */
    DEM_GROUP_ACCELERATION = 16,      /* effects that need the fluid's acceleration, */
    DEM_GROUP_VORTICITY = 32,         /* its vorticity, */
    DEM_GROUP_STRESS = 64,            /* its stress, */
    DEM_GROUP_MEAN_DIAMETER = 128,    /* the local mean particle diameter */
    DEM_GROUP_REACTION = 256,         /* forces other than drag that react on the fluid */
    DEM_GROUP_ADDED_MASS = 512,       /* added mass */
    DEM_GROUP_ROTATIONAL_DRAG = 1024, /* rotational drag */
    DEM_GROUP_TURBULENCE = 4096,      /* effects that need the fluid's turbulence */
    DEM_GROUP_OUTLETS = 8192,         /* outlets that are regions */
    DEM_GROUP_BIRTH = 65536,          /* outlets that ask for the residence time */
    DEM_GROUP_CLUMP = 32768,          /* rigid bodies of several spheres */
    DEM_GROUP_OWN_WAKE = 16384,       /* coupling that subtracts a particle's own wake */
    DEM_GROUP_UNDER_RELAXATION = 2048, /* light particles in a fluid that they displace */
    DEM_GROUP_INTERFACE = 131072      /* effects that need the interface of two fluids */
};

enum
{
    DEM_CLUMP_SPHERES = 256,          /* limit of the spheres of a clump */
    DEM_CLUMP_WIDTH = 20              /* numbers of its column */
};

enum dem_column_name
{
    DEM_COLUMN_FORCE,                    /* N    contact force */
    DEM_COLUMN_TORQUE,                   /* N m  contact torque */
    DEM_COLUMN_FLUID_VELOCITY,
    DEM_COLUMN_PRESSURE_GRADIENT,
    DEM_COLUMN_VOID_FRACTION,
    DEM_COLUMN_FLUID_DENSITY,
    DEM_COLUMN_FLUID_ACCELERATION,
    DEM_COLUMN_VORTICITY,
    DEM_COLUMN_STRESS,
    DEM_COLUMN_TENSION,                  /* N/m  surface tension times the interface's normal */
    DEM_COLUMN_INTERFACE_DISTANCE,       /* m    height above it */
    DEM_COLUMN_MEAN_DIAMETER,
    DEM_COLUMN_TURBULENCE,               /* m2/s2, m2/s3  k, epsilon */
    DEM_COLUMN_EDDY,                     /* 1    4: fluctuation over sqrt(2 k/3), time left in the
                                            eddy over its mean (laws/fluid/eddy.h) */
    DEM_COLUMN_SLIP_FACTOR,              /* 1    gamma of laws/fluid/particle_exchange.h */
    DEM_COLUMN_COUPLING_INDEX,           /* 2 numbers owned by the coupling, -1 when unset */
    DEM_COLUMN_DRAG_IMPULSE,             /* N s  J of this window */
    DEM_COLUMN_DECAY_FACTOR,             /* 1    decay factor: product of exp(-b dt/m) */
    DEM_COLUMN_DRAG_INTEGRAL,            /* kg   integral of the drag coefficient: sum of b dt */
    DEM_COLUMN_START_VELOCITY,           /* m/s  at the start of the window */
    DEM_COLUMN_DISPLACEMENT,             /* m    position at the start of the window; after
                                            its end the displacement in the window */
    DEM_COLUMN_RESPONSE,                 /* kg   R of this window */
    DEM_COLUMN_TRANSMITTED_FRACTION,     /* 1    fraction of a steady force
                                            that drag transmits to the fluid */
    DEM_COLUMN_CARRIED_OVER_IMPULSE,     /* N s  carried-over impulse: from the last
                                            exchange, to be applied in this window */
    DEM_COLUMN_UNDER_RELAXATION,         /* 1    factor of the pressure gradient and of Du/Dt,
                                            0 before it is set */
    DEM_COLUMN_OWED_PRESSURE_IMPULSE,    /* N s  of the pressure gradient on the volume of the
                                            particle, not passed on yet; by the coupling */
    DEM_COLUMN_OWN_WAKE,                 /* part of the fluid velocity that is the particle's own
                                            wake, 3 [m/s]: body effects see the rest; 6 that the
                                            coupling computes it from; part of the void fraction
                                            above the cells' [1] */
    DEM_COLUMN_VOIDAGE_FACTOR_FIRST,     /* 1    voidage factors of drag laws in this window, */
    DEM_COLUMN_VOIDAGE_FACTOR_SECOND,    /*      functions of the fluid alone, laws/batch.h */
    DEM_COLUMN_ADDED_MASS,               /* kg   of this window */
    DEM_COLUMN_FLUID_CHANGE,             /* m/s2 rate of the fluid velocity at
                                            the particle, over the last window */
    DEM_COLUMN_PREDICTED_ADDED_IMPULSE,  /* N s  predicted added-mass impulse,
                                            see step/body_window.c */
    DEM_COLUMN_OTHER_IMPULSE,            /* N s  of this window, of forces that react */
    DEM_COLUMN_ANGULAR_IMPULSE,          /* N m s  of this window, of rotational drag */
    DEM_COLUMN_LOST_ENERGY,              /* J    dissipated so far by bonds and films: half
                                            the loss of a pair, all of a wall's */
    DEM_COLUMN_BROKEN_BONDS,             /* 1    bonds broken so far, counted likewise */
    DEM_COLUMN_ORIENTATION,              /* 1    unit quaternion, see particles/orientation.h */
    DEM_COLUMN_CHECKED_POSITION,         /* m, 1 4: at the last check of outlets
                                            (sources/outlet_path.c) */
    DEM_COLUMN_BIRTH,                    /* s    time of the entry into the domain */
    DEM_COLUMN_CLUMP,                    /* the body of a sphere: struct dem_clump */
    DEM_COLUMNS,                         /* from here on columns of scalars, in use in this scene */
    DEM_FURTHER_COLUMNS = 24,            /* limit of their number */
    DEM_BATCH_COLUMNS = 4                /* limit of those that fill columns of batches */
};

struct dem_column
{
    const char *name;
    int width;                    /* numbers per particle */
    unsigned group;               /* enum dem_column_group, or-ed */
    double *data;                 /* NULL when not in use */
};

struct dem_column_list             /* columns of one number each */
{
    int n, column[DEM_FURTHER_COLUMNS];
};

struct dem_batch_columns           /* columns that are copied to columns of batches */
{
    int n;
    struct
    {
        int column;
        const struct dem_scalar_batch *to;    /* where, see laws/scalar.h */
    } at[DEM_BATCH_COLUMNS];
};

struct dem_particles
{
    size_t n, ghosts, capacity;
    unsigned groups;              /* groups of the columns in use */
    struct dem_particle *record;
    int columns;                  /* in the next array */
    struct dem_column column[DEM_COLUMNS + DEM_FURTHER_COLUMNS];
    struct dem_column_list ghost_step;    /* columns that ghosts have too, renewed in each step; */
    struct dem_column_list ghost_window;  /* renewed at the start of each window */
    struct dem_batch_columns batch;
};

void dem_particles_init(struct dem_particles *, unsigned groups);

/* Before there are particles: a further column of one number, 0 at first. `name` is not copied.
   Returns its index. */
int dem_particles_add_column(struct dem_particles *, const char *name);

/* The further columns and the lists of ghost columns of `from`, for particles just initialised. */
void dem_particles_add_columns_of(struct dem_particles *, const struct dem_particles *from);
void dem_particles_free(struct dem_particles *);

/* Raise the capacity to at least `count` particles; contents are kept. */
int dem_particles_grow(struct dem_particles *, size_t count);

/* Replace the content by the owned particles of `from` and their columns. The target may be all
   zero. */
int dem_particles_copy(struct dem_particles *, const struct dem_particles *from);

/* Move owned particle order[k] to index k, for k in [0, count), in place. `order` either holds all
   n particles in any order, or fewer in ascending order; the others are removed. Removes all ghosts
   and overwrites `order`. */
void dem_particles_reorder(struct dem_particles *, uint32_t *order, size_t count);

/* One particle with all columns in use as `dem_particles_packed_size` doubles: write it, and append
   it behind the owned ones (which removes all ghosts). */
size_t dem_particles_packed_size(const struct dem_particles *);
void dem_particles_pack(const struct dem_particles *, size_t particle, double *out);
int dem_particles_append(struct dem_particles *, const double *packed);

/* Append a particle behind the owned ones, with all columns 0. Removes all ghosts. */
int dem_particles_add(struct dem_particles *, const struct dem_particle *);

/* A record at rest with the given diameter [m] and density [kg/m3]. */
struct dem_particle dem_particle_sphere(int64_t id, const double x[3], double diameter,
                                        double density, int material);

/* Bytes held, and bytes per particle. */
size_t dem_particles_bytes(const struct dem_particles *);
size_t dem_particles_bytes_per_particle(const struct dem_particles *);

/* The owned particles for other programs (dem_types.h). */
void dem_particles_view(const struct dem_particles *, const double period[3], struct dem_view *);

/* Go on with copies of the arrays that a view shows; `was` gets the arrays. */
int dem_particles_leave(struct dem_particles *, struct dem_view_arrays *was);

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
