/*
 * clump_energy.c -- work of a fluid on rigid bodies of several spheres (formulas: clump_energy.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/clump_energy.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "particles/clump_lanes.h"
#include <string.h>

struct motion    /* of a body in a kick */
{
    struct dem_clump_flow_sums sums;
    double v[3], w[3];    /* m/s, 1/s  v_m, w_m */
    double turned[3];     /* N m s  A + S */
    double spun[3];       /* N m s  S */
};

int dem_clump_energy_reserve(struct dem_clump_flow *f, const struct dem_clumps *c,
                             const struct dem_effect_list *effects, size_t n)
{
    DEM_TRY(DEM_GROW(f->sums, f->sums_capacity, c->groups*DEM_CLUMP_LANES + 1));
    DEM_TRY(DEM_GROW(f->own, f->own_capacity, 3*n*(size_t)effects->entries + 1));
    return DEM_GROW(f->before, f->before_capacity, 6*n + 1);
}

/* The force of entry e on sphere i. */
static double *own_force(const struct dem_clump_flow *f, const struct dem_effect_list *effects, size_t i, int e)
{
    return f->own + 3*(i*(size_t)effects->entries + (size_t)e);
}

void dem_clump_energy_take(const struct dem_clump_flow *f, const struct dem_energy_balance *l,
                           const struct dem_effect_list *effects, size_t first, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        const size_t i = first + (size_t)c;

        for (int e = 0; e < effects->entries && f->part[i].form; e++)
        {
            for (int a = 0; a < 3; a++)
            {
                own_force(f, effects, i, e)[a] = f->part[i].share*l->scratch->own[e][a][c];
            }
        }
    }
}

void dem_clump_energy_before(const struct dem_clumps *c, const struct dem_particles *p)
{
    for (size_t body = 0; body < c->n; body++)
    {
        struct dem_clump b;

        dem_clumps_body(c, body, p, &b);
        memcpy(c->flow->before + 6*body, b.v, sizeof b.v);
        memcpy(c->flow->before + 6*body + 3, b.momentum, sizeof b.momentum);
    }
}

static void find_motion(const struct dem_clumps *c, size_t body, const struct dem_particles *p, double h,
                        struct motion *m)
{
    const double *const before = c->flow->before + 6*body;
    struct dem_clump mean;
    double slip[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 0.0};    /* N m  moments of d_k, t_k (o_k - w) */

    dem_clumps_body(c, body, p, &mean);
    m->sums = c->flow->sums[c->place[body]];
    for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
    {
        const struct dem_clump_flow_row *const r = &c->flow->row[c->member[k]];
        double arm[3], moment[3];

        dem_clumps_arm(c, body, k - c->start[body], arm);
        dem_vec_cross(arm, r->slip_force, moment);
        for (int a = 0; a < 3; a++)
        {
            slip[a] += moment[a];
            spin[a] += c->flow->rest[c->member[k]].spin_torque[a];
        }
    }
    for (int a = 0; a < 3; a++)
    {
        m->turned[a] = mean.momentum[a] - before[3 + a] - h*(m->sums.torque[a] - slip[a] - spin[a]);
        m->spun[a] = h*m->sums.phi_spin*spin[a];
        m->v[a] = 0.5*(mean.v[a] + before[a]);
        mean.momentum[a] = 0.5*(mean.momentum[a] + before[3 + a]);
    }
    dem_clump_spin(&mean, m->w);
}

/* v_k of entry k of c->member. */
static void velocity_of(const struct motion *m, const struct dem_clumps *c, size_t body, size_t k, double v[3])
{
    double turning[3], arm[3];

    dem_clumps_arm(c, body, k - c->start[body], arm);
    dem_vec_cross(m->w, arm, turning);
    for (int a = 0; a < 3; a++)
    {
        v[a] = m->v[a] + turning[a];
    }
}

/* Drag, and the impulse carried over from the last exchange. */
static void add_drag(struct dem_sum *sum, const struct motion *m, const struct dem_clumps *c, size_t body,
                     const struct dem_particles *p, double h, double window)
{
    double kept = dem_vec_dot(m->turned, m->w) - dem_vec_dot(m->spun, m->w), work = 0.0, carried = 0.0;

    for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
    {
        const size_t i = c->member[k];
        double J[3], v[3];

        dem_clump_flow_drag(&c->flow->row[i], &m->sums, h, J);
        velocity_of(m, c, body, k, v);
        kept += dem_vec_dot(J, m->v);
        work += dem_vec_dot(J, dem_column(p, DEM_COLUMN_FLUID_VELOCITY) + 3*i);
        carried += window > 0.0
                       ? h/window*dem_vec_dot(dem_column(p, DEM_COLUMN_CARRIED_OVER_IMPULSE) + 3*i, v)
                       : 0.0;
    }
    dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK], work);
    dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK], carried);
    dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_LOST], work - kept);
}

void dem_clump_energy_after(struct dem_energy_balance *l, const struct dem_effect_list *effects,
                            const struct dem_clumps *c, const struct dem_particles *p, double h, double window)
{
    for (size_t body = 0; body < c->n; body++)
    {
        struct motion m;

        if (dem_clumps_frozen(c, body, p))
        {
            continue;
        }
        find_motion(c, body, p, h, &m);
        for (int e = 0; e < effects->entries; e++)
        {
            const struct dem_effect *const effect = effects->entry[e].effect;
            struct dem_sum *const sum = dem_energy_balance_sums_of(l, effect);

            for (size_t k = c->start[body]; k < c->start[body + 1] && !effect->uniform_acceleration; k++)
            {
                double v[3];

                velocity_of(&m, c, body, k, v);
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK],
                                       h*dem_vec_dot(own_force(c->flow, effects, c->member[k], e), v));
            }
            if (effect->drag)
            {
                add_drag(sum, &m, c, body, p, h, window);
            }
            if (effect->has_rotational_drag)
            {
                dem_energy_balance_add(&sum[DEM_ENERGY_BALANCE_WORK], dem_vec_dot(m.spun, m.w));
            }
        }
    }
}
