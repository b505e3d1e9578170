/*
 * residence.h -- how long particles have been in the domain when outlets remove them: mean, variance and a
 * histogram for each outlet that asks for it.
 *
 *     outlets { drain { point; normal; residence 20; } }      64 bins up to 20 s
 *
 * Each particle has the time of its entry in the column DEM_COLUMN_BIRTH, 0 for initial ones; the column
 * exists only in scenes with such an outlet. Sums are made by all ranks alike, in the order of ids.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "dem_types.h"

struct dem_state;
struct dem_flows;
struct dem_text;

/* Memory for the outlets that ask, once flows have begun; `text` of the scene in a snapshot: go on from its
   sums. */
int dem_residence_begin(struct dem_state *, const char *text);
void dem_residence_free(struct dem_flows *);

/* The last departure that was recorded is of particle i: its age. */
void dem_residence_record(struct dem_state *, size_t i);

/* Add a departure. */
void dem_residence_add(struct dem_flows *, int flow, double age);

/* The sums of a flow; NULL: it does not ask. */
const struct dem_residence *dem_residence_of(const struct dem_flows *, int flow);

void dem_residence_backup(struct dem_flows *);
void dem_residence_restore(struct dem_flows *);

/* Lines with @ of the text of the scene in a snapshot. */
void dem_residence_describe(const struct dem_flows *, struct dem_text *);
