/*
 * test_failures.c -- errors on several ranks.
 *
 * - An error of MPI on the library's communicator is returned as DEM_ERROR_MPI with MPI's text and
 *   does not abort.
 * - When one rank runs out of memory in a collective call, or gives it a number of items below 0,
 *   all ranks return an error and none waits: also while they insert and pack spheres, open streams
 *   and mark bonds.
 *
 *     mpirun -np N test_failures    N >= 2; prints failures; status 0 if there are none
 *
 * MPI calls of the library pass through functions of this file (profiling interface of MPI). To
 * make a call fail, they broadcast from an invalid root on the same communicator instead, which
 * invokes its error handler. Every allocation of the core goes through aligned_alloc, which fails
 * once on the second rank.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "parallel/ranks.h"

#include "dem_fluid.h"
#include "dem_tables.h"
#include "case/dem_case.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum
{
    MANY = 300,
    LIMIT = 60    /* s  a rank that waits for so long in one trial ends the test */
};

static void check_of(int holds, const char *what, const char *of, double found, double expected)
{
    char text[256];

    snprintf(text, sizeof text, "%s, %s", of, what);
    check(holds, text, found, expected);
}

/* ---- faults ---------------------------------------------------------------------------------- */

static const char *broken = "";           /* names of the MPI calls that fail */
static long last_allocation =
    -1;         /* that many allocations succeed, then one fails; -1: all succeed */

void *aligned_alloc(size_t alignment, size_t size)
{
    void *p = NULL;

    if (last_allocation >= 0 && last_allocation-- == 0)
    {
        return NULL;
    }
    return posix_memalign(&p, alignment, size) ? NULL : p;
}

static int fails(const char *call)
{
    const char *const at = strstr(broken, call);

    return at && strchr(" ", at[strlen(call)]);
}

static int wrong_root(MPI_Comm comm)
{
    int value = 0;

    return PMPI_Bcast(&value, 1, MPI_INT, ranks + 7, comm);
}

int MPI_Allreduce(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    return fails("MPI_Allreduce") ? wrong_root(comm) : PMPI_Allreduce(in, out, n, type, op, comm);
}

int MPI_Reduce(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm)
{
    return fails("MPI_Reduce") ? wrong_root(comm) : PMPI_Reduce(in, out, n, type, op, root, comm);
}

int MPI_Exscan(const void *in, void *out, int n, MPI_Datatype type, MPI_Op op, MPI_Comm comm)
{
    return fails("MPI_Exscan") ? wrong_root(comm) : PMPI_Exscan(in, out, n, type, op, comm);
}

int MPI_Allgather(const void *in, int n, MPI_Datatype type, void *out, int count,
                  MPI_Datatype out_type, MPI_Comm comm)
{
    return fails("MPI_Allgather") ? wrong_root(comm)
                                  : PMPI_Allgather(in, n, type, out, count, out_type, comm);
}

int MPI_Bcast(void *data, int n, MPI_Datatype type, int root, MPI_Comm comm)
{
    return fails("MPI_Bcast") ? wrong_root(comm) : PMPI_Bcast(data, n, type, root, comm);
}

static MPI_Comm library_comm = MPI_COMM_NULL;

/* The data have arrived, but the call returns an error. */
int MPI_Waitall(int n, MPI_Request *request, MPI_Status *status)
{
    const int code = PMPI_Waitall(n, request, status);

    return fails("MPI_Waitall") ? wrong_root(library_comm) : code;
}

int MPI_Irecv(void *data, int n, MPI_Datatype type, int source, int tag, MPI_Comm comm,
              MPI_Request *request)
{
    return fails("MPI_Irecv") ? wrong_root(comm)
                              : PMPI_Irecv(data, n, type, source, tag, comm, request);
}

int MPI_Isend(const void *data, int n, MPI_Datatype type, int target, int tag, MPI_Comm comm,
              MPI_Request *request)
{
    return fails("MPI_Isend") ? wrong_root(comm)
                              : PMPI_Isend(data, n, type, target, tag, comm, request);
}

/* ---- calls of the library -------------------------------------------------------------------- */

static char folder[] = "/tmp/test_failures_XXXXXX", snapshot[64];

/* A packing with relaxation through periodic faces among a list, spheres on a lattice off the walls
   of a closed region, particles of the program, bonds, a stream, an outlet, an absorbing wall. */
