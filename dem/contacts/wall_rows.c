/*
 * wall_rows.c -- find the contact row of each wall neighbor, and list the neighbors that have one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/wall_rows.h"
#include <float.h>

void dem_wall_touches_set_rows(struct dem_wall_touches *t, const struct dem_wall_search *s,
                               const struct dem_contacts *c, const struct dem_interaction_table *laws)
{
    for (size_t k = 0; k < s->neighbors; k++)
    {
        t->touch[k].row = DEM_ROW_NONE;
    }
    for (uint32_t r = 0; r < c->rows.n && s->neighbors > 0; r++)
    {
        const struct dem_pair *const q =
            c->rows.pair[r] == DEM_ROW_NONE ? NULL : dem_contacts_pair(c, r);

        if (q && q->wall)
        {
            t->touch[q->j].row = r;
            t->touch[q->j].exponent = laws->list[q->class].pair.exponent;
        }
    }
    t->listed = 0;
    for (size_t k = 0; k < s->neighbors; k++)
    {
        if (t->touch[k].row != DEM_ROW_NONE)
        {
            t->list[t->listed++] = (uint32_t)k;
        }
        t->touch[k].distance = DBL_MAX;
        t->touch[k].drop = 0;
    }
}
