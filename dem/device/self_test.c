/*
 * self_test.c -- some thousand random contact rows of each pair class, with history, on the device
 * and through the loops of the CPU: all numbers must have the same bits.
 *
 * It finds a compiler that contracts products and sums, divides or takes roots inexactly, or flushes
 * small numbers to zero. Where the order of the laws is repeated here, step/contact_effects.c has the
 * original.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/self_test.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "device/shared.h"
#include "laws/batch.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    BATCHES = 64,
    ROWS = BATCHES*DEM_BATCH_ROWS,
    TIMES = 5
};

#define COUNT(column) +1
enum
{
    ROW_COLUMNS = 0 DEM_ROW_COLUMNS(COUNT)
};

struct test
{
    const struct dem_effect_list *list;
    int columns, numbers;               /* of history; of a row */
    double times[TIMES];                /* dt, max_dt, 1/dt, time, previous time */
    double *in, *here, *there;          /* rows */
    struct dem_contact_batch *batch;
    double (*history)[DEM_BATCH_ROWS];
    struct dem_scalar_rows scalars[DEM_EFFECT_SCALARS];
    double scalar[5][DEM_BATCH_ROWS];   /* values, rates, radius */
    uint64_t draws;
};

/* ---- random rows ------------------------------------------------------------------------------- */

static double uniform(struct test *t, double min, double max)
{
    return min + (max - min)*dem_random_unit(7, t->draws++, 0, 0);
}

static double positive(struct test *t, double min, double max)
{
    return dem_exp(uniform(t, dem_log(min), dem_log(max)));
}

static void unit_vector(struct test *t, double *x, double *y, double *z)
{
    const double a = uniform(t, -1.0, 1.0), b = uniform(t, -1.0, 1.0), c = uniform(t, -1.0, 1.0),
                 size = sqrt(a*a + b*b + c*c + 1e-9);

    *x = a/size;
    *y = b/size;
    *z = c/size;
}

/* A contact of two particles of the class, with any motion. */
static struct dem_contact_row random_row(struct test *t)
{
    struct dem_contact_row r;
    const double radius = t->list->pair.min_radius*positive(t, 1.0, 20.0),
                 gap = uniform(t, -0.1, t->list->past_touching ? 0.1 : -1e-6)*radius;

#define ANY(column) r.column = uniform(t, -1.0, 1.0);
    DEM_ROW_COLUMNS(ANY)
    unit_vector(t, &r.nx, &r.ny, &r.nz);
    unit_vector(t, &r.hx, &r.hy, &r.hz);
    r.gap = gap;
    r.distance = 2.0*radius + gap;
    r.overlap = gap < 0.0 ? -gap : 0.0;
    r.touching = gap < 0.0 ? 1.0 : 0.0;
    r.min_radius = radius;
    r.reduced_radius = radius*uniform(t, 0.5, 1.0);
    r.reduced_mass = t->list->pair.min_mass*positive(t, 1.0, 1e3);
    r.normal_spin = uniform(t, -1e3, 1e3);
    r.viscosity = 0.0;
    r.is_primary = 1.0;
    r.pair_random = uniform(t, 0.0, 1.0);
    /* as the caller of the laws clears them */
    r.bond_replaces = r.scratch = r.adhesive_force = 0.0;
    r.kn = r.kt = r.eta = r.fn = r.fx = r.fy = r.fz = r.mx = r.my = r.mz = 0.0;
    r.stored = r.lost = r.bonds = r.broke = r.cause = r.dissipated = 0.0;
    return r;
}

static void fill(struct test *t)
{
    double *to = t->in;

    for (int row = 0; row < ROWS; row++)
    {
        const struct dem_contact_row r = random_row(t);

#define PUT(column) *to++ = r.column;
        DEM_ROW_COLUMNS(PUT)
        for (int m = 0; m < t->columns; m++)
        {
            *to++ = row % 4 == 0 ? 0.0 : r.min_radius*uniform(t, -1e-2, 1e-2);
        }
    }
}

/* ---- the laws on the CPU ----------------------------------------------------------------------- */