static struct dem_case *create_packed(int energy)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e6; } } "
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } "
        "bondLinear { normalStiffness 1e9; shearStiffness 1e9; } }"
        "domain { min (0 0 -0.001); max (0.004 0.004 0.02); periodic (x y); }"
        "walls { floor { type plane; point (0 0 0); normal (0 0 1); } lid { type plane; "
        "point (0 0 0.019); normal (0 0 -1); absorb yes; } }"
        "insert { row { type list; diameter 1e-3; positions ((0.001 0.001 0.001) (0.002 0.001 "
        "0.001)); } packed { type random; diameter 1e-3; solidFraction 0.36; "
        "min (0 0 0.0005); max (0.004 0.004 0.003); inside walls; }"
        "top { type lattice; diameter 1e-3; count 8; min (0 0 0.006); max (0.004 0.004 0.008); "
        "inside walls; } feed { type stream; diameter 1e-3; rate 1e6; min (0 0 0.01); "
        "max (0.004 0.004 0.012); count 5; } } bonds { pairs (0 1); }"
        "outlets { sink { min (0 0 0.015); max (0.004 0.004 0.016); } }";
    static const double plate[9] = {0.0, 0.0, 0.018, 0.004, 0.0, 0.018, 0.0, 0.004, 0.018};
    const struct dem_new_particle extra[2] = {
        {.position = {0.001, 0.001, 0.014}, .diameter = 1e-3, .id = -1, .material = "glass"},
        {.position = {0.003, 0.003, 0.014}, .diameter = 1e-3, .id = -1, .material = "glass"}};
    struct dem_case *c;

    try(dem_case_create(&c, MPI_COMM_WORLD));
    try(dem_case_scene_text(c, scene, "packed"));
    try(dem_case_add_wall(c, "plate", "glass", 1, plate));
    try(dem_case_add_particles(c, 2, extra));
    try(energy ? dem_case_enable_energy(c) : DEM_OK);
    library_comm = c->d->state.decomposition.comm;
    return c;
}

static struct dem_case *create(int energy)
{
    static const char scene[] =
        "materials { glass { density 2500; youngsModulus 1e6; } } "
        "effects { hertz {} dry { restitution 0.5; } mindlin { friction 0.3; } }"
        "domain { x (0 %.17g); periodic (x); } insert { row { type lattice; count %d; "
        "diameter 1e-3; spacing 1.04; jitter 0.5; min (0 0 0);"
        " max (%.17g 0.00313 0.00313); velocity (0.3 0 0); seed 3; } }"
        "walls { plate { type triangles; corners ((0 0 -1) (1 0 -1) (0 1 -1)); motion { type"
        " translation; velocity (0 0 -1e-3); } } }"
        "averages { all { min (0 0 0); max (0.01 0.003 0.003); interval 1e-7; } }";
    const double length = 0.03120001*ranks;
    char text[1024];
    struct dem_case *c;

    snprintf(text, sizeof text, scene, length, 270*ranks, length);
    try(dem_case_create(&c, MPI_COMM_WORLD));
    try(dem_case_scene_text(c, text, "row"));
    try(energy ? dem_case_enable_energy(c) : DEM_OK);
    library_comm = c->d->state.decomposition.comm;
    return c;
}

/* The saved row continues with a stream. */
static struct dem_case *create_started(int energy)
{
    char text[512];
    struct dem_case *c;

    snprintf(text, sizeof text,
             "materials { glass { density 2500; youngsModulus 1e6; } } effects { hertz {} "
             "dry { restitution 0.5; } mindlin { friction 0.3; } } domain { x (0 %.17g); "
             "periodic (x); } start { snapshot \"%s\"; } insert { feed { type stream; rate 10; "
             "diameter 1e-3; min (0 0 0.01); max (0.01 0.01 0.02); } } walls { floor { type plane; "
             "point (0 0 -1); normal (0 0 1); } }", 0.03120001*ranks, snapshot);
    try(dem_case_create(&c, MPI_COMM_WORLD));
    try(dem_case_scene_text(c, text, "started"));
    try(energy ? dem_case_enable_energy(c) : DEM_OK);
    library_comm = c->d->state.decomposition.comm;
    return c;
}

static int call_create(struct dem_case **unused)
{
    struct dem_case *c;
    const int status = dem_case_create(&c, MPI_COMM_WORLD);

    (void)unused;
    dem_case_free(c);
    return status;
}

static int call_totals(struct dem *d)
{
    struct dem_totals t;

    return dem_totals(d, &t);
}

