/*
 * row.h -- one row of the contact batch in registers.
 *
 * The arithmetic of a contact law is written once, on one row: dem_<law>_row(settings, row,
 * history). The template laws/contact_loop.h makes the law's own loop of it; laws/fused puts the
 * rows of several laws into one loop. Columns that a law does not read cost nothing: the compiler
 * drops the loads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_ROW_H
#define DEM_LAWS_ROW_H

#include "core/math.h"
#include "laws/batch.h"

/* the columns of batch.h that laws of a contact work on, under the same names */
#define DEM_ROW_COLUMNS(COLUMN)                                                                \
    COLUMN(nx) COLUMN(ny) COLUMN(nz) COLUMN(hx) COLUMN(hy) COLUMN(hz)                          \
    COLUMN(overlap) COLUMN(touching)                                                           \
    COLUMN(reduced_radius) COLUMN(reduced_mass) COLUMN(min_radius)                             \
    COLUMN(vn) COLUMN(sx) COLUMN(sy) COLUMN(sz) COLUMN(wx) COLUMN(wy) COLUMN(wz)               \
    COLUMN(viscosity) COLUMN(normal_spin)                                                      \
    COLUMN(distance) COLUMN(gap) COLUMN(distance_rate) COLUMN(is_primary)                      \
    COLUMN(bond_replaces) COLUMN(scratch) COLUMN(adhesive_force)                               \
    COLUMN(kn) COLUMN(kt) COLUMN(eta) COLUMN(fn) COLUMN(fx) COLUMN(fy) COLUMN(fz)              \
    COLUMN(mx) COLUMN(my) COLUMN(mz)                                                           \
    COLUMN(stored) COLUMN(lost) COLUMN(bonds) COLUMN(broke) COLUMN(cause)

#define DEM_ROW_MEMBER(column) double column;
#define DEM_ROW_LOAD(column) .column = b->column[c],

struct dem_contact_row
{
    double dt, max_dt;   /* s */
    double inverse_dt;   /* 1/s  1e15 in the first evaluation, where dt is 0 */
    DEM_ROW_COLUMNS(DEM_ROW_MEMBER)
};

/* 1/dt; in the first evaluation dt is 0, and a large number keeps dashpots from slipping */
static inline double dem_contact_batch_inverse_dt(const struct dem_contact_batch *b)
{
    return b->dt > 0.0 ? 1.0/b->dt : 1e15;
}

/* Row c of a batch; inverse_dt: of dem_contact_batch_inverse_dt, taken out of the loop. */
DEM_MATH struct dem_contact_row dem_contact_row_load(const struct dem_contact_batch *b, int c,
                                                     double inverse_dt)
{
    return (struct dem_contact_row){.dt = b->dt, .max_dt = b->max_dt, .inverse_dt = inverse_dt,
                                    DEM_ROW_COLUMNS(DEM_ROW_LOAD)};
}

/* ---- history ----------------------------------------------------------------------------------- */

enum
{
    DEM_LAW_HISTORY = 10    /* limit of the history columns of one law */
};

/* The history of a law at row c, and back. `columns`, a constant: their number. Written out, so
   that the loop over rows is the innermost one, which compilers vectorise. */
#define DEM_HISTORY_EACH(columns, DO)                                                          \
    do                                                                                         \
    {                                                                                          \
        if ((columns) > 0) { DO(0); }                                                          \
        if ((columns) > 1) { DO(1); }                                                          \
        if ((columns) > 2) { DO(2); }                                                          \
        if ((columns) > 3) { DO(3); }                                                          \
        if ((columns) > 4) { DO(4); }                                                          \
        if ((columns) > 5) { DO(5); }                                                          \
        if ((columns) > 6) { DO(6); }                                                          \
        if ((columns) > 7) { DO(7); }                                                          \
        if ((columns) > 8) { DO(8); }                                                          \
        if ((columns) > 9) { DO(9); }                                                          \
    } while (0)

