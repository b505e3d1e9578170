/*
 * flows.h -- who comes in by streams and goes out by outlets while a run goes on, and the books of both.
 *
 * When. Streams and outlets are looked at in steps that are multiples of DEM_FLOW_STEPS, after the drift, never when lists happen to be
 * renewed: the cost of lists must not change results. In a run whose fluid must know of everybody beforehand the program says when,
 * between two windows (dem.h, dem_flow).
 *
 * Where. All ranks gather who is in the way of a mouth, and then each makes the same trials and knows the same places: nothing
 * depends on how space is cut. A place is taken when it is clear of spheres and of walls and its centre is in the domain; number k waits until it
 * has one, and those after it wait with it.
 *
 * How fast. Velocities are half a step behind positions there, so who comes in with v is given the kick of half a step backwards: after the
 * step he has v + h/2 a like anybody who had v at that time. A drag that would more than e-fold his slip backwards is left out of it.
 *
 * Books. Sums of what came in are made by all ranks alike, those of what went out from a list sorted by id. A particle counts with its
 * momentum at the time of the positions: in a step that is what the last kick made, half a step of gravity later.
 *
 * A run without streams and outlets looks at one number a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_FLOWS_H
#define DEM_STEP_FLOWS_H

#include "io/snapshot.h"
#include "io/stream.h"
#include "state/particles.h"

struct dem_parts;
struct dem_uniform_fluid;

enum
{
    DEM_FLOW_STEPS = 32,
    DEM_FLOW_STREAM = 1,                                  /* kinds, as snapshots have them */
    DEM_FLOW_OUTLET = 2,
    DEM_FLOW_MASSES = 3,                                  /* a stream that owes kilograms */
    DEM_FLOW_NONE = -1,
    DEM_FLOW_DOMAIN = -2                                  /* out by leaving the domain */
};

struct dem_arrival                                        /* who has found a place */
{
    struct dem_particle particle;
    int stream;
};

struct dem_departure
{
    int64_t id;
    int flow;                                             /* its row in `flow` */
    double mass, momentum[3], energy;                     /* kg, kg m/s, J */
    double push[3];                                       /* N  of contacts, which partners are still to get over half a step */
};

struct dem_flows
{
    const struct dem_streams *plan;
    int n;                                                /* rows: streams, outlets, and the domain if who leaves it is removed; 0: none */
    int now, left;                                        /* 1: outlets take out who is there; somebody goes, on any rank */
    int asked;                                            /* 1: only when the program says so */
    int64_t next_id;
    struct dem_snapshot_flow flow[DEM_SNAPSHOT_FLOWS], kept[DEM_SNAPSHOT_FLOWS];
    int64_t kept_id;
    double push[DEM_SNAPSHOT_FLOWS][3], kept_push[DEM_SNAPSHOT_FLOWS][3]; /* N  of those who went out between two windows */
    double waiting[DEM_SNAPSHOT_FLOWS];                   /* particles or kg: owed, and without a place at the last look */
    size_t arrivals, arrival_room, departures, departure_room;
    struct dem_arrival *arrival;                          /* the same on all ranks, until they are let in */
    struct dem_departure *departure;                      /* of this rank, until they are booked */
    const struct dem_uniform_fluid *fluid;                /* the scene's, for who comes in */
};

void dem_flows_free(struct dem_flows *);

/* Collective, when particles are there: begin, or go on from what a snapshot knew. */
int dem_flows_begin(struct dem_parts *, const struct dem_streams *, const struct dem_snapshot *from);

/* 1 when this is a step in which streams and outlets are looked at. */
int dem_flows_step(const struct dem_parts *);

/* Collective. Find places for who is owed at this time; `arrivals` tells how many have one. `step` names the moment. */
int dem_flows_call(struct dem_parts *, int64_t step);

/* Let in those whose place is here, after the rows of contacts were lifted: behind the owned particles. `half` [s]: they have been kicked back
   by so much. */
int dem_flows_let_in(struct dem_parts *, double half);

struct dem_goer                                           /* whom the program takes out */
{
    int64_t id;
    int flow;
};

/* Collective. Between two windows: let out who is in an outlet and those named, of this rank's, and in who is owed; `changed` on all ranks when
   particles have come or gone. Sorts `goer`. */
int dem_flows_between(struct dem_parts *, size_t n, struct dem_goer *goer, int *changed);

/* The first half kick of a window, over `kick` [s], gives their partners what contacts did to those who have gone since: they take the
   same with them. */
void dem_flows_kick(struct dem_flows *, double kick);

/* The outlet that takes a particle out at x, or DEM_FLOW_NONE. */
int dem_flows_outlet(const struct dem_flows *, const double x[3]);

/* One goes: note it. `late` [s]: so far its velocity is behind. Collective: book all who have gone. */
int dem_flows_note(struct dem_parts *, int flow, const struct dem_particle *, double late);
int dem_flows_book(struct dem_parts *);

/* Books of a state that is copied, and back to them: who had a place since, or was on his way out, has none and is not. */
void dem_flows_keep(struct dem_flows *);
void dem_flows_go_back(struct dem_flows *);

#endif
