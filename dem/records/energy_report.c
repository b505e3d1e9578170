/*
 * energy_report.c -- the terms of the energy balance by name, and their total.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "records/energy_balance.h"
#include "records/totals.h"
#include "ranks/dem_state.h"
#include <stdio.h>
#include <string.h>

/* Append a term, by name. */
static void add_term(struct dem_energy_balance *l, const char *kind, const char *of, double value)
{
    struct dem_energy_item *const item = &l->item[l->items++];

    snprintf(item->name, sizeof item->name, "%s%s", kind, of);
    item->value = value;
}

/* Kinetic energies of translation and rotation [J]; the same on all ranks. */
static void kinetic_energies(const struct dem_state *state, double value[2])
{
    struct dem_sum sum[2] = {0};

    for (size_t i = 0; i < state->particles.n; i++)
    {
        struct dem_particle_share s;

        dem_particle_share(&state->particles, i, &s);
        dem_sum_add(&sum[0], s.kinetic[0]);
        dem_sum_add(&sum[1], s.kinetic[1]);
    }
    dem_totals_reduce_sums(state, sum, 2, value);
}

static double value_of(const struct dem_state *state, const struct dem_sum *own)
{
    struct dem_sum sum = *own;
    double value;

    dem_totals_reduce_sums(state, &sum, 1, &value);
    return value;
}

/* A contact law without history is a function of the overlap, or of overlap and motion: it has no
   spring to report, or no heat. */
static int has_elastic(const struct dem_effect *e)
{
    return e->energy ? e->stage == DEM_STAGE_NORMAL || e->stage >= DEM_STAGE_BOND ||
                           (e->stage > DEM_STAGE_DAMP && e->history)
                     : e->stage >= DEM_STAGE_BOND;
}

static int has_lost(const struct dem_effect *e)
{
    return e->stage != DEM_STAGE_NORMAL || e->history;
}

/* The terms of contact effects: elastic energy, then heat. Returns their sum. */
static double report_contacts(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    double lost[DEM_EFFECT_LIST_LIMIT], total = 0.0;

    for (int k = 0;
         k < state->interaction_table.chosen && state->interaction_table.effect[k]->stage < DEM_STAGE_SCALAR;
         k++)
    {
        const struct dem_effect *const e = state->interaction_table.effect[k];
        const double stored =
            value_of(state, &dem_energy_balance_sums_of(l, e)[DEM_ENERGY_BALANCE_ELASTIC]);

        lost[k] = value_of(state, &dem_energy_balance_sums_of(l, e)[DEM_ENERGY_BALANCE_LOST]);
        total += stored + lost[k];
        if (has_elastic(e))
        {
            add_term(l, "elastic_", e->name, stored);
        }
    }
    for (int k = 0;
         k < state->interaction_table.chosen && state->interaction_table.effect[k]->stage < DEM_STAGE_SCALAR;
         k++)
    {
        const struct dem_effect *const e = state->interaction_table.effect[k];

        if (!e->energy && e->stage < DEM_STAGE_BOND)
        {
            add_term(l, "measured_", e->name, lost[k]);
        }
        else if (has_lost(e))
        {
            add_term(l, "lost_", e->name, lost[k]);
        }
    }
    return total;
}

/* The heat of drag and the work of the fluid and of other body forces. Returns heat minus work. */
static double report_bodies(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    double total = 0.0;

    for (int k = 0; k < state->interaction_table.chosen; k++)
    {
        const struct dem_effect *const e = state->interaction_table.effect[k];

        if (e->stage >= DEM_STAGE_BODY && !e->uniform_acceleration)
        {
            const double lost =
                value_of(state, &dem_energy_balance_sums_of(l, e)[DEM_ENERGY_BALANCE_LOST]);
            const double work =
                value_of(state, &dem_energy_balance_sums_of(l, e)[DEM_ENERGY_BALANCE_WORK]);

            if (e->drag)
            {
                add_term(l, "lost_", e->name, lost);
            }
            add_term(l, "work_", e->name, work);
            total += lost - work;
        }
    }
    return total;
}

/* The springs of contacts with walls that have gone. */
static double report_gone(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    double total = 0.0;

    if (!l->wall_elastic)
    {
        return 0.0;
    }
    for (int k = 0; k < state->walls.walls; k++)
    {
        total += state->walls.wall[k].absent ? value_of(state, &l->wall_elastic[k]) : 0.0;
    }
    add_term(l, "lost_removed", "", total);
    return total;
}

static int has_stage(const struct dem_interaction_table *r, enum dem_stage stage)
{
    int has = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        has |= r->effect[k]->stage == stage;
    }
    return has;
}

/* Heat content gained, and where it comes from. Returns the difference, 0 to rounding, less what
   contacts dissipated: that has become heat. */
