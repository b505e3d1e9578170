/*
 * dem.h -- the only public header of Suna's discrete element core.
 *
 * Order of use:   dem_create -> dem_scene_text | dem_scene_file, dem_set, dem_add_wall, dem_add_particles
 *                 -> (dem_check) -> dem_ready -> dem_advance ... -> dem_free
 *
 * Every function returns DEM_OK (0) or another status; dem_error_text() then holds one sentence with the thing, the
 * value, the limit and the cure. Functions marked collective are called by all ranks of the communicator together and
 * fail on all of them together. Units are SI. The core never prints, exits or aborts, and makes no MPI call when it
 * was created with MPI_COMM_NULL.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_H
#define DEM_H

#include <mpi.h>
#include <signal.h>

#ifdef __cplusplus
extern "C" {
#endif

#include <stddef.h>
#include <stdint.h>

struct dem;

/* The sentence about the last error on this thread. */
const char *dem_error_text(void);

/* For a caller's own words: always fails, with a sentence that lists the known ones, nearest first. */
int dem_unknown_word(const char *what, const char *word, const char *const *known, int n);

/* ---- making one ---------------------------------------------------------------------------------------------- */

/* Collective. The communicator is duplicated; MPI_COMM_NULL works alone and without MPI. */
int dem_create(struct dem **, MPI_Comm);
void dem_free(struct dem *);

/* The scene's tree, for entries that belong to the caller (io/dictionary.h): read them before dem_check. */
struct dem_dict;
const struct dem_dict *dem_scene_dict(const struct dem *);

/* Read a scene in OpenFOAM's dictionary syntax; `name` stands in messages. May be called once. */
int dem_scene_file(struct dem *, const char *path);
int dem_scene_text(struct dem *, const char *text, const char *name);

/* Override one entry of the scene before dem_check and dem_ready, e.g. dem_set(d, "effects/dry/restitution", "0.9"). */
int dem_set(struct dem *, const char *path, const char *value);

/* Leave an effect out of the scene, in `effects` and in `pairs`, before dem_check and dem_ready. */
int dem_leave_out(struct dem *, const char *effect);

/* One wall of n triangles, 9 numbers each (three corners), copied. Every rank hands in all triangles or its own ones;
   the same triangle handed in by two ranks counts once. `name` must match no other wall. Collective. */
int dem_add_wall(struct dem *, const char *name, const char *material, int64_t n, const double *triangles);

/* Such a wall follows a mesh: its corners, as many triangles in the same order, from each rank those that it has handed in.
   Before dem_ready: where they stand, when dem_add_wall has got them as they were when the mesh was new. Contacts are named
   after that surface, so hand in the same at a restart. After dem_ready: where they will be at the end of the next
   dem_advance; on the way they move linearly in time. A wall that is not told stays where it is. Collective. */
int dem_wall_move(struct dem *, const char *name, int64_t n, const double *triangles);

struct dem_seed                                           /* one particle to add */
{
    double position[3], velocity[3], spin[3];             /* m, m/s, 1/s */
    double diameter;                                      /* m */
    int64_t id;                                           /* < 0: the next free one */
    const char *material;
    int frozen;                                           /* 1: never moves, yet is felt */
};
int dem_add_particles(struct dem *, int64_t n, const struct dem_seed *);   /* every rank hands in the same list */

/* Collective. Read the scene and check all that can be known before particles are placed, which may take long. Entries that
   nobody has asked for are refused. */
int dem_check(struct dem *);

/* Collective. Check if that has not been done; insert or load the start snapshot, freeze the recipe, hand particles to ranks. */
int dem_ready(struct dem *);

struct dem_prospect                                       /* what the caller knows of the run ahead; 0 where nothing */
{
    double duration;                                      /* s  from now */
    double window;                                        /* s  the fluid's step, when one is coupled */
    const char *why;                                      /* what sets the window, in a few words */
    double cross_section;                                 /* m2 that the bed stands on; 0: look at the walls */

