/*
 * test.cl -- template: the kernel by which self_test.c has the laws of one pair class applied to given
 * rows. It is included once for each class; rows.cl describes its macros.
 *
 * A row is its columns in the order of laws/row.h, then its history.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_TEST_GET
#define DEM_TEST_GET(column) r.column = *in++;
#define DEM_TEST_PUT(column) *out++ = r.column;
#if BALANCE
#define WITHOUT_BALANCE , 0
#else
#define WITHOUT_BALANCE
#endif
#endif

kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void TEST(uint rows, uint numbers, global const double *in, global const double *times,
          global double *out)
{
    const uint row = get_global_id(0);
    double h[COLUMNS + 1];
    struct dem_contact_row r;

    if (row >= rows)
    {
        return;
    }
    r.dt = times[0];
    r.max_dt = times[1];
    r.inverse_dt = times[2];
    r.time = times[3];
    r.previous_time = times[4];
    in += (size_t)row*numbers;
    out += (size_t)row*numbers;
    DEM_ROW_COLUMNS(DEM_TEST_GET)
    for (int m = 0; m < COLUMNS; m++)
    {
        h[m] = *in++;
    }
#if SCALARS
    struct dem_row_scalars q;
    const double cube = r.min_radius*r.min_radius*r.min_radius;

    q.radius[0] = q.radius[1] = r.min_radius;
    for (int k = 0; k < SCALARS; k++)
    {
        q.value[0][k] = 0.01*cube;
        q.value[1][k] = 0.02*cube;
        q.rate[0][k] = q.rate[1][k] = 0.0;
    }
    LAWS(&r, h, &q WITHOUT_BALANCE);
#else
    LAWS(&r, h WITHOUT_BALANCE);
#endif
    DEM_ROW_COLUMNS(DEM_TEST_PUT)
    for (int m = 0; m < COLUMNS; m++)
    {
        *out++ = h[m];
    }
}

#undef TEST
