/*
 * sweep_contacts.c -- gather -> each effect of the class in the order of stages -> one push per row.
 *
 * With n from j to i, the contact point lies at x_i - a_i n and x_j + a_j n, so with T = n x F the torque is -a T on
 * both sides. The arms are R - overlap/2 at a pair (their sum is the distance, which conserves angular momentum) and
 * R - overlap at a wall (the contact point lies on the wall).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sweep_contacts.h"
#include "base/math.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum
{
    LANES = 8
};

struct gathered                                           /* what the geometry of a block is computed from */
{
    _Alignas(64) double rx[DEM_BLOCK], ry[DEM_BLOCK], rz[DEM_BLOCK];          /* m    from j (or the wall's point) to i */
    _Alignas(64) double vx[DEM_BLOCK], vy[DEM_BLOCK], vz[DEM_BLOCK];          /* m/s  v_i - v_j */
    _Alignas(64) double ax[DEM_BLOCK], ay[DEM_BLOCK], az[DEM_BLOCK];          /* m/s  R_i w_i + R_j w_j */
    _Alignas(64) double bx[DEM_BLOCK], by[DEM_BLOCK], bz[DEM_BLOCK];          /* 1/s  share (w_i + w_j) */
    _Alignas(64) double radii[DEM_BLOCK];                                     /* m    R_i + R_j */
    _Alignas(64) double inverse_mass[DEM_BLOCK];                              /* 1/kg summed */
    _Alignas(64) double product[DEM_BLOCK];                                   /* m2   R_i R_j */
    _Alignas(64) double least[DEM_BLOCK];                                     /* m    the smaller radius */
    _Alignas(64) double unused[DEM_BLOCK];                                    /* fourth members nobody needs */
};

struct tray
{
    struct dem_block block;
    struct gathered g;
};

/* ---- gathering ----------------------------------------------------------------------------------------------- */

/* Four members of a record that lie side by side, e.g. {x, y, z, radius}. The rows of four pairs turn into columns in
   registers: several times faster than number by number, and the same bits. */
typedef double quad __attribute__((vector_size(32), aligned(16), may_alias));

/* A quad in memory; not a function, because a vector returned has no fixed calling convention without AVX. */
#define QUAD(from) (*(const quad *)(const void *)(from))

__attribute__((always_inline)) static inline void columns(const quad *row, double *x, double *y, double *z, double *w)
{
    const quad a = __builtin_shufflevector(row[0], row[1], 0, 4, 2, 6), b = __builtin_shufflevector(row[0], row[1], 1, 5, 3, 7);
    const quad c = __builtin_shufflevector(row[2], row[3], 0, 4, 2, 6), d = __builtin_shufflevector(row[2], row[3], 1, 5, 3, 7);

    *(quad *)(void *)x = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    *(quad *)(void *)y = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    *(quad *)(void *)z = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    *(quad *)(void *)w = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

DEM_KERNEL
static void gather_pairs(struct tray *restrict t, const struct dem_pair *pair, const struct dem_particle *record,
                         double shift[DEM_SHIFTS][4], const uint32_t *restrict row_pair)
{
    const quad less = {-1.0, -1.0, -1.0, 1.0}, half = {0.5, 0.5, 0.5, 0.5};
    struct gathered *const g = &t->g;

    for (int c = 0; c < t->block.n; c += 4)
    {
        quad r[4], v[4], a[4], b[4], w[4];

        for (int k = 0; k < 4; k++)
        {
            const struct dem_pair *const q = &pair[row_pair[c + k]];
            const struct dem_particle *const i = &record[q->i], *const j = &record[q->j];
            const quad wi = QUAD(i->w), wj = QUAD(j->w);
            const quad ri = {i->radius, i->radius, i->radius, i->radius}, rj = {j->radius, j->radius, j->radius, j->radius};

            r[k] = QUAD(i->x) + less*QUAD(j->x) + QUAD(shift[q->shift]);      /* x_i - x_j + shift, R_i + R_j */
            v[k] = QUAD(i->v) + less*QUAD(j->v);                              /* v_i - v_j, 1/m_i + 1/m_j */
            a[k] = ri*wi + rj*wj;
            b[k] = half*(wi + wj);
            w[k] = wi - wj;
            g->product[c + k] = i->radius*j->radius;
            g->least[c + k] = dem_pick(i->radius < j->radius, i->radius, j->radius);
            t->block.viscosity[c + k] = 0.5*(i->viscosity + j->viscosity);
        }
        columns(r, g->rx + c, g->ry + c, g->rz + c, g->radii + c);
        columns(v, g->vx + c, g->vy + c, g->vz + c, g->inverse_mass + c);
        columns(a, g->ax + c, g->ay + c, g->az + c, g->unused + c);
        columns(b, g->bx + c, g->by + c, g->bz + c, g->unused + c);
        columns(w, t->block.wx + c, t->block.wy + c, t->block.wz + c, g->unused + c);
    }
}

static void gather_walls(struct tray *t, const struct dem_parts *p, const uint32_t *row_pair)
{
    struct gathered *const g = &t->g;
    struct dem_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[row_pair[c]];
        const struct dem_particle *const i = &p->particles.record[q->i];
        const struct dem_wall_touch *const at = &p->touches.touch[q->j];
        /* past the plane of a one-sided wall the distance is negative and n still points into the room */
        const double distance = at->distance < 4.0*i->radius ? at->distance : 4.0*i->radius;

        g->rx[c] = distance*at->normal[0];
        g->ry[c] = distance*at->normal[1];
        g->rz[c] = distance*at->normal[2];
        b->nx[c] = at->normal[0];
        b->ny[c] = at->normal[1];
        b->nz[c] = at->normal[2];
        b->overlap[c] = i->radius - distance;
        g->vx[c] = i->v[0];
        g->vy[c] = i->v[1];
        g->vz[c] = i->v[2];
        g->ax[c] = i->radius*i->w[0];
        g->ay[c] = i->radius*i->w[1];
        g->az[c] = i->radius*i->w[2];
        g->bx[c] = i->w[0];
        g->by[c] = i->w[1];
        g->bz[c] = i->w[2];
        g->inverse_mass[c] = i->inverse_mass;
        g->least[c] = i->radius;
        b->reduced_radius[c] = i->radius;
        b->wx[c] = i->w[0];
        b->wy[c] = i->w[1];
        b->wz[c] = i->w[2];
        b->viscosity[c] = i->viscosity;
    }
}

