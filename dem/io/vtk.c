/*
 * vtk.c -- a .vtp file: a head in XML that says where each array begins, then the arrays.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * All sizes are known before the first byte is written: an array is its length in bytes (UInt64), then its values.
 */
#include "io/vtk.h"

#include "base/error.h"
#include "io/file.h"

#include <fenv.h>
#include <stdbool.h>
#include <string.h>

enum
{
    COMPONENTS = 9,       /* most in one column: a tensor                   */
    BLOCK = 1 << 14       /* bytes collected before they go to the file     */
};

static const struct
{
    const char *name;
    size_t size;          /* in the file   [byte] */
    size_t in_memory;     /* of one number [byte] */
} types[] = {
    [DEM_VTK_DOUBLE] = {"Float64", 8, 8},
    [DEM_VTK_NARROW] = {"Float32", 4, 8},
    [DEM_VTK_INT64] = {"Int64", 8, 8},
    [DEM_VTK_INT32] = {"Int32", 4, 4},
};

struct block
{
    char bytes[BLOCK];
    size_t used;
    FILE *file;
};

static void block_flush(struct block *b)
{
    fwrite(b->bytes, 1, b->used, b->file);
    b->used = 0;
}

static void block_put(struct block *b, const void *bytes, size_t size)
{
    if (b->used + size > BLOCK)
    {
        block_flush(b);
    }
    memcpy(b->bytes + b->used, bytes, size);
    b->used += size;
}

static int check_column(const struct dem_vtk_column *c, int64_t n, const char *path)
{
    const bool known = c->type == DEM_VTK_DOUBLE || c->type == DEM_VTK_NARROW || c->type == DEM_VTK_INT64
                       || c->type == DEM_VTK_INT32;

    DEM_REQUIRE(c->name && *c->name && !strpbrk(c->name, "<>&\"\n"), DEM_ERROR_INPUT,
                "%s: \"%s\" can't name a column; use a word without < > & \"", path, c->name ? c->name : "");
    DEM_REQUIRE(known, DEM_ERROR_STATE, "%s: column %s has an unknown type %d", path, c->name, (int)c->type);
    DEM_REQUIRE(c->components >= 1 && c->components <= COMPONENTS, DEM_ERROR_STATE,
                "%s: column %s has %d components; give 1 to %d", path, c->name, c->components, COMPONENTS);
    DEM_REQUIRE(n == 0 || (c->data && c->stride >= types[c->type].in_memory*(size_t)c->components), DEM_ERROR_STATE,
                "%s: column %s has no data or a stride of %zu bytes, too small for %d numbers", path, c->name,
                c->stride, c->components);
    return DEM_OK;
}

static int check(const char *path, int64_t n, const struct dem_vtk_column *columns, int count, int ends)
{
    DEM_REQUIRE(n >= 0 && n < INT64_MAX/(8*COMPONENTS), DEM_ERROR_STATE, "%s: can't hold %lld particles", path,
                (long long)n);
    DEM_REQUIRE(count >= 1 && columns[0].components == 3*ends
                && (columns[0].type == DEM_VTK_DOUBLE || columns[0].type == DEM_VTK_NARROW),
                DEM_ERROR_STATE, "%s: the first column must be positions, %s doubles each", path, ends == 1 ? "three" : "six");
    for (int i = 0; i < count; i++)
    {
        DEM_TRY(check_column(&columns[i], n, path));
        for (int k = 0; k < i; k++)
        {
            DEM_REQUIRE(strcmp(columns[k].name, columns[i].name) != 0, DEM_ERROR_INPUT,
                        "%s: two columns are named %s; rename one", path, columns[i].name);
        }
    }
    return DEM_OK;
}

