/*
 * pairs_find.c -- search for pairs in the cell lists, then for walls.
 *
 * Within a level an entry is tested against the rest of its own cell, the next cell along x, and
 * the rows of three cells at (y + 1, z) and (y - 1 ... y + 1, z + 1), so that each pair is tested
 * once. A large particle is tested against the cells of all smaller levels around it. A test in
 * single precision on eight entries at a time preselects; the pair is decided in double precision.
 *
 * Periodic images are entries of their own at shifted positions, used for the search only; the pair
 * stores the shift. Two images never form a pair. A pair of an owned particle and an image of
 * another owned one is found twice, mirrored: the one whose unshifted partner comes first in memory
 * is kept, so that no row of an early particle comes late.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/grid.h"
#include "contacts/pairs.h"
#include "core/error.h"
#include "core/memory.h"
#include "laws/effect.h"
#include <math.h>

enum
{
    WIDE = 8,                     /* entries tested at a time */
    RUNS = 64                     /* limit of runs of one call */
};

struct run                                                /* contiguous entries */
{
    uint32_t from, end;
};

struct finder
{
    struct dem_pairs *s;
    const struct dem_particles *p;
    const struct dem_interaction_table *r;
    struct dem_contacts *c;
    struct dem_grid *g;
    uint32_t *hit;                /* preselected entries */
    size_t hit_capacity;
};

typedef float float8 __attribute__((vector_size(32), aligned(4), may_alias));
typedef int int8 __attribute__((vector_size(32)));

/* ---- preselection ---------------------------------------------------------------------------- */

/* Select the entries of the runs whose distance to `me` (x, y, z, radius with gap) is below the sum
   of radii; returns their number. Each index is written, and overwritten if its entry was not near:
   `hit` has capacity for all entries and WIDE more. */
DEM_KERNEL
static size_t preselect(const struct dem_grid *g, const struct run *run, int runs,
                        const float me[4], uint32_t *restrict hit)
{
    const int8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
    size_t n = 0;

    for (int k = 0; k < runs; k++)
    {
        for (uint32_t e = run[k].from; e < run[k].end; e += WIDE)
        {
            const float8 dx = *(const float8 *)(g->x + e) - me[0],
                         dy = *(const float8 *)(g->y + e) - me[1];
            const float8 dz = *(const float8 *)(g->z + e) - me[2],
                         reach = *(const float8 *)(g->radius + e) + me[3];
            const int8 near =
                (dx*dx + dy*dy + dz*dz < reach*reach) & (lane < (int)(run[k].end - e));

            for (int l = 0; l < WIDE; l++)
            {
                hit[n] = e + (uint32_t)l;
                n -= (size_t)(ptrdiff_t)near[l];          /* true is -1 */
            }
        }
    }
    return n;
}

/* ---- pairs ----------------------------------------------------------------------------------- */

/* Grows by an eighth only: the list is a large part of all memory. */
static inline int reserve(struct dem_contacts *c, size_t pairs)
{
    const size_t capacity = pairs + pairs/8 + WIDE;

    if (pairs > c->pairs.capacity)
    {
        DEM_TRY(DEM_RESIZE(c->pairs.pair, c->pairs.n, capacity));
        c->pairs.capacity = capacity;
    }
    return DEM_OK;
}

static inline int is_owned(const struct finder *f, uint32_t e)
{
    return f->g->particle[e] < f->p->n && f->g->shift[e] == DEM_SHIFT_NONE;
}

/* Add the pair of two entries if it is near. `owned` is an owned particle without shift. The caller
   has reserved capacity for the pair. */
static inline int try_pair(struct finder *f, uint32_t owned, uint32_t other)
{
    const struct dem_grid *const g = f->g;
    const uint32_t a = g->particle[owned], b = g->particle[other];
    const struct dem_particle *const me = &f->p->record[a], *const it = &f->p->record[b];
    const int code = g->shift[other];
    const double *const shift = f->s->shift[code];
    const double dx = me->x[0] - (it->x[0] + shift[0]), dy = me->x[1] - (it->x[1] + shift[1]),
                 dz = me->x[2] - (it->x[2] + shift[2]);
    const double reach = me->radius + it->radius + f->s->outer;

    if (!(dx*dx + dy*dy + dz*dz < reach*reach))
    {
        return DEM_OK;
    }
    const int first = me->id < it->id, mirrored = b < f->p->n && code != DEM_SHIFT_NONE;

    DEM_REQUIRE(
        me->id != it->id, DEM_ERROR_INPUT,
        "particle %lld reaches its own periodic image; make the domain wider than a diameter and the outer skin",
        (long long)me->id);
    if ((mirrored && a > b) || (me->body && me->body == it->body) ||
        (me->flags & it->flags & DEM_PARTICLE_FROZEN && !f->r->contact_scalars))
    {
        return DEM_OK;
    }
    f->c->pairs.pair[f->c->pairs.n++] =
        (struct dem_pair){.i = first ? a : b,
                          .j = first ? b : a,
                          .row = DEM_ROW_NONE,
                          .class = (uint16_t)f->r->class_of[0][me->material][it->material],
                          .shift = (uint8_t)(first ? DEM_SHIFTS - 1 - code : code)};
    return DEM_OK;
}

