/*
 * spots.c -- the grids, and the post between ranks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "io/spots.h"
#include "base/error.h"
#include "base/memory.h"
#include <math.h>
#include <string.h>

enum
{
    CELLS_A_SPOT = 2,
    WORDS = (int)(sizeof(struct dem_spot)/sizeof(double)) + 1       /* of a letter: the spot and what it is */
};
_Static_assert(sizeof(struct dem_spot) == 64, "a spot is a cache line");

int dem_spots_init(struct dem_spots *s, const struct dem_pieces *of)
{
    memset(s, 0, sizeof *s);
    DEM_TRY(DEM_NEW(s->box, of->ranks));
    return dem_pieces_init(&s->pieces, of->comm, of->rank, of->ranks);
}

void dem_spots_free(struct dem_spots *s)
{
    dem_pieces_free(&s->pieces);
    dem_memory_free(s->box);
    dem_memory_free(s->head);
    dem_memory_free(s->next);
    dem_memory_free(s->spot);
    dem_memory_free(s->post);
    dem_mail_free(&s->out);
    dem_mail_free(&s->in);
    memset(s, 0, sizeof *s);
}

int dem_spots_share(struct dem_spots *s, size_t n, const struct dem_spot *spot, const double low[3], const double high[3])
{
    DEM_TRY(dem_pieces_cut(&s->pieces, n, (const double *)(const void *)spot, sizeof *spot/sizeof(double)));
    for (int r = 0; r < s->pieces.ranks; r++)
    {
        dem_pieces_box(&s->pieces, r, s->box[r][0], s->box[r][1]);
    }
    for (int k = 0; k < 3; k++)
    {
        s->low[k] = fmax(low[k], s->box[s->pieces.rank][0][k]);
        s->high[k] = fmax(s->low[k], fmin(high[k], s->box[s->pieces.rank][1][k]));
    }
    return DEM_OK;
}

/* ---- the grids ----------------------------------------------------------------------------------------------- */

int dem_spots_level(const struct dem_spots *s, double radius)
{
    int k = 0;

    for (double edge = 0.5*s->most; k < DEM_SPOT_LEVELS - 1 && radius <= edge; edge *= 0.5)
    {
        k++;
    }
    return k;
}

void dem_spots_admit(struct dem_spots *s, double radius)
{
    struct dem_spot_level *const l = &s->level[dem_spots_level(s, radius)];

    l->most = fmax(l->most, radius);
}

static double choose_cells(const struct dem_spots *s, struct dem_spot_level *l)
{
    double count = 1.0;

    for (int k = 0; k < 3; k++)
    {
        l->cells[k] = (int64_t)fmin(1e9, (s->high[k] - s->low[k])/l->edge) + 1;
        count *= (double)l->cells[k];
    }
    return count;
}

int dem_spots_grid(struct dem_spots *s, double skin, size_t spots)
{
    const double most = CELLS_A_SPOT*(double)spots + 64.0;

    s->cells = 0;
    for (int k = 0; k < DEM_SPOT_LEVELS; k++)
    {
        struct dem_spot_level *const l = &s->level[k];

        l->first = s->cells;
        if (l->most > 0.0)
        {
            double count;

            for (l->edge = 2.0*l->most + skin; (count = choose_cells(s, l)) > most; l->edge *= 1.26)
            {
            }
            s->cells += (size_t)count;
        }
    }
    DEM_TRY(DEM_GROW(s->head, s->head_room, s->cells + 1));
    memset(s->head, 0xff, (s->cells + 1)*sizeof *s->head);
    return DEM_OK;
}

int dem_spots_add(struct dem_spots *s, const struct dem_spot *spot)
{
    DEM_REQUIRE(s->n < UINT32_MAX - 1, DEM_ERROR_INPUT, "more than %u particles to place on one rank; use more ranks", UINT32_MAX - 1);
    DEM_TRY(DEM_GROW(s->spot, s->room, s->n + 1));
    s->spot[s->n++] = *spot;
    return DEM_OK;
}

