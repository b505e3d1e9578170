/*
 * packing_addition.c -- random sequential addition in rounds: in each round every remaining sphere
 * tries one random position.
 *
 * A position is free when it overlaps no placed sphere, and no trial position of this round of a
 * larger sphere, or of an equal one with a lower number, whether that is placed or not. So the
 * result does not depend on the order of the tests. Octaves of diameters follow one another,
 * largest first. Rounds of an octave end when fewer than one in sixteen of the tried spheres is
 * placed.
 *
 * This is not the sequential process (Widom, J. Chem. Phys. 44 (1966) 3888), but agrees with it in
 * the first two orders of the density.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "insertion/packing.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/random.h"
#include "parallel/mpi_error.h"
#include <string.h>

enum
{
    USE_PLACE = 201,  /* stream of random numbers */
    DRAWS = 1000,     /* points for one trial; each lies inside with a probability above 0.5 */
    LIMITED_DRAWS = 100000,  /* the same where walls or a mesh leave an unknown part of the shape */
    ROUNDS = 64,
    SCARCE = 16       /* the last round places fewer than one in so many */
};

/* kinds of messages */
enum kind
{
    TRIAL,  /* to the owner of the trial position */
    TRIAL_GHOST,
    PLACED_GHOST
};

/* spheres that try a position in this round, owned ones and ghosts */
struct trials
{
    size_t n, capacity, head_capacity, next_capacity;
    struct dem_placed_sphere *sphere;  /* v[0] 1: owned, 0: a ghost; v[1] 1: its position is free */
    uint32_t *head, *next;             /* linked cells of the level, as in placed_sphere.h */
    int level;
};

int dem_packing_draw(const struct dem_packing *p, struct dem_placed_sphere *s, uint64_t trial)
{
    struct dem_insertion_limits *const limits = p->shape->limits;
    const uint64_t draws = limits ? LIMITED_DRAWS : DRAWS;
    double u[3];
    int inside = 0;

    for (uint64_t draw = trial*draws; draw < (trial + 1)*draws && !inside; draw++)
    {
        for (int k = 0; k < 3; k++)
        {
            u[k] = dem_random_unit(p->seed, (uint64_t)s->number, draw, USE_PLACE + (uint64_t)k);
        }
        inside = dem_insertion_shape_draw(p->shape, s->radius, u, s->x)
              && (!limits || dem_insertion_limits_allow(limits, s->radius, s->x));
    }
    return inside;
}

/* A sphere of this rank found no place off the walls and inside the mesh. */
static int no_place(const struct dem_packing *p, const struct dem_placed_sphere *s)
{
    return dem_error(
        DEM_ERROR_INPUT,
        "%s: a sphere of %g m finds no place off the walls inside its region, the box "
        "from (%g %g %g) to (%g %g %g) m, in %d trials; enlarge the region, or ask for "
        "smaller ones",
        p->where, 2.0*s->radius, p->shape->min[0], p->shape->min[1], p->shape->min[2],
        p->shape->max[0], p->shape->max[1], p->shape->max[2], LIMITED_DRAWS);
}

static int add_trial(struct trials *t, const struct dem_placed_sphere *sphere, int own)
{
    DEM_REQUIRE(t->n < UINT32_MAX - 1, DEM_ERROR_INPUT,
                "more than %u particles to place on one rank; use more ranks", UINT32_MAX - 1);
    DEM_TRY(DEM_GROW(t->sphere, t->capacity, t->n + 1));
    t->sphere[t->n] = *sphere;
    t->sphere[t->n].v[0] = own;
    t->sphere[t->n++].v[1] = 0.0;
    return DEM_OK;
}

/* The spheres of this level in this rank's run of the list. */
static int begin_level(struct trials *t, const struct dem_packing *p,
                       const struct dem_placed_spheres *s, int level)
{
    const int64_t ranks = s->decomposition.ranks, from = p->n*s->decomposition.rank/ranks;
    const int64_t to = p->n*(s->decomposition.rank + 1)/ranks;

    t->n = 0;
    t->level = level;
    for (int64_t m = from; m < to; m++)
    {
        const struct dem_placed_sphere sphere =
            {.radius = 0.5*(p->diameters ? p->diameters[m] : p->diameter), .number = m};

        if (dem_placed_spheres_level(s, sphere.radius) == level)
        {
            DEM_TRY(add_trial(t, &sphere, 1));
        }
    }
    return DEM_OK;
}

