/*
 * load_balance.h -- decides from counted work when a new domain decomposition pays; never from a
 * clock, so that a run can be repeated.
 *
 * All ranks wait for the one with the largest work: a step loses (largest - mean) work per rank.
 * The loss just after a decomposition is what it could not balance. The loss in excess of that is
 * summed, and when the sum exceeds the cost of a decomposition, the domain is divided again at the
 * next rebuild of lists. Subdomains get equal work; a particle weighs as much as its own work and
 * half of the work of its rows.
 *
 * Criterion after Menon et al., "Automated load balancing invocation based on application
 * characteristics", IEEE CLUSTER 2012.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/decomposition.h"
#include "contacts/contacts.h"

struct dem_load_balance
{
    int64_t work, steps;          /* of this rank since the last rebuild */
    double base, lost;            /* loss per step just after the decomposition; summed excess
                                     since; both over the mean work of a step */
    int fresh;                    /* 1: the decomposition is new, `base` not known yet */
    int cuts;                     /* number of decompositions so far */
    uint32_t *weight;             /* of each owned particle, during a decomposition */
    size_t weight_capacity;
};

void dem_load_balance_free(struct dem_load_balance *);

/* Count the work of one step. */
void dem_load_balance_count(struct dem_load_balance *, size_t particles,
                            const struct dem_contacts *);

/* Collective, before a rebuild of lists. 1 when a new decomposition pays; the counters then start
   again. */
int dem_load_balance_pays(struct dem_load_balance *, const struct dem_decomposition *);

/* Set the weights of the owned particles from the present lists; keep the weights of particles order[0 ..
   count) when the others are removed. */
int dem_load_balance_set_weights(struct dem_load_balance *, const struct dem_particles *,
                                 const struct dem_contacts *);
void dem_load_balance_keep_weights(struct dem_load_balance *, const uint32_t *order, size_t count);
