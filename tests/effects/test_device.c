/*
 * test_device.c -- OpenCL C computes each law with the bits of the loops of this library.
 *
 * 20 000 random rows for each row function, with random settings for every 64 of them. A fifth of
 * the rows has numbers that are zero, tiny or huge. A result that is not a number has no certain
 * bits; it must be none on both sides.
 *
 * Skipped without OpenCL. Debian: opencl-c-headers, ocl-icd-libopencl1, pocl-opencl-icd (on CPUs).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "unit/tap.h"

#include "core/file.h"
#include "core/memory.h"
#include "device/opencl_device.h"
#include "device/program_texts.h"
#include "laws/batch_row.h"
#include "laws/effects.h"
#include "random_rows.h"

enum
{
    BATCHES = 313,
    ROWS = BATCHES*DEM_BATCH_ROWS,
    TIMES = 5,
    SETTINGS_SIZE = 512
};

#define COUNT(column) +1
enum
{
    CONTACT_COLUMNS = 0 DEM_ROW_COLUMNS(COUNT),
    CONTACT_NUMBERS = CONTACT_COLUMNS + DEM_LAW_HISTORY + 6,
    BODY_COLUMNS = 0 DEM_BODY_COLUMNS(COUNT),
    BODY_NUMBERS = BODY_COLUMNS + DEM_VOIDAGE_FACTORS + DEM_EFFECT_SCALARS + 3,
    MOST_NUMBERS = CONTACT_NUMBERS > BODY_NUMBERS ? CONTACT_NUMBERS : BODY_NUMBERS
};

#define LAW_ROW(name) {#name, &dem_##name},
static const struct
{
    const char *name;
    const struct dem_effect *effect;
} laws[] = {DEM_EFFECT_ROWS(LAW_ROW)};
enum
{
    LAWS = sizeof laws/sizeof *laws
};

static double in[ROWS*MOST_NUMBERS], host[ROWS*MOST_NUMBERS], device[ROWS*MOST_NUMBERS];
static double times[BATCHES*TIMES];

/* ---- rows ------------------------------------------------------------------------------------ */

#define PUT(column) *to++ = r.column;
static void fill_contacts(void)
{
    double *to = in;

    for (int row = 0; row < ROWS; row++)
    {
        double h[DEM_LAW_HISTORY];
        const struct dem_contact_row r = random_contact(h);

        DEM_ROW_COLUMNS(PUT)
        memcpy(to, h, sizeof h);
        memcpy(to + DEM_LAW_HISTORY, &r.scalars[0], sizeof r.scalars[0]);
        to += DEM_LAW_HISTORY + 6;
        if (row % 5 == 0)
        {
            extreme(to - CONTACT_NUMBERS + (int)uniform(0.0, CONTACT_NUMBERS));
            extreme(to - CONTACT_NUMBERS + (int)uniform(0.0, CONTACT_NUMBERS));
        }
    }
    for (int b = 0; b < BATCHES; b++)
    {
        double *const t = times + b*TIMES;

        t[0] = b % 16 == 0 ? 0.0 : positive(1e-9, 1e-3);
        t[1] = t[0] > 0.0 ? t[0]*positive(1.0, 2.0) : positive(1e-9, 1e-3);
        t[2] = t[0] > 0.0 ? 1.0/t[0] : 1e15;
        t[3] = b % 4 == 0 ? 0.0 : positive(1e-3, 1e3);
        t[4] = b % 4 == 0 ? -INFINITY : t[3] - t[0];
    }
}

static void fill_bodies(void)
{
    double *to = in;

    for (int row = 0; row < ROWS; row++)
    {
        const struct dem_body_row r = random_body();

        DEM_BODY_COLUMNS(PUT)
        memcpy(to, r.voidage_factor, sizeof r.voidage_factor);
        to += DEM_VOIDAGE_FACTORS;
        for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
        {
            *to++ = r.scalars[k].value;
        }
        memcpy(to, &r.scalars[0].rate, 3*sizeof *to);
        to += 3;
        if (row % 5 == 0)
        {
            extreme(to - BODY_NUMBERS + (int)uniform(0.0, BODY_NUMBERS));
            extreme(to - BODY_NUMBERS + (int)uniform(0.0, BODY_NUMBERS));
        }
    }
}

