/*
 * contacts_history.c -- saves contact history by key before a rebuild and assigns it to the new
 * rows.
 *
 * The key (lower id, higher id or facet, image) does not depend on lists or ranks, so saved history
 * also moves with particles between ranks and into snapshots. Rows are matched with keys by
 * hashing.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/memory.h"
#include "core/random.h"
#include "model/contacts.h"
#include "model/periodic_image.h"
#include <string.h>

struct dem_contact_key dem_contacts_key(const struct dem_contacts *c, const struct dem_particles *p,
                                        const int *wall_facet, uint32_t row)
{
    const struct dem_pair *const q = &c->pair[c->row_pair[row]];
    const struct dem_particle *const i = &p->record[q->i];

    if (q->wall)
    {
        return (struct dem_contact_key){.low = i->id, .high = -1 - wall_facet[q->j]};
    }
    const struct dem_particle *const j = &p->record[q->j];

    return (struct dem_contact_key){.low = i->id,
                                    .high = j->id,
                                    .image = dem_image_of_pair(q->shift, i->image, j->image)};
}

int dem_contacts_has_history(const struct dem_contacts *c, uint32_t row)
{
    int some = 0;

    for (int m = 0; m < c->history_columns; m++)
    {
        some |= c->history[m][row] != 0.0;
    }
    return some;
}

void dem_contacts_get_history(const struct dem_contacts *c, uint32_t row, double *history)
{
    for (int m = 0; m < c->history_columns; m++)
    {
        history[m] = c->history[m][row];
    }
}

int dem_contacts_append_saved(struct dem_contacts *c, const struct dem_contact_key *key,
                              const double *history)
{
    DEM_TRY(DEM_GROW(c->saved_key, c->saved_capacity, c->saved + 1));
    DEM_TRY(DEM_GROW(c->saved_history, c->saved_history_capacity,
                     (c->saved + 1)*(size_t)c->history_columns));
    c->saved_key[c->saved] = *key;
    memcpy(c->saved_history + c->saved*(size_t)c->history_columns, history,
           (size_t)c->history_columns*sizeof *history);
    c->saved++;
    return DEM_OK;
}

/* Append the rows of `from` that have history to the saved history of c. Each contact is counted by
   the owner of its lower particle. */
static int save_rows(struct dem_contacts *c, const struct dem_contacts *from,
                     const struct dem_particles *p, const int *wall_facet)
{
    double history[DEM_HISTORY_COLUMNS];
    size_t more = 0;

    for (uint32_t r = 0; r < from->rows; r++)
    {
        more += from->row_pair[r] != DEM_ROW_NONE && dem_contacts_has_history(from, r);
    }
    DEM_TRY(DEM_GROW(c->saved_key, c->saved_capacity, c->saved + more));
    DEM_TRY(DEM_GROW(c->saved_history, c->saved_history_capacity,
                     (c->saved + more)*(size_t)c->history_columns));
    for (uint32_t r = 0; r < from->rows; r++)
    {
        if (from->row_pair[r] != DEM_ROW_NONE && dem_contacts_has_history(from, r))
        {
            struct dem_contact_key key = dem_contacts_key(from, p, wall_facet, r);

            key.counted = from->pair[from->row_pair[r]].i < p->n;
            dem_contacts_get_history(from, r, history);
            DEM_TRY(dem_contacts_append_saved(c, &key, history));
        }
    }
    return DEM_OK;
}

int dem_contacts_save_history(struct dem_contacts *c, const struct dem_particles *p,
                              const int *wall_facet)
{
    dem_contacts_free_forces(c);
    DEM_TRY(save_rows(c, c, p, wall_facet));
    dem_contacts_free_rows(c);
    return DEM_OK;
}

int dem_contacts_copy_saved(struct dem_contacts *c, const struct dem_contacts *from,
                            const struct dem_particles *p, const int *wall_facet)
{
    for (size_t k = 0; k < from->saved; k++)
    {
        DEM_TRY(dem_contacts_append_saved(c, &from->saved_key[k],
                                          from->saved_history + k*(size_t)from->history_columns));
    }
    return save_rows(c, from, p, wall_facet);
}

static size_t slot_of(const struct dem_contact_key *key, size_t mask)
{
    return dem_random_bits((uint64_t)key->low, (uint64_t)key->high, key->image, 0) & mask;
}

static int same_key(const struct dem_contact_key *a, const struct dem_contact_key *b)
{
    return a->low == b->low && a->high == b->high && a->image == b->image;
}

int dem_contacts_restore_history(struct dem_contacts *c, const struct dem_particles *p,
                                 const int *wall_facet)
{
    size_t mask = 15;
    uint32_t *table;

    if (c->saved == 0)
    {
        return DEM_OK;
    }
    while (mask < 2*c->saved)
    {
        mask = 2*mask + 1;
    }
    DEM_TRY(DEM_NEW(table, mask + 1));
    for (size_t k = 0; k < c->saved; k++)
    {
        size_t slot = slot_of(&c->saved_key[k], mask);

        while (table[slot])
        {
            slot = (slot + 1) & mask;
        }
        table[slot] = (uint32_t)k + 1;
    }
    for (uint32_t r = 0; r < c->rows; r++)
    {
        if (c->row_pair[r] == DEM_ROW_NONE)
        {
            continue;
        }
        const struct dem_contact_key key = dem_contacts_key(c, p, wall_facet, r);
        size_t slot = slot_of(&key, mask);

        while (table[slot] && !same_key(&c->saved_key[table[slot] - 1], &key))
        {
            slot = (slot + 1) & mask;
        }
        for (int m = 0; table[slot] && m < c->history_columns; m++)
        {
            c->history[m][r] =
                c->saved_history[(table[slot] - 1)*(size_t)c->history_columns + (size_t)m];
        }
    }
    dem_memory_free(table);
    dem_memory_free(c->saved_key);
    dem_memory_free(c->saved_history);
    c->saved_key = NULL;
    c->saved_history = NULL;
    c->saved = c->saved_capacity = c->saved_history_capacity = 0;
    return dem_contacts_allocate_forces(c);
}
