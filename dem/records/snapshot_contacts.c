/*
 * snapshot_contacts.c -- read the history of contacts from a snapshot and send it to the owners of both
 * partners.
 *
 * No rank knows which rank owns a given particle. Rank (id mod ranks) keeps the directory entry of
 * an id (a rendezvous algorithm):
 *
 * 1. Owners send their ids to the directory ranks.
 * 2. Each rank reads its slice of the contacts and sends them to the directory ranks of both
 *    partners.
 * 3. The directory ranks forward them to the owners.
 *
 * Each step is one sparse exchange. No rank holds more than its slice, its directory entries and
 * its own contacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/error.h"
#include "core/memory.h"
#include "core/sort.h"
#include "records/snapshot_validate.h"
#include "ranks/collect.h"
#include "ranks/sparse_exchange.h"
#include <stdlib.h>
#include <string.h>

enum
{
    CHUNK = 4096                                          /* contacts read at a time */
};

/* ---- directory of owners --------------------------------------------------------------------- */

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
    const struct entry wanted = {id, 0}, *const found =
                                             n > 0 && id >= 0
                                                 ? bsearch(&wanted, list, n, sizeof *list, compare)
                                                 : NULL;

    return found ? found->owner : -1;
}

/* The rank that keeps the directory entry of an id; -1 for none (a wall). */
static int64_t directory_rank(const struct dem_decomposition *q, int64_t id)
{
    return id >= 0 ? id%q->ranks : -1;
}

/* The sorted ids of this rank's particles. */
static int list_own(const struct dem_decomposition *q, const struct dem_particles *p,
                    struct entry **list)
{
    DEM_TRY(DEM_NEW(*list, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        (*list)[i] = (struct entry){p->record[i].id, q->rank};
    }
    dem_sort_by(*list, p->n, sizeof **list, compare);
    return DEM_OK;
}

/* Collective. DEM_ERROR_FILE when two particles have the same id. All entries of an id are in
   the sorted list of one rank. */
static int refuse_duplicates(const char *path, const struct dem_decomposition *q, int status,
                             const struct entry *list, size_t n)
{
    int64_t duplicate = -1;

    for (size_t k = 1; k < n && !status; k++)
    {
        duplicate = list[k].id == list[k - 1].id && list[k].id > duplicate ? list[k].id : duplicate;
    }
    dem_collect_max_int64(q, &duplicate, 1);
    DEM_TRY(dem_collect_agree(q, status));
    DEM_REQUIRE(duplicate < 0, DEM_ERROR_FILE,
                "%s is damaged: two of its particles have id %lld; use another one", path,
                (long long)duplicate);
    return DEM_OK;
}

/* ---- messages -------------------------------------------------------------------------------- */

struct bundle                                 /* items of one size, each with its target rank */
{
    size_t n, capacity, to_capacity, size;    /* size in doubles */
    double *item;
    int64_t *to;                              /* target; after an exchange the sender */
};

/* Add an item for rank `to`; a negative rank is ignored. */
static int put(struct bundle *b, int64_t to, const void *item)
{
    if (to < 0)
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_GROW(b->item, b->capacity, (b->n + 1)*b->size));
    DEM_TRY(DEM_GROW(b->to, b->to_capacity, b->n + 1));
    memcpy(b->item + b->n*b->size, item, b->size*sizeof *b->item);
    b->to[b->n++] = to;
    return DEM_OK;
}