static int pairs_of(struct finder *f, uint32_t e, const struct run *run, int runs)
{
    const struct dem_grid *const g = f->g;
    const float me[4] = {g->x[e], g->y[e], g->z[e], g->radius[e] + (float)f->s->outer + g->slack};
    const int owned = is_owned(f, e);
    size_t limit = WIDE, hits;

    for (int k = 0; k < runs; k++)
    {
        limit += run[k].end - run[k].from;
    }
    DEM_TRY(DEM_GROW(f->hit, f->hit_capacity, limit));
    hits = preselect(g, run, runs, me, f->hit);
    DEM_TRY(reserve(f->c, f->c->pairs.n + hits));
    for (size_t k = 0; k < hits; k++)
    {
        const uint32_t other = f->hit[k];

        if (owned)
        {
            DEM_TRY(try_pair(f, e, other));
        }
        else if (is_owned(f, other))
        {
            DEM_TRY(try_pair(f, other, e));
        }
    }
    return DEM_OK;
}

/* ---- within a level -------------------------------------------------------------------------- */

/* The run of the cells x - 1 to x + 1 of a row, if the row exists and has entries. */
static int add_run(const struct dem_grid *g, const struct dem_grid_level *l, const int cell[3],
                   struct run *run)
{
    const int last = l->cells[0] - 1;

    if (cell[1] < 0 || cell[1] >= l->cells[1] || cell[2] >= l->cells[2])
    {
        return 0;
    }
    run->from = dem_grid_first_entry(g, l, cell[0] > 0 ? cell[0] - 1 : 0, cell[1], cell[2]);
    run->end =
        dem_grid_first_entry(g, l, (cell[0] < last ? cell[0] + 1 : last) + 1, cell[1], cell[2]);
    return run->from < run->end;
}

static int pairs_of_cell(struct finder *f, const struct dem_grid_level *l, const int cell[3])
{
    static const int behind[4][2] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    const struct dem_grid *const g = f->g;
    const uint32_t from = dem_grid_first_entry(g, l, cell[0], cell[1], cell[2]),
                   end = dem_grid_first_entry(g, l, cell[0] + 1, cell[1], cell[2]);
    struct run run[5];
    int runs = 1;

    if (from == end)
    {
        return DEM_OK;
    }
    run[0].end = dem_grid_first_entry(g, l, (cell[0] + 1 < l->cells[0] ? cell[0] + 1 : cell[0]) + 1,
                                      cell[1], cell[2]);
    for (int k = 0; k < 4; k++)
    {
        const int beside[3] = {cell[0], cell[1] + behind[k][0], cell[2] + behind[k][1]};

        runs += add_run(g, l, beside, &run[runs]);
    }
    for (uint32_t e = from; e < end; e++)
    {
        run[0].from = e + 1;
        DEM_TRY(pairs_of(f, e, run, runs));
    }
    return DEM_OK;
}

static int pairs_of_level(struct finder *f, const struct dem_grid_level *l)
{
    int cell[3];

    for (cell[2] = 0; cell[2] < l->cells[2]; cell[2]++)
    {
        for (cell[1] = 0; cell[1] < l->cells[1]; cell[1]++)
        {
            for (cell[0] = 0; cell[0] < l->cells[0]; cell[0]++)
            {
                DEM_TRY(pairs_of_cell(f, l, cell));
            }
        }
    }
    return DEM_OK;
}

/* ---- between levels -------------------------------------------------------------------------- */

/* Distance of a coordinate from the cells with index c along an axis. */
static double distance_to_cell(const struct dem_grid_level *l, double x, int c)
{
    const double low = c*l->edge - x, high = x - (c + 1)*l->edge;

    return low > 0.0 ? low : high > 0.0 ? high : 0.0;
}

/* Test the smaller particles around a large one, row by row within the sphere of possible
   neighbours. */
static int pairs_with_smaller(struct finder *f, uint32_t e, const struct dem_grid_level *l)
{
    const struct dem_grid *const g = f->g;
    const double x[3] = {g->x[e], g->y[e], g->z[e]},
                 reach = g->radius[e] + l->radius + f->s->outer + 2.0*g->slack;
    struct run run[RUNS];
    int runs = 0;

    for (int z = dem_grid_cell(l, x[2] - reach, 2); z <= dem_grid_cell(l, x[2] + reach, 2); z++)
    {
        for (int y = dem_grid_cell(l, x[1] - reach, 1); y <= dem_grid_cell(l, x[1] + reach, 1); y++)
        {
            const double dy = distance_to_cell(l, x[1], y), dz = distance_to_cell(l, x[2], z),
                         square = reach*reach - dy*dy - dz*dz;
            const double half = square > 0.0 ? sqrt(square) : -1.0;

            if (half < 0.0)
            {
                continue;
            }
            run[runs].from = dem_grid_first_entry(g, l, dem_grid_cell(l, x[0] - half, 0), y, z);
            run[runs].end = dem_grid_first_entry(g, l, dem_grid_cell(l, x[0] + half, 0) + 1, y, z);
            runs += run[runs].from < run[runs].end;
            if (runs == RUNS)
            {
                DEM_TRY(pairs_of(f, e, run, runs));
                runs = 0;
            }
        }
    }
    return pairs_of(f, e, run, runs);
}

