/*
 * file.h -- whole files: read at once, and written beside their name until they are complete.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Whoever reads the name sees the old file or the new one, never a half; a full disk or a killed run leaves the
 * old one. Errors of the writes in between need no care: they show in dem_file_finish.
 *
 *     struct dem_file f;
 *     DEM_TRY(dem_file_begin(&f, path));
 *     status = write_all(f.stream);
 *     return dem_file_finish(&f, status);     a status that is not DEM_OK removes the piece and comes back
 */
#ifndef DEM_IO_FILE_H
#define DEM_IO_FILE_H

#include <stdbool.h>
#include <stdio.h>

struct dem_file
{
    FILE *stream;
    char *path, *part;    /* the name, and the name it has until then: path.part */
};

int dem_file_begin(struct dem_file *f, const char *path);
int dem_file_finish(struct dem_file *f, int status);

/* All bytes of a file and a zero behind them; the caller gives them back with dem_memory_free. */
int dem_file_load(const char *path, char **bytes, size_t *n);

/* The same of a text, which holds no zero: DEM_ERROR_FILE with the line where one is. */
int dem_file_load_text(const char *path, char **text);

/* False only when there is no such file; one that can't be read is there. */
bool dem_file_exists(const char *path);

#endif
