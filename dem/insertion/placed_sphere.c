/*
 * placed_sphere.c -- linked cells, one grid for each octave of diameters, and messages of spheres
 * between ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "insertion/placed_sphere.h"
#include "core/error.h"
#include "core/memory.h"
#include <math.h>
#include <string.h>

enum
{
    CELLS_A_SPHERE = 2,
    /* of a message: the sphere and its kind */
    WORDS = (int)(sizeof(struct dem_placed_sphere)/sizeof(double)) + 1
};
_Static_assert(sizeof(struct dem_placed_sphere) == 64, "a placed sphere is a cache line");

int dem_placed_spheres_init(struct dem_placed_spheres *s, const struct dem_decomposition *of)
{
    memset(s, 0, sizeof *s);
    DEM_TRY(DEM_NEW(s->box, of->ranks));
    return dem_decomposition_init(&s->decomposition, of->comm, of->rank, of->ranks);
}

void dem_placed_spheres_free(struct dem_placed_spheres *s)
{
    dem_decomposition_free(&s->decomposition);
    dem_memory_free(s->box);
    dem_memory_free(s->head);
    dem_memory_free(s->next);
    dem_memory_free(s->sphere);
    dem_memory_free(s->message);
    dem_messages_free(&s->out);
    dem_messages_free(&s->in);
    memset(s, 0, sizeof *s);
}

int dem_placed_spheres_decompose(struct dem_placed_spheres *s, size_t n,
                                 const struct dem_placed_sphere *sphere, const double low[3],
                                 const double high[3])
{
    DEM_TRY(dem_decomposition_divide(&s->decomposition, n, (const double *)(const void *)sphere,
                                     sizeof *sphere/sizeof(double)));
    for (int r = 0; r < s->decomposition.ranks; r++)
    {
        dem_decomposition_box(&s->decomposition, r, s->box[r][0], s->box[r][1]);
    }
    for (int k = 0; k < 3; k++)
    {
        s->low[k] = fmax(low[k], s->box[s->decomposition.rank][0][k]);
        s->high[k] = fmax(s->low[k], fmin(high[k], s->box[s->decomposition.rank][1][k]));
    }
    return DEM_OK;
}

/* ---- grids ----------------------------------------------------------------------------------- */

int dem_placed_spheres_level(const struct dem_placed_spheres *s, double radius)
{
    int k = 0;

    for (double edge = 0.5*s->max_radius; k < DEM_PLACED_SPHERE_LEVELS - 1 && radius <= edge;
         edge *= 0.5)
    {
        k++;
    }
    return k;
}

void dem_placed_spheres_include_radius(struct dem_placed_spheres *s, double radius)
{
    struct dem_placed_sphere_level *const l = &s->level[dem_placed_spheres_level(s, radius)];

    l->max_radius = fmax(l->max_radius, radius);
}

static double choose_cells(const struct dem_placed_spheres *s, struct dem_placed_sphere_level *l)
{
    double count = 1.0;

    for (int k = 0; k < 3; k++)
    {
        l->cells[k] = (int64_t)fmin(1e9, (s->high[k] - s->low[k])/l->edge) + 1;
        count *= (double)l->cells[k];
    }
    return count;
}

int dem_placed_spheres_clear_grids(struct dem_placed_spheres *s, double skin, size_t spheres)
{
    const double max_cells = CELLS_A_SPHERE*(double)spheres + 64.0;

    s->cells = 0;
    for (int k = 0; k < DEM_PLACED_SPHERE_LEVELS; k++)
    {
        struct dem_placed_sphere_level *const l = &s->level[k];

        l->first = s->cells;
        if (l->max_radius > 0.0)
        {
            double count;

            for (l->edge = 2.0*l->max_radius + skin; (count = choose_cells(s, l)) > max_cells;
                 l->edge *= 1.26)
            {
            }
            s->cells += (size_t)count;
        }
    }
    DEM_TRY(DEM_GROW(s->head, s->head_capacity, s->cells + 1));
    memset(s->head, 0xff, (s->cells + 1)*sizeof *s->head);
    return DEM_OK;
}

int dem_placed_spheres_add(struct dem_placed_spheres *s, const struct dem_placed_sphere *sphere)
{
    DEM_REQUIRE(s->n < UINT32_MAX - 1, DEM_ERROR_INPUT,
                "more than %u particles to place on one rank; use more ranks", UINT32_MAX - 1);
    DEM_TRY(DEM_GROW(s->sphere, s->capacity, s->n + 1));
    s->sphere[s->n++] = *sphere;
    return DEM_OK;
}

