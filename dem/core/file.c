/*
 * file.c -- write to path.part and rename it when complete; read a file whole.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/file.h"

#include "core/error.h"
#include "core/memory.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>

enum
{
    CHUNK = 1 << 16  /* bytes of one read */
};

static void release(struct dem_file *f)
{
    dem_memory_free(f->path);
    dem_memory_free(f->part);
    *f = (struct dem_file){0};
}

int dem_file_begin(struct dem_file *f, const char *path)
{
    const size_t n = strlen(path);
    int status;

    *f = (struct dem_file){0};
    status = DEM_NEW(f->path, n + 1);
    status = status == DEM_OK ? DEM_NEW(f->part, n + sizeof ".part") : status;
    if (status == DEM_OK)
    {
        memcpy(f->path, path, n + 1);
        memcpy(f->part, path, n);
        memcpy(f->part + n, ".part", sizeof ".part");
        f->stream = fopen(f->part, "wb");
        status = f->stream ? DEM_OK
                           : dem_error(DEM_ERROR_FILE,
                                       "cannot write %s: %s; check that its folder exists and that "
                                       "you may write there",
                                       f->part, strerror(errno));
    }
    if (status != DEM_OK)
    {
        release(f);
    }
    return status;
}

int dem_file_finish(struct dem_file *f, int status)
{
    const int bad = ferror(f->stream);
    const int bad_end = fclose(f->stream);    /* writes the buffer: a full disk is detected here */

    if (status == DEM_OK && (bad || bad_end))
    {
        status = dem_error(DEM_ERROR_FILE,
                           "cannot write all of %s: %s; an older file of that name is unchanged",
                           f->path, strerror(errno));
    }
    if (status == DEM_OK && rename(f->part, f->path) != 0)
    {
        status = dem_error(DEM_ERROR_FILE, "cannot rename %s to %s: %s", f->part, f->path,
                           strerror(errno));
    }
    if (status != DEM_OK)
    {
        remove(f->part);
    }
    release(f);
    return status;
}

int dem_file_refuse_others(const char *path)
{
    struct stat s;

    DEM_REQUIRE(stat(path, &s) != 0 || S_ISREG(s.st_mode), DEM_ERROR_FILE,
                "cannot read %s: it is a %s; give a file with the data", path,
                S_ISDIR(s.st_mode)    ? "folder"
                : S_ISFIFO(s.st_mode) ? "pipe"
                                      : "device or socket");
    return DEM_OK;
}

int dem_file_load(const char *path, char **bytes, size_t *n)
{
    size_t capacity = 0, got = 1;
    int status = DEM_OK;

    *bytes = NULL;
    *n = 0;
    DEM_TRY(dem_file_refuse_others(path));
    FILE *const stream = fopen(path, "rb");

    DEM_REQUIRE(stream, DEM_ERROR_FILE, "cannot open %s: %s", path, strerror(errno));
    while (got > 0 && status == DEM_OK)
    {
        status = DEM_GROW(*bytes, capacity, *n + CHUNK);
        /* the last byte stays zero */
        got = status == DEM_OK ? fread(*bytes + *n, 1, capacity - *n - 1, stream) : 0;
        *n += got;
    }
    if (status == DEM_OK && ferror(stream))
    {
        status = dem_error(DEM_ERROR_FILE, "cannot read %s: %s", path, strerror(errno));
    }
    fclose(stream);
    if (status != DEM_OK)
    {
        dem_memory_free(*bytes);
        *bytes = NULL;
        *n = 0;
    }
    return status;
}

int dem_file_load_text(const char *path, char **text)
{
    size_t n, line = 1;

    DEM_TRY(dem_file_load(path, text, &n));
    const size_t length = strlen(*text);

    if (length == n)
    {
        return DEM_OK;
    }
    for (size_t k = 0; k < length; k++)
    {
        line += (*text)[k] == '\n';
    }
    dem_memory_free(*text);
    *text = NULL;
    return dem_error(DEM_ERROR_FILE,
                     "%s, line %zu: found a zero byte, and plain text has none; is this the right "
                     "file? If it is, save it as UTF-8",
                     path, line);
}

int dem_file_make_folder(const char *path)
{
    errno = 0;
    DEM_REQUIRE(mkdir(path, 0777) == 0 || errno == EEXIST, DEM_ERROR_FILE,
                "cannot create the folder %s: %s; create its parent folder, or give another one",
                path, strerror(errno));
    return DEM_OK;
}

/* Where a folder of the path is none, or is closed to us, the writer has the sentence. */
bool dem_file_exists(const char *path)
{
    struct stat s;

    return stat(path, &s) == 0 || (errno != ENOENT && errno != ENOTDIR && errno != EACCES);
}
