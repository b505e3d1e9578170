/*
 * skins.h -- how thick the skins of the lists should be, from counted work and from how fast particles move; never from a clock.
 *
 * A near row costs 1 in each step, a prune and a renewal cost what is counted below. With skins s (inner) and S (outer) [m], R rows at
 * no skin and k more for each meter of it, and particles that come u (since the prune) and U (since the renewal) meters a step apart from
 * what all go together, v with it (how soon the bound runs out and positions are looked at):
 *
 *   work a step = R + k s + (2 v/s) look n + (2 u/s) prune (R + k S) + (2 U/S) (renew n + pair (R + k S))
 *
 * is least at  s^2 = 2 (v look n + u prune (R + k S))/k,  S^2 = (U/u) (renew n + pair R) s/(prune k).  All numbers are sums or maxima over ranks, so the
 * same skins are chosen on any number of ranks; and whatever they are, results are the same.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_SKINS_H
#define DEM_SPACE_SKINS_H

#include "state/walls.h"

struct dem_skins
{
    int tuned;                                            /* 0: they stay as they are */
    double least, most;                                   /* m */
    double skin[DEM_LISTS];                               /* m: for the next list */
    double rate[DEM_LISTS];                               /* m a step; below 0: not known yet */
    double pace;                                          /* m a step: of the fastest */
    int64_t steps[DEM_LISTS];                             /* since the list was made */
    int64_t look;                                         /* steps after which a list that has not been renewed is looked at */
    double in_use[DEM_LISTS];                             /* m: of the lists as they are */
    int64_t counted[3];                                   /* particles, pairs, near rows of all ranks, at the last renewal */
    double wide[DEM_LISTS];                               /* m: the skins then */
};

/* Fixed at skin[0], skin[1] [m], or tuned between `least` and `most`, beginning with them. */
void dem_skins_init(struct dem_skins *, const double skin[DEM_LISTS], int tuned, double least, double most);

/* 1 when all of it is what a run may have come to: skins between 0 and the most, numbers finite, counts that have room to grow. */
int dem_skins_are_sound(const struct dem_skins *);

/* A list has been made with its next skin; both have, with so many particles, pairs and rows. */
void dem_skins_made(struct dem_skins *, enum dem_list);
void dem_skins_count(struct dem_skins *, const int64_t counted[3]);

/* One more step, in which nobody went further than `fastest` [m]. Returns 1 when it is time to look whether the lists of a bed that has become calm have skins too thick. */
int dem_skins_step(struct dem_skins *, double fastest);

/* Particles have come `way` [m] since this list was made: choose. */
void dem_skins_choose(struct dem_skins *, enum dem_list, double way);

/* 1 when the skin chosen is so much thinner than the one in use that it pays to make the list anew. */
int dem_skins_pays(const struct dem_skins *, enum dem_list);

#endif
