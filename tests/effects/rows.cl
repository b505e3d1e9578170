/*
 * rows.cl -- kernels that call the row functions of laws.
 *
 * test_device.c adds the headers of the laws to this text, and a line CONTACT_LAW or
 * BODY_LAW for each row function.
 *
 * A row is its columns in the order of laws/row.h, then history or voidage factors, then scalars.
 * BATCH rows share settings and times.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/row.h"

struct none    /* in the place of the settings of a law that has none */
{
    double unused;
};

#define ROW_GET(column) r.column = *in++;
#define ROW_PUT(column) *out++ = r.column;

#define CONTACT_LAW(law, function, SETTINGS)                                                   \
    kernel void law##_##function##_kernel(global const double *in,                             \
                                          global const SETTINGS *settings,                     \
                                          global const double *times, global double *out)      \
    {                                                                                          \
        const size_t i = get_global_id(0);                                                     \
        SETTINGS l = settings[i/BATCH];                                                        \
        struct dem_contact_row r;                                                              \
        double h[DEM_LAW_HISTORY];                                                             \
                                                                                               \
        in += i*CONTACT_NUMBERS, out += i*CONTACT_NUMBERS, times += i/BATCH*5;                 \
        r.dt = times[0], r.max_dt = times[1], r.inverse_dt = times[2];                         \
        r.time = times[3], r.previous_time = times[4];                                         \
        DEM_ROW_COLUMNS(ROW_GET)                                                               \
        for (int k = 0; k < DEM_LAW_HISTORY; k++) h[k] = *in++;                                \
        r.scalars[0].i = in[0], r.scalars[0].j = in[1];                                        \
        r.scalars[0].rate_i = in[2], r.scalars[0].rate_j = in[3];                              \
        r.scalars[0].radius_i = in[4], r.scalars[0].radius_j = in[5];                          \
        law##_##function(&l, &r, h);                                                           \
        DEM_ROW_COLUMNS(ROW_PUT)                                                               \
        for (int k = 0; k < DEM_LAW_HISTORY; k++) *out++ = h[k];                               \
        out[0] = r.scalars[0].i, out[1] = r.scalars[0].j;                                      \
        out[2] = r.scalars[0].rate_i, out[3] = r.scalars[0].rate_j;                            \
        out[4] = r.scalars[0].radius_i, out[5] = r.scalars[0].radius_j;                        \
    }

#define BODY_LAW(law, function, SETTINGS)                                                      \
    kernel void law##_##function##_kernel(global const double *in,                             \
                                          global const SETTINGS *settings,                     \
                                          global const double *times, global double *out)      \
    {                                                                                          \
        const size_t i = get_global_id(0);                                                     \
        SETTINGS l = settings[i/BATCH];                                                        \
        struct dem_body_row r;                                                                 \
                                                                                               \
        in += i*BODY_NUMBERS, out += i*BODY_NUMBERS;                                           \
        DEM_BODY_COLUMNS(ROW_GET)                                                              \
        for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++) r.voidage_factor[k] = *in++;             \
        for (int k = 0; k < DEM_EFFECT_SCALARS; k++) r.scalars[k].value = *in++;               \
        r.scalars[0].rate = in[0], r.scalars[0].coefficient = in[1];                           \
        r.scalars[0].to_target = in[2];                                                        \
        law##_##function(&l, &r);                                                              \
        DEM_BODY_COLUMNS(ROW_PUT)                                                              \
        for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++) *out++ = r.voidage_factor[k];            \
        for (int k = 0; k < DEM_EFFECT_SCALARS; k++) *out++ = r.scalars[k].value;              \
        out[0] = r.scalars[0].rate, out[1] = r.scalars[0].coefficient;                         \
        out[2] = r.scalars[0].to_target;                                                       \
    }
