/*
 * inlet_grid.c -- the spheres near the inlet of a stream, in a grid of cells.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/inlet_grid.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec.h"
#include "ranks/collect.h"
#include "ranks/dem_state.h"
#include "sources/flows.h"
#include <math.h>
#include <string.h>

enum
{
    MAX_CELLS = 1 << 18,
    NONE = -1
};

/* Factor on distances, far above the round-off of a distance and of rounding a position to a
   multiple of the domain's unit of length. */
static const double margin = 1.0 + 1e-12;

static int is_near(const struct dem_inlet_grid *grid, const double x[3], double reach)
{
    int near = 1;

    for (int k = 0; k < 3; k++)
    {
        near &= x[k] >= grid->min[k] - reach && x[k] <= grid->max[k] + reach;
    }
    return near;
}

/* Add all periodic images of a sphere that are near the inlet. */
static int add_images(struct dem_inlet_grid *grid, const double x[3], double radius)
{
    const double reach = radius + grid->max_radius;
    const struct dem_domain *const d = grid->domain;
    int from[3] = {0, 0, 0}, to[3] = {0, 0, 0}, at[3];

    for (int k = 0; k < 3; k++)
    {
        if (d->periodic[k])
        {
            from[k] = (int)ceil((grid->min[k] - reach - x[k])/d->length[k]);
            to[k] = (int)floor((grid->max[k] + reach - x[k])/d->length[k]);
        }
    }
    for (at[2] = from[2]; at[2] <= to[2]; at[2]++)
    {
        for (at[1] = from[1]; at[1] <= to[1]; at[1]++)
        {
            for (at[0] = from[0]; at[0] <= to[0]; at[0]++)
            {
                const double there[3] = {x[0] + at[0]*d->length[0], x[1] + at[1]*d->length[1],
                                         x[2] + at[2]*d->length[2]};

                if (is_near(grid, there, reach))
                {
                    DEM_TRY(DEM_GROW(grid->sphere, grid->sphere_capacity, grid->n + 1));
                    grid->sphere[grid->n] = (struct dem_inlet_sphere){.radius = radius};
                    memcpy(grid->sphere[grid->n++].x, there, sizeof there);
                }
            }
        }
    }
    return DEM_OK;
}

/* Collective; `status`: of this rank. The spheres of all ranks replace this rank's. */
static int gather(struct dem_state *state, struct dem_inlet_grid *grid, int status)
{
    const struct dem_collect_items own = {"particles near the inlet of a stream", grid->sphere,
                                          grid->n, sizeof *grid->sphere};
    void *all;

    if (state->decomposition.ranks == 1)
    {
        return status;
    }
    DEM_TRY(dem_collect_gather(&state->decomposition, status, &own, &all, &grid->n));
    dem_memory_free(grid->sphere);
    grid->sphere = all;
    grid->sphere_capacity = grid->n;
    return DEM_OK;
}

int dem_inlet_grid_gather(struct dem_inlet_grid *grid, struct dem_state *state, int status)
{
    for (size_t i = 0; i < state->particles.n && !status; i++)
    {
        const struct dem_particle *const q = &state->particles.record[i];

        status = add_images(grid, q->x, q->radius);
    }
    for (size_t k = 0; k < state->flows->arrivals && state->decomposition.rank == 0 && !status; k++)
    {
        const struct dem_particle *const q = &state->flows->arrival[k].particle;

        status = add_images(grid, q->x, q->radius);
    }
    return gather(state, grid, status);
}

static int cell_along(const struct dem_inlet_grid *grid, int k, double x)
{
    const double at = (x - grid->min[k])/grid->edge;

    return !(at > 0.0) ? 0 : at >= grid->cells[k] ? grid->cells[k] - 1 : (int)at;
}

static int add_to_cell(struct dem_inlet_grid *grid, size_t b)
{
    const double *const x = grid->sphere[b].x;
    const int at[3] = {cell_along(grid, 0, x[0]), cell_along(grid, 1, x[1]),
                       cell_along(grid, 2, x[2])};
    int *const head = &grid->head[(at[2]*grid->cells[1] + at[1])*grid->cells[0] + at[0]];

    DEM_TRY(DEM_GROW(grid->next, grid->next_capacity, b + 1));
    grid->next[b] = *head;
    *head = (int)b;
    return DEM_OK;
}

/* Cells are as wide as the largest sphere, or wider if there would be too many. */
int dem_inlet_grid_make(struct dem_inlet_grid *grid)
{
    double cells;

    for (size_t b = 0; b < grid->n; b++)
    {
        grid->max_radius = fmax(grid->max_radius, grid->sphere[b].radius);
    }
    grid->edge = 2.0*grid->max_radius;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            cells *= grid->cells[k] =
                (int)fmin(MAX_CELLS, (grid->max[k] - grid->min[k])/grid->edge) + 1;
        }
        grid->edge *= cells > MAX_CELLS ? 1.26 : 1.0;
    } while (cells > MAX_CELLS);
    DEM_TRY(DEM_NEW(grid->head, (size_t)cells));
    for (size_t c = 0; c < (size_t)cells; c++)
    {
        grid->head[c] = NONE;
    }
    for (size_t b = 0; b < grid->n; b++)
    {
        DEM_TRY(add_to_cell(grid, b));
    }
    return DEM_OK;
}

int dem_inlet_grid_insert(struct dem_inlet_grid *grid, const double x[3], double radius)
{
    const size_t before = grid->n;

    DEM_TRY(add_images(grid, x, radius));
    for (size_t b = before; b < grid->n; b++)
    {
        DEM_TRY(add_to_cell(grid, b));
    }
    return DEM_OK;
}

int dem_inlet_grid_is_clear(const struct dem_inlet_grid *grid, const double x[3], double radius)
{
    const double reach = radius + grid->max_radius;
    int from[3], to[3];

    if (!is_near(grid, x, 0.0))
    {
        return 0;
    }
    for (int k = 0; k < 3; k++)
    {
        from[k] = cell_along(grid, k, x[k] - reach);
        to[k] = cell_along(grid, k, x[k] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            for (int c = from[0]; c <= to[0]; c++)
            {
                for (int b = grid->head[(z*grid->cells[1] + y)*grid->cells[0] + c]; b != NONE;
                     b = grid->next[b])
                {
                    const double apart = margin*(radius + grid->sphere[b].radius);
                    double d[3];

                    dem_vec_minus(x, grid->sphere[b].x, d);
                    if (dem_vec_dot(d, d) < apart*apart)
                    {
                        return 0;
                    }
                }
            }
        }
    }
    return 1;
}

void dem_inlet_grid_free(struct dem_inlet_grid *grid)
{
    dem_inlet_walls_free(&grid->walls);
    dem_memory_free(grid->head);
    dem_memory_free(grid->next);
    dem_memory_free(grid->sphere);
}
