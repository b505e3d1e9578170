/*
 * fill_batch.c -- gather the partners of a contact batch and compute normals, overlap and
 * relative motion of all lanes.
 *
 * For classes with effects that act past touching (stages BOND and FILM), geometry.h is extended to
 * a gap: with the gap as a negative overlap, the two contact points meet in the middle of the gap,
 * or on the wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/fill_batch.h"
#include "core/math.h"
#include "core/random.h"
#include "contacts/geometry.h"
#include "step/cell_motion.h"
#include "step/gather_partners.h"
#include "walls/wall_surface.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* ---- gathering ------------------------------------------------------------------------------- */

static void gather_walls(struct dem_contact_workspace *restrict t, const struct dem_state *state,
                         const uint32_t *restrict row_pair)
{
    struct dem_gathered *const g = &t->gathered;
    struct dem_contact_batch *const b = &t->batch;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &state->contacts.pairs.pair[row_pair[c]];
        const struct dem_particle *const i = &state->particles.record[q->i];
        const struct dem_wall_touch *const at = &state->touches.touch[q->j];
        /* behind the plane of a one-sided wall the distance is negative and n still points into the
           domain */
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
        b->min_radius[c] = i->radius;
        b->reduced_radius[c] = i->radius;
        b->reduced_mass[c] = i->inverse_mass > 0.0 ? 1.0/i->inverse_mass : i->mass;
        b->wx[c] = i->w[0];
        b->wy[c] = i->w[1];
        b->wz[c] = i->w[2];
    }
}

/* Scalars that have columns in the batch: the value of the particle. */
static void gather_scalars_at_walls(struct dem_contact_batch *b, const struct dem_state *state,
                                    unsigned needs, const uint32_t *row_pair)
{
    for (int k = 0; k < state->particles.batch.n; k++)
    {
        double *const to = dem_contact_batch_column(b, &state->particles, k, needs);

        for (int c = 0; to && c < b->n; c++)
        {
            const uint32_t i = state->contacts.pairs.pair[row_pair[c]].i;

            to[c] = dem_batch_column_values(&state->particles, k)[i];
        }
    }
}

/* A wall that moves, is curved, or has a tangential surface velocity: its velocity and spin, its
   normal half a step ago, and its curvature. */
static void gather_wall_motion(struct dem_contact_workspace *restrict t,
                               const struct dem_state *state,
                           const uint32_t *restrict row_pair)
{
    struct dem_gathered *const g = &t->gathered;
    struct dem_contact_batch *const b = &t->batch;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &state->contacts.pairs.pair[row_pair[c]];
        const struct dem_particle *const i = &state->particles.record[q->i];
        struct dem_wall_surface wall;
        const struct dem_wall_touch *const at = &state->touches.touch[q->j];
        const int facet = dem_pairs_facet(&state->pairs, q->j);

        dem_wall_surface_at(&state->walls, facet, i, at, b->dt, &wall);
        if (dem_wall_surface_follows_mesh(&state->walls, facet))
        {
            dem_wall_surface_add_mesh_motion(&state->walls, &state->pairs.wall_search, q->j, i->x,
                                             at, b->dt, &wall);
        }
        g->vx[c] -= wall.velocity[0];
        g->vy[c] -= wall.velocity[1];
        g->vz[c] -= wall.velocity[2];
        b->wx[c] -= wall.spin[0];
        b->wy[c] -= wall.spin[1];
        b->wz[c] -= wall.spin[2];
        b->hx[c] = wall.half_step_normal[0];
        b->hy[c] = wall.half_step_normal[1];
        b->hz[c] = wall.half_step_normal[2];
        b->reduced_radius[c] = wall.reduced_radius;
    }
}

/* ---- geometry -------------------------------------------------------------------------------- */

DEM_MATH void store_motion(const struct dem_contact_row *r, struct dem_contact_batch *restrict b,
                           int c)
{
    b->overlap[c] = r->overlap;
    b->touching[c] = r->touching;
    b->vn[c] = r->vn;
    b->sx[c] = r->sx;
    b->sy[c] = r->sy;
    b->sz[c] = r->sz;
    b->normal_spin[c] = r->normal_spin;
}

