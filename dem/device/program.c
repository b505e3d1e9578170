/*
 * program.c -- compose the program of a device.
 *
 * Settings are constants of the program, as the bits of the prepared struct; a comment has the numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/program.h"
#include "core/error.h"
#include "device/device_columns.h"
#include "device/program_balance.h"
#include "device/program_scalars.h"
#include "device/program_texts.h"
#include "device/shared.h"
#include "laws/effects.h"
#include "laws/fluid/eddy.h"
#include "walls/spring_kinds.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct composer
{
    struct dem_text *out;
    struct dem_program_texts texts;
    const struct dem_walls *walls;
    int viscosity;                /* 1: particles have the viscosity of the fluid around them */
    int scalars;                  /* particle scalars in lists of laws */
    struct dem_program_balance balance;
};

/* ---- laws ------------------------------------------------------------------------------------ */

#define LAW_NAME(name) {&dem_##name, #name},
static const struct
{
    const struct dem_effect *effect;
    const char *name;
} laws[] = {DEM_EFFECT_ROWS(LAW_NAME)};

/* The name of a law in C. */
static const char *law_name(const struct dem_effect *e)
{
    for (size_t k = 0; k < sizeof laws/sizeof *laws; k++)
    {
        if (laws[k].effect == e)
        {
            return laws[k].name;
        }
    }
    return "";
}

static const struct dem_device_text *law_text(const struct dem_effect *e)
{
    char file[100];

    snprintf(file, sizeof file, "/%s.h", law_name(e));
    return dem_program_find_text(file, strlen(file));
}

const char *dem_device_effect_refusal(const struct dem_effect *e)
{
    return law_text(e) || e->eddies ? NULL : "has no text for devices";
}

/* The settings of an effect: settings_<class>_<k>, a constant of the program. */
static void add_settings(struct composer *c, const char *class, int k,
                         const struct dem_effect_entry *e)
{
    const size_t words = (e->effect->size + 7)/8;

    if (e->effect->size == 0)
    {
        return;
    }
    dem_text_add(c->out, "constant ulong bits_%s_%d[%zu] =    /* %s */\n{\n", class, k, words,
                 e->effect->name);
    for (size_t w = 0; w < words; w++)
    {
        const size_t left = e->effect->size - 8*w;
        uint64_t bits = 0;
        double number;

        memcpy(&bits, (const char *)e->settings + 8*w, left < 8 ? left : 8);
        memcpy(&number, &bits, sizeof number);
        dem_text_add(c->out, "    0x%016llxul,    /* %g */\n", (unsigned long long)bits, number);
    }
    dem_text_add(c->out,
                 "};\n"
                 "static inline struct dem_%s settings_%s_%d(void)\n"
                 "{\n"
                 "    union { ulong bits[%zu]; struct dem_%s settings; } u;\n\n"
                 "    for (int w = 0; w < %zu; w++)\n"
                 "    {\n"
                 "        u.bits[w] = bits_%s_%d[w];\n"
                 "    }\n"
                 "    return u.settings;\n"
                 "}\n"
                 "typedef char size_%s_%d[sizeof(struct dem_%s) == %zu ? 1 : -1];\n",
                 law_name(e->effect), class, k, words, law_name(e->effect), words, class, k, class,
                 k, law_name(e->effect), e->effect->size);
}

/* The call of a function of a law on the row; history: of a contact, else "". */
static void add_call(struct composer *c, const char *class, int k, const struct dem_effect_entry *e,
                     const char *function, const char *history)
{
    const char *const law = law_name(e->effect);

    dem_device_scalars_before(c->out, e, *history);
    dem_text_add(c->out, e->grains ? "    parcel = *r;\n    dem_to_grains(PARCEL_RATIO, r);\n" : "");
    if (e->effect->size > 0)
    {
        dem_text_add(c->out,
                     "    {\n"
                     "        const struct dem_%s l = settings_%s_%d();\n\n"
                     "        dem_%s_%s(&l, r%s);\n"
                     "    }\n",
                     law, class, k, law, function, history);
    }
    else
    {
        dem_text_add(c->out, "    dem_%s_%s(0, r%s);\n", law, function, history);
    }
    dem_text_add(c->out, e->grains ? "    dem_to_parcel(PARCEL_RATIO, &parcel, r);\n" : "");
    dem_device_scalars_after(c->out, e, *history);
}