/* ---- geometry ------------------------------------------------------------------------------------------------ */

DEM_KERNEL
static void normals_of_pairs(struct dem_block *restrict b, const struct gathered *restrict g)
{
    const double half = 0.5*b->dt;

    for (int c = 0; c < b->n; c++)
    {
        const double rx = g->rx[c], ry = g->ry[c], rz = g->rz[c];
        const double hx = rx - half*g->vx[c], hy = ry - half*g->vy[c], hz = rz - half*g->vz[c];
        const double r2 = rx*rx + ry*ry + rz*rz, h2 = hx*hx + hy*hy + hz*hz;
        const double r = sqrt(r2), h = sqrt(h2), over = 1.0/dem_pick(r > 0.0, r, 1.0), over_half = 1.0/dem_pick(h > 0.0, h, 1.0);

        /* coincident centres: any fixed direction will do, as long as all ranks take the same */
        b->nx[c] = dem_pick(r > 0.0, rx*over, 1.0);
        b->ny[c] = ry*over;
        b->nz[c] = rz*over;
        b->hx[c] = dem_pick(h > 0.0, hx*over_half, 1.0);
        b->hy[c] = hy*over_half;
        b->hz[c] = hz*over_half;
        b->overlap[c] = g->radii[c] - r;
        b->reduced_radius[c] = g->product[c]/g->radii[c];
    }
}

/* The foot of the particle moves along a wall with it: the normal of half a step ago is today's. */
static void normals_of_walls(struct dem_block *b)
{
    memcpy(b->hx, b->nx, sizeof b->hx);
    memcpy(b->hy, b->ny, sizeof b->hy);
    memcpy(b->hz, b->nz, sizeof b->hz);
}

DEM_KERNEL
static void relative_motion(struct dem_block *restrict b, const struct gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        const double raw = b->overlap[c], touch = dem_pick(raw > 0.0, 1.0, 0.0), overlap = dem_pick(raw > 0.0, raw, 0.0);
        const double hx = b->hx[c], hy = b->hy[c], hz = b->hz[c];
        const double along = g->vx[c]*hx + g->vy[c]*hy + g->vz[c]*hz;
        const double ax = g->ax[c] - overlap*g->bx[c], ay = g->ay[c] - overlap*g->by[c], az = g->az[c] - overlap*g->bz[c];
        const double sum = g->inverse_mass[c];

        b->overlap[c] = overlap;
        b->touching[c] = touch;
        b->reduced_mass[c] = 1.0/sum;
        b->vn[c] = g->vx[c]*b->nx[c] + g->vy[c]*b->ny[c] + g->vz[c]*b->nz[c];
        b->sx[c] = g->vx[c] - along*hx - (ay*hz - az*hy);
        b->sy[c] = g->vy[c] - along*hy - (az*hx - ax*hz);
        b->sz[c] = g->vz[c] - along*hz - (ax*hy - ay*hx);
        b->kn[c] = b->kt[c] = b->eta[c] = 0.0;
        b->fn[c] = b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
        b->mx[c] = b->my[c] = b->mz[c] = 0.0;
    }
}

