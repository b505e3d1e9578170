/*
 * file.h -- whole files: read at once, and written under a temporary name until they are complete.
 *
 * A reader of the path sees the old file or the new one, never a partial one; a full disk or a
 * killed run leaves the old one. Errors of the writes in between need no check: dem_file_finish
 * reports them.
 *
 *     struct dem_file f;
 *     DEM_TRY(dem_file_begin(&f, path));
 *     status = write_all(f.stream);
 *     return dem_file_finish(&f, status);     with a status other than DEM_OK the temporary file is
 *                                             removed and the status is returned
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include <stdbool.h>
#include <stdio.h>

struct dem_file
{
    FILE *stream;
    char *path, *part;  /* the final name, and the temporary one: path.part */
};

/* Open path.part for writing. */
int dem_file_begin(struct dem_file *f, const char *path);

/* Close the file and rename it to path, or remove it when `status` or a write failed. */
int dem_file_finish(struct dem_file *f, int status);

/* Refuse a folder, pipe, socket or device: reading it would fail late, wait or never end. */
int dem_file_refuse_others(const char *path);

/* All bytes of a file, followed by a zero byte; the caller frees them with dem_memory_free. */
int dem_file_load(const char *path, char **bytes, size_t *n);

/* The same for plain text; DEM_ERROR_FILE with the line when it contains a zero byte. */
int dem_file_load_text(const char *path, char **text);

/* Create a folder, unless it exists; not those around it. */
int dem_file_make_folder(const char *path);

/* True also for a file that cannot be read. */
bool dem_file_exists(const char *path);
