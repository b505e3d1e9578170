/*
 * body_scalars.h -- particle scalars of a batch of particles: rates of contacts, effects and the
 * program, and their integration over a step (laws/scalar.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/sum.h"
#include "contacts/contacts.h"
#include "laws/interaction_table.h"
#include "particles/particles.h"

struct dem_body_scalars
{
    struct dem_scalar_bodies rows[DEM_EFFECT_SCALARS];    /* of the present effect */
    _Alignas(64) double value[DEM_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double rate[DEM_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double coefficient[DEM_SCALARS][DEM_BATCH_ROWS];
    _Alignas(64) double to_target[DEM_SCALARS][DEM_BATCH_ROWS];
};

/* a step over which scalars are integrated */
struct dem_scalar_step
{
    const struct dem_interaction_table *table;  /* NULL: the scene has no scalars */
    const struct dem_contacts *contacts;        /* with the rates of rows */
    double h;                                   /* s  0: effects read scalars, none is changed */
    double window;                              /* s  over which CARRIED_OVER is spread; 0: none */
    const struct dem_clump_heat *clump_heat;    /* clump_heat.h; NULL: none */
    struct dem_sum *heat;                       /* J  of what is not from contacts, of the scalar with
                                                   DEM_SCALAR_HEAT; NULL: not summed */
};

/* Sum of the rates of the contacts of a particle. */
double dem_body_scalars_contacts(const struct dem_contacts *, int scalar, size_t particle);

/* Gather the values of the particles [first, first + rows). With a step h > 0 rates begin with those
   of contacts and of the program; else they are not used. */
void dem_body_scalars_gather(struct dem_body_scalars *, const struct dem_scalar_step *,
                             const struct dem_particles *, size_t first, int rows);

/* Before an effect acts: let `scalars` of the batch be the scalars of its list. */
void dem_body_scalars_select(struct dem_body_scalars *, struct dem_body_batch *,
                             const struct dem_effect_entry *);

/* Integrate over the step, but for the spheres of clumps. Returns the number of values that are out of their range. */
int dem_body_scalars_integrate(const struct dem_body_scalars *, const struct dem_scalar_step *,
                               struct dem_particles *, size_t first, int rows);
