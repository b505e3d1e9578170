/*
 * warning_list.h -- the list of warnings while it is written, and the warnings of its parts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "advisor/plan.h"
#include "advisor/regime.h"

struct dem_warning_list
{
    struct dem_text *t;
    const struct dem_plan *p;
    struct dem_regime regime;
    int n;
    double step_cost;            /* s  of a particle and step; 0: not known */
    int measured;
};

/* Begin an item with its number. */
void dem_warning_begin(struct dem_warning_list *);

/* An item for each line. */
void dem_warning_lines(struct dem_warning_list *, const char *lines);

/* 1 when there are particles, or will be. */
int dem_warning_has_particles(const struct dem_warning_list *);

/* Collective at its first call. Sets the processor time of a particle and step. */
int dem_warning_measure_step(struct dem_warning_list *);

/* ", 3 h of processor time" for that many steps. */
void dem_warning_add_time(struct dem_warning_list *, double steps);

/* m/s: largest speed of the fluid, inside or on a patch. */
double dem_warning_fluid_speed(const struct dem_warning_list *);

/* of a fluid (warnings_fluid.c) */
void dem_warning_of_drag(struct dem_warning_list *);
void dem_warning_of_crossing(struct dem_warning_list *);
void dem_warning_of_cells(struct dem_warning_list *);
int dem_warning_of_window(struct dem_warning_list *);
