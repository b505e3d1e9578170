/*
 * test_effects.c -- every effect of the list is described, gives the same bits wherever a row lies
 * in a batch, zeros for padding, and writes the columns that it declares only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "bodies.h"
#include "scalar_columns.h"

#include "core/random.h"

#include <stdlib.h>

enum
{
    /* whole vectors of 2, 4, 8 and a remainder */
    ROWS = 37,
    MEMORY = 16
};

static const struct dem_material glass = {.name = "glass",
                                          .density = 2500.0,
                                          .youngs_modulus = 60e9,
                                          .poissons_ratio = 0.22,
                                          .thermal = {.conductivity = 1.0,
                                                      .heat_capacity = 800.0,
                                                      .emissivity = 0.9}};
static const struct dem_pair_class pair = {.a = &glass,
                                           .b = &glass,
                                           .reduced_modulus = 31e9,
                                           .reduced_shear = 7e9,
                                           .exponent = 1.5,
                                           .min_radius = 1e-3,
                                           .min_mass = 1e-5};

/* settings in the middle of their range, or their defaults; prepared */
static void settings_of(const struct dem_effect *e, void *settings)
{
    /* all different, as one may have to be above another */
    double unlike = 0.0;

    if (e->settings)
    {
        dem_settings_set_defaults(e->settings, settings);
        for (const struct dem_setting *f = e->settings; f->name; f++)
        {
            if (isnan(f->default_value))
            {
                const double value = (f->min > 0.5 ? 2.0*f->min : 0.5) + unlike,
                             values[3] = {value, 0.5, 0.5};

                dem_settings_set_number(e->settings, settings, e->name, f->name, values,
                                        f->kind == DEM_SETTING_VECTOR ? 3 : 1);
                unlike += 0.01;
            }
        }
    }
    if (e->prepare && e->prepare(settings, e->stage < DEM_STAGE_BODY ? &pair : NULL))
    {
        printf("Bail out! %s\n", dem_error_text());
        exit(1);
    }
}

static double uniform(int row, int use, double min, double max)
{
    return min + (max - min)*dem_random_unit(1, (uint64_t)row, 0, (uint64_t)use);
}

/* every third row is apart */
static void random_contact(struct dem_contact_batch *b, double memory[MEMORY][DEM_BATCH_ROWS],
                           int to, int row)
{
    const double a = uniform(row, 0, 0.0, 6.28), z = uniform(row, 1, -1.0, 1.0),
                 tilt = uniform(row, 2, -0.01, 0.01);
    const double apart = row % 3 == 2 ? 0.0 : 1.0;

    b->dt = b->max_dt = 1e-6;
    b->nx[to] = sqrt(1.0 - z*z)*cos(a), b->ny[to] = sqrt(1.0 - z*z)*sin(a), b->nz[to] = z;
    b->hx[to] = sqrt(1.0 - z*z)*cos(a + tilt), b->hy[to] = sqrt(1.0 - z*z)*sin(a + tilt),
    b->hz[to] = z;
    b->overlap[to] = apart*uniform(row, 3, 0.0, 1e-5);
    b->touching[to] = apart;
    b->reduced_radius[to] = uniform(row, 4, 1e-3, 2e-3);
    b->reduced_mass[to] = uniform(row, 5, 1e-5, 1e-4);
    b->vn[to] = uniform(row, 6, -1.0, 1.0);
    b->sx[to] = uniform(row, 7, -1.0, 1.0), b->sy[to] = uniform(row, 8, -1.0, 1.0),
    b->sz[to] = uniform(row, 9, -1.0, 1.0);
    b->wx[to] = uniform(row, 10, -9.0, 9.0), b->wy[to] = uniform(row, 11, -9.0, 9.0),
    b->wz[to] = uniform(row, 12, -9.0, 9.0);
    b->viscosity[to] = uniform(row, 13, 0.0, 0.01);
    b->min_radius[to] = uniform(row, 50, 1e-3, 2e-3);
    b->gap[to] = apart > 0.0 ? -b->overlap[to] : uniform(row, 51, 0.0, 1.0);
    b->distance[to] = 2.0*b->min_radius[to] + b->gap[to];
    b->distance_rate[to] = b->vn[to];
    b->normal_spin[to] = uniform(row, 52, -9.0, 9.0);
    b->is_primary[to] = uniform(row, 53, 0.0, 1.0) < 0.8 ? 1.0 : 0.0;
    b->pair_random[to] = uniform(row, 54, 0.0, 1.0);
    b->kn[to] = apart*uniform(row, 14, 0.0, 1e6);
    b->kt[to] = apart*uniform(row, 15, 0.0, 1e6);
    b->eta[to] = apart*uniform(row, 16, 0.0, 10.0);
    b->bond_replaces[to] = uniform(row, 55, 0.0, 1.0) < 0.2 ? 1.0 : 0.0;
    b->adhesive_force[to] = apart*uniform(row, 56, 0.0, 5.0);
    b->fn[to] = apart*uniform(row, 17, -1.0, 5.0);
    for (int m = 0; m < MEMORY; m++)
    {
        memory[m][to] = apart*uniform(row, 18 + m, -1e-6, 1e-6);
    }
}