/* Pack the items by target rank, one message a rank. */
static int pack_messages(const struct bundle *b, int ranks, struct dem_messages *out)
{
    size_t *count = NULL;
    double **where = NULL;
    int status = DEM_NEW(count, ranks);

    status = status ? status : DEM_NEW(where, ranks);
    for (size_t k = 0; k < b->n && !status; k++)
    {
        count[b->to[k]]++;
    }
    for (int k = 0; k < ranks && !status; k++)
    {
        status = count[k] > 0 ? dem_messages_begin(out, k) : DEM_OK;
        status = status || count[k] == 0 ? status
                                         : dem_messages_extend(out, count[k]*b->size, &where[k]);
    }
    for (int k = 0, peer = 0; k < ranks && !status; k++)
    {
        /* the buffer may have been reallocated while it grew */
        where[k] = count[k] > 0 ? out->data + out->start[peer++] : NULL;
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

/* Collective; `status`, here and below: a rank that has failed before takes part, and all ranks return an error. Send the
   items of the bundle and replace them by the received ones, `to` being the sender. */
static int exchange(const struct dem_decomposition *q, int status, struct bundle *b,
                    struct dem_messages *in)
{
    struct dem_messages out = {.ranks = 0};

    status = status ? status : pack_messages(b, q->ranks, &out);
    b->n = 0;
    status = dem_messages_exchange(q->comm, status, &out, in);
    dem_messages_free(&out);
    for (int k = 0; k < in->ranks && !status; k++)
    {
        for (size_t at = in->start[k]; at < in->start[k + 1] && !status; at += b->size)
        {
            status = put(b, in->rank[k], in->data + at);
        }
    }
    return dem_collect_agree(q, status);
}

static void release(struct bundle *b)
{
    dem_memory_free(b->item);
    dem_memory_free(b->to);
}

/* ---- contacts -------------------------------------------------------------------------------- */

/* A contact goes to the directory ranks of its partners, once when one rank is both. */
static int send_to_directory(const struct dem_decomposition *q, struct bundle *b, const double *row)
{
    struct dem_contact_key name;

    memcpy(&name, row, sizeof name);
    DEM_TRY(put(b, directory_rank(q, name.low), row));
    return directory_rank(q, name.high) != directory_rank(q, name.low)
               ? put(b, directory_rank(q, name.high), row)
               : DEM_OK;
}

/* Read this rank's slice. */
static void read_slice(struct dem_parallel_file *s, const struct dem_decomposition *q,
                       const struct dem_snapshot_header *h, struct bundle *b)
{
    int64_t first, count;
    double *row = NULL;

    dem_snapshot_slice(q, h->rows, &first, &count);
    s->status = DEM_NEW(row, CHUNK*b->size);
    for (int64_t at = first; at < first + count && !s->status; at += CHUNK)
    {
        const size_t n = (size_t)(first + count - at < CHUNK ? first + count - at : CHUNK);

        dem_parallel_file_read(s,
                               dem_snapshot_contacts_offset(h) + (size_t)at*b->size*sizeof *row,
                               row, n*b->size*sizeof *row);
        for (size_t k = 0; k < n && !s->status; k++)
        {
            s->status = dem_snapshot_validate_contact(s->path, h, row + k*b->size);
            s->status = s->status ? s->status : send_to_directory(q, b, row + k*b->size);
        }
    }
    dem_memory_free(row);
}

/* A directory rank sends what it received to the owners in its directory, once when both
   partners have the same owner. */
static int forward(const struct dem_decomposition *q, const struct entry *list, size_t n,
                   struct bundle *b)
{
    struct bundle next = {.size = b->size};
    int status = DEM_OK;

    for (size_t k = 0; k < b->n && !status; k++)
    {
        const double *const row = b->item + k*b->size;
        struct dem_contact_key name;

        memcpy(&name, row, sizeof name);
        const int64_t low =
            directory_rank(q, name.low) == q->rank ? owner_of(list, n, name.low) : -1;
        const int64_t high =
            directory_rank(q, name.high) == q->rank ? owner_of(list, n, name.high) : -1;

        status = put(&next, low, row);
        status = status || high == low ? status : put(&next, high, row);
    }
    release(b);
    *b = next;
    return status;
}

/* Two directory ranks may have sent the same contact: when this rank owns the lower partner,
   the one from the directory rank of the lower partner counts. */
static int is_duplicate(const struct dem_decomposition *q, const struct entry *own, size_t n,
                        const struct dem_contact_key *name, int64_t from)
{
    return owner_of(own, n, name->low) >= 0 && from != directory_rank(q, name->low);
}

static int load_contact(struct dem_contacts *c, const struct dem_snapshot_header *h,
                        const struct dem_interaction_table *r, struct dem_contact_key name,
                        const double *packed)
{
    double history[DEM_HISTORY_COLUMNS] = {0.0};

    for (int64_t k = 0; k < h->memories; k++)
    {
        const char *const stored = h->list[h->materials + h->columns + k].name;

        for (int m = 0; m < r->history_columns; m++)
        {
            history[m] = strcmp(r->history_name[m], stored) == 0 ? packed[k] : history[m];
        }
    }
    return dem_contact_history_append(&c->history, &name, history);
}

/* 0 when the contact is with a facet that this run does not have. */
static int renumber(const struct dem_snapshot_facets *facets, struct dem_contact_key *name)
{
    const int64_t was = -1 - name->high;

    if (!facets->changed || name->high >= 0)
    {
        return 1;
    }
    for (int k = 0; k < facets->walls; k++)
    {
        const struct dem_facet_range *const w = &facets->wall[k];

        if (was >= w->was && was < w->was + w->facets)
        {
            name->high = -1 - (w->now + was - w->was);
            return 1;
        }
    }
    return 0;
}

static int load_contacts(const char *path, struct dem_contacts *c,
                         const struct dem_snapshot_header *h, const struct dem_interaction_table *r,
                         const struct dem_decomposition *q, const struct dem_particles *p,
                         const struct dem_snapshot_facets *facets, const struct bundle *b)
{
    struct entry *own = NULL;
    int status = list_own(q, p, &own);

    /* with several ranks the directory ranks have checked */
    status = status || q->ranks > 1 ? status : refuse_duplicates(path, q, DEM_OK, own, p->n);
    for (size_t k = 0; k < b->n && !status; k++)
    {
        const double *const row = b->item + k*b->size;
        struct dem_contact_key name;

        memcpy(&name, row, sizeof name);
        if (!is_duplicate(q, own, p->n, &name, b->to[k]) && renumber(facets, &name))
        {
            name.counted = (uint32_t)(owner_of(own, p->n, name.low) >= 0);
            status = load_contact(c, h, r, name, row + DEM_SNAPSHOT_CONTACT);
        }
    }
    dem_memory_free(own);
    return status;
}

/* Collective. Owners send their ids to the directory ranks; `list` is the directory of this
   rank. */
static int build_directory(const struct dem_decomposition *q, const struct dem_particles *p,
                           struct dem_messages *in, struct entry **list, size_t *n)
{
    struct bundle b = {.size = 1};
    int status = DEM_OK;

    for (size_t i = 0; i < p->n && !status; i++)
    {
        status = put(&b, directory_rank(q, p->record[i].id), &p->record[i].id);
    }
    status = exchange(q, status, &b, in);
    status = status ? status : DEM_NEW(*list, b.n + 1);
    for (size_t k = 0; k < b.n && !status; k++)
    {
        memcpy(&(*list)[k].id, b.item + k, sizeof(int64_t));
        (*list)[k].owner = b.to[k];
    }
    *n = status ? 0 : b.n;
    if (*n > 0)
    {
        dem_sort_by(*list, *n, sizeof **list, compare);
    }
    release(&b);
    return status;
}

/* Collective. By way of the directory ranks to the owners. */
static int send_to_owners(const char *path, const struct dem_decomposition *q,
                          const struct dem_particles *p, struct bundle *b)
{
    struct dem_messages in = {.ranks = 0};
    struct entry *list = NULL;
    size_t n;
    int status = build_directory(q, p, &in, &list, &n);

    status = refuse_duplicates(path, q, status, list, n);
    status = status ? status : exchange(q, DEM_OK, b, &in);
    status = status ? status : exchange(q, forward(q, list, n, b), b, &in);
    dem_messages_free(&in);
    dem_memory_free(list);
    return status;
}

int dem_snapshot_read_contacts(const char *path, const struct dem_decomposition *q,
                               const struct dem_interaction_table *r, const struct dem_particles *p,
                               const struct dem_snapshot_facets *facets, struct dem_contacts *c)
{
    const struct dem_file_ranks by = dem_file_ranks_of(q);
    struct dem_parallel_file store;
    struct dem_snapshot_header h;

    DEM_TRY(dem_snapshot_open(&store, &by, path, &h));
    struct bundle b = {.size = dem_snapshot_contact_doubles(&h)};

    read_slice(&store, q, &h, &b);
    /* synchronises: earlier exchanges are complete */
    int status = dem_parallel_file_close(&store);

    status = status || q->ranks == 1 ? status : send_to_owners(path, q, p, &b);
    status = status ? status : load_contacts(path, c, &h, r, q, p, facets, &b);
    release(&b);
    return status;
}