    /* of a mesh and its fluid */
    double volume, cell;                                  /* m3 all cells; m  cube root of the smallest */
    double speed, vorticity;                              /* m/s, 1/s  largest */
    int one_way;                                          /* 1: the fluid does not feel the particles */
};

/* Collective, after dem_ready; in coupled runs after the fluid's columns were filled. What acts, walls, particles, step,
   bed, fluid, memory and time of the run ahead, as lines of text, the same on all ranks; it stays until the next call
   or dem_free. Takes a tenth of a second for measuring; nothing moves, and views stay valid. */
int dem_plan(struct dem *, const struct dem_prospect *, const char **text);

enum dem_verdict_word
{
    DEM_NEEDED,                                           /* on and needed */
    DEM_NEGLIGIBLE,                                       /* on but negligible */
    DEM_CALLED_FOR                                        /* off though the scene calls for it */
};

struct dem_verdict                                        /* of the plan, on one effect */
{
    const char *effect;                                   /* its word */
    enum dem_verdict_word word;
    double share;                                         /* 1  of what the words of `why` tell */
    double cost;                                          /* 1  of the run's processor time, of negligible ones; not a number: not measured */
    char why[200];                                        /* ends in the threshold's source */
    const char *instead_of;                               /* the effect whose place one that is called for takes; NULL: none */
    const char *lacks;                                    /* what nobody can guess and it must be given; NULL: nothing */
};

/* Those of the last dem_plan: how many. They stay until the next. */
int dem_verdicts(const struct dem *, const struct dem_verdict **);

struct dem_rewriter                                       /* who has the plan's choice of effects put into the text of a scene */
{
    const char *scene;                                    /* the file; SCENE.part is there while it is worked on, and gone then */
    /* Open the scene whose text is in this file: NULL, or a sentence why it is none. Where `verdict` is not NULL plan it as well, and hand over
       what dem_verdicts says, which stays until the next call that asks for verdicts. */
    const char *(*judge)(void *self, const char *file, const struct dem_verdict **verdict, int *n);
    void (*tell)(void *self, const char *lines);          /* once, at the end: what was changed, and what is left to the user */
    void *self;
};

/* What is called for is added to `effects` or takes another law's place, what is negligible is commented out, each with its reason; the text
   of before stays as SCENE.before, which must not be there yet. Each edit is judged, and plans are asked for until they have no more to say.
   Of one rank. After an error the scene is as it was. */
int dem_rewrite(const struct dem_rewriter *);

/* After dem_check: the line that stands in the head of each result, "effects: " and the words of all that act, in the order of their
   stages, with blanks between: laws of drag differ by a factor of two. The words alone; those of effects of the fluid. */
const char *dem_heading(const struct dem *);
const char *dem_acting(const struct dem *);
const char *dem_acting_fluid(const struct dem *);

/* ---- running ------------------------------------------------------------------------------------------------- */

/* Collective. Advance by `duration` [s] in equal steps no longer than the step limit. Position and velocity are
   synchronous before and after. After an error dem_error_text names the culprit, and the run can't go on: start again
   from the last snapshot. */
int dem_advance(struct dem *, double duration);

/* From here on dem_advance looks at *asked after each step, for whoever catches signals: not 0 on any rank, all return DEM_OK
   together at the end of that step, which may be in the middle of the advance, with velocities half a step ahead of positions. In that
   case, and only then, dem_stopped tells what *asked was (the largest of all ranks). Saved then and loaded, also on other ranks, or
   just advanced on, a run that is asked for the rest of the advance has the bits of one that was not stopped. */
void dem_stop_when(struct dem *, const volatile sig_atomic_t *asked);
int dem_stopped(const struct dem *);

struct dem_step_limit                                     /* s; what bounds the step, in words */
{
    double limit, used;
    char why[160];
};
struct dem_step_limit dem_step_limit(const struct dem *);