/* ---- contacts: as step/contact_effects.c applies the effects ----------------------------------- */

struct columns    /* of the laws of a class, one after the other */
{
    int n, first[DEM_EFFECT_LIST_LIMIT], column[DEM_HISTORY_COLUMNS];
};

static void list_columns(const struct dem_effect_list *list, struct columns *h)
{
    h->n = 0;
    for (int k = 0; k < list->entries; k++)
    {
        h->first[k] = h->n;
        for (int m = 0; m < dem_effect_history_columns(list->entry[k].effect); m++)
        {
            h->column[h->n++] = list->entry[k].first_column + m;
        }
    }
}

static void add_row_call(struct composer *c, const char *class,
                         const struct dem_effect_list *list, const struct columns *h, int k,
                         const char *function)
{
    char history[32];

    snprintf(history, sizeof history, ", h + %d", h->first[k]);
    add_call(c, class, k, &list->entry[k], function, history);
}

/* Where surfaces are apart, history of surface laws is zero. Only classes that act past touching
   come here with surfaces apart. */
static void add_clear(struct composer *c, const struct dem_effect_list *list,
                      const struct columns *h, int k)
{
    const int columns = dem_effect_history_columns(list->entry[k].effect);

    for (int m = 0; list->past_touching && list->entry[k].effect->stage < DEM_STAGE_BOND &&
                    m < columns;
         m++)
    {
        dem_text_add(c->out, "    h[%d] = dem_select(r->touching > 0.0, h[%d], 0.0);\n",
                     h->first[k] + m, h->first[k] + m);
    }
}

static void add_laws(struct composer *c, const struct dem_effect_list *list, const char *class,
                     const struct columns *h)
{
    int damped = 0;

    for (int k = 0; k < list->entries; k++)
    {
        add_settings(c, class, k, &list->entry[k]);
    }
    dem_text_add(c->out, "static void laws_%s(struct dem_contact_row *r, double *h%s%s)\n{\n", class,
                 c->scalars ? ", struct dem_row_scalars *q" : "",
                 c->balance.of->open ? ", struct dem_row_balance *e" : "");
    for (int k = 0; k < list->entries; k++)
    {
        if (list->entry[k].effect->replace_contact)
        {
            add_row_call(c, class, list, h, k, "replace_row");
        }
    }
    if (c->balance.of->open)
    {
        dem_text_add(c->out, "    dem_balance_begin(e, r, %d);\n", list->pair.with_wall);
    }
    for (int k = 0; k < list->entries; k++)
    {
        const int past_damping = list->entry[k].effect->stage >= DEM_STAGE_TANGENT;

        for (int m = 0; m < list->entries && list->past_touching && past_damping && !damped; m++)
        {
            if (list->entry[m].effect->set_adhesion)
            {
                add_row_call(c, class, list, h, m, "adhesion_row");
            }
        }
        damped |= past_damping;
        dem_program_balance_before(&c->balance, list->entry[k].effect, h->first[k]);
        add_row_call(c, class, list, h, k, "row");
        add_clear(c, list, h, k);
        dem_program_balance_after(&c->balance, list, k, h->first[k],
                                  law_name(list->entry[k].effect), class);
    }
    dem_text_add(c->out, "}\n");
}

