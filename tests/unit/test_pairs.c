/*
 * test_pairs.c -- the pair list agrees with a search over all pairs.
 *
 * - No pair is missing or listed twice, and each has the right periodic shift: for equal sizes and
 *   up to 1:30, in open and periodic boxes, with ghosts and frozen particles, in any order of
 *   storage.
 * - Sizes far apart are divided into levels, similar sizes are not.
 * - More particles or pairs than a 32-bit index can number are refused.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/random.h"
#include "contacts/grid.h"
#include "contacts/pairs.h"

#include <stdlib.h>
#include <string.h>

enum
{
    N = 1000
};

static const double gap = 0.2;                            /* m: of the outer list */

static struct dem_particles p;
static struct dem_contacts c;
static struct dem_interaction_table table;
static struct dem_domain domain;
static struct dem_pairs pairs;
static struct dem_walls walls;

static double random_number(int what, size_t i)
{
    return dem_random_unit(5, (uint64_t)i, (uint64_t)what, 0);
}

struct packing
{
    const char *name;
    double ratio, box;                                    /* largest to smallest radius; m: edge */
    int periodic[3];
    size_t ghosts;                                        /* of the N */
    /* 1: no owned particle is larger than a fifth of the largest ghost */
    int small;
};

/* Radii from 1/ratio to 1, equal numbers of spheres in equal steps of 1/d^2: many small ones. */
static int scatter(const struct packing *k)
{
    memset(&p, 0, sizeof p);
    dem_particles_init(&p, 0);
    DEM_TRY(dem_particles_grow(&p, N));
    for (size_t i = 0; i < N; i++)
    {
        const double any = 1.0/sqrt(1.0 + random_number(0, i)*(k->ratio*k->ratio - 1.0));
        const double r = k->small && i < N - k->ghosts ? fmin(any, 0.2) : any;
        const double x[3] = {k->box*random_number(1, i), k->box*random_number(2, i), k->box*random_number(3, i)};

        p.record[i] = dem_particle_sphere((int64_t)((i*7919)%N), x, 2.0*r, 1.0, random_number(4, i) < 0.5);
        p.record[i].flags = random_number(5, i) < 0.1 ? DEM_PARTICLE_FROZEN : 0;
    }
    p.n = N - k->ghosts;
    p.ghosts = k->ghosts;
    return DEM_OK;
}

static void set_domain(const struct packing *k)
{
    dem_domain_init(&domain);
    for (int a = 0; a < 3; a++)
    {
        if (k->periodic[a])
        {
            domain.min[a] = 0.0;
            domain.max[a] = k->box;
            domain.periodic[a] = 1;
        }
    }
    dem_domain_finish(&domain);
}

/* a pair, and how often it is in the list */
struct found
{
    int64_t low, high;
    int shift, class;
};

static int by_name(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(struct found));
}

/* All pairs at every shift; returns their number. */
static size_t search_all(struct found *all, size_t capacity)
{
    size_t n = 0;

    for (size_t i = 0; i < p.n; i++)
    {
        for (size_t j = 0; j < p.n + p.ghosts; j++)
        {
            for (int code = 0; code < DEM_SHIFTS; code++)
            {
                const struct dem_particle *const a = &p.record[i], *const b = &p.record[j];
                const double *const s = pairs.shift[code];
                const double x = a->x[0] - b->x[0] - s[0], y = a->x[1] - b->x[1] - s[1],
                             z = a->x[2] - b->x[2] - s[2];
                const double reach = a->radius + b->radius + gap;
                const int first = a->id < b->id,
                          possible = (domain.periodic[0] || code%3 == 1) &&
                                     (domain.periodic[1] || code/3%3 == 1) &&
                                     (domain.periodic[2] || code/9 == 1);

                if (possible && i != j && (first || j >= p.n) &&
                    !(a->flags & b->flags & DEM_PARTICLE_FROZEN) &&
                    x*x + y*y + z*z < reach*reach && n < capacity)
                {
                    memset(&all[n], 0, sizeof all[n]);
                    all[n].low = first ? a->id : b->id;
                    all[n].high = first ? b->id : a->id;
                    all[n].shift = first ? DEM_SHIFTS - 1 - code : code;
                    all[n++].class = a->material + b->material;
                }
            }
        }
    }
    return n;
}

static size_t list(struct found *found, size_t capacity)
{
    size_t n = 0;
    int sorted = 1;

    for (size_t k = 0; k < c.pairs.n && n < capacity; k++)
    {
        const struct dem_pair *const q = &c.pairs.pair[k];

        memset(&found[n], 0, sizeof found[n]);
        found[n].low = p.record[q->i].id;
        found[n].high = p.record[q->j].id;
        found[n].shift = q->shift;
        found[n++].class = q->class;
        sorted &= k == 0 || c.pairs.pair[k - 1].class <= q->class;
    }
    return sorted ? n : 0;
}