struct dem_tally                                          /* sums over all ranks, the same bits on any number of them */
{
    int64_t particles, steps, contacts, rebuilds, prunes;
    double time;                                          /* s  since the start of the scene */
    double kinetic;                                       /* J  translation and rotation */
    double largest_overlap;                               /* 1  of the smaller partner's diameter, since the last call */
    double momentum[3];                                   /* kg m/s */
    double volume, mass;                                  /* m3, kg of all particles */
    int64_t inserted, removed;                            /* by streams and outlets since the start, who left the domain with the latter */
    double fall;                                          /* J  those that move, falling by the mean diameter; 0 without gravity */

    /* the books of effects that act past touching (bonds, films); 0 without them */
    int64_t bonds;                                        /* that hold */
    double broken;                                        /* bonds since the start */
    double stored, lost;                                  /* J  in bonds now; to bonds and films since the start */
};
int dem_tally(struct dem *, struct dem_tally *);          /* collective */

enum
{
    DEM_PROFILE_PHASES = 11
};

struct dem_profile                                        /* what the run since dem_ready has cost */
{
    int ranks;
    struct
    {
        const char *name;                                 /* dem/README.md, section 4 */
        double mean, most;                                /* s  over ranks */
    } phase[DEM_PROFILE_PHASES];                          /* their means add up to wall */
    double wall, outside;                                 /* s  since dem_ready; of it not in dem_advance: means over ranks */
    double processor;                                     /* s  all ranks, whatever this process did */
    double busiest;                                       /* 1  largest over mean rank of the time at work: without waiting */
    int64_t steps, rebuilds, prunes;
    int64_t particles, contacts;                          /* now */
    int64_t particle_steps, row_steps;                    /* owned particles, rows in the sweep (between two ranks: in both), summed */
    double outer_skin, inner_skin, diameter;              /* m  as they are now; the largest particle's */
    double bytes;                                         /* of particles and lists, all ranks */
    int64_t messages, message_bytes;                      /* sent by all ranks to refresh copies */
    int64_t letters, letter_bytes;                        /* sent by all ranks when lists were renewed */
    int64_t agreements;                                   /* all-reduces of steps */
    int cuts;                                             /* how often space was cut anew among ranks */

    /* what the step was good for */
    double largest_overlap;                               /* 1  of the smaller partner's diameter, of all steps */
    int64_t watched, longer;                              /* contacts watched from beginning to end (dem_contacts_watch); of them longer than 128 */
    int least_steps, median_steps;                        /* of those: 0 without any, 129 for a longer one */
};

/* Collective, after dem_ready, not within a window of anybody's. Looking changes nothing. The text is the same on all ranks and stays
   until the next call or dem_free. */
int dem_profile(struct dem *, struct dem_profile *);

/* Before dem_ready: of 4096 steps 256 are watched, in how many of them contacts touch; for the profile. No bit changes. */
int dem_contacts_watch(struct dem *);
int dem_profile_text(struct dem *, const char **text);

struct dem_energy_item
{
    char name[72];                                        /* kinetic_translation ... total, residual: README.md, section 4 */
    double value;                                         /* J */
};

/* The ledger of energy. Asked for before dem_ready, it is kept from there on: kinetic and elastic energies of now, all others
   summed since [s]. Terms of all ranks, in the same order at every call; they stay until the next. Collective. */
int dem_energy_watch(struct dem *);
int dem_energy(struct dem *, double *since, int *n, const struct dem_energy_item **item);

/* Asked for before dem_ready, each particle's orientation is kept: a unit quaternion (cos(a/2), n sin(a/2)), its rotation by a
   about n since the start of the run or of the first one that kept it (snapshots hold it). No law depends on it. */
int dem_orientation_watch(struct dem *);

/* How many particles have more kinetic energy than this [J], translation and rotation. Collective. */
int dem_moving(struct dem *, double energy, int64_t *n);

struct dem_loss                                           /* a particle that was taken out, or passed through a wall */
{
    int64_t id;
    double time;                                          /* s  when it was found outside: lists were rebuilt, or it passed */
    double position[3], velocity[3], diameter;            /* m, m/s, m  then; the velocity is that of its last drift */
    int removed;                                          /* 1: it was taken out (domain/leaving remove); 0: it is still there */
    char cause[212];                                      /* where, by whom, why: as far as its last step tells */
};

