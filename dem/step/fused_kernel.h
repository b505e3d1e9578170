/*
 * fused_kernel.h -- the most common combination of laws between particles (hertz, dry, mindlin) in
 * four fused loops.
 *
 * The operations are those of the effects' own loops on a row, in the same order: in double
 * precision the results have the same bits. Relative motion, hertz and dry share one loop; the end
 * of mindlin and the contact force share another. Their intermediate results need no columns, and
 * none have to be cleared.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_FUSED_KERNEL_H
#define DEM_STEP_FUSED_KERNEL_H

#include "effects/contact/mindlin.h"
#include "model/contacts.h"
#include "model/contact_batch.h"

enum    /* positions in the effect list of the class */
{
    DEM_FUSED_NORMAL,
    DEM_FUSED_DAMPING,
    DEM_FUSED_FRICTION,
    DEM_FUSED_EFFECTS
};

struct dem_fused_constants    /* the constants of the three laws, from their settings */
{
    double modulus, alpha, min_force, shear;
    const struct dem_mindlin *mindlin;
    double check_overlap;  /* 1  overlaps above this fraction of the smaller radius are checked */
};

/* 1 when the effect list of a class consists of these three laws and nothing else. */
int dem_fused_kernel_applies(const struct dem_effect_list *);

/* `max_overlap`: largest overlap so far, as a fraction of the smaller diameter; smaller ones need
   no check. */
struct dem_fused_constants dem_fused_kernel_constants(const struct dem_effect_list *,
                                                      double max_overlap);

/* After dem_contact_batch_gather: evaluate the laws for all lanes of the batch and store their
   contact forces. `history`: the history columns of mindlin at the rows of the batch. Returns 1
   when a row may overlap by more than the largest overlap so far, or a force is not a number; the
   batch then holds overlap and forces for the limits check. */
int dem_fused_kernel_run(const struct dem_fused_constants *, struct dem_contact_batch *,
                         const struct dem_gathered *, double *const *history,
                         struct dem_contact_force *);

#endif
