/*
 * command_run.c -- `dem run SCENE`: reserves the output folder, announces the run, runs the scene
 * (run_loop.h) and prints the hash of the final state.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "app/run_announce.h"
#include "app/run_loop.h"
#include "app/scene_options.h"
#include "core/error.h"
#include "core/file.h"
#include "dem_tables.h"
#include <signal.h>
#include <stdio.h>

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
    int stopped;

    DEM_TRY(dem_run_announce(prog, d, s));
    DEM_TRY(dem_run_loop(prog, d, s, &stopped));
    DEM_TRY(dem_hash(d, &hash));
    if (prog->rank == 0)
    {
        dem_accuracy_print(&s->accuracy, dem_step_limit(d).used);
        printf("hash %016llx%s\n", (unsigned long long)hash, stopped ? " at the stop" : "");
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
