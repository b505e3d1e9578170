/*
 * pairs.c -- cells as wide as the longest reach, entries sorted by cell, each owned particle against 27 cells.
 *
 * Periodic images are entries of their own at shifted places, used for searching only; the pair keeps the shift and
 * the true coordinates decide. One grid serves size ratios to about 1:10.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "space/pairs.h"
#include "base/memory.h"
#include "base/sort.h"
#include <math.h>
#include <string.h>

enum
{
    CELLS_A_PARTICLE = 8                                  /* an emptier grid gets wider cells */
};

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
    dem_memory_free(s->entry);
    dem_memory_free(s->cell_start);
    dem_memory_free(s->near);
    memset(s, 0, sizeof *s);
}

size_t dem_pairs_bytes(const struct dem_pairs *s)
{
    return s->wall_region_room*sizeof *s->wall_region + s->at_room*(sizeof *s->at_outer + sizeof *s->at_inner)
         + s->entry_room*sizeof *s->entry + s->cell_room*sizeof *s->cell_start + s->near_room*sizeof *s->near
         + s->search.near_room*sizeof *s->search.near + s->search.candidate_room*sizeof *s->search.candidate;
}

/* ---- the grid ------------------------------------------------------------------------------------------------ */

static void size_grid(struct dem_pairs *s, const double min[3], const double max[3], size_t count)
{
    double cells;

    s->edge = 2.0*s->most_radius + s->outer;
    do
    {
        cells = 1.0;
        for (int k = 0; k < 3; k++)
        {
            s->origin[k] = min[k];
            s->cells[k] = max[k] > min[k] ? (int)fmin(1e6, (max[k] - min[k])/s->edge) + 1 : 1;
            cells *= s->cells[k];
        }
        s->edge *= cells > CELLS_A_PARTICLE*(double)count + 64.0 ? 1.26 : 1.0;
    } while (cells > CELLS_A_PARTICLE*(double)count + 64.0);
}

static int cell_axis(const struct dem_pairs *s, const double x[3], int k)
{
    const double c = floor((x[k] - s->origin[k])/s->edge);

    return c < 0.0 ? 0 : c >= s->cells[k] ? s->cells[k] - 1 : (int)c;
}

static size_t cell_of(const struct dem_pairs *s, const double x[3])
{
    return ((size_t)cell_axis(s, x, 2)*(size_t)s->cells[1] + (size_t)cell_axis(s, x, 1))*(size_t)s->cells[0]
         + (size_t)cell_axis(s, x, 0);
}

static void owned_box(const struct dem_particles *p, double min[3], double max[3])
{
    for (int k = 0; k < 3; k++)
    {
        min[k] = INFINITY;
        max[k] = -INFINITY;
        for (size_t i = 0; i < p->n; i++)
        {
            min[k] = fmin(min[k], p->record[i].x[k]);
            max[k] = fmax(max[k], p->record[i].x[k]);
        }
    }
}