static double report_heat(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    const double heated = value_of(state, &l->sum[DEM_ENERGY_BALANCE_HEATED]),
                 walls = value_of(state, &l->sum[DEM_ENERGY_BALANCE_HEAT_WALLS]),
                 bodies = value_of(state, &l->sum[DEM_ENERGY_BALANCE_HEAT_BODIES]),
                 left = value_of(state, &l->sum[DEM_ENERGY_BALANCE_HEAT_OUT]),
                 came = value_of(state, &l->sum[DEM_ENERGY_BALANCE_HEAT_IN]);
    struct dem_sum sum = l->sum[DEM_ENERGY_BALANCE_CONTENT];
    double gain;

    for (size_t i = 0; i < state->particles.n; i++)
    {
        dem_energy_balance_add_content(state, i, 1.0, &sum);
    }
    dem_totals_reduce_sums(state, &sum, 1, &gain);
    add_term(l, "heat_content", "", gain);
    if (state->interaction_table.needs & DEM_NEEDS_DISSIPATION)
    {
        add_term(l, "heat_dissipated", "", heated);
    }
    add_term(l, "heat_walls", "", walls);
    add_term(l, "heat_fluid", "", bodies);
    if (state->domain.remove || l->flows)
    {
        add_term(l, "heat_left", "", left);
    }
    if (l->flows)
    {
        add_term(l, "heat_came", "", came);
    }
    return gain - heated - walls - bodies + left - came;
}

/* The energy of walls that are moved by force, what they lost, less the work of their loads. */
static double report_bodies_of_walls(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    const double loads = value_of(state, &l->sum[DEM_ENERGY_BALANCE_LOADS]),
                 lost = value_of(state, &l->sum[DEM_ENERGY_BALANCE_LOST_WALLS]);
    double kinetic = 0.0;

    for (int k = 0; k < state->walls.walls; k++)
    {
        const struct dem_wall_body *const b = dem_walls_body(&state->walls, k);

        kinetic += b ? dem_wall_body_kinetic(b) : 0.0;
    }
    add_term(l, "kinetic_walls", "", kinetic);
    add_term(l, "lost_walls", "", lost);
    add_term(l, "work_loads", "", loads);
    return kinetic + lost - loads;
}

static double report_all(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    const double fell = value_of(state, &l->sum[DEM_ENERGY_BALANCE_GRAVITY]),
                 broken = value_of(state, &l->sum[DEM_ENERGY_BALANCE_BROKEN]);
    const double walls = value_of(state, &l->sum[DEM_ENERGY_BALANCE_WALLS]),
                 left = value_of(state, &l->sum[DEM_ENERGY_BALANCE_OUT]);
    const double driven = value_of(state, &l->sum[DEM_ENERGY_BALANCE_DRIVEN]);
    const double cell = value_of(state, &l->sum[DEM_ENERGY_BALANCE_CELL]);
    const double applied = value_of(state, &l->sum[DEM_ENERGY_BALANCE_APPLIED]);
    const double came = value_of(state, &l->sum[DEM_ENERGY_BALANCE_IN]);
    double kinetic[2], g[3], total;
    const struct dem_effect *const potential =
        dem_interaction_table_gravity(&state->interaction_table, g);

    l->items = 0;
    kinetic_energies(state, kinetic);
    add_term(l, "kinetic_translation", "", kinetic[0]);
    add_term(l, "kinetic_rotation", "", kinetic[1]);
    if (potential)
    {
        add_term(l, potential->name, "", -fell);
    }
    total = kinetic[0] + kinetic[1] - fell + report_contacts(state);
    total += report_gone(state);
    if (has_stage(&state->interaction_table, DEM_STAGE_BOND))
    {
        add_term(l, "broken", "", broken);
    }
    if (!state->walls.all_flat_static)
    {
        add_term(l, "work_walls", "", walls);
    }
    if (state->walls.bodies > 0)
    {
        total += report_bodies_of_walls(state);
    }
    if (l->driven)
    {
        add_term(l, "work_driven", "", driven);
    }
    if (state->cell.active)
    {
        add_term(l, "work_cell", "", cell);
    }
    if (state->applied_forces.n > 0 || state->applied_forces.program.worked)
    {
        add_term(l, "work_forces", "", applied);
    }
    total += broken - walls - applied - driven - cell + report_bodies(state);
    if (state->domain.remove || l->flows)
    {
        add_term(l, "left", "", left);
    }
    if (l->flows)
    {
        add_term(l, "came", "", came);
    }
    return total + left - came + (l->heat >= 0 ? report_heat(state) : 0.0);
}

void dem_energy_balance_begin(struct dem_state *state)
{
    state->energy_balance->driven = dem_totals_any_driven(state);
    dem_energy_balance_begin_heat(state);
    /* includes particles outside the domain, which are removed later */
    state->energy_balance->start = report_all(state);
    dem_sum_clear(&state->energy_balance->sum[DEM_ENERGY_BALANCE_OUT]);
    state->energy_balance->since = state->time;
    state->energy_balance->begun = 1;
}

double dem_energy_balance_total(struct dem_state *state)
{
    return report_all(state);
}

void dem_energy_balance_edited(struct dem_state *state, double before)
{
    struct dem_energy_balance *const l = state->energy_balance;

    if (l->open)
    {
        l->edited += report_all(state) - before;
        l->edits = 1;
    }
}

void dem_energy_balance_report(struct dem_state *state)
{
    struct dem_energy_balance *const l = state->energy_balance;
    const double total = report_all(state) - l->edited;

    if (l->edits)
    {
        add_term(l, "edited", "", l->edited);
    }
    add_term(l, "total", "", total);
    add_term(l, "residual", "", total - l->start);
}