/* Lanes past the last row repeat it, so that every lane is as good as a real one. */
static void pad(struct tray *t, const uint32_t *row_pair, int rows, uint32_t *padded)
{
    t->block.n = (rows + LANES - 1)/LANES*LANES;
    for (int c = 0; c < t->block.n; c++)
    {
        padded[c] = row_pair[c < rows ? c : rows - 1];
    }
}

/* ---- results ------------------------------------------------------------------------------------------------- */

DEM_KERNEL
static void forget_apart(const struct dem_block *restrict b, double *restrict memory)
{
    for (int c = 0; c < b->n; c++)
    {
        memory[c] = dem_pick(b->touching[c] > 0.0, memory[c], 0.0);
    }
}

DEM_KERNEL
static void push_out(const struct dem_block *restrict b, int rows, double share, int past_touching,
                     struct dem_push *restrict push)
{
    for (int c = 0; c < rows; c++)
    {
        const double on = past_touching ? 1.0 : b->touching[c];
        const double nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
        const double fx = on*b->fx[c], fy = on*b->fy[c], fz = on*b->fz[c], fn = on*b->fn[c];

        push[c].f[0] = fn*nx + fx;
        push[c].f[1] = fn*ny + fy;
        push[c].f[2] = fn*nz + fz;
        push[c].arm = share*b->overlap[c];
        push[c].t[0] = ny*fz - nz*fy;
        push[c].t[1] = nz*fx - nx*fz;
        push[c].t[2] = nx*fy - ny*fx;
    }
}

/* Largest overlap of the smaller diameter; a force that is not a number comes out above every limit. */
DEM_KERNEL
static double worst_of(const struct dem_block *restrict b, const struct gathered *restrict g)
{
    double most[LANES] = {0.0}, bad[LANES] = {0.0}, worst = 0.0;

    for (int c = 0; c < b->n; c += LANES)
    {
        for (int k = 0; k < LANES; k++)
        {
            const double share = 0.5*b->overlap[c + k]/g->least[c + k];

            most[k] = dem_pick(share > most[k], share, most[k]);
            bad[k] += (b->fn[c + k] + b->fx[c + k] + b->fy[c + k] + b->fz[c + k])*0.0;
        }
    }
    for (int k = 0; k < LANES; k++)
    {
        worst = most[k] > worst ? most[k] : worst;
        worst = bad[k] == 0.0 ? worst : 1e30;
    }
    return worst;
}

/* Remember the worst row so far, and who it is. */
static void note_worst(struct dem_parts *p, const struct tray *t, const uint32_t *row_pair)
{
    const double worst = worst_of(&t->block, &t->g);
    int lane = 0;

    if (worst <= p->watch.overlap)
    {
        return;
    }
    for (int c = 0; c < t->block.n; c++)
    {
        const double force = t->block.fn[c] + t->block.fx[c] + t->block.fy[c] + t->block.fz[c];

        lane = force*0.0 != 0.0 || 0.5*t->block.overlap[c]/t->g.least[c] == worst ? c : lane;
    }
    const struct dem_pair *const q = &p->contacts.pair[row_pair[lane]];
    const struct dem_particle *const i = &p->particles.record[q->i];

    p->watch.overlap = worst;
    p->watch.i = i->id;
    p->watch.j = q->wall ? -1 - p->pairs.wall_region[q->j] : p->particles.record[q->j].id;
    memcpy(p->watch.x, i->x, sizeof i->x);
}

/* ---- the sweep ----------------------------------------------------------------------------------------------- */

static void act(struct tray *t, const struct dem_chain *chain, const struct dem_contacts *c, uint32_t row)
{
    double *memory[DEM_MEMORY_COLUMNS];

    for (int k = 0; k < chain->links; k++)
    {
        const struct dem_link *const link = &chain->link[k];
        const int memories = dem_effect_memories(link->effect);

        for (int m = 0; m < memories; m++)
        {
            memory[m] = c->memory[link->memory + m] + row;
        }
        link->effect->act(link->settings, &t->block, memory);
        for (int m = 0; m < memories && link->effect->stage < DEM_STAGE_BOND; m++)
        {
            forget_apart(&t->block, memory[m]);
        }
    }
}

static void keep_moments(struct dem_contacts *c, const struct dem_block *b, uint32_t row, int rows)
{
    for (int k = 0; k < rows; k++)
    {
        double *const m = c->moment + 3*(row + (uint32_t)k);

        m[0] = b->mx[k];
        m[1] = b->my[k];
        m[2] = b->mz[k];
    }
}

