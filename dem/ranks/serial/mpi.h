/*
 * mpi.h -- what the core needs of MPI, for one process without an MPI library: `make MPI=no`.
 *
 * MPI_COMM_WORLD is MPI_COMM_NULL, for which the library makes no call of MPI. The program, and
 * tests, call collectives on MPI_COMM_WORLD: with one process the result is its own contribution.
 * Calls that need another process, or MPI-IO, return MPI_ERR_OTHER; so does MPI_Init where a
 * launcher has started several processes, and MPI_Comm_dup of a communicator of another MPI.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RANKS_SERIAL_MPI_H
#define DEM_RANKS_SERIAL_MPI_H

#pragma GCC system_header /* arguments that are not used */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef int MPI_Comm, MPI_Request, MPI_Op, MPI_Info, MPI_File, MPI_Fint, MPI_Errhandler;
typedef size_t MPI_Datatype; /* bytes of an item */
typedef int64_t MPI_Offset;
typedef struct
{
    int MPI_SOURCE, MPI_TAG, MPI_ERROR;
} MPI_Status;

enum
{
    MPI_SUCCESS = 0,
    MPI_ERR_OTHER = 15,
    MPI_MAX_ERROR_STRING = 256,
    MPI_COMM_NULL = 0,
    MPI_COMM_WORLD = 0,
    MPI_COMM_SELF = 0,
    MPI_REQUEST_NULL = 0,
    MPI_INFO_NULL = 0,
    MPI_ERRORS_RETURN = 1,
    MPI_COMM_TYPE_SHARED = 1,
    MPI_ANY_SOURCE = -2,
    MPI_SUM = 1,
    MPI_MIN,
    MPI_MAX,
    MPI_MAXLOC,
    MPI_MODE_CREATE = 1,
    MPI_MODE_RDONLY = 2,
    MPI_MODE_WRONLY = 4
};

#define MPI_IN_PLACE ((void *)-1)
#define MPI_STATUS_IGNORE ((MPI_Status *)0)
#define MPI_STATUSES_IGNORE ((MPI_Status *)0)
#define MPI_DATATYPE_NULL ((MPI_Datatype)0)
#define MPI_BYTE ((MPI_Datatype)1)
#define MPI_CHAR ((MPI_Datatype)1)
#define MPI_UINT8_T ((MPI_Datatype)1)
#define MPI_INT (sizeof(int))
#define MPI_DOUBLE (sizeof(double))
#define MPI_INT64_T (sizeof(int64_t))
#define MPI_UINT64_T (sizeof(uint64_t))
#define MPI_DOUBLE_INT (sizeof(struct { double value; int rank; }))

/* ---- one process ------------------------------------------------------------------------------- */

static inline int MPI_Init(int *argc, char ***argv)
{
    static const char *const sizes[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE",
                                       "SLURM_STEP_NUM_TASKS"};    /* Open MPI, MPICH, srun */

    for (size_t k = 0; k < sizeof sizes/sizeof *sizes; k++)
    {
        const char *const size = getenv(sizes[k]);

        if (size && atoi(size) > 1)
        {
            return MPI_ERR_OTHER;
        }
    }
    return MPI_SUCCESS;
}

static inline int MPI_Finalize(void) { return MPI_SUCCESS; }
static inline int MPI_Abort(MPI_Comm comm, int code) { exit(code); }
static inline int MPI_Comm_rank(MPI_Comm comm, int *rank) { return *rank = 0; }
static inline int MPI_Comm_free(MPI_Comm *comm) { return MPI_SUCCESS; }
static inline int MPI_Comm_split_type(MPI_Comm comm, int type, int key, MPI_Info info, MPI_Comm *out)
{
    return MPI_ERR_OTHER;
}
static inline int MPI_Comm_set_errhandler(MPI_Comm comm, MPI_Errhandler e) { return MPI_SUCCESS; }
static inline MPI_Comm MPI_Comm_f2c(MPI_Fint comm) { return -1; }

static inline int MPI_Comm_size(MPI_Comm comm, int *size)
{
    *size = 1;
    return MPI_SUCCESS;
}

static inline int MPI_Comm_dup(MPI_Comm comm, MPI_Comm *out)
{
    *out = MPI_COMM_NULL;
    return comm == MPI_COMM_NULL ? MPI_SUCCESS : MPI_ERR_OTHER;
}

static inline int MPI_Error_string(int code, char *text, int *length)
{
    *length = snprintf(text, MPI_MAX_ERROR_STRING,
                       "this build of Suna has no MPI (make MPI=no) and runs in one process");
    return MPI_SUCCESS;
}

static inline double MPI_Wtime(void)
{
    struct timespec now = {0};

    (void)timespec_get(&now, TIME_UTC);
    return (double)now.tv_sec + 1e-9*(double)now.tv_nsec;
}

/* ---- collectives ------------------------------------------------------------------------------- */

