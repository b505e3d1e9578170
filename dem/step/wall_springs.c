/*
 * wall_springs.c -- one pass over the particles with several wall contacts: group these by surface,
 * divide their friction springs, transfer other history.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/wall_springs.h"
#include "walls/spring_kinds.h"

struct dem_spring_rows
{
    struct dem_contact_history *history;
    const enum dem_spring_kind *kind;
    int columns;
};

static enum dem_spring_kind dem_spring_kind(const struct dem_spring_rows *h, int m)
{
    return h->kind[m];
}

static double dem_spring_get(const struct dem_spring_rows *h, int m, uint32_t row)
{
    return h->history->column[m][row];
}

static void dem_spring_put(const struct dem_spring_rows *h, int m, uint32_t row, double value)
{
    h->history->column[m][row] = value;
}

static int dem_spring_any(const struct dem_spring_rows *h, uint32_t row)
{
    return dem_contact_history_any(h->history, row);
}

#include "walls/facet_springs.h"

_Static_assert(DEM_SPRINGS_NONE == DEM_ROW_NONE, "both say that a contact has no row");

void dem_wall_springs_redistribute(struct dem_state *state)
{
    const struct dem_wall_search *const s = &state->pairs.wall_search;
    enum dem_spring_kind column[DEM_HISTORY_COLUMNS];
    const struct dem_spring_rows rows = {.history = &state->contacts.history, .kind = column,
                                         .columns = state->contacts.history.columns};

    if (state->contacts.history.columns == 0 || state->touches.shared == 0)
    {
        return;
    }
    dem_spring_kinds(&state->interaction_table, column);
    for (size_t k = 0; k < state->touches.shared; k++)
    {
        const size_t first = state->touches.shared_first[k];
        size_t end = first + 1;

        while (end < s->neighbors && s->neighbor[end].particle == s->neighbor[first].particle)
        {
            end++;
        }
        dem_springs_redistribute(&(struct dem_facet_springs){
            .rows = &rows, .touch = state->touches.touch, .first = first, .end = end,
            .radius = state->particles.record[s->neighbor[first].particle].radius});
    }
}
