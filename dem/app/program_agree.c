/*
 * program_agree.c -- agreement of the ranks of the program.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/main.h"
#include "core/error.h"

int dem_program_agree(const struct dem_program *p, int status)
{
    int worst = status;

    if (p->comm != MPI_COMM_NULL)
    {
        MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, p->comm);
    }
    return worst && !status ? dem_error(worst, "another rank failed; see its message") : status;
}
