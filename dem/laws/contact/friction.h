/*
 * friction.h -- what the friction laws share: settings, force and energy of one contact. Each law adds its
 * stiffness k_t and its own settings.
 *
 *   F_t = -k_t xi - eta_t s,    |F_t| <= mu max(F_n, 0)         see slider.h
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/slider_energy.h"

/* settings of all laws, first in the struct of each */
struct dem_friction_settings
{
    double friction;        /* mu */
    int damping, adhesion;  /* the dashpot acts; adhesion counts in the limit */
};

/* The slider of a row with stiffness r->kt and spring xi: dashpot of the normal law, limit from the
   normal force. */
DEM_MATH struct dem_slider dem_friction_slider(const struct dem_friction_settings *l,
                                               const struct dem_contact_row *r, const double *xi)
{
    const double with_dashpot = l->damping != 0, with_adhesion = l->adhesion != 0;
    const double normal = r->fn + with_adhesion*r->adhesive_force;

    return (struct dem_slider){.stiffness = r->kt,
                               .damping = with_dashpot*r->eta,
                               .limit = dem_select(normal > 0.0, l->friction*normal, 0.0),
                               .inverse_dt = r->inverse_dt,
                               .sx = r->sx,
                               .sy = r->sy,
                               .sz = r->sz,
                               .xi_x = xi[0],
                               .xi_y = xi[1],
                               .xi_z = xi[2]};
}

/* F of a slider into the row. */
DEM_MATH void dem_friction_add(const struct dem_slider *s, struct dem_contact_row *r)
{
    r->fx += s->fx;
    r->fy += s->fy;
    r->fz += s->fz;
}

/* Friction of a row by this slider. */
DEM_MATH void dem_friction_row(const struct dem_friction_settings *l, struct dem_contact_row *r,
                               double *xi)
{
    const struct dem_slider s = dem_slider_step(r, dem_friction_slider(l, r, xi));

    dem_slider_keep(&s, xi);
    dem_friction_add(&s, r);
}

/* The fraction of the elongation that keeps the force of a spring that was softer. */
DEM_MATH double dem_friction_keep(double before, double kt)
{
    return dem_select(before < kt, before/dem_select(kt > 0.0, kt, 1.0), 1.0);
}

/* Energy of the row of a law with the stiffness k_t; previous: k_t of the last step [N/m]. */
DEM_MATH void dem_friction_energy(const struct dem_friction_settings *l,
                                  const struct dem_contact_row *r, const double *xi, double previous,
                                  struct dem_energy_row *e)
{
    struct dem_slider s = dem_friction_slider(l, r, xi);

    s.mass = e->slip_mass;
    s.previous_stiffness = previous;
    dem_slider_energy(r, s, e);
}
