/*
 * virial.h -- contribution of the contacts to the stress, particle by particle.
 *
 *   W_ab = sum over contacts of  f_a l_b     [J]
 *
 *   f  force on the particle
 *   l  from its centre, or the centre of its clump, to the contact
 *
 * The mean contact stress in a volume V is the sum of W over the particles in it, divided by V,
 * tension positive: two spheres that are pressed together have f along -l, so W < 0. With forces in
 * balance it equals the mean of the stress inside the particles. After Christoffersen, Mehrabadi
 * and Nemat-Nasser, J. Appl. Mech. 48 (1981) 339, with each half of a branch vector given to its
 * particle. Each sphere of a clump has the contacts that act on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"

/* W of each owned particle from the contact forces of the last sweep, xx yy zz xy yz zx, the shear
   components as the mean of ab and ba; 6 numbers each. Positions must not have
   changed since that sweep. */
void dem_virial_sum(const struct dem_state *, double *virial);
