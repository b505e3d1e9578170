/*
 * row.h -- one row of the contact batch in registers, and the loop of a law over a batch.
 *
 * The arithmetic of a contact law is written once, on one row: dem_<law>_row(settings, row,
 * history). DEM_CONTACT_LOOP makes the law's own loop of it; laws/fused puts the rows of several
 * laws into one loop. Columns that a law does not read cost nothing: the compiler drops the loads.
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

/* ---- the loop of a law ------------------------------------------------------------------------- */

/* the rows of a batch do not depend on each other, and history columns do not overlap it */
#if defined(__clang__)
#define DEM_INDEPENDENT_ROWS _Pragma("clang loop vectorize(assume_safety)")
#else
#define DEM_INDEPENDENT_ROWS _Pragma("GCC ivdep")
#endif

/* b->x[c] = r.x for each of up to ten columns */
#define DEM_STORE_1(x) b->x[c] = r.x;
#define DEM_STORE_2(x, ...) DEM_STORE_1(x) DEM_STORE_1(__VA_ARGS__)
#define DEM_STORE_3(x, ...) DEM_STORE_1(x) DEM_STORE_2(__VA_ARGS__)
#define DEM_STORE_4(x, ...) DEM_STORE_1(x) DEM_STORE_3(__VA_ARGS__)
#define DEM_STORE_5(x, ...) DEM_STORE_1(x) DEM_STORE_4(__VA_ARGS__)
#define DEM_STORE_6(x, ...) DEM_STORE_1(x) DEM_STORE_5(__VA_ARGS__)
#define DEM_STORE_7(x, ...) DEM_STORE_1(x) DEM_STORE_6(__VA_ARGS__)
#define DEM_STORE_8(x, ...) DEM_STORE_1(x) DEM_STORE_7(__VA_ARGS__)
#define DEM_STORE_9(x, ...) DEM_STORE_1(x) DEM_STORE_8(__VA_ARGS__)
#define DEM_STORE_10(x, ...) DEM_STORE_1(x) DEM_STORE_9(__VA_ARGS__)
#define DEM_STORE_11(x, ...) DEM_STORE_1(x) DEM_STORE_10(__VA_ARGS__)
#define DEM_STORE_12(x, ...) DEM_STORE_1(x) DEM_STORE_11(__VA_ARGS__)
#define DEM_STORE_CHOICE(_1, _2, _3, _4, _5, _6, _7, _8, _9, _10, _11, _12, choice, ...) choice
#define DEM_STORE(...)                                                                         \
    DEM_STORE_CHOICE(__VA_ARGS__, DEM_STORE_12, DEM_STORE_11, DEM_STORE_10, DEM_STORE_9,       \
                     DEM_STORE_8, DEM_STORE_7, DEM_STORE_6, DEM_STORE_5, DEM_STORE_4,          \
                     DEM_STORE_3, DEM_STORE_2, DEM_STORE_1, )(__VA_ARGS__)

#define DEM_NOTHING_BEFORE(settings, batch) (void)0

/*
 * Define the function `loop` of an effect, e.g. `apply`, from the row function of its law:
 *
 *   DEM_CONTACT_LOOP(apply, dem_hertz, dem_hertz_row, 0, kn, fn)
 *
 * law: tag of the settings struct; columns: number of history columns; then the columns of the batch
 * that the row function sets. The settings are copied, so that they stay in registers.
 */
#define DEM_CONTACT_LOOP(loop, law, row, columns, ...)                                         \
    DEM_CONTACT_LOOP_AFTER(DEM_NOTHING_BEFORE, loop, law, row, columns, __VA_ARGS__)

/* The same, after before(settings, batch): what a law computes of the whole batch first. */
#define DEM_CONTACT_LOOP_AFTER(before, loop, law, row, columns, ...)                           \
    DEM_KERNEL                                                                                 \
    static void loop(const void *of, struct dem_contact_batch *restrict b,                     \
                     double *const *history)                                                   \
    {                                                                                          \
        const struct law settings_of_class = *(const struct law *)of;                          \
        const double inverse_dt = dem_contact_batch_inverse_dt(b);                             \
                                                                                               \
        (void)history;                                                                         \
        before(&settings_of_class, b);                                                         \
        DEM_INDEPENDENT_ROWS                                                                   \
        for (int c = 0; c < b->n; c++)                                                         \
        {                                                                                      \
            struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);                 \
            double values[DEM_LAW_HISTORY];                                                    \
                                                                                               \
            dem_history_load(history, columns, c, values);                                     \
            row(&settings_of_class, &r, values);                                               \
            dem_history_store(values, columns, c, history);                                    \
            DEM_STORE(__VA_ARGS__)                                                             \
        }                                                                                      \
    }

#endif