/* A new trial position for each; spheres go to the ranks that own these. */
static int draw_all(struct trials *t, const struct dem_packing *p, struct dem_placed_spheres *s,
                    uint64_t round)
{
    size_t kept = 0;

    for (size_t k = 0; k < t->n; k++)
    {
        struct dem_placed_sphere sphere = t->sphere[k];
        int sent;

        if (!dem_packing_draw(p, &sphere, round) && p->shape->limits && !p->shape->limits->status)
        {
            p->shape->limits->status = no_place(p, &sphere);    /* all ranks end it together */
        }
        DEM_TRY(
            dem_placed_spheres_send_ghosts(s, &sphere, TRIAL_GHOST, sphere.radius + s->max_radius));
        DEM_TRY(dem_placed_spheres_send_to_owner(s, &sphere, TRIAL, &sent));
        if (!sent)
        {
            t->sphere[kept++] = sphere;
        }
    }
    t->n = kept;
    DEM_TRY(dem_placed_spheres_exchange(s));
    for (size_t k = 0; k < s->messages; k++)
    {
        struct dem_placed_sphere *const sphere = &s->message[k].sphere;

        if (s->message[k].kind == PLACED_GHOST)
        {
            sphere->v[0] = 0.0;
            DEM_TRY(dem_placed_spheres_add(s, sphere));
            DEM_TRY(dem_placed_spheres_link(s, (uint32_t)(s->n - 1)));
        }
        else
        {
            DEM_TRY(add_trial(t, sphere, s->message[k].kind == TRIAL));
        }
    }
    s->messages = 0;
    return DEM_OK;
}

static int link_trials(struct trials *t, const struct dem_placed_spheres *s)
{
    const struct dem_placed_sphere_level *const l = &s->level[t->level];
    const size_t cells = (size_t)(l->cells[0]*l->cells[1]*l->cells[2]);

    DEM_TRY(DEM_GROW(t->head, t->head_capacity, cells));
    DEM_TRY(DEM_GROW(t->next, t->next_capacity, t->n + 1));
    memset(t->head, 0xff, cells*sizeof *t->head);
    for (size_t k = 0; k < t->n; k++)
    {
        const size_t cell = dem_placed_spheres_cell(s, l, t->sphere[k].x) - l->first;

        t->next[k] = t->head[cell];
        t->head[cell] = (uint32_t)k;
    }
    return DEM_OK;
}

static int overlap(const struct dem_placed_sphere *a, const struct dem_placed_sphere *b)
{
    const double dx = a->x[0] - b->x[0], dy = a->x[1] - b->x[1], dz = a->x[2] - b->x[2];
    const double d = a->radius + b->radius;

    return dx*dx + dy*dy + dz*dz < d*d;
}

/* Does a precede b in a round? */
static int precedes(const struct dem_placed_sphere *a, const struct dem_placed_sphere *b)
{
    return a->radius > b->radius || (a->radius >= b->radius && a->number < b->number);
}

static int free_in_cell(const struct trials *t, const struct dem_placed_spheres *s,
                        const struct dem_placed_sphere *trial, int level, size_t cell)
{
    for (uint32_t m = s->head[s->level[level].first + cell]; m != dem_placed_sphere_none;
         m = s->next[m])
    {
        if (overlap(trial, &s->sphere[m]))
        {
            return 0;
        }
    }
    for (uint32_t m = level == t->level ? t->head[cell] : dem_placed_sphere_none;
         m != dem_placed_sphere_none; m = t->next[m])
    {
        if (&t->sphere[m] != trial && precedes(&t->sphere[m], trial)
            && overlap(trial, &t->sphere[m]))
        {
            return 0;
        }
    }
    return 1;
}

static int is_free(const struct trials *t, const struct dem_placed_spheres *s,
                   const struct dem_placed_sphere *trial)
{
    for (int k = 0; k < DEM_PLACED_SPHERE_LEVELS; k++)
    {
        const struct dem_placed_sphere_level *const l = &s->level[k];

        if (l->max_radius > 0.0)
        {
            const struct dem_cell_range r =
                dem_placed_spheres_cell_range(s, l, trial->x, trial->radius + l->max_radius);

            for (int64_t z = r.from[2]; z <= r.to[2]; z++)
            {
                for (int64_t y = r.from[1]; y <= r.to[1]; y++)
                {
                    for (int64_t x = r.from[0]; x <= r.to[0]; x++)
                    {
                        if (!free_in_cell(t, s, trial, k,
                                          (size_t)((z*l->cells[1] + y)*l->cells[0] + x)))
                        {
                            return 0;
                        }
                    }
                }
            }
        }
    }
    return 1;
}

