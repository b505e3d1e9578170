/*
 * friction.h -- what the friction laws share: settings, force of one contact, energy. Each law adds
 * its stiffness k_t and its own settings.
 *
 *   F_t = -k_t xi - eta_t s,    |F_t| <= mu max(F_n, 0)         see slider.h
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_FRICTION_H
#define DEM_LAWS_FRICTION_H

#include "laws/contact/slider.h"
#include "laws/effect.h"

/* settings of all laws, first in the struct of each */
struct dem_friction_settings
{
    double friction;        /* mu */
    int damping, adhesion;  /* the dashpot acts; adhesion counts in the limit */
};

#define DEM_FRICTION_SETTING(type)                                                             \
    DEM_SETTING_AS(type, common.friction, "friction", "1", DEM_SETTING_REQUIRED, 0.0, 100.0,   \
                   "mu: limit of the tangential over the normal force")

#define DEM_FRICTION_SWITCHES(type)                                                            \
    DEM_SETTING_SWITCH(type, common.damping, "tangentialDamping", 1,                           \
                       "damping with the coefficient of the normal law while the contact "     \
                       "sticks"),                                                              \
    DEM_SETTING_SWITCH(type, common.adhesion, "adhesion", 1,                                   \
                       "count adhesion in the friction limit: mu (F_n + 2 F_c) with jkr, mu "  \
                       "(F_n + k_c d) with hookeHysteresis")

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

/* Friction of a row by this slider. */
DEM_MATH void dem_friction_row(const struct dem_friction_settings *l, struct dem_contact_row *r,
                               double *xi)
{
    dem_slider_row(r, dem_friction_slider(l, r, xi), (double *[3]){&r->fx, &r->fy, &r->fz}, xi);
}

/* ---- energy ------------------------------------------------------------------------------------ */

/* k_t of the last step of row c [N/m]; settings: of the law. NULL: it is kept in a fourth history
   column, and a spring keeps its force while k_t grows. */
typedef double dem_friction_previous(const void *settings, const struct dem_contact_batch *,
                                     const struct dem_energy *, int c);

/* The fraction of the elongation that keeps the force of a spring that was softer. */
DEM_MATH double dem_friction_keep(double before, double kt)
{
    return dem_select(before < kt, before/dem_select(kt > 0.0, kt, 1.0), 1.0);
}

/* dem_effect.energy. A spring that is shortened to keep its force while k grows to k' loses
   k xi^2/2 (1 - k/k'). */
DEM_MATH void dem_friction_energy(dem_friction_previous *previous, const void *settings,
                                  const struct dem_contact_batch *restrict b,
                                  double *const *before, struct dem_energy *restrict e)
{
    const struct dem_friction_settings *const l = settings;
    const double inverse_dt = dem_contact_batch_inverse_dt(b);
    const double *restrict x = before[0], *restrict y = before[1], *restrict z = before[2];
    const double *restrict stiffness = previous ? NULL : before[3];

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);
        const double was = previous ? 0.0 : stiffness[c];
        const double grown =
            previous ? 0.0 : b->touching[c]*dem_select(was < b->kt[c], b->kt[c] - was, 0.0);
        const double keep = dem_select(grown > 0.0, dem_friction_keep(was, b->kt[c]), 1.0);
        const double square = x[c]*x[c] + y[c]*y[c] + z[c]*z[c];

        struct dem_slider s = dem_friction_slider(
            l, &r, (const double[3]){keep*x[c], keep*y[c], keep*z[c]});

        s.mass = e->slip_mass[c];
        s.previous_stiffness = previous ? previous(settings, b, e, c) : was + grown;
        dem_slider_energy(b, c, s, e);
        if (!previous)
        {
            e->lost[c] += was/2*square*(1.0 - keep);
        }
    }
}

#endif
