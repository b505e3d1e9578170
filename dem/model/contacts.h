/*
 * contacts.h -- neighbor pairs, contact rows, contact history and the order in which forces are
 * summed.
 *
 *   pairs               gap < outer skin; found from cells, rarely; sorted by pair class, wall
 *                       classes last
 *   candidate contacts  gap < inner skin; pruned from the pairs; tested in each step
 *   touching contacts   overlap > 0; a mask inside a contact batch
 *
 * Each candidate contact has one contact row: its history columns and its contact force. A row is
 * seen from the lower id (i) to the higher id or the wall (j). History survives a prune by the
 * index of the pair, and a rebuild or a change of rank as saved history with the key (lower id,
 * higher id or facet, image).
 *
 * A particle sums its rows by partner id, walls last by facet: `row_entry` lists them in that
 * order as 4 row + 2 buffered + side.
 *
 * Most rows are summed shortly after they are computed. In a step whose contact forces are not read
 * afterwards they pass through a ring buffer of DEM_FORCE_BUFFER_ROWS rows that stays in the
 * second-level cache, instead of through memory. Rows that are summed later (deferred) or that
 * belong to walls are stored at their own index as well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_MODEL_CONTACTS_H
#define DEM_MODEL_CONTACTS_H

#include "model/particles.h"
#include "model/interaction_table.h"

enum
{
    DEM_ROW_NONE = 0x7fffffff,
    DEM_FORCE_BUFFER_ROWS = 4096  /* contact forces in the force buffer, 256
                                     kB: two layers of a bed of 40 by 40 */
};

enum                                                      /* bits of row_entry, below the row */
{
    DEM_ENTRY_SIDE = 1,      /* 1: of j */
    DEM_ENTRY_BUFFERED = 2,  /* 1: still in the force buffer when summed */
    DEM_ENTRY_ROW_SHIFT = 2  /* number of bits below the row */
};

struct dem_pair
{
    uint32_t i, j;                /* records; j at a wall: index of the wall neighbor */
    uint32_t row;                 /* its contact row, or DEM_ROW_NONE */
    uint16_t class;               /* pair class of the interaction table */
    uint8_t shift;                /* code: r = x_i - x_j + shift L */
    uint8_t wall;                 /* 1: with a wall */
};

enum
{
    DEM_PARTNER_SHIFT = 27,                      /* bits of a record's index in
                                                    struct dem_row_partners */
    DEM_PARTNER_LIMIT = 1 << DEM_PARTNER_SHIFT,  /* limit of the records of a rank */
    DEM_ROWS_AHEAD = 32                          /* rows prefetched ahead, also past the
                                                    last: 16 and 64 gained a little less */
};

/* partners of a row: the compact form of its pair */
struct dem_row_partners
{
    uint32_t i, j;                /* records; above the bits of j the shift */
};

/* contact force of a row; one cache line */
struct dem_contact_force
{
    double f[3], arm;             /* N on i; m: the lever arm of a side is radius - arm */
    double t[3], spare;           /* N: n x F; torque on a side: -(radius - arm) t */
};

/* the same in single precision (mixed precision) */
struct dem_contact_force_single
{
    float f[3], arm;
    float t[3], spare;
};

/* energies of a row, see effects/batch.h */
struct dem_contact_energy
{
    double stored, lost;          /* J, J in the last step */
    double bonds, broke;          /* bonds that hold, that broke in the last step */
};

/* the rows of one class, padded to whole batches */
struct dem_segment
{
    uint32_t first, count;
};

/* key of a contact whose history is saved */
struct dem_contact_key
{
    int64_t low, high;            /* ids; high is -1 - facet at a wall */
    uint32_t image;
    uint32_t counted;             /* 1: this rank counts the contact (after a load) */
};

struct dem_contacts
{
    size_t pairs, pair_capacity;
    struct dem_pair *pair;

    uint32_t rows;                                         /* with padding */
    size_t row_capacity;
    uint32_t *row_pair;                                    /* DEM_ROW_NONE on padding */
    struct dem_row_partners *row_partners;                 /* padding repeats the last row
                                                              of its class; DEM_ROWS_AHEAD
                                                              zeros past the end */
    struct dem_segment *segment;                           /* one per class */
    int classes;
    int history_columns;                                   /* number of history columns */
    double *history[DEM_HISTORY_COLUMNS];                  /* history columns, one value per row */
    double *history_scratch;
    struct dem_contact_force *force;                       /* per row; one of the two is NULL */
    struct dem_contact_force_single *force_single;
    int single;                                            /* 1: contact forces in
                                                              single precision */
    size_t force_capacity;
    struct dem_contact_force *force_buffer;                /* force buffer of DEM_FORCE_BUFFER_ROWS
                                                              rows where it pays, */
    struct dem_contact_force_single *force_buffer_single;  /* else NULL; again one of the two */
    size_t deferred_rows, deferred_capacity;
    uint32_t *deferred_row;                                /* deferred rows: summed after the
                                                              force buffer has been overwritten;
                                                              ascending; no walls */
    double *moment;                                        /* 3 per row; NULL: no
                                                              effect makes moments */
    int moments;
    struct dem_contact_energy *energy;                     /* per row; NULL: no effect
                                                              acts past touching */
    int has_energy;

