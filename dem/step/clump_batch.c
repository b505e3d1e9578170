/*
 * clump_batch.c -- spheres of rigid bodies in a batch of particles: the volume-equivalent sphere for the
 * effects, and shares of their results for the kick of the bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_batch.h"
#include "core/error.h"
#include "core/memory.h"
#include "laws/effect.h"
#include "particles/clump_lanes.h"
#include "step/clump_applied.h"
#include "step/clump_energy.h"
#include "step/clump_heat.h"
#include <string.h>

/* The slip in the principal axes of the bodies, q by columns. */
DEM_KERNEL
static void turn_slips(const struct dem_body_batch *restrict b, double q[4][DEM_BATCH_ROWS], int rows,
                       double along[3][DEM_BATCH_ROWS])
{
    for (int c = 0; c < rows; c++)
    {
        const double slip[3] = {b->ux[c] - b->vx[c], b->uy[c] - b->vy[c], b->uz[c] - b->vz[c]},
                     of[4] = {q[0][c], q[1][c], q[2][c], q[3][c]};
        double turned[3];

        dem_quaternion_rotate(of, -1.0, slip, turned);
        along[0][c] = turned[0];
        along[1][c] = turned[1];
        along[2][c] = turned[2];
    }
}

void dem_clump_batch_begin(const struct dem_clump_flow *f, struct dem_body_workspace *work, size_t first, int rows,
                           int forms)
{
    static const double upright[4] = {1.0, 0.0, 0.0, 0.0};
    struct dem_body_batch *const b = &work->batch;
    _Alignas(64) double q[4][DEM_BATCH_ROWS], along[3][DEM_BATCH_ROWS];
    int which[DEM_BATCH_ROWS];

    for (int c = 0; c < rows; c++)
    {
        const struct dem_clump_part *const part = &f->part[first + (size_t)c];
        const double *const turned = part->form ? part->q : upright;

        which[c] = part->which;
        for (int a = 0; a < 4; a++)
        {
            q[a][c] = turned[a];
        }
        if (part->form)
        {
            b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
            b->radius[c] = part->form->radius;
            b->volume[c] = part->form->volume;
            b->mass[c] = part->mass;
            b->sphericity[c] = part->form->sphericity;
        }
    }
    if (forms)
    {
        turn_slips(b, q, rows, along);
        dem_clump_forms_along(f->form, which, along, rows, b->crosswise, b->lengthwise);
    }
}

/* The columns of struct dem_clump_flow_row; in the batch they are cleared, but for single spheres, of share 0. */
DEM_KERNEL
static void take_shares(struct dem_body_workspace *restrict work, const double *restrict share,
                        const double *restrict carried, double over_window, int rows, double to[8][DEM_BATCH_ROWS])
{
    struct dem_body_batch *const b = &work->batch;

    for (int c = 0; c < rows; c++)
    {
        const double w = share[c];

        to[0][c] = over_window*carried[3*c] + w*b->fx[c];
        to[1][c] = over_window*carried[3*c + 1] + w*b->fy[c];
        to[2][c] = over_window*carried[3*c + 2] + w*b->fz[c];
        to[3][c] = w*b->drag[c];
        to[4][c] = w*(b->drag_ux[c] - b->drag[c]*b->vx[c]);
        to[5][c] = w*(b->drag_uy[c] - b->drag[c]*b->vy[c]);
        to[6][c] = w*(b->drag_uz[c] - b->drag[c]*b->vz[c]);
        to[7][c] = w*work->particle_drag[c];
    }
    for (int c = 0; c < rows; c++)
    {
        const int body = share[c] > 0.0;

        b->fx[c] = dem_select(body, 0.0, b->fx[c]);
        b->fy[c] = dem_select(body, 0.0, b->fy[c]);
        b->fz[c] = dem_select(body, 0.0, b->fz[c]);
        b->drag_ux[c] = dem_select(body, 0.0, b->drag_ux[c]);
        b->drag_uy[c] = dem_select(body, 0.0, b->drag_uy[c]);
        b->drag_uz[c] = dem_select(body, 0.0, b->drag_uz[c]);
        b->drag[c] = dem_select(body, 0.0, b->drag[c]);
        work->particle_drag[c] = dem_select(body, 0.0, work->particle_drag[c]);
    }
}

