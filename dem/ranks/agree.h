/*
 * agree.h -- agreement of all ranks: the maximum of numbers, and failure of all when one has
 * failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

enum
{
    DEM_AGREE_LIMIT = DEM_UNAGREED_STEPS + 1  /* limit of n */
};

/* Collective. Each of n numbers becomes the maximum of all ranks. When a rank has failed (status
   not DEM_OK), or has recorded an error of MPI (ranks/collect.h), all return its status and have its error text. */
int dem_agree_max(struct dem_state *, int status, double *value, int n);

/* Forget the steps since the last agreement: after one, or when the state is restored. */
void dem_unagreed_reset(struct dem_unagreed *);

/* Keep the first error of this rank until the ranks agree; returns it, with its text. */
int dem_unagreed_keep_error(struct dem_unagreed *, int status);

/* Collective. The same without numbers. */
int dem_agree(struct dem_state *, int status);
