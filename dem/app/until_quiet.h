/*
 * until_quiet.h -- time/untilQuiet: end the run when the particles have been at rest for long
 * enough.
 *
 *     untilQuiet { lasting 0.01; kinetic 1e-6; moving 0.01; }
 *
 * At rest: no more than the fraction `moving` of the particles have more kinetic energy than
 * `kinetic` times the mean energy of falling by the mean diameter (or than a particle of the mean
 * mass at `speed`). It is a fraction and not a mean, because without rolling resistance a few
 * spheres may roll for ever.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_APP_UNTIL_QUIET_H
#define DEM_APP_UNTIL_QUIET_H

#include "dem.h"
#include "input/dictionary.h"
#include "app/main.h"

struct dem_quiet
{
    int wanted;
    double kinetic;  /* 1  limit, of the energy of falling by a diameter */
    double speed;    /* m/s  limit instead of kinetic; 0: kinetic counts */
    double lasting;  /* s */
    double moving;   /* 1  fraction of the particles that may still move */

    double since;    /* s  at rest since; infinite: not at rest */
    int64_t move;    /* particles that moved at the last test */
    int reached;     /* 1: at rest for `lasting` */
};

/* dem_quiet_read: read time/untilQuiet, if there is one. dem_quiet_check: refuse it without
   gravity [m/s2] or speed. */
int dem_quiet_read(struct dem_quiet *, const struct dem_dict *time);
int dem_quiet_check(const struct dem_quiet *, const double gravity[3]);

/* The number of tests between two outputs: five or more in `lasting`. */
int64_t dem_quiet_tests(const struct dem_quiet *, double interval);

/* Collective. Test once, with the present totals; sets `reached`. */
int dem_quiet_test(struct dem_quiet *, struct dem *, const struct dem_totals *);

/* Print, on the first rank, whether the particles are at rest. */
void dem_quiet_print(const struct dem_quiet *, const struct dem_program *,
                     const struct dem_totals *);

#endif
