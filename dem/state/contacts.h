/*
 * contacts.h -- outer pairs, the near rows pruned from them, what rows remember, and who sums which row.
 *
 *   outer pairs   gap < outer skin, found from cells, rarely; sorted by pair class, wall classes last
 *   near rows     gap < inner skin, pruned from the pairs; one row of memory and one push each; this is what the sweep runs over
 *   touching      a lane mask inside the sweep
 *
 * A row is seen from the lower id (i) to the higher id or the wall (j). Memory survives a prune by pair, and a rebuild
 * or a change of rank as a "carried" row named by (lower id, higher id or region, image).
 *
 * A particle sums its rows by partner id, walls last by region: `near_entry` lists them in that order as 4 row + 2 soon + side.
 *
 * Most rows are summed soon after they are swept. While nobody wants to look at them (a quiet step) their pushes go round in a ring
 * that stays in the second cache, instead of through memory; those that are summed later, or at a wall, are kept at their own places.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_CONTACTS_H
#define DEM_STATE_CONTACTS_H

#include "state/particles.h"
#include "state/recipe.h"

enum
{
    DEM_ROW_NONE = 0x7fffffff,
    DEM_RING = 4096                                       /* pushes that the ring holds, 256 kB: two layers of a bed of 40 by 40 */
};

enum                                                      /* bits of near_entry, below the row */
{
    DEM_ENTRY_SIDE = 1,                                   /* 1: of j */
    DEM_ENTRY_SOON = 2,                                   /* still in the ring when it is summed */
    DEM_ENTRY_ROW = 2                                     /* bits */
};

struct dem_pair
{
    uint32_t i, j;                                        /* records; j is the place in the list of wall nears at a wall */
    uint32_t row;                                         /* its near row, or DEM_ROW_NONE */
    uint16_t class;                                       /* of the recipe */
    uint8_t shift;                                        /* code: r = x_i - x_j + shift L */
    uint8_t wall;                                         /* 1: with a wall */
};

enum
{
    DEM_NEAR_SHIFT = 27,                                  /* bits of a record's number in struct dem_near */
    DEM_NEAR_RECORDS = 1 << DEM_NEAR_SHIFT,               /* so many records a rank may have */
    DEM_NEAR_AHEAD = 32                                   /* rows that the sweep looks ahead, also past the last: 16 and 64 gained a little less */
};

struct dem_near                                           /* of a row, what the sweep reads: its pair in short */
{
    uint32_t i, j;                                        /* records, and above j's bits the shift */
};

struct dem_push                                           /* what a row does to its partners; one cache line */
{
    double f[3], arm;                                     /* N on i, m: the lever is radius - arm on either side */
    double t[3], spare;                                   /* N: n x F; the torque is -(radius - arm) t on either side */
};

struct dem_push_single                                    /* the same in single precision, of runs of mixed precision */
{
    float f[3], arm;
    float t[3], spare;
};

struct dem_books                                          /* energies of a row: see effects/block.h */
{
    double stored, lost;                                  /* J, J in the last step */
    double bonds, broke;                                  /* that hold, that broke in the last step */
};

struct dem_segment                                        /* the near rows of one class, padded to whole blocks of lanes */
{
    uint32_t first, count;
};

struct dem_carried                                        /* a row's name and where its memory lies */
{
    int64_t low, high;                                    /* ids; high is -1 - region at a wall */
    uint32_t image;
    uint32_t counted;                                     /* 1: this rank is the one that counts it (after a load) */
};

struct dem_contacts
{
    size_t pairs, pair_room;
    struct dem_pair *pair;

    uint32_t rows;                                        /* with padding */
    size_t row_room;
    uint32_t *row_pair;                                   /* DEM_ROW_NONE on padding */
    struct dem_near *near_row;                            /* padding repeats the last row of its class; DEM_NEAR_AHEAD zeros past the end */
    struct dem_segment *segment;                          /* one a class */
    int classes;
    int memories;
    double *memory[DEM_MEMORY_COLUMNS];
    double *memory_scratch;
    struct dem_push *push;                                /* of these two one is there, the other NULL */
    struct dem_push_single *push_single;
    int single;
    size_t push_room;
    struct dem_push *ring;                                /* DEM_RING of them, where it pays, else NULL; again one of two */
    struct dem_push_single *ring_single;
    size_t fars, far_room;
    uint32_t *far;                                        /* rows of pairs that are summed after the ring has come round, rising */
    double *moment;                                       /* 3 a row; NULL when no effect makes moments */
    int moments;
    struct dem_books *books;                              /* one a row; NULL when no effect acts past touching */
    int booked;

