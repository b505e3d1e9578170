/*
 * bed.c -- a bed of spheres as text, and the time that Suna takes for it.
 *
 *    bed state SCENE SNAPSHOT COPIES WIDTH SPEED
 *        prints the particles of a snapshot, repeated COPIES times along x every WIDTH [m], the
 *        snapshot's period along x and y, with a random velocity up to SPEED [m/s] along each axis
 *        added
 *    bed run SCENE STATE STEP STEPS END [PATH VALUE ...]
 *        runs STEPS steps of STEP [s] from such a text; prints processor time [s], bytes, kinetic
 *        energy
 *        [J], contacts, rebuilds, prunes, bonds; writes the last state as such a text to END,
 *        unless END is -
 *    bed spend PROGRAM ...
 *        runs another program; the last line has its processor time [s] and bytes
 *
 * A line of the text: id, diameter, position, velocity, spin. Contacts start without history, as in
 * the other codes. Time is the time of dem_advance after a first step, which makes the first lists,
 * multiplied by STEPS/(STEPS - 1). Bytes are the peak of the process beyond its memory before there
 * are particles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#define _DEFAULT_SOURCE

#include "dem_query.h"
#include "core/random.h"
#include <math.h>
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static int fail(const char *what)
{
    fprintf(stderr, "bed: %s\n", what);
    return 1;
}

/* One line of /proc/self/status [bytes]; 0 where there is none. */
static double status_bytes(const char *name)
{
    FILE *const f = fopen("/proc/self/status", "r");
    char line[256];
    double kilobytes = 0.0;

    while (f && fgets(line, sizeof line, f))
    {
        if (strncmp(line, name, strlen(name)) == 0)
        {
            kilobytes = strtod(line + strlen(name) + 1, NULL);
        }
    }
    if (f)
    {
        fclose(f);
    }
    return 1024.0*kilobytes;
}

/* Reset the peak of memory. */
static void reset_peak(void)
{
    FILE *const f = fopen("/proc/self/clear_refs", "w");

    if (f)
    {
        fputs("5", f);
        fclose(f);
    }
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9*(double)t.tv_nsec;
}

/* ---- state ----------------------------------------------------------------------------------- */

/* Suna refuses initial overlaps of 5 % of a diameter, but a small grain between large ones may have
   more: its diameter is reduced to an overlap of 4 %. Diameters of all [m]; NULL when there is no
   memory. */
static double *diameters(const struct dem_view *v, double width)
{
    const double most = 0.04;
    double *const d = malloc(v->n*sizeof *d);

    for (size_t i = 0; d && i < v->n; i++)
    {
        const double *const x = dem_at(v->position, v->stride, i),
                            full = 2.0*dem_at(v->radius, v->stride, i)[0];

        d[i] = full;
        for (size_t j = 0; j < v->n; j++)
        {
            const double *const y = dem_at(v->position, v->stride, j),
                                other = 2.0*dem_at(v->radius, v->stride, j)[0];
            const double a = remainder(x[0] - y[0], width), b = remainder(x[1] - y[1], width),
                         c = x[2] - y[2];
            const double reach = 0.5*(full + other), near = a*a + b*b + c*c;

            if (j != i && full <= other && near < reach*reach)
            {
                const double more = reach - sqrt(near) - most*full;

                d[i] = fmin(d[i], full - fmax(more, 0.0)/(0.5 - most));
            }
        }
    }
    return d;
}

static struct dem_new_particle seed_of(const struct dem_view *v, size_t i)
{
    const int64_t *const id = (const void *)((const char *)v->id + v->stride*i);
    struct dem_new_particle s = {.id = *id, .diameter = 2.0*dem_at(v->radius, v->stride, i)[0]};

    memcpy(s.position, dem_at(v->position, v->stride, i), sizeof s.position);
    memcpy(s.velocity, dem_at(v->velocity, v->stride, i), sizeof s.velocity);
    memcpy(s.spin, dem_at(v->spin, v->stride, i), sizeof s.spin);
    return s;
}

static void print_seed(FILE *f, const struct dem_new_particle *s)
{
    fprintf(f, "%lld %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n",
            (long long)s->id, s->diameter, s->position[0], s->position[1], s->position[2],
            s->velocity[0], s->velocity[1], s->velocity[2], s->spin[0], s->spin[1], s->spin[2]);
}

static int state(char **argument)
{
    const long copies = strtol(argument[2], NULL, 10);
    const double width = strtod(argument[3], NULL), speed = strtod(argument[4], NULL);
    char side[64];
    struct dem_view v;
    struct dem_case *made;
    struct dem *d;

    snprintf(side, sizeof side, "(0 %s)", argument[3]);
    if (dem_case_create(&made, MPI_COMM_NULL) || dem_case_scene_file(made, argument[0]) ||
        dem_case_set(made, "domain/x", side) || dem_case_set(made, "domain/y", side) ||
        dem_case_load(made, argument[1]) || dem_start(&made, &d))
    {
        return fail(dem_error_text());
    }
    dem_view(d, &v);
    double *const diameter = diameters(&v, width);

    for (size_t k = 0; diameter && k < (size_t)copies*v.n; k++)
    {
        struct dem_new_particle s = seed_of(&v, k % v.n);

        s.id = (int64_t)k;
        s.diameter = diameter[k % v.n];
        s.position[0] += (double)(k/v.n)*width;
        for (int c = 0; c < 3; c++)
        {
            s.velocity[c] += speed*(2.0*dem_random_unit(1, k, (uint64_t)c, 0) - 1.0);
        }
        print_seed(stdout, &s);
    }
    dem_free(d);
    if (!diameter)
    {
        return fail("no memory");
    }
    free(diameter);
    return 0;
}

