/*
 * run_loop.c -- the loop of `dem run`: advances from output to output, prints the progress, writes
 * VTK files, tables and snapshots.
 *
 * Outputs are at integer multiples of the interval, so that a restarted run has the same windows.
 * Each interval is divided into parts, after which rest is tested.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/run_loop.h"
#include "app/energy_csv.h"
#include "app/progress.h"
#include "app/run_announce.h"
#include "app/run_tables.h"
#include "app/walls_vtk.h"
#include "core/error.h"
#include "core/file.h"
#include "dem_plan.h"
#include <math.h>
#include <stdio.h>

enum
{
    BACKUP_STEPS = 1000,  /* between backups in memory; one costs less than a step */
    DEVICE_BACKUP_STEPS = 50000    /* with a device, from which the state comes for it */
};

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

/* 1: a signal or the file stop ends the run here, before its end. */
static int stops(const struct run_state *c)
{
    return dem_stopped(c->d) || (dem_stop_requested(c->d) && c->t.time < c->s->end*(1.0 - 1e-12) &&
                                 !c->quiet.reached && !dem_stages_over(c->d));
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
               dem_signal_name(dem_stop_requested(c->d)), c->t.time, (long long)c->t.steps, path,
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
    return stops(c) ? save_stopped(c, number) : dem_output_save(o, c->prog, c->d, number);
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
    DEM_TRY(dem_walls_vtk_begin(o, c->d));
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

    for (double due = 0.0; due < next && !stops(c);)
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

int dem_run_loop(const struct dem_program *prog, struct dem *d, const struct dem_schedule *s, int *stopped)
{
    struct run_state c = {.prog = prog,
                          .s = s,
                          .d = d,
                          .p = {.started = MPI_Wtime(), .rank = prog->rank},
                          .quiet = s->quiet};
    const int64_t checks = dem_quiet_tests(d, &c.quiet, s->interval);
    const double part = s->interval/(double)checks;

    *stopped = 0;
    DEM_TRY(begin(&c));
    while (c.t.time < s->end*(1.0 - 1e-12) && !c.quiet.reached && !dem_stages_over(d))
    {
        const int64_t k = (int64_t)floor(c.t.time/part + 1e-6) + 1,
                      number = (k + checks - 1)/checks;
        const double next = time_of_test(s, checks, k);

        DEM_TRY(advance_to(&c, next));
        const int reached = !(stops(&c) && c.t.time < next*(1.0 - 1e-12));

        DEM_TRY(reached ? dem_quiet_test(d, &c.quiet, &c.t) : DEM_OK);
        if (reached && (k%checks == 0 || c.quiet.reached || next == s->end || dem_stages_over(d)))
        {
            DEM_TRY(dem_output_write(&s->output, prog, d, number, next));
            DEM_TRY(write_output(&c, number));
        }
        else if (stops(&c))
        {
            DEM_TRY(write_output(&c, number));
        }
        if (stops(&c))
        {
            *stopped = 1;
            return print_profile(prog, d, &s->output);
        }
    }
    DEM_TRY(print_profile(prog, d, &s->output));
    dem_run_tables_print_flows(prog, d);
    dem_energy_log_print(&c.energy, prog);
    print_quiet(&c.quiet, prog, &c.t);
    return tell_stages_left(&c);
}
