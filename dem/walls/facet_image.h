/*
 * facet_image.h -- periodic images of facets and triangles: which ones are near, where a particle is
 * when one is taken back, and the image in the key of a contact. Devices compile it, too.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "particles/periodic_image.h"

/* Largest number of periods between a triangle and its image that a particle meets. Small, as a plate
   much larger than the domain has this number of images around each particle, squared. */
enum
{
    DEM_WALL_IMAGES = 2
};

static inline int dem_wall_images_limited(double n)
{
    return (int)fmax(-DEM_WALL_IMAGES, fmin(DEM_WALL_IMAGES, n));
}

/* The images [n, n] of an extent that may meet another one [m]: all that meet it; 0 without a period. */
static inline void dem_walls_image_range(double period, const double extent[2],
                                         const double other[2], int range[2])
{
    range[0] = period > 0.0 ? dem_wall_images_limited(ceil((other[0] - extent[1])/period)) : 0;
    range[1] = period > 0.0 ? dem_wall_images_limited(floor((other[1] - extent[0])/period)) : 0;
}

/* Where x is when the image that is n periods off is taken back: x itself, or written to `moved`. */
static inline const double *dem_walls_from_image(const double period[3], const int8_t n[3],
                                                 const double x[3], double moved[3])
{
    if (!(n[0] | n[1] | n[2]))
    {
        return x;
    }
    for (int k = 0; k < 3; k++)
    {
        moved[k] = x[k] - n[k]*period[k];
    }
    return moved;
}

/* Part of the key of a contact: the image n of a facet whose wall has made `turns` periods, as a
   particle with this image counter meets it. distinct: bit k: along axis k it may meet two. */
static inline uint32_t dem_facet_image(uint8_t distinct, const int turns[3], const int8_t n[3],
                                       uint32_t particle)
{
    uint32_t image = 0;

    for (int k = 0; k < 3; k++)
    {
        image = distinct >> k & 1
                    ? dem_image_add(image, k, turns[k] - n[k] - (int)dem_image_part(particle, k))
                    : image;
    }
    return image;
}
