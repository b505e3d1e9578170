/*
 * ghosts.cl -- with several ranks: what each step sends of particles that other ranks have as ghosts, and
 * receives for the ghosts here, in the order of ranks/halo_refresh.c: position, velocity, spin, columns.
 *
 * The host defines dem_ghost_column[1] to dem_ghost_column[GHOST_COLUMNS], where these columns are.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define GHOST_WIDTH (9 + GHOST_COLUMNS)    /* DEM_HALO_WIDTH and columns */

/* The last number is the largest speed^2 of the step, infinite after an event, for all ranks to leave the
   device together. */
kernel void ghosts_pack(constant struct dem_device_batch *b, global const struct dem_device_report *report,
                        uint s, uint sent, global const double4 *restrict record,
                        global const double *restrict columns, global const uint *restrict index,
                        global double *restrict to)
{
    const uint k = get_global_id(0);
    global double *const own = to + (size_t)k*GHOST_WIDTH;

    for (uint m = 0; k < sent && m < 3; m++)
    {
        vstore3(record[4*(size_t)index[k] + m].xyz, m, own);
    }
    for (uint m = 0; k < sent && m < GHOST_COLUMNS; m++)
    {
        own[9 + m] = columns[(size_t)dem_ghost_column[1 + m]*b->column + index[k]];
    }
    if (k == sent)
    {
        const float fastest = report->fastest[s];

        own[0] = report->events || !(fastest < INFINITY) ? INFINITY : fastest;
    }
}

kernel void ghosts_unpack(constant struct dem_device_batch *b, uint received,
                          global double4 *restrict record, global double *restrict columns,
                          global const uint *restrict index, global const double *restrict from)
{
    const uint k = get_global_id(0);

    if (k < received)
    {
        const size_t i = b->particles + index[k];
        global const double *const own = from + (size_t)k*GHOST_WIDTH;

        for (uint m = 0; m < 3; m++)
        {
            record[4*i + m] = (double4)(vload3(m, own), record[4*i + m].w);
        }
        for (uint m = 0; m < GHOST_COLUMNS; m++)
        {
            columns[(size_t)dem_ghost_column[1 + m]*b->column + i] = own[9 + m];
        }
    }
}
