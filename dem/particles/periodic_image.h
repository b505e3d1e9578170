/*
 * periodic_image.h -- integer codes of periodic shifts of pairs and image counters of particles.
 *
 * A shift code 0..26 is (sx + 1) + 3 (sy + 1) + 9 (sz + 1). An image counter holds how often a
 * particle has crossed each periodic face, modulo 1024 per axis, in 10 bits each. Wrapping i by -L
 * raises both image_i and the shift of its pairs by one, so (shift - image_i + image_j) does not
 * change and identifies the image of a pair permanently.
 *
 * A place between two wraps may be up to a period outside the box; dem_periodic_place gives the one inside.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

enum
{
    DEM_SHIFT_NONE = 13,
    DEM_SHIFTS = 27,
    DEM_IMAGE_BITS = 10,
    DEM_IMAGE_MASK = (1 << DEM_IMAGE_BITS) - 1
};

/* The shift of a code along one axis: -1, 0 or 1. */
static inline int dem_shift_axis(int code, int axis)
{
    return (axis == 0 ? code%3 : axis == 1 ? code/3%3 : code/9) - 1;
}

static inline int dem_shift_code(int x, int y, int z)
{
    return x + 1 + 3*(y + 1) + 9*(z + 1);
}

static inline uint32_t dem_image_part(uint32_t image, int axis)
{
    return image >> axis*DEM_IMAGE_BITS & DEM_IMAGE_MASK;
}

static inline uint32_t dem_image_add(uint32_t image, int axis, int by)
{
    const int at = axis*DEM_IMAGE_BITS;

    return (image & ~((uint32_t)DEM_IMAGE_MASK << at)) |
           ((dem_image_part(image, axis) + (uint32_t)by) & DEM_IMAGE_MASK) << at;
}

/* How often a particle has crossed the faces of an axis between two counters, at most 511 times. */
static inline int dem_image_difference(uint32_t now, uint32_t before, int axis)
{
    const uint32_t more = dem_image_part(now, axis) - dem_image_part(before, axis);
    const int middle = 1 << (DEM_IMAGE_BITS - 1);

    return (int)((more + (uint32_t)middle) & DEM_IMAGE_MASK) - middle;
}

/* The place x or its image in [min, min + length), less than a period away; x itself where length is 0. */
static inline double dem_periodic_place(double x, double min, double length)
{
    return x < min ? x + length : x >= min + length ? x - length : x;
}

static inline uint32_t dem_image_of_pair(int shift, uint32_t image_i, uint32_t image_j)
{
    uint32_t image = 0;

    for (int k = 0; k < 3; k++)
    {
        image = dem_image_add(image, k,
                              dem_shift_axis(shift, k) - (int)dem_image_part(image_i, k) +
                                  (int)dem_image_part(image_j, k));
    }
    return image;
}