static void sweep_block(struct dem_parts *p, struct tray *t, const struct dem_chain *chain, uint32_t row, int rows)
{
    uint32_t padded[DEM_BLOCK];
    const int wall = chain->pair.with_wall;

    pad(t, p->contacts.row_pair + row, rows, padded);
    if (wall)
    {
        gather_walls(t, p, padded);
        normals_of_walls(&t->block);
    }
    else
    {
        gather_pairs(t, p->contacts.pair, p->particles.record, p->pairs.shift, padded);
        normals_of_pairs(&t->block, &t->g);
    }
    relative_motion(&t->block, &t->g);
    act(t, chain, &p->contacts, row);
    push_out(&t->block, rows, wall ? 1.0 : 0.5, chain->past_touching, p->contacts.push + row);
    if (p->contacts.moment)
    {
        keep_moments(&p->contacts, &t->block, row, rows);
    }
    note_worst(p, t, padded);
}

/* Who touches whom, in words. */
static void culprits(const struct dem_parts *p, char *text, size_t size)
{
    const struct dem_watch *const w = &p->watch;

    if (w->j < 0)
    {
        snprintf(text, size, "particle %lld and wall %s", (long long)w->i, p->walls.wall[p->walls.region[-1 - w->j].wall].name);
    }
    else
    {
        snprintf(text, size, "particles %lld and %lld", (long long)w->i, (long long)w->j);
    }
}

static int judge(const struct dem_parts *p)
{
    const struct dem_watch *const w = &p->watch;
    char who[160];

    if (w->overlap <= w->limit)
    {
        return DEM_OK;
    }
    culprits(p, who, sizeof who);
    DEM_REQUIRE(w->overlap < 1e29, DEM_ERROR_NUMBER,
                "the force between %s near (%g %g %g) m is not a number at step %lld; look at their input, or at the fluid "
                "around them", who, w->x[0], w->x[1], w->x[2], (long long)p->steps);
    return dem_error(DEM_ERROR_NUMBER, "%s near (%g %g %g) m overlap by %.3g of a diameter at step %lld, the limit is %g; use a "
                     "smaller step or a stiffer material, or raise time/maxOverlap", who, w->x[0], w->x[1], w->x[2], w->overlap,
                     (long long)p->steps, w->limit);
}

int dem_sweep_contacts(struct dem_parts *p, double dt)
{
    struct tray t;

    memset(&t, 0, sizeof t);
    t.block.dt = dt;
    dem_wall_touches_update(&p->touches, &p->pairs.search, &p->walls, &p->particles);
    for (int s = 0; s < p->contacts.classes; s++)
    {
        const struct dem_segment *const seg = &p->contacts.segment[s];

        for (uint32_t done = 0; done < seg->count; done += DEM_BLOCK)
        {
            const uint32_t left = seg->count - done;

            sweep_block(p, &t, &p->recipe.chain[s], seg->first + done, left < DEM_BLOCK ? (int)left : DEM_BLOCK);
        }
    }
    return judge(p);
}

/* ---- the sum ------------------------------------------------------------------------------------------------- */

static void sum_moments(const struct dem_contacts *c, uint32_t first, uint32_t end, double t[3])
{
    for (uint32_t e = first; e < end; e++)
    {
        const double side = c->near_entry[e] & 1 ? -1.0 : 1.0;
        const double *const m = c->moment + 3*(c->near_entry[e] >> 1);

        t[0] += side*m[0];
        t[1] += side*m[1];
        t[2] += side*m[2];
    }
}

void dem_sweep_sum(struct dem_particles *p, const struct dem_contacts *c)
{
    double *const force = dem_column(p, DEM_COLUMN_FORCE), *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    const uint32_t *const entry = c->near_entry;

    for (size_t i = 0; i < p->n; i++)
    {
        const double radius = p->record[i].radius;
        const uint32_t first = c->near_start[i], end = c->near_start[i + 1];
        double fx = 0.0, fy = 0.0, fz = 0.0, t[3] = {0.0, 0.0, 0.0};

        for (uint32_t e = first; e < end; e++)
        {
            const struct dem_push *const push = &c->push[entry[e] >> 1];
            const double side = 1.0 - 2.0*(double)(entry[e] & 1), arm = push->arm - radius;

            fx += side*push->f[0];
            fy += side*push->f[1];
            fz += side*push->f[2];
            t[0] += arm*push->t[0];
            t[1] += arm*push->t[1];
            t[2] += arm*push->t[2];
        }
        if (c->moment)
        {
            sum_moments(c, first, end, t);
        }
        force[3*i] = fx;
        force[3*i + 1] = fy;
        force[3*i + 2] = fz;
        memcpy(torque + 3*i, t, sizeof t);
    }
}
