/*
 * snapshot_layout.c -- sizes and offsets of the parts of a snapshot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/snapshot_header.h"

size_t dem_snapshot_particle_doubles(const struct dem_snapshot_header *h)
{
    size_t size = DEM_SNAPSHOT_RECORD;

    for (int64_t c = 0; c < h->columns; c++)
    {
        size += (size_t)h->list[h->materials + c].width;
    }
    return size;
}

size_t dem_snapshot_contact_doubles(const struct dem_snapshot_header *h)
{
    return DEM_SNAPSHOT_CONTACT + (size_t)h->memories;
}

size_t dem_snapshot_contacts_offset(const struct dem_snapshot_header *h)
{
    return sizeof *h + (size_t)h->particles*dem_snapshot_particle_doubles(h)*sizeof(double);
}

size_t dem_snapshot_caller_data_offset(const struct dem_snapshot_header *h)
{
    return dem_snapshot_contacts_offset(h) +
           (size_t)h->rows*dem_snapshot_contact_doubles(h)*sizeof(double);
}
