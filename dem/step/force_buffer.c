/*
 * force_buffer.c -- store the forces and lever arms of a contact batch in the records of its rows.
 *
 * With T = n x F the torque is -a T on both sides, a the lever arm of that side (see geometry.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/force_buffer.h"
#include "effects/effect.h"
#include "step/contact_force.h"

struct dem_force_slot dem_force_buffer_slot(const struct dem_contacts *c, uint32_t row,
                                            int buffered)
{
    const struct dem_contact_forces *const f = &c->forces;
    const uint32_t place = buffered ? row & (DEM_FORCE_BUFFER_ROWS - 1) : row;
    struct dem_contact_moment *const moment = buffered ? f->moment_buffer : f->moment;

    return (struct dem_force_slot){.force = (buffered ? f->buffer : f->force) + place,
                                   .moment = moment ? moment + place : NULL};
}

size_t dem_force_buffer_copy_deferred(struct dem_contacts *c, size_t copied, uint32_t end)
{
    for (; copied < c->forces.deferred && c->forces.deferred_row[copied] < end; copied++)
    {
        const uint32_t row = c->forces.deferred_row[copied];

        c->forces.force[row] = c->forces.buffer[row & (DEM_FORCE_BUFFER_ROWS - 1)];
        if (c->forces.moment)
        {
            c->forces.moment[row] = c->forces.moment_buffer[row & (DEM_FORCE_BUFFER_ROWS - 1)];
        }
    }
    return copied;
}

DEM_KERNEL
static int store(const struct dem_contact_batch *restrict b, double factor, int past_touching,
                 double max_overlap, struct dem_contact_force *restrict to)
{
    typedef int64_t flags __attribute__((vector_size(32)));

    /* 2^-20: a margin for rounding errors */
    const double limit = 2.0*max_overlap*(1.0 - 0x1p-20);
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
        dem_contact_force_store(to + c, f, t);
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

int dem_force_buffer_store(const struct dem_contact_batch *b, double factor, int past_touching,
                           double max_overlap, struct dem_force_slot to)
{
    if (to.moment)
    {
        store_moments(b, to.moment);
    }
    return store(b, factor, past_touching, max_overlap, to.force);
}
