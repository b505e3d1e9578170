/*
 * main.h -- the commands of the program `dem`, and the ranks that it runs on.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <mpi.h>

struct dem_program
{
    MPI_Comm comm;  /* MPI_COMM_NULL on one rank */
    int rank, ranks;
};

/* Collective. Fails on all ranks when one has failed; the others say that another one did. */
int dem_program_agree(const struct dem_program *, int status);

/* On the first rank: an error when standard output has not taken all that was printed. */
int dem_program_check_output(const struct dem_program *, int status);

/* Run a command with the arguments after its name. Returns a status of core/error.h. */
int dem_main_run(struct dem_program *, int argc, char **argv);
int dem_main_plan(struct dem_program *, int argc, char **argv);
/* cost, plot, import: Python programs. Does not return, except for an error; before MPI_Init. */
int dem_main_python(const char *command, int argc, char **argv);
int dem_main_effects(struct dem_program *, int argc, char **argv);
int dem_main_hash(struct dem_program *, int argc, char **argv);
