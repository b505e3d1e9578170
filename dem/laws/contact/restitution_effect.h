/*
 * restitution_effect.h -- what the descriptors of the damping laws share: constants derived from
 * the restitution, words of the setting `attraction`. Formulas: restitution.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

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
