/*
 * inlet_grid.h -- the spheres near the inlet of a stream, in a grid of cells.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "ranks/dem_state.h"
#include "sources/inlet_walls.h"
#include "sources/stream.h"

/* a sphere near the inlet */
struct dem_inlet_sphere
{
    double x[3], radius;
};

/* spheres around the inlet of one stream */
struct dem_inlet_grid
{
    const struct dem_domain *domain;
    const struct dem_stream *stream;
    /* m  box of the centres that trials may produce */
    double min[3], max[3];
    /* m  of all spheres gathered or inserted */
    double max_radius;
    /* m  of a cell */
    double edge;
    int cells[3];
    /* first sphere of each cell; next sphere of each sphere */
    int *head, *next;
    size_t n, sphere_capacity, next_capacity;
    struct dem_inlet_sphere *sphere;
    struct dem_inlet_walls walls;
};

/* Collective; `status`: of this rank. The spheres of all ranks near the inlet. */
int dem_inlet_grid_gather(struct dem_inlet_grid *, struct dem_state *, int status);

/* Sort the spheres into cells. */
int dem_inlet_grid_make(struct dem_inlet_grid *);

/* Insert a sphere into the cells, with all periodic images that are near the inlet. */
int dem_inlet_grid_insert(struct dem_inlet_grid *, const double x[3], double radius);

/* 1 when a sphere of this radius at x is in the box of trials and meets no other. */
int dem_inlet_grid_is_clear(const struct dem_inlet_grid *, const double x[3], double radius);

void dem_inlet_grid_free(struct dem_inlet_grid *);
