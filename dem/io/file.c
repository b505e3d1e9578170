/*
 * file.c -- open path.part, write, rename; and read until the end.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/file.h"

#include "base/error.h"
#include "base/memory.h"

#include <errno.h>
#include <string.h>

enum
{
    CHUNK = 1 << 16    /* asked of the system at once [byte] */
};

static void forget(struct dem_file *f)
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
                           : dem_error(DEM_ERROR_FILE, "can't write %s: %s; is its folder there and yours to write?",
                                       f->part, strerror(errno));
    }
    if (status != DEM_OK)
    {
        forget(f);
    }
    return status;
}

int dem_file_finish(struct dem_file *f, int status)
{
    const int bad = ferror(f->stream);
    const int bad_end = fclose(f->stream);    /* what was buffered is written now: a full disk shows here */

    if (status == DEM_OK && (bad || bad_end))
    {
        status = dem_error(DEM_ERROR_FILE, "can't write all of %s: %s; a file of that name from before is untouched",
                           f->path, strerror(errno));
    }
    if (status == DEM_OK && rename(f->part, f->path) != 0)
    {
        status = dem_error(DEM_ERROR_FILE, "can't rename %s to %s: %s", f->part, f->path, strerror(errno));
    }
    if (status != DEM_OK)
    {
        remove(f->part);
    }
    forget(f);
    return status;
}

int dem_file_load(const char *path, char **bytes, size_t *n)
{
    FILE *stream = fopen(path, "rb");
    size_t room = 0, got = 1;
    int status = DEM_OK;

    *bytes = NULL;
    *n = 0;
    DEM_REQUIRE(stream, DEM_ERROR_FILE, "can't open %s: %s", path, strerror(errno));
    while (got > 0 && status == DEM_OK)
    {
        status = DEM_GROW(*bytes, room, *n + CHUNK);
        got = status == DEM_OK ? fread(*bytes + *n, 1, room - *n - 1, stream) : 0;    /* one byte stays zero */
        *n += got;
    }
    if (status == DEM_OK && ferror(stream))
    {
        status = dem_error(DEM_ERROR_FILE, "can't read %s: %s", path, strerror(errno));
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
    return dem_error(DEM_ERROR_FILE, "%s, line %zu: found a zero byte, and plain text has none; is this the right file? else write it anew in UTF-8", path, line);
}

bool dem_file_exists(const char *path)
{
    FILE *stream = fopen(path, "rb");

    if (stream)
    {
        fclose(stream);
        return true;
    }
    return errno != ENOENT;
}