static void random_body(struct dem_body_batch *b, int to, int row)
{
    body_fill(b, to, uniform(row, 0, 1e-4, 1e-2), uniform(row, 1, 1.0, 1000.0),
              uniform(row, 2, 1e-5, 1e-2), uniform(row, 3, 0.1, 1.1), uniform(row, 4, 0.0, 2000.0));
    b->vx[to] = uniform(row, 5, -1.0, 1.0), b->vy[to] = uniform(row, 6, -1.0, 1.0),
    b->vz[to] = uniform(row, 7, -1.0, 1.0);
    b->gx[to] = uniform(row, 8, -1e4, 1e4), b->gy[to] = uniform(row, 9, -1e4, 1e4),
    b->gz[to] = uniform(row, 10, -1e4, 1e4);
    b->ax[to] = uniform(row, 11, -20.0, 20.0), b->ay[to] = uniform(row, 12, -20.0, 20.0),
    b->az[to] = uniform(row, 13, -20.0, 20.0);
    b->ox[to] = uniform(row, 14, -99.0, 99.0), b->oy[to] = uniform(row, 15, -99.0, 99.0),
    b->oz[to] = uniform(row, 16, -99.0, 99.0);
    b->sx[to] = uniform(row, 17, -99.0, 99.0), b->sy[to] = uniform(row, 18, -99.0, 99.0),
    b->sz[to] = uniform(row, 19, -99.0, 99.0);
    b->wx[to] = uniform(row, 20, -99.0, 99.0), b->wy[to] = uniform(row, 21, -99.0, 99.0),
    b->wz[to] = uniform(row, 22, -99.0, 99.0);
    b->mean_diameter[to] = uniform(row, 23, 1e-4, 1e-2);
}

static int all_finite(const double *values)
{
    int all = 1;

    for (int c = 0; c < DEM_BATCH_ROWS; c++)
    {
        all &= isfinite(values[c]) ? 1 : 0;
    }
    return all;
}

/* how many of the columns from first to last (results and memory) hold a number that is not
   finite */
static int bad_columns(const double *first, const double *last)
{
    int bad = 0;

    for (const double *column = first; column <= last; column += DEM_BATCH_ROWS)
    {
        bad += !all_finite(column);
    }
    return bad;
}

static int differs(const double *first, const double *last, const double *other_first,
                   int row)
{
    int bad = 0;

    for (const double *a = first, *b = other_first; a <= last;
         a += DEM_BATCH_ROWS, b += DEM_BATCH_ROWS)
    {
        bad += memcmp(a + row, b, sizeof *a) != 0;        /* bits, so that -0 is not 0 */
    }
    return bad;
}

static void evaluate(const struct dem_effect *e, const double *settings, struct dem_contact_batch *b,
                double *const *memory)
{
    if (e->set_adhesion)
    {
        e->set_adhesion(settings, b, memory);
    }
    e->apply(settings, b, memory);
}

