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

#include "core/memory.h"
#include "core/text.h"

#include <fenv.h>
#include <stdbool.h>
#include <string.h>

enum
{
    MAX_COMPONENTS = 9,    /* of one column: a tensor              */
    BLOCK = 1 << 24        /* bytes packed before they are written */
};

static const struct
{
    const char *name;
    size_t size;    /* in the file [byte] */
} types[] = {
    [DEM_VTK_DOUBLE] = {"Float64", 8},
    [DEM_VTK_FLOAT32] = {"Float32", 4},
    [DEM_VTK_INT64] = {"Int64", 8},
};

/* ---- header ---------------------------------------------------------------------------------- */

/* One <DataArray>; advances the offset by the array's length field and values. */
static void declare_array(struct dem_text *t, const char *name, const char *type, int components,
                          uint64_t bytes, uint64_t *offset)
{
    dem_text_add(
        t,
        "        <DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"%llu\"/>\n",
        type, name, components, (unsigned long long)*offset);
    *offset += sizeof(uint64_t) + bytes;
}

static uint64_t bytes_of(const struct dem_vtk_column *c, int64_t n)
{
    return (uint64_t)n*(uint64_t)c->components*types[c->type].size;
}

/* `corners` of a cell: 1 for points; 2 for lines, 3 for triangles, whose columns belong to the
   cells. */
static void write_header(struct dem_text *t, const char *comment, int64_t n,
                         const struct dem_vtk_column *columns, int count, int corners)
{
    static const char *const kinds[] = {"Verts", "Lines", "Polys"};
    const char *const data = corners == 1 ? "PointData" : "CellData", *const cells = kinds[corners - 1];
    const uint16_t one = 1;
    const bool little = *(const unsigned char *)&one == 1;
    const long long points = (long long)n*corners;
    uint64_t offset = 0;

    dem_text_add(t, "<?xml version=\"1.0\"?>\n");
    if (comment)
    {
        dem_text_add(t, "<!-- %s -->\n", comment);
    }
    dem_text_add(t,
                 "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n"
                 "  <PolyData>\n    <Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"%lld\" "
                 "NumberOfLines=\"%lld\" NumberOfStrips=\"0\" NumberOfPolys=\"%lld\">\n",
                 little ? "LittleEndian" : "BigEndian", points, corners == 1 ? (long long)n : 0,
                 corners == 2 ? (long long)n : 0, corners == 3 ? (long long)n : 0);
    for (int i = 0; i < count; i++)
    {
        if (i < 2)
        {
            dem_text_add(t, "      <%s>\n", i == 0 ? "Points" : data);
        }
        declare_array(t, columns[i].name, types[columns[i].type].name,
                      i == 0 ? 3 : columns[i].components, bytes_of(&columns[i], n), &offset);
        if (i == 0 || i == count - 1)
        {
            dem_text_add(t, "      </%s>\n", i == 0 ? "Points" : data);
        }
    }
    dem_text_add(t, "      <%s>\n", cells);
    declare_array(t, "connectivity", "Int64", 1, (uint64_t)points*sizeof(int64_t), &offset);
    declare_array(t, "offsets", "Int64", 1, (uint64_t)n*sizeof(int64_t), &offset);
    dem_text_add(t, "      </%s>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_",
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

static void write_body(struct vtp_file *p, const struct dem_text *head,
                       const struct dem_vtk_column *columns, int count, int corners)
{
    const struct counts points = {p->before*corners, 1}, cells = {(p->before + 1)*corners, corners};

    p->at = head->n;
    if (p->store.by.rank == 0)
    {
        dem_parallel_file_write(&p->store, 0, head->text, head->n);
    }
    for (int i = 0; i < count; i++)
    {
        write_array(p, pack_column, &columns[i], 1, bytes_of(&columns[i], 1));
    }
    write_array(p, pack_counts, &points, corners, sizeof(int64_t));
    write_array(p, pack_counts, &cells, 1, sizeof(int64_t));
    write_tail(p);
}

static int write_cells(const struct dem_file_ranks *by, const char *path, int64_t n,
                       const struct dem_vtk_column *columns, int count, int corners)
{
    const struct dem_file_ranks alone = {.comm = MPI_COMM_NULL};
    struct dem_text head = {.text = NULL};
    struct vtp_file p = {.n = n};
    fenv_t traps;

    by = by ? by : &alone;
    int status = DEM_NEW(p.block, BLOCK);

    status = dem_file_ranks_count(by, status, n, &p.before, &p.all);
    if (!status)
    {
        write_header(&head, by->comment, p.all, columns, count, corners);
        status = dem_parallel_file_create(&p.store, by, path, 0);
    }
    if (!status)
    {
        p.store.status = head.status;
        /* a double beyond the range of Float32 is written as infinite, also when traps are on */
        feholdexcept(&traps);
        write_body(&p, &head, columns, count, corners);
        fesetenv(&traps);
        status = dem_parallel_file_close(&p.store);
    }
    dem_text_free(&head);
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

int dem_vtk_write_triangles(const char *path, int64_t n, const double *corners, const int64_t *wall,
                            const double *wear)
{
    const struct dem_vtk_column columns[] = {
        {"points", corners, 9*sizeof *corners, DEM_VTK_DOUBLE, 9},
        {"wall", wall, sizeof *wall, DEM_VTK_INT64, 1},
        {"wear", wear, sizeof *wear, DEM_VTK_DOUBLE, 1},
    };

    return write_cells(NULL, path, n, columns, wear ? 3 : 2, 3);
}