/* Losses of all ranks since the last call, by time and id: the same list on every rank, on any number of ranks. It holds
   until the next call. Collective. */
int dem_lost(struct dem *, int64_t *n, const struct dem_loss **);

struct dem_flow                                           /* a stream of `insert`, or an outlet: what has passed since the start */
{
    const char *name;
    int enters;                                           /* 1: a stream; 0: an outlet, or `domain`, by leaving it */
    int64_t particles;
    double mass, momentum[3], energy;                     /* kg, kg m/s, J of motion, each particle's when it passed */
    int64_t waiting;                                      /* particles that are owed, and found no room at the last look */
};

/* Streams, outlets, and the domain if particles may leave it, in this order; none in a scene that has neither streams nor outlets. The same
   on all ranks; they hold until the next call. */
int dem_flows(struct dem *, int *n, const struct dem_flow **);

/* For a program that must know of everybody before it advances (a fluid is coupled): from here on streams and outlets act in
   dem_let_through only, between two advances. Before dem_check; patches of a mesh may then be named in the scene. */
int dem_flow_between(struct dem *);

/* Collective. A patch through which streams come in: triangles of each rank, 9 numbers each [m], corners counterclockwise as seen from
   outside the mesh, and the velocity of the fluid there, 3 each [m/s], or NULL. Before dem_check for each patch of the scene's `insert`, and
   again whenever one of these changes. */
int dem_patch(struct dem *, const char *name, int64_t n, const double *triangles, const double *velocity);

/* Particles of this rank that have passed the patch of an outlet: they go in the next dem_let_through. */
int dem_take_out(struct dem *, const char *patch, int64_t n, const int64_t *id);

/* Collective. Let out who was named and who is in an outlet of the scene, and in who is owed now. *changed: somebody came or went, on any
   rank; then views and columns are new, and those of who came hold a place of -1. */
int dem_let_through(struct dem *, int *changed);

struct dem_bond                                           /* that holds */
{
    int64_t id[2];                                        /* the lower and the higher; -1 - wall for a wall */
    double position[3], branch[3];                        /* m  of the lower one; from the other to it, through periodic faces */
    double force[3], moment[3];                           /* N, N m  on the lower one */
    double stored;                                        /* J */
};

struct dem_break                                          /* of a bond */
{
    int64_t id[2];
    double time, position[3];                             /* s, m  in the middle of the gap, or on the wall; inside periodic limits */
    double energy;                                        /* J  lost in that step */
    int cause;                                            /* 1 tension and bending, 2 shear and twist, 3 distance; the first of these */
};

/* 1 when an effect of the scene bonds. The bonds whose lower particle is this rank's, as of the last step; they hold until the
   next call. The broken ones of all ranks since the last call, as with dem_lost. The last is collective. */
int dem_has_bonds(const struct dem *);
int dem_bonds(struct dem *, int64_t *n, const struct dem_bond **);
int dem_broken_bonds(struct dem *, int64_t *n, const struct dem_break **);
const char *dem_break_cause(int cause);                   /* in a word: tension, shear, distance */

/* A picture of the bonds that hold, for ParaView: a line from partner to partner in this file of a folder that is there, and its
   place at this time [s] in bonds.pvd beside it. None of a state just read or restored, before its first step. Collective. */
int dem_bonds_draw(struct dem *, const char *folder, const char *file, double time);

/* Losses and broken bonds are noted whether or not anybody asks, 288 and 64 bytes each, on the rank that saw them, and kept
   until dem_lost and dem_broken_bonds tell them, also through dem_restore. A long run that never calls these grows by as much: call
   them now and then, and throw away what you don't need. */

/* A 64-bit fingerprint of particles and contact memory, the same for any number of ranks. Collective. */
int dem_hash(struct dem *, uint64_t *hash);

/* Force and torque of particles on each wall, now; 3 numbers each [N], [N m about the origin]. Collective. */
int dem_wall_count(const struct dem *);
const char *dem_wall_name(const struct dem *, int wall);
int dem_wall_load(struct dem *, int wall, double force[3], double torque[3]);

