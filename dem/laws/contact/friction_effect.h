/*
 * friction_effect.h -- what the descriptors of the friction laws share: settings, energy.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_FRICTION_EFFECT_H
#define DEM_LAWS_FRICTION_EFFECT_H

#include "laws/contact/friction.h"
#include "laws/contact/slider_energy.h"
#include "laws/effect.h"

#define DEM_FRICTION_SETTING(type)                                                             \
    DEM_SETTING_AS(type, common.friction, "friction", "1", DEM_SETTING_REQUIRED, 0.0, 100.0,   \
                   "mu: limit of the tangential over the normal force")

#define DEM_FRICTION_SWITCHES(type)                                                            \
    DEM_SETTING_SWITCH(type, common.damping, "tangentialDamping", 1,                           \
                       "dashpot with the coefficient of the normal law, while sticking"),      \
    DEM_SETTING_SWITCH(type, common.adhesion, "adhesion", 1,                                   \
                       "limit mu (F_n + 2 F_c) with jkr, mu (F_n + k_c d) with hookeHysteresis")

/* 8 G* of a class [Pa], for the law of this name; an error without a normal law or shear moduli. */
int dem_mindlin_modulus(const char *law, const struct dem_pair_class *, double *modulus);

/* k_t of the last step of row c [N/m]; settings: of the law. NULL: it is kept in a fourth history
   column, and a spring keeps its force while k_t grows. */
typedef double dem_friction_previous(const void *settings, const struct dem_contact_batch *,
                                     const struct dem_energy *, int c);

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
