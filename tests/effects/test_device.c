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

#include "core/random.h"
#include "laws/batch_row.h"
#include "laws/effects.h"
#include "opencl.h"

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

/* ---- random numbers ---------------------------------------------------------------------------- */

static uint64_t draws;

static double uniform(double min, double max)
{
    return min + (max - min)*dem_random_unit(1, draws++, 0, 0);
}

static double positive(double min, double max)
{
    return dem_exp(uniform(dem_log(min), dem_log(max)));
}

static double signed_number(double min, double max)
{
    return (uniform(0.0, 1.0) < 0.5 ? -1.0 : 1.0)*positive(min, max);
}

static int one_in(int n)
{
    return uniform(0.0, 1.0)*n < 1.0;
}

static void unit_vector(double *x, double *y, double *z)
{
    const double a = uniform(0.0, 6.283), c = uniform(-1.0, 1.0), s = sqrt(1.0 - c*c);

    *x = s*cos(a), *y = s*sin(a), *z = c;
}

/* a number of a fifth of the rows */
static void extreme(double *number)
{
    const double sign = signbit(*number) ? -1.0 : 1.0;

    *number = one_in(3) ? 0.0 : sign*(one_in(2) ? positive(1e-308, 1e-100) : positive(1e100, 1e300));
}

/* ---- rows -------------------------------------------------------------------------------------- */

/* The numbers of a contact that belong together; all others are of any sign. */
static struct dem_contact_row random_contact(double h[DEM_LAW_HISTORY])
{
    struct dem_contact_row r;
    const double radius = positive(1e-6, 0.1), other = one_in(4) ? radius : positive(radius, 3.0*radius);
    const double gap = one_in(2) ? -radius*positive(1e-9, 0.1) : radius*positive(1e-9, 0.3);

#define ANY(column) r.column = one_in(8) ? 0.0 : signed_number(1e-6, 10.0);
    DEM_ROW_COLUMNS(ANY)
    unit_vector(&r.nx, &r.ny, &r.nz);
    if (one_in(4))
    {
        r.hx = r.nx, r.hy = r.ny, r.hz = r.nz;
    }
    else
    {
        unit_vector(&r.hx, &r.hy, &r.hz);
    }
    r.gap = gap;
    r.distance = radius + other + gap;
    r.overlap = gap < 0.0 ? -gap : 0.0;
    r.touching = gap < 0.0 ? 1.0 : 0.0;
    r.reduced_radius = radius*other/(radius + other);
    r.min_radius = radius;
    r.reduced_mass = positive(1e3, 1e4)*radius*radius*radius;
    r.viscosity = one_in(8) ? 0.0 : positive(1e-6, 10.0);
    r.is_primary = one_in(8) ? 0.0 : 1.0;
    r.pair_random = uniform(0.0, 1.0);
    r.bond_replaces = one_in(4) ? (one_in(2) ? 1.0 : 2.0) : 0.0;
    r.scratch = one_in(2) ? uniform(0.7, 2.0) : 0.0;
    r.kn = r.touching*positive(1.0, 1e8);
    r.kt = r.touching*positive(1.0, 1e8);
    r.eta = r.touching*positive(1e-9, 1e3);
    r.bonds = r.broke = r.cause = 0.0;    /* the caller clears them */
    for (int k = 0; k < DEM_LAW_HISTORY; k++)
    {
        /* many laws remember 0 or 1, a bond -3 to -1 of its length or a length */
        h[k] = one_in(3) ? floor(uniform(-3.0, 2.0)) : one_in(2) ? r.distance
                                                                         : signed_number(1e-9, 1e-2);
    }
    r.scalars[0] = (struct dem_contact_scalar){
        .i = one_in(2) ? positive(1.0, 2e3) : radius*radius*radius*positive(1e-6, 0.1),
        .j = one_in(2) ? positive(1.0, 2e3) : radius*radius*radius*positive(1e-6, 0.1),
        .rate_i = signed_number(1e-9, 1.0), .rate_j = signed_number(1e-9, 1.0),
        .radius_i = radius, .radius_j = other};
    return r;
}

static struct dem_body_row random_body(void)
{
    struct dem_body_row r;

#define ANY_OF_BODY(column) r.column = one_in(8) ? 0.0 : signed_number(1e-6, 10.0);
    DEM_BODY_COLUMNS(ANY_OF_BODY)
    r.radius = positive(1e-6, 0.1);
    r.volume = 4.0/3.0*3.14159265358979324*r.radius*r.radius*r.radius;
    r.density = one_in(8) ? 0.0 : positive(0.1, 1e4);
    r.mass = r.volume*positive(10.0, 2e4);
    r.void_fraction = one_in(8) ? uniform(-0.1, 1.2) : uniform(0.2, 1.0);
    r.viscosity = one_in(16) ? 0.0 : positive(1e-6, 10.0);
    r.mean_diameter = one_in(8) ? 0.0 : r.radius*positive(0.5, 8.0);
    r.added_mass = r.mass*positive(1e-3, 1.0);
    if (one_in(8))    /* no slip */
    {
        r.ux = r.vx, r.uy = r.vy, r.uz = r.vz;
    }
    r.voidage_factor[0] = positive(1e-2, 1e3);
    r.voidage_factor[1] = uniform(0.0, 1.0);
    for (int k = 0; k < DEM_EFFECT_SCALARS; k++)
    {
        r.scalars[k].value = positive(1e-2, 5e3);
    }
    r.scalars[0].rate = signed_number(1e-9, 1.0);
    r.scalars[0].coefficient = positive(1e-9, 1.0);
    r.scalars[0].to_target = signed_number(1e-9, 1.0);
    return r;
}

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

