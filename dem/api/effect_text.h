/*
 * effect_text.h -- an effect as text, from its descriptor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_API_EFFECT_TEXT_H
#define DEM_API_EFFECT_TEXT_H

#include "core/text.h"
#include "effects/effect.h"

/* Append name, stage, summary, source and limitation of the effect, a line or two of each setting,
   and an empty line. */
void dem_effect_text_add(struct dem_text *, const struct dem_effect *);

#endif
