/*
 * main_run.c -- `dem run SCENE`: advance from output to output, say how it goes, write pictures and snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main.h"
#include "main_energy.h"
#include "main_bonds.h"
#include "main_flows.h"
#include "main_lost.h"
#include "main_rows.h"
#include "main_scene.h"
#include "main_stop.h"
#include "main_surfaces.h"
#include "main_walls.h"
#include "base/error.h"
#include "io/snapshot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    KEEP_STEPS = 1000                                     /* between copies of the state in memory; one costs less than a step */
};

static const char help[] =
    "Usage: dem run [-restart SNAPSHOT] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem run SCENE\n\n"
    "Runs a scene in OpenFOAM's dictionary syntax. Of its entries these belong to the run:\n"
    "    time  { end 1; step auto;             s; auto takes the longest step that the effects stand\n"
    "            precision double;             mixed: laws and forces in single, positions and motion in double\n"
    "            maxOverlap 0.5; maxSpeed 100; maxCreated 0.05;  stop the run: of a diameter, m/s, of the energy between two rows\n"
    "            untilQuiet { lasting 0.01; } }  ends sooner, when next to nothing has moved for so long\n"
    "    write { interval 0.01;                s of simulated time between outputs\n"
    "            folder \"NAME\";                default: the scene's name without its ending\n"
    "            vtk yes;                      particles_*.vtp and particles.pvd for ParaView, walls of triangles too\n"
    "            walls 0.001;                  s between rows of walls.csv, force and torque on walls; none unless given\n"
    "            energy 0.001;                 s between rows of energy.csv, the ledger of energy; none unless given\n"
    "            orientation no;               yes: how each particle has turned, as a quaternion\n"
    "            profile yes;                  where the time went, told at the end\n"
    "            snapshot last;                last | all | no: snapshot.dem, or one per output\n"
    "            keep 3;                       of all snapshots only the last so many; all unless given\n"
    "            lastGood yes; }               copies in memory, written as lastGood.dem when the run fails\n"
    "-restart goes on from a snapshot, on any number of ranks, with the same bits as the run that wrote it.\n"
    "SIGTERM, SIGUSR1 and SIGINT (Ctrl-C) end the run after the step at hand; the snapshot that is left goes on, with the same bits.\n"
    "-set overrides an entry: -set effects/dry/restitution 0.8\n"
    "dem effects lists what can act.\n";

struct progress
{
    double started, from;                                 /* s: wall clock, simulated */
    double overlap;                                       /* 1: largest since the last line; a tally begins anew */
    int64_t steps;
    int rank;
};

/* What bonds and films have booked, where there are any. */
static void report_books(const struct dem_tally *t)
{
    if (t->bonds > 0 || t->broken > 0.0 || t->lost != 0.0)
    {
        printf("        %lld bonds  %.0f broken  stored %.4g J  lost %.4g J\n", (long long)t->bonds, t->broken, t->stored, t->lost);
    }
}

static void report(struct progress *p, const struct dem_tally *t, double end)
{
    if (p->rank == 0)
    {
        const double spent = MPI_Wtime() - p->started, done = t->time - p->from;

        printf("t %.6g s  %lld particles  %lld contacts  %.0f steps/s  kinetic %.4g J  overlap %.3g %%  ETA %.0f s\n", t->time,
               (long long)t->particles, (long long)t->contacts, (double)(t->steps - p->steps)/spent, t->kinetic, 100.0*p->overlap,
               done > 0.0 ? spent/done*(end - t->time) : 0.0);
        report_books(t);
        fflush(stdout);
    }
    p->overlap = 0.0;
}

/* The run has failed: tell who was lost, write the state that was copied last, and say where it is. */
static int rescue(const struct dem_program *prog, struct dem *d, const struct dem_output *o, struct dem_lost_log *lost, int failure)
{
    char text[DEM_ERROR_TEXT_SIZE];
    double time = 0.0;
    int status;

    snprintf(text, sizeof text, "%s", dem_error_text());
    status = dem_lost_tell(lost, prog, d);
    status = status ? status : dem_bond_rows_tell(prog, d, o);
    if (!o->last_good && !status)
    {
        return dem_error(failure, "%s", text);
    }
    status = status ? status : dem_restore(d, &time);
    status = status ? status : dem_output_last_good(o, prog, d);
    if (status)
    {
        return dem_error(failure, "%s; the last good state can't be written: %s", text, dem_error_text());
    }
    return dem_error(failure, "%s; the last good state, of time %g s, is in %s/lastGood.dem: look at it, or go on from it with "
                     "-restart", text, time, o->folder);
}

