/*
 * uniform.h -- the uniform fluid of a scene around its particles; one that is coupled comes to look for itself.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STEP_UNIFORM_H
#define DEM_STEP_UNIFORM_H

#include "io/scene.h"
#include "state/particles.h"

struct dem_parts;

/* The fluid's columns of particle i; of a fluid that is not given, those of one that nobody has placed. `mean` [m]: diameter of the swarm. */
void dem_uniform_fill(struct dem_particles *, size_t i, const struct dem_uniform_fluid *, double mean);

/* Collective. Particles came or went: the mean diameter of those that are there, and what laws of drag make of it. */
void dem_uniform_renew(struct dem_parts *, const struct dem_uniform_fluid *);

#endif