    size_t start_room, entry_room, near_room;                        /* adjacency: pairs of each owned particle, then its near rows */
    uint32_t *start, *entry;                              /* 2 pair + side, in the order of sums */
    uint32_t *near_start, *near_entry;                    /* see above; an even number, made so by the row past all, which does
                                                             nothing to nobody */

    size_t ready_room;
    uint32_t *ready;                                      /* a block of owned particles: so many rows of pairs, with those of all walls, and
                                                             they and all before them have all they sum */

    size_t carried, carried_room, kept_room;
    struct dem_carried *carry;
    double *kept;                                         /* memories numbers a carried row */
};

int dem_contacts_init(struct dem_contacts *, const struct dem_recipe *);
void dem_contacts_free(struct dem_contacts *);

/* 1 when quiet steps have a ring. */
static inline int dem_contacts_go_round(const struct dem_contacts *c)
{
    return c->ring || c->ring_single;
}

/* What a row does to its partners. Not after a quiet step, but for walls. */
static inline struct dem_push dem_contacts_push(const struct dem_contacts *c, uint32_t row)
{
    if (c->single)
    {
        const struct dem_push_single *const s = &c->push_single[row];

        return (struct dem_push){.f = {s->f[0], s->f[1], s->f[2]}, .arm = s->arm, .t = {s->t[0], s->t[1], s->t[2]}};
    }
    return c->push[row];
}

/* Bytes held, and bytes that the ring, one outer pair and one near row take. */
size_t dem_contacts_bytes(const struct dem_contacts *);
size_t dem_contacts_ring(const struct dem_contacts *);
size_t dem_contacts_each_pair(const struct dem_contacts *);
size_t dem_contacts_each_row(const struct dem_contacts *);

/* New list of pairs (already in place, sorted by class and particle): lay out who sums what. `partner` orders sums, see pairs.c. */
int dem_contacts_adjoin(struct dem_contacts *, const struct dem_particles *);

/* Who sums which row soon, for contacts.c, after rows and sums are laid out; n owned particles. */
int dem_contacts_make_ring(struct dem_contacts *, size_t n);

/* Between lift and settle there are neither rows nor pushes: what is carried has their room. For contacts_carry.c: pushes for all
   rows, to be written by a sweep (new ones do nothing until then; the row past all never does), no pushes, no rows. */
int dem_contacts_make_pushes(struct dem_contacts *);
void dem_contacts_drop_pushes(struct dem_contacts *);
void dem_contacts_drop_rows(struct dem_contacts *);

/* Keep as near rows the pairs marked in `near` (one byte a pair); memory of rows that stay is kept. */
int dem_contacts_prune(struct dem_contacts *, const struct dem_particles *, const uint8_t *near);

/* Name of a row, for carrying. */
struct dem_carried dem_contacts_name(const struct dem_contacts *, const struct dem_particles *, const int *wall_region, uint32_t row);

/* 1 when any remembered number of the row is not zero. */
int dem_contacts_remembers(const struct dem_contacts *, uint32_t row);

/* The remembered numbers of a row. */
void dem_contacts_recall(const struct dem_contacts *, uint32_t row, double *memory);

int dem_contacts_carry(struct dem_contacts *, const struct dem_carried *, const double *memory);

/* Lift every row with memory into the carried list (before a rebuild); `wall_region` of each wall near. */
int dem_contacts_lift(struct dem_contacts *, const struct dem_particles *, const int *wall_region);

/* Add the carried rows of `from` and its near rows with memory to the carried ones here, and leave `from` as it is. */
int dem_contacts_copy_rows(struct dem_contacts *, const struct dem_contacts *from, const struct dem_particles *,
                           const int *wall_region);

/* Give carried memory back to the near rows of the same name (after a rebuild), then empty the list. */
int dem_contacts_settle(struct dem_contacts *, const struct dem_particles *, const int *wall_region);

#endif