/* Test owned trials, cell by cell: neighbours read the same memory. */
static void test_all(struct trials *t, const struct dem_placed_spheres *s)
{
    const struct dem_placed_sphere_level *const l = &s->level[t->level];
    const size_t cells = (size_t)(l->cells[0]*l->cells[1]*l->cells[2]);

    for (size_t c = 0; c < cells; c++)
    {
        for (uint32_t m = t->head[c]; m != dem_placed_sphere_none; m = t->next[m])
        {
            t->sphere[m].v[1] = t->sphere[m].v[0] > 0.0 && is_free(t, s, &t->sphere[m]);
        }
    }
}

static int place(struct dem_placed_spheres *s, const struct dem_placed_sphere *sphere)
{
    DEM_TRY(dem_placed_spheres_add(s, sphere));
    DEM_TRY(dem_placed_spheres_link(s, (uint32_t)(s->n - 1)));
    return dem_placed_spheres_send_ghosts(s, sphere, PLACED_GHOST, sphere->radius + s->max_radius);
}

/* Place the spheres whose position is free. count: of all ranks, placed ones and remaining ones. */
static int place_free(struct trials *t, struct dem_placed_spheres *s, int64_t count[2])
{
    size_t kept = 0;

    count[0] = count[1] = 0;
    for (size_t k = 0; k < t->n; k++)
    {
        const struct dem_placed_sphere sphere = t->sphere[k];

        if (sphere.v[0] > 0.0)
        {
            count[sphere.v[1] > 0.0 ? 0 : 1]++;
            if (sphere.v[1] > 0.0)
            {
                DEM_TRY(place(s, &sphere));
            }
            else
            {
                t->sphere[kept++] = sphere;
            }
        }
    }
    t->n = kept;
    if (s->decomposition.ranks > 1)
    {
        DEM_TRY_MPI(
            MPI_Allreduce(MPI_IN_PLACE, count, 2, MPI_INT64_T, MPI_SUM, s->decomposition.comm));
    }
    return DEM_OK;
}

static int place_level(struct trials *t, const struct dem_packing *p, struct dem_placed_spheres *s,
                       int64_t *left)
{
    int64_t count[2] = {1, 1};

    for (uint64_t round = 0; round < ROUNDS && count[1] > 0 && count[0]*SCARCE >= count[1]; round++)
    {
        DEM_TRY(draw_all(t, p, s, round));
        DEM_TRY(link_trials(t, s));
        test_all(t, s);
        DEM_TRY(place_free(t, s, count));
    }
    *left += count[1];
    for (size_t k = 0; k < t->n; k++)    /* the remaining ones overlap: relaxation moves them */
    {
        DEM_TRY(place(s, &t->sphere[k]));
    }
    return DEM_OK;
}

static void drop_ghosts(struct dem_placed_spheres *s)
{
    size_t kept = 0;

    for (size_t k = 0; k < s->n; k++)
    {
        if (s->sphere[k].v[0] > 0.0)
        {
            s->sphere[kept] = s->sphere[k];
            memset(s->sphere[kept++].v, 0, sizeof s->sphere->v);
        }
    }
    s->n = s->owned = kept;
}

int dem_packing_place(const struct dem_packing *p, struct dem_placed_spheres *s, int64_t *left)
{
    struct trials t = {.n = 0};
    int status =
        dem_placed_spheres_clear_grids(s, 0.0, s->n + (size_t)(p->n/s->decomposition.ranks));

    *left = 0;
    for (size_t k = 0; k < s->n && !status; k++)
    {
        status = dem_placed_spheres_link(s, (uint32_t)k);
    }
    for (int level = 0; level < DEM_PLACED_SPHERE_LEVELS && !status; level++)
    {
        if (s->level[level].max_radius > 0.0)
        {
            status = begin_level(&t, p, s, level);
            status = status ? status : place_level(&t, p, s, left);
        }
    }
    drop_ghosts(s);
    s->messages = 0;
    dem_memory_free(t.sphere);
    dem_memory_free(t.head);
    dem_memory_free(t.next);
    return status;
}
