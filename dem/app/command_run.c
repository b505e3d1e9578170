/*
 * command_run.c -- `dem run SCENE`: advance from output to output, print the progress, write VTK
 * files, tables and snapshots.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "dem_plan.h"
#include "app/energy_csv.h"
#include "app/progress.h"
#include "app/run_announce.h"
#include "app/run_tables.h"
#include "app/scene_options.h"
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/file.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    BACKUP_STEPS = 1000,  /* between backups in memory; one costs less than a step */
    DEVICE_BACKUP_STEPS = 50000    /* with a device, from which the state comes for it */
};

static const char help[] =
    "Usage: dem run [-restart SNAPSHOT] [-device NAME] [-set PATH VALUE] ... SCENE\n"
    "       mpirun -np N dem run SCENE\n\n"
    "Runs a scene in OpenFOAM's dictionary syntax. Of its entries these belong to the run:\n"
    "    time  { end 1; step auto;        s; auto: the longest stable step\n"
    "            maxOverlap 0.5;          these three stop the run: overlap over the diameter,\n"
    "            maxSpeed 100;            m/s,\n"
    "            maxCreated 0.05;         energy created between two rows of energy.csv, of its\n"
    "                                     largest term\n"
    "            untilQuiet {} }          end earlier, when the particles rest\n"
    "    write { interval 0.01;           s of simulated time between outputs\n"
    "            folder \"NAME\";           default: the scene's name without its extension\n"
    "            vtk yes;                 particles_*.vtp and particles.pvd for ParaView, walls\n"
    "                                     of triangles too\n"
    "            walls 0.001;             s between rows of walls.csv, force and torque on\n"
    "                                     walls; none unless given\n"
    "            cell 0.001;              s between rows of cell.csv, stress and fabric of a cell\n"
    "                                     that deforms; none unless given\n"
    "            energy 0.001;            s between rows of energy.csv, the energy balance; none\n"
    "                                     unless given\n"
    "            orientation no;          yes: orientation of each particle, as a quaternion\n"
    "            profile yes;             time of each phase of the step, printed at the end\n"
    "            snapshot last;           last | all | no: snapshot.dem, or one per output\n"
    "            keep 3;                  of all snapshots only the last so many; default: all\n"
    "            lastGood yes; }          backups in memory; the last is written as lastGood.dem\n"
    "                                     when the run fails\n"
    "    accuracy { target 0.01; }        search the step for errors within 1 % first, see dem cost\n"
    "-device NAME makes the steps on an OpenCL device, with the same bits: gpu, or a part of a name\n"
    "that `dem run -device list` prints. The scene's entry `device` does the same.\n"
    "-restart continues from a snapshot, on any number of ranks, with the same bits as the run\n"
    "that wrote it. SIGTERM, SIGUSR1 and SIGINT (Ctrl-C) end the run after the present step with\n"
    "a snapshot, from which -restart continues with the same bits. So does a file `stop` in the\n"
    "folder of the output (touch NAME/stop), which needs neither mpirun nor the batch system.\n"
    "-set overrides an entry: -set effects/dry/restitution 0.8, or -set time/end=1\n"
    "dem effects lists the effects.\n";

/* The run has failed: report lost particles and broken bonds, write the last backup, and add its
   path to the message. */
static int write_last_good(const struct dem_program *prog, struct dem *d,
                           const struct dem_output *o, struct dem_run_tables *tables, int failure)
{
    char text[DEM_ERROR_TEXT_SIZE];
    double time = 0.0;
    int status;

    snprintf(text, sizeof text, "%s", dem_error_text());
    status = dem_run_tables_losses(tables, prog, d);
    if (!o->last_good && !status)
    {
        return dem_error(failure, "%s", text);
    }
    status = status ? status : dem_restore(d, &time);
    status = status ? status : dem_output_last_good(o, prog, d);
    if (status)
    {
        return dem_error(failure, "%s; the last good state cannot be written: %s", text,
                         dem_error_text());
    }
    return dem_error(failure,
                     "%s; the last good state, of time %g s, is in %s/lastGood.dem: look at it, or "
                     "continue from it with -restart",
                     text, time, o->folder);
}