static int history_of(struct test *t, int k, double **history)
{
    int before = 0, columns;

    for (int e = 0; e < k; e++)
    {
        before += dem_effect_history_columns(t->list->entry[e].effect);
    }
    columns = dem_effect_history_columns(t->list->entry[k].effect);
    for (int m = 0; m < columns; m++)
    {
        history[m] = t->history[before + m];
    }
    return columns;
}

static void clear_apart(struct test *t, double *history)
{
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        history[c] = t->batch->touching[c] > 0.0 ? history[c] : 0.0;
    }
}

/* The functions of a law besides `apply`. */
static void apply_others(struct test *t, int adhesion)
{
    double *history[DEM_HISTORY_COLUMNS];

    for (int k = 0; k < t->list->entries; k++)
    {
        const struct dem_effect *const e = t->list->entry[k].effect;

        history_of(t, k, history);
        if (adhesion && e->set_adhesion)
        {
            e->set_adhesion(t->list->entry[k].settings, t->batch, history);
        }
        if (!adhesion && e->replace_contact)
        {
            e->replace_contact(t->list->entry[k].settings, t->batch, history);
        }
    }
}

static void apply_laws(struct test *t)
{
    double *history[DEM_HISTORY_COLUMNS];
    int damped = 0;

    apply_others(t, 0);
    for (int k = 0; k < t->list->entries; k++)
    {
        const struct dem_effect *const e = t->list->entry[k].effect;

        if (e->stage >= DEM_STAGE_TANGENT && !damped)
        {
            damped = 1;
            apply_others(t, 1);
        }
        const int columns = history_of(t, k, history);

        e->apply(t->list->entry[k].settings, t->batch, history);
        for (int m = 0; m < columns && e->stage < DEM_STAGE_BOND; m++)
        {
            clear_apart(t, history[m]);
        }
    }
}

/* Each scalar of each law has the same values (test.cl). */
static void give_scalars(struct test *t)
{
    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        const double radius = t->batch->min_radius[c], cube = radius*radius*radius;

        t->scalar[0][c] = 0.01*cube;
        t->scalar[1][c] = 0.02*cube;
        t->scalar[2][c] = t->scalar[3][c] = 0.0;
        t->scalar[4][c] = radius;
    }
    for (int m = 0; m < DEM_EFFECT_SCALARS; m++)
    {
        t->scalars[m] = (struct dem_scalar_rows){.i = t->scalar[0], .j = t->scalar[1],
                                                 .rate_i = t->scalar[2], .rate_j = t->scalar[3],
                                                 .radius_i = t->scalar[4],
                                                 .radius_j = t->scalar[4]};
    }
    t->batch->scalars = t->scalars;
}

/* Rows of `in` through the laws, to `here`. */
static void compute_here(struct test *t)
{
    struct dem_contact_batch *const b = t->batch;
    const double *from = t->in;
    double *to = t->here;

    b->n = DEM_BATCH_ROWS;
    b->dt = t->times[0];
    b->max_dt = t->times[1];
    b->time = t->times[3];
    b->previous_time = t->times[4];
    for (int at = 0; at < BATCHES; at++)
    {
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
#define TO_BATCH(column) b->column[c] = *from++;
            DEM_ROW_COLUMNS(TO_BATCH)
            for (int m = 0; m < t->columns; m++)
            {
                t->history[m][c] = *from++;
            }
        }
        give_scalars(t);
        apply_laws(t);
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
#define FROM_BATCH(column) *to++ = b->column[c];
            DEM_ROW_COLUMNS(FROM_BATCH)
            for (int m = 0; m < t->columns; m++)
            {
                *to++ = t->history[m][c];
            }
        }
    }
}

/* ---- the laws on the device -------------------------------------------------------------------- */

