/*
 * test_vtk.c -- files for ParaView are read back with the same bits, and a collection is complete
 * after each entry.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "core/file.h"
#include "records/vtk.h"

#include <stdlib.h>
#include <string.h>

static char folder[] = "/tmp/vtk.XXXXXX", path[64];

struct grain
{
    double x[3], diameter, stress[9];
    int64_t id;
};

static struct grain *make_grains(int64_t n)
{
    struct grain *g = calloc((size_t)n + 1, sizeof *g);

    for (int64_t i = 0; i < n; i++)
    {
        for (int k = 0; k < 9; k++)
        {
            g[i].x[k%3] = dem_random_unit(1, (uint64_t)i, 0, (uint64_t)(k%3));
            g[i].stress[k] = dem_random_unit(1, (uint64_t)i, 1, (uint64_t)k) - 0.5;
        }
        g[i].diameter = 1e-3*(1 + dem_random_unit(1, (uint64_t)i, 2, 0));
        g[i].id = INT64_MAX - 7*i;
    }
    return g;
}

static int write_grains(int64_t n, const struct grain *g)
{
    const struct dem_vtk_column columns[] = {
        {"points", g->x, sizeof *g, DEM_VTK_DOUBLE, 3},
        {"id", &g->id, sizeof *g, DEM_VTK_INT64, 1},
        {"diameter", &g->diameter, sizeof *g, DEM_VTK_FLOAT32, 1},
        {"stress", g->stress, sizeof *g, DEM_VTK_DOUBLE, 9},
    };

    return dem_vtk_write(NULL, path, n, columns, 4);
}

/* Find an array as a reader does: type and components in the header, bytes at the offset. Null if
   wrong. */
static const char *find(const char *file, size_t size, const char *name, const char *type,
                        int components, uint64_t bytes)
{
    char head[160];
    const char *data = strstr(file, "encoding=\"raw\">\n_"), *at;
    uint64_t length;
    long long offset;

    snprintf(head, sizeof head,
             "type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"",
             type, name, components);
    at = strstr(file, head);
    if (!at || !data || sscanf(at + strlen(head), "%lld", &offset) != 1 || offset < 0)
    {
        return NULL;
    }
    data += (long long)strlen("encoding=\"raw\">\n_") + offset;
    if (data + sizeof length > file + size)
    {
        return NULL;
    }
    memcpy(&length, data, sizeof length);
    return length == bytes && data + sizeof length + length <= file + size ? data + sizeof length
                                                                           : NULL;
}

static void read_back(int64_t n)
{
    const size_t N = (size_t)n;
    struct grain *g = make_grains(n);
    const char *x, *id, *d, *s, *c, *o, *tail = "\n  </AppendedData>\n</VTKFile>\n";
    char *file = NULL, piece[128];
    size_t size = 0, wrong = 0;

    TAP_OK(!write_grains(n, g) && !dem_file_load(path, &file, &size), "%lld grains are written: %s",
           (long long)n, dem_error_text());
    snprintf(piece, sizeof piece, "<Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"%lld\" ",
             (long long)n, (long long)n);
    TAP_OK(strstr(file, piece) &&
               strstr(file, "byte_order=\"LittleEndian\" header_type=\"UInt64\""),
           "the header has numbers and byte order");
    x = find(file, size, "points", "Float64", 3, 24*N);
    id = find(file, size, "id", "Int64", 1, 8*N);
    d = find(file, size, "diameter", "Float32", 1, 4*N);
    s = find(file, size, "stress", "Float64", 9, 72*N);
    c = find(file, size, "connectivity", "Int64", 1, 8*N);
    o = find(file, size, "offsets", "Int64", 1, 8*N);
    if (!TAP_OK(x && id && d && s && c && o,
                "every array is at the position of the header, with its length"))
    {
        return;
    }
    TAP_OK(memcmp(o + 8*N, tail, strlen(tail)) == 0 && o + 8*N + strlen(tail) == file + size,
           "the file has nothing else");
    for (size_t i = 0; i < N; i++)
    {
        const float diameter = (float)g[i].diameter;
        const int64_t cell = (int64_t)i, end = cell + 1;

        wrong += memcmp(x + 24*i, g[i].x, 24) || memcmp(id + 8*i, &g[i].id, 8) ||
                 memcmp(d + 4*i, &diameter, 4) || memcmp(s + 72*i, g[i].stress, 72) ||
                 memcmp(c + 8*i, &cell, 8) ||
                 memcmp(o + 8*i, &end, 8);
    }
    TAP_OK(wrong == 0, "%zu of %zu grains differ", wrong, N);
    dem_memory_free(file);
    free(g);
}

static void narrow_numbers(void)
{
    const double d[5] = {1e300, -1e300, 1e-300, 0.1, (double)NAN}, x[3] = {0, 0, 0};
    const struct dem_vtk_column columns[] = {{"points", x, 24, DEM_VTK_FLOAT32, 3},
                                             {"d", d, 40, DEM_VTK_FLOAT32, 5}};
    const char *at;
    char *file = NULL;
    size_t size;
    float f[5] = {0};

    TAP_OK(!dem_vtk_write(NULL, path, 1, columns, 2) && !dem_file_load(path, &file, &size) &&
               (at = find(file, size, "d", "Float32", 5, 20)) && memcpy(f, at, 20),
           "five doubles as Float32");
    TAP_OK(f[0] == INFINITY && f[1] == -INFINITY && f[2] == 0 && f[3] == 0.1f && isnan(f[4]),
           "values beyond Float32 are infinite, without a trap");
    dem_memory_free(file);
}

