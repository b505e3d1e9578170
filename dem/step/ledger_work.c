/*
 * ledger_work.c -- the work of gravity, of walls that move and of body forces.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/vec.h"
#include "step/ledger.h"
#include "step/parts.h"
#include "step/wall_kind.h"
#include <string.h>

static void fall(struct dem_parts *p, double dt)
{
    const double *const g = p->ledger.gravity;

    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const r = &p->particles.record[i];

        dem_ledger_add(&p->ledger.sum[DEM_LEDGER_FALL], r->mass*dem_vec_dot(g, r->v)*dt);
    }
}

/* The forces of the last sweep for `span` of the drift: the one behind, or the one ahead, which then is the walls' last. */
static void walls(struct dem_parts *p, double span, int ahead)
{
    const struct dem_contacts *const c = &p->contacts;
    struct dem_wall_kind kind;

    for (int s = 0; s < c->classes && c->rows > 0 && !p->walls.plain; s++)
    {
        const uint32_t first = c->segment[s].first;
        const uint32_t end = first + (p->recipe.chain[s].pair.with_wall ? c->segment[s].count : 0);

        for (uint32_t r = first; r < end; r++)
        {
            const struct dem_pair *const q = &c->pair[c->row_pair[r]];
            const struct dem_push push = dem_contacts_push(c, r);
            const double *const f = push.f;

            dem_wall_kind_motion(&p->walls, p->pairs.wall_region[q->j], &p->touches.touch[q->j], ahead, &kind);
            if (dem_wall_kind_drifts(p, q->j))
            {
                dem_wall_kind_add_drift(p, q->j, p->dt, &kind);
            }
            const double power = dem_vec_dot(f, kind.velocity) + (c->moments ? dem_vec_dot(c->moment + 3*r, kind.spin) : 0.0);

            dem_ledger_add(&p->ledger.sum[DEM_LEDGER_WALLS], power*span);
        }
    }
}

void dem_ledger_drift(struct dem_parts *p, double dt)
{
    fall(p, dt);
    walls(p, 0.5*dt, 1);
}

void dem_ledger_swept(struct dem_parts *p, double dt)
{
    walls(p, 0.5*dt, 0);
}

/* Outside it mostly flies. */
void dem_ledger_leaves(struct dem_parts *p, const struct dem_particle *r, double late)
{
    const double inertia = 0.4*r->mass*r->radius*r->radius;
    double v[3];

    for (int k = 0; k < 3; k++)
    {
        v[k] = r->v[k] + late*r->mass*r->inverse_mass*p->ledger.gravity[k];
    }
    dem_ledger_add(&p->ledger.sum[DEM_LEDGER_LEFT], 0.5*r->mass*dem_vec_dot(v, v) + 0.5*inertia*dem_vec_dot(r->w, r->w));
}

void dem_ledger_comes(struct dem_parts *p, const struct dem_particle *r)
{
    const double inertia = 0.4*r->mass*r->radius*r->radius;

    dem_ledger_add(&p->ledger.sum[DEM_LEDGER_CAME], 0.5*r->mass*dem_vec_dot(r->v, r->v) + 0.5*inertia*dem_vec_dot(r->w, r->w));
}

/* ---- bodies -------------------------------------------------------------------------------------------------- */

void dem_ledger_body_before(struct dem_ledger *l, const struct dem_body_block *b)
{
    for (int c = 0; c < b->n; c++)
    {
        l->scratch->force[0][c] = b->fx[c] + b->rx[c];
        l->scratch->force[1][c] = b->fy[c] + b->ry[c];
        l->scratch->force[2][c] = b->fz[c] + b->rz[c];
    }
}

void dem_ledger_body_after(struct dem_ledger *l, const struct dem_body_block *b, int link)
{
    double (*const own)[DEM_BLOCK] = l->scratch->own[link];

    for (int c = 0; c < b->n; c++)
    {
        own[0][c] = b->fx[c] + b->rx[c] - l->scratch->force[0][c];
        own[1][c] = b->fy[c] + b->ry[c] - l->scratch->force[1][c];
        own[2][c] = b->fz[c] + b->rz[c] - l->scratch->force[2][c];
    }
}

/* Impulse times the fluid's velocity is the fluid's work, the rest is heat; and what the last exchange left for this window. */
static void drag(struct dem_sum *sum, const struct dem_particles *p, const struct dem_ledger_kick *k, int c, const double v[3])
{
    const struct dem_body_block *const b = k->block;
    const double *const pending = dem_column(p, DEM_COLUMN_PENDING) + 3*(k->first + (size_t)c);
    const double j[3] = {k->j[0][c], k->j[1][c], k->j[2][c]}, u[3] = {b->ux[c], b->uy[c], b->uz[c]};
    const double given = dem_vec_dot(j, u), late = k->window > 0.0 ? dem_vec_dot(pending, v)*k->h/k->window : 0.0;

    dem_ledger_add(&sum[DEM_LEDGER_WORK], given + late);
    dem_ledger_add(&sum[DEM_LEDGER_LOST], given - dem_vec_dot(j, v));
}

/* What the added mass takes: -a dv on the mean velocity. */
static double taken_along(const struct dem_particle *r, const struct dem_body_block *b, int c, const double v[3])
{
    const double gain[3] = {b->vx[c] - r->v[0], b->vy[c] - r->v[1], b->vz[c] - r->v[2]};

    return -b->added[c]*dem_vec_dot(gain, v);
}

/* Torque impulse on the mean spin. */
static double turned(const struct dem_particle *r, const struct dem_ledger_kick *k, int c)
{
    const struct dem_body_block *const b = k->block;
    const double w[3] = {0.5*(r->w[0] + b->wx[c]), 0.5*(r->w[1] + b->wy[c]), 0.5*(r->w[2] + b->wz[c])};
    const double turn[3] = {k->turn[0][c], k->turn[1][c], k->turn[2][c]};

    return dem_vec_dot(turn, w);
}

void dem_ledger_kicked(struct dem_ledger *l, const struct dem_particles *p, const struct dem_ledger_kick *k)
{
    for (int e = 0; e < k->bodies->links; e++)
    {
        const struct dem_effect *const effect = k->bodies->link[e].effect;
        struct dem_sum *const sum = dem_ledger_of(l, effect);
        double (*const own)[DEM_BLOCK] = l->scratch->own[e];
        const int potential = strcmp(effect->name, "gravity") == 0;    /* see fall */

        for (int c = 0; c < k->rows && !potential; c++)
        {
            const struct dem_particle *const r = &p->record[k->first + (size_t)c];
            const double v[3] = {0.5*(r->v[0] + k->block->vx[c]), 0.5*(r->v[1] + k->block->vy[c]), 0.5*(r->v[2] + k->block->vz[c])};
            const double f[3] = {own[0][c], own[1][c], own[2][c]};

            if (effect->drag && r->inverse_mass > 0.0)
            {
                drag(sum, p, k, c, v);
            }
            if (effect->inertia)
            {
                dem_ledger_add(&sum[DEM_LEDGER_WORK], taken_along(r, k->block, c, v));
            }
            if (effect->turns)
            {
                dem_ledger_add(&sum[DEM_LEDGER_WORK], turned(r, k, c));
            }
            dem_ledger_add(&sum[DEM_LEDGER_WORK], dem_vec_dot(f, v)*k->h);
        }
    }
}