/* ---- the loop -------------------------------------------------------------------------------- */

struct run_state
{
    const struct dem_program *prog;
    const struct dem_schedule *s;
    struct dem *d;
    struct dem_progress p;
    struct dem_quiet quiet;
    struct dem_run_tables tables;
    struct dem_energy_log energy;
    struct dem_totals t;
    int stages;    /* that have begun */
};

/* A line for each stage that has begun since the last call. */
static void tell_stages(struct run_state *c)
{
    const char *name, *why;
    double begin;

    while ((name = dem_run_stage(c->d, c->stages, &begin, &why)) && isfinite(begin))
    {
        if (c->prog->rank == 0)
        {
            printf("stage %s begins at t %.6g s%s%s\n", name, begin, why[0] ? ": " : "", why);
            fflush(stdout);
        }
        c->stages++;
    }
}

/* At the end of the run: the stages that have not begun. */
static int tell_stages_left(const struct run_state *c)
{
    const char *text;

    DEM_TRY(dem_stages_left_text(c->d, &text));
    if (c->prog->rank == 0)
    {
        fputs(text, stdout);
    }
    return DEM_OK;
}

static int advance(struct run_state *c, double duration)
{
    const struct dem_output *const o = &c->s->output;

    if (o->last_good)
    {
        DEM_TRY(dem_backup_every(c->d, dem_device_bytes(c->d) > 0.0 ? DEVICE_BACKUP_STEPS
                                                                    : BACKUP_STEPS));
    }
    const int status = dem_advance(c->d, duration);

    DEM_TRY(status && dem_ranks_agree(c->d) ? write_last_good(c->prog, c->d, o, &c->tables, status)
                                            : status);
    tell_stages(c);
    DEM_TRY(dem_totals(c->d, &c->t));
    c->p.overlap = fmax(c->p.overlap, c->t.largest_overlap);
    return DEM_OK;
}

/* The snapshot of a run that a signal has stopped, under the name of the next output's. */
static int save_stopped(struct run_state *c, int64_t number)
{
    const struct dem_output *const o = &c->s->output;
    const double began = MPI_Wtime();
    char path[640];

    DEM_TRY(dem_program_agree(c->prog, c->prog->rank == 0 ? dem_file_make_folder(o->folder) : DEM_OK));
    dem_output_snapshot_name(o, number, path, sizeof path);
    DEM_TRY(dem_save(c->d, path));
    DEM_TRY(dem_totals(c->d, &c->t));
    if (c->prog->rank == 0)
    {
        printf("stopped by %s at t %.9g s, after step %lld: the state is in %s, written in %.2g s; "
               "-restart %s continues, with the same bits\n",
               dem_signal_name(dem_stopped(c->d)), c->t.time, (long long)c->t.steps, path,
               MPI_Wtime() - began, path);
        fflush(stdout);
    }
    return DEM_OK;
}

/* A line and rows of tables; then the snapshot, so that a run restarted from it need not repeat
   them. */
static int write_output(struct run_state *c, int64_t number)
{
    const struct dem_output *const o = &c->s->output;
    const char *warning;

    DEM_TRY(dem_impact_warning(c->d, c->p.overlap, &warning));
    dem_progress_report(&c->p, &c->t);
    if (c->prog->rank == 0 && warning[0])
    {
        printf("warning: %s\n", warning);
        fflush(stdout);
    }
    DEM_TRY(dem_run_tables_flows(&c->tables, c->prog, c->d, c->t.time));
    DEM_TRY(dem_run_tables_losses(&c->tables, c->prog, c->d));
    return dem_stopped(c->d) ? save_stopped(c, number) : dem_output_save(o, c->prog, c->d, number);
}

