/*
 * packing.c -- grids of cells, one for each octave of diameters; random places; pushing apart.
 *
 * A function of the seed and the list of diameters alone, done in one order, so that all ranks get the same bits.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/packing.h"
#include "base/error.h"
#include "base/memory.h"
#include "base/random.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum
{
    USE_PLACE = 201, USE_PUSH = 211,                      /* streams of random numbers */
    LEVELS = 12,                                          /* octaves of diameters, the last holds all that is smaller */
    TRIALS = 12,                                          /* random places before a sphere makes room */
    DRAWS = 1000,                                         /* of a place; no vessel has a chance below 0.5 to be hit */
    PATIENCE = 50,                                        /* sweeps before a sphere that is wedged goes elsewhere */
    SWEEPS = 3000,                                        /* of pushing */
    CELLS_A_SPHERE = 8
};

static const double most_fraction = 0.57;                 /* pushing ends well at 0.56; random close packing is 0.64 */
static const double apart = 1e-4;                         /* 1  of the sum of radii: pushed this much further than touching */

struct spot
{
    double x[3], radius;
    int32_t next, level;
};

struct level
{
    double edge, most;                                    /* m: of a cell, largest radius present */
    int64_t cells[3];
    size_t first;                                         /* of its cells in places.head */
};

struct places
{
    double min[3];
    struct level level[LEVELS];
    int32_t *head;                                        /* chains of spots by cell, -1 ends */
    struct spot *spot;                                    /* n to place, then those that are there */
    int32_t n, all;
};

/* ---- the grids ----------------------------------------------------------------------------------------------- */

static int level_of(double diameter, double largest)
{
    int k = 0;

    for (double edge = 0.5*largest; k < LEVELS - 1 && diameter <= edge; edge *= 0.5)
    {
        k++;
    }
    return k;
}

static int64_t cell_on(const struct places *s, const struct level *l, int axis, double x)
{
    const double at = floor((x - s->min[axis])/l->edge);

    return at < 0.0 ? 0 : at >= (double)l->cells[axis] ? l->cells[axis] - 1 : (int64_t)at;
}

static size_t cell_of(const struct places *s, const struct spot *p)
{
    const struct level *const l = &s->level[p->level];

    return l->first + (size_t)((cell_on(s, l, 2, p->x[2])*l->cells[1] + cell_on(s, l, 1, p->x[1]))*l->cells[0] + cell_on(s, l, 0, p->x[0]));
}

static void enter(struct places *s, int32_t i)
{
    const size_t cell = cell_of(s, &s->spot[i]);

    s->spot[i].next = s->head[cell];
    s->head[cell] = i;
}

static void move(struct places *s, int32_t i, const double x[3])
{
    const size_t from = cell_of(s, &s->spot[i]);

    memcpy(s->spot[i].x, x, sizeof s->spot[i].x);
    if (cell_of(s, &s->spot[i]) != from)
    {
        int32_t *link = &s->head[from];

        while (*link != i)
        {
            link = &s->spot[*link].next;
        }
        *link = s->spot[i].next;
        enter(s, i);
    }
}

static int make_grids(struct places *s, const struct dem_vessel *v, double largest)
{
    size_t cells = 0;

    memcpy(s->min, v->min, sizeof s->min);
    for (int k = 0; k < LEVELS; k++)
    {
        struct level *const l = &s->level[k];
        double count;

        l->edge = largest/(double)(1 << k);
        do
        {
            count = 1.0;
            for (int axis = 0; axis < 3; axis++)
            {
                l->cells[axis] = (int64_t)fmin(1e6, (v->max[axis] - v->min[axis])/l->edge) + 1;
                count *= (double)l->cells[axis];
            }
            l->edge *= count > CELLS_A_SPHERE*(double)s->all + 64.0 ? 1.26 : 1.0;
        } while (count > CELLS_A_SPHERE*(double)s->all + 64.0);
        l->first = cells;
        cells += (size_t)count;
    }
    DEM_TRY(DEM_NEW(s->head, cells + 1));
    memset(s->head, -1, (cells + 1)*sizeof *s->head);
    return DEM_OK;
}

struct walk                                               /* who looks for neighbours, and from where */
{
    double x[3], radius;
    int32_t self;
};