DEM_MATH void dem_history_load(double *const *history, int columns, int c, double *values)
{
#define DEM_HISTORY_LOAD(m) values[m] = history[m][c]
    DEM_HISTORY_EACH(columns, DEM_HISTORY_LOAD);
#undef DEM_HISTORY_LOAD
}

DEM_MATH void dem_history_store(const double *values, int columns, int c, double *const *history)
{
#define DEM_HISTORY_STORE(m) history[m][c] = values[m]
    DEM_HISTORY_EACH(columns, DEM_HISTORY_STORE);
#undef DEM_HISTORY_STORE
}

/* Zero where the partners are apart. */
DEM_MATH void dem_history_clear_apart(const struct dem_contact_row *r, int columns, double *values)
{
#define DEM_HISTORY_CLEAR(m) values[m] = dem_select(r->touching > 0.0, values[m], 0.0)
    DEM_HISTORY_EACH(columns, DEM_HISTORY_CLEAR);
#undef DEM_HISTORY_CLEAR
}

/* ---- loops ----------------------------------------------------------------------------------- */

/* the rows of a batch do not depend on each other, and history columns do not overlap it */
#if defined(__clang__)
#define DEM_INDEPENDENT_ROWS _Pragma("clang loop vectorize(assume_safety)")
#else
#define DEM_INDEPENDENT_ROWS _Pragma("GCC ivdep")
#endif

/* columns that a row function sets */
enum
{
    DEM_SETS_KN = 1 << 0,
    DEM_SETS_KT = 1 << 1,
    DEM_SETS_ETA = 1 << 2,
    DEM_SETS_FN = 1 << 3,
    DEM_SETS_ADHESIVE_FORCE = 1 << 4,
    DEM_SETS_SCRATCH = 1 << 5,
    DEM_SETS_FORCE = 1 << 6,      /* fx fy fz */
    DEM_SETS_MOMENT = 1 << 7,     /* mx my mz */
    DEM_SETS_STORED = 1 << 8,
    DEM_SETS_LOST = 1 << 9,
    DEM_SETS_BONDS = 1 << 10,     /* bonds broke cause */
    DEM_SETS_REPLACED = 1 << 11   /* bond_replaces overlap touching */
};

/* Row r into row c of the batch. sets, a constant: the other columns cost nothing. */
DEM_MATH void dem_contact_row_store(const struct dem_contact_row *r, unsigned sets,
                                    struct dem_contact_batch *restrict b, int c)
{
    if (sets & DEM_SETS_KN)
    {
        b->kn[c] = r->kn;
    }
    if (sets & DEM_SETS_KT)
    {
        b->kt[c] = r->kt;
    }
    if (sets & DEM_SETS_ETA)
    {
        b->eta[c] = r->eta;
    }
    if (sets & DEM_SETS_FN)
    {
        b->fn[c] = r->fn;
    }
    if (sets & DEM_SETS_ADHESIVE_FORCE)
    {
        b->adhesive_force[c] = r->adhesive_force;
    }
    if (sets & DEM_SETS_SCRATCH)
    {
        b->scratch[c] = r->scratch;
    }
    if (sets & DEM_SETS_FORCE)
    {
        b->fx[c] = r->fx;
        b->fy[c] = r->fy;
        b->fz[c] = r->fz;
    }
    if (sets & DEM_SETS_MOMENT)
    {
        b->mx[c] = r->mx;
        b->my[c] = r->my;
        b->mz[c] = r->mz;
    }
    if (sets & DEM_SETS_STORED)
    {
        b->stored[c] = r->stored;
    }
    if (sets & DEM_SETS_LOST)
    {
        b->lost[c] = r->lost;
    }
    if (sets & DEM_SETS_BONDS)
    {
        b->bonds[c] = r->bonds;
        b->broke[c] = r->broke;
        b->cause[c] = r->cause;
    }
    if (sets & DEM_SETS_REPLACED)
    {
        b->bond_replaces[c] = r->bond_replaces;
        b->overlap[c] = r->overlap;
        b->touching[c] = r->touching;
    }
}

#define DEM_JOIN_(a, b) a##b
#define DEM_JOIN(a, b) DEM_JOIN_(a, b)

#endif
