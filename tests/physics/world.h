/*
 * world.h -- set up a scene from text and particles, run it, and read results: for the tests of
 * physics.
 *
 *   struct dem *d = world(scene, n, seeds);   a run, without MPI; or in two steps:
 *   struct dem_case *c = world_begin(scene); dem_case_...(c, ...); struct dem *d = world_start(c);
 *   world(world_text("... %g ...", x), n, seeds)   a scene from a format; texts are never freed
 *   world_refused(scene, words);                a claim that it is refused by a sentence with these
 *   world_run(d, 0.1); or world_step(d)       for one step of the scene's time/step
 *   world_at(d, id).x[2]                      position, velocity, spin, contact force and torque
 *
 *   world_make_file(path)                       for a snapshot: "/tmp/NAME.XXXXXX"
 *
 * An error of the core ends the test with the core's sentence.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "unit/tap.h"

#include "dem_query.h"
#include "dem_fluid.h"
#include "dem_plan.h"
#include "dem_tables.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double world_pi = 3.14159265358979324;

struct world_particle
{
    double x[3], v[3], w[3], f[3], t[3], radius, mass;
};

__attribute__((noreturn)) static inline void world_end(const char *call)
{
    printf("Bail out! %s: %s\n", call, dem_error_text());
    exit(1);
}

#define WORLD_TRY(call) ((call) ? world_end(#call) : (void)0)

/* Make an empty file; path ends with XXXXXX, which become its own letters. The caller removes it. */
static inline void world_make_file(char *path)
{
    const int file = mkstemp(path);

    if (file < 0)
    {
        printf("Bail out! no file %s\n", path);
        exit(1);
    }
    close(file);
}

/* memory for a text; never freed */
static inline char *world_room(size_t bytes)
{
    static struct room
    {
        struct room *next;
        char text[];
    } *rooms;
    struct room *const r = malloc(sizeof *r + bytes);

    if (!r)
    {
        printf("Bail out! no memory for a text\n");
        exit(1);
    }
    r->next = rooms;
    rooms = r;
    return r->text;
}

/* text from a format, for as long as the program runs */
__attribute__((format(printf, 1, 2)))
static inline char *world_text(const char *format, ...)
{
    va_list arguments, again;

    va_start(arguments, format);
    va_copy(again, arguments);
    const size_t bytes = (size_t)vsnprintf(NULL, 0, format, again) + 1;
    char *const text = world_room(bytes);

    vsnprintf(text, bytes, format, arguments);
    va_end(again);
    va_end(arguments);
    return text;
}

static inline struct dem_case *world_begin(const char *scene)
{
    struct dem_case *c;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    WORLD_TRY(dem_case_scene_text(c, scene, "scene"));
    return c;
}

static inline struct dem *world_start(struct dem_case *c)
{
    struct dem *d;

    WORLD_TRY(dem_start(&c, &d));
    return d;
}

/* claims that the scene is refused in a sentence with these words */
static inline void world_refused(const char *scene, const char *words)
{
    struct dem_case *c;
    struct dem *d = NULL;

    WORLD_TRY(dem_case_create(&c, MPI_COMM_NULL));
    int status = dem_case_scene_text(c, scene, "scene");

    status = status ? status : dem_start(&c, &d);
    TAP_OK(status == DEM_ERROR_INPUT && strstr(dem_error_text(), words), "refused: %s",
           status ? dem_error_text() : scene);
    dem_free(d);
}

/* the status of a start, for a case that should be refused */
static inline int world_status(struct dem_case *c)
{
    struct dem *d;
    const int status = dem_start(&c, &d);

    dem_free(d);
    return status;
}

static inline struct dem *world(const char *scene, int64_t n, const struct dem_new_particle *seed)
{
    struct dem_case *const c = world_begin(scene);

    if (n > 0)
    {
        WORLD_TRY(dem_case_add_particles(c, n, seed));
    }
    return world_start(c);
}

static inline void world_run(struct dem *d, double duration)
{
    WORLD_TRY(dem_advance(d, duration));
}

static inline void world_step(struct dem *d)
{
    WORLD_TRY(dem_advance(d, dem_step_limit(d).used));
}

static inline struct dem_totals world_tally(struct dem *d)
{
    struct dem_totals t;

    WORLD_TRY(dem_totals(d, &t));
    return t;
}

