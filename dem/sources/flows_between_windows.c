/*
 * flows_between_windows.c -- streams and outlets between two windows, for a program whose fluid has
 * to know of all particles beforehand.
 *
 * Positions and velocities are synchronous there, so no backward kick is needed. The contact
 * history is saved, as before a rebuild, and the next step rebuilds. The first half kick of the
 * next window takes the contact forces from the columns of the particles; the forces on walls are
 * summed here before the contact rows are deleted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/flows.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "ranks/agree.h"
#include "ranks/dem_state.h"
#include "records/energy_balance.h"
#include "records/wall_statistics.h"
#include "sources/residence.h"
#include <stdlib.h>

static int by_id(const void *a, const void *b)
{
    const struct dem_outgoing_particle *const p = a, *const q = b;

    return (p->id > q->id) - (p->id < q->id);
}

/* The outlet that removes a particle now: the one listed by the program, or one of the scene; else
   DEM_FLOW_NONE. */
static int flow_of(const struct dem_state *state, size_t i,
                   const struct dem_outgoing_particle *outgoing, size_t n)
{
    const struct dem_particle *const q = &state->particles.record[i];
    const struct dem_outgoing_particle key = {.id = q->id};
    const struct dem_outgoing_particle *const found =
        n > 0 ? bsearch(&key, outgoing, n, sizeof *outgoing, by_id) : NULL;
    const int absorbed = dem_flows_absorbed(state->flows, q);

    return found ? found->flow
           : absorbed != DEM_FLOW_NONE ? absorbed
                                       : dem_flows_outlet(state, i);
}

/* The momentum removed includes the impulses that were to act in the next windows (carried over
   from the last exchange, and owed by the pressure gradient, -owed_pressure_impulse), and later the
   contact forces of the half kick that the partners still get. */
static int remove_particle(struct dem_state *state, size_t i, int flow)
{
    const double *const carried_over = dem_column(&state->particles, DEM_COLUMN_CARRIED_OVER_IMPULSE),
                        *const owed =
                            dem_column(&state->particles, DEM_COLUMN_OWED_PRESSURE_IMPULSE),
                        *const force = dem_column(&state->particles, DEM_COLUMN_FORCE);
    struct dem_flows *const f = state->flows;

    DEM_TRY(dem_flows_record_departure(state, flow, &state->particles.record[i], 0.0));
    dem_residence_record(state, i);
    struct dem_departure *const new = &f->departure[f->departures - 1];

    for (size_t k = 0; k < 3; k++)
    {
        new->momentum[k] += carried_over ? carried_over[3*i + k] : 0.0;
        new->momentum[k] -= owed ? owed[3*i + k] : 0.0;
        new->contact_force[k] = force[3*i + k];
    }
    if (state->energy_balance->open)
    {
        dem_energy_balance_particle_out(state, &state->particles.record[i], 0.0);
    }
    return DEM_OK;
}

/* Remove outgoing particles. `order`: indices of the particles that stay, `stay` of them. */
static int remove_outgoing(struct dem_state *state, const struct dem_outgoing_particle *outgoing,
                           size_t n, uint32_t *order, size_t *stay)
{
    *stay = 0;
    for (size_t i = 0; i < state->particles.n; i++)
    {
        const int flow = flow_of(state, i, outgoing, n);

        if (flow == DEM_FLOW_NONE)
        {
            order[(*stay)++] = (uint32_t)i;
        }
        else
        {
            DEM_TRY(remove_particle(state, i, flow));
        }
    }
    return DEM_OK;
}

static int apply_changes(struct dem_state *state, uint32_t *order, size_t stay)
{
    if (state->lists_state != DEM_NEIGHBORS_NONE)
    {
        const int status = dem_wall_statistics_save_forces(state);

        DEM_TRY(dem_agree(state, status ? status
                                    : dem_contacts_save_history(&state->contacts, &state->particles,
                                                                state->pairs.wall_facet)));
    }
    if (stay < state->particles.n)
    {
        dem_particles_reorder(&state->particles, order, stay);
    }
    state->particles.ghosts = 0;
    DEM_TRY(dem_flows_sum_departures(state));
    state->lists_state = DEM_NEIGHBORS_NONE;
    return dem_agree(state, dem_flows_insert(state));
}

int dem_flows_between_windows(struct dem_state *state, size_t n, struct dem_outgoing_particle *outgoing,
                              int (*before_changes)(struct dem_state *), int *changed)
{
    double changes;
    uint32_t *order = NULL;
    size_t stay = 0;

    *changed = 0;
    if (state->flows->n == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_flows_count_passages(state, 0.0));
    dem_sort_by(outgoing, n, sizeof *outgoing, by_id);
    int status = DEM_NEW(order, state->particles.n + 1);

    status = dem_agree(state, status ? status : remove_outgoing(state, outgoing, n, order, &stay));
    status = status ? status : dem_flows_find_positions(state, state->steps);
    changes = stay < state->particles.n || state->flows->arrivals > 0 ? 1.0 : 0.0;
    status = dem_agree_max(state, status, &changes, 1);
    if (!status && changes > 0.0)
    {
        *changed = 1;
        status = before_changes(state);
        status = status ? status : apply_changes(state, order, stay);
    }
    dem_flows_end_check(state);
    dem_memory_free(order);
    return status;
}
