/*
 * rotate.h -- rotate a history vector of a pair from the last contact frame to the new one.
 *
 *   a' = a - 2 (h.a) h, its part along n removed, then turned about n by the spin of the pair
 *
 *   n   new unit normal                                        [1]
 *   h   unit vector half way between the old normal and n      [1]
 *   q   tan of half the angle of the turn about n              [1]
 *
 * The reflection maps the plane normal to the old n to the plane normal to the new n and keeps
 * lengths; its derivation is in contact/slider.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/math.h"

struct dem_history_vector
{
    double x, y, z;
};

DEM_MATH double dem_rotate_dot(struct dem_history_vector a, struct dem_history_vector b)
{
    return a.x*b.x + a.y*b.y + a.z*b.z;
}

/* a + f b */
DEM_MATH struct dem_history_vector dem_rotate_add(struct dem_history_vector a, double f,
                                                  struct dem_history_vector b)
{
    return (struct dem_history_vector){a.x + f*b.x, a.y + f*b.y, a.z + f*b.z};
}

/* a, which is normal to n, rotated about n by 2 atan(q) */
DEM_MATH struct dem_history_vector dem_rotate_about_normal(struct dem_history_vector a,
                                                           struct dem_history_vector n, double q)
{
    const struct dem_history_vector cross = {n.y*a.z - n.z*a.y, n.z*a.x - n.x*a.z,
                                             n.x*a.y - n.y*a.x};
    const double scale = 1.0/(1.0 + q*q), cosine = (1.0 - q*q)*scale;

    return dem_rotate_add((struct dem_history_vector){cosine*a.x, cosine*a.y, cosine*a.z},
                          2.0*q*scale, cross);
}

/* A history vector a (normal to the old n) with its increment of this step, both in the new
   frame. The increment is added in the middle of the rotation about n (half of the angle before,
   half after): a less symmetric form adds energy to a rotating pair. */
DEM_MATH struct dem_history_vector dem_rotate_history(struct dem_history_vector a,
                                                      struct dem_history_vector increment,
                                                      struct dem_history_vector h,
                                                      struct dem_history_vector n, double q)
{
    const struct dem_history_vector reflected = dem_rotate_add(a, -2.0*dem_rotate_dot(h, a), h);
    const struct dem_history_vector projected =
        dem_rotate_add(reflected, -dem_rotate_dot(n, reflected), n);

    const struct dem_history_vector turned = dem_rotate_about_normal(projected, n, q);

    return dem_rotate_about_normal(dem_rotate_add(turned, 1.0, increment), n, q);
}

/* a, which is normal to h, rotated by the smallest rotation into the plane normal to n */
DEM_MATH struct dem_history_vector dem_rotate_to_plane(struct dem_history_vector a,
                                                       struct dem_history_vector h,
                                                       struct dem_history_vector n)
{
    return dem_rotate_add(a, -dem_rotate_dot(n, a)/(1.0 + dem_rotate_dot(h, n)),
                          dem_rotate_add(h, 1.0, n));
}
