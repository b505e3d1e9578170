/*
 * marginal.h -- what one effect takes: the block of sample.h with it and without.
 *
 * The two take turns of 10 steps; told is the quickest turn of each, which what else runs on the machine can only make longer. A block at rest,
 * in which each sphere touches 8: an effect that costs more where particles move is dearer than told.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_MARGINAL_H
#define DEM_PLAN_MARGINAL_H

#include "step/parts.h"
#include "step/survey.h"

struct dem;

struct dem_marginal
{
    double with, without;                                 /* s of processor time a particle and step */
    double particle, pair, row;                           /* bytes of each, with it (dem_need_count) */
};

enum
{
    DEM_MARGINAL_CONTACTS = 4                             /* a particle of the block, each shared by two */
};

/* For `seconds` of processor time. Without an effect (NULL) both are the scene as it is: they differ by what can't be told apart. */
int dem_marginal_take(const struct dem_parts *, const struct dem_survey *, double dt, const char *effect, double seconds, struct dem_marginal *);

/* The same of a scene that is ready. On one rank. */
int dem_marginal(struct dem *, const char *effect, double seconds, struct dem_marginal *);

#endif