/* ---- both sides ------------------------------------------------------------------------------ */

typedef void contact_loop(const void *, struct dem_contact_batch *restrict, double *const *);
typedef void body_loop(const void *, struct dem_body_batch *restrict);

/* Rows of `in` through the loop of a contact law, to `host`. */
static void contacts_on_host(contact_loop *loop, const char *settings, size_t size)
{
    static struct dem_contact_batch batch;
    static double column[DEM_LAW_HISTORY][DEM_BATCH_ROWS], scalar[6][DEM_BATCH_ROWS];
    struct dem_contact_batch *const b = &batch;
    struct dem_scalar_rows scalars[DEM_EFFECT_SCALARS];
    double *history[DEM_LAW_HISTORY];

    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        scalars[k] = (struct dem_scalar_rows){scalar[0], scalar[1], scalar[2], scalar[3], scalar[4],
                                              scalar[5]};
    }
    for (int k = 0; k < DEM_LAW_HISTORY; k++)
    {
        history[k] = column[k];
    }
    b->n = DEM_BATCH_ROWS;
    b->scalars = scalars;
    for (int at = 0; at < BATCHES; at++)
    {
        const double *const t = times + at*TIMES, *from = in + at*DEM_BATCH_ROWS*CONTACT_NUMBERS;
        double *to = host + at*DEM_BATCH_ROWS*CONTACT_NUMBERS;

        b->dt = t[0], b->max_dt = t[1], b->time = t[3], b->previous_time = t[4];
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
#define TO_BATCH(name) b->name[c] = *from++;
            DEM_ROW_COLUMNS(TO_BATCH)
            for (int k = 0; k < DEM_LAW_HISTORY; k++)
            {
                column[k][c] = *from++;
            }
            for (int k = 0; k < 6; k++)
            {
                scalar[k][c] = *from++;
            }
        }
        loop(settings + (size_t)at*size, b, history);
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
#define FROM_BATCH(name) *to++ = b->name[c];
            DEM_ROW_COLUMNS(FROM_BATCH)
            for (int k = 0; k < DEM_LAW_HISTORY; k++)
            {
                *to++ = column[k][c];
            }
            for (int k = 0; k < 6; k++)
            {
                *to++ = scalar[k][c];
            }
        }
    }
}

static void bodies_on_host(body_loop *loop, const char *settings, size_t size)
{
    static struct dem_body_batch batch;
    static double value[DEM_EFFECT_SCALARS][DEM_BATCH_ROWS], exchange[3][DEM_BATCH_ROWS];
    struct dem_body_batch *const b = &batch;
    struct dem_scalar_bodies scalars[DEM_EFFECT_SCALARS];

    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        scalars[k] = (struct dem_scalar_bodies){value[k], exchange[0], exchange[1], exchange[2]};
    }
    b->n = DEM_BATCH_ROWS;
    b->scalars = scalars;
    for (int at = 0; at < BATCHES; at++)
    {
        const double *from = in + at*DEM_BATCH_ROWS*BODY_NUMBERS;
        double *to = host + at*DEM_BATCH_ROWS*BODY_NUMBERS;

        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            DEM_BODY_COLUMNS(TO_BATCH)
            for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++)
            {
                b->voidage_factor[k][c] = *from++;
            }
            for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
            {
                value[k][c] = *from++;
            }
            for (int k = 0; k < 3; k++)
            {
                exchange[k][c] = *from++;
            }
        }
        loop(settings + (size_t)at*size, b);
        for (int c = 0; c < DEM_BATCH_ROWS; c++)
        {
            DEM_BODY_COLUMNS(FROM_BATCH)
            for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++)
            {
                *to++ = b->voidage_factor[k][c];
            }
            for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
            {
                *to++ = value[k][c];
            }
            for (int k = 0; k < 3; k++)
            {
                *to++ = exchange[k][c];
            }
        }
    }
}

