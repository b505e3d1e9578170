/*
 * accuracy.h -- the entry `accuracy` of a scene: the largest error allowed, and the time step found
 * for it.
 *
 *     accuracy { target 0.01; budget 60; }    `dem run` searches first, for at most 60 s
 *     accuracy { target 0.01; reached 0.0054; of kinetic; window 0.01; step 1.2e-6; }
 *                                             found by `dem cost -target`, see suna_cost/target.py
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "input/dictionary.h"

struct dem_program;
struct dem_request;

struct dem_accuracy
{
    double target;        /* 1  relative error; 0: no wish */
    double budget;        /* s  of the search */
    double reached;       /* 1  error + uncertainty of `of`; 0: not searched yet */
    double window, step;  /* s  of the search */
    char of[32];          /*    the worst quantity */
};

/* Read the entry, if the scene has it. */
int dem_accuracy_read(struct dem_accuracy *, const struct dem_dict *scene);

/* If the scene has a wish and no result, start the search in place of this program; it runs the
   scene at its end. Returns only if there is nothing to search, or with an error. */
int dem_accuracy_search(const struct dem_accuracy *, const struct dem_program *,
                        const struct dem_request *);

/* Print whether the wish was met by a run with this step [s]. */
void dem_accuracy_print(const struct dem_accuracy *, double step);
