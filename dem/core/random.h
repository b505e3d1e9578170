/*
 * random.h -- random numbers without a state: a function of (seed, id, step, use), the same on any
 * rank.
 *
 *   seed   the user's number for the whole run
 *   id     the particle's id
 *   step   number of the time step
 *   use    purpose: each place in the code that draws has its own constant, and counts up from it
 *          to draw more than one number
 *
 * The four words are absorbed one after the other by a 64-bit mixing function: the finaliser of
 * Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014, with the
 * shifts and multipliers that David Stafford published as his variant 13; the increment is 2^64
 * over the golden ratio. Not for cryptography.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/device.h"

/* Spread every bit of a word over all 64 bits; bijective. */
static inline uint64_t dem_random_mix(uint64_t h)
{
    h += 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 30))*0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27))*0x94d049bb133111ebu;
    return h ^ (h >> 31);
}

/* 64 random bits. */
static inline uint64_t dem_random_bits(uint64_t seed, uint64_t id, uint64_t step, uint64_t use)
{
    uint64_t h = dem_random_mix(seed);

    h = dem_random_mix(h ^ id);
    h = dem_random_mix(h ^ step);
    return dem_random_mix(h ^ use);
}

/* A double in [0, 1), a multiple of 2^-53. */
static inline double dem_random_unit(uint64_t seed, uint64_t id, uint64_t step, uint64_t use)
{
    return (double)(int64_t)(dem_random_bits(seed, id, step, use) >> 11)*0x1p-53;
}
