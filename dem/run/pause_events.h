/*
 * pause_events.h -- when something begins or ends that the scene has a time for (pause.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RUN_PAUSE_EVENTS_H
#define DEM_RUN_PAUSE_EVENTS_H

struct dem_state;
struct dem_wall;

struct dem_event
{
    double from;         /* s  it comes after this time */
    int mechanics;       /* 1: of mechanics only; 0: or the condition of a wall for a scalar */
    double time;         /* s  infinite: none */
    char what[200];      /* "stream feed begins" */
};

/* s  times are sums of steps: up to here they are the same */
double dem_events_after(double time);

/* The first event after `from` [s]. */
struct dem_event dem_events_next(const struct dem_state *, double from, int mechanics);

/* 1 while this wall is in motion; `always`: from the start of the run to its end. */
int dem_events_wall_moves(const struct dem_state *, const struct dem_wall *, int always);

/* 1 while a wall moves or a stream inserts: something moves that the test of rest cannot show. */
int dem_events_act(const struct dem_state *);

#endif