static void triangles(void)
{
    double corner[18];
    const int64_t wall[2] = {7, -1}, connectivity[6] = {0, 1, 2, 3, 4, 5}, offsets[2] = {3, 6};
    char *file = NULL;
    size_t size;

    for (int k = 0; k < 18; k++)
    {
        corner[k] = dem_random_unit(2, (uint64_t)k, 0, 0);
    }
    TAP_OK(!dem_vtk_write_triangles(path, 2, corner, wall, NULL) && !dem_file_load(path, &file, &size),
           "two triangles are written");
    const char *const x = find(file, size, "points", "Float64", 3, sizeof corner), *const w =
                                                                                       find(file,
                                                                                            size,
                                                                                            "wall",
                                                                                            "Int64",
                                                                                            1, 16);
    const char *const c = find(file, size, "connectivity", "Int64", 1, 48), *const o =
                                                                                find(file, size,
                                                                                     "offsets",
                                                                                     "Int64", 1,
                                                                                     16);

    TAP_OK(strstr(file, "<Piece NumberOfPoints=\"6\" NumberOfVerts=\"0\"") &&
               strstr(file, "NumberOfPolys=\"2\">"),
           "the header has the numbers");
    TAP_OK(x && w && c && o && memcmp(x, corner, sizeof corner) == 0 && memcmp(w, wall, 16) == 0 &&
               memcmp(c, connectivity, 48) == 0 && memcmp(o, offsets, 16) == 0,
           "corners, walls and cells are at the positions of the header");
    dem_memory_free(file);
}

static void refused(int status, int expected, const char *words)
{
    TAP_OK(status == expected && strstr(dem_error_text(), words), "refused: %s", dem_error_text());
}

static void refusals(void)
{
    const double x[3] = {0};
    const struct dem_vtk_column c[1] = {{"points", x, 24, DEM_VTK_DOUBLE, 3}};
    char elsewhere[80];

    snprintf(elsewhere, sizeof elsewhere, "%s/absent/a.vtp", folder);
    refused(dem_vtk_write(NULL, elsewhere, 1, c, 1), DEM_ERROR_FILE, "folder");
    refused(dem_vtk_write(NULL, folder, 1, c, 1), DEM_ERROR_FILE, "rename");
    snprintf(elsewhere, sizeof elsewhere, "%s.part", folder);
    TAP_OK(!dem_file_exists(elsewhere), "an incomplete file is removed");
}

/* True if the collection is complete, with these entries. */
static int collection_is(const char *entries)
{
    char *file = NULL, expected[1024];
    size_t size;

    snprintf(expected, sizeof expected,
             "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
             "  <Collection>\n%s  </Collection>\n</VTKFile>\n",
             entries);
    const int same = !dem_file_load(path, &file, &size) && strcmp(file, expected) == 0;

    dem_memory_free(file);
    return same;
}

#define ENTRY(time, file) "    <DataSet timestep=\"" time "\" file=\"" file "\"/>\n"

static void collection(void)
{
    remove(path);
    TAP_OK(!dem_vtk_collection_add(path, 0.0, "VTK/0.vtp") &&
               collection_is(ENTRY("0", "VTK/0.vtp")),
           "the first entry makes a complete collection");
    TAP_OK(!dem_vtk_collection_add(path, 0.1, "VTK/1.vtp") &&
               !dem_vtk_collection_add(path, 0.1 + 0.2, "VTK/2.vtp") &&
               !dem_vtk_collection_add(path, 1e-7*4e7, "VTK/3.vtp"),
           "three more");
    TAP_OK(collection_is(ENTRY("0", "VTK/0.vtp") ENTRY("0.1", "VTK/1.vtp")
                             ENTRY("0.30000000000000004", "VTK/2.vtp")
                                 ENTRY("4", "VTK/3.vtp")),
           "all are in order, with exact times");
    TAP_OK(!dem_vtk_collection_add(path, 0.1 + 0.2, "b.vtp") &&
               collection_is(ENTRY("0", "VTK/0.vtp") ENTRY("0.1", "VTK/1.vtp")
                                 ENTRY("0.30000000000000004", "b.vtp")),
           "a restart drops its own time and later ones");
    TAP_OK(!dem_vtk_collection_add(path, 0.2, "c.vtp") &&
               !dem_vtk_collection_add(path, 0.25, "c.vtp") &&
               collection_is(ENTRY("0", "VTK/0.vtp") ENTRY("0.1", "VTK/1.vtp")
                                 ENTRY("0.25", "c.vtp")),
           "a file written again has one entry");
}

static void write_text(const char *text)
{
    FILE *f = fopen(path, "w");

    fputs(text, f);
    fclose(f);
}

static void bad_collections(void)
{
    refused(dem_vtk_collection_add(path, (double)NAN, "x"), DEM_ERROR_STATE, "finite");
    write_text("not xml");
    refused(dem_vtk_collection_add(path, 1.0, "x"), DEM_ERROR_FILE, "not a collection");
    write_text("<Collection><DataSet timestep=\"1e999\" file=\"a\"/>");
    refused(dem_vtk_collection_add(path, 1.0, "x"), DEM_ERROR_FILE, "without a timestep");
    write_text("<Collection><DataSet timestep=\"1");
    refused(dem_vtk_collection_add(path, 1.0, "x"), DEM_ERROR_FILE, "without a timestep");
}

int main(void)
{
    TAP_TRAPS;
    TAP_OK(mkdtemp(folder) != NULL, "a folder");
    snprintf(path, sizeof path, "%s/a.vtp", folder);
    read_back(10000);
    read_back(1);
    read_back(0);
    narrow_numbers();
    triangles();
    refusals();
    collection();
    bad_collections();
    remove(path);
    TAP_OK(remove(folder) == 0, "no other file is left");
    TAP_DONE;
}
