/*
 * store.c -- the two ways behind one set of calls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _POSIX_C_SOURCE 200809L                           /* fsync, fileno */

#include "io/store.h"
#include "base/error.h"
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

enum
{
    PIECE = 1 << 30                                       /* MPI counts bytes in int */
};

static int is_alone(const struct dem_store *s)
{
    return s->by.comm == MPI_COMM_NULL;
}

static void part_name(const struct dem_store *s, char *name, size_t size)
{
    snprintf(name, size, "%s%s", s->path, s->writing ? ".part" : "");
}

/* 1 on all ranks when it is 1 on one. */
static int anywhere(const struct dem_store *s, int bad)
{
    if (!is_alone(s))
    {
        MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT, MPI_MAX, s->by.comm);
    }
    return bad;
}

/* ---- opening --------------------------------------------------------------------------------------------------- */

static int start(struct dem_store *s, const struct dem_writers *by, const char *path)
{
    char name[sizeof s->path + 8];
    int bad;

    DEM_REQUIRE(strlen(path) < sizeof s->path, DEM_ERROR_FILE, "path %s is longer than %zu letters", path, sizeof s->path - 1);
    s->by = *by;
    memcpy(s->path, path, strlen(path) + 1);
    part_name(s, name, sizeof name);
    errno = 0;
    if (is_alone(s))
    {
        s->alone = fopen(name, s->writing ? "wb" : "rb");
        bad = !s->alone;
    }
    else
    {
        const int mode = s->writing ? MPI_MODE_CREATE | MPI_MODE_WRONLY : MPI_MODE_RDONLY;

        bad = anywhere(s, MPI_File_open(by->comm, name, mode, MPI_INFO_NULL, &s->file) != MPI_SUCCESS);
        bad = bad || (s->writing && anywhere(s, MPI_File_set_size(s->file, 0) != MPI_SUCCESS));
    }
    DEM_REQUIRE(!bad, DEM_ERROR_FILE, "can't open %s for %s%s%s; %s", name, s->writing ? "writing" : "reading", errno ? ": " : "",
                errno ? strerror(errno) : "", s->writing ? "is its folder there and yours to write?" : "check path and rights");
    return DEM_OK;
}

int dem_store_create(struct dem_store *s, const struct dem_writers *by, const char *path, int lasting)
{
    *s = (struct dem_store){.writing = 1, .lasting = lasting};
    return start(s, by, path);
}

int dem_store_open(struct dem_store *s, const struct dem_writers *by, const char *path)
{
    *s = (struct dem_store){.writing = 0};
    return start(s, by, path);
}

/* ---- bytes ----------------------------------------------------------------------------------------------------- */

static void fail(struct dem_store *s, const char *what)
{
    char name[sizeof s->path + 8];

    part_name(s, name, sizeof name);
    s->status = dem_error(DEM_ERROR_FILE, "%s %s failed%s%s; is the %s?", what, name, errno ? ": " : "",
                          errno ? strerror(errno) : "", s->writing ? "disk full" : "file cut short");
}

static int transfer(struct dem_store *s, size_t at, void *data, size_t size)
{
    MPI_Status status;
    int done = 0;

    if (is_alone(s))
    {
        return fseeko(s->alone, (off_t)at, SEEK_SET) == 0
            && (s->writing ? fwrite(data, 1, size, s->alone) : fread(data, 1, size, s->alone)) == size;
    }
    if ((s->writing ? MPI_File_write_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE, &status)
                    : MPI_File_read_at(s->file, (MPI_Offset)at, data, (int)size, MPI_BYTE, &status)) != MPI_SUCCESS)
    {
        return 0;
    }
    MPI_Get_count(&status, MPI_BYTE, &done);
    return (size_t)done == size;
}

static void in_pieces(struct dem_store *s, size_t at, char *data, size_t size)
{
    errno = 0;
    for (size_t done = 0; done < size && !s->status;)
    {
        const size_t piece = size - done < PIECE ? size - done : PIECE;

        if (!transfer(s, at + done, data + done, piece))
        {
            fail(s, s->writing ? "writing" : "reading");
        }
        done += piece;
    }
}