/* Means in the grids of the scene's `averages`, sampled while it advances: the first rank writes NAME.csv and NAME.vti
   of each grid that has samples into the folder, which must exist. Call it on all ranks; only the first can fail. */
int dem_averages_count(const struct dem *);
int dem_averages(struct dem *, const char *folder);
/* Impulse of particles on each wall [N s] and its moment [N m s, about the origin] since the last dem_wall_watch, which
   begins to keep these books or begins them anew. Over the time since it is the mean force and torque. Collective. */
int dem_wall_watch(struct dem *);
int dem_wall_impulse(struct dem *, int wall, double impulse[3], double twist[3]);

struct dem_wall_facts                                     /* of a wall made of triangles; 0 at others */
{
    int64_t triangles, flat, repeats;                     /* kept; left out: without area, given before */
    int moves;                                            /* 1: it has a motion */
};
void dem_wall_facts(const struct dem *, int wall, struct dem_wall_facts *);

/* The triangles of a wall where they stand now [m], 9 numbers each, in an order that stays; all of them on each rank. */
void dem_wall_corners(const struct dem *, int wall, double *corners);

/* ---- looking ------------------------------------------------------------------------------------------------- */

/* The particles that this rank owns. Valid until the next collective call. Record members lie `stride` bytes apart
   from particle to particle; use dem_at. Contiguous columns have 3 numbers (or 1) per particle. */
struct dem_view
{
    size_t n, stride;
    const double *position, *velocity, *spin;             /* 3 numbers, stride */
    const double *radius, *mass;                          /* 1 number, stride */
    const int64_t *id;                                    /* stride */
    const uint16_t *material;                             /* stride; index for dem_material_name */
    const uint16_t *flags;                                /* stride; bit 0: frozen */
    const double *force, *torque;                         /* contact force [N] and torque [N m], contiguous, 3 each */
    const double *orientation;                            /* contiguous, 4 each; NULL unless asked for, dem_orientation_watch */
};
void dem_view(const struct dem *, struct dem_view *);
/* What contacts contribute to the stress, xx yy zz xy yz zx of each particle of the view [J]: sum of force times branch
   over its contacts, tension positive (step/virial.h). Per volume of the mean it is the contact stress. */
int dem_virial(struct dem *, double *virial);
const char *dem_material_name(const struct dem *, int material);

static inline const double *dem_at(const double *column, size_t stride, size_t particle)
{
    return (const double *)(const void *)((const char *)column + stride*particle);
}

/* ---- the fluid ----------------------------------------------------------------------------------------------- */

/* 1 when an effect of the scene needs fluid columns. */
int dem_needs_fluid(const struct dem *);

/* Columns per owned particle, contiguous, written by the coupling before dem_advance (in) and read after it (out).
   They travel with their particles; the pointers are valid until the next collective call. NULL without fluid effects. */
struct dem_fluid
{
    size_t n;
    double *velocity;                                     /* in   m/s   3 */
    double *pressure_gradient;                            /* in   Pa/m  3, full, hydrostatic part included */
    double *void_fraction;                                /* in   1     */
    double *density;                                      /* in   kg/m3 */
    double *viscosity;                                    /* in   Pa s  */
    double *acceleration;                                 /* in   m/s2  3, Du/Dt; like the next three NULL unless an effect asks for it */
    double *vorticity;                                    /* in   1/s   3, curl u */
    double *stress;                                       /* in   N/m3  3, div tau, viscous and turbulent */
    double *mean_diameter;                                /* in   m     Sauter mean of the particles around */
    double *counterflow;                                  /* in   1     how much faster than in a fluid of given velocity a
                                                             particle's motion changes its slip; 1 unless set, 1/e^2
                                                             where the fluid must make room (step/sweep_bodies.c) */
    double *place;                                        /* in/out  the coupling's own: 2 numbers per particle, carried along */
    const double *drag_impulse;                           /* out  N s   3, J: on the particle during the last advance */
    const double *other_impulse;                          /* out  N s   3, of lift and added mass, less what pending will take back; NULL without
                                                             them. The fluid gets the opposite of this and of J */
    const double *turn_impulse;                           /* out  N m s 3, of rotational drag; NULL without. The fluid gets nothing of it */
    const double *drag_time;                              /* out  kg    sum of b h over the last advance, b without counterflow */
    const double *response;                               /* out  kg    R: d(drag impulse)/d(fluid velocity), clamped for held particles */
    const double *way;                                    /* out  m     3, what they moved by in the last advance */
    const double *passed;                                 /* out  1     share of a steady force that drag passed to the fluid */
    const double *pending;                                /* out  N s   3, what dem_fluid_correct left for the next window */
};
int dem_fluid(struct dem *, struct dem_fluid *);