    /* adjacency: pairs of each owned particle, then its rows */
    size_t start_capacity, pair_entry_capacity, row_entry_capacity;
    uint32_t *pair_start, *pair_entry;                     /* 2 pair + side, in the order of sums */
    uint32_t *row_start, *row_entry;                       /* see above; padded to an even
                                                              number with the row past the
                                                              last, whose force is zero */

    size_t rows_needed_capacity;
    uint32_t *rows_needed;                                 /* per batch of owned particles: number
                                                              of pair rows that must be computed
                                                              (with all wall rows) before this batch
                                                              and all before it can be summed */

    size_t saved, saved_capacity, saved_history_capacity;
    struct dem_contact_key *saved_key;                     /* keys of the saved history */
    double *saved_history;                                 /* saved history, `history_columns`
                                                              numbers per key */
};

int dem_contacts_init(struct dem_contacts *, const struct dem_interaction_table *);
void dem_contacts_free(struct dem_contacts *);

/* 1 when steps whose contact forces are not read afterwards use the force buffer. */
static inline int dem_contacts_use_force_buffer(const struct dem_contacts *c)
{
    return c->force_buffer || c->force_buffer_single;
}

/* Contact force of a row. After a step through the force buffer only rows of walls are valid. */
static inline struct dem_contact_force dem_contacts_force(const struct dem_contacts *c,
                                                          uint32_t row)
{
    if (c->single)
    {
        const struct dem_contact_force_single *const s = &c->force_single[row];

        return (struct dem_contact_force){.f = {s->f[0], s->f[1], s->f[2]},
                                          .arm = s->arm,
                                          .t = {s->t[0], s->t[1], s->t[2]}};
    }
    return c->force[row];
}

/* Bytes held; bytes of the force buffer, of one pair and of one contact row. */
size_t dem_contacts_bytes(const struct dem_contacts *);
size_t dem_contacts_force_buffer_bytes(const struct dem_contacts *);
size_t dem_contacts_bytes_per_pair(const struct dem_contacts *);
size_t dem_contacts_bytes_per_row(const struct dem_contacts *);

/* After a new list of pairs (already in place, sorted by class and particle): list the pairs of
   each owned particle in the order of its sum. */
int dem_contacts_build_adjacency(struct dem_contacts *, const struct dem_particles *);

/* For contacts.c, after rows and adjacency are built: mark the rows that are summed from the force
   buffer, list the deferred ones, and allocate the buffer where it pays. n: owned particles. */
int dem_contacts_make_force_buffer(struct dem_contacts *, size_t n);

/* For contacts_history.c: allocate contact forces for all rows (zero until a sweep writes them;
   that of the row past the last stays zero), free them, free the rows. While history is saved there
   are neither rows nor contact forces: this keeps the peak of memory low. */
int dem_contacts_allocate_forces(struct dem_contacts *);
void dem_contacts_free_forces(struct dem_contacts *);
void dem_contacts_free_rows(struct dem_contacts *);

/* Make rows of the pairs marked in `near` (one byte per pair). Rows that stay keep their
   history. */
int dem_contacts_prune(struct dem_contacts *, const struct dem_particles *, const uint8_t *near);

/* Key of a row for saved history. */
struct dem_contact_key dem_contacts_key(const struct dem_contacts *, const struct dem_particles *,
                                        const int *wall_facet, uint32_t row);

/* 1 when any history value of the row is not zero. */
int dem_contacts_has_history(const struct dem_contacts *, uint32_t row);

/* Copy the history values of a row to the array. */
void dem_contacts_get_history(const struct dem_contacts *, uint32_t row, double *history);

/* Append one contact to the saved history. */
int dem_contacts_append_saved(struct dem_contacts *, const struct dem_contact_key *,
                              const double *history);

/* Before a rebuild: save the history of every row that has one, and free the rows. `wall_facet`:
   the facet of each wall neighbor. */
int dem_contacts_save_history(struct dem_contacts *, const struct dem_particles *,
                              const int *wall_facet);

/* Append the saved history of `from` and the history of its rows to the saved history here; `from`
   is not changed. */
int dem_contacts_copy_saved(struct dem_contacts *, const struct dem_contacts *from,
                            const struct dem_particles *, const int *wall_facet);

/* After a rebuild: assign saved history to the rows with the same keys, then empty it. */
int dem_contacts_restore_history(struct dem_contacts *, const struct dem_particles *,
                                 const int *wall_facet);

#endif
