/*
 * agree.h -- what all ranks know: the largest numbers of any of them, and whether one has failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_AGREE_H
#define DEM_STEP_AGREE_H

#include "step/parts.h"

enum
{
    DEM_AGREE_MOST = 8                                    /* numbers at a time */
};

/* Collective. Each of n numbers becomes the largest of all ranks. Where one has failed, all fail with its sentence. */
int dem_agree_most(struct dem_parts *, int status, double *value, int n);

/* Collective. The same without numbers. */
int dem_agree(struct dem_parts *, int status);

#endif
