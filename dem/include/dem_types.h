/*
 * dem_types.h -- public types of Suna's discrete element library: status codes, and the structs
 * that the functions of dem.h take and fill.
 *
 * The sections are the same as in dem.h, which says when a struct is filled and how long it is
 * valid. This header includes nothing of the library, so all of its folders may include it. Units
 * are SI; vectors are x, y, z; "1" marks a pure number.
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

/* ---- scene: before dem_check ----------------------------------------------------------------- */

/* a particle to add: dem_add_particles */
struct dem_new_particle
{
    double position[3], velocity[3], spin[3];  /* m, m/s, 1/s */
    double diameter;                           /* m */
    int64_t id;                                /* below 0: the next free id */
    const char *material;                      /* name of a material of the scene */
    int frozen;                                /* 1: never moves; others collide with it */
};

/* ---- plan ------------------------------------------------------------------------------------ */

/* 1  largest void fraction of a bed: particles that touch. Random loose packings of spheres have
   0.44 (Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727), of cohesive ones up to this. */
#define DEM_BED_VOID_FRACTION 0.6

/* what the program knows of the run ahead, for dem_plan; 0 where unknown */
struct dem_run_info
{
    double duration;       /* s  from now on */
    double window;         /* s  time step of a coupled fluid */
    const char *why;       /* what limits the window, in a few words */
    double cross_section;  /* m2 of the bed, mean over dem_bed_slab; 0: estimated from the walls */
    double reached_window; /* s  time step that an adjusted one grows to; 0: `window` */
    const char *reached_why;  /* what limits that */
    double inflow;         /* m/s  superficial velocity of the fluid that enters, against gravity */

    /* of a mesh and its fluid */
    double volume, cell;      /* m3 of all cells; m  cube root of the smallest cell */
    double speed, vorticity;  /* m/s, 1/s  largest */
    int one_way;              /* 1: particles do not act on the fluid */
    double patch_speed;       /* m/s  largest speed of the fluid on a patch */
    double resolution;        /* m  length that a particle should not cross in half a window: the
                                 smallest cell, or half the kernel's width */
};

/* what an effect takes from the fluid or gives to the particles, or-ed: dem_effect_traits */
enum dem_effect_trait
{
    DEM_TRAIT_PRESSURE_GRADIENT = 1,   /* the force of the full pressure gradient */
    DEM_TRAIT_FLUID_ACCELERATION = 2,  /* reads Du/Dt of the fluid: added mass */
    DEM_TRAIT_FLUID_STRESS = 4,        /* reads div tau of the fluid */
    DEM_TRAIT_FLUID = 8,               /* acts in a fluid only */
    DEM_TRAIT_TURBULENCE = 32,         /* reads k and epsilon of the fluid */
    DEM_TRAIT_VISCOSITY = 16           /* reads the viscosity, unless it has a setting of its own */
};

enum dem_verdict_word
{
    DEM_NEEDED,      /* on, and needed */
    DEM_NEGLIGIBLE,  /* on, but negligible */
    DEM_MISSING      /* off, though the scene needs it */
};

/* whether the scene needs one effect: dem_verdicts */
struct dem_verdict
{
    const char *effect;           /* its name */
    enum dem_verdict_word word;
    double fraction;              /* 1  its fraction of the quantity that `why` names */
    double cost;                  /* 1  a negligible effect's fraction of processor time; NaN: not
                                     measured */
    char why[200];                /* the reason, and the source of the threshold */
    const char *replaces;         /* the effect that a DEM_MISSING one replaces, or NULL */
    const char *missing_setting;  /* the setting that the user must give for it, or NULL */
};

/* ---- advance --------------------------------------------------------------------------------- */

enum
{
    DEM_STOP_FILE = 1000    /* asked to stop by a file; other numbers are signals */
};

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
};

/* time/untilQuiet: settings, and what the tests have found; docs/scene-reference.md explains them */
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
    DEM_PROFILE_PHASES = 11  /* phases of a step, and the time outside dem_advance */
};

