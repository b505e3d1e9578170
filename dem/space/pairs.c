/*
 * pairs.c -- the order of particles, pruning, and how far particles have come. Finding pairs is in pairs_find.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/pairs.h"
#include "base/error.h"
#include "base/memory.h"
#include "space/grid.h"
#include <math.h>
#include <string.h>

void dem_pairs_init(struct dem_pairs *s, const struct dem_domain *d, const double skin[2], double reach, double most_radius)
{
    memset(s, 0, sizeof *s);
    s->outer = reach + skin[0];
    s->inner = reach + skin[1];
    s->half_outer = 0.5*skin[0];
    s->half_inner = 0.5*skin[1];
    s->most_radius = most_radius;
    dem_domain_shifts(d, s->shift);
}

void dem_pairs_free(struct dem_pairs *s)
{
    dem_wall_search_free(&s->search);
    dem_memory_free(s->wall_region);
    dem_memory_free(s->at_outer);
    dem_memory_free(s->at_inner);
    dem_memory_free(s->near);
    memset(s, 0, sizeof *s);
}

size_t dem_pairs_bytes(const struct dem_pairs *s)
{
    return s->wall_region_room*sizeof *s->wall_region + s->at_room*(sizeof *s->at_outer + sizeof *s->at_inner)
         + s->near_room*sizeof *s->near
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

int dem_pairs_remember(struct dem_pairs *s, const struct dem_particles *p)
{
    const size_t room = dem_memory_room(s->at_room, 3*p->n + 3);

    DEM_TRY(DEM_RESIZE(s->at_outer, s->at_room, room));
    DEM_TRY(DEM_RESIZE(s->at_inner, s->at_room, room));
    s->at_room = room;
    for (size_t i = 0; i < p->n; i++)
    {
        memcpy(s->at_outer + 3*i, p->record[i].x, sizeof p->record[i].x);
    }
    s->moved_outer = 0.0;
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
    DEM_TRY(DEM_GROW(s->near, s->near_room, c->pairs + 1));
    for (size_t k = 0; k < c->pairs; k++)
    {
        s->near[k] = (uint8_t)(c->pair[k].wall ? wall_near(s, p, w, &c->pair[k]) : pair_near(s, p, &c->pair[k]));
    }
    for (size_t i = 0; i < p->n; i++)
    {
        memcpy(s->at_inner + 3*i, p->record[i].x, sizeof p->record[i].x);
    }
    s->moved_inner = 0.0;
    return dem_contacts_prune(c, p, s->near);
}

static double furthest(const double *at, const struct dem_particles *p)
{
    double most = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        const double *const x = p->record[i].x;
        const double dx = x[0] - at[3*i], dy = x[1] - at[3*i + 1], dz = x[2] - at[3*i + 2], d = dx*dx + dy*dy + dz*dz;

        most = d > most ? d : most;
    }
    return sqrt(most);
}

void dem_pairs_moved(const struct dem_pairs *s, const struct dem_particles *p, double *outer, double *inner)
{
    *outer = furthest(s->at_outer, p);
    *inner = furthest(s->at_inner, p);
}