static void contact_effect(const struct dem_effect *e)
{
    static struct dem_contact_batch many, one;
    static _Alignas(64) double memory[MEMORY][DEM_BATCH_ROWS],
        memory_of_one[MEMORY][DEM_BATCH_ROWS], rate[3][DEM_EFFECT_SCALARS][DEM_BATCH_ROWS];
    double *all[MEMORY], *alone[MEMORY];
    double settings[32] = {0};
    int bad = 0;

    for (int m = 0; m < MEMORY; m++)
    {
        all[m] = memory[m];
        alone[m] = memory_of_one[m];
    }
    settings_of(e, settings);
    memset(&many, 0, sizeof many);
    memset(memory, 0, sizeof memory);
    many.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_contact(&many, memory, row, row);
    }
    scalar_columns_contacts(&many);
    for (int row = 0; row < ROWS; row++)
    {
        scalar_columns_row(e, row, row);
    }
    evaluate(e, settings, &many, all);
    memcpy(rate, scalar_columns.result, sizeof rate);
    for (int row = 0; row < ROWS; row++)
    {
        memset(&one, 0, sizeof one);
        one.n = 1;
        random_contact(&one, memory_of_one, 0, row);
        scalar_columns_contacts(&one);
        scalar_columns_row(e, 0, row);
        evaluate(e, settings, &one, alone);
        bad += differs(rate[0][0], rate[1][DEM_EFFECT_SCALARS - 1], scalar_columns.result[0][0],
                       row);
        bad += differs(many.kn, many.broke, one.kn, row) +
               differs(memory[0], memory[MEMORY - 1], memory_of_one[0], row);
    }
    TAP_OK(bad == 0, "%s: a row has the same bits alone and among others (%d differ)", e->name,
           bad);
    TAP_OK(bad_columns(many.kn, many.broke) + bad_columns(memory[0], memory[MEMORY - 1]) +
                   bad_columns(rate[0][0], rate[1][DEM_EFFECT_SCALARS - 1]) ==
               0,
           "%s: all finite", e->name);
    bad = 0;
    for (int row = 2; row < ROWS && e->stage < DEM_STAGE_BOND; row += 3)
    {
        bad += many.kn[row] != 0.0 || many.kt[row] != 0.0 || many.eta[row] != 0.0 ||
               many.fn[row] != 0.0;
        bad += many.fx[row] != 0.0 || many.fy[row] != 0.0 || many.fz[row] != 0.0;
    }
    TAP_OK(bad == 0, "%s: no force on rows apart", e->name);

    bad = 0;
    for (int row = 0; row < ROWS && e->clears_history;
         row++)    /* fn, kn, overlap, touching: 0 in every third row */
    {
        random_contact(&many, memory, row, row);
        for (int m = 0; m < MEMORY; m++)
        {
            memory[m][row] = uniform(row, 60 + m, -1e-6, 1e-6);
        }
    }
    scalar_columns_contacts(&many);
    if (e->clears_history)
    {
        evaluate(e, settings, &many, all);
    }
    for (int row = 2; row < ROWS && e->clears_history; row += 3)
    {
        for (int m = 0; e->history[m]; m++)
        {
            bad += memory[m][row] != 0.0 || signbit(memory[m][row]);
        }
    }
    TAP_OK(bad == 0, "%s: clears the history of rows apart if declared", e->name);

    memset(&many, 0, sizeof many);
    memset(memory, 0, sizeof memory);
    many.n = DEM_BATCH_ROWS;
    many.max_dt = 1e-6;
    scalar_columns_contacts(&many);
    evaluate(e, settings, &many, all);
    TAP_OK(bad_columns(many.kn, many.broke) == 0 && many.fn[DEM_BATCH_ROWS - 1] == 0.0 &&
               many.fx[0] == 0.0,
           "%s: rows of zeros", e->name);
}

