/*
 * main_quiet.h -- time/untilQuiet: a run ends when next to nothing has moved for long enough.
 *
 *     untilQuiet { lasting 0.01; kinetic 1e-6; moving 0.01; }
 *
 * Quiet means: no more than the share `moving` of the particles have more kinetic energy than `kinetic` times what falling
 * by the mean diameter would give the mean one (or than a particle of the mean mass at `speed`). It is a share, and no mean,
 * because a few beads may roll on for ever: nothing stops them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MAIN_QUIET_H
#define DEM_MAIN_QUIET_H

#include "dem.h"
#include "io/dictionary.h"
#include "main.h"

struct dem_quiet
{
    int wanted;
    double kinetic;                                       /* 1    of the energy of falling by a diameter */
    double speed;                                         /* m/s  in place of it; 0: kinetic counts */
    double lasting;                                       /* s */
    double moving;                                        /* 1 */

    double since;                                         /* s    quiet from then on; infinite: it is not */
    int64_t move;                                         /* who moves at the last look */
    int reached;
};

/* Reads time/untilQuiet, where there is one; `check` when gravity is known [m/s2]. */
int dem_quiet_read(struct dem_quiet *, const struct dem_dict *time);
int dem_quiet_check(const struct dem_quiet *, const double gravity[3]);

/* How often to look between two outputs: five times or more in `lasting`. */
int64_t dem_quiet_looks(const struct dem_quiet *, double interval);

/* Collective. One look; sets `reached`. */
int dem_quiet_look(struct dem_quiet *, struct dem *, const struct dem_tally *);

void dem_quiet_tell(const struct dem_quiet *, const struct dem_program *, const struct dem_tally *);

#endif
