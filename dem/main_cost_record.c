/*
 * main_cost_record.c -- `dem cost -record FILE GX GY GZ`: what the record of a coupled run (coupling/README.md, section 4) says of its
 * particles as a whole, a line for each time.
 *
 *   time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]
 *
 * height: of the centre of volume against gravity. level: under which 95 % of the volume lies. kinetic: of translation, by mass. All
 * particles of one density. diameter: mean by volume.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "main_cost.h"
#include "base/memory.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct row                                                /* as it is in the file */
{
    int32_t id;
    float place[3], velocity[3], diameter;
};

struct grain
{
    double height, volume;
};

static int higher(const void *a, const void *b)
{
    const double x = ((const struct grain *)a)->height, y = ((const struct grain *)b)->height;

    return (x > y) - (x < y);
}

static double level(struct grain *g, size_t n, double volume)
{
    double below = 0.0;
    size_t k = 0;

    qsort(g, n, sizeof *g, higher);
    while (k + 1 < n && (below += g[k].volume) < 0.95*volume)
    {
        k++;
    }
    return n > 0 ? g[k].height : 0.0;
}

static void tell(double time, const struct row *r, struct grain *g, size_t n, const double up[3])
{
    double volume = 0.0, height = 0.0, kinetic = 0.0;

    for (size_t k = 0; k < n; k++)
    {
        g[k].volume = pow(r[k].diameter, 3.0);
        g[k].height = up[0]*r[k].place[0] + up[1]*r[k].place[1] + up[2]*r[k].place[2];
        volume += g[k].volume;
        height += g[k].volume*g[k].height;
        for (int a = 0; a < 3; a++)
        {
            kinetic += 0.5*g[k].volume*r[k].velocity[a]*r[k].velocity[a];
        }
    }
    const double all = n > 0 ? volume : 1.0;

    printf("%.9g,%zu,%.9g,%.9g,%.9g,%.9g\n", time, n, height/all, level(g, n, volume), kinetic/all, n > 0 ? cbrt(volume/(double)n) : 0.0);
}

/* One time: its particles, read into room that grows. *end: 1 where the file ends before it. */
static int read_time(const char *path, FILE *f, const double up[3], int *end)
{
    struct grain *grains = NULL;
    struct row *rows = NULL;
    double time;
    int64_t n;

    *end = fread(&time, sizeof time, 1, f) != 1;
    if (*end)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(fread(&n, sizeof n, 1, f) == 1 && n >= 0 && n < (int64_t)1 << 40, DEM_ERROR_FILE, "%s is cut off, or no record of particles", path);
    int status = DEM_NEW(rows, (size_t)n + 1);

    status = status ? status : DEM_NEW(grains, (size_t)n + 1);
    if (!status && fread(rows, sizeof *rows, (size_t)n, f) != (size_t)n)
    {
        status = dem_error(DEM_ERROR_FILE, "%s is cut off at %g s, or no record of particles", path, time);
    }
    if (!status)
    {
        tell(time, rows, grains, (size_t)n, up);
    }
    dem_memory_free(rows);
    dem_memory_free(grains);
    return status;
}

int dem_cost_tell_record(int argc, char **argv)
{
    double up[3], size = 0.0;
    int status = DEM_OK, end = 0;

    DEM_REQUIRE(argc == 5, DEM_ERROR_INPUT, "dem cost -record takes a file and gravity, three numbers");
    for (int k = 0; k < 3; k++)
    {
        char *after;

        up[k] = -strtod(argv[2 + k], &after);
        DEM_REQUIRE(after != argv[2 + k] && !*after && isfinite(up[k]), DEM_ERROR_INPUT, "gravity %s; give three numbers", argv[2 + k]);
        size += up[k]*up[k];
    }
    for (int k = 0; k < 3 && size > 0.0; k++)
    {
        up[k] /= sqrt(size);
    }
    FILE *const f = fopen(argv[1], "rb");

    DEM_REQUIRE(f, DEM_ERROR_FILE, "can't read %s: %s", argv[1], strerror(errno));
    printf("time[s],particles,height[m],level[m],kinetic[m2/s2],diameter[m]\n");
    while (!status && !end)
    {
        status = read_time(argv[1], f, up, &end);
    }
    fclose(f);
    return status;
}
