/*
 * main_run.c -- `dem run SCENE`: advance from output to output, say how it goes, write pictures and snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main.h"
#include "main_lost.h"
#include "main_output.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/dictionary.h"
#include "io/snapshot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct request                                            /* the command line */
{
    const char *scene, *restart;
    const char *set[64][2];
    int sets, help;
};

struct schedule                                           /* time { ... } and write { ... } */
{
    double end, interval;
    struct dem_output output;
};

static const char help[] =
    "Usage: dem run [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem run SCENE\n\n"
    "Runs a scene in OpenFOAM's dictionary syntax. Of its entries these belong to the run:\n"
    "    time  { end 1; step auto; }           s; auto takes the longest step that the effects stand\n"
    "    write { interval 0.01;                s of simulated time between outputs\n"
    "            folder \"NAME\";                default: the scene's name without its ending\n"
    "            vtk yes;                      particles_*.vtp and particles.pvd for ParaView\n"
    "            snapshot last; }              last | all | no: snapshot.dem, or one per output\n"
    "-restart goes on from a snapshot, on any number of ranks, with the same bits as the run that wrote it.\n"
    "-set overrides an entry: -set effects/dry/restitution 0.8\n"
    "dem effects lists what can act.\n";

static int read_arguments(struct request *r, int argc, char **argv)
{
    static const char *const known[] = {"-restart", "-set", "-help"};

    for (int k = 0; k < argc; k++)
    {
        if (strcmp(argv[k], "-help") == 0)
        {
            r->help = 1;
        }
        else if (strcmp(argv[k], "-restart") == 0 && k + 1 < argc)
        {
            r->restart = argv[++k];
        }
        else if (strcmp(argv[k], "-set") == 0 && k + 2 < argc && r->sets < 64)
        {
            r->set[r->sets][0] = argv[++k];
            r->set[r->sets++][1] = argv[++k];
        }
        else if (strcmp(argv[k], "-restart") == 0 || strcmp(argv[k], "-set") == 0)
        {
            return dem_error(DEM_ERROR_INPUT, "%s lacks its value%s; dem run -help tells how", argv[k], argv[k][1] == 's' ? "s" : "");
        }
        else if (argv[k][0] == '-')
        {
            return dem_unknown_word("option", argv[k], known, 3);
        }
        else
        {
            DEM_REQUIRE(!r->scene, DEM_ERROR_INPUT, "two scenes, %s and %s; run one", r->scene, argv[k]);
            r->scene = argv[k];
        }
    }
    DEM_REQUIRE(r->scene || r->help, DEM_ERROR_INPUT, "no scene; dem run -help tells how");
    return DEM_OK;
}

static int read_schedule(struct schedule *s, const struct dem_dict *scene, const char *path)
{
    const struct dem_dict *time, *write;

    DEM_TRY(dem_dict_sub(scene, "time", &time));
    DEM_TRY(dem_dict_number(time, "end", "s", &s->end));
    DEM_TRY(dem_dict_sub_if(scene, "write", &write));
    s->interval = s->end;
    if (write)
    {
        DEM_TRY(dem_dict_number_or(write, "interval", "s", s->end, &s->interval));
    }
    DEM_REQUIRE(s->end > 0.0, DEM_ERROR_INPUT, "time/end %g s; give a time above 0", s->end);
    DEM_REQUIRE(s->interval > 0.0, DEM_ERROR_INPUT, "write/interval %g s; give a time above 0", s->interval);
    return dem_output_read(&s->output, write, path);
}

struct progress
{
    double started, from;                                 /* s: wall clock, simulated */
    int64_t steps;
    int rank;
};

static int report(struct progress *p, struct dem *d, double end)
{
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    if (p->rank == 0)
    {
        const double spent = MPI_Wtime() - p->started, done = t.time - p->from;

        printf("t %.6g s  %lld particles  %lld contacts  %.0f steps/s  kinetic %.4g J  overlap %.3g %%  ETA %.0f s\n", t.time,
               (long long)t.particles, (long long)t.contacts, (double)(t.steps - p->steps)/spent, t.kinetic,
               100.0*t.largest_overlap, done > 0.0 ? spent/done*(end - t.time) : 0.0);
        fflush(stdout);
    }
    return DEM_OK;
}

