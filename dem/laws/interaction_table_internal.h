/*
 * interaction_table_internal.h -- settings for one pair of materials only, internal to
 * interaction_table*.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/interaction_table.h"

struct dem_override                                       /* a setting for one pair of materials */
{
    const struct dem_effect *effect;
    int pair[2], count;
    char entry[48], word[48], where[160];  /* word: empty when the setting is a number */
    double values[3];
};

/* Apply the setting to a copy of the settings of its effect. */
int dem_override_apply(const struct dem_override *, void *settings);
