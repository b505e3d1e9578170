/*
 * spring_kinds.c -- which history columns are vectors, numbers, or stay with their facet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "walls/spring_kinds.h"
#include "laws/effect.h"
#include "laws/interaction_table.h"
#include <string.h>

static int is_vector(const struct dem_interaction_table *r, int m)
{
    const size_t length = strlen(r->history_name[m]);

    return m + 2 < r->history_columns && length > 2 &&
           strcmp(r->history_name[m] + length - 2, "_x") == 0;
}

void dem_spring_kinds(const struct dem_interaction_table *r, enum dem_spring_kind *column)
{
    for (int m = 0; m < r->history_columns; m++)
    {
        column[m] = is_vector(r, m) ? DEM_SPRING_VECTOR : DEM_SPRING_NUMBER;
        column[m] = m > 0 && column[m - 1] == DEM_SPRING_VECTOR ? DEM_SPRING_REST : column[m];
        column[m] = m > 1 && column[m - 2] == DEM_SPRING_VECTOR ? DEM_SPRING_REST : column[m];
    }
    for (int s = 0; s < r->classes; s++)
    {
        for (int k = 0; k < r->list[s].entries; k++)
        {
            const struct dem_effect_entry *const entry = &r->list[s].entry[k];

            for (int m = 0; m < dem_effect_history_columns(entry->effect) &&
                            entry->effect->stage >= DEM_STAGE_BOND;
                 m++)
            {
                column[entry->first_column + m] = DEM_SPRING_OWN;
            }
        }
    }
}
