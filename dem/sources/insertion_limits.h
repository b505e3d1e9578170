/*
 * insertion_limits.h -- where a group of `insert` may place its spheres besides its shape: off the
 * walls, and inside the mesh or one of its zones.
 *
 *     inside walls;        no sphere overlaps a wall
 *     inside NAME;         the same, and each centre lies inside this closed wall of triangles
 *     inside mesh;         the same, and each centre lies in a cell of the mesh
 *     zone NAME;           the same, and each centre lies in a cell of that zone
 *
 * Each rank has all walls and the whole surface, so the answer is the same on all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "sources/closed_surface.h"
#include "input/dictionary.h"
#include "particles/domain.h"
#include "walls/wall_search.h"

/* the surfaces that a scene may name */
struct dem_insertion_regions
{
    size_t n, capacity;
    struct dem_closed_surface *surface;
};

struct dem_insertion_limits
{
    const struct dem_closed_surface *surface;  /* NULL: walls only */
    struct dem_closed_surface own;             /* of a wall, to which `surface` points then */
    const struct dem_walls *walls;
    const struct dem_domain *domain;
    struct dem_wall_search search;
    int status;                                /* the first failure: memory, or no place for a
                                                  sphere */
};

/* Read `inside` or `zone` of a group; *limits: a new one, which the caller frees, or NULL without
   these entries. */
int dem_insertion_limits_read(struct dem_insertion_limits **, const struct dem_dict *group,
                              const struct dem_insertion_regions *, const struct dem_walls *);
void dem_insertion_limits_free(struct dem_insertion_limits *);

/* Before the calls below, once walls are finished. radius [m]: the largest of the group. */
int dem_insertion_limits_prepare(struct dem_insertion_limits *, const struct dem_walls *,
                                 const struct dem_domain *, double radius);

/* 1 when a sphere may lie at x, that is at the image of x in the domain; the image that lies inside
   the surface may be another one. */
int dem_insertion_limits_allow(struct dem_insertion_limits *, double radius, const double x[3]);

/* A sphere at `from`, which is allowed, is to go to x: move x out of the walls that it overlaps;
   where that is not enough it stays. */
void dem_insertion_limits_confine(struct dem_insertion_limits *, double radius,
                                  const double from[3], double x[3]);

void dem_insertion_regions_free(struct dem_insertion_regions *);