/* ---- settings ---------------------------------------------------------------------------------- */

static struct dem_material random_material(const char *name)
{
    struct dem_material m = {.density = positive(100.0, 1e4),
                             .youngs_modulus = positive(1e5, 1e11),
                             .poissons_ratio = uniform(0.0, 0.49),
                             .thermal = {.conductivity = positive(0.01, 400.0),
                                         .heat_capacity = positive(100.0, 5e3),
                                         .emissivity = uniform(0.01, 1.0)}};

    snprintf(m.name, sizeof m.name, "%s", name);
    m.thermal.real_modulus = one_in(2) ? 0.0 : m.youngs_modulus*positive(1.0, 1e3);
    return m;
}

static double random_setting(const struct dem_setting *s)
{
    const double min = s->min > 1e-12 ? s->min : 1e-12, max = s->max < 1e12 ? s->max : 1e12;

    if (!isnan(s->default_value) && one_in(3))
    {
        return s->default_value;
    }
    if (s->min <= 0.0 && one_in(8))
    {
        return 0.0;
    }
    const double value = max <= 1.0 || max/min > 1e20 ? positive(min > 1e-6 ? min : 1e-6, max < 1e6 ? max : 1e6)
                                                      : positive(min, max);

    return s->flags & DEM_SETTING_WHOLE ? floor(value) : value;
}

/* Settings that the law accepts, prepared for a random pair of materials. */
static void random_settings(const struct dem_effect *e, char *settings)
{
    for (int attempt = 0; attempt < 1000; attempt++)
    {
        const struct dem_material a = random_material("a"), b = random_material("b");
        const double a_compliance = (1.0 - a.poissons_ratio*a.poissons_ratio)/a.youngs_modulus,
                     b_compliance = (1.0 - b.poissons_ratio*b.poissons_ratio)/b.youngs_modulus;
        const struct dem_pair_class pair = {
            .a = &a, .b = &b, .with_wall = one_in(3),
            .reduced_modulus = 1.0/(a_compliance + b_compliance),
            .reduced_shear = positive(1e5, 1e10), .exponent = one_in(3) ? 1.0 : 1.5,
            .min_radius = 1e-3, .min_mass = 1e-5, .max_radius_sum = 4e-3,
            .fluid_density = one_in(2) ? 0.0 : 1000.0};

        for (const struct dem_setting *s = e->settings; s && s->name; s++)
        {
            double numbers[3] = {random_setting(s), random_setting(s), random_setting(s)};
            int choice = 0, choices = s->kind == DEM_SETTING_SWITCH ? 2 : 0;

            while (s->kind == DEM_SETTING_CHOICE && s->choices[choices])
            {
                choices++;
            }
            choice = (int)uniform(0.0, choices);
            memcpy(settings + s->offset, choices ? (void *)&choice : (void *)numbers,
                   choices                            ? sizeof choice
                   : s->kind == DEM_SETTING_VECTOR ? sizeof numbers
                                                      : sizeof *numbers);
        }
        if (!e->prepare || e->prepare(settings, e->stage < DEM_STAGE_BODY ? &pair : NULL) == DEM_OK)
        {
            return;
        }
    }
    printf("Bail out! %s accepts no random settings: %s\n", e->name, dem_error_text());
    exit(1);
}

/* ---- both sides -------------------------------------------------------------------------------- */

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
    TAP_OK(runs && differ == 0, "%s, dem_%s_%s: %d of %d rows differ", e->name, law, function, differ, ROWS);
    /* most extreme numbers are finite in most laws, too */
    TAP_OK(finite > 3*ROWS/4 && act > ROWS/8, "%s: %d rows are finite, the law acts in %d", e->name,
           finite, act);
}

/* ---- the program ------------------------------------------------------------------------------- */

static char text[200000];

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
    int has_row[LAWS];

    if (why)
    {
        printf("1..0 # SKIP %s\n", why);
        return 0;
    }
    add_line("#include \"rows.cl\"\n");
    for (int k = 0; k < LAWS; k++)
    {
        has_row[k] = include_law(laws[k].name);
        /* eddies are part of the fluid's velocity */
        TAP_OK(has_row[k] || laws[k].effect->eddies, "%s has a row function", laws[k].effect->name);
    }
    for (int k = 0; k < LAWS; k++)
    {
        if (has_row[k])
        {
            write_law(k);
        }
    }
    snprintf(text + sizeof text - 1000, 1000,
             "-I../dem -Ieffects -DBATCH=%d -DCONTACT_NUMBERS=%d -DBODY_NUMBERS=%d", DEM_BATCH_ROWS,
             CONTACT_NUMBERS, BODY_NUMBERS);
    if (!TAP_OK(opencl_build(text, text + sizeof text - 1000), "the row functions are OpenCL C, for %s",
                opencl.name))
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
    printf("1..0 # SKIP no CL/cl.h (Debian: opencl-c-headers)\n");
    return 0;
}

#endif
