/*
 * restitution.h -- what laws of damping share: the dashpot that makes two bodies part with e times the speed at which they met.
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
 * Both hold if the force may pull at the end of the contact; clamped, they bounce higher. A spring that pulls by itself,
 * by adhesion, is never clamped.
 *
 * Source: Antypov and Elliott, EPL 94 (2011) 50004; Hu, Hu, Jian, Liu, Wan, J. Computers 6, no. 5 (2011).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_RESTITUTION_H
#define DEM_EFFECTS_RESTITUTION_H

#include "base/math.h"
#include "effects/block.h"

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

/* ---- the pull at the end: a dashpot may pull harder than the spring pushes, for a moment ---------------------------- */

enum
{
    DEM_ATTRACTION_ALLOWED,
    DEM_ATTRACTION_CLAMPED
};
static const char *const dem_attractions[] = {"allowed", "clamped", NULL};

/* N: the least force that this choice leaves */
static inline double dem_attraction_least(int choice)
{
    return choice == DEM_ATTRACTION_CLAMPED ? 0.0 : -1e30;    /* beyond any force */
}

/* the force less the dashpot's; clamped, a spring that pushes is not turned into a pull, and one that pulls stays as it is */
static inline __attribute__((always_inline)) dem_real dem_attraction(dem_real spring, dem_real dashpot, dem_real least)
{
    const dem_real sum = spring - dashpot;

    return dem_pick((spring < 0) | (sum >= least), sum, least);
}

/* ---- the ledger -------------------------------------------------------------------------------------------------- */

/* J: the dashpot's force, clamped or not, times the speed in the middle of the kick that it is part of, as far as this contact
   alone changes that: eta v_n (v_n + F_n dt/2 m*) dt. With v_n of before the kick in its place an impact that is damped to
   e = 0.9 at 1/20 of its duration loses 0.5 % too much. */
static inline void dem_restitution_energy(const struct dem_block *b, struct dem_energy *restrict e)
{
    for (int c = 0; c < b->n; c++)
    {
        const dem_real mass = b->reduced_mass[c], gain = dem_pick(mass > 0, b->dt/2/dem_pick(mass > 0, mass, 1), 0);

        e->lost[c] = -b->touching[c]*e->push[c]*(b->vn[c] + gain*b->fn[c])*b->dt;
    }
}

#endif