int dem_spots_enter(struct dem_spots *s, uint32_t spot)
{
    const struct dem_spot *const p = &s->spot[spot];
    const size_t cell = dem_spots_cell(s, &s->level[dem_spots_level(s, p->radius)], p->x);

    DEM_TRY(DEM_GROW(s->next, s->next_room, s->n));
    s->next[spot] = s->head[cell];
    s->head[cell] = spot;
    return DEM_OK;
}

/* ---- the post ------------------------------------------------------------------------------------------------ */

static int post(struct dem_spots *s, const struct dem_spot *spot, int what, int peer)
{
    DEM_TRY(DEM_GROW(s->post, s->post_room, s->posts + 1));
    s->post[s->posts++] = (struct dem_spot_post){peer, what, *spot};
    return DEM_OK;
}

int dem_spots_send(struct dem_spots *s, const struct dem_spot *spot, int what, int *gone)
{
    const int owner = dem_pieces_owner(&s->pieces, spot->x);

    *gone = owner != s->pieces.rank;
    return *gone ? post(s, spot, what, owner) : DEM_OK;
}

/* m2: the square of the distance of a place from a box. */
static double square_from(double box[2][3], const double x[3])
{
    double square = 0.0;

    for (int k = 0; k < 3; k++)
    {
        const double gap = fmax(0.0, fmax(box[0][k] - x[k], x[k] - box[1][k]));

        square += gap*gap;
    }
    return square;
}

int dem_spots_copy(struct dem_spots *s, const struct dem_spot *spot, int what, double reach)
{
    const int owner = dem_pieces_owner(&s->pieces, spot->x);
    int inside = 1;

    for (int k = 0; k < 3; k++)
    {
        inside &= spot->x[k] - s->box[owner][0][k] > reach && s->box[owner][1][k] - spot->x[k] > reach;
    }
    for (int r = 0; r < s->pieces.ranks && !inside; r++)
    {
        if (r != owner && square_from(s->box[r], spot->x) < reach*reach)
        {
            DEM_TRY(post(s, spot, what, r));
        }
    }
    return DEM_OK;
}

/* One letter a peer, posts in their order. */
static int write_letters(struct dem_spots *s)
{
    size_t *count, *at;
    double *where;
    int letters = 0;

    DEM_TRY(DEM_NEW(count, s->pieces.ranks));
    DEM_TRY(DEM_NEW(at, s->pieces.ranks));
    for (size_t k = 0; k < s->posts; k++)
    {
        count[s->post[k].peer]++;
    }
    dem_mail_clear(&s->out);
    for (int peer = 0; peer < s->pieces.ranks; peer++)
    {
        if (count[peer] > 0)
        {
            DEM_TRY(dem_mail_letter(&s->out, peer));
            DEM_TRY(dem_mail_room(&s->out, WORDS*count[peer], &where));
            at[peer] = s->out.start[letters++];
        }
    }
    for (size_t k = 0; k < s->posts; k++)
    {
        const struct dem_spot_post *const p = &s->post[k];

        where = s->out.data + at[p->peer];
        memcpy(where, &p->spot, sizeof p->spot);
        where[WORDS - 1] = (double)p->what;
        at[p->peer] += WORDS;
    }
    dem_memory_free(count);
    dem_memory_free(at);
    return DEM_OK;
}

int dem_spots_deliver(struct dem_spots *s)
{
    if (s->pieces.ranks == 1)
    {
        s->posts = 0;
        return DEM_OK;
    }
    DEM_TRY(write_letters(s));
    DEM_TRY(dem_mail_exchange(s->pieces.comm, &s->out, &s->in));
    s->posts = s->in.peers > 0 ? s->in.start[s->in.peers]/WORDS : 0;
    DEM_TRY(DEM_GROW(s->post, s->post_room, s->posts + 1));
    for (size_t k = 0; k < s->posts; k++)
    {
        const double *const where = s->in.data + WORDS*k;

        memcpy(&s->post[k].spot, where, sizeof s->post[k].spot);
        s->post[k].what = (int)where[WORDS - 1];
    }
    return DEM_OK;
}
