/*
 * contact_effects.c -- apply the effects of a class to a batch of contacts, in the order of their
 * stages: a fused kernel for the first ones, or one loop each.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/contact_effects.h"
#include "core/math.h"
#include "laws/fused/fused.h"
#include "records/energy_balance.h"
#include "step/contact_scalars.h"
#include <stddef.h>
#include <string.h>

DEM_KERNEL
static void clear_apart(const struct dem_contact_batch *restrict b, double *restrict history)
{
    for (int c = 0; c < b->n; c++)
    {
        history[c] = dem_select(b->touching[c] > 0.0, history[c], 0.0);
    }
}

/* The history columns of an effect at the rows of the batch. Returns their number. */
static int find_history(const struct dem_contact_history *h, const struct dem_effect_entry *entry,
                        uint32_t row, double **history)
{
    const int columns = dem_effect_history_columns(entry->effect);

    for (int m = 0; m < columns; m++)
    {
        history[m] = h->column[entry->first_column + m] + row;
    }
    return columns;
}

/* The history columns and the particle scalars of an effect. Returns the number of columns. */
static int begin_effect(struct dem_contact_workspace *t, const struct dem_contact_history *h,
                        const struct dem_effect_entry *entry, uint32_t row, double **history)
{
    if (t->scalars)
    {
        dem_contact_scalars_select(t, entry);
    }
    return find_history(h, entry, row, history);
}

void dem_contact_effects_replace_contacts(struct dem_contact_workspace *t,
                                          const struct dem_effect_list *effects,
                                          const struct dem_contact_history *h, uint32_t row)
{
    double *history[DEM_HISTORY_COLUMNS];

    for (int k = 0; k < effects->entries; k++)
    {
        if (effects->entry[k].effect->replace_contact)
        {
            begin_effect(t, h, &effects->entry[k], row, history);
            effects->entry[k].effect->replace_contact(effects->entry[k].settings, &t->batch,
                                                      history);
        }
    }
}

/* Adhesive forces of films, which friction needs, just before it acts. */
static void apply_adhesion(struct dem_contact_workspace *t, const struct dem_effect_list *effects,
                           const struct dem_contact_history *h, uint32_t row)
{
    double *history[DEM_HISTORY_COLUMNS];

    for (int k = 0; k < effects->entries; k++)
    {
        if (effects->entry[k].effect->set_adhesion)
        {
            begin_effect(t, h, &effects->entry[k], row, history);
            effects->entry[k].effect->set_adhesion(effects->entry[k].settings, &t->batch, history);
        }
    }
}

/* 1 when this entry is the first after the stages NORMAL and DAMP, in an effect list that acts past
   touching. */
static int is_first_after_damping(const struct dem_effect_list *effects, int k)
{
    return effects->past_touching && effects->entry[k].effect->stage >= DEM_STAGE_TANGENT
           && (k == 0 || effects->entry[k - 1].effect->stage < DEM_STAGE_TANGENT);
}

static void apply_effect(struct dem_contact_workspace *t, const struct dem_effect_list *effects,
                         int k, double **history, int columns)
{
    const struct dem_effect *const effect = effects->entry[k].effect;
    /* An effect that replaces contacts clears the touching mask but not the overlap, so beside it the
       own clearing of an effect (`clears_history`) is not enough. */
    const int cleared_already =
        effect->stage >= DEM_STAGE_BOND || (effect->clears_history && !effects->past_touching);

    effect->apply(effects->entry[k].settings, &t->batch, history);
    for (int m = 0; m < columns && !cleared_already; m++)
    {
        clear_apart(&t->batch, history[m]);
    }
}

static void clear_results(struct dem_contact_batch *b)
{
    const size_t first = offsetof(struct dem_contact_batch, kn),
                 end = offsetof(struct dem_contact_batch, stored);

    memset((char *)b + first, 0, end - first);
}

/* The first effects of the list, in one loop. Returns their number. */
static int apply_fused(struct dem_contact_workspace *t, const struct dem_effect_list *effects,
                       const struct dem_contact_history *h, uint32_t row)
{
    const void *settings[DEM_FUSED_LAWS];
    double *history[DEM_HISTORY_COLUMNS];
    int columns = 0, k = 0;

    for (int m = 0; m < DEM_FUSED_LAWS; m++)
    {
        settings[m] = effects->entry[0].settings;
        if (effects->kernel->law[m] != &dem_none)
        {
            settings[m] = effects->entry[k].settings;
            columns += find_history(h, &effects->entry[k], row, history + columns);
            k++;
        }
    }
    effects->kernel->apply(settings, &t->batch, history);
    return k;
}

void dem_contact_effects_apply(struct dem_contact_workspace *t,
                               const struct dem_effect_list *effects,
                               const struct dem_contact_history *h, uint32_t row)
{
    double *history[DEM_HISTORY_COLUMNS];
    int first = 0;

    if (effects->kernel)
    {
        first = apply_fused(t, effects, h, row);
    }
    else
    {
        clear_results(&t->batch);
    }
    for (int k = first; k < effects->entries; k++)
    {
        if (is_first_after_damping(effects, k))
        {
            apply_adhesion(t, effects, h, row);
        }
        const int columns = begin_effect(t, h, &effects->entry[k], row, history);

        apply_effect(t, effects, k, history, columns);
    }
}

/* What the last effect dissipated, for those that make heat of it. */
static void add_dissipated(struct dem_contact_batch *b, const double *lost)
{
    for (int c = 0; c < b->n; c++)
    {
        b->dissipated[c] += lost[c];
    }
}

void dem_contact_effects_apply_with_energy(struct dem_state *state, struct dem_contact_workspace *t,
                                           const struct dem_effect_list *effects, uint32_t row,
                                           int rows)
{
    double *history[DEM_HISTORY_COLUMNS];
    struct dem_energy_balance_rows r = {.list = effects,
                                        .memory = history,
                                        .row = row,
                                        .rows = rows};
    const int heats = (effects->needs & DEM_NEEDS_DISSIPATION) != 0;

    clear_results(&t->batch);
    memset(t->batch.dissipated, 0, sizeof t->batch.dissipated);
    dem_energy_balance_begin_batch(state, t, &r);
    for (int k = 0; k < effects->entries; k++)
    {
        if (is_first_after_damping(effects, k))
        {
            apply_adhesion(t, effects, &state->contacts.history, row);
        }
        r.entry = &effects->entry[k];
        const int columns = begin_effect(t, &state->contacts.history, r.entry, row, history);

        dem_energy_balance_before_effect(state, t, &r);
        apply_effect(t, effects, k, history, columns);
        dem_energy_balance_after_effect(state, t, &r);
        if (heats)
        {
            add_dissipated(&t->batch, state->energy_balance->scratch->energy.lost);
        }
    }
}