/* Outputs lie at whole multiples of the interval, so that a restarted run has the same windows. */
static int advance_to_end(struct dem_program *prog, struct dem *d, const struct schedule *s)
{
    struct progress p = {.started = MPI_Wtime(), .rank = prog->rank};
    struct dem_lost_log lost;
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    p.from = t.time;
    p.steps = t.steps;
    DEM_TRY(dem_lost_begin(&lost, prog, &s->output, t.time));
    if (t.time == 0.0)
    {
        DEM_TRY(dem_output_write(&s->output, prog, d, 0, 0.0));
    }
    for (int64_t k = (int64_t)floor(t.time/s->interval + 1e-6) + 1; t.time < s->end*(1.0 - 1e-12); k++)
    {
        const double next = fmin((double)k*s->interval, s->end);

        DEM_TRY(dem_advance(d, next - t.time));
        DEM_TRY(dem_output_write(&s->output, prog, d, k, next));
        DEM_TRY(report(&p, d, s->end));
        DEM_TRY(dem_lost_tell(&lost, prog, d));
        DEM_TRY(dem_tally(d, &t));
    }
    return DEM_OK;
}

static int announce(const struct dem_program *prog, struct dem *d)
{
    const struct dem_step_limit step = dem_step_limit(d);
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    if (prog->rank == 0)
    {
        printf("Suna: %lld particles, %d walls, %d rank%s\nstep %.4g s, limit %.4g s: %s\n", (long long)t.particles, dem_wall_count(d),
               prog->ranks, prog->ranks > 1 ? "s" : "", step.used, step.limit, step.why);
        fflush(stdout);
    }
    return DEM_OK;
}

/* No fluid solver will ever come: say so before anything is written. */
static int need_no_solver(struct dem *d)
{
    DEM_REQUIRE(!dem_needs_fluid(d) || dem_dict_has(dem_scene_dict(d), "fluid"), DEM_ERROR_INPUT,
                "an effect of the scene needs a fluid, and there is none; add fluid { density; viscosity; velocity; } or run it "
                "in OpenFOAM");
    return DEM_OK;
}

static int run(struct dem_program *prog, struct dem *d, const struct request *r)
{
    struct schedule s = {.end = 0.0};
    uint64_t hash;

    DEM_TRY(dem_scene_file(d, r->scene));
    for (int k = 0; k < r->sets; k++)
    {
        DEM_TRY(dem_set(d, r->set[k][0], r->set[k][1]));
    }
    if (r->restart)
    {
        DEM_TRY(dem_load(d, r->restart));
    }
    DEM_TRY(dem_ready(d));
    DEM_TRY(read_schedule(&s, dem_scene_dict(d), r->scene));
    DEM_TRY(dem_scene_check(d));
    DEM_TRY(need_no_solver(d));
    DEM_TRY(announce(prog, d));
    DEM_TRY(advance_to_end(prog, d, &s));
    DEM_TRY(dem_hash(d, &hash));
    if (prog->rank == 0)
    {
        printf("hash %016llx\n", (unsigned long long)hash);
    }
    return DEM_OK;
}

int dem_main_run(struct dem_program *prog, int argc, char **argv)
{
    struct request r = {.scene = NULL};
    struct dem *d;
    int status;

    DEM_TRY(read_arguments(&r, argc, argv));
    if (r.help)
    {
        if (prog->rank == 0)
        {
            fputs(help, stdout);
        }
        return DEM_OK;
    }
    DEM_TRY(dem_create(&d, prog->comm));
    status = run(prog, d, &r);
    dem_free(d);
    return status;
}

int dem_main_hash(struct dem_program *prog, int argc, char **argv)
{
    uint64_t hash;

    if (argc != 1 || strcmp(argv[0], "-help") == 0)
    {
        if (prog->rank == 0)
        {
            printf("Usage: dem hash SNAPSHOT\n\nThe fingerprint of particles and remembered contacts, as dem run prints it at its end;\n"
                   "it does not depend on the number of ranks.\n");
        }
        DEM_REQUIRE(argc == 1, DEM_ERROR_INPUT, "name one snapshot");
        return DEM_OK;
    }
    DEM_TRY(dem_snapshot_fingerprint(argv[0], &hash));
    if (prog->rank == 0)
    {
        printf("%016llx\n", (unsigned long long)hash);
    }
    return DEM_OK;
}
