/*
 * mindlin.h -- the law of mindlin.c for one contact row.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_MINDLIN_H
#define DEM_EFFECTS_MINDLIN_H

#include "effects/contact/slider.h"
#include <math.h>

struct dem_mindlin
{
    double friction;
    int damping, adhesion;
    double modulus;                                       /* Pa   8 G*, derived */
};

static inline struct dem_friction dem_mindlin_friction(const struct dem_mindlin *m,
                                                       const struct dem_contact_batch *b)
{
    return (struct dem_friction){(dem_real)m->friction, m->damping ? 1 : 0, m->adhesion ? 1 : 0,
                                 dem_slider_inverse_dt(b)};
}

static inline __attribute__((always_inline)) dem_real dem_mindlin_stiffness(dem_real modulus,
                            const struct dem_contact_row *r)
{
    return modulus*dem_sqrt(r->reduced_radius*r->overlap);
}

/* The slider of a row with stiffness r->kt, its spring (x, y, z of the last step) loaded. */
static inline __attribute__((always_inline)) struct dem_slider
dem_mindlin_row(struct dem_friction rubs, const struct dem_contact_row *r, dem_real x, dem_real y,
                dem_real z)
{
    struct dem_slider s = dem_slider_friction(r, r->kt, rubs);

    s.xi_x = x;
    s.xi_y = y;
    s.xi_z = z;
    return dem_slider_load(r, s);
}

#endif
