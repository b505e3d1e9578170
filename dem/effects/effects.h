/*
 * effects.h -- the list of all effects. To add one: write effects/<name>.c and add its row here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_EFFECTS_H
#define DEM_EFFECTS_EFFECTS_H

#include "effects/effect.h"

#define DEM_EFFECT_ROWS(ROW)                                                                                          \
    ROW(hertz)                                                                                                        \
    ROW(hooke)                                                                                                        \
    ROW(hooke_hysteresis)                                                                                             \
    ROW(dry)                                                                                                          \
    ROW(viscous)                                                                                                      \
    ROW(stokes)                                                                                                       \
    ROW(mindlin)                                                                                                      \
    ROW(mindlin_incremental)                                                                                          \
    ROW(linear)                                                                                                       \
    ROW(rolling_constant)                                                                                             \
    ROW(rolling_spring)                                                                                               \
    ROW(rolling_viscous)                                                                                              \
    ROW(twisting_spring)                                                                                              \
    ROW(sjkr)                                                                                                         \
    ROW(bond_linear)                                                                                                  \
    ROW(jkr)                                                                                                          \
    ROW(lubrication)                                                                                                  \
    ROW(gravity)                                                                                                      \
    ROW(pressure_gradient)                                                                                            \
    ROW(stokes_drag)                                                                                                  \
    ROW(schiller_naumann)                                                                                             \
    ROW(wen_yu)                                                                                                       \
    ROW(ergun)                                                                                                        \
    ROW(gidaspow)                                                                                                     \
    ROW(di_felice)                                                                                                    \
    ROW(rong)                                                                                                         \
    ROW(koch_hill)                                                                                                    \
    ROW(beetstra)                                                                                                     \
    ROW(tenneti)                                                                                                      \
    ROW(viscous_stress)                                                                                               \
    ROW(virtual_mass)                                                                                                 \
    ROW(saffman_mei)                                                                                                  \
    ROW(magnus)                                                                                                       \
    ROW(viscous_torque)

#define DEM_EFFECT_DECLARE(name) extern const struct dem_effect dem_##name;
DEM_EFFECT_ROWS(DEM_EFFECT_DECLARE)
#undef DEM_EFFECT_DECLARE

/* All effects, in the order of the list, ended by NULL. */
extern const struct dem_effect *const dem_effects[];

/* The effect with this word, or NULL. */
const struct dem_effect *dem_effects_find(const char *name);

/* Open a tray of bodies and act on it, where it is used once only. */
static inline void dem_effect_on_bodies(const struct dem_effect *effect, const void *settings, struct dem_body_block *b)
{
    if (effect->open_bodies)
    {
        effect->open_bodies(settings, b);
    }
    effect->act_on_bodies(settings, b);
}

/* DEM_ERROR_INPUT with a sentence that names the known words, nearest first; `where` is the place in the input. */
int dem_effects_unknown(const char *where, const char *name);

#endif
