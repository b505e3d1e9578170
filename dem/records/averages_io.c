/*
 * averages_io.c -- read the scene entry `averages`; write the averages as CSV tables and VTK
 * images.
 *
 * Files: CSV with a header line of names, each with its unit in brackets; VTK XML ImageData in text
 * form ("VTK File Formats", Kitware).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/averages_io.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/file.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Limit of cells in a grid: the sums of 1e6 cells take 4 GB. */
static const double max_cells = 1e6;

/* Time steps are longer than 1e-15 s, and sample numbers are exact up to 1e15. */
static const double min_interval = 1e-15, max_intervals = 1e15;

/* ---- reading --------------------------------------------------------------------------------- */

static int read_cells(const struct dem_dict *d, int cells[3])
{
    static const double one[3] = {1.0, 1.0, 1.0};
    double n[3];

    DEM_TRY(dem_dict_vector_or(d, "cells", "1", one, n));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(n[k] >= 1.0 && n[k] <= max_cells && n[k] == floor(n[k]), DEM_ERROR_INPUT,
                    "%s: cells (%g %g %g); give three whole numbers from 1", dem_dict_where(d),
                    n[0], n[1], n[2]);
        cells[k] = (int)n[k];
    }
    DEM_REQUIRE(n[0]*n[1]*n[2] <= max_cells, DEM_ERROR_INPUT,
                "%s: %g cells, the limit is %g; use larger cells", dem_dict_where(d),
                n[0]*n[1]*n[2], max_cells);
    return DEM_OK;
}

/* 1 when a run or a coupled run writes a table of this name into the folder of the averages. */
static int is_taken(const char *name)
{
    static const char *const tables[] = {"effects", "energy", "walls", "flows", "lost", "bonds",
                                         "budget"};
    int taken = strncmp(name, "particles_", 10) == 0;

    for (size_t k = 0; k < sizeof tables/sizeof *tables; k++)
    {
        taken |= strcmp(name, tables[k]) == 0;
    }
    return taken;
}

static int read_plan(struct dem_averages_entry *p, const struct dem_dict *d)
{
    p->name = dem_dict_name(d);
    DEM_REQUIRE(!strchr(p->name, '/'), DEM_ERROR_INPUT,
                "%s: the name %s is used as a file name and cannot hold a /", dem_dict_where(d),
                p->name);
    DEM_REQUIRE(!is_taken(p->name), DEM_ERROR_INPUT,
                "%s: averages named %s would overwrite %s.csv, which the run writes; give these "
                "averages another name", dem_dict_where(d), p->name, p->name);
    DEM_TRY(dem_dict_vector(d, "min", "m", p->min));
    DEM_TRY(dem_dict_vector(d, "max", "m", p->max));
    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(isfinite(p->max[k] - p->min[k]), DEM_ERROR_INPUT,
                    "%s: %s: min %g m and max %g m are too far apart along %c", dem_dict_where(d),
                    dem_dict_path(d), p->min[k], p->max[k], 'x' + k);
        DEM_REQUIRE(p->min[k] < p->max[k], DEM_ERROR_INPUT,
                    "%s: min %g m is not below max %g m along axis %c", dem_dict_where(d),
                    p->min[k], p->max[k], 'x' + k);
    }
    DEM_TRY(read_cells(d, p->cells));
    DEM_TRY(dem_dict_number_or(d, "start", "s", 0.0, &p->start));
    DEM_TRY(dem_dict_number_or(d, "end", "s", INFINITY, &p->end));
    DEM_TRY(dem_dict_number(d, "interval", "s", &p->interval));
    DEM_REQUIRE(p->interval >= min_interval, DEM_ERROR_INPUT,
                "%s: %s: interval %g s; give a time above 0, at least %g s", dem_dict_where(d),
                dem_dict_path(d), p->interval, min_interval);
    DEM_REQUIRE(fabs(p->start) < max_intervals*p->interval, DEM_ERROR_INPUT,
                "%s: %s: start %g s is more than %g intervals away; "
                "give another start, or a longer interval",
                dem_dict_where(d), dem_dict_path(d), p->start, max_intervals);
    DEM_REQUIRE(p->start < p->end, DEM_ERROR_INPUT, "%s: start %g s is not before end %g s",
                dem_dict_where(d), p->start, p->end);
    return DEM_OK;
}

int dem_averages_io_read(const struct dem_dict *scene, struct dem_averages_entry **plan, int *n)
{
    const struct dem_dict *all;
    size_t count;

    *plan = NULL;
    *n = 0;
    DEM_TRY(dem_dict_sub_if(scene, "averages", &all));
    count = all ? dem_dict_count(all) : 0;
    if (!count)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(*plan, count));
    for (size_t k = 0; k < count; k++)
    {
        const struct dem_entry *const e = dem_dict_entry(all, k);

        DEM_REQUIRE(dem_entry_is_dict(e), DEM_ERROR_INPUT,
                    "%s: %s is not a dictionary; write %s { min; max; cells; interval; }",
                    dem_entry_where(e), dem_entry_name(e), dem_entry_name(e));
        DEM_TRY(read_plan(&(*plan)[k], dem_entry_dict(e)));
        (*n)++;
    }
    return DEM_OK;
}

