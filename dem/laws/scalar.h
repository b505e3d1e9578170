/*
 * scalar.h -- particle scalars: numbers per particle, besides the record's, that effects declare:
 * temperature, volume of liquid, ...
 *
 * A row is a constant that effects list by its address; effects that list the same row share the
 * scalar. From the row follow storage, sorting, ghosts, migration, backup, snapshots, the entries
 * of scenes (insertion, streams, walls, start), output, means on grids and the calls dem_scalar of
 * dem.h. A scene whose effects list none has none.
 *
 * A scalar with a rate obeys, over a time step h,
 *
 *     C ds/dt = q + B (s* - s)       s' = s + phi(z) h/C (q + B (s* - s)),   z = B h/C
 *
 *   s    the scalar                                                 [unit]
 *   q    sum of what contacts, bodies and the program add           [unit C/s]
 *   B    sum of exchange coefficients of bodies and the program     [C/s]
 *   s*   their target, mean weighted by the coefficients            [unit]
 *   C    capacity, of the row: 1, or mass times a property of the material
 *
 * which is exact for q, B and s* that are constant over the step: s tends to s* and never past it.
 * phi(z) = (1 - exp(-z))/z. Rates of contacts are explicit, s at the start of the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include <stddef.h>

enum
{
    DEM_SCALARS = 12,           /* limit of a scene */
    DEM_SCALAR_COLUMNS = 10     /* columns of an exchange, enum dem_scalar_column */
};

enum dem_scalar_flag
{
    DEM_SCALAR_PARTNERS = 1,    /* contact effects read it: contact batches have the values of both
                                   partners, and ghosts have it */
    DEM_SCALAR_RATE = 2,        /* effects change it: rates are summed and integrated in each step */
    DEM_SCALAR_WRITTEN = 4,     /* it is written with the particles (VTK, CSV), and averaged on grids */
    DEM_SCALAR_AMOUNT = 8,      /* an amount: a wall has no value of it, a flux only */
    DEM_SCALAR_HEAT = 16        /* C ds is energy [J]: the energy balance counts it; one in a scene */
};

/* Per particle, of a scalar that is exchanged with a fluid or with the program. Over a window: */
enum dem_scalar_column
{
    DEM_SCALAR_SOURCE,        /* in   unit C/s  explicit source */
    DEM_SCALAR_COEFFICIENT,   /* in   C/s       coefficient, besides the effects', */
    DEM_SCALAR_TARGET,        /* in   unit      and its target */
    DEM_SCALAR_RECEIVED,      /* out  unit C    by all coefficients, J of the window */
    DEM_SCALAR_TIME,          /* out  C         sum of B h */
    DEM_SCALAR_TARGET_TIME,      /* out  unit C    sum of B s* h */
    DEM_SCALAR_DECAY,         /* out  1         product of exp(-B h/C) */
    DEM_SCALAR_START,         /* out  unit      the scalar at the start of the window */
    DEM_SCALAR_RESPONSE,      /* out  C         R = dJ/ds*, bounded by TIME */
    DEM_SCALAR_CARRIED_OVER   /* in   unit C    to be added evenly over the window */
};

/* Their names on disk, for the member `exchange` of a row: name is a string literal. */
#define DEM_SCALAR_EXCHANGE_NAMES(name) \
    {name "Source", name "Coefficient", name "Target", name "Received", name "CoefficientTime", \
     name "TargetTime", name "Decay", name "Start", name "Response", name "CarriedOver"}

struct dem_material;

/* The columns of batches that a scalar fills, at these offsets; 0: none. */
struct dem_scalar_batch
{
    /* in struct dem_contact_batch: mean of both partners, value of the particle at a wall; 0 in the
       first evaluation of a run */
    size_t contact;
    /* enum dem_needs: of the contact effects that read it */
    unsigned contact_needs;
    /* in struct dem_body_batch, with DEM_NEEDS_FLUID */
    size_t body;
};

struct dem_scalar               /* a row */
{
    /* word of scenes, and of the column in files and snapshots */
    const char *name;
    const char *unit;
    /* of particles without an own; DEM_SETTING_REQUIRED: none */
    double default_value;
    /* limits, inclusive, of the input and of the run; DEM_ABOVE_ZERO as min excludes zero */
    double min, max;
    const char *help;
    /* enum dem_scalar_flag, or-ed */
    unsigned flags;
    /* C per mass; NULL: C is 1 */
    double (*capacity)(const struct dem_material *);
    /* the entry of materials that gives it */
    const char *capacity_entry;
    /* names of the columns of an exchange; NULL: it has none */
    const char *const *exchange;
    /* a value of the fluid at the particle: the entry of `fluid` that gives it, else the coupled
       program writes it; 0: not yet given. NULL: a value of the particle */
    const char *fluid_entry;
    /* laws read it there, not in `scalars` of the batch: a value of the fluid with a place in the
       usual batch. Such rows are not in the lists of effects, and have no rate */
    struct dem_scalar_batch batch;
};

/* A scalar of an effect at the rows of a contact batch, seen as forces are: j is the higher id or
   the wall. The scene gives the value of a wall; a wall without a given value has the value of the
   particle, so that differences vanish. */
struct dem_scalar_rows
{
    /* unit  values of the partners */
    const double *i, *j;
    /* unit C/s what each receives, to be added to */
    double *rate_i, *rate_j;
    /* m  of the partners; of the particle for both at a wall (with DEM_NEEDS_RADII) */
    const double *radius_i, *radius_j;
};

/* A scalar of an effect at the rows of a body batch. */
struct dem_scalar_bodies
{
    const double *value;          /* unit */
    double *rate;                 /* unit C/s  to be added to, likewise: */
    double *coefficient;          /* C/s       B, >= 0 */
    double *to_target;            /* unit C/s  B s* */
};
