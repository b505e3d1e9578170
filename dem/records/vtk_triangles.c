/*
 * vtk_triangles.c -- serial writer of a .vtp file of triangles: an XML header with the offset of
 * each array, then the arrays.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/vtk.h"

#include "core/error.h"
#include "core/file.h"

/* One <DataArray>; advances the offset by the array's length field and values. */
static void declare_array(FILE *f, const char *name, const char *type, int components,
                          uint64_t bytes, uint64_t *offset)
{
    fprintf(
        f,
        "        <DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"%llu\"/>\n",
        type, name, components, (unsigned long long)*offset);
    *offset += sizeof(uint64_t) + bytes;
}

static void write_header(FILE *f, int64_t n, int wear)
{
    const uint64_t bytes = (uint64_t)n*sizeof(int64_t);
    const uint16_t word = 1;
    uint64_t offset = 0;

    fprintf(
        f,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n",
        *(const unsigned char *)&word == 1 ? "LittleEndian" : "BigEndian");
    fprintf(
        f,
        "  <PolyData>\n    <Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\""
        " NumberOfPolys=\"%lld\">\n      <Points>\n",
        3*(long long)n, (long long)n);
    declare_array(f, "points", "Float64", 3, 9*bytes, &offset);
    fputs("      </Points>\n      <CellData>\n", f);
    declare_array(f, "wall", "Int64", 1, bytes, &offset);
    if (wear)
    {
        declare_array(f, "wear", "Float64", 1, bytes, &offset);
    }
    fputs("      </CellData>\n      <Polys>\n", f);
    declare_array(f, "connectivity", "Int64", 1, 3*bytes, &offset);
    declare_array(f, "offsets", "Int64", 1, bytes, &offset);
    fputs("      </Polys>\n    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_", f);
}

static void write_array(FILE *f, const void *data, uint64_t bytes)
{
    fwrite(&bytes, sizeof bytes, 1, f);
    fwrite(data, 1, bytes, f);
}

/* Write the array first, first + step, ... */
static void write_counts(FILE *f, int64_t n, int64_t first, int64_t step)
{
    const uint64_t bytes = (uint64_t)n*sizeof n;

    fwrite(&bytes, sizeof bytes, 1, f);
    for (int64_t k = 0; k < n; k++)
    {
        const int64_t value = first + k*step;

        fwrite(&value, sizeof value, 1, f);
    }
}

int dem_vtk_write_triangles(const char *path, int64_t n, const double *corners, const int64_t *wall,
                            const double *wear)
{
    struct dem_file f;

    DEM_TRY(dem_file_begin(&f, path));
    write_header(f.stream, n, wear != NULL);
    write_array(f.stream, corners, 9*(uint64_t)n*sizeof *corners);
    write_array(f.stream, wall, (uint64_t)n*sizeof *wall);
    if (wear)
    {
        write_array(f.stream, wear, (uint64_t)n*sizeof *wear);
    }
    write_counts(f.stream, 3*n, 0, 1);
    write_counts(f.stream, n, 3, 3);
    fputs("\n  </AppendedData>\n</VTKFile>\n", f.stream);
    return dem_file_finish(&f, DEM_OK);
}
