/*
 * mindlin.h -- what mindlin.c does to one row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_MINDLIN_H
#define DEM_EFFECTS_MINDLIN_H

#include "effects/slider.h"
#include <math.h>

struct dem_mindlin
{
    double friction;
    int damping, adhesion;
    double modulus;                                       /* Pa   8 G*, derived */
};

static inline struct dem_rubbing dem_mindlin_rubs(const struct dem_mindlin *m, const struct dem_block *b)
{
    return (struct dem_rubbing){(dem_real)m->friction, m->damping ? 1 : 0, m->adhesion ? 1 : 0, dem_slider_often(b)};
}

static inline __attribute__((always_inline)) dem_real dem_mindlin_stiffness(dem_real modulus, const struct dem_row *r)
{
    return modulus*dem_root(r->reduced_radius*r->overlap);
}

/* A row's slider of stiffness r->kt, its spring (`x`, `y`, `z` a step ago) loaded. */
static inline __attribute__((always_inline)) struct dem_slider
dem_mindlin_row(struct dem_rubbing rubs, const struct dem_row *r, dem_real x, dem_real y, dem_real z)
{
    struct dem_slider s = dem_slider_friction(r, r->kt, rubs);

    s.xi_x = x;
    s.xi_y = y;
    s.xi_z = z;
    return dem_slider_load(r, s);
}

#endif
