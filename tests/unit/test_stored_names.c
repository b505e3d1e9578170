/*
 * test_stored_names.c -- names in the code and in snapshots.
 *
 * Every alias is found both ways, no name occurs twice, and every column and history column is
 * stored under the name that snapshots have had since version 5 of the format.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "records/stored_names.h"
#include "laws/effects.h"
#include "particles/particles.h"

#include <string.h>

/* In the order of enum dem_column_name. */
static const char *const stored_columns[] =
    {"force", "torque", "fluidVelocity", "pressureGradient",
     "voidFraction", "fluidDensity", "fluidAcceleration",
     "fluidVorticity", "fluidStress", "meanDiameter", "fluidTurbulence", "eddy", "counterflow",
     "place", "dragImpulse", "kept", "dragTime",
     "startVelocity", "way",          "response", "passed",
     "pending", "underRelaxation", "owedPressureImpulse",
     "swarmFirst", "swarmSecond", "addedMass",
     "fluidChange", "foreseen", "otherImpulse", "turnImpulse",
     "lostEnergy", "brokenBonds", "orientation", "checkedPosition"};

static const char *const stored_history[] = {"bond_length", "bond_worn", "bond_shear_x",
                                             "bond_shear_y", "bond_shear_z", "bond_twist",
                                             "bond_bend_x", "bond_bend_y", "bond_bend_z",
                                             "bond_asked", "impact_speed", "stretch_x",
                                             "stretch_y", "stretch_z", "tangential_stiffness",
                                             "twist", "shear_x", "shear_y",
                                             "shear_z",      "jkr_holds", "slip_x",
                                             "slip_y", "slip_z", "largest_overlap",
                                             "rolling_x", "rolling_y", "rolling_z",
                                             "bridge_volume"};

enum
{
    COLUMNS = sizeof stored_columns/sizeof *stored_columns,
    HISTORY_NAMES = sizeof stored_history/sizeof *stored_history
};

static void columns(void)
{
    struct dem_particles p;

    dem_particles_init(&p, 0);
    TAP_OK((int)COLUMNS == (int)DEM_COLUMNS, "%d columns, and %d names of them", (int)DEM_COLUMNS,
           (int)COLUMNS);
    for (int c = 0; c < (int)DEM_COLUMNS && c < (int)COLUMNS; c++)
    {
        const char *const name = p.column[c].name;

        TAP_OK(strcmp(dem_stored_name(name), stored_columns[c]) == 0 &&
                   strcmp(dem_name_of_stored(stored_columns[c]), name) == 0 &&
                   dem_is_stored_as(name, stored_columns[c]),
               "%s is stored as %s", name, stored_columns[c]);
        for (int k = 0; k < c; k++)
        {
            if (strcmp(name, p.column[k].name) == 0 ||
                strcmp(stored_columns[c], stored_columns[k]) == 0 ||
                strcmp(name, stored_columns[k]) == 0 ||
                strcmp(stored_columns[c], p.column[k].name) == 0)
            {
                TAP_OK(0, "%s and %s have different names", name, p.column[k].name);
            }
        }
    }
    dem_particles_free(&p);
}

/* Effects declare their history in any order: each stored name belongs to one effect, and each
   declared one is in the list. */
static void history(void)
{
    int found[HISTORY_NAMES] = {0}, named = 0;

    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        for (const char *const *name = (*e)->history; name && *name; name++)
        {
            int k = 0;

            while (k < HISTORY_NAMES && !dem_is_stored_as(*name, stored_history[k]))
            {
                k++;
            }
            TAP_OK(k < HISTORY_NAMES &&
                       strcmp(dem_name_of_stored(dem_stored_name(*name)), *name) == 0,
                   "%s of %s is stored as %s", *name, (*e)->name, dem_stored_name(*name));
            named++;
            if (k < HISTORY_NAMES)
            {
                found[k]++;
            }
        }
    }
    TAP_OK(named == HISTORY_NAMES, "%d history columns, and %d names of them", named,
           (int)HISTORY_NAMES);
    for (int k = 0; k < HISTORY_NAMES; k++)
    {
        TAP_OK(found[k] == 1, "%s belongs to one effect", stored_history[k]);
    }
}

static void others(void)
{
    TAP_OK(strcmp(dem_stored_name("bond_length"), "bond_length") == 0 &&
               strcmp(dem_name_of_stored("bond_length"), "bond_length") == 0,
           "a name without an alias is the same in both");
    TAP_OK(!dem_is_stored_as("counterflow", "slipFactor") &&
               !dem_is_stored_as("slipFactor", "slipFactor"),
           "a new name is never stored");
}

int main(void)
{
    TAP_TRAPS;
    columns();
    history();
    others();
    TAP_DONE;
}
