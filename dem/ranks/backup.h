/*
 * backup.h -- in-memory copy of the owned particles and of the contact history, for recovery after
 * a failed step.
 *
 * step/step.c decides when a copy is made; dem_restore of dem.h puts it back.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contacts.h"
#include "particles/particles.h"

/* the coupling window: the steps of one advance */
struct dem_window
{
    /* s  length */
    double length;
    /* s  time at its start */
    double start;
    /* steps of the run before it; steps of it */
    int64_t steps_before, steps;
    /* 1: stopped within it; velocities are half a step ahead */
    int half_step_ahead;
    /* value of the stop request at the stop, maximum of ranks */
    int stopped;
};

struct dem_backup
{
    int64_t every;                   /* steps between copies within a window; 0: none */
    int valid;                       /* 1: there is a copy */
    int64_t steps;                   /* number of steps at the copy */
    double time, dt;                 /* s, of the copy; the last time step */
    struct dem_window window;        /* of the copy; velocities are half a step ahead if it is open */
    struct dem_particles particles;  /* owned particles only */
    struct dem_contacts history;     /* saved history only: no pairs, no rows */
};

void dem_backup_free(struct dem_backup *);

/* Copy the owned particles and the history of all contacts that have one. `wall_facet`: the facet
   of each wall neighbor. DEM_OK, or an error when memory runs out; then there is no copy. */
int dem_backup_save(struct dem_backup *, const struct dem_particles *, const struct dem_contacts *,
                    const struct dem_facet_key *wall_facet);

/* Put the copy back. The contacts then have no pairs; their history is saved history, which the
   next rebuild assigns to the new rows. */
int dem_backup_restore(const struct dem_backup *, struct dem_particles *, struct dem_contacts *);
