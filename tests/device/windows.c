/*
 * windows.c -- coupling windows of a scene in a gas, as a fluid solver makes them: one line for every second of them, of
 * particles, contact forces, contacts and forces on walls. Contacts may stay on a device between windows; the lines are
 * the same without one.
 *
 *     windows SCENE [DEVICE]       under mpirun, too
 *
 * Windows differ in length, some have a single step; some are stopped within and go on. Between them snapshots are
 * written, and the run goes back to a backup, once.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "dem_fluid.h"
#include "dem_query.h"
#include <inttypes.h>
#include <mpi.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    WINDOWS = 48,
    BACKUP = 20,     /* window before which a backup is made, and behind which the run goes back to it */
    RESTORE = 31
};

static volatile sig_atomic_t stop;
static int armed;

static void check(int status)
{
    if (status)
    {
        fprintf(stderr, "%s\n", dem_error_text());
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
}

/* The first report of a window that is to be stopped. */
static void report(void *self, double time, int64_t steps)
{
    (void)self, (void)time, (void)steps;
    stop = armed;
}

static uint64_t mix(uint64_t h, const void *from, size_t bytes)
{
    const unsigned char *const byte = from;

    for (size_t k = 0; k < bytes; k++)
    {
        h = (h ^ byte[k])*1099511628211u;
    }
    return h;
}

/* A sum over particles, so that their order does not count. */
static void print_line(struct dem *d, int window)
{
    struct dem_totals totals;
    struct dem_view v;
    uint64_t sum = 0, all = 0;
    int rank;

    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        uint64_t h = mix(14695981039346656037u, (const char *)v.id + i*v.stride, sizeof(int64_t));

        h = mix(h, dem_at(v.velocity, v.stride, i), 3*sizeof(double));
        h = mix(h, dem_at(v.spin, v.stride, i), 3*sizeof(double));
        h = mix(h, v.force + 3*i, 3*sizeof(double));
        sum += mix(h, v.torque + 3*i, 3*sizeof(double));
    }
    MPI_Allreduce(&sum, &all, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    check(dem_totals(d, &totals));
    if (rank == 0)
    {
        printf("%d %.17g %016" PRIx64 " %" PRId64, window, totals.time, all, totals.contacts);
    }
    for (int w = 0; w < dem_wall_count(d); w++)
    {
        double force[3], torque[3];

        check(dem_wall_load(d, w, force, torque));
        if (rank == 0)
        {
            printf(" %.17g", force[0] + force[2]);
        }
    }
    if (rank == 0)
    {
        printf("\n");
    }
}

/* Gas that blows along x, a little faster or slower in each window. */
static void blow(struct dem *d, int window)
{
    struct dem_fluid f;

    check(dem_fluid(d, &f));
    for (size_t i = 0; i < f.n; i++)
    {
        f.velocity[3*i] = 3.0 + 0.1*(window%5);
        f.velocity[3*i + 1] = f.velocity[3*i + 2] = 0.0;
        f.void_fraction[i] = 0.8;
        f.density[i] = 1.2;
        f.viscosity[i] = 2e-5;
    }
}

static double time_of(struct dem *d)
{
    struct dem_totals totals;

    check(dem_totals(d, &totals));
    return totals.time;
}

static void advance(struct dem *d, int window)
{
    const double length = window%7 == 3 ? 4e-6 : 2e-4*(1.0 + 0.37*(window%3)), end = time_of(d) + length;

    blow(d, window);
    armed = window%8 == 6;
    check(dem_advance(d, length));
    while (dem_stopped(d))
    {
        armed = 0;
        stop = 0;
        check(dem_advance(d, end - time_of(d)));
    }
}

static char *read_scene(const char *path)
{
    FILE *const file = fopen(path, "r");
    char *const text = calloc(1, 1 << 16);

    if (!file || !text || fread(text, 1, (1 << 16) - 1, file) == 0)
    {
        fprintf(stderr, "cannot read %s\n", path);
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    fclose(file);
    return text;
}

static struct dem *start(const char *path, const char *device)
{
    char *const scene = read_scene(path), entry[200];
    struct dem_case *c;
    struct dem *d;

    snprintf(entry, sizeof entry, "\ndevice \"%s\";\n", device);
    strcat(scene, *device ? entry : "");
    check(dem_case_create(&c, MPI_COMM_WORLD));
    check(dem_case_scene_text(c, scene, path));
    check(dem_start(&c, &d));
    check(dem_device_keep_contacts(d));
    dem_set_stop_flag(d, &stop);
    dem_set_progress(d, 0.0, report, NULL);
    free(scene);
    return d;
}

int main(int argc, char **argv)
{
    int64_t made, parts, repeated;
    double back;
    int rank;

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    struct dem *const d = start(argc > 1 ? argv[1] : "windows.in", argc > 2 ? argv[2] : "");

    for (int window = 1; window <= WINDOWS; window++)
    {
        if (window%10 == 9)
        {
            check(dem_save(d, "windows.snapshot"));
        }
        if (window == BACKUP)
        {
            check(dem_backup_every(d, 0));
        }
        advance(d, window);
        if (window == RESTORE)
        {
            check(dem_restore(d, &back));
        }
        if (window%2 == 0)
        {
            print_line(d, window);
        }
    }
    dem_device_steps(d, &made, &parts, &repeated);
    if (rank == 0)
    {
        fprintf(stderr, "device: %" PRId64 " steps in %" PRId64 " parts\n", made, parts);
    }
    dem_free(d);
    MPI_Finalize();
    return 0;
}
