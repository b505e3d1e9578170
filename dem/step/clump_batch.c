/*
 * clump_batch.c -- spheres of rigid bodies in a batch of particles: the volume-equivalent sphere for the
 * effects, and shares of their results for the kick of the bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_batch.h"
#include "core/error.h"
#include "core/memory.h"
#include "step/clump_energy.h"
#include "step/clump_heat.h"

void dem_clump_batch_begin(struct dem_clump_flow *f, struct dem_body_workspace *work,
                           const struct dem_particles *p, size_t first, int rows, double over_window)
{
    const double *const carried = dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE);
    struct dem_body_batch *const b = &work->batch;

    for (int c = 0; c < rows; c++)
    {
        const size_t i = first + (size_t)c;
        const struct dem_clump *const body = dem_clump_of(p, i);

        if (!body)
        {
            continue;
        }
        const struct dem_clump_form *const form = dem_clump_flow_form(f, p, i);
        const double slip[3] = {b->ux[c] - b->vx[c], b->uy[c] - b->vy[c], b->uz[c] - b->vz[c]};
        double along[3];

        f->row[i] = (struct dem_clump_flow_row){.share = p->record[i].mass/body->mass};
        f->row[i].surface = f->row[i].share/form->sphericity;
        for (size_t a = 0; a < 3; a++)
        {
            f->row[i].force[a] = over_window*carried[3*i + a];
        }
        b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
        b->radius[c] = form->radius;
        b->volume[c] = form->volume;
        b->mass[c] = body->mass;
        b->sphericity[c] = form->sphericity;
        dem_clump_rotate_back(body->q, slip, along);
        dem_clump_form_along(form, along, &b->crosswise[c], &b->lengthwise[c]);
    }
}

void dem_clump_batch_take(struct dem_clump_flow *f, struct dem_body_workspace *work,
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
        const double w = r->share;

        if (!p->record[first + (size_t)c].body)
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

int dem_index_clumps(struct dem_state *state)
{
    struct dem_clumps *const c = &state->clumps;
    const size_t n = state->particles.n;

    DEM_TRY(c->flow ? dem_clump_flow_reserve(c->flow, n) : DEM_OK);
    DEM_TRY(c->flow && state->energy_balance->open
                ? dem_clump_energy_reserve(c->flow, &state->interaction_table.bodies, n)
                : DEM_OK);
    DEM_TRY(c->heat ? DEM_GROW(c->heat->row, c->heat->capacity, n + 1) : DEM_OK);
    return dem_clumps_index(c, &state->particles);
}

int dem_kick_clumps(const struct dem_state *state, struct dem_particles *p, const struct dem_body_sweep *s)
{
    const struct dem_clumps *const c = &state->clumps;
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
