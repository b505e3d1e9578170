/*
 * mpi_error.c -- the message of a failed MPI call: its name, and the text that MPI has for the
 * error code.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "ranks/mpi_error.h"
#include <stdio.h>
#include <string.h>

int dem_mpi_status(const char *call, int code)
{
    char text[MPI_MAX_ERROR_STRING + 1] = "";
    int length = 0;

    if (code == MPI_SUCCESS)
    {
        return DEM_OK;
    }
    if (MPI_Error_string(code, text, &length) != MPI_SUCCESS)
    {
        snprintf(text, sizeof text, "error code %d", code);
    }
    return dem_error(
        DEM_ERROR_MPI,
        "%.*s failed: %s; the ranks are out of step, end the program and restart from the last snapshot",
        (int)strcspn(call, "("), call, text);
}
