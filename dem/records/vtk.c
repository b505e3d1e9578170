/*
 * vtk.c -- parallel writer of .vtp files: an XML header with the offset of each array, then the
 * arrays.
 *
 * All sizes are known before the first byte is written: an array is its length in bytes (UInt64),
 * then its values in the order of ranks. Each rank builds the same header and so knows all
 * offsets; the first rank writes the header, the lengths and the tail.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/vtk.h"

#include "core/error.h"
#include "core/memory.h"

#include <fenv.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum
{
    MAX_COMPONENTS = 9,    /* of one column: a tensor              */
    BLOCK = 1 << 24        /* bytes packed before they are written */
};

static const struct
{
    const char *name;
    size_t size;          /* in the file   [byte] */
    size_t in_memory;     /* of one number [byte] */
} types[] = {
    [DEM_VTK_DOUBLE] = {"Float64", 8, 8},
    [DEM_VTK_FLOAT32] = {"Float32", 4, 8},
    [DEM_VTK_INT64] = {"Int64", 8, 8},
    [DEM_VTK_INT32] = {"Int32", 4, 4},
};

static int check_column(const struct dem_vtk_column *c, int64_t n, const char *path)
{
    const bool known = c->type == DEM_VTK_DOUBLE || c->type == DEM_VTK_FLOAT32 ||
                       c->type == DEM_VTK_INT64 || c->type == DEM_VTK_INT32;

    DEM_REQUIRE(c->name && *c->name && !strpbrk(c->name, "<>&\"\n"), DEM_ERROR_INPUT,
                "%s: \"%s\" cannot name a column; use a word without < > & \"", path,
                c->name ? c->name : "");
    DEM_REQUIRE(known, DEM_ERROR_STATE, "%s: column %s has an unknown type %d", path, c->name,
                (int)c->type);
    DEM_REQUIRE(c->components >= 1 && c->components <= MAX_COMPONENTS, DEM_ERROR_STATE,
                "%s: column %s has %d components; give 1 to %d", path, c->name, c->components,
                MAX_COMPONENTS);
    DEM_REQUIRE(n == 0 ||
                    (c->data && c->stride >= types[c->type].in_memory*(size_t)c->components),
                DEM_ERROR_STATE,
                "%s: column %s has no data or a stride of %zu bytes, too small for %d numbers",
                path, c->name, c->stride, c->components);
    return DEM_OK;
}