/* ---- going ------------------------------------------------------------------------------------------------------ */

struct course                                             /* a run on its way */
{
    const struct dem_program *prog;
    const struct dem_schedule *s;
    struct dem *d;
    struct progress p;
    struct dem_quiet quiet;
    struct dem_lost_log lost;
    struct dem_wall_log walls;
    struct dem_energy_log energy;
    struct dem_flow_log flows;
    struct dem_tally t;
};

/* One window, with copies of the state in it. */
static int advance(struct course *c, double duration)
{
    const struct dem_output *const o = &c->s->output;

    if (o->last_good)
    {
        DEM_TRY(dem_keep(c->d, KEEP_STEPS));
    }
    const int status = dem_advance(c->d, duration);

    DEM_TRY(status && dem_ranks_agree(c->d) ? rescue(c->prog, c->d, o, &c->lost, status) : status);
    DEM_TRY(dem_tally(c->d, &c->t));
    c->p.overlap = fmax(c->p.overlap, c->t.largest_overlap);
    return DEM_OK;
}

/* A line, tables, and the snapshot last of all: what it is gone on from has been told. */
static int tell(struct course *c, int64_t number)
{
    const struct dem_output *const o = &c->s->output;

    report(&c->p, &c->t, c->s->end);
    DEM_TRY(dem_flow_log_tell(&c->flows, c->prog, c->d, c->t.time));
    DEM_TRY(dem_lost_tell(&c->lost, c->prog, c->d));
    DEM_TRY(dem_bond_rows_tell(c->prog, c->d, o));
    return dem_stopped(c->d) ? dem_stop_save(c->prog, o, c->d, number) : dem_output_save(o, c->prog, c->d, number);
}

static int begin(struct course *c)
{
    const struct dem_output *const o = &c->s->output;

    DEM_TRY(dem_tally(c->d, &c->t));
    const double start = c->t.time;

    c->p.from = start;
    c->p.steps = c->t.steps;
    DEM_TRY(dem_lost_begin(&c->lost, c->prog, o, c->d, start));
    DEM_TRY(dem_flow_log_begin(&c->flows, c->prog, o, c->d, start));
    DEM_TRY(dem_bond_rows_begin(c->prog, c->d, o->folder, start));
    DEM_TRY(dem_surfaces_begin(o, c->prog, c->d));
    if (start == 0.0)
    {
        DEM_TRY(dem_output_write(o, c->prog, c->d, 0, 0.0));
        DEM_TRY(dem_output_save(o, c->prog, c->d, 0));
    }
    DEM_TRY(dem_wall_log_begin(&c->walls, c->prog, o, c->d, start));
    DEM_TRY(dem_energy_log_begin(&c->energy, c->prog, o, c->d, start));
    return start == 0.0 ? dem_energy_log_tell(&c->energy, c->prog, c->d, 0.0) : DEM_OK;
}

/* Up to the next look, from row to row; or until a signal stops it. */
static int go(struct course *c, double next)
{
    const struct dem_output *const o = &c->s->output;

    for (double due = 0.0; due < next;)
    {
        due = dem_rows_due(o->energy, c->t.time, dem_rows_due(o->walls, c->t.time, next));
        DEM_TRY(advance(c, due - c->t.time));
        if (dem_stopped(c->d))
        {
            return DEM_OK;
        }
        DEM_TRY(dem_wall_log_tell(&c->walls, c->prog, c->d, due));
        const int status = dem_energy_log_tell(&c->energy, c->prog, c->d, due);

        DEM_TRY(status == DEM_ERROR_NUMBER ? rescue(c->prog, c->d, o, &c->lost, status) : status);
    }
    return DEM_OK;
}

static int tell_profile(const struct dem_program *prog, struct dem *d, const struct dem_output *o)
{
    const char *text;

    if (o->profile)
    {
        DEM_TRY(dem_profile_text(d, &text));
        if (prog->rank == 0)
        {
            fputs(text, stdout);
        }
    }
    return DEM_OK;
}