/* In one loop, because the roots and the division of the first part leave time for the second. */
DEM_KERNEL
static void geometry_of_pairs(struct dem_contact_batch *restrict b,
                              const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r;

        dem_geometry_pair(g, c, b->dt, &r);
        dem_geometry_motion(g, c, 1.0, &r);
        b->nx[c] = r.nx;
        b->ny[c] = r.ny;
        b->nz[c] = r.nz;
        b->hx[c] = r.hx;
        b->hy[c] = r.hy;
        b->hz[c] = r.hz;
        b->reduced_radius[c] = r.reduced_radius;
        b->reduced_mass[c] = r.reduced_mass;
        b->min_radius[c] = r.min_radius;
        store_motion(&r, b, c);
    }
}

/* At a flat wall at rest the normal of half a step ago equals the present one. */
static void normals_of_walls(struct dem_contact_batch *b)
{
    memcpy(b->hx, b->nx, sizeof b->hx);
    memcpy(b->hy, b->ny, sizeof b->hy);
    memcpy(b->hz, b->nz, sizeof b->hz);
}

/* At a wall twice the spin of the particle was gathered: a quarter of it is the mean of particle and
   wall at rest. */
DEM_KERNEL
static void motion_at_walls(struct dem_contact_batch *restrict b,
                            const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = {.nx = b->nx[c],
                                    .ny = b->ny[c],
                                    .nz = b->nz[c],
                                    .hx = b->hx[c],
                                    .hy = b->hy[c],
                                    .hz = b->hz[c],
                                    .overlap = b->overlap[c]};

        dem_geometry_motion(g, c, 0.5, &r);
        store_motion(&r, b, c);
    }
}

/* A rotating wall has a spin, too: the spin gathered of the particle minus the spin relative to the
   wall. */
static void add_normal_spin_of_walls(struct dem_contact_workspace *t)
{
    struct dem_contact_batch *const b = &t->batch;
    const struct dem_gathered *const g = &t->gathered;

    for (int c = 0; c < b->n; c++)
    {
        b->normal_spin[c] +=
            0.5*((0.5*g->bx[c] - b->wx[c])*b->nx[c] + (0.5*g->by[c] - b->wy[c])*b->ny[c] +
                   (0.5*g->bz[c] - b->wz[c])*b->nz[c]);
    }
}

/* Lanes past the last row repeat it, so that every lane holds valid numbers. */
static void pad(const struct dem_contact_workspace *restrict t, const uint32_t *restrict row_pair,
                int rows, uint32_t *restrict padded)
{
    for (int c = 0; c < t->batch.n; c++)
    {
        padded[c] = row_pair[c < rows ? c : rows - 1];
    }
}

/* ---- past touching --------------------------------------------------------------------------- */

/* Where another facet has taken over the contact, the distance is measured along the old normal:
   bonds and films made there persist. */
static void gaps_of_walls(struct dem_contact_workspace *restrict t, const struct dem_state *state,
                          const uint32_t *restrict row_pair)
{
    struct dem_contact_batch *const b = &t->batch;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_pair *const q = &state->contacts.pairs.pair[row_pair[c]];
        const struct dem_wall_touch *const at = &state->touches.touch[q->j];
        const double *const x = state->particles.record[q->i].x;
        const double height = (x[0] - at->point[0])*at->normal[0] +
                              (x[1] - at->point[1])*at->normal[1] +
                              (x[2] - at->point[2])*at->normal[2];

        const int dropped = at->distance > DBL_MAX/2.0;

        b->distance[c] = dropped ? height : at->distance;
        b->gap[c] = b->distance[c] - b->min_radius[c];
        b->is_primary[c] = dropped ? 0.0 : 1.0;
    }
}

static void gaps_of_pairs(struct dem_contact_workspace *t)
{
    struct dem_contact_batch *const b = &t->batch;
    const struct dem_gathered *const g = &t->gathered;

    for (int c = 0; c < b->n; c++)
    {
        b->distance[c] = sqrt(g->rx[c]*g->rx[c] + g->ry[c]*g->ry[c] + g->rz[c]*g->rz[c]);
        b->gap[c] = b->distance[c] - g->radii[c];
        b->is_primary[c] = 1.0;
    }
}

