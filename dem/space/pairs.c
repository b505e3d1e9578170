/*
 * pairs.c -- the order of particles, and pruning. Finding pairs is in pairs_find.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/pairs.h"
#include "base/error.h"
#include "base/memory.h"
#include "space/grid.h"
#include <math.h>
#include <string.h>

static void use(struct dem_pairs *s, enum dem_list list)
{
    const double skin = s->skins.skin[list];

    *(list == DEM_LIST_OUTER ? &s->outer : &s->inner) = s->reach + skin;
    *(list == DEM_LIST_OUTER ? &s->half_outer : &s->half_inner) = 0.5*skin;
}

void dem_pairs_init(struct dem_pairs *s, const struct dem_domain *d, const double skin[2], double reach, double most_radius)
{
    memset(s, 0, sizeof *s);
    dem_skins_init(&s->skins, skin, 0, 0.0, 0.0);
    s->reach = reach;
    s->most_radius = most_radius;
    use(s, DEM_LIST_OUTER);
    use(s, DEM_LIST_INNER);
    dem_domain_shifts(d, s->shift);
}

/* The least: what rounding of places would spoil is far below; thinner ones save next to nothing where a tenth of it counts. */
void dem_pairs_tune(struct dem_pairs *s, double most)
{
    const double skin[2] = {s->skins.skin[0], s->skins.skin[1]};

    dem_skins_init(&s->skins, skin, 1, fmin(1e-3*most, skin[1]), fmax(most, skin[0]));
}

void dem_pairs_thicken(struct dem_pairs *s)
{
    use(s, DEM_LIST_OUTER);
}

void dem_pairs_free(struct dem_pairs *s)
{
    dem_wall_search_free(&s->search);
    dem_memory_free(s->wall_region);
    dem_drift_free(&s->drift[DEM_LIST_OUTER]);
    dem_drift_free(&s->drift[DEM_LIST_INNER]);
    memset(s, 0, sizeof *s);
}

size_t dem_pairs_bytes(const struct dem_pairs *s)
{
    return s->wall_region_room*sizeof *s->wall_region + dem_drift_bytes(&s->drift[DEM_LIST_OUTER])
         + dem_drift_bytes(&s->drift[DEM_LIST_INNER])
         + s->search.near_room*sizeof *s->search.near + s->search.candidate_room*sizeof *s->search.candidate;
}

int dem_pairs_order(struct dem_pairs *s, struct dem_particles *p)
{
    struct dem_grid g = {0};
    uint32_t *order;

    dem_grid_divide(&g, p, s->most_radius, s->outer);
    DEM_TRY(DEM_NEW(order, p->n + 1));
    const int status = dem_grid_order(&g, p, order);

    if (!status)
    {
        dem_particles_reorder(p, order, p->n);
    }
    dem_memory_free(order);
    return status;
}

/* Two entries a pair, and a bit of each for the side; images of particles are counted beside them. */
static const size_t most_particles = (size_t)1 << 31, most_pairs = (size_t)1 << 30;

int dem_pairs_countable(size_t particles, size_t pairs)
{
    DEM_REQUIRE(particles < most_particles && pairs < most_pairs, DEM_ERROR_INPUT,
                "%zu particles and %zu pairs near each other on one rank, the limits are %zu and %zu; use more ranks", particles, pairs,
                most_particles - 1, most_pairs - 1);
    return DEM_OK;
}

/* ---- pruning ------------------------------------------------------------------------------------------------- */

static int pair_near(const struct dem_pairs *s, const struct dem_particles *p, const struct dem_pair *q)
{
    const struct dem_particle *const i = &p->record[q->i], *const j = &p->record[q->j];
    const double *const shift = s->shift[q->shift];
    const double dx = i->x[0] - j->x[0] + shift[0], dy = i->x[1] - j->x[1] + shift[1], dz = i->x[2] - j->x[2] + shift[2];
    const double reach = i->radius + j->radius + s->inner;

    return dx*dx + dy*dy + dz*dz < reach*reach;
}

static int wall_near(const struct dem_pairs *s, const struct dem_particles *p, const struct dem_walls *w, const struct dem_pair *q)
{
    const struct dem_particle *const i = &p->record[q->i];

    return dem_wall_search_distance(&s->search, w, &s->search.near[q->j], i->x) < i->radius + s->inner;
}

int dem_pairs_prune(struct dem_pairs *s, const struct dem_particles *p, const struct dem_walls *w, struct dem_contacts *c)
{
    uint8_t *near;

    use(s, DEM_LIST_INNER);
    DEM_TRY(DEM_NEW(near, c->pairs + 1));
    for (size_t k = 0; k < c->pairs; k++)
    {
        near[k] = (uint8_t)(c->pair[k].wall ? wall_near(s, p, w, &c->pair[k]) : pair_near(s, p, &c->pair[k]));
    }
    const int status = dem_contacts_prune(c, p, near);

    dem_memory_free(near);
    DEM_TRY(status);
    dem_skins_made(&s->skins, DEM_LIST_INNER);
    return dem_drift_begin(&s->drift[DEM_LIST_INNER], p, s->skins.skin[DEM_LIST_INNER]);
}
