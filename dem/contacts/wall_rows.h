/*
 * wall_rows.h -- the contact rows of wall neighbors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contacts.h"
#include "laws/interaction_table.h"
#include "walls/wall_touch.h"

/* Assign the contact rows; after every prune. */
void dem_wall_touches_set_rows(struct dem_wall_touches *, const struct dem_wall_search *,
                               const struct dem_contacts *, const struct dem_interaction_table *);
