/*
 * contact_durations.h -- number of time steps that contacts last, sampled periodically.
 *
 * Of 4096 steps the first 256 are watched. Contacts that begin in the first half of these are
 * counted by the number of steps in which they touch; those that have not ended after 128 steps are
 * counted as longer ones, so that short contacts are not favoured. Contacts that exist when
 * watching begins are left out because their beginning is unknown, and so are contacts that begin
 * in a step that rebuilds lists.
 *
 * Contacts with walls of triangles are left out, too: there a contact passes from facet to facet.
 *
 * In a watched step all contact forces are stored (see step.c); no result changes. Memory: 16 bytes
 * a listed pair, in runs that ask for it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_DIAGNOSTICS_CONTACT_DURATIONS_H
#define DEM_DIAGNOSTICS_CONTACT_DURATIONS_H

#include <stddef.h>
#include <stdint.h>

enum
{
    DEM_CONTACT_DURATIONS_PERIOD = 4096,  /* steps: period */
    DEM_CONTACT_DURATIONS_WATCHED = 256,  /* steps of a period that are watched */
    /* steps: longest duration that is counted */
    DEM_CONTACT_DURATIONS_MAX = DEM_CONTACT_DURATIONS_WATCHED/2
};

struct dem_state;

struct dem_contact_duration    /* of one pair of the outer list */
{
    int32_t age;    /* steps that it has touched; 0 apart; -1 beginning unknown */
    int32_t seen;   /* the watched step in which it touched last */
    uint64_t name;  /* hash of both partners, to find the pair in rebuilt lists */
};

struct dem_contact_durations
{
    int asked;                                     /* 1: this run watches contacts */
    struct dem_contact_duration *pair;
    size_t pairs, capacity;
    struct dem_contact_duration *saved;            /* pairs in contact of all ranks, sorted
                                                      by name, while lists are rebuilt */
    size_t saved_count, saved_capacity;
    int64_t rebuilds, last;                        /* number of rebuilds when these pairs
                                                      were listed; last watched step */
    int64_t count[DEM_CONTACT_DURATIONS_MAX + 2];  /* contacts by duration in steps;
                                                      the last entry: longer ones */
};

/* 1 when the n-th step since the start is watched. */
static inline int dem_contact_durations_due(const struct dem_contact_durations *d, int64_t n)
{
    return d->asked && (n - 1)%DEM_CONTACT_DURATIONS_PERIOD < DEM_CONTACT_DURATIONS_WATCHED;
}

/* After the sweep of a watched step, in which all contact forces are stored at their rows. */
int dem_contact_durations_record(struct dem_contact_durations *, const struct dem_state *);
void dem_contact_durations_free(struct dem_contact_durations *);

/* Collective. `watched`: number of contacts counted; `longer`: how many of them lasted longer than
   DEM_CONTACT_DURATIONS_MAX steps; `shortest`, `median`: shortest and median duration in steps, 0 without any
   contact, DEM_CONTACT_DURATIONS_MAX + 1 if it is one of the longer ones. */
void dem_contact_durations_report(const struct dem_state *, int64_t *watched, int64_t *longer,
                                  int *shortest, int *median);

#endif
