/*
 * effect_text.h -- an effect as text, from its descriptor.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_RUN_EFFECT_TEXT_H
#define DEM_RUN_EFFECT_TEXT_H

#include "core/text.h"
#include "laws/effect.h"

/* Append name, stage, summary, source and limitation of the effect, a line or two of each setting,
   and an empty line. */
void dem_effect_text_add(struct dem_text *, const struct dem_effect *);

#endif
