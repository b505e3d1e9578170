/*
 * batch_row.h -- a row of a batch into registers and back, for the loops over a batch.
 *
 * Columns that a law does not read cost nothing: the compiler drops the loads. Those that it does
 * not set cost nothing either: SETS is a constant.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "laws/row.h"
#include "laws/scalar.h"

#define DEM_JOIN_(a, b) a##b
#define DEM_JOIN(a, b) DEM_JOIN_(a, b)

/* the rows of a batch do not depend on each other, and history columns do not overlap it */
#if defined(__clang__)
#define DEM_INDEPENDENT_ROWS _Pragma("clang loop vectorize(assume_safety)")
#else
#define DEM_INDEPENDENT_ROWS _Pragma("GCC ivdep")
#endif

/* DO(0), DO(1), ... up to `count`, a constant. Written out, so that the loop over rows is the
   innermost one, which compilers vectorise. */
#define DEM_ROW_EACH(count, DO)                                                                \
    do                                                                                         \
    {                                                                                          \
        if ((count) > 0) { DO(0); }                                                            \
        if ((count) > 1) { DO(1); }                                                            \
        if ((count) > 2) { DO(2); }                                                            \
        if ((count) > 3) { DO(3); }                                                            \
    } while (0)
#define DEM_HISTORY_EACH(columns, DO)                                                          \
    do                                                                                         \
    {                                                                                          \
        DEM_ROW_EACH(columns, DO);                                                             \
        if ((columns) > 4) { DO(4); }                                                          \
        if ((columns) > 5) { DO(5); }                                                          \
        if ((columns) > 6) { DO(6); }                                                          \
        if ((columns) > 7) { DO(7); }                                                          \
        if ((columns) > 8) { DO(8); }                                                          \
        if ((columns) > 9) { DO(9); }                                                          \
    } while (0)

/* columns that a row function sets */
enum
{
    DEM_SETS_KN = 1 << 0,
    DEM_SETS_KT = 1 << 1,
    DEM_SETS_ETA = 1 << 2,
    DEM_SETS_FN = 1 << 3,
    DEM_SETS_ADHESIVE_FORCE = 1 << 4,
    DEM_SETS_SCRATCH = 1 << 5,
    DEM_SETS_FORCE = 1 << 6,      /* fx fy fz, of a contact or a particle */
    DEM_SETS_MOMENT = 1 << 7,     /* mx my mz */
    DEM_SETS_STORED = 1 << 8,
    DEM_SETS_LOST = 1 << 9,
    DEM_SETS_BONDS = 1 << 10,     /* bonds broke cause */
    DEM_SETS_REPLACED = 1 << 11,  /* bond_replaces */
    DEM_SETS_TOUCHING = 1 << 12,  /* overlap touching */
    DEM_SETS_REACTION = 1 << 13,  /* rx ry rz */
    DEM_SETS_DRAG = 1 << 14,      /* drag and its target */
    DEM_SETS_SPIN_DRAG = 1 << 15, /* rotational drag and its target */
    DEM_SETS_ADDED_MASS = 1 << 16,
    DEM_SETS_VOIDAGE_FACTOR = 1 << 17,
    /* of the first scalar: rates of both partners, or of the particle; exchange coefficient and its
       target */
    DEM_SETS_RATE = 1 << 18,
    DEM_SETS_EXCHANGE = 1 << 19,
    /* reads radius_i and radius_j of the first scalar (DEM_NEEDS_RADII) */
    DEM_READS_RADII = 1 << 20
};

#define DEM_ROW_LOAD(column) .column = b->column[c],
#define DEM_ROW_STORE(bit, column)                                                             \
    do                                                                                         \
    {                                                                                          \
        if (sets & (bit)) { b->column[c] = r->column; }                                        \
    } while (0)
#define DEM_ROW_STORE3(bit, x, y, z)                                                           \
    do                                                                                         \
    {                                                                                          \
        DEM_ROW_STORE(bit, x);                                                                 \
        DEM_ROW_STORE(bit, y);                                                                 \
        DEM_ROW_STORE(bit, z);                                                                 \
    } while (0)

/* ---- contacts ---------------------------------------------------------------------------------- */

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
                                    .time = b->time, .previous_time = b->previous_time,
                                    DEM_ROW_COLUMNS(DEM_ROW_LOAD)};
}

