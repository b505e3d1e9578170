/*
 * drift.h -- how far particles have come since a list of neighbours was made, apart from the way that all have gone together.
 *
 *   d_i = x_i(now) - x_i(then)        c: any vector that all ranks agree on        s = max |d_i - c|
 *
 * Two particles have come nearer to each other by at most 2 s, a particle and a wall by s + |w - c|, w the way of the wall (across it):
 * a list that holds all pairs up to a skin holds until one of these exceeds it. The middle between the largest and the smallest d_i
 * along each axis makes s about as small as it can be: zero for a bed that moves as a whole, half of the way where one flies
 * and the others rest. Along an axis with a limit to leave by c is zero, or who leaves would not be seen.
 *
 * Places are kept as whole units, modulo 2^32, of less than 1e-4 of the skin: 12 bytes a particle, good for any distance from the
 * origin up to 2^35 skins.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_SPACE_DRIFT_H
#define DEM_SPACE_DRIFT_H

#include "state/particles.h"

enum
{
    DEM_DRIFT_NUMBERS = 7                                 /* of one look: largest and smallest way along each axis, longest way */
};

struct dem_drift
{
    double skin;                                          /* m */
    double spread;                                        /* m: s, or more; the largest speed times dt is added in each step */
    double centre[3];                                     /* m: c */
    double unit, round;                                   /* m; (x + round) is x in whole units, in its lowest 32 bits */
    uint32_t *then;                                       /* 3 an owned particle */
    size_t room;
};

void dem_drift_free(struct dem_drift *);
size_t dem_drift_bytes(const struct dem_drift *);

/* Particles are here now; the list that is made now has this skin [m]. */
int dem_drift_begin(struct dem_drift *, const struct dem_particles *, double skin);

/* max d, max -d by axis, max |d| [m] of this rank's particles: to be made the largest of all ranks. */
void dem_drift_look(const struct dem_drift *, const struct dem_particles *, double most[DEM_DRIFT_NUMBERS]);

/* Take from the largest of all ranks what they say with c = 0. Returns 1 when another c may do better: `centre`, zero where not `free`. */
int dem_drift_take(struct dem_drift *, const double most[DEM_DRIFT_NUMBERS], const int free[3], double centre[3]);

/* max |d - c| [m] of this rank's particles. */
double dem_drift_spread(const struct dem_drift *, const struct dem_particles *, const double centre[3]);

/* So: the list is good as far as these say. */
void dem_drift_settle(struct dem_drift *, double spread, const double centre[3]);

#endif
