/*
 * parallel_file.c -- writes and reads a file through MPI-IO, or through stdio in serial runs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* fsync, fileno */

#include "ranks/parallel_file.h"
#include "core/file.h"
#include "ranks/mpi_error.h"
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

enum
{
    CHUNK = 1 << 30               /* bytes per call: MPI counts them in int */
};

static const char another_rank[] = "another rank failed; see its message";

static int is_serial(const struct dem_parallel_file *s)
{
    return s->by.comm == MPI_COMM_NULL;
}

static void part_name(const struct dem_parallel_file *s, char *name, size_t size)
{
    snprintf(name, size, "%s%s", s->path, s->writing ? ".part" : "");
}

/* Store the first error. Returns 1 for an error. */
static int keep_error(struct dem_parallel_file *s, int status)
{
    s->status = s->status ? s->status : status;
    return status != DEM_OK;
}

/* 1 on all ranks when it is 1 on one. An error of MPI is stored and counts as bad. */
static int on_any_rank(struct dem_parallel_file *s, int bad)
{
    if (!is_serial(s) && keep_error(s, DEM_MPI_STATUS(MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT,
                                                                    MPI_MAX, s->by.comm))))
    {
        return 1;
    }
    return bad;
}

int64_t dem_parallel_file_max(struct dem_parallel_file *s, int64_t n)
{
    if (!is_serial(s))
    {
        (void)keep_error(s, DEM_MPI_STATUS(MPI_Allreduce(MPI_IN_PLACE, &n, 1, MPI_INT64_T, MPI_MAX,
                                                         s->by.comm)));
    }
    return n;
}

int dem_file_ranks_count(const struct dem_file_ranks *by, int status, int64_t n, int64_t *before,
                         int64_t *all)
{
    const int64_t own[2] = {n, status != DEM_OK};
    int64_t sum[2] = {own[0], own[1]}, lower[2] = {0, 0};
    int mpi = DEM_OK;

    if (by->comm != MPI_COMM_NULL)
    {
        mpi = DEM_MPI_STATUS(MPI_Exscan(own, lower, 2, MPI_INT64_T, MPI_SUM, by->comm));
        mpi =
            mpi ? mpi : DEM_MPI_STATUS(MPI_Allreduce(own, sum, 2, MPI_INT64_T, MPI_SUM, by->comm));
    }
    DEM_TRY(status ? status : mpi);
    DEM_REQUIRE(sum[1] == 0, DEM_ERROR_STATE, "%s", another_rank);
    *before = by->rank > 0 ? lower[0] : 0;
    *all = sum[0];
    return DEM_OK;
}

/* ---- opening --------------------------------------------------------------------------------- */

static int open_file(struct dem_parallel_file *s, const struct dem_file_ranks *by, const char *path)
{
    char name[sizeof s->path + 8];
    int bad;

    DEM_REQUIRE(strlen(path) < sizeof s->path, DEM_ERROR_FILE,
                "path %s is longer than %zu characters; use a shorter one", path,
                sizeof s->path - 1);
    s->by = *by;
    memcpy(s->path, path, strlen(path) + 1);
    part_name(s, name, sizeof name);
    s->status = s->writing ? DEM_OK : dem_file_refuse_others(name);
    if (on_any_rank(s, s->status != DEM_OK))
    {
        return s->status ? s->status
                         : dem_error(DEM_ERROR_FILE, "another rank cannot read %s", name);
    }
    errno = 0;
    if (is_serial(s))
    {
        s->serial = fopen(name, s->writing ? "wb" : "rb");
        bad = !s->serial;
    }
    else
    {
        const int mode = s->writing ? MPI_MODE_CREATE | MPI_MODE_WRONLY : MPI_MODE_RDONLY;

        bad = on_any_rank(s, MPI_File_open(by->comm, name, mode, MPI_INFO_NULL, &s->file) !=
                                 MPI_SUCCESS);
        errno = bad && !s->writing && access(name, R_OK) != 0 ? errno : 0;    /* MPI leaves another one */
        if (!bad && s->writing)
        {
            bad = on_any_rank(s, MPI_File_set_size(s->file, 0) != MPI_SUCCESS);
            if (bad)
            {
                (void)MPI_File_close(&s->file);
            }
        }
    }
    DEM_TRY(s->status);
    DEM_REQUIRE(!bad, DEM_ERROR_FILE, "cannot open %s for %s%s%s; check %s", name,
                s->writing ? "writing" : "reading", errno ? ": " : "", errno ? strerror(errno) : "",
                s->writing ? "that its folder exists and is writable" : "path and permissions");
    return DEM_OK;
}

int dem_parallel_file_create(struct dem_parallel_file *s, const struct dem_file_ranks *by,
                             const char *path, int lasting)
{
    *s = (struct dem_parallel_file){.writing = 1, .durable = lasting};
    return open_file(s, by, path);
}

int dem_parallel_file_open(struct dem_parallel_file *s, const struct dem_file_ranks *by,
                           const char *path)
{
    *s = (struct dem_parallel_file){.writing = 0};
    return open_file(s, by, path);
}

/* ---- bytes ----------------------------------------------------------------------------------- */

static void fail(struct dem_parallel_file *s, const char *what)
{
    char name[sizeof s->path + 8];

    part_name(s, name, sizeof name);
    s->status =
        dem_error(DEM_ERROR_FILE, "%s %s failed%s%s; is the %s?", what, name, errno ? ": " : "",
                  errno ? strerror(errno) : "", s->writing ? "disk full" : "file cut short");
}