static int add_class(struct composer *c, const struct dem_interaction_table *table, int class)
{
    const struct dem_effect_list *const list = &table->list[class];
    struct columns h;
    char name[16];

    snprintf(name, sizeof name, "%d", class);
    list_columns(list, &h);
    dem_text_add(c->out, "\n/* ---- %s and %s%s */\n", list->pair.a->name,
                 list->pair.with_wall ? "walls of " : "", list->pair.b->name);
    add_laws(c, list, name, &h);
    dem_text_add(c->out, "#define COLUMN_OF(DO)");
    for (int m = 0; m < h.n; m++)
    {
        dem_text_add(c->out, " DO(%d, %d)", m, h.column[m]);
    }
    dem_text_add(c->out, "\n#define COLUMNS %d\n#define LAWS laws_%d\n#define TEST test_%d\n"
                 "#define PAST_TOUCHING %d\n", h.n, class, class, list->past_touching);
    DEM_TRY(dem_program_include_name(&c->texts, "device/test.cl"));
    dem_text_add(c->out, "#define KERNEL rows_%d\n#define WITH_WALL %d\n#define MOMENTS %d\n"
                 "#define ENERGY %d\n#define RANDOM %d\n#define SURFACE %d\n"
                 "#define VISCOSITY %d\n#define CLASS_SCALARS %d\n#define HEATS %d\n", class,
                 list->pair.with_wall, table->moments, table->past_touching,
                 (list->needs & DEM_NEEDS_RANDOM) != 0, !c->walls->all_flat_static,
                 c->viscosity && list->needs & DEM_NEEDS_VISCOSITY, list->scalars > 0,
                 (list->needs & DEM_NEEDS_DISSIPATION) != 0);
    return dem_program_include_name(&c->texts, "device/rows.cl");
}

int dem_device_has_facets(const struct dem_walls *w)
{
    return dem_walls_count_triangles(w) > 0 || w->facets > 1 || w->absorbing > 0;
}

/* ---- the program ----------------------------------------------------------------------------- */

/* The model of eddies, for fluid.cl. */
static void add_eddies(struct composer *c, const struct dem_effect_entry *e)
{
    struct dem_eddies model = {0};

    e->effect->eddies(e->settings, &model);
    dem_text_add(c->out, "#define EDDIES .lifetime = %a, .length = %a, .seed = %llu\n",
                 model.lifetime, model.length, (unsigned long long)model.seed);
}

static int include_laws(struct composer *c, const struct dem_effect_list *list)
{
    for (int k = 0; k < list->entries; k++)
    {
        if (list->entry[k].effect->eddies)
        {
            add_eddies(c, &list->entry[k]);
        }
        DEM_TRY(dem_program_include(&c->texts, law_text(list->entry[k].effect)));
    }
    return DEM_OK;
}

static void add_balance_call(struct composer *c, const char *when, int k)
{
    if (c->balance.of->open)
    {
        dem_text_add(c->out, "    dem_balance_%s_law(e, r, %d);\n", when, k);
    }
}

static int add_bodies(struct composer *c, const struct dem_interaction_table *table)
{
    const struct dem_effect_list *const list = &table->bodies;

    for (int k = 0; k < list->entries; k++)
    {
        if (!list->entry[k].effect->eddies)
        {
            add_settings(c, "body", k, &list->entry[k]);
        }
    }
    dem_text_add(c->out, "#define PARCEL_RATIO q->value[%d]\nstatic void body_laws(struct dem_body_row *r%s%s)\n{\n",
                 list->parcel_scalar, c->scalars ? ", struct dem_particle_scalars *q" : "",
                 c->balance.of->open ? ", struct dem_particle_balance *e" : "");
    dem_text_add(c->out, list->grains ? "    struct dem_body_row parcel;\n\n" : "");
    for (int k = 0; k < list->entries; k++)
    {
        if (!list->entry[k].effect->eddies)
        {
            add_balance_call(c, "before", k);
            add_call(c, "body", k, &list->entry[k], "row", "");
            add_balance_call(c, "after", k);
        }
    }
    dem_text_add(c->out, "}\n#define BODIES body_laws\n#define BODY_ARGUMENTS &r%s%s\n#define MOMENTS %d\n"
                 "#define PAST_TOUCHING %d\n", c->scalars ? ", &q" : "",
                 c->balance.of->open ? ", &e" : "", table->moments, table->past_touching);
    if (c->balance.of->open)
    {
        dem_program_balance_bodies(&c->balance, list);
    }
    DEM_TRY(dem_program_include_name(&c->texts, "device/loads.cl"));
    return dem_program_include_name(&c->texts, "device/bodies.cl");
}

