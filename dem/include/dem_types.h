/*
 * dem_types.h -- public types of Suna's discrete element library: status codes, and the structs
 * that the functions of dem.h take and fill.
 *
 * The sections are the same as in dem.h, which says when a struct is filled and how long it is
 * valid; structs of other public headers are in those. This header includes nothing of the library,
 * so all of its folders may include it. Units are SI; vectors are x, y, z; "1" marks a pure number.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_TYPES_H
#define DEM_TYPES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- status ---------------------------------------------------------------------------------- */

/* what functions that can fail return; dem_error_text() has the sentence */
enum
{
    DEM_OK = 0,
    DEM_ERROR_INPUT,   /* what the user wrote: a word, a value, a range */
    DEM_ERROR_MEMORY,  /* an allocation failed, or its size overflows */
    DEM_ERROR_FILE,    /* a file cannot be opened, read or written, or has wrong content */
    DEM_ERROR_STATE,   /* a call out of order, or an internal condition does not hold */
    DEM_ERROR_LOST,    /* particles left the domain or passed through a wall */
    DEM_ERROR_NUMBER,  /* a NaN, an infinity or an absurd value in the physics */
    DEM_ERROR_MPI      /* an MPI call failed */
};

/* ---- case ------------------------------------------------------------------------------------ */

/* a particle to add: dem_case_add_particles */
struct dem_new_particle
{
    double position[3], velocity[3], spin[3];  /* m, m/s, 1/s */
    double diameter;                           /* m */
    int64_t id;                                /* below 0: the next free id */
    const char *material;                      /* name of a material of the scene */
    int frozen;                                /* 1: never moves; others collide with it */
};

/* ---- fluid ----------------------------------------------------------------------------------- */

enum
{
    DEM_OWN_WAKE_DRAG = 9,   /* index of r - 1 in own_wake of struct dem_fluid */
    DEM_OWN_WAKE_VOID = 10,  /* of the part of void_fraction */
    DEM_OWN_WAKE_WIDTH = 11  /* numbers of a particle in it */
};

/* ---- advance --------------------------------------------------------------------------------- */

/* time step of a scene: dem_step_limit */
struct dem_step_limit
{
    double limit;   /* s  the longest stable step */
    double used;    /* s  the longest step of dem_advance */
    char why[160];  /* what sets the limit */
};

/* ---- totals, profile, energy ----------------------------------------------------------------- */

/* sums over all ranks, with the same bits on any number of ranks: dem_totals */
struct dem_totals
{
    int64_t particles, steps, contacts;
    int64_t clumps;             /* rigid bodies of several particles */
    int64_t rebuilds, prunes;   /* of the outer and the inner neighbor list */
    double time;                /* s  since the start of the scene */
    double kinetic;             /* J  translation and rotation */
    double largest_overlap;     /* 1  of the smaller partner's diameter, since the last call */
    double momentum[3];         /* kg m/s */
    double volume, mass;        /* m3, kg  of all particles */
    int64_t inserted, removed;  /* since the start: by streams; by outlets and by leaving the
                                   domain */
    double fall_energy;         /* J  energy of the moving particles' fall by the mean diameter; 0
                                   without gravity */

    /* of effects that act beyond contact (bonds, films); 0 without them */
    int64_t bonds;              /* intact */
    double broken;              /* bonds broken since the start */
    double stored, lost;        /* J  elastic energy of bonds; dissipated by bonds and films since
                                   the start */
    double weight;              /* N  of the moving particles; 0 without gravity */
    int64_t bodies;             /* particles, but the spheres of a clump count once */
};

/* time/untilQuiet: settings, and what the tests have found; see docs/scene-reference.md */
struct dem_quiet
{
    int wanted;          /* 1: the scene has the entry */
    double kinetic;      /* 1  limit, of the energy of falling by a diameter */
    double speed;        /* m/s  limit instead of kinetic; 0: kinetic counts */
    double moving;       /* 1  fraction of the particles that may still move */
    double imbalance;    /* 1  net force on all particles, of their weight */
    double lasting;      /* s  0: from the height of the bed */

    double wait;         /* s  lasting, or the one from the height at the last test */
    double since;        /* s  at rest since; infinite: not at rest */
    double tested;       /* s  time of the last test, with the momentum [kg m/s] then */
    double momentum[3];
    int64_t move;        /* particles that moved at the last test */
    int reached;         /* 1: at rest for long enough */
};