/* ---- writing --------------------------------------------------------------------------------- */

static const char *component(int components, int k)
{
    static const char *const names[] = {"X", "Y", "Z", "XX", "YY", "ZZ", "XY", "YZ", "ZX"};

    return components == 1 ? "" : names[components == 3 ? k : 3 + k];
}

static void write_head(FILE *f, const struct dem_averages_quantity *field, int fields)
{
    fputs("x[m],y[m],z[m]", f);
    for (int q = 0; q < fields; q++)
    {
        for (int k = 0; k < field[q].components; k++)
        {
            const char *const part = component(field[q].components, k);

            fprintf(f, ",%s%s[%s],%s%s_ci95", field[q].name, part, field[q].unit, field[q].name,
                    part);
        }
    }
    fputc('\n', f);
}

static void write_row(FILE *f, const struct dem_averages_entry *p,
                      const struct dem_averages_quantity *field, int fields, size_t stride,
                      size_t cell)
{
    const size_t nx = (size_t)p->cells[0], ny = (size_t)p->cells[1];
    const size_t at[3] = {cell%nx, cell/nx%ny, cell/nx/ny};

    for (int k = 0; k < 3; k++)
    {
        fprintf(f, "%s%.9g", k ? "," : "",
                p->min[k] + ((double)at[k] + 0.5)*(p->max[k] - p->min[k])/(double)p->cells[k]);
    }
    for (int q = 0; q < fields; q++)
    {
        for (int k = 0; k < field[q].components; k++)
        {
            fprintf(f, ",%.9g,%.4g", field[q].value[cell*stride + (size_t)k],
                    field[q].ci[cell*stride + (size_t)k]);
        }
    }
    fputc('\n', f);
}

static void write_array(FILE *f, const char *name, const char *suffix, int components,
                        const double *value, size_t stride, size_t cells)
{
    fprintf(
        f,
        "        <DataArray type=\"Float64\" Name=\"%s%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n",
        name, suffix, components);
    for (size_t cell = 0; cell < cells; cell++)
    {
        for (int k = 0; k < components; k++)
        {
            fprintf(f, "%.9g%c", value[cell*stride + (size_t)k], k + 1 < components ? ' ' : '\n');
        }
    }
    fputs("        </DataArray>\n", f);
}

static void write_image(FILE *f, const struct dem_averages_entry *p,
                        const struct dem_averages_quantity *field, int fields, size_t stride,
                        size_t cells)
{
    const int *const n = p->cells;
    double d[3];

    for (int k = 0; k < 3; k++)
    {
        d[k] = (p->max[k] - p->min[k])/(double)n[k];
    }
    fprintf(f, "<?xml version=\"1.0\"?>\n");
    if (p->comment)
    {
        fprintf(f, "<!-- %s -->\n", p->comment);
    }
    fprintf(
        f,
        "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "  <ImageData WholeExtent=\"0 %d 0 %d 0 %d\" Origin=\"%.17g %.17g %.17g\" Spacing=\"%.17g %.17g %.17g\">\n"
        "    <Piece Extent=\"0 %d 0 %d 0 %d\">\n      <CellData>\n",
        n[0], n[1], n[2], p->min[0], p->min[1], p->min[2], d[0], d[1], d[2], n[0], n[1], n[2]);
    for (int q = 0; q < fields; q++)
    {
        write_array(f, field[q].name, "", field[q].components, field[q].value, stride, cells);
        write_array(f, field[q].name, "_ci95", field[q].components, field[q].ci, stride, cells);
    }
    fputs("      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n", f);
}

int dem_averages_io_write(const char *folder, const struct dem_averages_entry *p,
                          const struct dem_averages_quantity *field, int fields, size_t stride)
{
    const size_t cells = (size_t)p->cells[0]*(size_t)p->cells[1]*(size_t)p->cells[2];
    struct dem_file f;
    char path[1024];

    const int length = snprintf(path, sizeof path, "%s/%s.csv", folder, p->name);
    DEM_REQUIRE(length > 0 && (size_t)length < sizeof path, DEM_ERROR_INPUT,
                "path %s/%s.csv of the averages %s is "
                "longer than %zu characters; use a shorter folder or name",
                folder, p->name, p->name, sizeof path - 1);
    DEM_TRY(dem_file_begin(&f, path));
    write_head(f.stream, field, fields);
    for (size_t cell = 0; cell < cells; cell++)
    {
        write_row(f.stream, p, field, fields, stride, cell);
    }
    DEM_TRY(dem_file_finish(&f, DEM_OK));
    memcpy(path + length - 3, "vti", 3);
    DEM_TRY(dem_file_begin(&f, path));
    write_image(f.stream, p, field, fields, stride, cells);
    return dem_file_finish(&f, DEM_OK);
}