/* ---- run ------------------------------------------------------------------------------------- */

static int start(struct dem_case *c, const char *path, struct dem **d)
{
    FILE *const f = fopen(path, "r");
    struct dem_new_particle *seed = NULL, s = {.material = "glass"};
    size_t n = 0, room = 0;
    long long id;

    if (!f)
    {
        return fail(path);
    }
    while (fscanf(f, "%lld %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", &id, &s.diameter,
                  &s.position[0], &s.position[1], &s.position[2], &s.velocity[0], &s.velocity[1],
                  &s.velocity[2], &s.spin[0], &s.spin[1], &s.spin[2]) == 11)
    {
        if (n == room)
        {
            room = 2*room + 1024;
            seed = realloc(seed, room*sizeof *seed);
            if (!seed)
            {
                return fail("no memory");
            }
        }
        s.id = id;
        seed[n++] = s;
    }
    fclose(f);
    const int status = dem_case_add_particles(c, (int64_t)n, seed) || dem_start(&c, d);

    free(seed);
    return status ? fail(dem_error_text()) : 0;
}

static int print_end(const struct dem *d, const char *path)
{
    FILE *const f = fopen(path, "w");
    struct dem_view v;

    if (!f)
    {
        return fail(path);
    }
    dem_view(d, &v);
    for (size_t i = 0; i < v.n; i++)
    {
        const struct dem_new_particle s = seed_of(&v, i);

        print_seed(f, &s);
    }
    return fclose(f) ? fail(path) : 0;
}

static int run(int arguments, char **argument)
{
    const double step = strtod(argument[2], NULL), steps = strtod(argument[3], NULL),
                 before = status_bytes("VmRSS:");
    struct dem_totals t;
    struct dem_case *c;
    struct dem *d;

    if (dem_case_create(&c, MPI_COMM_NULL) || dem_case_scene_file(c, argument[0]) ||
        dem_case_set(c, "time/step", argument[2]))
    {
        return fail(dem_error_text());
    }
    for (int k = 5; k + 1 < arguments; k += 2)
    {
        if (dem_case_set(c, argument[k], argument[k + 1]))
        {
            return fail(dem_error_text());
        }
    }
    if (start(c, argument[1], &d))
    {
        return 1;
    }
    reset_peak();
    if (dem_advance(d, step*(1.0 -
                               /* makes lists, as the other codes do before their first step */
                               1e-12)))
    {
        return fail(dem_error_text());
    }
    const double start = seconds();

    /* slightly less than a whole number of steps, so that rounding does not add one */
    if (steps > 1.0 && dem_advance(d, step*(steps - 1.0)*(1.0 - 1e-12)))
    {
        return fail(dem_error_text());
    }
    const double spent = steps > 1.0 ? (seconds() - start)*steps/(steps - 1.0) : NAN;

    if (dem_totals(d, &t))
    {
        return fail(dem_error_text());
    }
    printf("%.6g %.6g %.6g %lld %lld %lld %lld\n", spent, status_bytes("VmHWM:") - before, t.kinetic,
           (long long)t.contacts, (long long)t.rebuilds, (long long)t.prunes, (long long)t.bonds);
    const int status = strcmp(argument[4], "-") == 0 ? 0 : print_end(d, argument[4]);

    dem_free(d);
    return status;
}

/* ---- spend ----------------------------------------------------------------------------------- */

/* The peak memory of a process includes its parent's before the start; so its parent is this
   program, which has little. */
static int spend(char **argument)
{
    struct rusage use;
    int status = 1;
    const pid_t child = fork();

    if (child == 0)
    {
        execvp(argument[0], argument);
        _exit(127);
    }
    if (child < 0 || waitpid(child, &status, 0) != child || status != 0 ||
        getrusage(RUSAGE_CHILDREN, &use))
    {
        return fail(argument[0]);
    }
    printf("spent %.6f %.0f\n",
           (double)(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
               1e-6*(double)(use.ru_utime.tv_usec + use.ru_stime.tv_usec),
           1024.0*(double)use.ru_maxrss);
    return 0;
}

int main(int arguments, char **argument)
{
    mallopt(M_MMAP_THRESHOLD, 1 << 20);                   /* as the program dem does */
    if (arguments == 7 && strcmp(argument[1], "state") == 0)
    {
        return state(argument + 2);
    }
    if (arguments >= 7 && strcmp(argument[1], "run") == 0)
    {
        return run(arguments - 2, argument + 2);
    }
    if (arguments >= 3 && strcmp(argument[1], "spend") == 0)
    {
        return spend(argument + 2);
    }
    return fail("see the first comment of bed.c for the arguments");
}