/* largest overlaps of a state from which a run has started, of the smaller diameter */
struct dem_start_overlap
{
    double particles;   /* 1  between particles */
    double wall;        /* 1  with a wall; 0: none */
    int64_t id;         /* of that particle */
    double position[3]; /* m */
    const char *name;   /* of that wall */
};

enum
{
    DEM_PROFILE_PHASES = 12  /* phases of a step, and the time outside dem_advance */
};

/* cost of the run since dem_start: dem_profile; docs/output.md explains it */
struct dem_profile
{
    int ranks;
    struct
    {
        const char *name;
        double mean, max;                     /* s  mean and largest over ranks */
    } phase[DEM_PROFILE_PHASES];              /* the means add up to wall */
    double wall, outside;                     /* s  wall-clock time; part of it outside
                                                 dem_advance: means over ranks */
    double processor;                         /* s  processor time of all ranks: less than theirs
                                                 in `wall` where others had the processor */
    double imbalance;                         /* 1  load imbalance: largest over mean working
                                                 time, without waiting */
    int64_t steps, rebuilds, prunes;
    int64_t particles, contacts;              /* now */
    int64_t particle_steps, row_steps;        /* summed over steps: owned particles; contact rows
                                                 (one between ranks: on both) */
    double outer_skin, inner_skin, diameter;  /* m  present skins; the largest particle */
    double bytes;                             /* of particles and lists, all ranks */
    int64_t messages, message_bytes;          /* sent by all ranks to update ghosts */
    int64_t rebuild_messages;                 /* sent by all ranks when lists were rebuilt */
    int64_t rebuild_message_bytes;
    int64_t agreements;                       /* all-reduces of steps */
    int cuts;                                 /* number of load balancings */

    /* quality of the time integration */
    double largest_overlap;                   /* 1  of the smaller partner's diameter, over all
                                                 steps */
};

enum
{
    DEM_MEANS_MIN_BLOCKS = 4  /* fewer full blocks give no interval: dem_means_get */
};

/* a term of the energy balance: dem_energy */
struct dem_energy_item
{
    char name[72];  /* kinetic_translation ... total, residual: see docs/energy-balance.md */
    double value;   /* J */
};

/* ---- lost particles, streams and outlets ----------------------------------------------------- */

/* a particle that left the domain or crossed a wall: dem_lost */
struct dem_loss
{
    int64_t id;
    double time;                    /* s  when found outside (at a rebuild), or when it crossed */
    double position[3];             /* m  then */
    double velocity[3], diameter;   /* m/s, m  then; the velocity of its last drift */
    int removed;                    /* 1: removed (domain/leaving remove); 0: still there */
    char cause[212];                /* where and why, as far as its last step shows */
};

/* how the particles of a row of dem_flows pass */
enum dem_flow_way
{
    DEM_FLOW_WAY_OUT,                   /* through an outlet, or `domain`: particles that left it */
    DEM_FLOW_WAY_IN,                    /* from a stream */
    DEM_FLOW_WAY_FORTH,                 /* through a plane, along its normal; */
    DEM_FLOW_WAY_BACK                   /* the next row of the same name: against it */
};

/* sums of a stream, an outlet or one direction through a plane, since the start: dem_flows */
struct dem_flow
{
    const char *name;
    int enters;                         /* enum dem_flow_way */
    int64_t particles;
    double mass, momentum[3], energy;   /* kg, kg m/s, J kinetic  each particle's when it passed */
    int64_t waiting;                    /* particles that are due but found no free space at the
                                           last trial */
};

enum
{
    DEM_RESIDENCE_BINS = 64
};

/* times from entry to removal of the particles of an outlet: dem_residence */
struct dem_residence
{
    double end;                     /* s  of the last bin, which has all later ones, too */
    int64_t particles, bin[DEM_RESIDENCE_BINS];
    double sum, squares;            /* s, s2 */
};

