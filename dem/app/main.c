/*
 * main.c -- the program `dem`: run a scene, plan one, measure its cost, list the effects, print the
 * hash of a snapshot.
 *
 * Only the files of app/ print. Each command is in a file of its own, command_*.c, with its -help.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "core/error.h"
#include "core/did_you_mean.h"
#include "dem_query.h"
#include <mpi.h>
#include <errno.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* the commands, in the order of -help; NULL: a program in Python */
static const struct command
{
    const char *name, *summary;
    int (*run)(struct dem_program *, int argc, char **argv);
} commands[] =
{
    {"run", "run a scene (alone or under mpirun)", dem_main_run},
    {"plan",
     "check a scene and report its effects, time step, memory and run time, without running it",
     dem_main_plan},
    {"cost", "accuracy against processor time, over time step and stiffness", NULL},
    {"plot", "draw tables: energy, forces on walls, means, the cost.csv of dem cost", NULL},
    {"import", "translate input of LIGGGHTS, CFDEMcoupling or OpenFOAM into a scene or case", NULL},
    {"effects", "list the effects with their settings, units, defaults, ranges and sources",
     dem_main_effects},
    {"hash", "print the hash of a snapshot", dem_main_hash},
};

enum
{
    COMMANDS = (int)(sizeof commands/sizeof commands[0])
};

static void usage(FILE *to)
{
    fprintf(to, "dem: Suna's discrete element method, without a fluid solver\n\nUsage: dem COMMAND "
                "[...]\n\n");
    for (int k = 0; k < COMMANDS; k++)
    {
        fprintf(to, "  %-10s %s\n", commands[k].name, commands[k].summary);
    }
    fprintf(to, "\ndem COMMAND -help describes a command; dem -version prints the version. The exit status is 0\n"
                "only on success.\n");
}

/* NULL for a word that is no command */
static const struct command *find(const char *name)
{
    for (int k = 0; k < COMMANDS; k++)
    {
        if (strcmp(name, commands[k].name) == 0)
        {
            return &commands[k];
        }
    }
    return NULL;
}

static int refuse(const char *name)
{
    const char *known[COMMANDS];

    for (int k = 0; k < COMMANDS; k++)
    {
        known[k] = commands[k].name;
    }
    return dem_did_you_mean_error("command", name, known, COMMANDS);
}

int dem_program_check_output(const struct dem_program *p, int status)
{
    if (p->rank > 0)
    {
        return status;
    }
    errno = 0;
    const int bad = fflush(stdout) != 0 || ferror(stdout);

    /* an earlier failure has left no reason */
    return bad && status == DEM_OK
             ? dem_error(DEM_ERROR_FILE, "cannot write all to standard output: %s",
                         errno ? strerror(errno) : "its disk is full, or its reader has ended")
             : status;
}

/* Print the version, or the commands; returns 0 where neither is asked for. */
static int introduce(const struct dem_program *p, int argc, char **argv)
{
    const int version = argc > 1 && strcmp(argv[1], "-version") == 0;
    const int help = argc > 1 && (strcmp(argv[1], "-help") == 0 || strcmp(argv[1], "--help") == 0);

    if (p->rank == 0 && version)
    {
        printf("Suna %s\n", dem_version());
    }
    else if (p->rank == 0 && (help || argc < 2))
    {
        usage(help ? stdout : stderr);
    }
    return version || help || argc < 2;
}

/* Large lists are allocated and freed during a run: have glibc return their memory to the
   system. By default it raises the threshold after the first of them and keeps the memory. */
static void return_large_blocks(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
}

int main(int argc, char **argv)
{
    const struct command *const command = argc > 1 ? find(argv[1]) : NULL;
    struct dem_program p = {.comm = MPI_COMM_NULL};
    int status, printer;

    /* another program takes the place of this one, on each rank */
    if (command && !command->run)
    {
        (void)dem_main_python(argv[1], argc - 2, argv + 2);
        fprintf(stderr, "dem: %s\n", dem_error_text());
        return EXIT_FAILURE;
    }
    return_large_blocks();
    if (MPI_Init(&argc, &argv) != MPI_SUCCESS)
    {
        fprintf(stderr, "dem: MPI does not start; a program built with MPI=no runs in one process only, "
                        "build it again without that for several ranks\n");
        return EXIT_FAILURE;
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &p.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &p.ranks);
    p.comm = p.ranks > 1 ? MPI_COMM_WORLD : MPI_COMM_NULL;
    if (introduce(&p, argc, argv))
    {
        status = dem_program_check_output(&p, DEM_OK);
        if (status)
        {
            fprintf(stderr, "dem: %s\n", dem_error_text());
        }
        MPI_Finalize();
        return argc < 2 || status ? EXIT_FAILURE : EXIT_SUCCESS;
    }
    status = command ? command->run(&p, argc - 2, argv + 2) : refuse(argv[1]);
    status = dem_program_agree(&p, dem_program_check_output(&p, status));
    /* print the message once, on the first rank that has it */
    printer = p.ranks;
    if (status != DEM_OK && strncmp(dem_error_text(), "another rank failed", 19) != 0)
    {
        printer = p.rank;
    }
    MPI_Allreduce(MPI_IN_PLACE, &printer, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (status != DEM_OK && printer == p.rank)
    {
        fflush(stdout);
        fprintf(stderr, "dem: %s\n", dem_error_text());
    }
    MPI_Finalize();
    return status == DEM_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}
