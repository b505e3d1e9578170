/*
 * energy_heat.c -- energy balance: heat content of the particles, and where it comes from.
 *
 *   sum C (T - T_start) = heated + walls + bodies - left + came
 *
 *   C, T      heat capacity, temperature: the particle scalar with DEM_SCALAR_HEAT    [J/K], [K]
 *   heated    dissipated in contacts, where an effect makes heat of it                [J]
 *   walls     received at walls, less what was dissipated there: below 0 where walls receive    [J]
 *   bodies    received from the fluid and the program                                 [J]
 *
 * Both sides are exact sums of what each step adds, so they differ by the rounding of T alone: 3e-14 C
 * a particle and step at room temperature.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/energy_balance.h"
#include "contacts/contact_batch.h"
#include "particles/scalars.h"
#include "ranks/dem_state.h"
#include <math.h>

void dem_energy_balance_add_content(const struct dem_state *p, size_t particle, double sign,
                                    struct dem_sum *sum)
{
    const int k = p->energy_balance->heat;

    if (k >= 0)
    {
        const struct dem_particle *const q = &p->particles.record[particle];
        const double C = sign*dem_interaction_table_capacity(&p->interaction_table, k,
                                                             q->material, q->mass);
        const double T = dem_scalar_values(&p->particles, k)[particle], content = C*T;

        dem_energy_balance_add(sum, content);
        dem_energy_balance_add(sum, fma(C, T, -content));
    }
}

void dem_energy_balance_begin_heat(struct dem_state *p)
{
    struct dem_sum *const sum = p->energy_balance->sum;

    for (int k = DEM_ENERGY_BALANCE_CONTENT; k <= DEM_ENERGY_BALANCE_HEAT_IN; k++)
    {
        dem_sum_clear(&sum[k]);
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        dem_energy_balance_add_content(p, i, -1.0, &sum[DEM_ENERGY_BALANCE_CONTENT]);
    }
}

void dem_energy_balance_contact_heat(struct dem_state *p, const struct dem_contact_batch *b,
                                     const struct dem_energy_balance_rows *r, const double *rate)
{
    struct dem_sum *const sum = p->energy_balance->sum;
    const int heats = (r->list->needs & DEM_NEEDS_DISSIPATION) != 0;

    for (int c = 0; c < r->rows && p->energy_balance->begun; c++)
    {
        const double heat = heats ? b->dissipated[c] : 0.0;

        if (dem_contacts_pair(&p->contacts, r->row + (uint32_t)c)->i < p->particles.n)
        {
            dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEATED], heat);
            if (r->list->pair.with_wall)
            {
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEAT_WALLS], rate[c]*b->dt);
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_HEAT_WALLS], -heat);
            }
        }
    }
}
