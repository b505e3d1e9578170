/*
 * tray.c -- partners gathered into columns, then normals, overlap and relative motion, all lanes of a block alike.
 *
 * Past touching what geometry.h says holds with the gap as a negative overlap: the two points meet in the middle of the gap, or
 * on the wall. Only classes with effects of the stages BOND and FILM are seen past touching.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/tray.h"
#include "base/math.h"
#include "base/random.h"
#include "step/gather_pairs.h"
#include "step/geometry.h"
#include "step/wall_kind.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* ---- gathering ----------------------------------------------------------------------------------------------- */

static void gather_walls(struct dem_tray *restrict t, const struct dem_parts *p, const uint32_t *restrict row_pair)
{
    struct dem_gathered *const g = &t->g;
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
        g->bx[c] = 2.0*i->w[0];
        g->by[c] = 2.0*i->w[1];
        g->bz[c] = 2.0*i->w[2];
        b->least_radius[c] = i->radius;
        b->reduced_radius[c] = i->radius;
        b->reduced_mass[c] = 1.0/i->inverse_mass;
        b->wx[c] = i->w[0];
        b->wy[c] = i->w[1];
        b->wz[c] = i->w[2];
        b->viscosity[c] = i->viscosity;
    }
}

/* What is different at a wall that moves, is round, or whose surface runs in itself: velocity, spin and, half a step ago,
   normal; curvature. */
static void gather_special(struct dem_tray *restrict t, const struct dem_parts *p, const uint32_t *restrict row_pair)
{
    struct dem_gathered *const g = &t->g;
    struct dem_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[row_pair[c]];
        const struct dem_particle *const i = &p->particles.record[q->i];
        struct dem_wall_kind kind;

        dem_wall_kind_at(&p->walls, p->pairs.wall_region[q->j], i, &p->touches.touch[q->j], b->dt, &kind);
        if (dem_wall_kind_drifts(p, q->j))
        {
            dem_wall_kind_add_drift(p, q->j, b->dt, &kind);
        }
        g->vx[c] -= kind.velocity[0];
        g->vy[c] -= kind.velocity[1];
        g->vz[c] -= kind.velocity[2];
        b->wx[c] -= kind.spin[0];
        b->wy[c] -= kind.spin[1];
        b->wz[c] -= kind.spin[2];
        b->hx[c] = kind.half[0];
        b->hy[c] = kind.half[1];
        b->hz[c] = kind.half[2];
        b->reduced_radius[c] = kind.reduced_radius;
    }
}

/* ---- geometry ------------------------------------------------------------------------------------------------ */

DEM_KERNEL
static void geometry_of_pairs(struct dem_block *restrict b, const struct dem_gathered *restrict g)
{
    dem_geometry_pairs(b, g, b->dt);
}

/* The foot of the particle moves along a flat wall with it: the normal of half a step ago is today's. */
static void normals_of_walls(struct dem_block *b)
{
    memcpy(b->hx, b->nx, sizeof b->hx);
    memcpy(b->hy, b->ny, sizeof b->hy);
    memcpy(b->hz, b->nz, sizeof b->hz);
}

DEM_KERNEL
static void relative_motion(struct dem_block *restrict b, const struct dem_gathered *restrict g, double share)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = {.nx = b->nx[c], .ny = b->ny[c], .nz = b->nz[c], .hx = b->hx[c], .hy = b->hy[c], .hz = b->hz[c],
                            .overlap = b->overlap[c]};

        dem_geometry_motion(g, c, share, &r);
        b->overlap[c] = r.overlap;
        b->touching[c] = r.touching;
        b->vn[c] = r.vn;
        b->sx[c] = r.sx;
        b->sy[c] = r.sy;
        b->sz[c] = r.sz;
        b->swing[c] = r.swing;
        b->kn[c] = b->kt[c] = b->eta[c] = 0.0;
        b->fn[c] = b->fx[c] = b->fy[c] = b->fz[c] = 0.0;
        b->mx[c] = b->my[c] = b->mz[c] = 0.0;
    }
}

/* A wall that turns has a spin, too: what was gathered of the particle less what is left of it relative to the wall. */
static void swing_of_walls(struct dem_tray *t)
{
    struct dem_block *const b = &t->block;
    const struct dem_gathered *const g = &t->g;

    for (int c = 0; c < b->n; c++)
    {
        b->swing[c] += 0.5*((0.5*g->bx[c] - b->wx[c])*b->nx[c] + (0.5*g->by[c] - b->wy[c])*b->ny[c] + (0.5*g->bz[c] - b->wz[c])*b->nz[c]);
    }
}

/* Lanes past the last row repeat it, so that every lane is as good as a real one. */
static void pad(const struct dem_tray *restrict t, const uint32_t *restrict row_pair, int rows, uint32_t *restrict padded)
{
    for (int c = 0; c < t->block.n; c++)
    {
        padded[c] = row_pair[c < rows ? c : rows - 1];
    }
}

