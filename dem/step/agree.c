/*
 * agree.c -- one all-reduce for numbers and failures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/agree.h"
#include <stdio.h>

enum
{
    FULL_TEXT = DEM_ERROR_TEXT_SIZE
};

/* The failing rank of lowest number tells all the others its sentence; all return its status. */
static int fail_together(const struct dem_parts *p, int status)
{
    char text[FULL_TEXT];
    int speaker = status ? p->pieces.rank : p->pieces.ranks;

    MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, p->pieces.comm);
    snprintf(text, sizeof text, "%s", dem_error_text());
    MPI_Bcast(text, FULL_TEXT, MPI_CHAR, speaker, p->pieces.comm);
    MPI_Bcast(&status, 1, MPI_INT, speaker, p->pieces.comm);
    return dem_error(status, "%s", text);
}

int dem_agree_most(struct dem_parts *p, int status, double *value, int n)
{
    double all[DEM_AGREE_MOST + 1];

    if (p->pieces.ranks == 1)
    {
        return status;
    }
    p->phases.agreements++;
    for (int k = 0; k < n; k++)
    {
        all[k] = value[k];
    }
    all[n] = status ? 1.0 : 0.0;
    MPI_Allreduce(MPI_IN_PLACE, all, n + 1, MPI_DOUBLE, MPI_MAX, p->pieces.comm);
    for (int k = 0; k < n; k++)
    {
        value[k] = all[k];
    }
    return all[n] > 0.0 ? fail_together(p, status) : DEM_OK;
}

int dem_agree(struct dem_parts *p, int status)
{
    return dem_agree_most(p, status, NULL, 0);
}
