/*
 * durations.h -- how many steps contacts last: watched from beginning to end, now and then.
 *
 * Of 4096 steps the first 256 are watched. Contacts that begin in the first half of these are counted by the steps in which they touch;
 * those that have not ended after 128 steps count as longer ones, so that what is told is no better for short ones than for long. Who
 * touches when watching begins is not known from its beginning and is left out, and so is who begins in a step that renews lists.
 *
 * Walls of triangles are left out, too: there a contact goes from face to face.
 *
 * A step that is watched is one that somebody looks at (step.c); it changes no bit. Memory: 16 bytes a listed pair, in runs that ask.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_DURATIONS_H
#define DEM_STEP_DURATIONS_H

#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_DURATIONS_EVERY = 4096,                           /* steps */
    DEM_DURATIONS_WATCHED = 256,                          /* of these */
    DEM_DURATIONS_MOST = DEM_DURATIONS_WATCHED/2          /* steps of a contact that are counted */
};

struct dem_parts;

struct dem_duration                                       /* of an outer pair */
{
    int32_t age;                                          /* steps that it has touched; 0 apart; -1 since before anybody watched */
    int32_t seen;                                         /* the watched step in which it touched last */
    uint64_t name;                                        /* of its two bodies: what finds it in new lists */
};

struct dem_durations
{
    int asked;                                            /* 1: watch */
    struct dem_duration *pair;
    size_t pairs, room;
    struct dem_duration *carried;                         /* of all ranks, by name, while lists are new */
    size_t carries, carry_room;
    int64_t rebuilds, last;                               /* of lists when these pairs were new; the step noted last */
    int64_t count[DEM_DURATIONS_MOST + 2];                /* contacts that lasted so many steps; the last: longer */
};

/* Is this step, the n-th since the start, watched? */
static inline int dem_durations_due(const struct dem_durations *d, int64_t n)
{
    return d->asked && (n - 1)%DEM_DURATIONS_EVERY < DEM_DURATIONS_WATCHED;
}

/* After the sweep of such a step, whose pushes are at their places. */
int dem_durations_note(struct dem_durations *, const struct dem_parts *);
void dem_durations_free(struct dem_durations *);

/* Collective. How many were watched from beginning to end, how many of them lasted longer than can be told; the shortest and the
   median, in steps: 0 without any, DEM_DURATIONS_MOST + 1 where it is one of the longer ones. */
void dem_durations_tell(const struct dem_parts *, int64_t *watched, int64_t *longer, int *least, int *median);

#endif
