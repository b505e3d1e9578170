/*
 * rows.cl -- template: the kernel that computes the contact rows of one pair class. It is included
 * once for each class, after
 *
 *   KERNEL, LAWS     name of the kernel; of the function that applies the laws to a row
 *   COLUMNS          history columns of the laws, whose places are in COLUMN_OF
 *   WITH_WALL, PAST_TOUCHING, RANDOM, VISCOSITY, CLASS_SCALARS    1 or 0, as the host's effect list
 *   MOMENTS, ENERGY, SURFACE, FACETS    1 or 0, of all classes: there are moments; energies; walls that
 *                               are curved or move; contacts of facets.cl
 *   BALANCE, HEATS              1 or 0: there is an energy balance; laws make heat of what is lost
 *
 * The arithmetic is the host's (step/fill_batch.c, step/store_forces.c): the same operations in the
 * same order. A row that does not touch leaves no force; touch[row] says so to the sums, and that the
 * history is zero.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
kernel __attribute__((reqd_work_group_size(DEM_DEVICE_GROUP, 1, 1)))
void KERNEL(constant struct dem_device_batch *b, global struct dem_device_report *report, uint s,
            uint first, uint count, global const double4 *restrict record,
            global const uint2 *restrict partners, global const double4 *restrict shift,
            global const struct dem_facet *restrict facets, global uchar *restrict touch,
            global double *restrict history, global double4 *restrict force,
            global double4 *restrict moment, global double4 *restrict energy,
            global const struct dem_device_frame *restrict frames,
            global const double *restrict columns,
            global const struct dem_wall_drive *restrict drives,
            global const double4 *restrict contacts,
            global const struct dem_device_condition *restrict conditions,
            global double *restrict rates, global long *sums)
{
    const uint k = get_global_id(0), row = first + k;
    double h[COLUMNS + 1];
    struct dem_gathered g;
    struct dem_contact_row r;

    if (dem_used_up(b, report, s) || k >= count)
    {
        return;
    }
    const uint before = touch[row];
    const int was = PAST_TOUCHING || before & DEM_DEVICE_TOUCHES;

    dem_row_begin(b, s, &r);
#if WITH_WALL
    dem_row_of_wall(record + 4*(size_t)partners[row].x,
                    FACETS ? contacts + 2*(size_t)(row - b->walls) : 0, facets + partners[row].y,
                    frames + s*b->frames, drives, RANDOM, SURFACE, &g, &r);
#else
    dem_row_of_pair(record, partners[row], shift, RANDOM, CLASS_SCALARS, &g, &r);
#endif
#if VISCOSITY
    global const double *const viscosity = columns + (size_t)COLUMN_VISCOSITY*b->column;
    const double of_i = viscosity[partners[row].x];

    r.viscosity = WITH_WALL ? of_i : 0.5*(of_i + viscosity[partners[row].y & ((1u << 27) - 1)]);
#endif
#if PAST_TOUCHING
    dem_row_add_gap(&g, &r);
#else
    if (r.touching == 0.0 && !(BALANCE && was))
    {
        if (before)
        {
            touch[row] = 0;
        }
        return;
    }
#endif
#define LOAD_COLUMN(m, column) h[m] = was ? history[(size_t)(column)*b->stride + row] : 0.0;
    COLUMN_OF(LOAD_COLUMN)
#if BALANCE
    /* the owner of the first partner, with the lower id, counts a pair */
    struct dem_row_balance e = {
        .to = {b, report, partners[row].x < b->particles ? sums : 0, s}};

    dem_balance_gather(record, partners[row], WITH_WALL, &g, &e);
#define WITH_BALANCE , &e
#else
#define WITH_BALANCE
#endif
#if SCALARS
    struct dem_row_scalars q;

#if WITH_WALL
    dem_row_scalars_begin(columns, b->column, partners[row].x, 0,
                          conditions + (size_t)(facets[partners[row].y].largest >> 2)*SCALARS, &r, &q);
#else
    dem_row_scalars_begin(columns, b->column, partners[row].x,
                          partners[row].y & ((1u << 27) - 1), 0, &r, &q);
#endif
    q.radius[0] = record[4*(size_t)partners[row].x].w;
    q.radius[1] = WITH_WALL ? q.radius[0]
                            : record[4*(size_t)(partners[row].y & ((1u << 27) - 1))].w;
    LAWS(&r, h, &q WITH_BALANCE);
#ifdef ENERGY_HEATED
    dem_balance_heat(&e, &r, HEATS, WITH_WALL, q.rate[0][dem_scalar_heat]);
#endif
    if (RATES)
    {
        dem_row_scalars_end(rates, row, &q);
    }
#else
    LAWS(&r, h WITH_BALANCE);
#endif
#if BALANCE && !PAST_TOUCHING
    if (r.touching == 0.0)
    {
        touch[row] = SCALARS && RATES ? DEM_DEVICE_RATED : 0;
        return;
    }
#endif
    if (!was)
    {
        touch[row] = DEM_DEVICE_TOUCHES;
    }
#define STORE_COLUMN(m, column) history[(size_t)(column)*b->stride + row] = h[m];
    COLUMN_OF(STORE_COLUMN)
    dem_row_check(b, report, s, WITH_WALL, &r, facets + (WITH_WALL ? partners[row].y : 0));

    const double factor = WITH_WALL ? 1.0 : 0.5,
                 arm = PAST_TOUCHING ? -factor*r.gap : factor*r.overlap;

    force[2*(size_t)row] = (double4)(r.fn*r.nx + r.fx, r.fn*r.ny + r.fy, r.fn*r.nz + r.fz, arm);
    force[2*(size_t)row + 1] = (double4)(r.ny*r.fz - r.nz*r.fy, r.nz*r.fx - r.nx*r.fz,
                                         r.nx*r.fy - r.ny*r.fx, 0.0);
#if MOMENTS
    moment[row] = (double4)(r.mx, r.my, r.mz, 0.0);
#endif
#if ENERGY
    energy[row] = (double4)(r.stored, r.lost, r.bonds, r.broke);
#endif
}

#undef KERNEL
#undef LAWS
#undef COLUMNS
#undef COLUMN_OF
#undef LOAD_COLUMN
#undef STORE_COLUMN
#undef WITH_WALL
#undef PAST_TOUCHING
#undef MOMENTS
#undef ENERGY
#undef RANDOM
#undef SURFACE
#undef VISCOSITY
#undef CLASS_SCALARS
#undef HEATS
#undef WITH_BALANCE
