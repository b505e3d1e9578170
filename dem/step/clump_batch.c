/*
 * clump_batch.c -- spheres of rigid bodies in a batch of particles: the volume-equivalent sphere for the
 * effects, and shares of their results for the kick of the bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_batch.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/clump_lanes.h"
#include "step/clump_energy.h"
#include "step/clump_heat.h"
#include <string.h>

void dem_clump_batch_begin(const struct dem_clump_flow *f, struct dem_body_workspace *work,
                           const struct dem_particles *p, size_t first, int rows, double over_window)
{
    const double *const carried = dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE);
    struct dem_body_batch *const b = &work->batch;

    for (int c = 0; c < rows; c++)
    {
        const size_t i = first + (size_t)c;
        const struct dem_clump_part *const part = &f->part[i];
        const struct dem_clump_form *const form = part->form;

        if (!form)
        {
            continue;
        }
        for (size_t a = 0; a < 3; a++)
        {
            f->row[i].force[a] = over_window*carried[3*i + a];
        }
        b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
        b->radius[c] = form->radius;
        b->volume[c] = form->volume;
        b->mass[c] = part->mass;
        b->sphericity[c] = form->sphericity;
        if (form->areas)
        {
            const double slip[3] = {b->ux[c] - b->vx[c], b->uy[c] - b->vy[c], b->uz[c] - b->vz[c]},
                         q[4] = {part->q[0], part->q[DEM_CLUMP_LANES], part->q[2*DEM_CLUMP_LANES],
                                 part->q[3*DEM_CLUMP_LANES]};
            double along[3];

            dem_clump_rotate_back(q, slip, along);
            dem_clump_form_along(form, along, &b->crosswise[c], &b->lengthwise[c]);
        }
        else
        {
            b->crosswise[c] = b->lengthwise[c] = 1.0;
        }
    }
}

void dem_clump_batch_take(const struct dem_clump_flow *f, struct dem_body_workspace *work,
                          const struct dem_particles *p, size_t first, int rows)
{
    struct dem_body_batch *const b = &work->batch;
    const int reacts = dem_column(p, DEM_COLUMN_OTHER_IMPULSE) != NULL,
              turns = dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE) != NULL;
    double *const force[3] = {b->fx, b->fy, b->fz}, *const reaction[3] = {b->rx, b->ry, b->rz},
           *const target[3] = {b->drag_ux, b->drag_uy, b->drag_uz}, *const v[3] = {b->vx, b->vy, b->vz},
           *const spin_target[3] = {b->spin_drag_wx, b->spin_drag_wy, b->spin_drag_wz};

    for (int c = 0; c < rows; c++)
    {
        struct dem_clump_flow_row *const r = &f->row[first + (size_t)c];
        const double w = f->part[first + (size_t)c].share;

        if (!f->part[first + (size_t)c].form)
        {
            continue;
        }
        for (int a = 0; a < 3; a++)
        {
            r->force[a] += w*force[a][c];
            r->reaction[a] = reacts ? w*reaction[a][c] : 0.0;
            r->slip_force[a] = w*(target[a][c] - b->drag[c]*v[a][c]);
            r->spin_torque[a] =
                turns ? w*(spin_target[a][c] - b->spin_drag[c]*p->record[first + (size_t)c].w[a]) : 0.0;
            force[a][c] = reaction[a][c] = target[a][c] = spin_target[a][c] = 0.0;
        }
        r->drag = w*b->drag[c];
        r->particle_drag = w*work->particle_drag[c];
        r->spin_drag = turns ? w*b->spin_drag[c] : 0.0;
        b->drag[c] = work->particle_drag[c] = b->spin_drag[c] = 0.0;
    }
}

void dem_clump_batch_contacts(const struct dem_clumps *c, const struct dem_contact_sum *sum, size_t first, int rows)
{
    _Static_assert(sizeof *sum == sizeof *c->contact, "clump.h has the numbers of a sum");
    memcpy(c->contact + first, sum, (size_t)rows*sizeof *sum);
}

int dem_index_clumps(struct dem_state *state)
{
    struct dem_clumps *const c = &state->clumps;

    DEM_TRY(dem_clumps_index(c, &state->particles));
    DEM_TRY(c->flow ? dem_clump_flow_index(c->flow, c, &state->particles) : DEM_OK);
    DEM_TRY(c->flow && state->energy_balance->open
                ? dem_clump_energy_reserve(c->flow, c, &state->interaction_table.bodies, state->particles.n)
                : DEM_OK);
    return c->heat ? DEM_GROW(c->heat->row, c->heat->capacity, state->particles.n + 1) : DEM_OK;
}

int dem_kick_clumps(struct dem_state *state, struct dem_particles *p, const struct dem_body_sweep *s)
{
    struct dem_clumps *const c = &state->clumps;
    double gravity[3];

    if (c->flow && s->energy_balance)
    {
        dem_clump_energy_before(c, p);
        dem_clump_flow_kick(c->flow, c, p, s->kick);
        dem_clump_energy_after(s->energy_balance, &state->interaction_table.bodies, c, p, s->kick, s->window);
    }
    else if (c->flow)
    {
        dem_clump_flow_kick(c->flow, c, p, s->kick);
    }
    else
    {
        dem_interaction_table_gravity(&state->interaction_table, gravity);
        dem_clumps_kick(c, p, gravity, s->kick);
    }
    return c->heat && s->scalars.h > 0.0 ? dem_clump_heat_integrate(c, &s->scalars, p) : 0;
}
