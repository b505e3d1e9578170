/*
 * contact_effects.h -- apply the effects of a class to a batch of contacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_batch.h"
#include "ranks/dem_state.h"

/* Effects that replace the contact of the surfaces, for example bonds: they clear the touching mask
   before the contact laws act. row: the first of the batch in the history. */
void dem_contact_effects_replace_contacts(struct dem_contact_workspace *,
                                          const struct dem_effect_list *,
                                          const struct dem_contact_history *, uint32_t row);

/* All effects of the list; and the same one by one, with the energy balance. */
void dem_contact_effects_apply(struct dem_contact_workspace *, const struct dem_effect_list *,
                               const struct dem_contact_history *, uint32_t row);
void dem_contact_effects_apply_with_energy(struct dem_state *, struct dem_contact_workspace *,
                                           const struct dem_effect_list *, uint32_t row, int rows);