/* yes: drag is the law's b over the void fraction, the whole force of a steady and uniform flow, which holds that of its
   pressure gradient (set III of Zhou, Kuang, Chu, Yu, J. Fluid Mech. 661 (2010) 482, "simplified model B"); the pressure
   gradient handed over must then be the hydrostatic one. no: the law's own b. Kept until it is called again; not in the snapshot. */
void dem_fluid_whole_drag(struct dem *, int yes);

/* For the column counterflow, where the solver's continuity makes room for particles and they get what its new velocity adds:
   1/e^2, or 1/e with whole drag; e as at least 0.1 (effects/exchange.h). */
double dem_fluid_counterflow(const struct dem *, double void_fraction);

/* For the column mean_diameter: from sum V and sum V/d of the particles around [m3], [m2]; 0 where there are none. */
double dem_sauter(double volume, double per_diameter);

enum dem_exchange                                         /* how the fluid gets what it has given: effects/exchange.h */
{
    DEM_EXCHANGE_DEFERRED,                                /* to its new velocity; particles get the same in the next window */
    DEM_EXCHANGE_SEMI_IMPLICIT,                           /* drag at the particles' velocity of now */
    DEM_EXCHANGE_EXPLICIT                                 /* as it was */
};

/* The force of each particle on the fluid after an advance by `window` [s]: F - K u, with K [kg/s] and F [N] (3 each), u the fluid's
   velocity to come. */
int dem_fluid_reaction(const struct dem *, enum dem_exchange, double window, double *coefficient, double *force);

/* The fastest rate at which drag takes up the slip of a particle of this rank [1/s]: b/(m + a), b the mean over the last advance in a fluid
   of given velocity, a the added mass. Frozen ones have none. */
double dem_fluid_relaxation(const struct dem *);

/* After the fluid is solved: with its new velocity and full pressure gradient at the particles (3 numbers each, same
   order as the columns), leave for the next window what the drag of this one would have changed by: the impulse
   R (u' - u) + q V T (grad p' - grad p) with q `passed`. The fluid must receive the same with the other sign. */
int dem_fluid_correct(struct dem *, const double *velocity, const double *pressure_gradient);

/* ---- keeping ------------------------------------------------------------------------------------------------- */

/* Collective. Written aside by all ranks, checked, brought to the disk and renamed: the file of before is there until the new one
   is whole. Loads on any number of ranks, and then runs on with the same bits. */
int dem_save(struct dem *, const char *path);
int dem_load(struct dem *, const char *path);             /* after the scene, instead of its insertions, before dem_check */

/* A copy in memory, for the case that the run fails: one now, and one in dem_advance whenever `steps` steps have passed
   since the last (0: none). A state with a number that is none is not copied; the copy of before stays. The run has the
   same bits with copies and without. Collective. */
int dem_keep(struct dem *, int64_t steps);

/* Go back to the last copy; also after a failed dem_advance. Then look, save, or advance on; averages keep what they have
   sampled. Collective. */
int dem_restore(struct dem *, double *time);

/* 1 unless the last dem_advance left the ranks apart. Failures of physics (a number that is none, too much overlap, a particle
   lost) all ranks have together: dem_lost, dem_restore and what comes after it still work. */
int dem_ranks_agree(const struct dem *);

#ifdef __cplusplus
}
#endif
#endif