static int begin(struct run_state *c)
{
    const struct dem_output *const o = &c->s->output;
    const double start = o->start;

    DEM_TRY(dem_totals(c->d, &c->t));

    c->p.from = start;
    c->p.end = c->s->end;
    c->p.steps = c->t.steps;
    c->p.particles = c->t.particles;
    c->p.printed = MPI_Wtime();
    snprintf(c->p.stop_file, sizeof c->p.stop_file, "%s/stop", o->folder);
    if (c->prog->rank == 0)
    {
        dem_set_progress(c->d, DEM_LOOK_INTERVAL, dem_progress_watch, &c->p);
    }
    DEM_TRY(dem_run_tables_begin(&c->tables, c->prog, o, c->d));
    dem_run_announce_device(c->prog, c->d);
    tell_stages(c);
    DEM_TRY(dem_walls_vtk_begin(o, c->prog, c->d));
    if (start == 0.0)
    {
        DEM_TRY(dem_output_write(o, c->prog, c->d, 0, 0.0));
        DEM_TRY(dem_output_save(o, c->prog, c->d, 0));
    }
    DEM_TRY(dem_energy_log_begin(&c->energy, c->prog, o, c->d));
    return start == 0.0 ? dem_energy_log_append(&c->energy, c->prog, c->d, 0.0) : DEM_OK;
}

/* Advance to this time, and write the rows due on the way; a signal ends it earlier. */
static int advance_to(struct run_state *c, double next)
{
    const struct dem_output *const o = &c->s->output;

    for (double due = 0.0; due < next;)
    {
        due = dem_next_due(o->cell, c->t.time, next);
        due = dem_next_due(o->energy, c->t.time, dem_next_due(o->walls, c->t.time, due));
        DEM_TRY(advance(c, due - c->t.time));
        if (dem_stopped(c->d))
        {
            return DEM_OK;
        }
        DEM_TRY(dem_run_tables_walls(&c->tables, c->prog, c->d, due));
        const int status = dem_energy_log_append(&c->energy, c->prog, c->d, due);

        DEM_TRY(status == DEM_ERROR_NUMBER ? write_last_good(c->prog, c->d, o, &c->tables, status)
                                           : status);
    }
    return DEM_OK;
}

static void print_quiet(const struct dem_quiet *q, const struct dem_program *prog,
                        const struct dem_totals *t)
{
    if (q->wanted && prog->rank == 0)
    {
        printf("%s at t %.6g s: %lld of %lld particles move\n", q->reached ? "quiet" : "not quiet",
               t->time, (long long)q->move, (long long)t->particles);
    }
}

static int print_profile(const struct dem_program *prog, struct dem *d, const struct dem_output *o)
{
    const char *text;
    int64_t made, parts, repeated;

    if (o->profile)
    {
        DEM_TRY(dem_profile_text(d, &text));
        if (prog->rank == 0)
        {
            fputs(text, stdout);
        }
        dem_device_steps(d, &made, &parts, &repeated);
        if (prog->rank == 0 && made + repeated > 0)
        {
            printf("    device: %lld steps in %lld parts, %lld given up\n", (long long)made,
                   (long long)parts, (long long)repeated);
        }
    }
    return DEM_OK;
}

/* The time of test k of rest, of `checks` in an interval. */
static double time_of_test(const struct dem_schedule *s, int64_t checks, int64_t k)
{
    return fmin(k%checks ? (double)k*(s->interval/(double)checks)
                         : (double)(k/checks)*s->interval, s->end);
}

/* Outputs are at integer multiples of the interval, so that a restarted run has the same
   windows. Each interval is divided into `checks` parts, after which rest is tested. */
