/*
 * cost_record.c -- `dem cost -record FILE GX GY GZ`: totals over all particles from the record of a
 * coupled run (docs/output.md, record), one line for each time.
 *
 *   time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]
 *
 *   height     of the centre of volume, against gravity                       [m]
 *   level      95 % of the volume lies below it                               [m]
 *   kinetic    kinetic energy of translation over mass, for equal densities   [m2/s2]
 *   diameter   of a sphere of the mean volume                                 [m]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "app/cost.h"
#include "core/memory.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* record of a particle in the file; do not reorder */
struct row
{
    int32_t id;
    float position[3], velocity[3], diameter;
};

struct particle
{
    double height, volume;
};

static int by_height(const void *a, const void *b)
{
    const double x = ((const struct particle *)a)->height, y = ((const struct particle *)b)->height;

    return (x > y) - (x < y);
}

static double bed_level(struct particle *p, size_t n, double volume)
{
    double below = 0.0;
    size_t k = 0;

    qsort(p, n, sizeof *p, by_height);
    while (k + 1 < n && (below += p[k].volume) < 0.95*volume)
    {
        k++;
    }
    return n > 0 ? p[k].height : 0.0;
}

static void report(double time, const struct row *r, struct particle *p, size_t n,
                   const double up[3])
{
    double volume = 0.0, height = 0.0, kinetic = 0.0;

    for (size_t k = 0; k < n; k++)
    {
        p[k].volume = pow(r[k].diameter, 3.0);
        p[k].height = up[0]*r[k].position[0] + up[1]*r[k].position[1] + up[2]*r[k].position[2];
        volume += p[k].volume;
        height += p[k].volume*p[k].height;
        for (int a = 0; a < 3; a++)
        {
            kinetic += 0.5*p[k].volume*r[k].velocity[a]*r[k].velocity[a];
        }
    }
    const double total = n > 0 ? volume : 1.0;

    printf("%.9g,%zu,%.9g,%.9g,%.9g,%.9g\n", time, n, height/total, bed_level(p, n, volume),
           kinetic/total, n > 0 ? cbrt(volume/(double)n) : 0.0);
}

/* Read and report the particles of one time. *end: 1 if the file has no further time. */
static int read_time(const char *path, FILE *f, const double up[3], int *end)
{
    struct particle *particles = NULL;
    struct row *rows = NULL;
    double time;
    int64_t n;

    *end = fread(&time, sizeof time, 1, f) != 1;
    if (*end)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(fread(&n, sizeof n, 1, f) == 1 && n >= 0 && n < (int64_t)1 << 40, DEM_ERROR_FILE,
                "%s is truncated, or not a record of particles", path);
    int status = DEM_NEW(rows, (size_t)n + 1);

    status = status ? status : DEM_NEW(particles, (size_t)n + 1);
    if (!status && fread(rows, sizeof *rows, (size_t)n, f) != (size_t)n)
    {
        status = dem_error(DEM_ERROR_FILE, "%s is truncated at %g s, or not a record of particles",
                           path, time);
    }
    if (!status)
    {
        report(time, rows, particles, (size_t)n, up);
    }
    dem_memory_free(rows);
    dem_memory_free(particles);
    return status;
}

int dem_cost_report_record(int argc, char **argv)
{
    double up[3], size = 0.0;
    int status = DEM_OK, end = 0;

    DEM_REQUIRE(argc == 5, DEM_ERROR_INPUT,
                "dem cost -record takes a file and gravity, three numbers");
    for (int k = 0; k < 3; k++)
    {
        char *after;

        up[k] = -strtod(argv[2 + k], &after);
        DEM_REQUIRE(after != argv[2 + k] && !*after && isfinite(up[k]), DEM_ERROR_INPUT,
                    "gravity %s; give three numbers", argv[2 + k]);
        size += up[k]*up[k];
    }
    for (int k = 0; k < 3 && size > 0.0; k++)
    {
        up[k] /= sqrt(size);
    }
    FILE *const f = fopen(argv[1], "rb");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "cannot read %s: %s", argv[1], strerror(errno));
    printf("time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]\n");
    while (!status && !end)
    {
        status = read_time(argv[1], f, up, &end);
    }
    fclose(f);
    return status;
}