static void body_effect(const struct dem_effect *e)
{
    static struct dem_body_batch many, one;
    static _Alignas(64) double rate[3][DEM_EFFECT_SCALARS][DEM_BATCH_ROWS];
    double settings[32] = {0};
    int bad = 0;

    settings_of(e, settings);
    memset(&many, 0, sizeof many);
    many.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_body(&many, row, row);
    }
    scalar_columns_bodies(&many);
    for (int row = 0; row < ROWS; row++)
    {
        scalar_columns_row(e, row, row);
    }
    dem_effect_apply_to_bodies(e, settings, &many);
    memcpy(rate, scalar_columns.result, sizeof rate);
    for (int row = 0; row < ROWS; row++)
    {
        memset(&one, 0, sizeof one);
        one.n = 1;
        random_body(&one, 0, row);
        scalar_columns_bodies(&one);
        scalar_columns_row(e, 0, row);
        dem_effect_apply_to_bodies(e, settings, &one);
        bad += differs(many.added_mass, many.spin_drag_wz, one.added_mass, row);
        bad += differs(rate[0][0], rate[2][DEM_EFFECT_SCALARS - 1], scalar_columns.result[0][0],
                       row);
    }
    TAP_OK(bad == 0, "%s: a row has the same bits alone and among others (%d differ)", e->name,
           bad);
    TAP_OK(bad_columns(many.added_mass, many.spin_drag_wz) +
                   bad_columns(rate[0][0], rate[2][DEM_EFFECT_SCALARS - 1]) == 0,
           "%s: all finite", e->name);
    bad = 0;
    for (int row = 0; row < ROWS; row++)
    {
        bad += many.drag[row] < 0.0 || many.spin_drag[row] < 0.0 || many.added_mass[row] < 0.0 ||
               rate[1][0][row] < 0.0;
    }
    TAP_OK(bad == 0, "%s: no coefficient of drag or rotational drag and no added mass is negative",
           e->name);

    memset(&many, 0, sizeof many);
    many.n = DEM_BATCH_ROWS;
    scalar_columns_bodies(&many);
    dem_effect_apply_to_bodies(e, settings, &many);
    TAP_OK(bad_columns(many.added_mass, many.spin_drag_wz) == 0 &&
           many.fx[DEM_BATCH_ROWS - 1] == 0.0 && many.drag[0] == 0.0,
           "%s: rows of zeros", e->name);
    TAP_OK(many.rx[0] == 0.0 && many.spin_drag[DEM_BATCH_ROWS - 1] == 0.0 &&
           many.added_mass[0] == 0.0,
           "%s: rows of zeros have no reaction, rotational drag or added mass", e->name);
}

/* an effect writes the columns that it declares, and no others */
static void declarations(const struct dem_effect *e)
{
    static struct dem_body_batch b;
    double settings[32] = {0};
    int has_reaction = 0, pushes = 0, turns = 0, added = 0;

    settings_of(e, settings);
    memset(&b, 0, sizeof b);
    b.n = ROWS;
    for (int row = 0; row < ROWS; row++)
    {
        random_body(&b, row, row);
    }
    scalar_columns_bodies(&b);
    dem_effect_apply_to_bodies(e, settings, &b);
    for (int row = 0; row < ROWS; row++)
    {
        has_reaction |= b.rx[row] != 0.0 || b.ry[row] != 0.0 || b.rz[row] != 0.0;
        pushes |= b.fx[row] != 0.0 || b.fy[row] != 0.0 || b.fz[row] != 0.0;
        turns |= b.spin_drag[row] != 0.0;
        added |= b.added_mass[row] != 0.0;
    }
    TAP_OK(has_reaction == e->has_reaction && added == e->has_added_mass &&
               turns == e->has_rotational_drag && (pushes == 0 || !has_reaction),
           "%s: reaction, added mass and rotational drag are those that it declares", e->name);
}

/* 1: the example has each required setting, and each word in it is a setting. */
static int example_is_complete(const struct dem_effect *e)
{
    char text[200], *rest;
    int required = 0, given = 0;

    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        required += isnan(f->default_value);
    }
    snprintf(text, sizeof text, "%s", e->example ? e->example : "");
    for (char *entry = strtok_r(text, ";", &rest); entry; entry = strtok_r(NULL, ";", &rest))
    {
        char name[64];

        if (sscanf(entry, " %63s", name) == 1)
        {
            const struct dem_setting *const f =
                e->settings ? dem_settings_find(e->settings, name) : NULL;

            if (!f)
            {
                return 0;
            }
            given += isnan(f->default_value);
        }
    }
    return given == required;
}

