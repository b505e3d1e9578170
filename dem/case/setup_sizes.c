/*
 * setup_sizes.c -- sizes of the particles: smallest and largest radius and smallest body of each
 * material, smallest and largest ratio of parcels, on all ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "particles/scalars.h"
#include "ranks/collect.h"
#include <float.h>
#include <math.h>

/* All ranks get the same range of ratios. */
static int find_ratios(struct dem_state *state)
{
    struct dem_parcels_entry *const range = &state->interaction_table.parcels;
    double min[2] = {DBL_MAX, 0.0};

    for (size_t i = 0; i < state->particles.n; i++)
    {
        const double l = dem_scalar_values(&state->particles, range->scalar)[i];

        min[0] = fmin(min[0], l);
        min[1] = fmin(min[1], -l);
    }
    dem_collect_min_double(&state->decomposition, min, 2);
    DEM_TRY(dem_collect_status(&state->decomposition));
    range->min = min[0] < DBL_MAX ? min[0] : 0.0;
    range->max = -min[1];
    return DEM_OK;
}

/* The smallest volume of a body of each material, for the limit of the time step [m3]; not changed without one. */
static void find_bodies(const struct dem *d, double least[DEM_MATERIALS])
{
    const struct dem_particles *const p = &d->state.particles;

    for (size_t i = 0; i < p->n; i++)
    {
        const struct dem_clump *const b = dem_clump_of(p, i);
        const int m = p->record[i].material;
        const struct dem_clump_shape *const s =
            b ? dem_clump_shapes_with_volume(&d->scene.shapes,
                                             b->mass/d->state.interaction_table.material[m].density)
              : NULL;

        least[m] = s ? fmin(least[m], s->step_volume) : least[m];
    }
}

int dem_sim_find_radii(struct dem *d)
{
    struct dem_state *const state = &d->state;
    /* the smallest radii, the negative of the largest, the smallest bodies: one reduction */
    double min[3*DEM_MATERIALS];

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        min[m] = DBL_MAX;
        min[DEM_MATERIALS + m] = 0.0;
        min[2*DEM_MATERIALS + m] = DBL_MAX;
    }
    find_bodies(d, min + 2*DEM_MATERIALS);
    for (size_t i = 0; i < state->particles.n; i++)
    {
        const struct dem_particle *const r = &state->particles.record[i];

        min[r->material] = fmin(min[r->material], r->radius);
        min[DEM_MATERIALS + r->material] = fmin(min[DEM_MATERIALS + r->material], -r->radius);
    }
    dem_collect_min_double(&state->decomposition, min, 3*DEM_MATERIALS);
    DEM_TRY(dem_collect_status(&state->decomposition));
    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        state->interaction_table.min_radius[m] = min[m] < DBL_MAX ? min[m] : 0.0;
        state->interaction_table.max_radius[m] = 0.0 - min[DEM_MATERIALS + m];    /* not -0 */
        state->interaction_table.body_volume[m] =
            min[2*DEM_MATERIALS + m] < DBL_MAX ? min[2*DEM_MATERIALS + m] : 0.0;
    }
    return state->interaction_table.parcels.used ? find_ratios(state) : DEM_OK;
}
