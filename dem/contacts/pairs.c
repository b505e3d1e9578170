/*
 * pairs.c -- order of particles, skins in use, and pruning of pairs to candidate contacts.
 *
 * The search for pairs is in pairs_find.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/pairs.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/vec4.h"
#include "laws/effect.h"
#include <math.h>
#include <string.h>

static void use_skin(struct dem_pairs *s, enum dem_list list)
{
    const double skin = s->skins.skin[list];

    *(list == DEM_LIST_OUTER ? &s->outer : &s->inner) = s->reach + skin;
    *(list == DEM_LIST_OUTER ? &s->half_outer : &s->half_inner) = 0.5*skin;
}

void dem_pairs_init(struct dem_pairs *s, const struct dem_domain *d, const double skin[2],
                    double reach, double max_radius)
{
    memset(s, 0, sizeof *s);
    dem_skins_init(&s->skins, skin, 0, 0.0, 0.0);
    dem_pairs_set_reach(s, reach, max_radius);
    dem_domain_shifts(d, s->shift);
}

void dem_pairs_set_reach(struct dem_pairs *s, double reach, double max_radius)
{
    s->reach = reach;
    s->max_radius = max_radius;
    use_skin(s, DEM_LIST_OUTER);
    use_skin(s, DEM_LIST_INNER);
}

/* The lower limit of 1e-3 of the upper one is far above the rounding of positions; thinner skins
   would save next to nothing. */
void dem_pairs_tune(struct dem_pairs *s, double max)
{
    const double skin[2] = {s->skins.skin[0], s->skins.skin[1]};

    dem_skins_init(&s->skins, skin, 1, fmin(1e-3*max, skin[1]), fmax(max, skin[0]));
}

void dem_pairs_use_chosen_skin(struct dem_pairs *s)
{
    use_skin(s, DEM_LIST_OUTER);
}

void dem_pairs_free(struct dem_pairs *s)
{
    dem_grid_free(&s->grid);
    dem_wall_search_free(&s->wall_search);
    dem_memory_free(s->wall_facet);
    dem_displacement_free(&s->displacement[DEM_LIST_OUTER]);
    dem_displacement_free(&s->displacement[DEM_LIST_INNER]);
    memset(s, 0, sizeof *s);
}

size_t dem_pairs_bytes(const struct dem_pairs *s)
{
    return s->wall_facet_capacity*sizeof *s->wall_facet +
           dem_displacement_bytes(&s->displacement[DEM_LIST_OUTER]) +
           dem_displacement_bytes(&s->displacement[DEM_LIST_INNER]) +
           s->wall_search.neighbor_capacity*sizeof *s->wall_search.neighbor +
           s->wall_search.candidate_capacity*sizeof *s->wall_search.candidate +
           s->wall_search.image_capacity*sizeof *s->wall_search.image;
}

int dem_pairs_order(struct dem_pairs *s, struct dem_particles *particles)
{
    struct dem_grid g = {0};
    uint32_t *order;

    dem_grid_choose_levels(&g, particles, s->max_radius, s->outer);
    DEM_TRY(DEM_NEW(order, particles->n + 1));
    const int status = dem_grid_order(&g, particles, order);

    if (!status)
    {
        dem_particles_reorder(particles, order, particles->n);
    }
    dem_memory_free(order);
    return status;
}

/* An index of 32 bits holds two entries per pair; images of particles are entries besides the
   particles. */
static const size_t particle_limit = (size_t)1 << 31, pair_limit = (size_t)1 << 30;

int dem_pairs_check_counts(size_t particles, size_t pairs)
{
    DEM_REQUIRE(
        particles < particle_limit && pairs < pair_limit, DEM_ERROR_INPUT,
        "%zu particles and %zu pairs near each other on one rank, the limits are %zu and %zu; use more ranks",
        particles, pairs, particle_limit - 1, pair_limit - 1);
    return DEM_OK;
}

/* ---- pruning --------------------------------------------------------------------------------- */

/* Mark the pairs of particles that are near, up to the first one with a wall; returns its index.
   {x, radius} of a record is one vector, and so is the distance with the sum of radii. *few: 1 when less
   than half of them touch. */
DEM_KERNEL
static size_t mark_near(const struct dem_pairs *s, const struct dem_particles *particles,
                        const struct dem_pair_list *list, uint8_t *restrict near, int *few)
{
    const struct dem_particle *const record = particles->record;
    const struct dem_pair *const pair = list->pair;
    const dem_vec4 sign = {-1.0, -1.0, -1.0, 1.0}, gap = {0.0, 0.0, 0.0, s->inner};
    size_t k = 0, touching = 0, rows = 0;

    for (; k < list->n && !pair[k].wall; k++)
    {
        const dem_vec4 d = DEM_VEC4(record[pair[k].i].x) + sign*DEM_VEC4(record[pair[k].j].x) +
                           DEM_VEC4(s->shift[pair[k].shift]) + gap;
        const dem_vec4 square = d*d;
        const double distance = square[0] + square[1] + square[2], radii = d[3] - s->inner;

        near[k] = distance < square[3];
        rows += near[k];
        touching += distance < radii*radii;
    }
    *few = 2*touching < rows;
    return k;
}

static int is_wall_near(const struct dem_pairs *s, const struct dem_particles *particles,
                        const struct dem_walls *w, const struct dem_pair *q)
{
    const struct dem_particle *const i = &particles->record[q->i];

    return dem_wall_search_distance(&s->wall_search, w, &s->wall_search.neighbor[q->j], i->x) <
           i->radius + s->inner;
}

int dem_pairs_prune(struct dem_pairs *s, const struct dem_particles *particles,
                    const struct dem_walls *w, struct dem_contacts *c)
{
    uint8_t *near;

    use_skin(s, DEM_LIST_INNER);
    DEM_TRY(DEM_NEW(near, c->pairs.n + 1));
    /* classes of walls are last */
    for (size_t k = mark_near(s, particles, &c->pairs, near, &c->rows.few_touch); k < c->pairs.n; k++)
    {
        near[k] = (uint8_t)is_wall_near(s, particles, w, &c->pairs.pair[k]);
    }
    const int status = dem_contacts_prune(c, particles, near);

    dem_memory_free(near);
    DEM_TRY(status);
    dem_skins_list_made(&s->skins, DEM_LIST_INNER);
    return dem_displacement_begin(&s->displacement[DEM_LIST_INNER], particles,
                                  s->skins.skin[DEM_LIST_INNER]);
}
