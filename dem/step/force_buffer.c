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

struct dem_contact_force *dem_force_buffer_slot(const struct dem_contacts *c, uint32_t row,
                                                int buffered)
{
    return buffered ? c->forces.buffer + (row & (DEM_FORCE_BUFFER_ROWS - 1))
                    : c->forces.force + row;
}

size_t dem_force_buffer_copy_deferred(struct dem_contacts *c, size_t copied, uint32_t end)
{
    for (; copied < c->forces.deferred && c->forces.deferred_row[copied] < end; copied++)
    {
        const uint32_t row = c->forces.deferred_row[copied];

        c->forces.force[row] = c->forces.buffer[row & (DEM_FORCE_BUFFER_ROWS - 1)];
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

int dem_force_buffer_store(const struct dem_contact_batch *b, double factor, int past_touching,
                           double max_overlap, struct dem_contact_force *to)
{
    return store(b, factor, past_touching, max_overlap, to);
}
