/*
 * clump_heat.c -- integrates the temperatures of rigid bodies of several spheres (formulas: clump_heat.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_heat.h"
#include "core/math.h"
#include "particles/scalars.h"

void dem_clump_heat_begin(const struct dem_clump_heat *heat, struct dem_body_scalars *s,
                          const struct dem_particles *p, size_t first, int rows)
{
    const int k = heat->scalar;

    for (int c = 0; c < rows; c++)
    {
        if (p->record[first + (size_t)c].body)
        {
            heat->row[first + (size_t)c] = (struct dem_clump_heat_row){
                .rate = s->rate[k][c], .coefficient = s->coefficient[k][c], .to_target = s->to_target[k][c]};
            s->rate[k][c] = s->coefficient[k][c] = s->to_target[k][c] = 0.0;
        }
    }
}

void dem_clump_heat_take(const struct dem_clump_heat *heat, const struct dem_clump_flow *flow,
                         const struct dem_body_scalars *s, const struct dem_particles *p, size_t first, int rows)
{
    const int k = heat->scalar;

    for (int c = 0; c < rows; c++)
    {
        struct dem_clump_heat_row *const r = &heat->row[first + (size_t)c];

        if (p->record[first + (size_t)c].body && flow)
        {
            const double part = flow->part[first + (size_t)c].surface;

            r->rate += part*s->rate[k][c];
            r->coefficient += part*s->coefficient[k][c];
            r->to_target += part*s->to_target[k][c];
        }
    }
}

/* What sphere i received from its coefficient, for the partner of the exchange; all: of its body. */
static void sum_exchange(const struct dem_clump_heat *heat, const struct dem_clump_heat_row *all,
                         const struct dem_scalar_step *step, struct dem_particles *p, size_t i, double T, double z)
{
    const struct dem_interaction_table *const t = step->table;
    const struct dem_clump_heat_row *const r = &heat->row[i];
    const double phi = dem_phi(z), part = all->coefficient > 0.0 ? r->coefficient/all->coefficient : 0.0;
    const int k = heat->scalar;

    dem_scalar_exchange_values(p, t, k, DEM_SCALAR_RECEIVED)[i] +=
        step->h*(phi*(r->to_target - r->coefficient*T) - (1.0 - phi)*part*all->rate);
    dem_scalar_exchange_values(p, t, k, DEM_SCALAR_TIME)[i] += step->h*r->coefficient;
    dem_scalar_exchange_values(p, t, k, DEM_SCALAR_TARGET_TIME)[i] += step->h*r->to_target;
    dem_scalar_exchange_values(p, t, k, DEM_SCALAR_DECAY)[i] *= 1.0 - z*phi;
}

/* One body. Returns its new temperature. */
static double integrate(const struct dem_clumps *c, size_t body, const struct dem_scalar_step *step,
                        struct dem_particles *p)
{
    const struct dem_clump_heat *const heat = c->heat;
    const size_t begin = c->start[body], end = c->start[body + 1], first = c->member[begin];
    double *const value = dem_scalar_values(p, heat->scalar);
    const double T = value[first], C = dem_interaction_table_capacity(
        step->table, heat->scalar, p->record[first].material, dem_clump_at(p, first)->mass);
    struct dem_clump_heat_row all = {.rate = 0.0};

    for (size_t k = begin; k < end; k++)
    {
        const struct dem_clump_heat_row *const r = &heat->row[c->member[k]];

        all.rate += r->rate;
        all.coefficient += r->coefficient;
        all.to_target += r->to_target;
    }
    const double z = all.coefficient*step->h/C,
                 gain = dem_phi(z)*(all.rate + all.to_target - all.coefficient*T), now = T + step->h/C*gain;

    for (size_t k = begin; k < end; k++)
    {
        const size_t i = c->member[k];

        value[i] = now;
        if (step->heat && step->contacts->forces.rates)
        {
            dem_sum_add(step->heat, -step->h*dem_body_scalars_contacts(step->contacts, heat->scalar, i));
        }
        if (step->table->exchanged[heat->scalar])
        {
            sum_exchange(heat, &all, step, p, i, T, z);
        }
    }
    if (step->heat)
    {
        dem_sum_add(step->heat, step->h*gain);
    }
    return now;
}

int dem_clump_heat_integrate(const struct dem_clumps *c, const struct dem_scalar_step *step,
                             struct dem_particles *p)
{
    const struct dem_scalar *const s = step->table->scalar[c->heat->scalar];
    int bad = 0;

    for (size_t body = 0; body < c->n; body++)
    {
        const double T = integrate(c, body, step, p);

        bad += !(T >= s->min && T <= s->max);
    }
    return bad;
}

void dem_clump_heat_end_window(const struct dem_clumps *c, const struct dem_interaction_table *t,
                               struct dem_particles *p)
{
    double *const decay = dem_scalar_exchange_values(p, t, c->heat->scalar, DEM_SCALAR_DECAY),
           *const time = dem_scalar_exchange_values(p, t, c->heat->scalar, DEM_SCALAR_TIME);

    if (decay)
    {
        dem_clump_share_decay(c, p, time, decay, 1);
    }
}