static int call_hash(struct dem *d)
{
    uint64_t hash;

    return dem_hash(d, &hash);
}

static int call_profile(struct dem *d)
{
    struct dem_profile profile;

    return dem_profile(d, &profile);
}

static int call_energy(struct dem *d)
{
    const struct dem_energy_item *item;
    double since;
    int n;

    return dem_energy(d, &since, &n, &item);
}

static int call_moving(struct dem *d)
{
    int64_t n;

    return dem_count_moving(d, 0.0, &n);
}

static int call_lost(struct dem *d)
{
    const struct dem_loss *loss;
    int64_t n;

    return dem_lost(d, &n, &loss);
}

static int call_broken_bonds(struct dem *d)
{
    const struct dem_broken_bond *bond;
    int64_t n;

    return dem_broken_bonds(d, &n, &bond);
}

static int call_bonds_draw(struct dem *d)
{
    return dem_bonds_draw(d, folder, "bonds.vtp", 0.0);
}

static int call_advance(struct dem *d)
{
    return dem_advance(d, 40.0*d->step);
}

static int call_save(struct dem *d)
{
    return dem_save(d, snapshot);
}

static int call_start(struct dem_case **c)
{
    struct dem *d;
    const int status = dem_start(c, &d);

    dem_free(d);
    return status;
}

static int call_load(struct dem_case **c)
{
    try(dem_case_load(*c, snapshot));
    return call_start(c);
}

static const double triangle[9] = {0, 0, 5, 1, 0, 5, 0, 1, 5};
static int64_t triangles = 1;    /* of this rank, in the next call */

static int call_add_wall(struct dem_case **c)
{
    return dem_case_add_wall(*c, "added", "glass", triangles, triangle);
}

static int call_move_wall(struct dem_case **c)
{
    try(dem_case_add_wall(*c, "added", "glass", 1, triangle));
    return dem_case_move_wall(*c, "added", triangles, triangle);
}

static int call_patch(struct dem_case **c)
{
    return dem_case_add_patch(*c, "inlet", triangles, triangle, NULL);
}