/* ---- the device ------------------------------------------------------------------------------ */

static struct dem_opencl *cl;

/* Opens the first device with doubles. */
static int open_device(void)
{
    struct dem_opencl_info list[DEM_OPENCL_DEVICES];
    int n, fitting, k = 0;

    DEM_TRY(dem_opencl_list(list, &n));
    while (k < n - 1 && !list[k].doubles)
    {
        k++;
    }
    return dem_opencl_open(&cl, list[k].name, 0, &fitting);
}

/* Rows of `in` through a kernel, to `device`. */
static int rows_on_device(const char *name, const char *settings, size_t bytes, size_t numbers)
{
    static struct dem_opencl_memory m[4];
    struct dem_opencl_kernel *kernel;
    const size_t all = ROWS*numbers*sizeof *in;

    DEM_TRY(dem_opencl_kernel(cl, name, &kernel));
    DEM_TRY(dem_opencl_put(cl, &m[0], all, in));
    DEM_TRY(dem_opencl_put(cl, &m[1], bytes, settings));
    DEM_TRY(dem_opencl_put(cl, &m[2], sizeof times, times));
    DEM_TRY(dem_opencl_reserve(cl, &m[3], all));
    DEM_TRY(DEM_OPENCL_GIVE(cl, kernel, 0, &m[0], &m[1], &m[2], &m[3]));
    DEM_TRY(dem_opencl_launch(cl, kernel, ROWS));
    return dem_opencl_read(cl, &m[3], 0, all, device);
}

/* Claims about a row function, of a loop over contacts or over bodies. */
static void compare(const char *law, const char *function, const struct dem_effect *e,
                    contact_loop *contacts, body_loop *bodies)
{
    static char settings[BATCHES*SETTINGS_SIZE];
    const size_t size = e->size ? e->size : sizeof(double),
                 numbers = contacts ? CONTACT_NUMBERS : BODY_NUMBERS;
    char kernel[100];
    int differ = 0, finite = 0, act = 0;

    memset(settings, 0, sizeof settings);
    for (size_t b = 0; e->size && b < BATCHES; b++)
    {
        random_settings(e, settings + b*size);
    }
    if (contacts)
    {
        contacts_on_host(contacts, settings, size);
    }
    else
    {
        bodies_on_host(bodies, settings, size);
    }
    snprintf(kernel, sizeof kernel, "dem_%s_%s_kernel", law, function);
    const int status = rows_on_device(kernel, settings, BATCHES*size, numbers);

    for (size_t row = 0; row < ROWS; row++)
    {
        const double *const a = host + row*numbers, *const b = device + row*numbers;
        int same = 1, is_finite = 1;

        for (size_t k = 0; k < numbers; k++)
        {
            same &= dem_math_bits(a[k]) == dem_math_bits(b[k]) || (isnan(a[k]) && isnan(b[k]));
            is_finite &= isfinite(a[k]) != 0;
        }
        differ += !same;
        finite += is_finite;
        act += memcmp(a, in + row*numbers, numbers*sizeof *a) != 0;
    }
    TAP_OK(status == DEM_OK && differ == 0, "%s, dem_%s_%s: %d of %d rows differ%s", e->name, law,
           function, differ, ROWS, status ? dem_error_text() : "");
    /* most extreme numbers are finite in most laws, too */
    TAP_OK(finite > 3*ROWS/4 && act > ROWS/8, "%s: %d rows are finite, the law acts in %d",
           e->name, finite, act);
}

/* ---- the program ----------------------------------------------------------------------------- */

