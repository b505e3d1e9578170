/*
 * contact_batch.h -- a contact batch: up to 64 contact rows as columns, and the gathered data of
 * their partners.
 *
 * A candidate contact is a pair within the inner skin; it has one contact row, that is one history
 * and one contact force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/gathered.h"
#include "laws/batch.h"

struct dem_contact_scalars;

enum
{
    DEM_LANES = 8  /* the number of rows is padded to a multiple of this */
};

/* the columns that effects work on, and what they are computed from */
struct dem_contact_workspace
{
    struct dem_contact_batch batch;
    struct dem_gathered gathered;
    struct dem_contact_scalars *scalars;    /* step/contact_scalars.h, of the batch; NULL: none */
};