/* Outputs lie at whole multiples of the interval, so that a restarted run has the same windows; looks whether all is quiet
   lie between them. */
static int advance_to_end(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    struct course c = {.prog = prog, .s = s, .d = d, .p = {.started = MPI_Wtime(), .rank = prog->rank}, .quiet = s->quiet};
    const int64_t looks = dem_quiet_looks(&c.quiet, s->interval);
    const double look = s->interval/(double)looks;

    DEM_TRY(begin(&c));
    for (int64_t k = (int64_t)floor(c.t.time/look + 1e-6) + 1; c.t.time < s->end*(1.0 - 1e-12) && !c.quiet.reached; k++)
    {
        const double next = fmin(k%looks ? (double)k*look : (double)(k/looks)*s->interval, s->end);
        const int64_t number = (k + looks - 1)/looks;

        DEM_TRY(go(&c, next));
        if (dem_stopped(d))
        {
            DEM_TRY(tell(&c, number));
            return tell_profile(prog, d, &s->output);
        }
        DEM_TRY(dem_quiet_look(&c.quiet, d, &c.t));
        if (k%looks == 0 || c.quiet.reached || next == s->end)
        {
            DEM_TRY(dem_output_write(&s->output, prog, d, number, next));
            DEM_TRY(tell(&c, number));
        }
    }
    DEM_TRY(tell_profile(prog, d, &s->output));
    dem_flow_log_end(prog, d);
    dem_energy_log_end(&c.energy, prog);
    dem_quiet_tell(&c.quiet, prog, &c.t);
    return DEM_OK;
}

/* ---- saying ----------------------------------------------------------------------------------------------------- */

/* What was left out of surfaces: the user may not know of it. */
static void announce_walls(const struct dem *d)
{
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        struct dem_wall_facts f;

        dem_wall_facts(d, w, &f);
        if (f.flat + f.repeats > 0)
        {
            printf("wall %s: %lld triangles; left out %lld without area, %lld given before\n", dem_wall_name(d, w), (long long)f.triangles,
                   (long long)f.flat, (long long)f.repeats);
        }
    }
}

static void announce_gravity(const struct dem_schedule *s)
{
    const double *const g = s->gravity;

    if (g[0] != 0.0 || g[1] != 0.0 || g[2] != 0.0)
    {
        printf("gravity (%g %g %g) m/s2\n", g[0], g[1], g[2]);
    }
    else
    {
        printf("no gravity: effects/gravity is %s\n", s->with_gravity ? "zero" : "not there");
    }
}

static int announce(const struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    const struct dem_step_limit step = dem_step_limit(d);
    struct dem_tally t;

    DEM_TRY(dem_tally(d, &t));
    if (prog->rank == 0)
    {
        printf("Suna: %lld particles, %d walls, %d rank%s\nstep %.4g s, limit %.4g s: %s\n", (long long)t.particles, dem_wall_count(d),
               prog->ranks, prog->ranks > 1 ? "s" : "", step.used, step.limit, step.why);
        announce_gravity(s);
        if (dem_acting_fluid(d)[0])
        {
            printf("of the fluid: %s\n", dem_acting_fluid(d));
        }
        if (s->coupling)
        {
            printf("coupling is not read: it is for runs in OpenFOAM\n");
        }
        announce_walls(d);
        if (t.time >= s->end*(1.0 - 1e-12))
        {
            printf("nothing to run: time goes on from the snapshot, and its %.6g s are time/end\n", t.time);
        }
        fflush(stdout);
    }
    return DEM_OK;
}

static int run(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    uint64_t hash;

    dem_stop_when(d, dem_stop_listen());                  /* first: who reads what is announced may send a signal */
    DEM_TRY(announce(prog, d, s));
    DEM_TRY(advance_to_end(prog, d, s));
    DEM_TRY(dem_hash(d, &hash));
    if (prog->rank == 0)
    {
        printf("hash %016llx\n", (unsigned long long)hash);
    }
    return DEM_OK;
}

int dem_main_run(struct dem_program *prog, int argc, char **argv)
{
    const struct dem_command command = {.name = "run", .help = help, .serve = run};

    return dem_scene_serve(prog, &command, argc, argv);
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