/* The header of a law with its row function, or NULL. */
static const struct dem_device_text *header_of(int k)
{
    char name[100];

    snprintf(name, sizeof name, "/%s.h", laws[k].name);
    return dem_program_find_text(name, strlen(name));
}

/* Writes the kernels of a law. */
static void write_law(struct dem_text *text, int k)
{
    const struct dem_effect *const e = laws[k].effect;
    const char *const name = laws[k].name;
    char settings[100] = "struct none";

    if (e->size)
    {
        snprintf(settings, sizeof settings, "struct dem_%s", name);
        /* the same layout as here, or the program does not compile */
        dem_text_add(text, "typedef char %s_size[sizeof(%s) == %zu ? 1 : -1];\n", name, settings, e->size);
    }
    dem_text_add(text, "%s_LAW(dem_%s, row, %s)\n", e->apply ? "CONTACT" : "BODY", name, settings);
    if (e->set_adhesion)
    {
        dem_text_add(text, "CONTACT_LAW(dem_%s, adhesion_row, %s)\n", name, settings);
    }
    if (e->replace_contact)
    {
        dem_text_add(text, "CONTACT_LAW(dem_%s, replace_row, %s)\n", name, settings);
    }
    if (e->prepare_bodies)
    {
        dem_text_add(text, "BODY_LAW(dem_%s, prepare_row, %s)\n", name, settings);
    }
}

static void compare_law(int k)
{
    const struct dem_effect *const e = laws[k].effect;
    const char *const name = laws[k].name;

    compare(name, "row", e, e->apply, e->apply_to_bodies);
    if (e->set_adhesion)
    {
        compare(name, "adhesion_row", e, e->set_adhesion, NULL);
    }
    if (e->replace_contact)
    {
        compare(name, "replace_row", e, e->replace_contact, NULL);
    }
    if (e->prepare_bodies)
    {
        compare(name, "prepare_row", e, NULL, e->prepare_bodies);
    }
}

static int build(void)
{
    struct dem_text text = {.text = NULL};
    struct dem_program_texts texts = {.out = &text};
    struct dem_device_text rows = {.name = "rows.cl"};
    char *file = NULL;
    uint64_t key;

    DEM_TRY(dem_file_load_text("effects/rows.cl", &file));
    rows.text = file;
    dem_text_add(&text, "#define BATCH %d\n#define CONTACT_NUMBERS %d\n#define BODY_NUMBERS %d\n",
                 DEM_BATCH_ROWS, CONTACT_NUMBERS, BODY_NUMBERS);
    int status = dem_program_include(&texts, &rows);

    for (int k = 0; k < LAWS && !status; k++)
    {
        /* a law of eddies has none: they are part of the fluid's velocity */
        if (!header_of(k) && !laws[k].effect->eddies)
        {
            TAP_OK(0, "%s has no header in dem/laws with its row function", laws[k].effect->name);
        }
        else if (header_of(k))
        {
            status = dem_program_include(&texts, header_of(k));
            write_law(&text, k);
        }
    }
    status = status ? status : dem_opencl_build(cl, text.text, &key);
    dem_memory_free(file);
    dem_text_free(&text);
    return status;
}

int main(void)
{
    if (open_device())
    {
        printf("ok 1 - rows on a device # SKIP %s\n1..1\n", dem_error_text());
        return 0;
    }
    const int built = build() == DEM_OK;

    if (!TAP_OK(built, "the row functions are OpenCL C, for %s%s", dem_opencl_device(cl)->name,
                built ? "" : dem_error_text()))
    {
        return tap_done();
    }
    for (int bodies = 0; bodies < 2; bodies++)
    {
        bodies ? fill_bodies() : fill_contacts();
        for (int k = 0; k < LAWS; k++)
        {
            if (header_of(k) && (bodies ? laws[k].effect->apply_to_bodies != NULL : laws[k].effect->apply != NULL))
            {
                compare_law(k);
            }
        }
    }
    dem_opencl_close(cl);
    return tap_done();
}
