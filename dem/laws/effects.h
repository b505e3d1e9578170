/*
 * effects.h -- the list of all effects. A new law needs a row here.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effect.h"

#define DEM_EFFECT_ROWS(ROW)                                                                                          \
    ROW(hertz)                                                                                                        \
    ROW(hooke)                                                                                                        \
    ROW(hooke_hysteresis)                                                                                             \
    ROW(dry)                                                                                                          \
    ROW(viscous)                                                                                                      \
    ROW(stokes_damping)                                                                                                       \
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
    ROW(liquid_bridge)                                                                                                \
    ROW(conduction)                                                                                                   \
    ROW(gas_film)                                                                                                     \
    ROW(radiation)                                                                                                    \
    ROW(friction_heat)                                                                                                \
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
    ROW(hoelzer_sommerfeld)                                                                                           \
    ROW(viscous_stress)                                                                                               \
    ROW(capillary_force)                                                                                              \
    ROW(virtual_mass)                                                                                                 \
    ROW(saffman_mei)                                                                                                  \
    ROW(magnus)                                                                                                       \
    ROW(viscous_torque)                                                                                               \
    ROW(turbulent_dispersion)                                                                                         \
    ROW(gunn)                                                                                                         \
    ROW(ranz_marshall)                                                                                                \
    ROW(wakao)

#define DEM_EFFECT_DECLARE(name) extern const struct dem_effect dem_##name;
DEM_EFFECT_ROWS(DEM_EFFECT_DECLARE)
#undef DEM_EFFECT_DECLARE

/* All effects, in the order of the list, ended by NULL. */
extern const struct dem_effect *const dem_effects[];

/* The effect with this name, or NULL. */
const struct dem_effect *dem_effects_find(const char *name);

/* Evaluate a body effect on a batch that is used once only: both prepare_bodies and apply_to_bodies. */
static inline void dem_effect_apply_to_bodies(const struct dem_effect *effect, const void *settings,
                                              struct dem_body_batch *b)
{
    if (effect->prepare_bodies)
    {
        effect->prepare_bodies(settings, b);
    }
    effect->apply_to_bodies(settings, b);
}

/* 1 if a particle scalar has this name: of an effect of the list, or parcelRatio. */
int dem_scalar_is_known(const char *name);

/* 1 if `word` is another code's word for the effect. */
int dem_effect_is_alias(const struct dem_effect *, const char *word);

/* Returns DEM_ERROR_INPUT with a message that lists the known names, most similar first.
   `where`: position in the input. */
int dem_effects_unknown(const char *where, const char *name);