/* Contacts with several facets. */
static int add_facets(struct composer *c, const struct dem_interaction_table *table)
{
    enum dem_spring_kind kind[DEM_HISTORY_COLUMNS];

    dem_spring_kinds(table, kind);
    dem_text_add(c->out, "#define FACETS %d\n#define TRIANGLES %d\n#define HISTORY %d\n"
                 "#define CLASS_EXPONENTS", dem_device_has_facets(c->walls),
                 dem_walls_count_triangles(c->walls) > 0, table->history_columns);
    for (int k = 0; k < table->classes; k++)
    {
        dem_text_add(c->out, "%s %a", k > 0 ? "," : "", table->list[k].pair.exponent);
    }
    dem_text_add(c->out, "\n#define SPRING_KINDS 0");
    for (int m = 0; m < table->history_columns; m++)
    {
        dem_text_add(c->out, m > 0 ? ", %d" : " + %d", (int)kind[m]);
    }
    dem_text_add(c->out, "\n");
    if (dem_device_has_facets(c->walls))
    {
        DEM_TRY(dem_program_include_name(&c->texts, "device/facets.cl"));
    }
    if (dem_walls_count_triangles(c->walls) > 0)
    {
        DEM_TRY(dem_program_include_name(&c->texts, "device/triangles.cl"));
    }
    return DEM_OK;
}

static int compose(struct composer *c, const struct dem_interaction_table *table,
                   const struct dem_particles *particles)
{
    dem_text_add(c->out, "#define FLUID %d\n#define WHOLE_DRAG %d\n",
                 dem_device_columns_text(particles, c->out), table->bodies.whole_drag);
    c->viscosity = particles->batch.n > 0;
    dem_program_balance_sums(&c->balance);
    DEM_TRY(dem_program_include_name(&c->texts, "device/gather.cl"));
    DEM_TRY(dem_program_include_name(&c->texts, "device/sums.cl"));
    DEM_TRY(c->balance.of->open ? dem_program_include_name(&c->texts, "device/balance.cl") : DEM_OK);
    DEM_TRY(add_facets(c, table));
    c->scalars = table->listed;
    dem_device_scalars_text(c->out, table);
    DEM_TRY(table->listed > 0 ? dem_program_include_name(&c->texts, "device/scalars.cl") : DEM_OK);
    for (int k = 0; k < table->classes; k++)
    {
        DEM_TRY(include_laws(c, &table->list[k]));
    }
    DEM_TRY(include_laws(c, &table->bodies));
    for (int k = 0; k < table->classes; k++)
    {
        DEM_TRY(add_class(c, table, k));
    }
    DEM_TRY(dem_column(particles, DEM_COLUMN_FLUID_VELOCITY) ? dem_program_include_name(&c->texts, "device/fluid.cl")
                                                             : DEM_OK);
    DEM_TRY(add_bodies(c, table));
    DEM_TRY(dem_program_include_name(&c->texts, "device/ghosts.cl"));
    DEM_TRY(dem_program_include_name(&c->texts, "device/lists.cl"));
    return dem_program_include_name(&c->texts, "device/scan.cl");
}

int dem_device_program(const struct dem_interaction_table *table,
                       const struct dem_particles *particles, const struct dem_walls *walls,
                       const struct dem_energy_balance *balance, struct dem_text *text)
{
    struct composer c = {.out = text, .texts = {.out = text}, .walls = walls,
                         .balance = {.out = text, .of = balance,
                                     .first = DEM_DEVICE_WALL_SUMS*(unsigned)walls->walls}};
    const int status = compose(&c, table, particles);

    return status ? status : text->status;
}