static void description(const struct dem_effect *e)
{
    const int body = e->stage >= DEM_STAGE_BODY;
    int fields = 0, bad = 0;

    for (const struct dem_setting *f = e->settings; f && f->name; f++)
    {
        fields++;
        bad += f->help == NULL || f->help[0] == '\0' || f->unit == NULL || f->offset >= e->size;
    }
    TAP_OK(e->summary && e->source && e->name[0] && e->summary[0] && e->source[0],
           "%s: word, sentence, source", e->name);
    TAP_OK(bad == 0 && (fields > 0) == (e->size > 0), "%s: %d settings, each with unit and help",
           e->name, fields);
    TAP_OK(body ? e->apply_to_bodies && !e->apply && !e->history : e->apply && !e->apply_to_bodies,
           "%s: has the function of its stage", e->name);
    TAP_OK(!(e->reach || e->replace_contact) || e->stage == DEM_STAGE_BOND ||
               e->stage == DEM_STAGE_FILM || (e->stage == DEM_STAGE_SCALAR && !e->replace_contact),
           "%s: only bonds, films and exchanges of scalars act beyond contact", e->name);
    TAP_OK(!e->set_adhesion || e->stage == DEM_STAGE_FILM,
           "%s: only films give a friction force before contact", e->name);
    TAP_OK(!e->prepare_bodies || e->drag || e->has_added_mass,
           "%s: only drag and added mass prepare a window", e->name);
    TAP_OK(!(e->drag || e->has_reaction || e->has_added_mass || e->has_rotational_drag) ||
               e->stage == DEM_STAGE_FLUID,
           "%s: only in a fluid", e->name);
    TAP_OK(!e->transfers || (e->stage == DEM_STAGE_FLUID && e->transfers->exchange),
           "%s: only in a fluid a scalar is transferred, which has an exchange", e->name);
    TAP_OK(!e->clears_history || (e->history && e->stage < DEM_STAGE_BOND),
           "%s: only contact laws clear history", e->name);
    TAP_OK((e->exponent > 0.0) == (e->stage == DEM_STAGE_NORMAL),
           "%s: only a normal law has an exponent", e->name);
    TAP_OK(!e->uniform_acceleration || e->stage == DEM_STAGE_BODY,
           "%s: only a body force is declared as gravity", e->name);
    TAP_OK(!e->has_pressure_gradient || e->stage == DEM_STAGE_FLUID,
           "%s: only a fluid force has the pressure gradient", e->name);
    TAP_OK((e->listed_column != NULL) == (e->makes_listed != NULL),
           "%s: a list of pairs has its column", e->name);
    TAP_OK(example_is_complete(e),
           "%s: the example gives each required setting, and settings only: %s", e->name,
           e->example ? e->example : "none");
    TAP_OK(dem_effects_find(e->name) == e, "%s: found by its name", e->name);
}

int main(void)
{
    int count = 0;

    TAP_TRAPS;
    for (const struct dem_effect *const *e = dem_effects; *e; e++)
    {
        count++;
        description(*e);
        if ((*e)->stage < DEM_STAGE_BODY)
        {
            contact_effect(*e);
        }
        else
        {
            body_effect(*e);
            declarations(*e);
        }
    }
    TAP_OK(count > 0, "%d effects", count);
    TAP_OK(dem_effects_find("hertzz") == NULL && dem_effects_find("") == NULL,
           "an unknown name is not found");
    TAP_OK(dem_effects_unknown("scene.dem, line 3", "hertzz") == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    TAP_OK(strncmp(dem_error_text(), "scene.dem, line 3: ", 19) == 0,
           "the message begins with file and line");
    TAP_OK(strstr(dem_error_text(), "did you mean hertz") != NULL, "the message suggests the nearest name");
    TAP_OK(strstr(dem_error_text(), "gidaspow") != NULL, "the message lists the names");
    TAP_DONE;
}
