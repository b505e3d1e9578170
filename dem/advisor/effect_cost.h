/*
 * effect_cost.h -- cost of one effect: processor time and bytes with and without it.
 *
 * The two blocks (sample_block.h) run in alternation, 10 steps each. The result is the fastest
 * measurement of each, because other load on the machine can only make a measurement longer. The
 * block is at rest and each sphere touches 8 others: an effect that costs more where particles move
 * is more expensive than reported.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_ADVISOR_EFFECT_COST_H
#define DEM_ADVISOR_EFFECT_COST_H

#include "core/text.h"
#include "records/inventory.h"
#include "laws/effect.h"
#include "ranks/dem_state.h"

struct dem;

struct dem_effect_cost
{
    /* s  processor time per particle and step */
    double with, without;
    /* bytes of each, with the effect (dem_memory_need_count) */
    double particle, pair, row;
};

enum
{
    /* contacts per particle of the block, each counted once */
    DEM_EFFECT_COST_CONTACTS = 4
};

/* Measures for `seconds` of processor time. effect NULL: both blocks are the scene as it is, and
   their difference is the uncertainty of the measurement. Returns DEM_OK or an error. */
int dem_effect_cost_measure(const struct dem_state *, const struct dem_inventory *, double dt,
                            const char *effect, double seconds, struct dem_effect_cost *);

/* The same for a scene that is ready (dem_setup). On one rank. */
int dem_effect_cost(struct dem *, const char *effect, double seconds, struct dem_effect_cost *);

/* Append the heading of the table, with a row of the bed compared with itself; the row of an
   effect, measured for `seconds` of processor time in a bed that has what it requires. */
int dem_effect_cost_heading(struct dem_text *, double seconds);
int dem_effect_cost_row(struct dem_text *, const struct dem_effect *, double seconds);

#endif
