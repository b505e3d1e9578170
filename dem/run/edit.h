/*
 * edit.h -- an edit of the particles between two advances, its checks and what follows from it.
 *
 *   1. check the arguments
 *   2. save the contact history and the forces on walls, and drop the contact rows: the next step
 *      rebuilds the lists and sends particles to their owners
 *   3. change the particles that this rank owns
 *   4. on a backup, build the lists: refuse overlaps of particles that are new or were moved, and
 *      evaluate the elastic energy for the energy balance
 *
 * After an error the state is put back from a copy. Velocities and spins alone change nothing but the
 * records. The first half kick of the next advance takes the contact forces from the columns of the
 * particles, 0 for those that are new or moved.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "case/dem_case.h"
#include <string.h>

struct dem_edit_item            /* an id of the call and where it stands in the list */
{
    int64_t id, at;
};

struct dem_edit
{
    const char *call;
    int64_t n;
    struct dem_edit_item *item;                 /* by id */
    int (*change)(struct dem *, const struct dem_edit *);
    int lists;                                  /* 1: the lists change */
    const struct dem_new_particle *new;         /* to add; NULL: none */
    struct dem_initial_particles add;           /* the same, checked */
    int64_t *id;                                /* and their ids */
    const struct dem_particle_changes *to;      /* to set */
};

/* An error unless the run can be edited now. */
int dem_edit_check_state(const struct dem *, const char *call);

/* Take the ids, each once; where an id stands in the list, or NULL. */
int dem_edit_list(struct dem_edit *, const int64_t *id);
const struct dem_edit_item *dem_edit_find(const struct dem_edit *, int64_t id);

/* The first id that no particle has had. */
int64_t dem_edit_next_id(const struct dem *);

/* Time step and lists are made for the radius of this particle. */
int dem_edit_check_radius(const struct dem *, const char *call, const struct dem_particle *);

/* Set the position; a particle outside the domain is refused. */
int dem_edit_place(const struct dem *, const char *call, struct dem_particle *);

static inline void dem_edit_set_vector(double to[3], const double *values, int64_t at)
{
    if (values)
    {
        memcpy(to, values + 3*at, 3*sizeof *to);
    }
}

/* Add the checked particles that this rank owns. */
int dem_edit_add(struct dem *, const struct dem_edit *);

/* 1 if the call sets more than particle scalars: then the first sphere of a clump stands for all of it. */
static inline int dem_edit_moves(const struct dem_edit *e)
{
    return e->to && (e->to->position || e->to->velocity || e->to->spin || e->to->frozen);
}

/* Sphere i and its clump with the changes of entry `at`. */
int dem_edit_set_clump(const struct dem *, const struct dem_edit *, int64_t at, size_t i, struct dem_particle *,
                       struct dem_clump *);

/* Collective. Check that the run has all particles of the list, and that a clump is named by its first sphere to be
   moved, by all spheres to be removed. `status`: of the checks of this rank. */
int dem_edit_require_present(struct dem *, const struct dem_edit *, int status);

/* Collective. Make the edit, unless n is 0; frees the list. `status`: as above. */
int dem_edit_make(struct dem *, struct dem_edit *, int status);
