/*
 * virial.h -- what contacts contribute to the stress, particle by particle.
 *
 *   W_ab = sum over contacts of  f_a l_b        [J]      f force on the particle, l from its centre to the contact
 *
 * The mean contact stress in a volume V is the sum of W over the particles in it, by V, tension positive: two spheres
 * that are pushed together have f along -l, so W < 0. With forces in balance it equals the mean of the stress inside the
 * particles. After Christoffersen, Mehrabadi and Nemat-Nasser, J. Appl. Mech. 48 (1981) 339, with the two halves of a
 * branch vector given to their owners.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_VIRIAL_H
#define DEM_STEP_VIRIAL_H

#include "step/parts.h"

/* W of each owned particle from the pushes of the last sweep, xx yy zz xy yz zx, the shear components as the mean of
   ab and ba; 6 numbers each. Positions must be those of that sweep. */
void dem_virial_sum(const struct dem_parts *, double *virial);

#endif
