/*
 * test_agreement.c -- all-reduces of a step, where time/maxSpeed bounds how far particles move.
 *
 * - A column of spheres that collapses has the same bits, rebuilds and prunes with and without
 *   time/maxSpeed, on any number of ranks; with it the ranks agree in fewer than half of the steps.
 * - A particle that exceeds the limit on one rank ends the run on all, with one sentence.
 * - A request to stop on one rank stops all after the same step, at most 16 steps later.
 *
 *     mpirun -np N test_agreement    prints failures and counts; status 0 if there are none
 *
 * Reference: the same run on each rank alone. Calls of MPI_Allreduce pass through a function of this
 * file (profiling interface of MPI), which counts them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "parallel/ranks.h"

#include "case/simulation.h"
#include <string.h>

static long reductions;

int MPI_Allreduce(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    reductions++;
    return PMPI_Allreduce(in, out, n, type, op, comm);
}

/* `time`: entries of time; velocity [m/s] along x and down. */
static struct dem *make(MPI_Comm comm, const char *time, double velocity)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e7; } }"
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; }"
        " gravity { acceleration (0 0 -9.81); } }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); }"
        " left { type plane; point (0 0 0); normal (1 0 0); } }"
        "insert { column { type lattice; count 800; diameter 1e-3; spacing 1.05; jitter 0.5; seed 3;"
        " min (0 0 0); max (0.0085 0.0085 0.02); velocity (%g 0 %g); } }"
        "neighbours { outerSkin 0.3; innerSkin 0.05; } time { %s }";
    char text[1024];
    struct dem_case *c;
    struct dem *d;

    snprintf(text, sizeof text, scene, velocity, -velocity, time);
    try(dem_case_create(&c, comm));
    try(dem_case_scene_text(c, text, "column"));
    try(dem_start(&c, &d));
    return d;
}

struct run                        /* what a run ends with */
{
    uint64_t hash;
    double rebuilds, prunes, reductions;    /* all-reduces of a step */
};

static struct run run(MPI_Comm comm, const char *time)
{
    struct dem *const d = make(comm, time, 0.02);
    const int64_t steps = d->state.steps, rebuilds = d->state.rebuilds;
    const long before = reductions;
    struct run r;

    try(dem_advance(d, 2e-3));
    try(dem_advance(d, 3e-3));
    r.reductions = (double)(reductions - before)/(double)(d->state.steps - steps);
    r.rebuilds = (double)(d->state.rebuilds - rebuilds);
    r.prunes = (double)d->state.prunes;
    try(dem_hash(d, &r.hash));
    dem_free(d);
    return r;
}

static void counts(void)
{
    const struct run each = run(MPI_COMM_WORLD, ""), few = run(MPI_COMM_WORLD, "maxSpeed 0.3;"),
                     alone = run(MPI_COMM_SELF, "maxSpeed 0.3;");

    check(few.hash == each.hash && few.hash == alone.hash, "hash with a limit of speed",
          (double)few.hash, (double)each.hash);
    check(few.rebuilds == alone.rebuilds && few.prunes == alone.prunes,
          "prunes as on one rank", few.prunes, alone.prunes);
    check(few.prunes > 5.0, "prunes", few.prunes, 5.0);
    if (ranks > 1)
    {
        check(each.reductions > 1.0 && each.reductions < 1.5, "all-reduces a step",
              each.reductions, 1.0);
        check(few.reductions < 0.5, "all-reduces a step, with a limit of speed", few.reductions,
              0.5);
    }
    if (rank == 0)
    {
        printf("# %d ranks: %.3f all-reduces a step, %.3f with time/maxSpeed; %.0f and %.0f prunes\n",
               ranks, each.reductions, few.reductions, each.prunes, few.prunes);
    }
}

/* Gravity takes the column beyond the limit, first on one rank. */
static void too_fast(void)
{
    struct dem *const d = make(MPI_COMM_WORLD, "maxSpeed 0.44;", 0.3);
    char text[512] = "", first[512];
    const int status = dem_advance(d, 5e-3);

    check(status == DEM_ERROR_NUMBER, "status of a particle beyond the limit", status,
          DEM_ERROR_NUMBER);
    check(strstr(dem_error_text(), "the limit time/maxSpeed is 0.44 m/s") != NULL, "its sentence",
          0.0, 0.0);
    snprintf(text, sizeof text, "%s", dem_error_text());
    memcpy(first, text, sizeof first);
    PMPI_Bcast(first, sizeof first, MPI_CHAR, 0, MPI_COMM_WORLD);
    check(strcmp(first, text) == 0, "one sentence", 0.0, 0.0);
    dem_free(d);
}

static void stops(void)
{
    static volatile sig_atomic_t request = 0;
    struct dem *const d = make(MPI_COMM_WORLD, "maxSpeed 0.3;", 0.02);
    int64_t from, least, most;

    try(dem_advance(d, 1e-3));
    from = d->state.steps;
    d->state.stop_request = &request;
    request = rank == ranks - 1;
    try(dem_advance(d, 1e-3));
    least = most = d->state.steps - from;
    PMPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_INT64_T, MPI_MIN, MPI_COMM_WORLD);
    PMPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
    check(least == most && most <= DEM_UNAGREED_STEPS, "steps until a stop", (double)most,
          DEM_UNAGREED_STEPS);
    dem_free(d);
}

int main(int argc, char **argv)
{
    ranks_begin(&argc, &argv);
    counts();
    too_fast();
    stops();
    return ranks_end();
}