static int pairs_between(struct finder *f, int large)
{
    const struct dem_grid *const g = f->g;
    const struct dem_grid_level *const l = &g->level[large];
    const size_t cells = (size_t)l->cells[0]*(size_t)l->cells[1]*(size_t)l->cells[2];

    for (uint32_t e = g->start[l->first]; e < g->start[l->first + cells]; e++)
    {
        for (int small = 0; small < large; small++)
        {
            DEM_TRY(pairs_with_smaller(f, e, &g->level[small]));
        }
    }
    return DEM_OK;
}

/* ---- walls ----------------------------------------------------------------------------------- */

static struct dem_facet_key facet_key(const struct dem_walls *w,
                                      const struct dem_wall_neighbor *near,
                                      const struct dem_particle *me)
{
    const struct dem_facet *const r = &w->facet[near->facet];
    struct dem_facet_key key = {.number = r->number};
    int turns[3];

    dem_walls_turns(w, r->wall, turns);
    key.image = dem_facet_image(r->distinct, turns, near->image, me->image);
    return key;
}

static int wall_pairs(struct dem_pairs *s, const struct dem_particles *particles,
                      const struct dem_walls *w,
                      const struct dem_interaction_table *r, struct dem_contacts *c)
{
    DEM_TRY(dem_wall_search_find(&s->wall_search, w, particles, s->outer));
    DEM_TRY(DEM_GROW(s->wall_facet, s->wall_facet_capacity, s->wall_search.neighbors));
    for (size_t k = 0; k < s->wall_search.neighbors; k++)
    {
        const struct dem_wall_neighbor *const near = &s->wall_search.neighbor[k];
        const struct dem_particle *const me = &particles->record[near->particle];
        const struct dem_wall *const wall = &w->wall[w->facet[near->facet].wall];
        const int *const class = r->class_of[DEM_PARTNER_WALL + wall->frictionless][me->material];

        s->wall_facet[k] = facet_key(w, near, me);
        if (!(me->flags & DEM_PARTICLE_FROZEN) || r->contact_scalars)
        {
            DEM_TRY(reserve(c, c->pairs.n + 1));
            c->pairs.pair[c->pairs.n++] =
                (struct dem_pair){.i = near->particle,
                                  .j = (uint32_t)k,
                                  .row = DEM_ROW_NONE,
                                  .shift = DEM_SHIFT_NONE,
                                  .wall = 1,
                                  .class = (uint16_t)class[wall->material]};
        }
    }
    return DEM_OK;
}

/* ---- all together ---------------------------------------------------------------------------- */

static int find(struct finder *f, const struct dem_domain *d)
{
    struct dem_grid *const g = f->g;

    DEM_TRY(dem_grid_fill(g, d, f->p, f->s->shift));
    for (int k = 0; k < g->levels; k++)
    {
        DEM_TRY(pairs_of_level(f, &g->level[k]));
        DEM_TRY(pairs_between(f, k));
    }
    return DEM_OK;
}

int dem_pairs_search(struct dem_pairs *s, const struct dem_domain *d,
                     const struct dem_particles *particles,
                     const struct dem_interaction_table *r, struct dem_contacts *c)
{
    struct finder f = {.s = s, .p = particles, .r = r, .c = c, .g = &s->grid};
    /* usual: a little less than in a settled bed */
    const size_t before = c->pairs.n, usual = 3*particles->n;

    c->pairs.n = 0;
    DEM_TRY(dem_pairs_check_counts(particles->n + particles->ghosts, 0));
    dem_grid_choose_levels(&s->grid, particles, s->max_radius, s->outer);
    const int ready = reserve(c, before > usual ? before : usual),
              status = ready || particles->n == 0 ? ready : find(&f, d);

    dem_memory_free(f.hit);
    return status;
}

int dem_pairs_find(struct dem_pairs *s, const struct dem_domain *d,
                   const struct dem_particles *particles,
                   const struct dem_walls *w, const struct dem_interaction_table *r,
                   struct dem_contacts *c)
{
    DEM_TRY(dem_pairs_search(s, d, particles, r, c));
    dem_grid_free(&s->grid);      /* a run searches rarely */
    DEM_TRY(wall_pairs(s, particles, w, r, c));
    DEM_TRY(dem_pairs_check_counts(particles->n + particles->ghosts, c->pairs.n));
    /* all rows of a particle are contiguous and in the order of particles: searches across levels
       or periodic faces find some of them late */
    DEM_TRY(dem_pair_list_sort(&c->pairs, particles->n, (size_t)c->rows.classes));
    DEM_TRY(dem_pair_list_build_adjacency(&c->pairs, particles));
    dem_skins_list_made(&s->skins, DEM_LIST_OUTER);
    return dem_displacement_begin(&s->displacement[DEM_LIST_OUTER], particles,
                                  s->skins.skin[DEM_LIST_OUTER]);
}