static int advance_to_end(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    struct run_state c = {.prog = prog,
                          .s = s,
                          .d = d,
                          .p = {.started = MPI_Wtime(), .rank = prog->rank},
                          .quiet = s->quiet};
    const int64_t checks = dem_quiet_tests(d, &c.quiet, s->interval);
    const double part = s->interval/(double)checks;

    DEM_TRY(begin(&c));
    while (c.t.time < s->end*(1.0 - 1e-12) && !c.quiet.reached && !dem_stages_over(d))
    {
        const int64_t k = (int64_t)floor(c.t.time/part + 1e-6) + 1,
                      number = (k + checks - 1)/checks;
        const double next = time_of_test(s, checks, k);

        DEM_TRY(advance_to(&c, next));
        if (dem_stopped(d))
        {
            DEM_TRY(write_output(&c, number));
            return print_profile(prog, d, &s->output);
        }
        DEM_TRY(dem_quiet_test(d, &c.quiet, &c.t));
        if (k%checks == 0 || c.quiet.reached || next == s->end || dem_stages_over(d))
        {
            DEM_TRY(dem_output_write(&s->output, prog, d, number, next));
            DEM_TRY(write_output(&c, number));
        }
    }
    DEM_TRY(print_profile(prog, d, &s->output));
    dem_run_tables_print_flows(prog, d);
    dem_energy_log_print(&c.energy, prog);
    print_quiet(&c.quiet, prog, &c.t);
    return tell_stages_left(&c);
}

/* ---- the run --------------------------------------------------------------------------------- */

/* A file `stop` from before the start would end this run. */
static int clear_stop_file(const struct dem_output *o)
{
    char path[640];
    int found;

    snprintf(path, sizeof path, "%s/stop", o->folder);
    DEM_TRY(dem_stop_file_clear(path, &found));
    if (found)
    {
        printf("the file %s, which was there before this run, is removed; made again, it ends the "
               "run\n", path);
    }
    return DEM_OK;
}

/* One run at a time writes into the folder. */
static int take_folder(struct dem_folder_lock *lock, const struct dem_output *o, const struct dem *d)
{
    if (dem_output_writes(o, d))
    {
        DEM_TRY(dem_file_make_folder(o->folder));
        DEM_TRY(dem_folder_lock(lock, o->folder));
    }
    if (lock->before[0])
    {
        printf("the lock of an earlier run in %s, %s, which has ended, is taken over\n", o->folder,
               lock->before);
    }
    return clear_stop_file(o);
}

static int run_scene(struct dem_program *prog, struct dem *d, const struct dem_schedule *s)
{
    uint64_t hash;

    DEM_TRY(dem_run_announce(prog, d, s));
    DEM_TRY(advance_to_end(prog, d, s));
    DEM_TRY(dem_hash(d, &hash));
    if (prog->rank == 0)
    {
        dem_accuracy_print(&s->accuracy, dem_step_limit(d).used);
        printf("hash %016llx%s\n", (unsigned long long)hash, dem_stopped(d) ? " at the stop" : "");
    }
    return DEM_OK;
}

static int run(struct dem_program *prog, struct dem *d, const struct dem_schedule *scheduled)
{
    struct dem_folder_lock lock = {.file = 0};
    struct dem_schedule s = *scheduled;
    struct dem_totals t;

    DEM_TRY(dem_accuracy_search(&s.accuracy, prog, s.request));
    /* before the first line is printed, to which a script may answer with a signal */
    dem_set_stop_flag(d, dem_catch_signals(NULL, 0));
    DEM_TRY(dem_totals(d, &t));
    s.output.start = t.time;
    int status =
        dem_program_agree(prog, prog->rank == 0 ? take_folder(&lock, &s.output, d) : DEM_OK);

    status = status ? status : run_scene(prog, d, &s);
    dem_folder_unlock(&lock);
    return status;
}

int dem_main_run(struct dem_program *prog, int argc, char **argv)
{
    const struct dem_command command = {.name = "run", .help = help, .run = run};

    /* a reader of the log that ends (head, less) must not end the run */
    signal(SIGPIPE, SIG_IGN);
    return dem_command_run(prog, &command, argc, argv);
}
