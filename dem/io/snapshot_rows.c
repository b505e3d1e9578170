/*
 * snapshot_rows.c -- what contacts remember, from the file to the owners of both partners.
 *
 * Who owns which particle no rank knows of another. So rank id mod ranks keeps the register of an id: owners enter theirs; each
 * rank reads its share of the rows and posts them to the registers of both partners; these pass them on to the owners. Three
 * exchanges of letters, and no rank ever holds more than its share, what it registers, and what is its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/error.h"
#include "base/memory.h"
#include "base/sort.h"
#include "io/snapshot_judge.h"
#include "space/mail.h"
#include <stdlib.h>
#include <string.h>

enum
{
    CHUNK = 4096                                          /* rows read at a time */
};

/* ---- who has which id -------------------------------------------------------------------------------------------- */

struct entry
{
    int64_t id, owner;
};

static int compare(const void *a, const void *b)
{
    const int64_t p = ((const struct entry *)a)->id, q = ((const struct entry *)b)->id;

    return (p > q) - (p < q);
}

/* The owner of an id, or -1. */
static int64_t owner_of(const struct entry *list, size_t n, int64_t id)
{
    const struct entry wanted = {id, 0}, *const found = n > 0 && id >= 0 ? bsearch(&wanted, list, n, sizeof *list, compare) : NULL;

    return found ? found->owner : -1;
}

static int64_t keeper(const struct dem_pieces *q, int64_t id)
{
    return id >= 0 ? id%q->ranks : -1;
}

/* This rank's particles. */
static int list_own(const struct dem_pieces *q, const struct dem_particles *p, struct entry **list)
{
    DEM_TRY(DEM_NEW(*list, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        (*list)[i] = (struct entry){p->record[i].id, q->rank};
    }
    dem_sort_by(*list, p->n, sizeof **list, compare);
    return DEM_OK;
}

/* Collective. No two particles of all ranks have one id: each id is in the list of one rank only, which is in order. */
static int refuse_twins(const char *path, const struct dem_pieces *q, const struct entry *list, size_t n)
{
    int64_t twin = -1;

    for (size_t k = 1; k < n; k++)
    {
        twin = list[k].id == list[k - 1].id && list[k].id > twin ? list[k].id : twin;
    }
    if (q->ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &twin, 1, MPI_INT64_T, MPI_MAX, q->comm);
    }
    DEM_REQUIRE(twin < 0, DEM_ERROR_FILE, "%s is damaged: two of its particles have id %lld; use another one", path, (long long)twin);
    return DEM_OK;
}

/* ---- letters ----------------------------------------------------------------------------------------------------- */

struct bundle                                             /* items of one size, each to one rank or none */
{
    size_t n, room, to_room, size;                        /* size in doubles */
    double *item;
    int64_t *to;
};

static int put(struct bundle *b, int64_t to, const void *item)
{
    if (to < 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(b->item, b->room, (b->n + 1)*b->size));
    DEM_TRY(DEM_GROW(b->to, b->to_room, b->n + 1));
    memcpy(b->item + b->n*b->size, item, b->size*sizeof *b->item);
    b->to[b->n++] = to;
    return DEM_OK;
}

/* Items in the order of their ranks, one letter a rank. */
static int write_letters(const struct bundle *b, int ranks, struct dem_mail *out)
{
    size_t *count;
    double **where;
    int status = DEM_NEW(count, ranks);

    DEM_TRY(status ? status : DEM_NEW(where, ranks));
    for (size_t k = 0; k < b->n; k++)
    {
        count[b->to[k]]++;
    }
    for (int k = 0; k < ranks && !status; k++)
    {
        status = count[k] > 0 ? dem_mail_letter(out, k) : DEM_OK;
        status = status || count[k] == 0 ? status : dem_mail_room(out, count[k]*b->size, &where[k]);
    }
    for (int k = 0, peer = 0; k < ranks && !status; k++)
    {
        where[k] = count[k] > 0 ? out->data + out->start[peer++] : NULL;     /* the letters may have been moved while they grew */
    }
    for (size_t k = 0; k < b->n && !status; k++)
    {
        memcpy(where[b->to[k]], b->item + k*b->size, b->size*sizeof *b->item);
        where[b->to[k]] += b->size;
    }
    dem_memory_free(count);
    dem_memory_free(where);
    return status;
}

/* Collective. Post the bundle, empty it, and fill it with what has come, `to` being who sent it. */
static int exchange(const struct dem_pieces *q, struct bundle *b, struct dem_mail *in)
{
    struct dem_mail out = {.peers = 0};

    DEM_TRY(write_letters(b, q->ranks, &out));
    b->n = 0;
    const int status = dem_mail_exchange(q->comm, &out, in);

    dem_mail_free(&out);
    DEM_TRY(status);
    for (int k = 0; k < in->peers; k++)
    {
        for (size_t at = in->start[k]; at < in->start[k + 1]; at += b->size)
        {
            DEM_TRY(put(b, in->peer[k], in->data + at));
        }
    }
    return DEM_OK;
}

