/*
 * row.h -- one contact, or one particle, in registers: what the row function of a law works on.
 *
 * The arithmetic of a law is written once, on one row: dem_<law>_row(settings, row, history) of a
 * contact, dem_<law>_row(settings, row) of a particle. The templates contact_loop.h and body_loop.h
 * make the law's own loop of it; laws/fused puts the rows of several laws into one loop; a device
 * compiles it as OpenCL C (core/device.h). batch.h says what each member is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_ROW_H
#define DEM_LAWS_ROW_H

#include "core/math.h"

enum
{
    DEM_EFFECT_SCALARS = 4,    /* limit of the particle scalars of a law */
    DEM_LAW_HISTORY = 10,      /* limit of the history columns of a law */
    /* columns in which a drag law keeps its voidage factors */
    DEM_VOIDAGE_FACTORS = 2
};

/* the columns of struct dem_contact_batch that laws work on, under the same names */
#define DEM_ROW_COLUMNS(COLUMN)                                                                \
    COLUMN(nx) COLUMN(ny) COLUMN(nz) COLUMN(hx) COLUMN(hy) COLUMN(hz)                          \
    COLUMN(overlap) COLUMN(touching)                                                           \
    COLUMN(reduced_radius) COLUMN(reduced_mass) COLUMN(min_radius)                             \
    COLUMN(vn) COLUMN(sx) COLUMN(sy) COLUMN(sz) COLUMN(wx) COLUMN(wy) COLUMN(wz)               \
    COLUMN(viscosity) COLUMN(normal_spin)                                                      \
    COLUMN(distance) COLUMN(gap) COLUMN(distance_rate) COLUMN(is_primary) COLUMN(pair_random)  \
    COLUMN(bond_replaces) COLUMN(scratch) COLUMN(adhesive_force)                               \
    COLUMN(kn) COLUMN(kt) COLUMN(eta) COLUMN(fn) COLUMN(fx) COLUMN(fy) COLUMN(fz)              \
    COLUMN(mx) COLUMN(my) COLUMN(mz)                                                           \
    COLUMN(stored) COLUMN(lost) COLUMN(bonds) COLUMN(broke) COLUMN(cause) COLUMN(dissipated)

/* the columns of struct dem_body_batch, likewise */
#define DEM_BODY_COLUMNS(COLUMN)                                                               \
    COLUMN(radius) COLUMN(mass) COLUMN(volume)                                                 \
    COLUMN(sphericity) COLUMN(crosswise) COLUMN(lengthwise)                                    \
    COLUMN(vx) COLUMN(vy) COLUMN(vz) COLUMN(wx) COLUMN(wy) COLUMN(wz)                          \
    COLUMN(ux) COLUMN(uy) COLUMN(uz) COLUMN(gx) COLUMN(gy) COLUMN(gz)                          \
    COLUMN(void_fraction) COLUMN(density) COLUMN(viscosity)                                    \
    COLUMN(ax) COLUMN(ay) COLUMN(az) COLUMN(ox) COLUMN(oy) COLUMN(oz)                          \
    COLUMN(sx) COLUMN(sy) COLUMN(sz) COLUMN(mean_diameter) COLUMN(added_mass)                  \
    COLUMN(tension_x) COLUMN(tension_y) COLUMN(tension_z) COLUMN(interface_distance)           \
    COLUMN(fx) COLUMN(fy) COLUMN(fz) COLUMN(rx) COLUMN(ry) COLUMN(rz)                          \
    COLUMN(drag) COLUMN(drag_ux) COLUMN(drag_uy) COLUMN(drag_uz)                               \
    COLUMN(spin_drag) COLUMN(spin_drag_wx) COLUMN(spin_drag_wy) COLUMN(spin_drag_wz)

#define DEM_ROW_MEMBER(column) double column;

/* a particle scalar of the law at a contact: struct dem_scalar_rows of scalar.h */
struct dem_contact_scalar
{
    double i, j, rate_i, rate_j, radius_i, radius_j;
};

/* a particle scalar of the law at a particle: struct dem_scalar_bodies */
struct dem_body_scalar
{
    double value, rate, coefficient, to_target;
};

struct dem_contact_row
{
    double dt, max_dt;            /* s */
    double inverse_dt;            /* 1/s  1e15 in the first evaluation, where dt is 0 */
    double time, previous_time;   /* s */
    DEM_ROW_COLUMNS(DEM_ROW_MEMBER)
    /* in the order of the law's list */
    struct dem_contact_scalar scalars[DEM_EFFECT_SCALARS];
};

struct dem_body_row
{
    DEM_BODY_COLUMNS(DEM_ROW_MEMBER)
    double voidage_factor[DEM_VOIDAGE_FACTORS];
    /* in the order of the law's list */
    struct dem_body_scalar scalars[DEM_EFFECT_SCALARS];
};

#endif
