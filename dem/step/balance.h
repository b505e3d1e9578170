/*
 * balance.h -- when it pays to cut space anew among ranks, from counted work: never from the clock, so that a run can be repeated.
 *
 * All ranks wait for the one with most to do: a step loses (largest - mean) work of a rank. What the cut itself could not even out is
 * what is lost just after it; what is lost beyond that adds up, and when it exceeds the price of a new cut, space is cut at the next
 * renewal of lists. Pieces get equal work, a particle weighs as what it and half of its rows do. Criterion after Menon et al.,
 * "Automated load balancing invocation based on application characteristics", IEEE CLUSTER 2012.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_BALANCE_H
#define DEM_STEP_BALANCE_H

#include "space/pieces.h"
#include "state/contacts.h"

struct dem_balance
{
    int64_t work, steps;                                  /* done by this rank since the last renewal, steps in it */
    double base, lost;                                    /* per step after the cut; beyond that since, both over mean work of a step */
    int fresh;                                            /* 1: the pieces are new, their base not yet known */
    int cuts;                                             /* so far */
    uint32_t *weight;                                     /* of each owned particle, while cutting */
    size_t weight_room;
};

void dem_balance_free(struct dem_balance *);

/* A step has been made. */
void dem_balance_count(struct dem_balance *, size_t particles, const struct dem_contacts *);

/* Collective, before lists are renewed. 1 when a new cut pays; all begins anew then. */
int dem_balance_pays(struct dem_balance *, const struct dem_pieces *);

/* The weights of the owned particles from the present lists; those that stay when others are taken out. */
int dem_balance_weigh(struct dem_balance *, const struct dem_particles *, const struct dem_contacts *);
void dem_balance_keep(struct dem_balance *, const uint32_t *order, size_t count);

#endif
