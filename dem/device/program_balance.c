/*
 * program_balance.c -- text of a program for the energy balance.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "device/program_balance.h"

void dem_program_balance_sums(const struct dem_program_balance *b)
{
    static const struct
    {
        const char *name;
        enum dem_energy_balance_sum sum;
    } named[] = {{"GRAVITY", DEM_ENERGY_BALANCE_GRAVITY}, {"WALLS", DEM_ENERGY_BALANCE_WALLS},
                 {"APPLIED", DEM_ENERGY_BALANCE_APPLIED}, {"DRIVEN", DEM_ENERGY_BALANCE_DRIVEN},
                 /* with heat: from here on */
                 {"HEATED", DEM_ENERGY_BALANCE_HEATED}, {"HEAT_WALLS", DEM_ENERGY_BALANCE_HEAT_WALLS},
                 {"HEAT_BODIES", DEM_ENERGY_BALANCE_HEAT_BODIES}};

    dem_text_add(b->out, "#define BALANCE %d\n", b->of->open);
    for (int k = 0; b->of->open && k < (b->of->heat < 0 ? 4 : 7); k++)
    {
        dem_text_add(b->out, "#define ENERGY_%s %u\n", named[k].name,
                     b->first + (unsigned)named[k].sum);
    }
    dem_text_add(b->out, "#define BALANCE_GRAVITY %a, %a, %a\n", b->of->gravity[0],
                 b->of->gravity[1], b->of->gravity[2]);
}

static unsigned sum_of(const struct dem_program_balance *b, const struct dem_effect *e,
                       enum dem_energy_balance_sum which)
{
    return b->first + (unsigned)(dem_energy_balance_sums_of(b->of, e) - b->of->sum) + which;
}

void dem_program_balance_before(const struct dem_program_balance *b, const struct dem_effect *e,
                                int first)
{
    if (b->of->open && e->stage < DEM_STAGE_SCALAR)
    {
        dem_text_add(b->out, "    dem_balance_before(e, r, h + %d, %d);\n", first,
                     dem_effect_history_columns(e));
    }
}

void dem_program_balance_after(const struct dem_program_balance *b,
                               const struct dem_effect_list *list, int k, int first,
                               const char *name, const char *class)
{
    const struct dem_effect *const e = list->entry[k].effect;

    if (!b->of->open || e->stage >= DEM_STAGE_SCALAR)
    {
        return;
    }
    dem_text_add(b->out, "    if (e)\n    {\n");
    if (e->size > 0)
    {
        dem_text_add(b->out, "        const struct dem_%s l = settings_%s_%d();\n\n", name, class, k);
    }
    dem_text_add(b->out, "        dem_balance_contribution(e, r);\n");
    if (e->energy)
    {
        dem_text_add(b->out, "        dem_%s_energy_row(%s, r, e->before, h + %d, &e->energy);\n", name,
                     e->size > 0 ? "&l" : "0", first);
    }
    else if (e->stage < DEM_STAGE_BOND)
    {
        dem_text_add(b->out, "        dem_balance_measure(e, r);\n");
    }
    if (e->stage == DEM_STAGE_NORMAL)
    {
        dem_text_add(b->out, "        dem_%s_row(%s, dem_balance_row_before(e, r), e->before);\n"
                     "        e->energy.previous_kn = e->was.kn;\n", name, e->size > 0 ? "&l" : "0");
    }
    dem_text_add(b->out, "        dem_exact_add(&e->to, %u, e->energy.lost);\n%s    }\n",
                 sum_of(b, e, DEM_ENERGY_BALANCE_LOST),
                 list->needs & DEM_NEEDS_DISSIPATION ? "        r->dissipated += e->energy.lost;\n" : "");
}

void dem_program_balance_bodies(const struct dem_program_balance *b, const struct dem_effect_list *list)
{
    dem_text_add(b->out, "static void body_balance(const struct dem_particle_balance *e, "
                 "const struct dem_body_row *r)\n{\n");
    for (int k = 0; k < list->entries; k++)
    {
        const struct dem_effect *const e = list->entry[k].effect;

        /* eddies are no force; gravity is dem_balance_drift */
        if (!e->eddies && !e->uniform_acceleration)
        {
            dem_text_add(b->out, "    dem_balance_kick(e, r, %d, %d, %d, %d, %u, %u);\n", k,
                         e->drag != 0, e->has_added_mass, e->has_rotational_drag,
                         sum_of(b, e, DEM_ENERGY_BALANCE_LOST), sum_of(b, e, DEM_ENERGY_BALANCE_WORK));
        }
    }
    dem_text_add(b->out, "}\n");
}
