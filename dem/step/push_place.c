/*
 * push_place.c -- a block's forces and overlaps into the records of its pushes.
 *
 * With T = n x F the torque is -a T on both sides, a the arm of that side (see tray.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/push_place.h"
#include "effects/effect.h"
#include "step/push.h"

struct dem_push_place dem_push_place(const struct dem_contacts *c, uint32_t row, int ring)
{
    const uint32_t slot = row & (DEM_RING - 1);

    return c->single ? (struct dem_push_place){.single = ring ? c->ring_single + slot : c->push_single + row}
                     : (struct dem_push_place){.push = ring ? c->ring + slot : c->push + row};
}

size_t dem_push_keep_far(struct dem_contacts *c, size_t far, uint32_t end)
{
    for (; far < c->fars && c->far[far] < end; far++)
    {
        const uint32_t row = c->far[far], slot = row & (DEM_RING - 1);

        if (c->single)
        {
            c->push_single[row] = c->ring_single[slot];
        }
        else
        {
            c->push[row] = c->ring[slot];
        }
    }
    return far;
}

DEM_KERNEL
static void put(const struct dem_block *restrict b, double share, int past_touching, const struct dem_push_place *to)
{
    const double *const less = past_touching ? b->gap : b->overlap;
    const double part = past_touching ? -share : share;

    for (int c = 0; c < b->n; c += 4)
    {
        const dem_quad one = {1.0, 1.0, 1.0, 1.0}, on = past_touching ? one : DEM_QUAD(b->touching + c);
        const dem_quad nx = DEM_QUAD(b->nx + c), ny = DEM_QUAD(b->ny + c), nz = DEM_QUAD(b->nz + c), fn = on*DEM_QUAD(b->fn + c);
        const dem_quad fx = on*DEM_QUAD(b->fx + c), fy = on*DEM_QUAD(b->fy + c), fz = on*DEM_QUAD(b->fz + c);
        dem_quad f[4] = {fn*nx + fx, fn*ny + fy, fn*nz + fz, part*DEM_QUAD(less + c)};
        dem_quad t[4] = {ny*fz - nz*fy, nz*fx - nx*fz, nx*fy - ny*fx, {0.0, 0.0, 0.0, 0.0}};

        if (to->single)
        {
            dem_push_put_single(to->single + c, f, t);
        }
        else
        {
            dem_push_put(to->push + c, f, t);
        }
    }
}

void dem_push_out(const struct dem_block *b, double share, int past_touching, const struct dem_push_place *to)
{
    put(b, share, past_touching, to);
}
