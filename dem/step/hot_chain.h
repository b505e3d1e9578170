/*
 * hot_chain.h -- the commonest chain, hertz, dry and mindlin between particles, in four loops.
 *
 * The operations are those of the effects' own loops, on a row, in the same order: in double precision the bits are the same. Relative
 * motion, hertz and dry share a loop, and so do the last of mindlin and the push: their numbers need no columns, nor are any cleared.
 *
 * A run of mixed precision has its laws and forces in single precision here: only what positions say and what contacts remember
 * stays in double. Half of the bytes and twice the lanes.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_HOT_CHAIN_H
#define DEM_STEP_HOT_CHAIN_H

#include "effects/mindlin.h"
#include "state/contacts.h"
#include "step/gathered.h"

enum
{
    DEM_HOT_NORMAL,
    DEM_HOT_DAMPING,
    DEM_HOT_FRICTION,
    DEM_HOT_LINKS
};

struct dem_hot_laws                                       /* the numbers of the three, out of their settings */
{
    double modulus, alpha, least, shear;
    const struct dem_mindlin *mindlin;
    double looks;                                         /* an overlap of this share of the lesser radius is to be looked at */
};

struct dem_hot_rows                                       /* of the tray: how many, the step, and columns */
{
    int n;
    double dt;                                            /* s */
    double *least_radius, *overlap, *fn, *fx, *fy, *fz;   /* filled for who is to look */
};

/* 1 when these are the laws, and nothing else. */
int dem_hot_chain_is(const struct dem_chain *);

/* `worst`: an overlap of the lesser diameter that is no news. */
struct dem_hot_laws dem_hot_chain_laws(const struct dem_chain *, double worst);

/* After dem_tray_gather: the laws over the block's rows, and the push of every lane. `memory`: mindlin's columns at the tray's rows.
   1 when a row may overlap by more than the worst, or a force is not a number; overlap and forces are in the tray for that. */
int dem_hot_chain_act(const struct dem_hot_laws *, struct dem_block *, const struct dem_gathered *, double *const *memory,
                      struct dem_push *);

/* The same in single precision. */
int dem_hot_chain_act_single(const struct dem_hot_laws *, const struct dem_hot_rows *, const struct dem_gathered *,
                             double *const *memory, struct dem_push_single *);

#endif
