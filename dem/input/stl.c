/*
 * stl.c -- read triangles from text and binary STL files.
 *
 * Format: 3D Systems, StereoLithography Interface Specification (1989). A binary file is a header
 * of 80 bytes, the number of triangles (uint32) and for each triangle 12 float32 (normal, three
 * corners) and 2 bytes, little-endian. A text file is solid ... endsolid with facets.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/stl.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum
{
    HEAD = 84,   /* bytes before the first triangle */
    RECORD = 50  /* bytes of a triangle */
};

/* ---- binary ---------------------------------------------------------------------------------- */

static uint32_t read_little_endian(const char *at)
{
    uint32_t value = 0;

    for (int k = 3; k >= 0; k--)
    {
        value = value << 8 | (unsigned char)at[k];
    }
    return value;
}

static int read_binary(const char *path, const char *bytes, size_t n, double scale, double *corner)
{
    for (size_t t = 0; t < n; t++)
    {
        for (size_t k = 0; k < 9; k++)
        {
            const uint32_t bits = read_little_endian(bytes + HEAD + t*RECORD + 12 + 4*k);
            float value;

            memcpy(&value, &bits, sizeof value);
            DEM_REQUIRE(isfinite(value), DEM_ERROR_FILE,
                        "%s: triangle %zu has a corner that is not a finite number; repair the "
                        "surface",
                        path, t + 1);
            corner[9*t + k] = scale*(double)value;
        }
    }
    return DEM_OK;
}

/* ---- text ------------------------------------------------------------------------------------ */

struct text
{
    const char *path, *at;
    size_t line;
};

static void skip_space(struct text *s)
{
    for (; isspace((unsigned char)*s->at); s->at++)
    {
        s->line += *s->at == '\n';
    }
}

static size_t length_of_word(const char *at)
{
    size_t n = 0;

    while (at[n] && !isspace((unsigned char)at[n]))
    {
        n++;
    }
    return n;
}

static int is_word(const char *at, const char *word)
{
    const size_t n = strlen(word);

    for (size_t k = 0; k < n; k++)
    {
        if (tolower((unsigned char)at[k]) != word[k])
        {
            return 0;
        }
    }
    return length_of_word(at) == n;
}

static int expect(struct text *s, const char *word)
{
    skip_space(s);
    DEM_REQUIRE(*s->at, DEM_ERROR_FILE,
                "%s: the file ends in line %zu, where %s should follow; the file is truncated",
                s->path, s->line, word);
    DEM_REQUIRE(is_word(s->at, word), DEM_ERROR_FILE,
                "%s, line %zu: found %.*s where %s should be; is this an STL file?", s->path,
                s->line, (int)(length_of_word(s->at) < 40 ? length_of_word(s->at) : 40), s->at,
                word);
    s->at += strlen(word);
    return DEM_OK;
}

static void skip_line(struct text *s)
{
    while (*s->at && *s->at != '\n')
    {
        s->at++;
    }
}

static int read_corner(struct text *s, double scale, double x[3])
{
    DEM_TRY(expect(s, "vertex"));
    for (int k = 0; k < 3; k++)
    {
        char *end;

        skip_space(s);
        DEM_REQUIRE(*s->at, DEM_ERROR_FILE,
                    "%s: the file ends in line %zu in the middle of a corner; the file is "
                    "truncated",
                    s->path, s->line);
        x[k] = scale*strtod(s->at, &end);
        DEM_REQUIRE(end > s->at && (*end == '\0' || isspace((unsigned char)*end)) && isfinite(x[k]),
                    DEM_ERROR_FILE,
                    "%s, line %zu: %.*s is not a coordinate; give three numbers after vertex",
                    s->path, s->line,
                    (int)(length_of_word(s->at) < 40 ? length_of_word(s->at) : 40), s->at);
        s->at = end;
    }
    return DEM_OK;
}

static int read_facet(struct text *s, double scale, double corner[9])
{
    skip_line(s);    /* its normal */
    DEM_TRY(expect(s, "outer"));
    DEM_TRY(expect(s, "loop"));
    for (int k = 0; k < 3; k++)
    {
        DEM_TRY(read_corner(s, scale, corner + 3*k));
    }
    DEM_TRY(expect(s, "endloop"));
    return expect(s, "endfacet");
}

static int read_text(struct text *s, double scale, double **corner, size_t *n)
{
    size_t capacity = 0;
    int open = 0;

    for (skip_space(s); *s->at; skip_space(s))
    {
        if (open && is_word(s->at, "facet"))
        {
            DEM_TRY(DEM_GROW(*corner, capacity, 9*(*n + 1)));
            DEM_TRY(read_facet(s, scale, *corner + 9**n));
            ++*n;
        }
        else
        {
            DEM_TRY(expect(s, open ? "endsolid" : "solid"));
            skip_line(s);    /* its name */
            open = !open;
        }
    }
    DEM_REQUIRE(!open, DEM_ERROR_FILE,
                "%s: the file ends in line %zu without endsolid; the file is truncated", s->path,
                s->line);
    return DEM_OK;
}

/* ---- text or binary -------------------------------------------------------------------------- */

static int begins_as_text(const char *bytes)
{
    while (isspace((unsigned char)*bytes))
    {
        bytes++;
    }
    return is_word(bytes, "solid");
}

static int read(const char *path, const char *bytes, size_t size, double scale, double **corner,
                size_t *n)
{
    const size_t triangles = size >= HEAD ? read_little_endian(bytes + 80) : 0;
    const size_t needed = HEAD + triangles*RECORD;

    if (size >= HEAD && size == needed)
    {
        DEM_TRY(DEM_NEW(*corner, 9*triangles + 1));
        *n = triangles;
        return read_binary(path, bytes, triangles, scale, *corner);
    }
    if (begins_as_text(bytes))
    {
        struct text s = {.path = path, .at = bytes, .line = 1};

        DEM_REQUIRE(strlen(bytes) == size, DEM_ERROR_FILE,
                    "%s begins with solid, but is neither text nor a binary STL file of %zu "
                    "triangles, which would have %zu bytes; it has %zu",
                    path, triangles, needed, size);
        return read_text(&s, scale, corner, n);
    }
    DEM_REQUIRE(size >= HEAD, DEM_ERROR_FILE,
                "%s has %zu bytes and does not begin with solid; it is not an STL file", path,
                size);
    return dem_error(DEM_ERROR_FILE,
                     "%s has %zu bytes; a binary STL file of %zu triangles, the number in its "
                     "header, has %zu: the file is truncated or is not an STL file",
                     path, size, triangles, needed);
}

int dem_stl_read(const char *path, double scale, double **corners, size_t *n)
{
    char *bytes;
    size_t size;

    *corners = NULL;
    *n = 0;
    DEM_TRY(dem_file_load(path, &bytes, &size));
    int status = read(path, bytes, size, scale, corners, n);

    dem_memory_free(bytes);
    if (!status && *n == 0)
    {
        status = dem_error(DEM_ERROR_FILE, "%s contains no triangle", path);
    }
    if (status)
    {
        dem_memory_free(*corners);
        *corners = NULL;
    }
    return status;
}
