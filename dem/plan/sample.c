/*
 * sample.c -- a block of spheres with the scene's own physics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/sample.h"
#include "step/step.h"
#include <math.h>
#include <string.h>

enum
{
    MOST_EDGE = 16                                        /* lattice cells, two spheres each: 8192 spheres */
};

static int commonest(const struct dem_parts *p, const struct dem_survey *s)
{
    int best = 0;

    for (int m = 1; m < p->recipe.materials; m++)
    {
        best = s->material[m].n > s->material[best].n ? m : best;
    }
    return best;
}

static int fill(struct dem_parts *q, const struct dem_parts *p, const struct dem_survey *s, int edge, double a)
{
    const int material = commonest(p, s);
    const double d = s->all.diameters/(double)s->all.n;

    DEM_TRY(dem_particles_grow(&q->particles, (size_t)(2*edge*edge*edge)));
    for (int k = 0; k < 2*edge*edge*edge; k++)
    {
        const int cell = k/2;
        const double shift = 0.25 + 0.5*(k%2);
        const double x[3] = {a*(cell%edge + shift), a*(cell/edge%edge + shift), a*(cell/edge/edge + shift)};

        q->particles.record[k] = dem_particle_sphere(k, x, d, p->recipe.material[material].density, material);
        q->particles.record[k].viscosity = s->fluid_viscosity;
        if (dem_column(&q->particles, DEM_COLUMN_FLUID_DENSITY))
        {
            dem_column(&q->particles, DEM_COLUMN_FLUID_DENSITY)[k] = s->fluid_density;
            dem_column(&q->particles, DEM_COLUMN_FLUID_VISCOSITY)[k] = s->fluid_viscosity;
            dem_column(&q->particles, DEM_COLUMN_VOID_FRACTION)[k] = 0.4;
            dem_column(&q->particles, DEM_COLUMN_COUNTERFLOW)[k] = 1.0;
        }
    }
    q->particles.n = (size_t)(2*edge*edge*edge);
    return DEM_OK;
}

int dem_sample_make(struct dem_parts *q, const struct dem_parts *p, const struct dem_survey *s, const char *without)
{
    const double d = s->all.diameters/(double)s->all.n, a = 0.999*d*2.0/sqrt(3.0);    /* touching, and a little more */
    const double skin[2] = {2.0*p->pairs.half_outer, 2.0*p->pairs.half_inner};
    const int least = (int)ceil((2.0*d + p->pairs.outer)/a) + 1;
    int edge = 1;

    memset(q, 0, sizeof *q);
    while (edge < MOST_EDGE && 2*edge*edge*edge < s->all.n)
    {
        edge++;
    }
    edge = edge < least ? least : edge;
    dem_domain_init(&q->domain);
    for (int k = 0; k < 3; k++)
    {
        q->domain.min[k] = 0.0;
        q->domain.max[k] = a*edge;
        q->domain.periodic[k] = 1;
    }
    dem_domain_close(&q->domain);
    DEM_TRY(dem_recipe_lend(&p->recipe, &q->recipe));
    if (without)
    {
        dem_recipe_leave(&q->recipe, without);
    }
    q->watch.limit = 1.0;
    q->longest_step = p->longest_step;
    q->stale = 2;                                         /* no lists yet */
    DEM_TRY(dem_pieces_init(&q->pieces, MPI_COMM_NULL, 0, 1));
    dem_halo_init(&q->halo, &q->pieces);
    dem_particles_init(&q->particles, p->particles.groups);
    DEM_TRY(fill(q, p, s, edge, a));
    DEM_TRY(dem_contacts_init(&q->contacts, &q->recipe));
    dem_pairs_init(&q->pairs, &q->domain, skin, q->recipe.reach, 0.5*d);
    DEM_TRY(dem_wall_search_prepare(&q->pairs.search, &q->walls, 0.5*d));
    DEM_TRY(dem_step_renew(q));
    q->stale = 0;
    return DEM_OK;
}

void dem_sample_free(struct dem_parts *q)
{
    dem_halo_free(&q->halo);
    dem_pairs_free(&q->pairs);
    dem_wall_touches_free(&q->touches);
    dem_contacts_free(&q->contacts);
    dem_particles_free(&q->particles);
    dem_walls_free(&q->walls);
    dem_recipe_give_back(&q->recipe);
    dem_pieces_free(&q->pieces);
    dem_losses_free(&q->losses);
}
