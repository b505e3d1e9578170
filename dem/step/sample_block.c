/*
 * sample_block.c -- build and free the sample block of spheres.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sample_block.h"
#include "particles/scalars.h"
#include "step/neighbor_rebuild.h"
#include <math.h>
#include <string.h>

static int most_frequent_material(const struct dem_state *state, const struct dem_inventory *s)
{
    int best = 0;

    for (int m = 1; m < state->interaction_table.materials; m++)
    {
        best = s->material[m].n > s->material[best].n ? m : best;
    }
    return best;
}

static int fill(struct dem_state *q, const struct dem_state *state, const struct dem_inventory *s,
                int edge, double a)
{
    const int material = most_frequent_material(state, s);
    const double d = s->all.diameters/(double)s->all.n;

    DEM_TRY(dem_particles_grow(&q->particles, (size_t)(2*edge*edge*edge)));
    for (int k = 0; k < 2*edge*edge*edge; k++)
    {
        const int cell = k/2;
        const double shift = 0.25 + 0.5*(k%2);
        const double x[3] = {a*(cell%edge + shift), a*(cell/edge%edge + shift),
                             a*(cell/edge/edge + shift)};

        q->particles.record[k] =
            dem_particle_sphere(k, x, d, state->interaction_table.material[material].density, material);
        if (state->interaction_table.motionless)              /* frozen, so that any step is stable */
        {
            q->particles.record[k].flags = DEM_PARTICLE_FROZEN;
            q->particles.record[k].inverse_mass = 0.0;
            q->particles.record[k].inverse_inertia = 0.0;
        }
        if (dem_column(&q->particles, DEM_COLUMN_FLUID_DENSITY))
        {
            dem_column(&q->particles, DEM_COLUMN_FLUID_DENSITY)[k] = s->fluid_density;
            dem_column(&q->particles, DEM_COLUMN_VOID_FRACTION)[k] = 0.4;
            dem_column(&q->particles, DEM_COLUMN_SLIP_FACTOR)[k] = 1.0;
        }
    }
    q->particles.n = (size_t)(2*edge*edge*edge);
    for (int k = 0; k < state->interaction_table.scalars; k++)
    {
        const double given = dem_interaction_table_default(&state->interaction_table, k);
        const double value = state->particles.n > 0 ? dem_scalar_values(&state->particles, k)[0]
                             : isnan(given)     ? 0.0
                                                : given;

        for (size_t i = 0; i < q->particles.n; i++)
        {
            dem_scalar_values(&q->particles, k)[i] = value;
        }
    }
    return DEM_OK;
}

int dem_sample_block_make(struct dem_sample *sample, const struct dem_state *state,
                          const struct dem_inventory *s, int64_t max)
{
    /* touching, with a small overlap */
    const double d = s->all.diameters/(double)s->all.n, a = 0.999*d*2.0/sqrt(3.0);
    const double skin[2] = {2.0*state->pairs.half_outer, 2.0*state->pairs.half_inner};
    const int min_edge = (int)ceil((2.0*d + state->pairs.outer)/a) + 1;
    struct dem_state *const q = &sample->state;
    int edge = 1;

    memset(sample, 0, sizeof *sample);
    dem_attached_stores_attach(&sample->stores, q);
    while (2*edge*edge*edge < s->all.n && 2*(int64_t)(edge + 1)*(edge + 1)*(edge + 1) <= max)
    {
        edge++;
    }
    edge = edge < min_edge ? min_edge : edge;
    dem_domain_init(&q->domain);
    for (int k = 0; k < 3; k++)
    {
        q->domain.min[k] = 0.0;
        q->domain.max[k] = a*edge;
        q->domain.periodic[k] = 1;
    }
    dem_domain_finish(&q->domain);
    DEM_TRY(dem_interaction_table_share(&state->interaction_table, &q->interaction_table));
    q->limits.overlap_limit = 1.0;
    q->max_dt = state->max_dt;
    q->lists_state = DEM_NEIGHBORS_NONE;
    DEM_TRY(dem_decomposition_init(&q->decomposition, MPI_COMM_NULL, 0, 1));
    dem_halo_init(&q->halo, &q->decomposition);
    dem_wall_store_init(&q->wall_store, &q->decomposition);
    dem_particles_init(&q->particles, state->particles.groups);
    dem_particles_add_columns_of(&q->particles, &state->particles);
    DEM_TRY(fill(q, state, s, edge, a));
    DEM_TRY(dem_contacts_init(&q->contacts, &q->interaction_table));
    dem_pairs_init(&q->pairs, &q->domain, skin, q->interaction_table.reach, 0.5*d);
    DEM_TRY(dem_wall_search_prepare(&q->pairs.wall_search, &q->walls, 0.5*d));
    DEM_TRY(dem_neighbor_rebuild(q));
    q->lists_state = DEM_NEIGHBORS_VALID;
    return DEM_OK;
}

void dem_sample_block_free(struct dem_sample *sample)
{
    struct dem_state *const q = &sample->state;

    dem_halo_free(&q->halo);
    dem_pairs_free(&q->pairs);
    dem_wall_touches_free(&q->touches);
    dem_contacts_free(&q->contacts);
    dem_particles_free(&q->particles);
    dem_walls_free(&q->walls);
    dem_interaction_table_unshare(&q->interaction_table);
    dem_decomposition_free(&q->decomposition);
    dem_attached_stores_free(&sample->stores);
}