static int transfer(struct dem_parallel_file *s, size_t at, void *data, size_t size)
{
    MPI_Status status;
    int done = 0;

    if (is_serial(s))
    {
        return fseeko(s->serial, (off_t)at, SEEK_SET) == 0 &&
               (s->writing ? fwrite(data, 1, size, s->serial) : fread(data, 1, size, s->serial)) ==
                   size;
    }
    if ((s->writing ? MPI_File_write_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE, &status)
                    : MPI_File_read_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE,
                                       &status)) != MPI_SUCCESS)
    {
        return 0;
    }
    return MPI_Get_count(&status, MPI_BYTE, &done) == MPI_SUCCESS && (size_t)done == size;
}

static void transfer_in_chunks(struct dem_parallel_file *s, size_t at, char *data, size_t size)
{
    errno = 0;
    for (size_t done = 0; done < size && !s->status;)
    {
        const size_t chunk = size - done < CHUNK ? size - done : CHUNK;

        if (!transfer(s, at + done, data + done, chunk))
        {
            fail(s, s->writing ? "writing" : "reading");
        }
        done += chunk;
    }
}

void dem_parallel_file_write(struct dem_parallel_file *s, size_t at, const void *data, size_t size)
{
    transfer_in_chunks(s, at, (char *)(size_t)data, size);
}

void dem_parallel_file_read(struct dem_parallel_file *s, size_t at, void *data, size_t size)
{
    transfer_in_chunks(s, at, data, size);
}

/* All ranks make as many calls as the one with the most chunks; a rank that has failed or is done
   writes nothing. */
void dem_parallel_file_write_all(struct dem_parallel_file *s, size_t at, const void *data,
                                 size_t size)
{
    int64_t rounds = (int64_t)((size + CHUNK - 1)/CHUNK);

    if (is_serial(s))
    {
        dem_parallel_file_write(s, at, data, size);
        return;
    }
    rounds = dem_parallel_file_max(s, rounds);
    errno = 0;
    for (int64_t k = 0; k < rounds; k++)
    {
        const size_t done = (size_t)k*CHUNK < size ? (size_t)k*CHUNK : size, rest = size - done;
        const int chunk = s->status ? 0 : (int)(rest < CHUNK ? rest : CHUNK);
        MPI_Status status;
        int written = 0;

        const int good =
            MPI_File_write_at_all(s->file, (MPI_Offset)(at + done), (const char *)data + done,
                                  chunk, MPI_BYTE, &status) == MPI_SUCCESS &&
            MPI_Get_count(&status, MPI_BYTE, &written) == MPI_SUCCESS;

        if (!s->status && (!good || written != chunk))
        {
            fail(s, "writing");
        }
    }
}

size_t dem_parallel_file_size(struct dem_parallel_file *s)
{
    MPI_Offset size = 0;

    if (!is_serial(s))
    {
        return MPI_File_get_size(s->file, &size) == MPI_SUCCESS ? (size_t)size : 0;
    }
    const off_t end = fseeko(s->serial, 0, SEEK_END) == 0 ? ftello(s->serial) : 0;

    return end > 0 ? (size_t)end : 0;
}

/* ---- closing --------------------------------------------------------------------------------- */

/* Flush a durable file to the disk. Returns 0 on failure. */
static int flush(struct dem_parallel_file *s)
{
    if (!s->writing || !s->durable)
    {
        return 1;
    }
    return is_serial(s) ? fflush(s->serial) == 0 && fsync(fileno(s->serial)) == 0
                        : MPI_File_sync(s->file) == MPI_SUCCESS;
}

/* Flush the folder, which holds the new name, to the disk. A file system that cannot do this for
   folders returns EINVAL, which is accepted. */
static int flush_folder(const char *path)
{
    char folder[1024] = ".";
    const char *const slash = strrchr(path, '/');

    if (slash)
    {
        snprintf(folder, sizeof folder, "%.*s", slash > path ? (int)(slash - path) : 1, path);
    }
    const int handle = open(folder, O_RDONLY);

    if (handle < 0)
    {
        return 0;
    }
    const int good = fsync(handle) == 0 || errno == EINVAL;

    return (close(handle) == 0) & good;
}

static int rename_part(const struct dem_parallel_file *s, const char *name)
{
    DEM_REQUIRE(rename(name, s->path) == 0, DEM_ERROR_FILE, "cannot rename %s to %s: %s", name,
                s->path, strerror(errno));
    DEM_REQUIRE(!s->durable || flush_folder(s->path), DEM_ERROR_FILE,
                "%s is written, but its folder cannot be flushed to the "
                "disk: %s",
                s->path, strerror(errno));
    return DEM_OK;
}

int dem_parallel_file_close(struct dem_parallel_file *s)
{
    char name[sizeof s->path + 8];
    int bad = s->status != DEM_OK;

    part_name(s, name, sizeof name);
    errno = 0;
    bad |= !flush(s);
    bad |= is_serial(s) ? fclose(s->serial) != 0 : MPI_File_close(&s->file) != MPI_SUCCESS;
    if (bad && !s->status)
    {
        fail(s, s->writing ? "writing" : "reading");
    }
    bad = on_any_rank(s, bad);
    if (bad && !s->status)
    {
        s->status = dem_error(DEM_ERROR_FILE, "%s", another_rank);
    }
    if (s->writing && s->by.rank == 0)
    {
        s->status = bad ? s->status : rename_part(s, name);
        if (s->status)
        {
            remove(name);
        }
    }
    return on_any_rank(s, s->status != DEM_OK) && !s->status
               ? dem_error(DEM_ERROR_FILE, "%s", another_rank)
               : s->status;
}