static int call_region(struct dem_case **c)
{
    static const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const int of[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    double surface[36];

    for (int k = 0; k < 12; k++)
    {
        memcpy(surface + 3*k, corners[of[k/3][k%3]], sizeof corners[0]);
    }
    return dem_case_add_region(*c, "", 0, triangles < 0 ? triangles : rank == 0 ? 4 : 0, surface);
}

struct trial
{
    const char *broken, *name;
    int (*run)(struct dem *);               /* a call of a run, or NULL: */
    int (*describe)(struct dem_case **);    /* of a case */
};

struct tried
{
    struct dem_case *c;
    struct dem *d;
};

static struct tried make(const struct trial *t, struct dem_case *(*create_case)(int energy))
{
    struct tried m = {.c = create_case(t->run != NULL)};

    try(t->run ? dem_start(&m.c, &m.d) : DEM_OK);
    return m;
}

static int make_call(const struct trial *t, struct tried *m)
{
    return t->run ? t->run(m->d) : t->describe(&m->c);
}

static void end(struct tried *m)
{
    dem_case_free(m->c);
    dem_free(m->d);
}

/* ---- MPI ------------------------------------------------------------------------------------- */

static void mpi_errors(void)
{
    static const struct trial trials[] =
    {
        {"MPI_Allreduce", "dem_totals", call_totals, NULL},
        {"MPI_Allreduce", "dem_hash", call_hash, NULL},
        {"MPI_Allreduce", "dem_profile", call_profile, NULL},
        {"MPI_Allreduce", "dem_energy", call_energy, NULL},
        {"MPI_Allreduce", "dem_count_moving", call_moving, NULL},
        {"MPI_Allreduce", "dem_advance", call_advance, NULL},
        {"MPI_Allreduce", "dem_save", call_save, NULL},
        {"MPI_Allreduce", "dem_start", NULL, call_start},
        {"MPI_Allgather", "dem_lost", call_lost, NULL},
        {"MPI_Allgather", "dem_broken_bonds", call_broken_bonds, NULL},
        {"MPI_Exscan", "dem_save", call_save, NULL},
        {"MPI_Exscan", "dem_bonds_draw", call_bonds_draw, NULL},
        {"MPI_Reduce", "dem_advance", call_advance, NULL},
        {"MPI_Waitall", "dem_advance", call_advance, NULL},
        {"MPI_Irecv MPI_Isend", "dem_advance", call_advance, NULL},
        {"MPI_Bcast", "dem_case_load", NULL, call_load},
    };
    struct dem_case *c = create(0);
    struct dem *saved;

    try(dem_start(&c, &saved));
    try(dem_save(saved, snapshot));                       /* for dem_case_load */
    dem_free(saved);
    for (size_t k = 0; k < sizeof trials/sizeof *trials; k++)
    {
        const struct trial *const t = &trials[k];
        char call_name[32], name[96];

        struct tried m = make(t, create);

        broken = t->broken;
        const int status = make_call(t, &m);

        broken = "";
        snprintf(name, sizeof name, "%s fails in %s", t->broken, t->name);
        snprintf(call_name, sizeof call_name, "%.*s failed", (int)strcspn(t->broken, " "),
                 t->broken);
        check_of(status == DEM_ERROR_MPI, "status", name, status, DEM_ERROR_MPI);
        check_of(strstr(dem_error_text(), call_name) != NULL, "the message names the call", name, 0,
              1);
        check_of(strstr(dem_error_text(), "root") != NULL, "the message has the text of MPI", name, 0,
              1);
        end(&m);
    }
}

/* ---- memory ---------------------------------------------------------------------------------- */

/* The k-th allocation of a call fails on the second rank, for all k, and for every seventh beyond
   MANY, where a packing makes the same allocations again and again: all ranks fail, or none when
   there are fewer allocations. */
static void memory(const struct trial *t, struct dem_case *(*create_case)(int energy))
{
    int done = 0;

    for (long k = 0; !done && !failed; k += k < MANY ? 1 : 7)
    {
        struct tried m = make(t, create_case);
        int all[2];

        alarm(LIMIT);
        last_allocation = rank == 1 ? k : -1;
        const int status = make_call(t, &m);

        all[0] = status != DEM_OK;
        all[1] = status == DEM_OK;
        done = rank == 1 && last_allocation >= 0;
        last_allocation = -1;
        PMPI_Allreduce(MPI_IN_PLACE, all, 2, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        PMPI_Bcast(&done, 1, MPI_INT, 1, MPI_COMM_WORLD);
        check_of(all[0] + all[1] == 1, "ranks that fail, and others that do not, without memory",
              t->name, (double)k, 0);
        check_of(done == (all[0] == 0), "fails without memory", t->name, all[0], !done);
        end(&m);
        PMPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    }
    alarm(0);
}

static void no_memory(void)
{
    static const struct trial trials[] =
    {
        {"", "dem_save", call_save, NULL},
        {"", "dem_bonds_draw", call_bonds_draw, NULL},
        {"", "dem_case_load", NULL, call_load},
        {"", "dem_start", NULL, call_start},
        {"", "dem_advance", call_advance, NULL},
        {"", "dem_case_add_wall", NULL, call_add_wall},
        {"", "dem_case_add_patch", NULL, call_patch},
        {"", "dem_case_add_region", NULL, call_region},
    };
    static const struct trial create_again = {"", "dem_case_create", NULL, call_create};
    static const struct trial of_start = {"", "dem_start with a start", NULL, call_start};
    static const struct trial of_packing[] =
    {
        {"", "dem_start of a packing", NULL, call_start},
        {"", "dem_advance of a packing", call_advance, NULL},
    };

    for (size_t k = 0; k < sizeof trials/sizeof *trials; k++)
    {
        memory(&trials[k], create);
    }
    if (ranks > 2)    /* would repeat what two ranks have shown */
    {
        return;
    }
    for (size_t k = 0; k < sizeof of_packing/sizeof *of_packing; k++)
    {
        memory(&of_packing[k], create_packed);
    }
    memory(&of_start, create_started);
    memory(&create_again, create_started);
}

/* ---- numbers of items ------------------------------------------------------------------------ */

static void wrong_counts(void)
{
    static const struct trial trials[] =
    {
        {"", "dem_case_add_wall", NULL, call_add_wall},
        {"", "dem_case_move_wall", NULL, call_move_wall},
        {"", "dem_case_add_patch", NULL, call_patch},
        {"", "dem_case_add_region", NULL, call_region},
    };

    for (size_t k = 0; k < sizeof trials/sizeof *trials; k++)
    {
        struct tried m = make(&trials[k], create);

        triangles = rank == 1 ? -1 : 1;
        const int status = make_call(&trials[k], &m);

        triangles = 1;
        check_of(status == DEM_ERROR_INPUT, "one rank gives -1 triangles", trials[k].name, status,
              DEM_ERROR_INPUT);
        end(&m);
    }
}

/* ---- reductions and gathers ------------------------------------------------------------------ */

static void reductions(const struct dem_decomposition *p)
{
    const int64_t own = rank + 1;
    int64_t sum = own, before = -1, max = own;
    double min = rank;

    dem_collect_sum_int64(p, &sum, 1);
    dem_collect_max_int64(p, &max, 1);
    dem_collect_min_double(p, &min, 1);
    dem_collect_sum_before(p, &own, &before, 1);
    check_of(sum == ranks*(ranks + 1)/2, "sum", "collect", (double)sum, ranks*(ranks + 1)/2);
    check_of(max == ranks, "maximum", "collect", (double)max, ranks);
    check_of(min == 0.0, "minimum", "collect", min, 0);
    check_of(before == rank*(rank + 1)/2, "sum of lower ranks", "collect", (double)before,
          rank*(rank + 1)/2);
    check_of(dem_collect_agree(p, DEM_OK) == DEM_OK, "agreement", "collect", 1, 0);
    check_of(dem_collect_agree(p, rank == 1 ? dem_error(DEM_ERROR_INPUT, "one") : DEM_OK) ==
              DEM_ERROR_INPUT,
          "agreement on an error", "collect", 0, 1);
}

/* Rank k gives k items of 24 bytes, so the first one gives none. */
static void gathers(const struct dem_decomposition *p)
{
    double item[3*64];
    struct dem_collect_items own = {"items", item, (size_t)rank, 3*sizeof *item};
    double *x;
    size_t n;
    void *all;

    for (int k = 0; k < 3*rank; k++)
    {
        item[k] = rank;
    }
    try(dem_collect_gather(p, DEM_OK, &own, &all, &n));
    check_of(n == (size_t)(ranks*(ranks - 1)/2), "items", "gather", (double)n, ranks*(ranks - 1)/2);
    x = all;
    for (int k = 0, at = 0; k < ranks; k++)
    {
        for (int m = 0; m < 3*k; m++, at++)
        {
            check_of(x[at] == k, "item", "gather", x[at], k);
        }
    }
    dem_memory_free(all);
    check_of(dem_collect_gather(p, rank == 1 ? dem_error(DEM_ERROR_INPUT, "one") : DEM_OK, &own, &all,
                             &n) == DEM_ERROR_INPUT,
          "a rank has failed before", "gather", 0, 1);
    last_allocation = rank == 1 ? 0 : -1;
    check_of(dem_collect_gather(p, DEM_OK, &own, &all, &n) == DEM_ERROR_MEMORY && !all,
          "a rank has no memory", "gather", 0, 1);
    last_allocation = -1;
    own.n = 0;
    check_of(dem_collect_gather(p, DEM_OK, &own, &all, &n) == DEM_OK && n == 0 && !all, "nothing",
          "gather", 0, 1);
}

static void clean_up(void)
{
    static const char *const files[] = {"bonds.vtp", "bonds.pvd"};
    char path[96];

    PMPI_Barrier(MPI_COMM_WORLD);
    if (rank == 0)
    {
        remove(snapshot);
    }
    for (size_t k = 0; rank == 0 && k < sizeof files/sizeof *files; k++)
    {
        snprintf(path, sizeof path, "%s/%s", folder, files[k]);
        remove(path);
    }
    if (rank == 0 && remove(folder) != 0)
    {
        printf("# files are left in %s\n", folder);
        failed = 1;
    }
}

int main(int argc, char **argv)
{
    struct dem_decomposition p;

    ranks_begin(&argc, &argv);
    check_of(ranks > 1 && ranks <= 64, "ranks; run it on 2 to 64", "", ranks, 2);
    if (rank == 0 && !mkdtemp(folder))
    {
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    PMPI_Bcast(folder, sizeof folder, MPI_CHAR, 0, MPI_COMM_WORLD);
    snprintf(snapshot, sizeof snapshot, "%s/snapshot.dem", folder);
    try(dem_decomposition_init(&p, MPI_COMM_WORLD, rank, ranks));
    reductions(&p);
    gathers(&p);
    dem_decomposition_free(&p);
    mpi_errors();
    no_memory();
    wrong_counts();
    clean_up();
    return ranks_end();
}