static int run(struct dem_opencl *cl, struct test *t, int class, struct dem_opencl_memory memory[3])
{
    const size_t bytes = (size_t)t->numbers*ROWS*sizeof(double);
    struct dem_opencl_kernel *kernel;
    char name[32];

    snprintf(name, sizeof name, "test_%d", class);
    DEM_TRY(dem_opencl_kernel(cl, name, &kernel));
    DEM_TRY(dem_opencl_reserve(cl, &memory[0], bytes));
    DEM_TRY(dem_opencl_reserve(cl, &memory[1], sizeof t->times));
    DEM_TRY(dem_opencl_reserve(cl, &memory[2], bytes));
    DEM_TRY(dem_opencl_write(cl, &memory[0], 0, bytes, t->in));
    DEM_TRY(dem_opencl_write(cl, &memory[1], 0, sizeof t->times, t->times));
    DEM_TRY(dem_opencl_give_number(cl, kernel, 0, ROWS));
    DEM_TRY(dem_opencl_give_number(cl, kernel, 1, (uint32_t)t->numbers));
    DEM_TRY(DEM_OPENCL_GIVE(cl, kernel, 2, &memory[0], &memory[1], &memory[2]));
    DEM_TRY(dem_opencl_launch(cl, kernel, ROWS));
    return dem_opencl_read(cl, &memory[2], 0, bytes, t->there);
}

/* Not a number has no certain bits, and minus zero of a row that does not touch none either, as it is
   added to sums. */
static int same(double a, double b)
{
    return dem_math_bits(a + 0.0) == dem_math_bits(b + 0.0) || (isnan(a) && isnan(b));
}

static int compare(const struct dem_opencl *cl, const struct test *t)
{
    int differ = 0;

    for (int row = 0; row < ROWS; row++)
    {
        int equal = 1;

        for (int k = 0; k < t->numbers; k++)
        {
            const size_t at = (size_t)row*(size_t)t->numbers + (size_t)k;

            equal &= same(t->here[at], t->there[at]);
        }
        differ += !equal;
    }
    DEM_REQUIRE(differ == 0, DEM_ERROR_STATE, "the device %s (driver %s) computes %d of %d contacts "
                "of %s and %s with other bits than the CPU; its compiler may contract or "
                "approximate operations",
                dem_opencl_device(cl)->name, dem_opencl_device(cl)->driver, differ, (int)ROWS,
                t->list->pair.a->name, t->list->pair.b->name);
    return DEM_OK;
}

/* ---- the test ---------------------------------------------------------------------------------- */

static int allocate(struct test *t)
{
    const size_t n = (size_t)t->numbers*ROWS;

    DEM_TRY(DEM_NEW(t->in, n));
    DEM_TRY(DEM_NEW(t->here, n));
    DEM_TRY(DEM_NEW(t->there, n));
    DEM_TRY(DEM_NEW(t->batch, 1));
    return DEM_NEW(t->history, DEM_HISTORY_COLUMNS);
}

static int test_class(struct dem_opencl *cl, const struct dem_interaction_table *table, int class)
{
    const double dt = table->step_limit > 0.0 && table->step_limit < 1.0 ? table->step_limit : 1e-6;
    struct test t = {.list = &table->list[class],
                     .times = {dt, dt, 1.0/dt, 100.0*dt, 99.0*dt}};
    struct dem_opencl_memory memory[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};

    for (int k = 0; k < t.list->entries; k++)
    {
        t.columns += dem_effect_history_columns(t.list->entry[k].effect);
    }
    t.numbers = ROW_COLUMNS + t.columns;
    int status = allocate(&t);

    if (!status)
    {
        fill(&t);
        compute_here(&t);
        status = run(cl, &t, class, memory);
    }
    status = status ? status : compare(cl, &t);
    for (int k = 0; k < 3; k++)
    {
        dem_opencl_release(cl, &memory[k]);
    }
    dem_memory_free(t.in);
    dem_memory_free(t.here);
    dem_memory_free(t.there);
    dem_memory_free(t.batch);
    dem_memory_free(t.history);
    return status;
}

int dem_device_self_test(struct dem_opencl *cl, const struct dem_interaction_table *table)
{
    for (int k = 0; k < table->classes; k++)
    {
        DEM_TRY(table->list[k].entries > 0 ? test_class(cl, table, k) : DEM_OK);
    }
    return DEM_OK;
}
