/*
 * command_hash.c -- `dem hash SNAPSHOT`: print the hash of a snapshot.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem.h"
#include "app/main.h"
#include "core/error.h"
#include <stdio.h>
#include <string.h>

int dem_main_hash(struct dem_program *prog, int argc, char **argv)
{
    uint64_t hash;

    if (argc != 1 || strcmp(argv[0], "-help") == 0)
    {
        if (prog->rank == 0)
        {
            printf("Usage: dem hash SNAPSHOT\n\nThe hash of particles and contact history, as dem "
                   "run prints it at its end;\n"
                   "it does not depend on the number of ranks.\n");
        }
        DEM_REQUIRE(argc == 1, DEM_ERROR_INPUT, "dem hash: %d arguments; give one snapshot", argc);
        return DEM_OK;
    }
    DEM_TRY(dem_snapshot_hash(argv[0], &hash));
    if (prog->rank == 0)
    {
        printf("%016llx\n", (unsigned long long)hash);
    }
    return DEM_OK;
}
