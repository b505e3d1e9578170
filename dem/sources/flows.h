/*
 * flows.h -- insertion of particles by streams and removal by outlets during a run, with the totals
 * of both.
 *
 * Timing. Streams and outlets are checked after the drift in steps that are multiples of
 * DEM_FLOW_STEPS, never when lists happen to be rebuilt: the cost of lists must not change results.
 * In a run whose fluid has to know of all particles beforehand, the program chooses the time,
 * between two windows (dem.h, dem_flow).
 *
 * Outlets. A particle is removed when the straight line from its position at the last check to the
 * present one meets an outlet, so that none passes a thin one. These positions are a column of the
 * particles, which scenes with a region among their outlets have.
 *
 * Position. All ranks gather the particles near an inlet, and then each rank makes the same trials
 * and finds the same positions: nothing depends on the decomposition. A position is accepted when
 * it is clear of spheres and walls and its centre is in the domain. Particle number k of a stream
 * waits until it has a position, and the following ones wait with it.
 *
 * Velocity. In a step velocities are half a step behind positions. A particle that enters with v is
 * therefore given a backward kick of half a step: after the step it has v + h/2 a like any particle
 * that had v at that time. Drag that would enlarge its slip by more than a factor of e = 2.718 is
 * left out of this kick.
 *
 * Totals. Sums over inserted particles are made by all ranks alike, those over removed particles
 * from a list sorted by id. A particle counts with its momentum at the time of its position: in a
 * step, the momentum after the last kick plus half a step of gravity.
 *
 * Planes. A particle counts in a check when the line from its position at the last check goes through
 * the plane or disc, forth and back in rows of their own.
 *
 * A run without streams and outlets tests one number a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "records/snapshot.h"
#include "sources/stream.h"
#include "particles/particles.h"

struct dem_state;
struct dem_uniform_fluid;

enum
{
    DEM_FLOW_STEPS = 32,
    DEM_FLOW_STREAM = 1,                                  /* kinds, as stored in snapshots */
    DEM_FLOW_OUTLET = 2,
    DEM_FLOW_MASS_STREAM = 3,                                  /* a stream with a mass rate */
    DEM_FLOW_FORTH = 4,                                   /* through a plane, along its normal */
    DEM_FLOW_BACK = 5,                                    /* and against it */
    DEM_FLOW_NONE = -1,
    DEM_FLOW_DOMAIN = -2                                  /* out by leaving the domain */
};

struct dem_arrival    /* a particle with a position, not yet inserted */
{
    struct dem_particle particle;
    int stream;
    int64_t number;               /* in its stream, from 0 */
};

struct dem_departure
{
    int64_t id;
    int flow;                          /* its index in `flow` */
    double mass, momentum[3], energy;  /* kg, kg m/s, J */
    double age;                        /* s  since its entry, where an outlet asks */
    double contact_force[3];                    /* N  contact force, whose reaction acts on
                                          the partners for another half step */
};

struct dem_flows
{
    const struct dem_streams *plan;
    int n;                                  /* number of flows: streams, outlets, and
                                               the sides of the domain; 0: none */
    int now, left;                          /* 1: outlets remove particles in this
                                               step; 1: some rank removes particles */
    int asked;                              /* 1: only when the program asks */
    int64_t checked;                        /* the last step that a device has had checked */
    int found;                              /* 1: it has found particles that enter or leave, and
                                               the host changes them in this step */
    int64_t next_id;
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS], backup[DEM_SNAPSHOT_FLOWS];
    int64_t backup_id;
    /* N  contact force of particles removed between two windows */
    double contact_force[DEM_SNAPSHOT_FLOWS][3], backup_contact_force[DEM_SNAPSHOT_FLOWS][3];
    double waiting[DEM_SNAPSHOT_FLOWS];     /* particles or kg: due, and without
                                               a position at the last check */
    size_t arrivals, arrival_capacity, departures, departure_capacity;
    struct dem_arrival *arrival;            /* the same on all ranks, until they are inserted */
    struct dem_departure *departure;        /* of this rank, until they are summed */
    struct dem_residence *residence;        /* of each flow, then the backup; NULL: no outlet asks */
    const struct dem_uniform_fluid *fluid;  /* of the scene, for inserted particles */
};

