/*
 * stored_names.c -- table of names in the code and names in snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/stored_names.h"
#include <stddef.h>
#include <string.h>

static const struct
{
    const char *name, *stored;
} table[] =
{
    /* columns, particles/particles.c */
    {"slipFactor", "counterflow"},
    {"couplingIndex", "place"},
    {"decayFactor", "kept"},
    {"displacement", "way"},
    {"dragFraction", "passed"},
    {"carriedOverImpulse", "pending"},
    {"voidageFactorFirst", "swarmFirst"},
    {"voidageFactorSecond", "swarmSecond"},
    {"predictedAddedImpulse", "foreseen"},
    {"angularImpulse", "turnImpulse"},
};

enum
{
    ROWS = sizeof table/sizeof *table
};

const char *dem_stored_name(const char *name)
{
    for (size_t k = 0; k < ROWS; k++)
    {
        if (strcmp(table[k].name, name) == 0)
        {
            return table[k].stored;
        }
    }
    return name;
}

const char *dem_name_of_stored(const char *stored)
{
    for (size_t k = 0; k < ROWS; k++)
    {
        if (strcmp(table[k].stored, stored) == 0)
        {
            return table[k].name;
        }
    }
    return stored;
}

int dem_is_stored_as(const char *name, const char *stored)
{
    return strcmp(dem_stored_name(name), stored) == 0;
}