/* cost of the run since dem_setup: dem_profile; docs/output.md explains it */
struct dem_profile
{
    int ranks;
    struct
    {
        const char *name;
        double mean, max;                     /* s  mean and largest over ranks */
        double processor;                     /* s  processor time, mean over ranks: less than
                                                 `mean` where a rank slept or others had the
                                                 processor */
    } phase[DEM_PROFILE_PHASES];              /* the means add up to wall */
    double wall, outside;                     /* s  wall-clock time; part of it outside
                                                 dem_advance: means over ranks */
    double processor;                         /* s  processor time of all ranks, whatever the
                                                 process did */
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

/* sums of a stream or an outlet since the start: dem_flows */
struct dem_flow
{
    const char *name;
    int enters;                         /* 1: a stream; 0: an outlet, or `domain`: particles that
                                           left it */
    int64_t particles;
    double mass, momentum[3], energy;   /* kg, kg m/s, J kinetic  each particle's when it passed */
    int64_t waiting;                    /* particles that are due but found no free space at the
                                           last trial */
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

/* ---- walls and averages ---------------------------------------------------------------------- */

/* of a wall of triangles: dem_wall_info; all 0 for planes, cylinders, spheres */
struct dem_wall_info
{
    int64_t triangles;      /* in use */
    int64_t flat, repeats;  /* left out: without area; duplicates */
    int moves;              /* 1: it has a motion */
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
                                                  dem_orientation_enable */
    double period[3];                          /* m  length of the box along periodic axes, 0 along
                                                  others: positions that differ by it are one */
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

/* exchange of a scalar s with a fluid or the program over an advance: C ds/dt = q + B (s* - s), with
   the capacity C and B the sum of the coefficients of effects and of the program. Columns of owned
   particles, contiguous; in: the program writes them before dem_advance, they stay until it does so
   again; out: it reads them after. docs/adding-an-effect.md */
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

/* ---- coupled fluid --------------------------------------------------------------------------- */

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
    double *acceleration;                /* in   m/s2  3 each, Du/Dt; NULL, like the next four,
                                            unless an effect needs it */
    double *vorticity;                   /* in   1/s   3 each, curl u */
    double *stress;                      /* in   N/m3  3 each, div tau, viscous and turbulent */
    double *mean_diameter;               /* in   m     Sauter mean of the particles around */
    double *turbulence;                  /* in   m2/s2, m2/s3  2 each, k and epsilon */
    double *slip_factor;                 /* in   1     change of the slip by a particle's motion,
                                            relative to a fluid of given velocity; 1 unless set,
                                            1/e^2 where continuity makes the fluid displace
                                            (step/sweep_bodies.c) */
    double *location;                    /* in/out  2 each, for the program: its location in the
                                            mesh; -1 for a new particle */
    const double *drag_impulse;          /* out  N s   3 each, J: drag on the particle during the
                                            last advance */
    const double *other_impulse;         /* out  N s   3 each, of lift and added mass, less what
                                            `carried_over_impulse` will take back; NULL without
                                            them. The fluid gets the opposite of this and of J */
    const double *angular_impulse;       /* out  N m s 3 each, of rotational drag; NULL without.
                                            Not given to the fluid */
    const double *drag_time;             /* out  kg    sum of b h over the steps of the last
                                            advance, b without slip_factor */
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
                                            (dem_fluid_set_displaced) */
    double *owed_pressure_impulse;       /* in/out  N s  3 each, for the program: impulse of the
                                            pressure gradient, without its hydrostatic part, that
                                            the particle has not received yet */
};

enum
{
    DEM_FLOWS = 64    /* limit of streams and outlets; a scene may have fewer */
};

/* a table of a run: dem_table_name */
struct dem_table
{
    char folder[512], path[640];
    double start;     /* s  time at which the run starts */
};

/* sums of streams and outlets at the last rows of flows.csv, for their rates */
struct dem_flow_sums
{
    double time;                                    /* s */
    double particles[DEM_FLOWS], mass[DEM_FLOWS];   /* 1, kg */
};

/* a folder that one run at a time writes into */
struct dem_folder_lock
{
    int file;               /* descriptor; 0: not locked */
    char path[640];
    char before[300];       /* "process 123 on host box" of a run that has left its lock; or "" */
};

#ifdef __cplusplus
}
#endif

#endif
