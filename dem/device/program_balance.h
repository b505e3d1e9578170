/*
 * program_balance.h -- text of a program for the energy balance (balance.cl).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/text.h"
#include "laws/interaction_table.h"
#include "records/energy_balance.h"

struct dem_program_balance
{
    struct dem_text *out;
    const struct dem_energy_balance *of;
    unsigned first;               /* its first sum, behind the sums of walls */
};

/* #define BALANCE, and the sums that have names. */
void dem_program_balance_sums(const struct dem_program_balance *);

/* Before and after the call of entry k of a list of contact laws, whose history begins at h + first;
   name: of the law in C, class: of its settings. */
void dem_program_balance_before(const struct dem_program_balance *, const struct dem_effect *, int first);
void dem_program_balance_after(const struct dem_program_balance *, const struct dem_effect_list *, int k,
                               int first, const char *name, const char *class);

/* The function body_balance: the work of body laws over a kick. */
void dem_program_balance_bodies(const struct dem_program_balance *, const struct dem_effect_list *);