/* Those that overlap: at most `room` of them into found; returns how many. */
static int overlaps(const struct places *s, const struct walk *w, int32_t *found, int room)
{
    int count = 0;

    for (int k = 0; k < LEVELS; k++)
    {
        const struct level *const l = &s->level[k];
        const double reach = w->radius + l->most;
        int64_t from[3], to[3];

        if (l->most == 0.0)
        {
            continue;
        }
        for (int axis = 0; axis < 3; axis++)
        {
            from[axis] = cell_on(s, l, axis, w->x[axis] - reach);
            to[axis] = cell_on(s, l, axis, w->x[axis] + reach);
        }
        for (int64_t z = from[2]; z <= to[2]; z++)
        {
            for (int64_t y = from[1]; y <= to[1]; y++)
            {
                for (int64_t x = from[0]; x <= to[0]; x++)
                {
                    for (int32_t m = s->head[l->first + (size_t)((z*l->cells[1] + y)*l->cells[0] + x)]; m >= 0; m = s->spot[m].next)
                    {
                        const struct spot *const p = &s->spot[m];
                        const double dx = w->x[0] - p->x[0], dy = w->x[1] - p->x[1], dz = w->x[2] - p->x[2], d = w->radius + p->radius;

                        if (dx*dx + dy*dy + dz*dz < d*d && m != w->self)
                        {
                            found[count++] = m;
                            if (count == room)
                            {
                                return count;
                            }
                        }
                    }
                }
            }
        }
    }
    return count;
}

/* ---- random places ------------------------------------------------------------------------------------------- */

struct by_size
{
    double diameter;
    int32_t index;
};

static int larger_first(const void *a, const void *b)
{
    const struct by_size *const p = a, *const q = b;

    return p->diameter > q->diameter ? -1 : p->diameter < q->diameter ? 1 : (p->index > q->index) - (p->index < q->index);
}

/* 1: found a free place, 0: the last one that was tried. `draw` counts those that missed the vessel, too. */
static int find_place(const struct places *s, const struct dem_packing *p, int32_t i, uint64_t draw, double place[3])
{
    struct walk w = {.radius = 0.5*p->diameter[i], .self = i};
    int32_t found;
    int trials = 0;

    memcpy(place, s->spot[i].x, sizeof w.x);
    for (const uint64_t end = draw + DRAWS; draw < end && trials < TRIALS; draw++)
    {
        double u[3];

        for (int k = 0; k < 3; k++)
        {
            u[k] = dem_random_unit(p->seed, (uint64_t)i, draw, USE_PLACE + (uint64_t)k);
        }
        if (dem_vessel_place(p->vessel, w.radius, u, w.x))
        {
            memcpy(place, w.x, sizeof w.x);
            trials++;
            if (overlaps(s, &w, &found, 1) == 0)
            {
                return 1;
            }
        }
    }
    return 0;
}

static int place_all(struct places *s, const struct dem_packing *p, uint8_t *waits)
{
    struct by_size *order;

    DEM_TRY(DEM_NEW(order, p->n + 1));
    for (int32_t i = 0; i < p->n; i++)
    {
        order[i] = (struct by_size){p->diameter[i], i};
    }
    qsort(order, (size_t)p->n, sizeof *order, larger_first);
    for (int32_t k = 0; k < p->n; k++)
    {
        struct level *const l = &s->level[s->spot[order[k].index].level];

        waits[order[k].index] = (uint8_t)!find_place(s, p, order[k].index, 0, s->spot[order[k].index].x);
        l->most = fmax(l->most, s->spot[order[k].index].radius);
        enter(s, order[k].index);
    }
    dem_memory_free(order);
    return DEM_OK;
}

/* ---- pushing ------------------------------------------------------------------------------------------------- */

/* Move i and j apart; who was there before stays. */
static void push(struct places *s, const struct dem_packing *p, int32_t i, int32_t j, uint64_t sweep)
{
    const struct spot *const a = &s->spot[i], *const b = &s->spot[j];
    const double want = (a->radius + b->radius)*(1.0 + apart), share = j < s->n ? 0.5 : 1.0;
    double r[3] = {a->x[0] - b->x[0], a->x[1] - b->x[1], a->x[2] - b->x[2]}, xi[3], xj[3];
    double size = sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2]);

    for (int k = 0; k < 3 && size < 1e-6*want; k++)       /* one in the other: any direction */
    {
        r[k] = want*(dem_random_unit(p->seed, (uint64_t)i, sweep, USE_PUSH + (uint64_t)k) - 0.5);
    }
    size = size < 1e-6*want ? fmax(1e-6*want, sqrt(r[0]*r[0] + r[1]*r[1] + r[2]*r[2])) : size;
    for (int k = 0; k < 3; k++)
    {
        const double step = size < want ? (want/size - 1.0)*r[k] : 0.0;

        xi[k] = a->x[k] + share*step;
        xj[k] = b->x[k] - (1.0 - share)*step;
    }
    dem_vessel_confine(p->vessel, a->radius, xi);
    move(s, i, xi);
    if (j < s->n)
    {
        dem_vessel_confine(p->vessel, b->radius, xj);
        move(s, j, xj);
    }
}

/* Who is wedged between spheres that stay starts anew elsewhere. */
static void free_wedged(struct places *s, const struct dem_packing *p, uint8_t *waits, uint64_t sweep)
{
    for (int32_t i = 0; i < p->n; i++)
    {
        struct walk w = {.radius = s->spot[i].radius, .self = i};
        int32_t found[64];
        int wedged = 0;

        memcpy(w.x, s->spot[i].x, sizeof w.x);
        for (int k = waits[i] ? overlaps(s, &w, found, 64) : 0; k > 0; k--)
        {
            wedged |= found[k - 1] >= s->n;
        }
        if (wedged)
        {
            (void)find_place(s, p, i, sweep*DRAWS, w.x);
            move(s, i, w.x);
        }
    }
}

