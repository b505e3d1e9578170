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

#if defined(__has_include) && __has_include(<CL/cl.h>)

#include "laws/batch_row.h"
#include "laws/effects.h"
#include "opencl.h"
#include "random_rows.h"

#include <unistd.h>

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
    const int runs = opencl_run(kernel, ROWS, 4, (void *[]){in, settings, times, device},
                                (size_t[]){ROWS*numbers*sizeof *in, BATCHES*size, sizeof times,
                                           ROWS*numbers*sizeof *device});

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
    TAP_OK(runs && differ == 0, "%s, dem_%s_%s: %d of %d rows differ", e->name, law, function,
           differ, ROWS);
    /* most extreme numbers are finite in most laws, too */
    TAP_OK(finite > 3*ROWS/4 && act > ROWS/8, "%s: %d rows are finite, the law acts in %d",
           e->name, finite, act);
}

/* ---- the program ----------------------------------------------------------------------------- */

static char text[20000];

static void add_line(const char *format, ...)
{
    const size_t at = strlen(text);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(text + at, sizeof text - at, format, arguments);
    va_end(arguments);
}

/* Finds the header of a law in a folder of dem/laws and includes it; 0 if there is none. */
static int include_law(const char *name)
{
    static const char *const folders[] = {"contact", "bond", "body", "fluid", "heat"};

    for (size_t k = 0; k < sizeof folders/sizeof *folders; k++)
    {
        char path[200];

        snprintf(path, sizeof path, "../dem/laws/%s/%s.h", folders[k], name);
        if (access(path, R_OK) == 0)
        {
            add_line("#include \"laws/%s/%s.h\"\n", folders[k], name);
            return 1;
        }
    }
    return 0;
}

static void write_law(int k)
{
    const struct dem_effect *const e = laws[k].effect;
    const char *const name = laws[k].name;
    char settings[100] = "struct none";

    if (e->size)
    {
        snprintf(settings, sizeof settings, "struct dem_%s", name);
        /* the same layout as here, or the program does not compile */
        add_line("typedef char %s_size[sizeof(%s) == %zu ? 1 : -1];\n", name, settings, e->size);
    }
    add_line("%s_LAW(dem_%s, row, %s)\n", e->apply ? "CONTACT" : "BODY", name, settings);
    if (e->set_adhesion)
    {
        add_line("CONTACT_LAW(dem_%s, adhesion_row, %s)\n", name, settings);
    }
    if (e->replace_contact)
    {
        add_line("CONTACT_LAW(dem_%s, replace_row, %s)\n", name, settings);
    }
    if (e->prepare_bodies)
    {
        add_line("BODY_LAW(dem_%s, prepare_row, %s)\n", name, settings);
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

int main(void)
{
    const char *const why = opencl_open();
    char options[200];
    int has_row[LAWS];

    if (why)
    {
        printf("ok 1 - rows on a device # SKIP %s\n1..1\n", why);
        return 0;
    }
    add_line("#include \"rows.cl\"\n");
    for (int k = 0; k < LAWS; k++)
    {
        has_row[k] = include_law(laws[k].name);
        /* a law of eddies has none: they are part of the fluid's velocity */
        if (!has_row[k] && !laws[k].effect->eddies)
        {
            TAP_OK(0, "%s has no header in dem/laws with its row function", laws[k].effect->name);
        }
    }
    for (int k = 0; k < LAWS; k++)
    {
        if (has_row[k])
        {
            write_law(k);
        }
    }
    snprintf(options, sizeof options,
             "-I../dem -Ieffects -DBATCH=%d -DCONTACT_NUMBERS=%d -DBODY_NUMBERS=%d", DEM_BATCH_ROWS,
             CONTACT_NUMBERS, BODY_NUMBERS);
    if (!TAP_OK(opencl_build(text, options), "the row functions are OpenCL C, for %s", opencl.name))
    {
        return tap_done();
    }
    fill_contacts();
    for (int k = 0; k < LAWS; k++)
    {
        if (has_row[k] && laws[k].effect->apply)
        {
            compare_law(k);
        }
    }
    fill_bodies();
    for (int k = 0; k < LAWS; k++)
    {
        if (has_row[k] && laws[k].effect->apply_to_bodies)
        {
            compare_law(k);
        }
    }
    return tap_done();
}

#else

int main(void)
{
    printf("ok 1 - rows on a device # SKIP no CL/cl.h (Debian: opencl-c-headers)\n1..1\n");
    return 0;
}

#endif