/* The first `count` scalars of the law at row c. */
DEM_MATH void dem_contact_row_load_scalars(struct dem_contact_row *r, int count, unsigned sets,
                                           const struct dem_contact_batch *b, int c)
{
#define DEM_SCALAR_LOAD(k) r->scalars[k].i = b->scalars[k].i[c], r->scalars[k].j = b->scalars[k].j[c]
    DEM_ROW_EACH(count, DEM_SCALAR_LOAD);
#undef DEM_SCALAR_LOAD
    if (sets & DEM_SETS_RATE)
    {
        r->scalars[0].rate_i = b->scalars[0].rate_i[c];
        r->scalars[0].rate_j = b->scalars[0].rate_j[c];
    }
    if (sets & DEM_READS_RADII)
    {
        r->scalars[0].radius_i = b->scalars[0].radius_i[c];
        r->scalars[0].radius_j = b->scalars[0].radius_j[c];
    }
}

/* Row r into row c of the batch. */
DEM_MATH void dem_contact_row_store(const struct dem_contact_row *r, unsigned sets,
                                    struct dem_contact_batch *restrict b, int c)
{
    DEM_ROW_STORE(DEM_SETS_KN, kn);
    DEM_ROW_STORE(DEM_SETS_KT, kt);
    DEM_ROW_STORE(DEM_SETS_ETA, eta);
    DEM_ROW_STORE(DEM_SETS_FN, fn);
    DEM_ROW_STORE(DEM_SETS_ADHESIVE_FORCE, adhesive_force);
    DEM_ROW_STORE(DEM_SETS_SCRATCH, scratch);
    DEM_ROW_STORE3(DEM_SETS_FORCE, fx, fy, fz);
    DEM_ROW_STORE3(DEM_SETS_MOMENT, mx, my, mz);
    DEM_ROW_STORE(DEM_SETS_STORED, stored);
    DEM_ROW_STORE(DEM_SETS_LOST, lost);
    DEM_ROW_STORE3(DEM_SETS_BONDS, bonds, broke, cause);
    DEM_ROW_STORE(DEM_SETS_REPLACED, bond_replaces);
    DEM_ROW_STORE(DEM_SETS_TOUCHING, overlap);
    DEM_ROW_STORE(DEM_SETS_TOUCHING, touching);
    if (sets & DEM_SETS_RATE)
    {
        b->scalars[0].rate_i[c] = r->scalars[0].rate_i;
        b->scalars[0].rate_j[c] = r->scalars[0].rate_j;
    }
}

/* The history of a law at row c, and back. `columns`, a constant: their number. */
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

/* ---- particles --------------------------------------------------------------------------------- */

/* Row c of a batch with the first `count` scalars of the law. */
DEM_MATH struct dem_body_row dem_body_row_load(const struct dem_body_batch *b, int count,
                                               unsigned sets, int c)
{
    struct dem_body_row r = {
        DEM_BODY_COLUMNS(DEM_ROW_LOAD)
        .voidage_factor = {b->voidage_factor[0][c], b->voidage_factor[1][c]}};

#define DEM_SCALAR_LOAD(k) r.scalars[k].value = b->scalars[k].value[c]
    DEM_ROW_EACH(count, DEM_SCALAR_LOAD);
#undef DEM_SCALAR_LOAD
    if (sets & DEM_SETS_RATE)
    {
        r.scalars[0].rate = b->scalars[0].rate[c];
    }
    if (sets & DEM_SETS_EXCHANGE)
    {
        r.scalars[0].coefficient = b->scalars[0].coefficient[c];
        r.scalars[0].to_target = b->scalars[0].to_target[c];
    }
    return r;
}

/* Row r into row c of the batch. */
DEM_MATH void dem_body_row_store(const struct dem_body_row *r, unsigned sets,
                                 struct dem_body_batch *restrict b, int c)
{
    DEM_ROW_STORE3(DEM_SETS_FORCE, fx, fy, fz);
    DEM_ROW_STORE3(DEM_SETS_REACTION, rx, ry, rz);
    DEM_ROW_STORE(DEM_SETS_DRAG, drag);
    DEM_ROW_STORE3(DEM_SETS_DRAG, drag_ux, drag_uy, drag_uz);
    DEM_ROW_STORE(DEM_SETS_SPIN_DRAG, spin_drag);
    DEM_ROW_STORE3(DEM_SETS_SPIN_DRAG, spin_drag_wx, spin_drag_wy, spin_drag_wz);
    DEM_ROW_STORE(DEM_SETS_ADDED_MASS, added_mass);
    if (sets & DEM_SETS_VOIDAGE_FACTOR)
    {
        b->voidage_factor[0][c] = r->voidage_factor[0];
        b->voidage_factor[1][c] = r->voidage_factor[1];
    }
    if (sets & DEM_SETS_RATE)
    {
        b->scalars[0].rate[c] = r->scalars[0].rate;
    }
    if (sets & DEM_SETS_EXCHANGE)
    {
        b->scalars[0].coefficient[c] = r->scalars[0].coefficient;
        b->scalars[0].to_target[c] = r->scalars[0].to_target;
    }
}