static void empty(struct bundle *b)
{
    dem_memory_free(b->item);
    dem_memory_free(b->to);
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

/* A row goes to the registers of its partners: once when one register has both. */
static int address(const struct dem_pieces *q, struct bundle *b, const double *row)
{
    struct dem_carried name;

    memcpy(&name, row, sizeof name);
    DEM_TRY(put(b, keeper(q, name.low), row));
    return keeper(q, name.high) != keeper(q, name.low) ? put(b, keeper(q, name.high), row) : DEM_OK;
}

/* This rank's share. */
static void read_share(struct dem_store *s, const struct dem_pieces *q, const struct dem_snapshot_head *h, struct bundle *b)
{
    int64_t first, count;
    double *row;

    dem_snapshot_share(q, h->rows, &first, &count);
    s->status = DEM_NEW(row, CHUNK*b->size);
    for (int64_t at = first; at < first + count && !s->status; at += CHUNK)
    {
        const size_t n = (size_t)(first + count - at < CHUNK ? first + count - at : CHUNK);

        dem_store_read(s, dem_snapshot_rows_at(h) + (size_t)at*b->size*sizeof *row, row, n*b->size*sizeof *row);
        for (size_t k = 0; k < n && !s->status; k++)
        {
            s->status = dem_snapshot_judge_row(s->path, h, row + k*b->size);
            s->status = s->status ? s->status : address(q, b, row + k*b->size);
        }
    }
    dem_memory_free(row);
}

/* What a register has got goes on to those owners whom it knows: to one of both partners once. */
static int forward(const struct dem_pieces *q, const struct entry *list, size_t n, struct bundle *b)
{
    struct bundle on = {.size = b->size};
    int status = DEM_OK;

    for (size_t k = 0; k < b->n && !status; k++)
    {
        const double *const row = b->item + k*b->size;
        struct dem_carried name;

        memcpy(&name, row, sizeof name);
        const int64_t low = keeper(q, name.low) == q->rank ? owner_of(list, n, name.low) : -1;
        const int64_t high = keeper(q, name.high) == q->rank ? owner_of(list, n, name.high) : -1;

        status = put(&on, low, row);
        status = status || high == low ? status : put(&on, high, row);
    }
    empty(b);
    *b = on;
    return status;
}

/* Two registers may have sent the same row here: that of the lower partner has it when this rank owns the lower one. */
static int is_second(const struct dem_pieces *q, const struct entry *own, size_t n, const struct dem_carried *name, int64_t from)
{
    return owner_of(own, n, name->low) >= 0 && from != keeper(q, name->low);
}

static int take_row(struct dem_contacts *c, const struct dem_snapshot_head *h, const struct dem_recipe *r, struct dem_carried name,
                    const double *packed)
{
    double memory[DEM_MEMORY_COLUMNS] = {0.0};

    for (int64_t k = 0; k < h->memories; k++)
    {
        const char *const column = h->list[h->materials + h->columns + k].name;

        for (int m = 0; m < r->memories; m++)
        {
            memory[m] = strcmp(r->memory[m], column) == 0 ? packed[k] : memory[m];
        }
    }
    return dem_contacts_carry(c, &name, memory);
}

static int take_rows(const char *path, struct dem_contacts *c, const struct dem_snapshot_head *h, const struct dem_recipe *r,
                     const struct dem_pieces *q, const struct dem_particles *p, const struct bundle *b)
{
    struct entry *own;
    int status = list_own(q, p, &own);

    status = status || q->ranks > 1 ? status : refuse_twins(path, q, own, p->n);     /* of many ranks the registers have told */
    for (size_t k = 0; k < b->n && !status; k++)
    {
        const double *const row = b->item + k*b->size;
        struct dem_carried name;

        memcpy(&name, row, sizeof name);
        if (!is_second(q, own, p->n, &name, b->to[k]))
        {
            name.counted = (uint32_t)(owner_of(own, p->n, name.low) >= 0);
            status = take_row(c, h, r, name, row + DEM_SNAPSHOT_ROW);
        }
    }
    dem_memory_free(own);
    return status;
}

/* Collective. Owners enter their ids in the registers; `list` is what is registered here. */
static int open_register(const struct dem_pieces *q, const struct dem_particles *p, struct dem_mail *in, struct entry **list, size_t *n)
{
    struct bundle b = {.size = 1};
    int status = DEM_OK;

    for (size_t i = 0; i < p->n && !status; i++)
    {
        status = put(&b, keeper(q, p->record[i].id), &p->record[i].id);
    }
    DEM_TRY(status);
    DEM_TRY(exchange(q, &b, in));
    *n = b.n;
    DEM_TRY(DEM_NEW(*list, b.n + 1));
    for (size_t k = 0; k < b.n; k++)
    {
        memcpy(&(*list)[k].id, b.item + k, sizeof(int64_t));
        (*list)[k].owner = b.to[k];
    }
    dem_sort_by(*list, *n, sizeof **list, compare);
    empty(&b);
    return DEM_OK;
}

/* Collective: who can't read takes part with what it has, and fails with the others. */
static int pass_on(const char *path, const struct dem_pieces *q, const struct dem_particles *p, struct bundle *b)
{
    struct dem_mail in = {.peers = 0};
    struct entry *list = NULL;
    size_t n;
    int status = open_register(q, p, &in, &list, &n);

    status = status ? status : refuse_twins(path, q, list, n);
    status = status ? status : exchange(q, b, &in);
    status = status ? status : forward(q, list, n, b);
    status = status ? status : exchange(q, b, &in);
    dem_mail_free(&in);
    dem_memory_free(list);
    return status;
}

int dem_snapshot_read_rows(const char *path, const struct dem_pieces *q, const struct dem_recipe *r, const struct dem_particles *p,
                           struct dem_contacts *c)
{
    struct dem_store store;
    struct dem_snapshot_head h;

    DEM_TRY(dem_snapshot_open(&store, &(const struct dem_writers){.comm = q->ranks > 1 ? q->comm : MPI_COMM_NULL, .rank = q->rank}, path, &h));
    struct bundle b = {.size = dem_snapshot_row_doubles(&h)};

    read_share(&store, q, &h, &b);
    int status = dem_store_close(&store);                 /* all ranks meet here: letters of other exchanges have been read */

    status = status || q->ranks == 1 ? status : pass_on(path, q, p, &b);
    status = status ? status : take_rows(path, c, &h, r, q, p, &b);
    empty(&b);
    return status;
}
