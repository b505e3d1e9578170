/*
 * store_forces.c -- forces and lever arms of a contact batch, from columns into the records of its
 * rows.
 *
 * With T = n x F the torque is -a T on both sides, a the lever arm of that side (see geometry.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/store_forces.h"
#include "laws/effect.h"
#include "core/vec4.h"
#include <string.h>

struct dem_batch_forces dem_store_target(const struct dem_contact_forces *c, uint32_t slot)
{
    return (struct dem_batch_forces){.force = c->force + slot,
                                     .moment = c->moment ? c->moment + slot : NULL};
}

size_t dem_store_deferred(struct dem_contact_forces *c, size_t copied, uint32_t end)
{
    for (; c->ring && c->first_deferred + copied < c->own_slots; copied++)
    {
        const size_t to = c->ring + c->first_deferred + copied;
        const uint32_t row = c->slot_row[c->first_deferred + copied], slot = row & (c->ring - 1);

        if (row >= end)
        {
            break;
        }
        c->force[to] = c->force[slot];
        if (c->moment)
        {
            c->moment[to] = c->moment[slot];
        }
    }
    return copied;
}

void dem_store_observed(struct dem_contacts *c, const struct dem_batch_forces *from, uint32_t row,
                        int rows, size_t n)
{
    struct dem_contact_forces *const f = &c->forces;

    for (int k = 0; k < rows; k++)
    {
        f->touching += from->force[k].arm > 0.0 && dem_contacts_pair(c, row + (uint32_t)k)->i < n;
    }
    if (f->row_force)
    {
        memcpy(f->row_force + row, from->force, (size_t)rows*sizeof *from->force);
    }
    if (f->row_moment)
    {
        memcpy(f->row_moment + row, from->moment, (size_t)rows*sizeof *from->moment);
    }
}

DEM_KERNEL
static int store(const struct dem_contact_batch *restrict b, double factor, int past_touching,
                 double overlap_so_far, struct dem_contact_force *restrict to)
{
    typedef int64_t flags __attribute__((vector_size(32)));

    /* 2^-20: a margin for rounding errors */
    const double limit = 2.0*overlap_so_far*(1.0 - 0x1p-20);
    flags check = {0, 0, 0, 0};
    const double *const depth = past_touching ? b->gap : b->overlap;
    const double signed_factor = past_touching ? -factor : factor;

    for (int c = 0; c < b->n; c += 4)
    {
        const dem_vec4 one = {1.0, 1.0, 1.0, 1.0},
                       mask = past_touching ? one : DEM_VEC4(b->touching + c);
        const dem_vec4 nx = DEM_VEC4(b->nx + c), ny = DEM_VEC4(b->ny + c), nz = DEM_VEC4(b->nz + c),
                       raw = DEM_VEC4(b->fn + c), fn = mask*raw;
        const dem_vec4 fx = mask*DEM_VEC4(b->fx + c), fy = mask*DEM_VEC4(b->fy + c),
                       fz = mask*DEM_VEC4(b->fz + c);
        dem_vec4 f[4] = {fn*nx + fx, fn*ny + fy, fn*nz + fz, signed_factor*DEM_VEC4(depth + c)};
        dem_vec4 t[4] = {ny*fz - nz*fy, nz*fx - nx*fz, nx*fy - ny*fx, {0.0, 0.0, 0.0, 0.0}};

        const dem_vec4 sum = raw + (fx + fy + fz);

        check |= (flags)(DEM_VEC4(b->overlap + c) >= limit*DEM_VEC4(b->min_radius + c)) |
                 (flags)(sum*0.0 != 0.0);

        dem_transpose4(f);
        dem_transpose4(t);
        for (int k = 0; k < 4; k++)
        {
            DEM_VEC4_AT(to[c + k].f) = f[k];
            DEM_VEC4_AT(to[c + k].t) = t[k];
        }
    }
    return (check[0] | check[1] | check[2] | check[3]) != 0;
}

DEM_KERNEL
static void store_moments(const struct dem_contact_batch *restrict b,
                          struct dem_contact_moment *restrict to)
{
    for (int c = 0; c < b->n; c += 4)
    {
        dem_vec4 m[4] = {DEM_VEC4(b->mx + c), DEM_VEC4(b->my + c), DEM_VEC4(b->mz + c),
                         {0.0, 0.0, 0.0, 0.0}};

        dem_transpose4(m);
        for (int k = 0; k < 4; k++)
        {
            DEM_VEC4_AT(to[c + k].m) = m[k];
        }
    }
}

int dem_store_forces(const struct dem_contact_batch *b, double factor, int past_touching,
                     double overlap_so_far, struct dem_batch_forces to)
{
    if (to.moment)
    {
        store_moments(b, to.moment);
    }
    return store(b, factor, past_touching, overlap_so_far, to.force);
}