/* Columns into rows. */
DEM_KERNEL
static void store_rows(double column[8][DEM_BATCH_ROWS], int rows, struct dem_clump_flow_row *restrict row)
{
    for (int half = 0; half < 8; half += 4)
    {
        for (int c = 0; c < rows; c += 4)
        {
            dem_vec4 four[4] = {DEM_VEC4(column[half] + c), DEM_VEC4(column[half + 1] + c),
                                DEM_VEC4(column[half + 2] + c), DEM_VEC4(column[half + 3] + c)};

            dem_transpose4(four);
            for (int k = 0; k < 4 && c + k < rows; k++)
            {
                DEM_VEC4_AT((double *)(void *)(row + c + k) + half) = four[k];
            }
        }
    }
}

/* The same for reactions and rotational drag. */
static void take_rest(const struct dem_clump_flow *f, struct dem_body_batch *b, const struct dem_particles *p,
                      size_t first, int rows)
{
    const int reacts = dem_column(p, DEM_COLUMN_OTHER_IMPULSE) != NULL,
              turns = dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE) != NULL;
    double *const reaction[3] = {b->rx, b->ry, b->rz},
           *const target[3] = {b->spin_drag_wx, b->spin_drag_wy, b->spin_drag_wz};

    for (int c = 0; c < rows && (reacts || turns); c++)
    {
        const size_t i = first + (size_t)c;
        const double w = f->part[i].share;

        for (int a = 0; a < 3 && f->part[i].form; a++)
        {
            f->rest[i].reaction[a] = reacts ? w*reaction[a][c] : 0.0;
            f->rest[i].spin_torque[a] = turns ? w*(target[a][c] - b->spin_drag[c]*p->record[i].w[a]) : 0.0;
            reaction[a][c] = target[a][c] = 0.0;
        }
        if (f->part[i].form)
        {
            f->rest[i].spin_drag = turns ? w*b->spin_drag[c] : 0.0;
            b->spin_drag[c] = 0.0;
        }
    }
}

void dem_clump_batch_take(const struct dem_clump_flow *f, struct dem_body_workspace *work,
                          const struct dem_particles *p, size_t first, int rows, double over_window)
{
    _Alignas(64) double share[DEM_BATCH_ROWS], column[8][DEM_BATCH_ROWS];

    for (int c = 0; c < rows; c++)
    {
        share[c] = f->part[first + (size_t)c].share;
    }
    take_shares(work, share, dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE) + 3*first, over_window, rows, column);
    store_rows(column, rows, f->row + first);
    take_rest(f, &work->batch, p, first, rows);
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
    DEM_TRY(dem_applied_forces_exist(&state->applied_forces) ? DEM_GROW(c->applied, c->applied_capacity, c->n + 1)
                                                             : DEM_OK);
    return c->heat ? DEM_GROW(c->heat->row, c->heat->capacity, state->particles.n + 1) : DEM_OK;
}

int dem_kick_clumps(struct dem_state *state, struct dem_particles *p, const struct dem_body_sweep *s)
{
    struct dem_clumps *const c = &state->clumps;
    double gravity[3];

    if (s->applied)
    {
        dem_clump_applied_add(c, p, s->applied, s->domain, s->time);
    }
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
    if (s->applied && s->energy_balance)
    {
        dem_clump_applied_work(c, p, s->energy_balance, s->kick);
    }
    return c->heat && s->scalars.h > 0.0 ? dem_clump_heat_integrate(c, &s->scalars, p) : 0;
}
