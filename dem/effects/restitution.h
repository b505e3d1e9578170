/*
 * restitution.h -- the dashpot that makes two bodies part with e times the speed at which they met.
 *
 *   eta = alpha sqrt(m* k_n),    alpha = sqrt(2 (p + 1)) * L/sqrt(pi^2 + L^2),    L = -ln e
 *
 *   eta  force per normal speed                                    [kg/s]
 *   m*   reduced mass                                              [kg]
 *   k_n  secant stiffness of the normal law F = k_n d ~ d^p        [N/m]
 *   p    exponent of the normal law: 1 linear, 3/2 Hertz           [1]
 *
 * With a dashpot ~ d^((p-1)/2) the equation of motion turns into the linear one by a change of variables, so e does
 * not depend on the impact speed and alpha is exact: p = 1 gives the textbook 2 L/sqrt(pi^2 + L^2), p = 3/2 the
 * sqrt(5) L/sqrt(pi^2 + L^2) of Hu et al. The factor after the dot is 0 for e = 1 and 1, critical damping, for e = 0.
 * Both hold if the force may pull at the end of the contact.
 *
 * Source: Antypov and Elliott, EPL 94 (2011) 50004; Hu, Hu, Jian, Liu, Wan, J. Computers 6, no. 5 (2011).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_RESTITUTION_H
#define DEM_EFFECTS_RESTITUTION_H

#include "base/math.h"

#define DEM_RESTITUTION_PI2 9.86960440108935862           /* pi^2 */

/* sqrt(2 (p + 1)): alpha at critical damping */
static inline double dem_restitution_critical(double exponent)
{
    return sqrt(2.0*(exponent + 1.0));
}

/* -ln e, with a finite stand-in for e = 0: from 1e9 on L/sqrt(pi^2 + L^2) is 1 to the last bit */
static inline double dem_restitution_loss(double e)
{
    return e > 0.0 ? 0.0 - dem_log(e) : 1e9;
}

#endif
