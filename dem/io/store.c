/*
 * store.c -- the two ways behind one set of calls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/store.h"
#include "base/error.h"
#include <errno.h>
#include <string.h>

enum
{
    PIECE = 1 << 30                                       /* MPI counts bytes in int */
};

static void part_name(const struct dem_store *s, char *name, size_t size)
{
    snprintf(name, size, "%s%s", s->path, s->writing ? ".part" : "");
}

static int start(struct dem_store *s, MPI_Comm comm, int rank, const char *path, int writing)
{
    char name[sizeof s->path + 8];
    int bad;

    DEM_REQUIRE(strlen(path) < sizeof s->path, DEM_ERROR_FILE, "path %s is longer than %zu letters", path, sizeof s->path - 1);
    *s = (struct dem_store){.comm = comm, .rank = rank, .writing = writing};
    memcpy(s->path, path, strlen(path));
    part_name(s, name, sizeof name);
    if (comm == MPI_COMM_NULL)
    {
        s->alone = fopen(name, writing ? "wb" : "rb");
        bad = !s->alone;
    }
    else
    {
        const int mode = writing ? MPI_MODE_CREATE | MPI_MODE_WRONLY : MPI_MODE_RDONLY;

        bad = MPI_File_open(comm, name, mode, MPI_INFO_NULL, &s->file) != MPI_SUCCESS;
        bad = bad || (writing && MPI_File_set_size(s->file, 0) != MPI_SUCCESS);
    }
    DEM_REQUIRE(!bad, DEM_ERROR_FILE, "can't open %s for %s%s%s; check path and rights", name, writing ? "writing" : "reading",
                errno ? ": " : "", errno ? strerror(errno) : "");
    return DEM_OK;
}

int dem_store_create(struct dem_store *s, MPI_Comm comm, int rank, const char *path)
{
    return start(s, comm, rank, path, 1);
}

int dem_store_open(struct dem_store *s, MPI_Comm comm, int rank, const char *path)
{
    return start(s, comm, rank, path, 0);
}

static void fail(struct dem_store *s, const char *what)
{
    char name[sizeof s->path + 8];

    part_name(s, name, sizeof name);
    s->status = dem_error(DEM_ERROR_FILE, "%s %s failed%s%s; is the %s?", what, name, errno ? ": " : "",
                          errno ? strerror(errno) : "", s->writing ? "disk full" : "file cut short");
}

static int transfer(struct dem_store *s, size_t at, void *data, size_t size, int writing)
{
    MPI_Status status;
    int done = 0;

    if (s->comm == MPI_COMM_NULL)
    {
        return fseek(s->alone, (long)at, SEEK_SET) == 0
            && (writing ? fwrite(data, 1, size, s->alone) : fread(data, 1, size, s->alone)) == size;
    }
    if ((writing ? MPI_File_write_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE, &status)
                 : MPI_File_read_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE, &status)) != MPI_SUCCESS)
    {
        return 0;
    }
    MPI_Get_count(&status, MPI_BYTE, &done);
    return (size_t)done == size;
}

static void in_pieces(struct dem_store *s, size_t at, char *data, size_t size, int writing)
{
    errno = 0;
    for (size_t done = 0; done < size && !s->status;)
    {
        const size_t piece = size - done < PIECE ? size - done : PIECE;

        if (!transfer(s, at + done, data + done, piece, writing))
        {
            fail(s, writing ? "writing" : "reading");
        }
        done += piece;
    }
}

void dem_store_write(struct dem_store *s, size_t at, const void *data, size_t size)
{
    in_pieces(s, at, (char *)(size_t)data, size, 1);
}

void dem_store_read(struct dem_store *s, size_t at, void *data, size_t size)
{
    in_pieces(s, at, data, size, 0);
}

size_t dem_store_size(struct dem_store *s)
{
    MPI_Offset size = 0;

    if (s->comm != MPI_COMM_NULL)
    {
        return MPI_File_get_size(s->file, &size) == MPI_SUCCESS ? (size_t)size : 0;
    }
    const long end = fseek(s->alone, 0, SEEK_END) == 0 ? ftell(s->alone) : 0;

    return end > 0 ? (size_t)end : 0;
}

int dem_store_close(struct dem_store *s)
{
    char name[sizeof s->path + 8];
    int bad = s->status != DEM_OK;

    part_name(s, name, sizeof name);
    errno = 0;
    if (s->comm == MPI_COMM_NULL)
    {
        bad |= fclose(s->alone) != 0;
    }
    else
    {
        bad |= MPI_File_close(&s->file) != MPI_SUCCESS;
        MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT, MPI_MAX, s->comm);
    }
    if (!bad && s->writing && s->rank == 0)
    {
        bad = rename(name, s->path) != 0;
    }
    if (s->comm != MPI_COMM_NULL)
    {
        MPI_Bcast(&bad, 1, MPI_INT, 0, s->comm);
    }
    if (bad && !s->status)
    {
        fail(s, s->writing ? "writing" : "reading");
    }
    return s->status;
}
