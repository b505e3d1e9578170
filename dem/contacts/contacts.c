/*
 * contacts.c -- the steps that concern pairs, rows, history and forces together: prune, save and
 * restore history.
 *
 * A prune renumbers the rows; history columns move with them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "contacts/contacts.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/periodic_image.h"
#include <string.h>

int dem_contacts_init(struct dem_contacts *c, const struct dem_interaction_table *r)
{
    memset(c, 0, sizeof *c);
    c->history.columns = r->history_columns;
    c->forces.moments = r->moments;
    c->forces.has_energy = c->forces.all_rows = r->past_touching;
    c->forces.rates = r->contact_scalars ? r->listed : 0;
    return dem_contact_rows_init(&c->rows, r->classes);
}

void dem_contacts_free(struct dem_contacts *c)
{
    dem_pair_list_free(&c->pairs);
    dem_contact_rows_free(&c->rows);
    dem_contact_history_free(&c->history);
    dem_contact_forces_free(&c->forces);
    memset(c, 0, sizeof *c);
}

/* A pair between two owned particles is an entry of both. */
size_t dem_contacts_bytes_per_pair(const struct dem_contacts *c)
{
    return sizeof *c->pairs.pair + 2*(sizeof *c->pairs.entry + sizeof *c->rows.entry);
}

/* During a rebuild saved history takes the memory that contact forces have otherwise. */
size_t dem_contacts_bytes_per_row(const struct dem_contacts *c, int ring)
{
    return sizeof *c->rows.pair + sizeof *c->rows.partners +
           (size_t)(c->history.columns + 1)*sizeof *c->history.scratch +
           dem_contact_forces_bytes_per_row(&c->forces, ring);
}

size_t dem_contacts_bytes(const struct dem_contacts *c)
{
    return dem_pair_list_bytes(&c->pairs) + dem_contact_rows_bytes(&c->rows) +
           dem_contact_history_bytes(&c->history) + dem_contact_forces_bytes(&c->forces);
}

int dem_contacts_prune(struct dem_contacts *c, const struct dem_particles *particles,
                       const uint8_t *near)
{
    const uint32_t *from;

    DEM_TRY(dem_contact_rows_number(&c->rows, &c->pairs, near, particles->n, &from));
    DEM_TRY(dem_contact_history_resize(&c->history, c->rows.capacity));
    dem_contact_history_move(&c->history, c->rows.n, from);
    DEM_TRY(dem_contact_forces_resize(&c->forces, c->rows.n + DEM_PADDING_ROWS,
                                      c->rows.capacity));
    DEM_TRY(dem_contact_rows_build_adjacency(&c->rows, &c->pairs, particles->n));
    DEM_TRY(dem_contact_forces_assign_slots(&c->forces, &c->rows, particles->n));
    return c->history.saved > 0 ? DEM_OK : dem_contact_forces_allocate(&c->forces, &c->rows);
}

/* ---- history --------------------------------------------------------------------------------- */

struct dem_contact_key dem_contacts_key(const struct dem_contacts *c,
                                        const struct dem_particles *particles,
                                        const struct dem_facet_key *wall_facet, uint32_t row)
{
    const struct dem_pair *const q = dem_contacts_pair(c, row);
    const struct dem_particle *const i = &particles->record[q->i];

    if (q->wall)
    {
        return (struct dem_contact_key){.low = i->id, .high = -1 - wall_facet[q->j].number,
                                        .image = wall_facet[q->j].image};
    }
    const struct dem_particle *const j = &particles->record[q->j];

    return (struct dem_contact_key){.low = i->id,
                                    .high = j->id,
                                    .image = dem_image_of_pair(q->shift, i->image, j->image)};
}

static int has_history(const struct dem_contacts *c, uint32_t row)
{
    return c->rows.pair[row] != DEM_ROW_NONE && dem_contact_history_any(&c->history, row);
}

/* Append the rows of `from` that have history to the saved history h. Each contact is counted by
   the owner of its lower particle. */
static int save_rows(struct dem_contact_history *h, const struct dem_contacts *from,
                     const struct dem_particles *particles, const struct dem_facet_key *wall_facet)
{
    double values[DEM_HISTORY_COLUMNS];
    size_t more = 0;

    for (uint32_t r = 0; r < from->rows.n; r++)
    {
        more += (size_t)has_history(from, r);
    }
    DEM_TRY(dem_contact_history_reserve(h, more));
    for (uint32_t r = 0; r < from->rows.n; r++)
    {
        if (has_history(from, r))
        {
            struct dem_contact_key key = dem_contacts_key(from, particles, wall_facet, r);

            key.counted = dem_contacts_pair(from, r)->i < particles->n;
            dem_contact_history_get(&from->history, r, values);
            DEM_TRY(dem_contact_history_append(h, &key, values));
        }
    }
    return DEM_OK;
}

int dem_contacts_save_history(struct dem_contacts *c, const struct dem_particles *particles,
                              const struct dem_facet_key *wall_facet)
{
    dem_contact_forces_release(&c->forces);
    DEM_TRY(save_rows(&c->history, c, particles, wall_facet));
    dem_contact_rows_clear(&c->rows);
    dem_contact_history_clear(&c->history);
    dem_contact_forces_clear(&c->forces);
    return DEM_OK;
}

int dem_contacts_copy_saved(struct dem_contacts *c, const struct dem_contacts *from,
                            const struct dem_particles *particles,
                            const struct dem_facet_key *wall_facet)
{
    const struct dem_contact_history *const h = &from->history;

    for (size_t k = 0; k < h->saved; k++)
    {
        DEM_TRY(dem_contact_history_append(&c->history, &h->saved_key[k],
                                           h->saved_value + k*(size_t)h->columns));
    }
    return save_rows(&c->history, from, particles, wall_facet);
}

int dem_contacts_restore_history(struct dem_contacts *c, const struct dem_particles *particles,
                                 const struct dem_facet_key *wall_facet)
{
    struct dem_contact_hash hash;

    if (c->history.saved == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_contact_history_hash(&c->history, &hash));
    for (uint32_t r = 0; r < c->rows.n; r++)
    {
        if (c->rows.pair[r] != DEM_ROW_NONE)
        {
            const struct dem_contact_key key = dem_contacts_key(c, particles, wall_facet, r);

            dem_contact_history_take(&c->history, &hash, &key, r);
        }
    }
    dem_memory_free(hash.slot);
    dem_contact_history_forget(&c->history);
    return dem_contact_forces_allocate(&c->forces, &c->rows);
}

void dem_contacts_turn_images(struct dem_contacts *c, int turns)
{
    for (size_t k = 0; turns != 0 && k < c->history.saved; k++)
    {
        struct dem_contact_key *const key = &c->history.saved_key[k];
        const int across = dem_image_difference((uint32_t)key->image, 0, 1);

        key->image = key->high < 0 ? key->image : dem_image_add((uint32_t)key->image, 0, turns*across);
    }
}