void dem_flows_free(struct dem_flows *);

/* Collective, after the initial particles have been created: begin, or continue from the totals of
   a snapshot. */
int dem_flows_begin(struct dem_state *, const struct dem_streams *,
                    const struct dem_snapshot *from);

/* Collective. The first id above all particles' ids. */
int64_t dem_flows_first_free_id(const struct dem_state *);

/* Set the columns of a particle that is inserted as number i: the fluid's, and what the beginning of
   a window sets. */
void dem_flows_begin_columns(struct dem_state *, size_t i, const struct dem_uniform_fluid *);

/* 1 when streams and outlets are checked in this step. */
int dem_flows_due(const struct dem_state *);

/* Collective. Find positions for the particles due at this time; `arrivals` is the number of those
   that have one. `step` seeds the random numbers. */
int dem_flows_find_positions(struct dem_state *, int64_t step);

/* 1 while particles of a stream, or of a group with `at`, are missing. It looks at those that begin by this time [s]. */
int dem_flows_insert_by(const struct dem_state *, double begun);

/* Add the arrivals of this rank behind its owned particles, after the contact history has been
   saved. They have the velocity of their stream: within a window the caller kicks it backward by
   half a step. */
int dem_flows_insert(struct dem_state *);

struct dem_outgoing_particle    /* a particle that the program removes */
{
    int64_t id;
    int flow;
};

/* Collective. Between two windows: remove the particles in outlets and the listed ones of this
   rank, and insert those due. `changed`: 1 on all ranks when any particle was inserted or removed.
   before_changes: called if any will be. Sorts `outgoing`. */
int dem_flows_between_windows(struct dem_state *, size_t n, struct dem_outgoing_particle *outgoing,
                              int (*before_changes)(struct dem_state *), int *changed);

/* The first half kick of a window, over `kick` [s], still gives the partners of removed particles
   the reaction of their contact forces. The removed momentum gets the opposite impulse. */
void dem_flows_complete_departures(struct dem_flows *, double kick);

/* Index of the outlet that particle i contains or has met since the last check, or DEM_FLOW_NONE. */
int dem_flows_outlet(const struct dem_state *, size_t i);

/* Index of the outlet that contains a position in the domain [m], or DEM_FLOW_NONE. */
int dem_flows_outlet_at(const struct dem_flows *, const double x[3]);

/* How often particle i has passed each plane since the last check: times forth less times back. Returns 0
   when its path is not known. */
int dem_flows_planes_passed(const struct dem_state *, size_t i, int passed[DEM_SNAPSHOT_FLOWS]);

/* Collective, at the beginning of a check: count the particles that have passed planes since the last one.
   `late` [s]: by how much velocities are behind positions. */
int dem_flows_count_passages(struct dem_state *, double late);

/* At the end of a check: the present position of each owned particle is its last one. */
void dem_flows_end_check(struct dem_state *);

/* Index of the outlet of the wall that has absorbed the particle, or DEM_FLOW_NONE. */
int dem_flows_absorbed(const struct dem_flows *, const struct dem_particle *);

/* Record a particle that is removed; `late` [s]: by how much its velocity is behind its position.
   Collective: add all recorded ones to the totals. */
int dem_flows_record_departure(struct dem_state *, int flow, const struct dem_particle *,
                               double late);
int dem_flows_sum_departures(struct dem_state *);

/* Back up the totals with the state, and restore them: arrivals and departures since then are
   dropped. */
void dem_flows_backup(struct dem_flows *);
void dem_flows_restore(struct dem_flows *);
