/*
 * packing_spheres.c -- the spheres of a packing: their ranks and pairs, a random position for one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "sources/packing.h"
#include "core/random.h"
#include "ranks/collect.h"
#include <string.h>

enum
{
    USE_PLACE = 201,         /* stream of random numbers */
    DRAWS = 1000             /* points for one trial; each lies inside with a probability above 0.5 */
};

int dem_packing_spheres_init(struct dem_packing_spheres *s, const struct dem_domain *domain,
                             const struct dem_decomposition *of)
{
    const double skin[DEM_LISTS] = {0.0, 0.0};

    memset(s, 0, sizeof *s);
    dem_pairs_init(&s->search, domain, skin, 0.0, 0.0);
    dem_halo_init(&s->halo, &s->decomposition);
    dem_particles_init(&s->particles, 0);
    return dem_decomposition_init(&s->decomposition, of->comm, of->rank, of->ranks);
}

void dem_packing_spheres_free(struct dem_packing_spheres *s)
{
    dem_contacts_free(&s->contacts);
    dem_pairs_free(&s->search);
    dem_particles_free(&s->particles);
    dem_halo_free(&s->halo);
    dem_decomposition_free(&s->decomposition);
}

int dem_packing_list_pairs(const struct dem_packing *p, struct dem_packing_spheres *s, int status,
                           double gap)
{
    dem_pairs_set_reach(&s->search, gap, s->max_radius);
    for (size_t i = 0; i < s->particles.n; i++)
    {
        dem_domain_wrap(p->domain, &s->particles.record[i]);
    }
    status = dem_halo_migrate(&s->halo, status, &s->particles, &s->contacts);
    status = status || !(gap > 0.0) ? status : dem_pairs_order(&s->search, &s->particles);
    status = dem_halo_build(&s->halo, status, &s->particles, p->domain, s->max_radius, gap);
    status = status ? status
                    : dem_pairs_search(&s->search, p->domain, &s->particles, &s->table,
                                       &s->contacts);
    return dem_collect_agree(&s->decomposition, status);
}

int dem_packing_draw(const struct dem_packing *p, struct dem_particle *s, uint64_t trial)
{
    struct dem_insertion_limits *const limits = p->shape->limits;
    const uint64_t draws = limits ? DEM_PACKING_LIMITED_DRAWS : DRAWS;
    double u[3];
    int inside = 0;

    for (uint64_t draw = trial*draws; draw < (trial + 1)*draws && !inside; draw++)
    {
        for (int k = 0; k < 3; k++)
        {
            u[k] = dem_random_unit(p->seed, (uint64_t)s->id, draw, USE_PLACE + (uint64_t)k);
        }
        inside = dem_insertion_shape_draw(p->shape, s->radius, u, s->x)
              && (!limits || dem_insertion_limits_allow(limits, s->radius, s->x));
    }
    dem_domain_wrap(p->domain, s);
    return inside;
}
