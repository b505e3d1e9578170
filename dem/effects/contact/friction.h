/*
 * friction.h -- what the friction laws share: settings, loops over a contact batch, energy. A law is a
 * header comment, its stiffness k_t of a row, and its settings beyond these.
 *
 *   F_t = -k_t xi - eta_t s,    |F_t| <= mu max(F_n, 0)         see slider.h
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_FRICTION_H
#define DEM_EFFECTS_FRICTION_H

#include "effects/contact/slider.h"
#include "effects/effect.h"

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
                       "damp slip with the damping coefficient of the normal law while the "   \
                       "contact sticks"),                                                      \
    DEM_SETTING_SWITCH(type, common.adhesion, "adhesion", 1,                                   \
                       "count adhesion in the friction limit: mu (F_n + 2 F_c) with jkr, mu "  \
                       "(F_n + k_c d) with hookeHysteresis")

/* What distinguishes the laws. Inlined: pass constants. */
struct dem_friction_law
{
    /* k_t of a row [N/m]; settings: of the law */
    double (*stiffness)(const void *settings, const struct dem_contact_row *);
    /* k_t of the last step, for the energy; NULL: it is kept in a fourth history column, and a
       spring keeps its force while k_t grows */
    double (*previous)(const void *settings, const struct dem_contact_batch *,
                         const struct dem_energy *, int c);
};

static inline struct dem_friction dem_friction_of(const struct dem_friction_settings *s,
                                                  const struct dem_contact_batch *b)
{
    return (struct dem_friction){s->friction, s->damping ? 1 : 0, s->adhesion ? 1 : 0,
                                 dem_slider_inverse_dt(b)};
}

/* The slider of a row with stiffness kt, its spring of the last step loaded: x, y, z times keep. */
static inline __attribute__((always_inline)) struct dem_slider
dem_friction_row(struct dem_friction rubs, const struct dem_contact_row *r, double kt,
                 double x, double y, double z)
{
    struct dem_slider s = dem_slider_friction(r, kt, rubs);

    s.xi_x = x;
    s.xi_y = y;
    s.xi_z = z;
    return dem_slider_load(r, s);
}

/* The share of the elongation that keeps the force of a spring that was softer. */
static inline __attribute__((always_inline)) double dem_friction_keep(double before, double kt)
{
    return dem_select(before < kt, before/dem_select(kt > 0, kt, 1), 1);
}

/* dem_effect.apply: to be called from a function of DEM_KERNEL with a copy of the settings, so that
   they stay in registers. */
static inline __attribute__((always_inline)) void
dem_friction_apply(struct dem_friction_law law, const void *settings,
                   const struct dem_friction_settings *common, struct dem_contact_batch *restrict b,
                   double *const *history)
{
    const struct dem_friction rubs = dem_friction_of(common, b);
    double *restrict x = history[0], *restrict y = history[1], *restrict z = history[2];
    double *restrict stiffness = law.previous ? NULL : history[3];

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_contact_row r = dem_contact_row_load(b, c);
        const double kt = law.stiffness(settings, &r);
        const double keep = law.previous ? 1 : dem_friction_keep(stiffness[c], kt);
        const struct dem_slider s = dem_friction_row(rubs, &r, kt, keep*x[c], keep*y[c], keep*z[c]);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        if (!law.previous)
        {
            stiffness[c] = kt;
        }
        b->kt[c] = kt;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_finish(b, (double *const[3]){b->fx, b->fy, b->fz}, x, y, z);
}

/* dem_effect.energy, called as dem_friction_apply. A spring that is shortened to keep its force
   while k grows to k' loses k xi^2/2 (1 - k/k'). */
static inline __attribute__((always_inline)) void
dem_friction_energy(struct dem_friction_law law, const void *settings,
                    const struct dem_friction_settings *common,
                    const struct dem_contact_batch *restrict b, double *const *before,
                    struct dem_energy *restrict e)
{
    const struct dem_friction rubs = dem_friction_of(common, b);
    const double *restrict x = before[0], *restrict y = before[1], *restrict z = before[2];
    const double *restrict stiffness = law.previous ? NULL : before[3];

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_contact_row r = dem_contact_row_load(b, c);
        struct dem_slider s = dem_slider_friction(&r, b->kt[c], rubs);
        const double was = law.previous ? 0 : stiffness[c];
        const double grown = law.previous ? 0 : b->touching[c]*dem_select(was < b->kt[c],
                                                                            b->kt[c] - was, 0);
        const double keep = dem_select(grown > 0, dem_friction_keep(was, b->kt[c]), 1);
        const double square = x[c]*x[c] + y[c]*y[c] + z[c]*z[c];

        s.xi_x = keep*x[c];
        s.xi_y = keep*y[c];
        s.xi_z = keep*z[c];
        s.mass = e->slip_mass[c];
        s.previous_stiffness = law.previous ? law.previous(settings, b, e, c) : was + grown;
        dem_slider_energy(b, c, s, e);
        if (!law.previous)
        {
            e->lost[c] += was/2*square*(1 - keep);
        }
    }
}

#endif