int dem_pairs_order(struct dem_pairs *s, struct dem_particles *p)
{
    struct dem_sort_pair *key, *scratch;
    uint32_t *order;
    double min[3], max[3];

    owned_box(p, min, max);
    size_grid(s, min, max, p->n);
    DEM_TRY(DEM_NEW(key, p->n + 1));
    DEM_TRY(DEM_NEW(scratch, p->n + 1));
    DEM_TRY(DEM_NEW(order, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        key[i] = (struct dem_sort_pair){.hi = cell_of(s, p->record[i].x), .lo = (uint64_t)p->record[i].id, .index = (uint32_t)i};
    }
    dem_sort_pairs(key, p->n, scratch);
    for (size_t i = 0; i < p->n; i++)
    {
        order[i] = key[i].index;
    }
    dem_particles_reorder(p, order, p->n);
    dem_memory_free(key);
    dem_memory_free(scratch);
    dem_memory_free(order);
    return DEM_OK;
}

/* Entries: every record at every shift that brings it within reach of the owned particles' box. */
static int make_entries(struct dem_pairs *s, const struct dem_domain *d, const struct dem_particles *p, const double min[3],
                        const double max[3])
{
    const double reach = 2.0*s->most_radius + s->outer;

    s->entries = 0;
    for (int code = 0; code < DEM_SHIFTS; code++)
    {
        int possible = 1;

        for (int k = 0; k < 3; k++)
        {
            possible &= d->periodic[k] || dem_shift_axis(code, k) == 0;
        }
        for (size_t i = 0; possible && i < p->n + p->ghosts; i++)
        {
            struct dem_grid_entry e = {.radius = p->record[i].radius, .particle = (uint32_t)i, .shift = (uint32_t)code};
            int inside = 1;

            for (int k = 0; k < 3; k++)
            {
                e.x[k] = p->record[i].x[k] + s->shift[code][k];
                inside &= e.x[k] > min[k] - reach && e.x[k] < max[k] + reach;
            }
            if (inside)
            {
                DEM_TRY(DEM_GROW(s->entry, s->entry_room, s->entries + 1));
                s->entry[s->entries++] = e;
            }
        }
    }
    return DEM_OK;
}

static int sort_entries(struct dem_pairs *s)
{
    const size_t cells = (size_t)s->cells[0]*(size_t)s->cells[1]*(size_t)s->cells[2];
    struct dem_grid_entry *sorted;
    uint32_t *cell;

    DEM_TRY(DEM_GROW(s->cell_start, s->cell_room, cells + 2));
    DEM_TRY(DEM_NEW(sorted, s->entry_room));
    DEM_TRY(DEM_NEW(cell, s->entries + 1));
    memset(s->cell_start, 0, (cells + 2)*sizeof *s->cell_start);
    for (size_t e = 0; e < s->entries; e++)
    {
        cell[e] = (uint32_t)cell_of(s, s->entry[e].x);
        s->cell_start[cell[e] + 2]++;
    }
    for (size_t c = 2; c < cells + 2; c++)
    {
        s->cell_start[c] += s->cell_start[c - 1];
    }
    for (size_t e = 0; e < s->entries; e++)
    {
        sorted[s->cell_start[cell[e] + 1]++] = s->entry[e];
    }
    dem_memory_free(s->entry);
    dem_memory_free(cell);
    s->entry = sorted;
    return DEM_OK;
}

/* ---- pairs --------------------------------------------------------------------------------------------------- */

static int add_pair(struct dem_contacts *c, struct dem_pair pair)
{
    DEM_TRY(DEM_GROW(c->pair, c->pair_room, c->pairs + 1));
    pair.row = DEM_ROW_NONE;
    c->pair[c->pairs++] = pair;
    return DEM_OK;
}

static int try_pair(struct dem_contacts *c, const struct dem_particles *p, const struct dem_recipe *r, uint32_t a,
                    const struct dem_grid_entry *e)
{
    const struct dem_particle *const me = &p->record[a], *const it = &p->record[e->particle];
    const int first = me->id < it->id, owned = e->particle < p->n;
    const int class = r->class_of[0][me->material][it->material];
    const struct dem_pair pair = {.i = first ? a : e->particle, .j = first ? e->particle : a, .class = (uint16_t)class,
                                  .shift = (uint8_t)(first ? DEM_SHIFTS - 1 - (int)e->shift : (int)e->shift)};

    if (me->id == it->id)
    {
        DEM_REQUIRE(e->particle == a && e->shift == DEM_SHIFT_NONE, DEM_ERROR_INPUT,
                    "particle %lld reaches its own periodic image; make the domain at least two diameters and a skin wide",
                    (long long)me->id);
        return DEM_OK;
    }
    /* two owned particles meet twice, once from each side: the lower id keeps the pair; two frozen ones never do */
    return (owned && !first) || (me->flags & it->flags & DEM_PARTICLE_FROZEN) ? DEM_OK : add_pair(c, pair);
}

static int pairs_of(struct dem_pairs *s, const struct dem_particles *p, const struct dem_recipe *r, struct dem_contacts *c,
                    uint32_t a)
{
    const double *const x = p->record[a].x;
    int from[3], to[3];

    for (int k = 0; k < 3; k++)
    {
        const int cell = cell_axis(s, x, k);

        from[k] = cell > 0 ? cell - 1 : 0;
        to[k] = cell + 1 < s->cells[k] ? cell + 1 : cell;
    }
    for (int z = from[2]; z <= to[2]; z++)
    {
        for (int y = from[1]; y <= to[1]; y++)
        {
            const size_t row = ((size_t)z*(size_t)s->cells[1] + (size_t)y)*(size_t)s->cells[0];

            for (uint32_t e = s->cell_start[row + (size_t)from[0]]; e < s->cell_start[row + (size_t)to[0] + 1]; e++)
            {
                const struct dem_grid_entry *const b = &s->entry[e];
                const double dx = x[0] - b->x[0], dy = x[1] - b->x[1], dz = x[2] - b->x[2];
                const double reach = p->record[a].radius + b->radius + s->outer;

                if (dx*dx + dy*dy + dz*dz < reach*reach)
                {
                    DEM_TRY(try_pair(c, p, r, a, b));
                }
            }
        }
    }
    return DEM_OK;
}

static int wall_pairs(struct dem_pairs *s, const struct dem_particles *p, const struct dem_walls *w, const struct dem_recipe *r,
                      struct dem_contacts *c)
{
    DEM_TRY(dem_wall_search_find(&s->search, w, p, s->outer));
    DEM_TRY(DEM_GROW(s->wall_region, s->wall_region_room, s->search.nears));
    for (size_t k = 0; k < s->search.nears; k++)
    {
        const struct dem_wall_near *const near = &s->search.near[k];
        const struct dem_particle *const me = &p->record[near->particle];
        const int material = w->wall[w->region[near->region].wall].material;

        s->wall_region[k] = near->region;
        if (!(me->flags & DEM_PARTICLE_FROZEN))
        {
            DEM_TRY(add_pair(c, (struct dem_pair){.i = near->particle, .j = (uint32_t)k, .shift = DEM_SHIFT_NONE, .wall = 1,
                                                  .class = (uint16_t)r->class_of[1][me->material][material]}));
        }
    }
    return DEM_OK;
}

/* Stable counting sort by class. */
static int sort_by_class(struct dem_contacts *c)
{
    struct dem_pair *sorted;
    size_t *start;

    if (c->classes < 2)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(sorted, c->pair_room));
    DEM_TRY(DEM_NEW(start, c->classes + 1));
    for (size_t k = 0; k < c->pairs; k++)
    {
        start[c->pair[k].class + 1]++;
    }
    for (int s = 1; s <= c->classes; s++)
    {
        start[s] += start[s - 1];
    }
    for (size_t k = 0; k < c->pairs; k++)
    {
        sorted[start[c->pair[k].class]++] = c->pair[k];
    }
    dem_memory_free(c->pair);
    dem_memory_free(start);
    c->pair = sorted;
    return DEM_OK;
}

static int remember_positions(struct dem_pairs *s, const struct dem_particles *p)
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

int dem_pairs_find(struct dem_pairs *s, const struct dem_domain *d, const struct dem_particles *p, const struct dem_walls *w,
                   const struct dem_recipe *r, struct dem_contacts *c)
{
    double min[3], max[3];

    owned_box(p, min, max);
    c->pairs = 0;
    if (p->n > 0)
    {
        DEM_TRY(make_entries(s, d, p, min, max));
        size_grid(s, min, max, s->entries);
        DEM_TRY(sort_entries(s));
    }
    for (uint32_t a = 0; a < p->n; a++)
    {
        DEM_TRY(pairs_of(s, p, r, c, a));
    }
    DEM_TRY(wall_pairs(s, p, w, r, c));
    DEM_TRY(sort_by_class(c));
    DEM_TRY(dem_contacts_adjoin(c, p));
    return remember_positions(s, p);
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
