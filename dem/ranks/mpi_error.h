/*
 * mpi_error.h -- turn the return code of an MPI call into a status and a message of the library.
 *
 * The library's communicator returns errors (MPI_ERRORS_RETURN, set in dem_case_create), so a call that
 * is not checked goes on with an undefined result.
 *
 *     DEM_TRY_MPI(MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_INT64_T, MPI_SUM, comm));
 *
 *     int status = DEM_MPI_STATUS(MPI_Allgather(...));     where something has to be freed before the return
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/error.h"
#include <mpi.h>

/* DEM_OK for MPI_SUCCESS; else DEM_ERROR_MPI, with the name of the function, which is `call` up to its parenthesis, and
   the text of MPI_Error_string. */
int dem_mpi_status(const char *call, int code);

/* The status of an MPI call. */
#define DEM_MPI_STATUS(call) dem_mpi_status(#call, (call))

/* Leave the calling function with DEM_ERROR_MPI when an MPI call has failed. */
#define DEM_TRY_MPI(call) DEM_TRY(DEM_MPI_STATUS(call))
