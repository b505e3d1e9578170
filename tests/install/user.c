/*
 * user.c -- a program that uses the library: two grains fall on a floor, on all ranks of MPI. Compiled as C
 * and as C++ against an installed library. Prints the version and the hash, which does not depend on
 * the number of ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <dem_query.h>
#include <stdio.h>

static const char *const scene =
    "materials { glass { density 2500; youngsModulus 1e7; } }"
    "effects { gravity { acceleration (0 0 -9.81); } hertz {} dry { restitution 0.7; } }"
    "walls { floor { type plane; point (0 0 0); normal (0 0 1); } }"
    "insert { grains { type lattice; count 2; diameter 1e-3; min (0 0 0); max (0.01 0.01 0.01); } }";

int main(int argc, char **argv)
{
    struct dem_case *c = NULL;
    struct dem *d = NULL;
    uint64_t hash = 0;
    int rank;

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const int failed = dem_case_create(&c, MPI_COMM_WORLD) || dem_case_scene_text(c, scene, "user") ||
                       dem_start(&c, &d) || dem_advance(d, 0.02) || dem_hash(d, &hash);

    if (rank == 0 && failed)
    {
        fprintf(stderr, "%s\n", dem_error_text());
    }
    else if (rank == 0)
    {
        printf("%s %s %016llx\n", DEM_VERSION, dem_version(), (unsigned long long)hash);
    }
    dem_case_free(c);
    dem_free(d);
    MPI_Finalize();
    return failed;
}