static inline uint64_t world_hash(struct dem *d)
{
    uint64_t hash;

    WORLD_TRY(dem_hash(d, &hash));
    return hash;
}

/* by index in the view, 0 to particles - 1 */
static inline int64_t world_id(const struct dem_view *v, size_t k)
{
    return *(const int64_t *)(const void *)((const char *)v->id + v->stride*k);
}

static inline struct world_particle world_take(const struct dem_view *v, size_t k)
{
    struct world_particle p = {.radius = *dem_at(v->radius, v->stride, k),
                               .mass = *dem_at(v->mass, v->stride, k)};

    memcpy(p.x, dem_at(v->position, v->stride, k), sizeof p.x);
    memcpy(p.v, dem_at(v->velocity, v->stride, k), sizeof p.v);
    memcpy(p.w, dem_at(v->spin, v->stride, k), sizeof p.w);
    memcpy(p.f, v->force + 3*k, sizeof p.f);
    memcpy(p.t, v->torque + 3*k, sizeof p.t);
    return p;
}

/* all particles, by id: ids 0 to n - 1 */
static inline void world_all(const struct dem *d, struct world_particle *p)
{
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        p[world_id(&v, k)] = world_take(&v, k);
    }
}

static inline struct world_particle world_at(const struct dem *d, int64_t id)
{
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        if (world_id(&v, k) == id)
        {
            return world_take(&v, k);
        }
    }
    printf("Bail out! there is no particle %lld\n", (long long)id);
    exit(1);
}

/* a particle scalar of all particles of one rank, by id */
static inline void world_scalars(struct dem *d, const char *name, double *value)
{
    const double *const all = dem_scalar(d, dem_scalar_index(d, name));
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        value[world_id(&v, k)] = all[k];
    }
}

/* a particle scalar of particle `id` */
static inline double world_scalar(struct dem *d, const char *name, int64_t id)
{
    const double *const all = dem_scalar(d, dem_scalar_index(d, name));
    struct dem_view v;

    dem_view(d, &v);
    for (size_t k = 0; k < v.n; k++)
    {
        if (world_id(&v, k) == id)
        {
            return all[k];
        }
    }
    printf("Bail out! there is no particle %lld\n", (long long)id);
    exit(1);
}

/* stream or outlet number k of the scene */
static inline struct dem_flow world_flow(struct dem *d, int k)
{
    const struct dem_flow *all;
    int n;

    WORLD_TRY(dem_flows(d, &n, &all));
    if (k >= n)
    {
        printf("Bail out! there are %d flows\n", n);
        exit(1);
    }
    return all[k];
}

/* force on the wall of this name */
static inline void world_wall(struct dem *d, const char *name, double force[3])
{
    double torque[3];

    for (int w = 0; w < dem_wall_count(d); w++)
    {
        if (strcmp(dem_wall_name(d, w), name) == 0)
        {
            WORLD_TRY(dem_wall_load(d, w, force, torque));
            return;
        }
    }
    printf("Bail out! there is no wall %s\n", name);
    exit(1);
}

static inline double world_sphere_mass(double radius, double density)
{
    return 4.0/3.0*world_pi*radius*radius*radius*density;
}

/* duration of an elastic Hertzian impact; Johnson, Contact Mechanics (1985), section 11.4 */
static inline double world_contact_time(double reduced_mass, double reduced_radius,
                                        double reduced_modulus, double speed)
{
    return 2.8682656992*pow(reduced_mass*reduced_mass/
                                  (reduced_radius*reduced_modulus*reduced_modulus*speed),
                              0.2);
}

/* a table of numbers with commas, "#" lines and one line of names skipped; returns the number of
   rows. `name` is relative to tests/, where the programs run. */
static inline int world_table(const char *name, int columns, int capacity, double *row)
{
    FILE *const f = fopen(name, "r");
    char line[1024];
    int rows = 0;

    if (!f)
    {
        printf("Bail out! cannot open %s\n", name);
        exit(1);
    }
    while (rows < capacity && fgets(line, sizeof line, f))
    {
        char *at = line, *end;
        int k = 0;

        for (; k < columns; k++, at = end + (*end == ','))
        {
            row[rows*columns + k] = strtod(at, &end);
            if (end == at)
            {
                break;
            }
        }
        rows += k == columns;
    }
    fclose(f);
    return rows;
}
