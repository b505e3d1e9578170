/*
 * test_stl.c -- surface files in STL format, text and binary.
 *
 * - Both give the same triangles, whatever the case, spaces and normals; several solids give one
 *   list.
 * - A binary file with a header that begins with "solid" is read as binary.
 * - A file that is truncated anywhere, is of another kind or contains a value that is not a number
 *   is refused with its line or triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "core/error.h"
#include "core/memory.h"
#include "input/stl.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char path[] = "/tmp/test_stl_XXXXXX";

static const char text[] =
    "solid one\n"
    "  facet normal 0 0 1\n"
    "    outer loop\n"
    "      vertex 0 0 0\n"
    "      vertex 1.5 0 0\n"
    "      vertex 0 2.5e0 -0.25\n"
    "    endloop\n"
    "  endfacet\n"
    "endsolid one\n"
    "\n"
    "SOLID\n"
    "FACET NORMAL nan nan nan\n"
    "OUTER LOOP VERTEX 1 2 3 VERTEX 4 5 6 VERTEX 7 8 10\n"
    "ENDLOOP ENDFACET\n"
    "ENDSOLID\n";
static const double corners[18] = {0, 0, 0, 1.5, 0, 0, 0, 2.5, -0.25, 1, 2, 3, 4, 5, 6, 7, 8, 10};

static void write_file(const void *bytes, size_t n)
{
    FILE *const f = fopen(path, "wb");

    if (!f || fwrite(bytes, 1, n, f) != n || fclose(f) != 0)
    {
        printf("Bail out! cannot write %s\n", path);
        exit(1);
    }
}

static void accepted(const char *what, const void *bytes, size_t size)
{
    double *corner = NULL;
    size_t n = 0;

    write_file(bytes, size);
    const int status = dem_stl_read(path, 0.5, &corner, &n);

    TAP_OK(status == DEM_OK && n == 2, "%s: is read (%s)", what,
           status ? dem_error_text() : "two triangles");
    int same = n == 2;

    for (size_t k = 0; k < 18 && same; k++)
    {
        same = corner[k] <= 0.5*corners[k] && corner[k] >= 0.5*corners[k];
    }
    TAP_OK(same, "%s: has the triangles, scaled", what);
    dem_memory_free(corner);
}

static void refused(const char *what, const void *bytes, size_t size, const char *word)
{
    double *corner = (double *)path;
    size_t n = 7;

    write_file(bytes, size);
    const int status = dem_stl_read(path, 1.0, &corner, &n);

    TAP_OK(status != DEM_OK && corner == NULL, "%s: is refused", what);
    TAP_OK(strstr(dem_error_text(), word) && strstr(dem_error_text(), path),
           "%s: the sentence names \"%s\": %s", what, word, dem_error_text());
}

static void faulty(const char *what, const char *old, const char *new, const char *word)
{
    char other[sizeof text + 40];
    const char *const at = strstr(text, old);

    snprintf(other, sizeof other, "%.*s%s%s", (int)(at - text), text, new, at + strlen(old));
    refused(what, other, strlen(other), word);
}

static size_t binary(char *out, const char *head)
{
    const uint32_t n = 2;

    memset(out, 0, 84 + 100);
    memcpy(out, head, strlen(head));
    memcpy(out + 80, &n, 4);
    for (int k = 0; k < 18; k++)
    {
        const float value = (float)corners[k];

        memcpy(out + 84 + k/9*50 + 12 + 4*(k%9), &value, 4);
    }
    return 184;
}

int main(void)
{
    char bytes[200];
    const float none = strtof("nan", NULL);
    int all = 1;

    TAP_TRAPS;
    close(mkstemp(path));
    accepted("text", text, sizeof text - 1);
    accepted("binary", bytes, binary(bytes, "some program"));
    accepted("binary that begins with solid", bytes, binary(bytes, "solid in name only"));

    faulty("an unknown word", "outer", "outre", "line 3");
    faulty("a corner that is a word", "1.5 0", "1.5 zero", "line 5");
    faulty("a corner that is not a number", "2.5e0", "nan", "line 6");
    faulty("an infinite corner", "2.5e0", "inf", "line 6");
    faulty("a number that ends in letters", "2.5e0", "2.5m", "line 6");
    faulty("a corner too few", "      vertex 1.5 0 0\n", "", "line 6");
    faulty("a second solid in the first", "endsolid one\n", "", "line 10");
    refused("an empty file", "", 0, "STL");
    refused("another text", "It was a dark night\n", 20, "STL");
    refused("solids without triangles", "solid x\nendsolid x\n", 19, "no triangle");
    const char *const end = strstr(text, "endsolid one");

    for (size_t n = 12; n < (size_t)(end - text); n += 3)
    {
        double *corner;
        size_t count;

        write_file(text, n);
        all &= dem_stl_read(path, 1.0, &corner, &count) != DEM_OK;
    }
    TAP_OK(all, "text truncated anywhere in the first solid: is refused");
    refused("text truncated in a triangle", text, 90, "truncated");
    for (size_t n = 1; n < binary(bytes, "some program"); n++)
    {
        double *corner;
        size_t count;

        write_file(bytes, n);
        all &= dem_stl_read(path, 1.0, &corner, &count) != DEM_OK;
    }
    TAP_OK(all, "binary truncated anywhere: is refused");
    refused("binary truncated", bytes, 150, "truncated");
    refused("binary, a byte too many", bytes, 185, "184");
    memcpy(bytes + 84 + 50 + 12, &none, sizeof none);
    refused("binary with a corner that is not a number", bytes, 184, "triangle 2");
    unlink(path);
    TAP_DONE;
}