/* ---- past touching ------------------------------------------------------------------------------------------- */

/* A region that another one has taken the contact from is still as far away as it is: what was made there goes on. */
static void gaps_of_walls(struct dem_tray *restrict t, const struct dem_parts *p, const uint32_t *restrict row_pair)
{
    struct dem_block *const b = &t->block;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[row_pair[c]];
        const struct dem_wall_touch *const at = &p->touches.touch[q->j];
        const double *const x = p->particles.record[q->i].x;
        const double height = (x[0] - at->point[0])*at->normal[0] + (x[1] - at->point[1])*at->normal[1]
                            + (x[2] - at->point[2])*at->normal[2];

        const int dropped = at->distance > DBL_MAX/2.0;

        b->distance[c] = dropped ? height : at->distance;
        b->gap[c] = b->distance[c] - b->least_radius[c];
        b->counts[c] = dropped ? 0.0 : 1.0;
    }
}

static void gaps_of_pairs(struct dem_tray *t)
{
    struct dem_block *const b = &t->block;
    const struct dem_gathered *const g = &t->g;

    for (int c = 0; c < b->n; c++)
    {
        b->distance[c] = sqrt(g->rx[c]*g->rx[c] + g->ry[c]*g->ry[c] + g->rz[c]*g->rz[c]);
        b->gap[c] = b->distance[c] - g->radii[c];
        b->counts[c] = 1.0;
    }
}

/* Longer arms where there is a gap. */
DEM_KERNEL
static void motion_past_touching(struct dem_block *restrict b, const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        const double gap = dem_pick(b->gap[c] > 0.0, b->gap[c], 0.0);
        const double bx = 0.5*g->bx[c], by = 0.5*g->by[c], bz = 0.5*g->bz[c];

        b->sx[c] -= gap*(by*b->hz[c] - bz*b->hy[c]);
        b->sy[c] -= gap*(bz*b->hx[c] - bx*b->hz[c]);
        b->sz[c] -= gap*(bx*b->hy[c] - by*b->hx[c]);
        b->rate[c] = g->vx[c]*b->hx[c] + g->vy[c]*b->hy[c] + g->vz[c]*b->hz[c];
        b->stored[c] = b->lost[c] = b->bonds[c] = b->broke[c] = 0.0;
    }
}

static void chances(struct dem_tray *t, const struct dem_parts *p, const uint32_t *row_pair)
{
    for (int c = 0; c < t->block.n; c++)
    {
        const struct dem_pair *const q = &p->contacts.pair[row_pair[c]];
        const int64_t i = p->particles.record[q->i].id;
        const int64_t j = q->wall ? -1 - p->pairs.wall_region[q->j] : p->particles.record[q->j].id;

        t->block.chance[c] = dem_random_unit((uint64_t)i, (uint64_t)j, 0, 0);
    }
}

static void fill_past_touching(struct dem_tray *t, const struct dem_parts *p, const struct dem_chain *chain, const uint32_t *padded)
{
    if (chain->pair.with_wall)
    {
        gaps_of_walls(t, p, padded);
    }
    else
    {
        gaps_of_pairs(t);
    }
    motion_past_touching(&t->block, &t->g);
    if (chain->needs & DEM_NEEDS_CHANCE)
    {
        chances(t, p, padded);
    }
}

/* Of a wall the spin of the particle alone was gathered, of a pair the mean. */
static void motion(struct dem_tray *t, const struct dem_chain *chain, int plain)
{
    relative_motion(&t->block, &t->g, chain->pair.with_wall ? 0.5 : 1.0);
    if (chain->pair.with_wall && !plain && chain->needs & DEM_NEEDS_SWING)
    {
        swing_of_walls(t);
    }
}

/* ---- the whole ----------------------------------------------------------------------------------------------- */

void dem_tray_gather(struct dem_tray *t, const struct dem_parts *p, const struct dem_chain *chain, uint32_t row, int rows)
{
    t->block.n = (rows + DEM_LANES - 1)/DEM_LANES*DEM_LANES;
    dem_gather_pairs(t, p, chain->needs, p->contacts.near_row + row);
}

void dem_tray_fill(struct dem_tray *t, const struct dem_parts *p, const struct dem_chain *chain, uint32_t row, int rows)
{
    uint32_t padded[DEM_BLOCK];

    t->block.n = (rows + DEM_LANES - 1)/DEM_LANES*DEM_LANES;
    pad(t, p->contacts.row_pair + row, rows, padded);
    if (chain->pair.with_wall)
    {
        gather_walls(t, p, padded);
        normals_of_walls(&t->block);
        if (!p->walls.plain)
        {
            gather_special(t, p, padded);
        }
    }
    else
    {
        dem_tray_gather(t, p, chain, row, rows);
        geometry_of_pairs(&t->block, &t->g);
    }
    motion(t, chain, p->walls.plain);
    if (chain->past_touching)
    {
        fill_past_touching(t, p, chain, padded);
    }
}