int dem_placed_spheres_link(struct dem_placed_spheres *s, uint32_t sphere)
{
    const struct dem_placed_sphere *const p = &s->sphere[sphere];
    const size_t cell =
        dem_placed_spheres_cell(s, &s->level[dem_placed_spheres_level(s, p->radius)], p->x);

    DEM_TRY(DEM_GROW(s->next, s->next_capacity, s->n));
    s->next[sphere] = s->head[cell];
    s->head[cell] = sphere;
    return DEM_OK;
}

/* ---- messages -------------------------------------------------------------------------------- */

static int queue(struct dem_placed_spheres *s, const struct dem_placed_sphere *sphere, int kind,
                 int peer)
{
    DEM_TRY(DEM_GROW(s->message, s->message_capacity, s->messages + 1));
    s->message[s->messages++] = (struct dem_placed_sphere_message){peer, kind, *sphere};
    return DEM_OK;
}

int dem_placed_spheres_send_to_owner(struct dem_placed_spheres *s,
                                     const struct dem_placed_sphere *sphere, int kind, int *sent)
{
    const int owner = dem_decomposition_owner(&s->decomposition, sphere->x);

    *sent = owner != s->decomposition.rank;
    return *sent ? queue(s, sphere, kind, owner) : DEM_OK;
}

/* The square of the distance of a point from a box [m2]. */
static double square_distance(double box[2][3], const double x[3])
{
    double square = 0.0;

    for (int k = 0; k < 3; k++)
    {
        const double gap = fmax(0.0, fmax(box[0][k] - x[k], x[k] - box[1][k]));

        square += gap*gap;
    }
    return square;
}

int dem_placed_spheres_send_ghosts(struct dem_placed_spheres *s,
                                   const struct dem_placed_sphere *sphere, int kind, double reach)
{
    const int owner = dem_decomposition_owner(&s->decomposition, sphere->x);
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= sphere->x[k] - s->box[owner][0][k] > reach
               && s->box[owner][1][k] - sphere->x[k] > reach;
    }
    for (int r = 0; r < s->decomposition.ranks && !inside; r++)
    {
        if (r != owner && square_distance(s->box[r], sphere->x) < reach*reach)
        {
            DEM_TRY(queue(s, sphere, kind, r));
        }
    }
    return DEM_OK;
}

/* One message a rank, with the spheres in the order in which they were queued. count, at: zeroed
   scratch, one number a rank. */
static int fill_messages(struct dem_placed_spheres *s, size_t *count, size_t *at)
{
    double *where;
    int packed = 0, status = DEM_OK;

    for (size_t k = 0; k < s->messages; k++)
    {
        count[s->message[k].peer]++;
    }
    dem_messages_clear(&s->out);
    for (int peer = 0; peer < s->decomposition.ranks && !status; peer++)
    {
        if (count[peer] > 0)
        {
            status = dem_messages_begin(&s->out, peer);
            status = status ? status : dem_messages_extend(&s->out, WORDS*count[peer], &where);
            at[peer] = status ? 0 : s->out.start[packed++];
        }
    }
    for (size_t k = 0; k < s->messages && !status; k++)
    {
        const struct dem_placed_sphere_message *const p = &s->message[k];

        where = s->out.data + at[p->peer];
        memcpy(where, &p->sphere, sizeof p->sphere);
        where[WORDS - 1] = (double)p->kind;
        at[p->peer] += WORDS;
    }
    return status;
}

static int pack_messages(struct dem_placed_spheres *s)
{
    size_t *count = NULL, *at = NULL;
    int status = DEM_NEW(count, s->decomposition.ranks);

    status = status ? status : DEM_NEW(at, s->decomposition.ranks);
    status = status ? status : fill_messages(s, count, at);
    dem_memory_free(count);
    dem_memory_free(at);
    return status;
}

int dem_placed_spheres_exchange(struct dem_placed_spheres *s)
{
    if (s->decomposition.ranks == 1)
    {
        s->messages = 0;
        return DEM_OK;
    }
    DEM_TRY(dem_messages_exchange(s->decomposition.comm, pack_messages(s), &s->out, &s->in));
    s->messages = s->in.ranks > 0 ? s->in.start[s->in.ranks]/WORDS : 0;
    DEM_TRY(DEM_GROW(s->message, s->message_capacity, s->messages + 1));
    for (size_t k = 0; k < s->messages; k++)
    {
        const double *const where = s->in.data + WORDS*k;

        memcpy(&s->message[k].sphere, where, sizeof s->message[k].sphere);
        s->message[k].kind = (int)where[WORDS - 1];
    }
    return DEM_OK;
}
