/*
 * test_traffic.c -- messages, bytes and all-reduces of a step and of a rebuild on many ranks, against
 * the model of cost in docs/parallel.md.
 *
 *     mpirun -np P test_traffic [N [STEPS]]    a packing of N spheres a rank (250) in a periodic cube,
 *                                              STEPS steps (40); prints a row of the table;
 *                                              status 0 if the model holds
 *
 * Calls of MPI pass through functions of this file (profiling interface), which count them. The model,
 * for cubic subdomains of side L in diameters and a number density rho, with r the largest gap of a
 * pair of the list and c of a candidate contact, both from centre to centre:
 *
 *     ghosts of a rebuild      rho (6 L^2 r + 3 pi L r^2 + 4/3 pi r^3)
 *     neighbors                26 where three ranks or more lie along each axis, 7 for two
 *
 * Ghosts of a step are those with a candidate contact across the face, a part of the formula with c in
 * place of r. A sphere at depth x has Z/2 (1 - x/c) of them on average, of its Z in all, so with Poisson's
 * distribution the part is 1 - (1 - exp(-Z/2))/(Z/2): 0.48 for Z = 3, 0.75 for Z = 8.
 * A step sends to the neighbors that have such ghosts; with few spheres a rank, edges and corners have
 * none. With two ranks along each axis a ghost that is near two faces counts once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "parallel/ranks.h"

#include "case/simulation.h"
#include "step/neighbor_rebuild.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- counting -------------------------------------------------------------------------------- */

enum
{
    REDUCTIONS, REFRESHES, REFRESH_BYTES, MESSAGES, BYTES, BARRIERS, COUNTS
};

static double counted[COUNTS];

int MPI_Allreduce(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    counted[REDUCTIONS]++;
    return PMPI_Allreduce(in, out, n, type, op, comm);
}

int MPI_Iallreduce(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm,
                   MPI_Request *request)
{
    counted[REDUCTIONS]++;
    return PMPI_Iallreduce(in, out, n, type, op, comm, request);
}

int MPI_Isend(const void *data, int n, MPI_Datatype type, int target, int tag, MPI_Comm comm,
              MPI_Request *request)
{
    int size;

    MPI_Type_size(type, &size);
    counted[REFRESHES]++;
    counted[REFRESH_BYTES] += (double)n*size;
    return PMPI_Isend(data, n, type, target, tag, comm, request);
}

int MPI_Issend(const void *data, int n, MPI_Datatype type, int target, int tag, MPI_Comm comm,
               MPI_Request *request)
{
    int size;

    MPI_Type_size(type, &size);
    counted[MESSAGES]++;
    counted[BYTES] += (double)n*size;
    return PMPI_Issend(data, n, type, target, tag, comm, request);
}

int MPI_Ibarrier(MPI_Comm comm, MPI_Request *request)
{
    counted[BARRIERS]++;
    return PMPI_Ibarrier(comm, request);
}

/* Means over the ranks of what was counted since the last call, each divided by `by`. */
static void collect(double by, double mean[COUNTS])
{
    PMPI_Allreduce(counted, mean, COUNTS, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    for (int k = 0; k < COUNTS; k++)
    {
        mean[k] /= by*ranks;
        counted[k] = 0.0;
    }
}

static double mean_of(double value)
{
    double sum;

    PMPI_Allreduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return sum/ranks;
}

/* ---- the model ------------------------------------------------------------------------------- */

static const double pi = 3.14159265358979324, density = 0.55*6.0/3.14159265358979324;

/* Spheres around a cube of side L that are within r of it. */
static double shell(double side, double r)
{
    return density*(6.0*side*side*r + 3.0*pi*side*r*r + 4.0/3.0*pi*r*r*r);
}

static struct dem *make(int n)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e6; } }"
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } }"
        "domain { x (0 %.17g); y (0 %.17g); z (0 %.17g); periodic (x y z); }"
        "insert { bed { type random; count %d; diameter 1e-3; velocity (0.01 0 0); seed 3;"
        " min (0 0 0); max (%.17g %.17g %.17g); } }"
        "neighbours { outerSkin 0.3; innerSkin 0.04; }";
    const double side = 1e-3*cbrt((double)n*ranks/density);
    char text[1024];
    struct dem_case *c;
    struct dem *d;

    snprintf(text, sizeof text, scene, side, side, side, n*ranks, side, side, side);
    try(dem_case_create(&c, MPI_COMM_WORLD));
    try(dem_case_scene_text(c, text, "bed"));
    try(dem_start(&c, &d));
    return d;
}

int main(int argc, char **argv)
{
    const int n = argc > 1 ? atoi(argv[1]) : 250, steps = argc > 2 ? atoi(argv[2]) : 40;
    const double side = cbrt(n/density), outer = 1.0 + 0.3, inner = 1.0 + 0.04;
    double step[COUNTS], rebuild[COUNTS];

    ranks_begin(&argc, &argv);
    struct dem *const d = make(n);
    struct dem_state *const p = &d->state;

    try(dem_advance(d, d->step));                         /* with the first rebuild */
    collect(1.0, step);
    try(dem_advance(d, steps*d->step));
    collect(steps, step);
    const double ghosts = mean_of((double)p->particles.ghosts),
                 used = step[REFRESH_BYTES]/(DEM_HALO_WIDTH*sizeof(double));

    try(dem_neighbor_rebuild(p));
    collect(1.0, rebuild);
    if (rank == 0)
    {
        printf("| %d | %d | %.1f | %.0f, %.0f | %.1f | %.2f | %.0f, %.0f | %.0f | %.0f | %.0f |\n", ranks, n,
               step[REFRESHES], used, shell(side, inner), step[REFRESH_BYTES]/1e3, step[REDUCTIONS], ghosts,
               shell(side, outer), (rebuild[BYTES] + rebuild[REFRESH_BYTES])/1e3, rebuild[REDUCTIONS],
               rebuild[MESSAGES] + rebuild[REFRESHES]);
    }
    if (ranks >= 8)
    {
        const double neighbors = ranks < 27 ? 7.0 : 26.0;    /* of 2 and 3 ranks along each axis */

        check(step[REFRESHES] > 0.3*neighbors && step[REFRESHES] <= neighbors,
              "messages of a step", step[REFRESHES], neighbors);
        check(ghosts < 1.05*shell(side, outer) && ghosts > (ranks < 27 ? 0.7 : 0.9)*shell(side, outer),
              "ghosts of a rebuild", ghosts, shell(side, outer));
        check(used < 0.75*shell(side, inner) && used > 0.48*shell(side, inner), "ghosts of a step",
              used, shell(side, inner));
        check(step[REDUCTIONS] < 1.2, "all-reduces of a step", step[REDUCTIONS], 1.0);
        check(rebuild[REDUCTIONS] <= 8.0 && rebuild[BARRIERS] <= 2.0, "all-reduces of a rebuild",
              rebuild[REDUCTIONS], 7.0);
    }
    dem_free(d);
    return ranks_end();
}