void dem_store_write(struct dem_store *s, size_t at, const void *data, size_t size)
{
    in_pieces(s, at, (char *)(size_t)data, size);
}

void dem_store_read(struct dem_store *s, size_t at, void *data, size_t size)
{
    in_pieces(s, at, data, size);
}

/* As many calls on each rank as the one with most pieces makes; who has failed, or is through, writes nothing. */
void dem_store_write_together(struct dem_store *s, size_t at, const void *data, size_t size)
{
    int64_t rounds = (int64_t)((size + PIECE - 1)/PIECE);

    if (is_alone(s))
    {
        dem_store_write(s, at, data, size);
        return;
    }
    MPI_Allreduce(MPI_IN_PLACE, &rounds, 1, MPI_INT64_T, MPI_MAX, s->by.comm);
    errno = 0;
    for (int64_t k = 0; k < rounds; k++)
    {
        const size_t done = (size_t)k*PIECE < size ? (size_t)k*PIECE : size, rest = size - done;
        const int piece = s->status ? 0 : (int)(rest < PIECE ? rest : PIECE);
        MPI_Status status;
        int written = 0;

        const int bad = MPI_File_write_at_all(s->file, (MPI_Offset)(at + done), (const char *)data + done, piece, MPI_BYTE, &status);

        MPI_Get_count(&status, MPI_BYTE, &written);
        if (!s->status && (bad != MPI_SUCCESS || written != piece))
        {
            fail(s, "writing");
        }
    }
}

size_t dem_store_size(struct dem_store *s)
{
    MPI_Offset size = 0;

    if (!is_alone(s))
    {
        return MPI_File_get_size(s->file, &size) == MPI_SUCCESS ? (size_t)size : 0;
    }
    const off_t end = fseeko(s->alone, 0, SEEK_END) == 0 ? ftello(s->alone) : 0;

    return end > 0 ? (size_t)end : 0;
}

/* ---- closing --------------------------------------------------------------------------------------------------- */

/* What was written is on the disk, not only on its way there. */
static int settle(struct dem_store *s)
{
    if (!s->writing || !s->lasting)
    {
        return 1;
    }
    return is_alone(s) ? fflush(s->alone) == 0 && fsync(fileno(s->alone)) == 0 : MPI_File_sync(s->file) == MPI_SUCCESS;
}

/* So is the new name: it is part of the folder. A file system that can't do this for folders says EINVAL; then there is no more
   to be done. */
static int settle_folder(const char *path)
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

static int take_name(const struct dem_store *s, const char *name)
{
    DEM_REQUIRE(rename(name, s->path) == 0, DEM_ERROR_FILE, "can't rename %s to %s: %s", name, s->path, strerror(errno));
    DEM_REQUIRE(!s->lasting || settle_folder(s->path), DEM_ERROR_FILE, "%s is written, but its folder can't be brought to the disk: %s",
                s->path, strerror(errno));
    return DEM_OK;
}

int dem_store_close(struct dem_store *s)
{
    char name[sizeof s->path + 8];
    int bad = s->status != DEM_OK;

    part_name(s, name, sizeof name);
    errno = 0;
    bad |= !settle(s);
    bad |= is_alone(s) ? fclose(s->alone) != 0 : MPI_File_close(&s->file) != MPI_SUCCESS;
    if (bad && !s->status)
    {
        fail(s, s->writing ? "writing" : "reading");
    }
    bad = anywhere(s, bad);
    if (bad && !s->status)
    {
        s->status = dem_error(DEM_ERROR_FILE, "another rank failed; its message tells why");
    }
    if (s->writing && s->by.rank == 0)
    {
        s->status = bad ? s->status : take_name(s, name);
        if (s->status)
        {
            remove(name);
        }
    }
    return anywhere(s, s->status != DEM_OK) && !s->status ? dem_error(DEM_ERROR_FILE, "another rank failed; its message tells why") : s->status;
}
