/*
 * carry.h -- a vector that a pair remembers, brought from the pair's old frame into today's; lengths are kept.
 *
 *   a - 2 (h.a) h ...   mirrored from the old normal's plane into today's (mindlin.c), then turned about n
 *   n                   normal of today                                          [1]
 *   h                   unit vector half way from the old normal to n           [1]
 *   q                   tan of half the angle by which it turns about n         [1]
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_CARRY_H
#define DEM_EFFECTS_CARRY_H

#include "base/math.h"

struct dem_carried
{
    dem_real x, y, z;
};

DEM_MATH dem_real dem_carry_inner(struct dem_carried a, struct dem_carried b)
{
    return a.x*b.x + a.y*b.y + a.z*b.z;
}

/* a + f b */
DEM_MATH struct dem_carried dem_carry_plus(struct dem_carried a, dem_real f, struct dem_carried b)
{
    return (struct dem_carried){a.x + f*b.x, a.y + f*b.y, a.z + f*b.z};
}

/* a, normal to n, turned about n by 2 atan(q) */
DEM_MATH struct dem_carried dem_carry_turned(struct dem_carried a, struct dem_carried n, dem_real q)
{
    const struct dem_carried aside = {n.y*a.z - n.z*a.y, n.z*a.x - n.x*a.z, n.x*a.y - n.y*a.x};
    const dem_real over = 1.0/(1.0 + q*q), less = (1.0 - q*q)*over;

    return dem_carry_plus((struct dem_carried){less*a.x, less*a.y, less*a.z}, 2.0*q*over, aside);
}

/* What was normal to the old n a step ago, and gains `more` in its middle: both brought into today's frame, half of the
   swing before and half after. Anything less even feeds energy to a turning pair. */
DEM_MATH struct dem_carried dem_carry_on(struct dem_carried a, struct dem_carried more, struct dem_carried h, struct dem_carried n, dem_real q)
{
    const struct dem_carried mirrored = dem_carry_plus(a, -2.0*dem_carry_inner(h, a), h);
    const struct dem_carried flat = dem_carry_plus(mirrored, -dem_carry_inner(n, mirrored), n);

    return dem_carry_turned(dem_carry_plus(dem_carry_turned(flat, n, q), 1.0, more), n, q);
}

/* a, normal to h, by the smallest rotation in the plane normal to n */
DEM_MATH struct dem_carried dem_carry_tilted(struct dem_carried a, struct dem_carried h, struct dem_carried n)
{
    return dem_carry_plus(a, -dem_carry_inner(n, a)/(1.0 + dem_carry_inner(h, n)), dem_carry_plus(h, 1.0, n));
}

#endif