/* A gap lengthens the lever arms. */
DEM_KERNEL
static void motion_past_touching(struct dem_contact_batch *restrict b,
                                 const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        const double gap = dem_select(b->gap[c] > 0.0, b->gap[c], 0.0);
        const double bx = 0.5*g->bx[c], by = 0.5*g->by[c], bz = 0.5*g->bz[c];

        b->sx[c] -= gap*(by*b->hz[c] - bz*b->hy[c]);
        b->sy[c] -= gap*(bz*b->hx[c] - bx*b->hz[c]);
        b->sz[c] -= gap*(bx*b->hy[c] - by*b->hx[c]);
        b->distance_rate[c] = g->vx[c]*b->hx[c] + g->vy[c]*b->hy[c] + g->vz[c]*b->hz[c];
        b->stored[c] = b->lost[c] = b->bonds[c] = b->broke[c] = 0.0;
    }
}

static void random_numbers(struct dem_contact_workspace *t, const struct dem_state *state,
                           const uint32_t *row_pair)
{
    for (int c = 0; c < t->batch.n; c++)
    {
        const struct dem_pair *const q = &state->contacts.pairs.pair[row_pair[c]];
        const int64_t i = state->particles.record[q->i].id;
        const int64_t j = q->wall ? -1 - state->pairs.wall_facet[q->j].number
                                  : state->particles.record[q->j].id;

        t->batch.pair_random[c] = dem_random_unit((uint64_t)i, (uint64_t)j, 0, 0);
    }
}

static void fill_past_touching(struct dem_contact_workspace *t, const struct dem_state *state,
                               const struct dem_effect_list *effects, const uint32_t *padded)
{
    if (effects->pair.with_wall)
    {
        gaps_of_walls(t, state, padded);
    }
    else
    {
        gaps_of_pairs(t);
    }
    motion_past_touching(&t->batch, &t->gathered);
    if (effects->needs & DEM_NEEDS_RANDOM)
    {
        random_numbers(t, state, padded);
    }
}

/* Frozen partners exchange scalars, but have no inverse mass: with one, all columns are finite. No
   force moves them. */
static void give_frozen_pairs_mass(struct dem_contact_workspace *t)
{
    for (int c = 0; c < t->batch.n; c++)
    {
        t->gathered.inverse_mass[c] =
            t->gathered.inverse_mass[c] > 0.0 ? t->gathered.inverse_mass[c] : 1.0;
    }
}

/* ---- the batch ------------------------------------------------------------------------------- */

static void fill_walls(struct dem_contact_workspace *t, const struct dem_state *state,
                       const struct dem_effect_list *effects, const uint32_t *padded)
{
    gather_walls(t, state, padded);
    gather_scalars_at_walls(&t->batch, state, effects->needs, padded);
    normals_of_walls(&t->batch);
    if (!state->walls.all_flat_static)
    {
        gather_wall_motion(t, state, padded);
    }
    motion_at_walls(&t->batch, &t->gathered);
    if (!state->walls.all_flat_static && effects->needs & DEM_NEEDS_NORMAL_SPIN)
    {
        add_normal_spin_of_walls(t);
    }
}

void dem_contact_batch_fill_pairs(struct dem_contact_workspace *t, const struct dem_state *state,
                                  const struct dem_effect_list *effects,
                                  const struct dem_row_partners *partners, int rows)
{
    t->batch.n = dem_contact_batch_lanes(rows);
    dem_gather_pairs(t, state, effects->needs, partners);
    if (state->cell.active)
    {
        dem_cell_add_velocities(state, t->batch.n, &t->gathered);
    }
    if (effects->scalars)
    {
        give_frozen_pairs_mass(t);
    }
    geometry_of_pairs(&t->batch, &t->gathered);
}

void dem_contact_batch_fill(struct dem_contact_workspace *t, const struct dem_state *state,
                            const struct dem_effect_list *effects, uint32_t row, int rows)
{
    uint32_t padded[DEM_BATCH_ROWS];

    t->batch.n = dem_contact_batch_lanes(rows);
    if (effects->pair.with_wall || effects->past_touching)
    {
        pad(t, state->contacts.rows.pair + row, rows, padded);
    }
    if (effects->pair.with_wall)
    {
        fill_walls(t, state, effects, padded);
    }
    else
    {
        dem_contact_batch_fill_pairs(t, state, effects, state->contacts.rows.partners + row, rows);
    }
    if (effects->past_touching)
    {
        fill_past_touching(t, state, effects, padded);
    }
}