/* One <DataArray>; moves the offset past the array's length and values. */
static void head_array(FILE *f, const char *name, const char *type, int components, uint64_t bytes, uint64_t *offset)
{
    fprintf(f, "        <DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" ", type, name, components);
    fprintf(f, "format=\"appended\" offset=\"%llu\"/>\n", (unsigned long long)*offset);
    *offset += sizeof(uint64_t) + bytes;
}

static uint64_t bytes_of(const struct dem_vtk_column *c, int64_t n)
{
    return (uint64_t)n*(uint64_t)c->components*types[c->type].size;
}

/* `ends` of a cell: 1 for points, 2 for lines, whose ends are the points and whose columns belong to the cells. */
static void write_head(FILE *f, int64_t n, const struct dem_vtk_column *columns, int count, int ends)
{
    const char *const data = ends == 1 ? "PointData" : "CellData", *const cells = ends == 1 ? "Verts" : "Lines";
    const uint16_t one = 1;
    const bool little = *(const unsigned char *)&one == 1;
    uint64_t offset = 0;

    fprintf(f, "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n",
            little ? "LittleEndian" : "BigEndian");
    fprintf(f, "  <PolyData>\n    <Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"%lld\" NumberOfLines=\"%lld\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n", (long long)n*ends, ends == 1 ? (long long)n : 0,
            ends == 1 ? 0 : (long long)n);
    for (int i = 0; i < count; i++)
    {
        i == 0 ? fputs("      <Points>\n", f) : i == 1 ? fprintf(f, "      <%s>\n", data) : 0;
        head_array(f, columns[i].name, types[columns[i].type].name, i == 0 ? 3 : columns[i].components, bytes_of(&columns[i], n),
                   &offset);
        i == 0 ? fputs("      </Points>\n", f) : i == count - 1 ? fprintf(f, "      </%s>\n", data) : 0;
    }
    fprintf(f, "      <%s>\n", cells);
    head_array(f, "connectivity", "Int64", 1, (uint64_t)n*(uint64_t)ends*sizeof(int64_t), &offset);
    head_array(f, "offsets", "Int64", 1, (uint64_t)n*sizeof(int64_t), &offset);
    fprintf(f, "      </%s>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_", cells);
}

static void write_column(struct block *b, int64_t n, const struct dem_vtk_column *c)
{
    const uint64_t bytes = bytes_of(c, n);
    const char *at = c->data;

    block_put(b, &bytes, sizeof bytes);
    for (int64_t i = 0; i < n; i++, at += c->stride)
    {
        if (c->type == DEM_VTK_NARROW)
        {
            double from[COMPONENTS];
            float to[COMPONENTS];

            memcpy(from, at, sizeof *from*(size_t)c->components);
            for (int k = 0; k < c->components; k++)
            {
                to[k] = (float)from[k];
            }
            block_put(b, to, sizeof *to*(size_t)c->components);
        }
        else
        {
            block_put(b, at, types[c->type].size*(size_t)c->components);
        }
    }
}

/* first, first + step, ...: cells hold points one after the other (connectivity: 0, 1, ...) and end before the next one's
   first (offsets: 1, 2, ... or 2, 4, ...) */
static void write_counts(struct block *b, int64_t n, int64_t first, int64_t step)
{
    const uint64_t bytes = (uint64_t)n*sizeof n;

    block_put(b, &bytes, sizeof bytes);
    for (int64_t i = 0; i < n; i++)
    {
        const int64_t value = first + i*step;

        block_put(b, &value, sizeof value);
    }
}

static int write_cells(const char *path, int64_t n, const struct dem_vtk_column *columns, int count, int ends)
{
    struct dem_file f;
    struct block b = {.used = 0};
    fenv_t traps;

    DEM_TRY(check(path, n, columns, count, ends));
    DEM_TRY(dem_file_begin(&f, path));
    feholdexcept(&traps);    /* a double past the range of Float32 is written as infinite, also under traps */
    b.file = f.stream;
    write_head(f.stream, n, columns, count, ends);
    for (int i = 0; i < count; i++)
    {
        write_column(&b, n, &columns[i]);
    }
    write_counts(&b, n*ends, 0, 1);
    write_counts(&b, n, ends, ends);
    block_flush(&b);
    fesetenv(&traps);
    fputs("\n  </AppendedData>\n</VTKFile>\n", f.stream);
    return dem_file_finish(&f, DEM_OK);
}

int dem_vtk_write(const char *path, int64_t n, const struct dem_vtk_column *columns, int count)
{
    return write_cells(path, n, columns, count, 1);
}

int dem_vtk_write_lines(const char *path, int64_t n, const struct dem_vtk_column *columns, int count)
{
    return write_cells(path, n, columns, count, 2);
}