static int check(const char *path, int64_t n, const struct dem_vtk_column *columns, int count,
                 int ends)
{
    DEM_REQUIRE(n >= 0 && n < INT64_MAX/(8*MAX_COMPONENTS), DEM_ERROR_STATE,
                "%s: cannot hold %lld particles", path, (long long)n);
    DEM_REQUIRE(count >= 1 && columns[0].components == 3*ends &&
                    (columns[0].type == DEM_VTK_DOUBLE || columns[0].type == DEM_VTK_FLOAT32),
                DEM_ERROR_STATE, "%s: the first column must be positions, %s doubles each", path,
                ends == 1 ? "three" : "six");
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

/* ---- header ---------------------------------------------------------------------------------- */

struct text
{
    char *at;
    size_t length, capacity;
    int status;
};

/* printf to the end of the text; the first failure is stored in its status. */
static void append(struct text *t, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    const int more = vsnprintf(NULL, 0, format, list);

    va_end(list);
    t->status = t->status ? t->status : DEM_GROW(t->at, t->capacity, t->length + (size_t)more + 1);
    if (!t->status)
    {
        va_start(list, format);
        t->length += (size_t)vsnprintf(t->at + t->length, (size_t)more + 1, format, list);
        va_end(list);
    }
}

/* One <DataArray>; advances the offset by the array's length field and values. */
static void declare_array(struct text *t, const char *name, const char *type, int components,
                          uint64_t bytes, uint64_t *offset)
{
    append(
        t,
        "        <DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"%llu\"/>\n",
        type, name, components, (unsigned long long)*offset);
    *offset += sizeof(uint64_t) + bytes;
}

static uint64_t bytes_of(const struct dem_vtk_column *c, int64_t n)
{
    return (uint64_t)n*(uint64_t)c->components*types[c->type].size;
}

/* `ends` of a cell: 1 for points; 2 for lines, whose ends are the points and whose columns
   belong to the cells. */
static void write_header(struct text *t, const char *comment, int64_t n,
                         const struct dem_vtk_column *columns, int count, int ends)
{
    const char *const data = ends == 1 ? "PointData" : "CellData";
    const char *const cells = ends == 1 ? "Verts" : "Lines";
    const uint16_t one = 1;
    const bool little = *(const unsigned char *)&one == 1;
    uint64_t offset = 0;

    append(t, "<?xml version=\"1.0\"?>\n");
    if (comment)
    {
        append(t, "<!-- %s -->\n", comment);
    }
    append(t,
           "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n",
           little ? "LittleEndian" : "BigEndian");
    append(
        t,
        "  <PolyData>\n    <Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"%lld\" NumberOfLines=\"%lld\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
        (long long)n*ends, ends == 1 ? (long long)n : 0, ends == 1 ? 0 : (long long)n);
    for (int i = 0; i < count; i++)
    {
        append(t, i == 0 ? "      <Points>\n" : i == 1 ? "      <%s>\n" : "", data);
        declare_array(t, columns[i].name, types[columns[i].type].name,
                      i == 0 ? 3 : columns[i].components, bytes_of(&columns[i], n), &offset);
        append(t, i == 0 ? "      </Points>\n" : i == count - 1 ? "      </%s>\n" : "", data);
    }
    append(t, "      <%s>\n", cells);
    declare_array(t, "connectivity", "Int64", 1, (uint64_t)n*(uint64_t)ends*sizeof(int64_t),
                  &offset);
    declare_array(t, "offsets", "Int64", 1, (uint64_t)n*sizeof(int64_t), &offset);
    append(t, "      </%s>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_",
           cells);
}

/* ---- arrays ---------------------------------------------------------------------------------- */

struct vtp_file                /* a file being written; the arrays follow each other */
{
    struct dem_parallel_file store;
    size_t at;                 /* offset of the next array */
    int64_t n, before, all;    /* cells of this rank, of lower ranks, of all */
    char *block;
};

static void narrow(const char *from, char *to, size_t components)
{
    double wide[MAX_COMPONENTS];
    float small[MAX_COMPONENTS];

    memcpy(wide, from, components*sizeof *wide);
    for (size_t k = 0; k < components; k++)
    {
        small[k] = (float)wide[k];
    }
    memcpy(to, small, components*sizeof *small);
}

/* Items [first, first + count) in the form of the file. */
static void pack_column(const void *source, int64_t first, size_t count, char *out)
{
    const struct dem_vtk_column *const c = source;
    const size_t components = (size_t)c->components, size = components*types[c->type].size;
    const char *at = (const char *)c->data + (size_t)first*c->stride;

    for (size_t i = 0; i < count; i++, at += c->stride, out += size)
    {
        if (c->type == DEM_VTK_FLOAT32)
        {
            narrow(at, out, components);
        }
        else
        {
            memcpy(out, at, size);
        }
    }
}

/* The sequence from, from + step, ...: connectivity is 0, 1, ..., because the cells use the
   points in order; offsets are 1, 2, ... or 2, 4, ... */
struct counts
{
    int64_t from, step;
};

static void pack_counts(const void *source, int64_t first, size_t count, char *out)
{
    const struct counts *const c = source;

    for (size_t i = 0; i < count; i++)
    {
        const int64_t value = c->from + (first + (int64_t)i)*c->step;

        memcpy(out + i*sizeof value, &value, sizeof value);
    }
}

typedef void packer(const void *source, int64_t first, size_t count, char *out);

/* Collective. Write one array with `each` items per cell, of `size` bytes each. */
static void write_array(struct vtp_file *p, packer *pack, const void *source, int64_t each,
                        size_t size)
{
    const int64_t n = p->n*each, block = (int64_t)(BLOCK/size);
    const uint64_t bytes = (uint64_t)(p->all*each)*size;
    int64_t rounds = (n + block - 1)/block;

    if (p->store.by.rank == 0)
    {
        dem_parallel_file_write(&p->store, p->at, &bytes, sizeof bytes);
    }
    rounds = dem_parallel_file_max(&p->store, rounds);
    for (int64_t k = 0; k < rounds; k++)
    {
        const int64_t first = k*block < n ? k*block : n,
                      count = n - first < block ? n - first : block;

        pack(source, first, (size_t)count, p->block);
        dem_parallel_file_write_all(&p->store,
                                    p->at + sizeof bytes +
                                        (size_t)(p->before*each + first)*size,
                                    p->block, (size_t)count*size);
    }
    p->at += sizeof bytes + bytes;
}

static void write_tail(struct vtp_file *p)
{
    static const char tail[] = "\n  </AppendedData>\n</VTKFile>\n";

    if (p->store.by.rank == 0)
    {
        dem_parallel_file_write(&p->store, p->at, tail, sizeof tail - 1);
    }
}

static void write_body(struct vtp_file *p, const struct text *head,
                       const struct dem_vtk_column *columns, int count, int ends)
{
    const struct counts points = {p->before*ends, 1}, cells = {(p->before + 1)*ends, ends};

    p->at = head->length;
    if (p->store.by.rank == 0)
    {
        dem_parallel_file_write(&p->store, 0, head->at, head->length);
    }
    for (int i = 0; i < count; i++)
    {
        write_array(p, pack_column, &columns[i], 1, bytes_of(&columns[i], 1));
    }
    write_array(p, pack_counts, &points, ends, sizeof(int64_t));
    write_array(p, pack_counts, &cells, 1, sizeof(int64_t));
    write_tail(p);
}

static int write_cells(const struct dem_file_ranks *by, const char *path, int64_t n,
                       const struct dem_vtk_column *columns, int count, int ends)
{
    const struct dem_file_ranks alone = {.comm = MPI_COMM_NULL};
    struct text head = {.at = NULL};
    struct vtp_file p = {.n = n};
    fenv_t traps;

    by = by ? by : &alone;
    int status = check(path, n, columns, count, ends);

    status = status ? status : DEM_NEW(p.block, BLOCK);
    status = dem_file_ranks_count(by, status, n, &p.before, &p.all);
    if (!status)
    {
        write_header(&head, by->comment, p.all, columns, count, ends);
        status = dem_parallel_file_create(&p.store, by, path, 0);
    }
    if (!status)
    {
        p.store.status = head.status;
        /* a double beyond the range of Float32 is written as infinite, also when traps are on */
        feholdexcept(&traps);
        write_body(&p, &head, columns, count, ends);
        fesetenv(&traps);
        status = dem_parallel_file_close(&p.store);
    }
    dem_memory_free(head.at);
    dem_memory_free(p.block);
    return status;
}

int dem_vtk_write(const struct dem_file_ranks *by, const char *path, int64_t n,
                  const struct dem_vtk_column *columns, int count)
{
    return write_cells(by, path, n, columns, count, 1);
}

int dem_vtk_write_lines(const struct dem_file_ranks *by, const char *path, int64_t n,
                        const struct dem_vtk_column *columns, int count)
{
    return write_cells(by, path, n, columns, count, 2);
}