/* All that wait make room once; who is touched by that waits next. Returns how many still overlap. */
static int32_t sweep_once(struct places *s, const struct dem_packing *p, uint8_t *waits, uint8_t *next, uint64_t sweep)
{
    int32_t left = 0;

    memset(next, 0, (size_t)p->n);
    for (int32_t i = 0; i < p->n; i++)
    {
        struct walk w = {.radius = s->spot[i].radius, .self = i};
        int32_t found[64];

        if (!waits[i])
        {
            continue;
        }
        memcpy(w.x, s->spot[i].x, sizeof w.x);
        const int count = overlaps(s, &w, found, 64);

        for (int k = 0; k < count; k++)
        {
            push(s, p, i, found[k], sweep);
            if (found[k] < s->n)
            {
                next[found[k]] = 1;
            }
        }
        next[i] |= count > 0;
        left += count > 0;
    }
    return left;
}

static int make_room(struct places *s, const struct dem_packing *p, uint8_t *waits, uint8_t *next)
{
    int32_t left = 1;

    for (uint64_t sweep = 0; left > 0; sweep++)
    {
        left = sweep_once(s, p, waits, next, sweep);
        memcpy(waits, next, (size_t)p->n);
        if (sweep%PATIENCE == PATIENCE - 1)
        {
            free_wedged(s, p, waits, sweep);
        }
        DEM_REQUIRE(left == 0 || sweep < SWEEPS, DEM_ERROR_INPUT,
                    "%s: %lld of %lld particles found no room at random in %d sweeps of pushing; enlarge the region, ask for fewer, use type "
                    "lattice, or let them settle", p->where, (long long)left, (long long)p->n, SWEEPS);
    }
    return DEM_OK;
}

/* ---- all ----------------------------------------------------------------------------------------------------- */

static int may_touch(const struct dem_vessel *v, const struct dem_particle *q)
{
    int may = 1;

    for (int k = 0; k < 3; k++)
    {
        may &= q->x[k] + q->radius > v->min[k] && q->x[k] - q->radius < v->max[k];
    }
    return may;
}

static int list_spots(struct places *s, const struct dem_packing *p, const struct dem_crowd *c)
{
    double largest = 0.0;

    DEM_TRY(DEM_NEW(s->spot, (size_t)p->n + c->n + 1));
    s->n = s->all = p->n;
    for (int32_t i = 0; i < p->n; i++)
    {
        s->spot[i].radius = 0.5*p->diameter[i];
        largest = fmax(largest, p->diameter[i]);
    }
    for (size_t k = 0; k < c->n; k++)
    {
        if (may_touch(p->vessel, &c->particle[k]))
        {
            s->spot[s->all].radius = c->particle[k].radius;
            memcpy(s->spot[s->all++].x, c->particle[k].x, sizeof c->particle[k].x);
            largest = fmax(largest, 2.0*c->particle[k].radius);
        }
    }
    for (int32_t i = 0; i < s->all; i++)
    {
        s->spot[i].level = level_of(2.0*s->spot[i].radius, largest);
    }
    DEM_TRY(make_grids(s, p->vessel, largest));
    for (int32_t i = s->n; i < s->all; i++)
    {
        struct level *const l = &s->level[s->spot[i].level];

        l->most = fmax(l->most, s->spot[i].radius);
        enter(s, i);
    }
    return DEM_OK;
}

int dem_packing_may_fit(const struct dem_vessel *v, double volume, double n, const char *where)
{
    const double fraction = volume/dem_vessel_volume(v);

    DEM_REQUIRE(fraction <= most_fraction, DEM_ERROR_INPUT,
                "%s: %.10g particles at random are a solid fraction of %.3g, and no more than %g finds room; enlarge the region, ask for fewer, "
                "use type lattice, or let a looser packing settle", where, n, fraction, most_fraction);
    return DEM_OK;
}

int dem_packing_fill(struct dem_packing *p, const struct dem_crowd *c)
{
    struct places s;
    uint8_t *waits = NULL;

    memset(&s, 0, sizeof s);
    int status = list_spots(&s, p, c);

    status = status ? status : DEM_NEW(waits, 2*(size_t)p->n + 2);
    status = status ? status : place_all(&s, p, waits);
    status = status ? status : make_room(&s, p, waits, waits + p->n + 1);
    for (int32_t i = 0; i < p->n && !status; i++)
    {
        memcpy(p->x[i], s.spot[i].x, sizeof p->x[i]);
    }
    dem_memory_free(s.spot);
    dem_memory_free(s.head);
    dem_memory_free(waits);
    return status;
}
