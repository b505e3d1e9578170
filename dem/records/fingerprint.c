/*
 * fingerprint.c -- hash id, position, velocity and spin of a particle; name and history of a
 * contact row.
 *
 * Adding +0.0 makes minus zero count as zero.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/fingerprint.h"
#include "core/hash.h"
#include <string.h>

uint64_t dem_fingerprint_particle(const struct dem_particle *r)
{
    double values[10];

    memcpy(values, &r->id, sizeof r->id);
    for (int k = 0; k < 3; k++)
    {
        values[1 + k] = r->x[k] + 0.0;
        values[4 + k] = r->v[k] + 0.0;
        values[7 + k] = r->w[k] + 0.0;
    }
    return dem_hash_record(values, sizeof values, 'p');
}

uint64_t dem_fingerprint_scalar(int64_t id, const char *name, double value)
{
    struct dem_hash hash;
    const double counted = value + 0.0;

    dem_hash_start(&hash, 's');
    dem_hash_bytes(&hash, &id, sizeof id);
    dem_hash_bytes(&hash, name, strlen(name));
    dem_hash_bytes(&hash, &counted, sizeof counted);
    return dem_hash_value(&hash);
}

uint64_t dem_fingerprint_contact(const struct dem_contact_key *name, const double *history,
                                 int columns)
{
    double values[3 + DEM_HISTORY_COLUMNS];
    const uint64_t image = name->image;

    memcpy(&values[0], &name->low, sizeof name->low);
    memcpy(&values[1], &name->high, sizeof name->high);
    memcpy(&values[2], &image, sizeof image);
    for (int m = 0; m < columns; m++)
    {
        values[3 + m] = history[m] + 0.0;
    }
    return dem_hash_record(values, (3 + (size_t)columns)*sizeof *values, 'r');
}
