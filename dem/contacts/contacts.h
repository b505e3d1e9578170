/*
 * contacts.h -- the contacts of a rank.
 *
 *   pair_list.h         pairs: gap < outer skin; found from cells, rarely
 *   contact_rows.h      candidate contacts: gap < inner skin; pruned from pairs, tested in each step
 *   contact_history.h   history columns of the rows; saved history
 *   contact_forces.h    contact force of each row; force buffer
 *
 * Touching contacts, overlap > 0, are a mask inside a contact batch (contact_batch.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "contacts/contact_forces.h"
#include "contacts/contact_history.h"

struct dem_contacts
{
    struct dem_pair_list pairs;
    struct dem_contact_rows rows;
    struct dem_contact_history history;
    struct dem_contact_forces forces;
};

/* The pair of a row that is not padding. */
static inline struct dem_pair *dem_contacts_pair(const struct dem_contacts *c, uint32_t row)
{
    return &c->pairs.pair[c->rows.pair[row]];
}

/* The force, and the moment, of a row of walls. */
static inline const struct dem_contact_force *
dem_contacts_wall_force(const struct dem_contacts *c, uint32_t row)
{
    const struct dem_segment *const s = &c->rows.segment[dem_contacts_pair(c, row)->class];

    return &c->forces.force[s->slot + (row - s->first)];
}

static inline const struct dem_contact_moment *
dem_contacts_wall_moment(const struct dem_contacts *c, uint32_t row)
{
    const struct dem_segment *const s = &c->rows.segment[dem_contacts_pair(c, row)->class];

    return &c->forces.moment[s->slot + (row - s->first)];
}

int dem_contacts_init(struct dem_contacts *, const struct dem_interaction_table *);
void dem_contacts_free(struct dem_contacts *);

/* Bytes held; bytes of one pair; of one contact row, in a scene with a force buffer or without. */
size_t dem_contacts_bytes(const struct dem_contacts *);
size_t dem_contacts_bytes_per_pair(const struct dem_contacts *);
size_t dem_contacts_bytes_per_row(const struct dem_contacts *, int ring);

/* Make rows of the pairs marked in `near` (one byte per pair). Rows that stay keep their
   history. */
int dem_contacts_prune(struct dem_contacts *, const struct dem_particles *, const uint8_t *near);

/* Key of a row for saved history. `wall_facet`: the facet of each wall neighbor. */
struct dem_contact_key dem_contacts_key(const struct dem_contacts *, const struct dem_particles *,
                                        const struct dem_facet_key *wall_facet, uint32_t row);

/* While history is saved: pairs across the faces of y get another x, by so many lengths. */
void dem_contacts_turn_images(struct dem_contacts *, int turns);

/* Before a rebuild: save the history of every row that has one, and free the rows. */
int dem_contacts_save_history(struct dem_contacts *, const struct dem_particles *,
                              const struct dem_facet_key *wall_facet);

/* Append the saved history of `from` and the history of its rows to the saved history here; `from`
   is not changed. */
int dem_contacts_copy_saved(struct dem_contacts *, const struct dem_contacts *from,
                            const struct dem_particles *, const struct dem_facet_key *wall_facet);

/* After a rebuild: assign saved history to the rows with the same keys, then empty it. */
int dem_contacts_restore_history(struct dem_contacts *, const struct dem_particles *,
                                 const struct dem_facet_key *wall_facet);
