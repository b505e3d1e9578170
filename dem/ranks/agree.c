/*
 * agree.c -- one all-reduce (maximum) of numbers and status; the text of the first failed rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/agree.h"
#include "ranks/collect.h"
#include "ranks/mpi_error.h"
#include <stdio.h>

/* The lowest rank that has failed broadcasts its error text and status; all return this status. */
static int fail_together(const struct dem_state *state, int status)
{
    char text[DEM_ERROR_TEXT_SIZE];
    int source = status ? state->decomposition.rank : state->decomposition.ranks;

    snprintf(text, sizeof text, "%s", dem_error_text());
    DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, &source, 1, MPI_INT, MPI_MIN, state->decomposition.comm));
    DEM_TRY_MPI(MPI_Bcast(text, DEM_ERROR_TEXT_SIZE, MPI_CHAR, source, state->decomposition.comm));
    DEM_TRY_MPI(MPI_Bcast(&status, 1, MPI_INT, source, state->decomposition.comm));
    return dem_error(status, "%s", text);
}

int dem_agree_max(struct dem_state *state, int status, double *value, int n)
{
    double all[DEM_AGREE_LIMIT + 1];

    if (state->decomposition.ranks == 1)
    {
        return status;
    }
    const int recorded =
        dem_collect_status(&state->decomposition);    /* as a rule the cause of the other error */

    status = recorded ? recorded : status;
    state->agreements++;
    for (int k = 0; k < n; k++)
    {
        all[k] = value[k];
    }
    all[n] = status ? 1.0 : 0.0;
    DEM_TRY_MPI(
        MPI_Allreduce(MPI_IN_PLACE, all, n + 1, MPI_DOUBLE, MPI_MAX, state->decomposition.comm));
    for (int k = 0; k < n; k++)
    {
        value[k] = all[k];
    }
    return all[n] > 0.0 ? fail_together(state, status) : DEM_OK;
}

void dem_unagreed_reset(struct dem_unagreed *u)
{
    u->n = 0;
    u->bound = 0.0;
    u->status = DEM_OK;
}

int dem_unagreed_keep_error(struct dem_unagreed *u, int status)
{
    if (status && !u->status)
    {
        u->status = status;
        snprintf(u->text, sizeof u->text, "%s", dem_error_text());
    }
    return u->status ? dem_error(u->status, "%s", u->text) : DEM_OK;
}

int dem_agree(struct dem_state *state, int status)
{
    return dem_agree_max(state, status, NULL, 0);
}