/* a periodic cell that deforms, as it is now: dem_cell. Pairs are xx yy zz xy yz zx */
struct dem_cell_now
{
    double length[3], rate[3];      /* m, 1/s  (dL/dt)/L in the last step */
    double shear_rate, shear;       /* 1/s, 1  of simple shear, xy: in the last step; its strain since the
                                       start */
    double stress[6];               /* Pa  of contacts and of motion relative to the flow; tension positive */
    double fabric[6];               /* 1   mean of n n over the contacts */
    double solid;                   /* 1   volume of particles over the cell's */
    double contacts;                /* with a force, between two particles each */
    double modulus[3];              /* Pa  of the contacts along the axes, sum k l^2 n^4/V */
};

/* ---- bonds ----------------------------------------------------------------------------------- */

/* an intact bond: dem_bonds */
struct dem_bond
{
    int64_t id[2];                  /* the lower and the higher id; -1 - wall for a wall */
    double position[3], branch[3];  /* m  of the lower one; vector from the other to it, across
                                       periodic faces */
    double force[3], moment[3];     /* N, N m  on the lower one */
    double stored;                  /* J  elastic energy */
};

/* a broken bond: dem_broken_bonds */
struct dem_broken_bond
{
    int64_t id[2];             /* as in struct dem_bond */
    double time, position[3];  /* s; m  middle of the gap, or on the wall; wrapped into the
                                  periodic domain */
    double energy;             /* J  released in that step */
    int cause;                 /* 1 tension and bending, 2 shear and twist, 3 distance; the first
                                  that held */
};

/* ---- walls ----------------------------------------------------------------------------------- */

/* of a wall: dem_wall_info; no triangles for planes, cylinders, spheres */
struct dem_wall_info
{
    int64_t triangles;      /* in use */
    int64_t flat, repeats;  /* left out: without area; duplicates */
    int moves;              /* 1: it has a motion */
    int passes, absent;     /* 1: it has `from` or `until`; it is not there now */
};

/* of any wall: dem_wall_position */
struct dem_wall_position
{
    double rotation[3][3], shift[3];    /* 1, m  what was given at X is at rotation X + shift */
    int axes;                           /* moved by force: its free axes, 1 for a hinge; else 0 */
    double moved[3], velocity[3];       /* m, m/s along these axes; rad, rad/s for a hinge */
    double spin[3];                     /* 1/s  of a free wall that rotates */
};

/* ---- particles ------------------------------------------------------------------------------- */

/* the particles that this rank owns: dem_view. Valid until the next collective call. Particle k of
   an array with a stride lies k*stride bytes behind the first: dem_at(view.position, view.stride,
   k)[0] is its x. */
struct dem_view
{
    size_t n, stride;                          /* particles; bytes */
    const double *position, *velocity, *spin;  /* m, m/s, 1/s  3 each, with stride */
    const double *radius, *mass;               /* m, kg  with stride */
    const int64_t *id;                         /* with stride */
    const uint16_t *material;                  /* with stride; number for dem_material_name */
    const uint16_t *flags;                     /* with stride; bit 0: frozen */
    const double *force, *torque;              /* N, N m  of contacts, contiguous, 3 each */
    const double *orientation;                 /* contiguous, 4 each; NULL without
                                                  dem_case_enable_orientation */
    const int64_t *clump;                      /* with stride; 1 + the first id of the rigid body
                                                  that it belongs to, 0: none; NULL without shapes */
    const double *density;                     /* kg/m3 of material 0; of material m
                                                  dem_at(density, density_stride, m). A sphere of a
                                                  clump has the volume mass/density; NULL without
                                                  shapes */
    size_t density_stride;
    double period[3];                          /* m  length of the box along periodic axes, 0 along
                                                  others: positions that differ by it are one */
};

/* the arrays of a view: dem_view_leave; NULL: there is none */
struct dem_view_arrays
{
    void *record;                     /* what has a stride */
    void *force, *torque, *orientation;
};

/* ---- particle scalars ------------------------------------------------------------------------ */

/* a number per particle that effects of the scene declare: dem_scalar_info */
struct dem_scalar_info
{
    const char *name, *unit, *help;
    double default_value;   /* of particles without an own; NaN: the scene must give it */
    double min, max;        /* limits */
    int changes;            /* 1: effects change it, 0: it stays as it is given */
    int written;            /* 1: it is written with the particles */
    int exchanged;          /* 1: dem_scalar_exchange gives columns */
};

#ifdef __cplusplus
}
#endif

#endif