static inline int dem_serial_copy(const void *own, void *all, int n, MPI_Datatype type)
{
    if (own != MPI_IN_PLACE)
    {
        memcpy(all, own, (size_t)n*type);
    }
    return MPI_SUCCESS;
}

#define DEM_SERIAL_COPY { return dem_serial_copy(own, all, n, type); }
#define DEM_SERIAL_NONE { return MPI_ERR_OTHER; }

static inline int MPI_Allreduce(const void *own, void *all, int n, MPI_Datatype type, MPI_Op op,
                                MPI_Comm comm) DEM_SERIAL_COPY
static inline int MPI_Reduce(const void *own, void *all, int n, MPI_Datatype type, MPI_Op op,
                             int root, MPI_Comm comm) DEM_SERIAL_COPY
static inline int MPI_Allgather(const void *own, int n, MPI_Datatype type, void *all, int each,
                                MPI_Datatype same, MPI_Comm comm) DEM_SERIAL_COPY
static inline int MPI_Allgatherv(const void *own, int n, MPI_Datatype type, void *all,
                                 const int *count, const int *start, MPI_Datatype same,
                                 MPI_Comm comm) DEM_SERIAL_COPY
static inline int MPI_Bcast(void *data, int n, MPI_Datatype type, int root, MPI_Comm comm)
{
    return MPI_SUCCESS;
}
static inline int MPI_Exscan(const void *own, void *before, int n, MPI_Datatype type, MPI_Op op,
                             MPI_Comm comm)
{
    return MPI_SUCCESS;    /* undefined on the first rank */
}
static inline int MPI_Type_contiguous(int n, MPI_Datatype type, MPI_Datatype *made)
{
    *made = (size_t)n*type;
    return MPI_SUCCESS;
}
static inline int MPI_Type_commit(MPI_Datatype *type) { return MPI_SUCCESS; }
static inline int MPI_Type_free(MPI_Datatype *type) { return MPI_SUCCESS; }

/* ---- other processes, MPI-IO: there are none --------------------------------------------------- */

static inline int MPI_Isend(const void *data, int n, MPI_Datatype type, int rank, int tag,
                            MPI_Comm comm, MPI_Request *request) DEM_SERIAL_NONE
static inline int MPI_Issend(const void *data, int n, MPI_Datatype type, int rank, int tag,
                             MPI_Comm comm, MPI_Request *request) DEM_SERIAL_NONE
static inline int MPI_Irecv(void *data, int n, MPI_Datatype type, int rank, int tag, MPI_Comm comm,
                            MPI_Request *request) DEM_SERIAL_NONE
static inline int MPI_Recv(void *data, int n, MPI_Datatype type, int rank, int tag, MPI_Comm comm,
                           MPI_Status *status) DEM_SERIAL_NONE
static inline int MPI_Iprobe(int rank, int tag, MPI_Comm comm, int *there, MPI_Status *status)
{
    *there = 0;
    *status = (MPI_Status){0};
    return MPI_ERR_OTHER;
}
static inline int MPI_Get_count(const MPI_Status *status, MPI_Datatype type, int *n)
{
    *n = 0;
    return MPI_ERR_OTHER;
}
static inline int MPI_Test(MPI_Request *request, int *done, MPI_Status *status)
{
    *done = 0;
    return MPI_ERR_OTHER;
}
static inline int MPI_Testall(int n, MPI_Request *request, int *done, MPI_Status *status)
{
    *done = 0;
    return MPI_ERR_OTHER;
}
static inline int MPI_Waitall(int n, MPI_Request *request, MPI_Status *status) DEM_SERIAL_NONE
static inline int MPI_Ibarrier(MPI_Comm comm, MPI_Request *request) DEM_SERIAL_NONE
static inline int MPI_File_open(MPI_Comm comm, const char *path, int mode, MPI_Info info,
                                MPI_File *file) DEM_SERIAL_NONE
static inline int MPI_File_close(MPI_File *file) DEM_SERIAL_NONE
static inline int MPI_File_sync(MPI_File file) DEM_SERIAL_NONE
static inline int MPI_File_set_size(MPI_File file, MPI_Offset size) DEM_SERIAL_NONE
static inline int MPI_File_get_size(MPI_File file, MPI_Offset *size) DEM_SERIAL_NONE
static inline int MPI_File_read_at(MPI_File file, MPI_Offset at, void *data, int n,
                                   MPI_Datatype type, MPI_Status *status) DEM_SERIAL_NONE
static inline int MPI_File_write_at(MPI_File file, MPI_Offset at, const void *data, int n,
                                    MPI_Datatype type, MPI_Status *status) DEM_SERIAL_NONE
static inline int MPI_File_write_at_all(MPI_File file, MPI_Offset at, const void *data, int n,
                                        MPI_Datatype type, MPI_Status *status) DEM_SERIAL_NONE

#undef DEM_SERIAL_COPY
#undef DEM_SERIAL_NONE

#endif
