/*
 * restitution_effect.h -- what the descriptors of the damping laws share: constants derived from
 * the restitution, words of the setting `attraction`, energy. Formulas: restitution.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_RESTITUTION_EFFECT_H
#define DEM_LAWS_RESTITUTION_EFFECT_H

#include "laws/batch.h"
#include "laws/contact/restitution.h"

/* words of the lower limit of the normal force, in the order of its enum */
static const char *const dem_attractions[] = {"allowed", "clamped", "none", NULL};

/* sqrt(2 (p + 1)): alpha at critical damping */
static inline double dem_restitution_critical(double exponent)
{
    return sqrt(2.0*(exponent + 1.0));
}

/* -ln e; 1e9 for e = 0: from there on L/sqrt(pi^2 + L^2) is 1 in double precision */
static inline double dem_restitution_loss(double e)
{
    return e > 0.0 ? 0.0 - dem_log(e) : 1e9;
}

/* dem_effect.energy: dissipated by the dashpot: its force, clamped or not, times the velocity in the middle of
   the kick, as far as this contact alone changes it: eta v_n (v_n + F_n dt/2 m*) dt. With v_n
   before the kick instead, an impact with e = 0.9 and 20 steps would count 0.5 % too much. */
static inline void dem_restitution_energy(const void *of, const struct dem_contact_batch *restrict b,
                                          double *const *before, double *const *history,
                                          struct dem_energy *restrict e)
{
    (void)of, (void)before, (void)history;
    for (int c = 0; c < b->n; c++)
    {
        const double mass = b->reduced_mass[c],
                       gain = dem_select(mass > 0, b->dt/2/dem_select(mass > 0, mass, 1), 0);

        e->lost[c] = -b->touching[c]*e->normal_force[c]*(b->vn[c] + gain*b->fn[c])*b->dt;
    }
}

#endif