static void compare(const struct packing *k)
{
    enum { ROOM = 400000 };
    struct found *const all = calloc(ROOM, sizeof *all), *const found = calloc(ROOM, sizeof *found);
    const double skin[2] = {gap, 0.1*gap};

    set_domain(k);
    dem_pairs_init(&pairs, &domain, skin, 0.0, 1.0);
    if (!all || !found || scatter(k) || dem_contacts_init(&c, &table) ||
        dem_pairs_order(&pairs, &p))
    {
        TAP_OK(0, "%s: %s", k->name, dem_error_text());
        exit(1);
    }
    /* ordering sets it to 0, but moves nothing behind the owned particles */
    p.ghosts = k->ghosts;
    TAP_OK(dem_pairs_find(&pairs, &domain, &p, &walls, &table, &c) == DEM_OK, "%s: searched",
           k->name);
    const size_t many = search_all(all, ROOM), n = list(found, ROOM);

    qsort(all, many, sizeof *all, by_name);
    qsort(found, n, sizeof *found, by_name);
    TAP_OK(many > N/2 && many < ROOM && n == many && memcmp(all, found, n*sizeof *all) == 0,
           "%s: the same %zu pairs as the search over all pairs, %zu", k->name, n, many);
    dem_contacts_free(&c);
    dem_pairs_free(&pairs);
    dem_particles_free(&p);
    free(all);
    free(found);
}

/* Number of levels for N spheres of this ratio, `large` of them of radius 1. */
static int levels(double ratio, size_t large)
{
    const struct packing k = {.ratio = ratio, .box = 12.0};
    struct dem_grid g = {0};

    if (scatter(&k))
    {
        return 0;
    }
    for (size_t i = 0; i < N; i++)
    {
        p.record[i].radius = i < large ? 1.0 : fmin(p.record[i].radius, 0.999);
    }
    dem_grid_choose_levels(&g, &p, 1.0, gap/ratio);
    dem_particles_free(&p);
    return g.levels;
}

int main(void)
{
    static const struct packing packings[] = {
        {.name = "1:1, open", .ratio = 1.0, .box = 12.0},
        {.name = "1:1, periodic along x and y", .ratio = 1.0, .box = 14.0, .periodic = {1, 1, 0}},
        {.name = "1:1, periodic along all axes, so small that images touch images",
         .ratio = 1.0,
         .box = 5.0,
         .periodic = {1, 1, 1}},
        {.name = "1:5, open", .ratio = 5.0, .box = 6.0},
        {.name = "1:5, periodic along all axes", .ratio = 5.0, .box = 6.0, .periodic = {1, 1, 1}},
        {.name = "1:30, open", .ratio = 30.0, .box = 5.0},
        {.name = "1:30, periodic along z", .ratio = 30.0, .box = 5.0, .periodic = {0, 0, 1}},
        {.name = "1:30, periodic along all axes", .ratio = 30.0, .box = 5.0, .periodic = {1, 1, 1}},
        {.name = "1:1, a third are ghosts",
         .ratio = 1.0,
         .box = 12.0,
         .ghosts = N/3,
         .periodic = {1, 0, 0}},
        {.name = "1:30, a third are ghosts",
         .ratio = 30.0,
         .box = 5.0,
         .ghosts = N/3,
         .periodic = {1, 1, 1}},
        {.name = "1:30, the large ones are ghosts",
         .ratio = 30.0,
         .box = 5.0,
         .ghosts = N/3,
         .periodic = {1, 1, 1},
         .small = 1},
    };

    TAP_TRAPS;
    table.classes = 3;
    table.class_of[0][0][1] = table.class_of[0][1][0] = 1;
    table.class_of[0][1][1] = 2;
    for (size_t k = 0; k < sizeof packings/sizeof *packings; k++)
    {
        compare(&packings[k]);
    }
    TAP_OK(!dem_pairs_check_counts(((size_t)1 << 31) - 1, ((size_t)1 << 30) - 1),
           "as many as an index can number");
    TAP_OK(dem_pairs_check_counts((size_t)1 << 31, 0) &&
               strstr(dem_error_text(), "2147483648 particles") &&
               strstr(dem_error_text(), "more ranks"),
           "more particles are refused");
    TAP_OK(dem_pairs_check_counts(5, (size_t)1 << 32) &&
               strstr(dem_error_text(), "4294967296 pairs"),
           "more pairs are refused");
    TAP_OK(levels(1.0, 0) == 1, "equal spheres: one level");
    TAP_OK(levels(30.0, 0) > 1, "1:30: %d levels", levels(30.0, 0));
    TAP_OK(levels(30.0, 1) > 1, "one large one among them: %d levels", levels(30.0, 1));
    TAP_DONE;
}
