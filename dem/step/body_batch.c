/*
 * body_batch.c -- gather a batch of particles and write it back.
 *
 * Records are transposed four at a time in registers; columns are copied as whole vectors.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/body_batch.h"
#include "laws/effect.h"
#include "laws/scalar.h"
#include "step/eddies.h"
#include "core/vec4.h"
#include <stddef.h>
#include <string.h>

static const enum dem_column_name voidage_columns[DEM_VOIDAGE_FACTORS] =
    {DEM_COLUMN_VOIDAGE_FACTOR_FIRST, DEM_COLUMN_VOIDAGE_FACTOR_SECOND};

/* Fluid quantities at the particles: a column, and its offset in the batch. The three components of
   a vector are stored one after the other. */
static const struct
{
    enum dem_column_name column;
    size_t offset;
} vectors[] =
{
    {DEM_COLUMN_FLUID_VELOCITY, offsetof(struct dem_body_batch, ux)},
    {DEM_COLUMN_PRESSURE_GRADIENT, offsetof(struct dem_body_batch, gx)},
    {DEM_COLUMN_FLUID_ACCELERATION, offsetof(struct dem_body_batch, ax)},
    {DEM_COLUMN_VORTICITY, offsetof(struct dem_body_batch, ox)},
    {DEM_COLUMN_STRESS, offsetof(struct dem_body_batch, sx)},
    {DEM_COLUMN_TENSION, offsetof(struct dem_body_batch, tension_x)},
}, scalars[] =
{
    {DEM_COLUMN_VOID_FRACTION, offsetof(struct dem_body_batch, void_fraction)},
    {DEM_COLUMN_FLUID_DENSITY, offsetof(struct dem_body_batch, density)},
    {DEM_COLUMN_INTERFACE_DISTANCE, offsetof(struct dem_body_batch, interface_distance)},
    {DEM_COLUMN_MEAN_DIAMETER, offsetof(struct dem_body_batch, mean_diameter)},
    {DEM_COLUMN_ADDED_MASS, offsetof(struct dem_body_batch, added_mass)},
};
_Static_assert(offsetof(struct dem_body_batch, uz) ==
                   offsetof(struct dem_body_batch, ux) + 2*DEM_BATCH_ROWS*sizeof(double),
               "the components of a vector are stored one after the other");

static double *column_at(struct dem_body_batch *batch, size_t offset)
{
    return (double *)(void *)((char *)batch + offset);
}

/* ---- gather ---------------------------------------------------------------------------------- */

/* Four records into the lanes from c on. */
__attribute__((always_inline)) static inline void
gather_four(struct dem_body_workspace *work, const struct dem_particle *const four[4], int c)
{
    struct dem_body_batch *const batch = &work->batch;
    dem_vec4 v[4];

    for (int k = 0; k < 4; k++)
    {
        v[k] = DEM_VEC4(four[k]->v);
        batch->radius[c + k] = four[k]->radius;
        batch->mass[c + k] = four[k]->mass;
    }
    dem_transpose4(v);
    DEM_VEC4_AT(batch->vx + c) = v[0];
    DEM_VEC4_AT(batch->vy + c) = v[1];
    DEM_VEC4_AT(batch->vz + c) = v[2];
    DEM_VEC4_AT(work->inverse_mass + c) = v[3];
}

DEM_KERNEL
static void gather_records(struct dem_body_workspace *restrict work,
                           const struct dem_particle *record, int rows)
{
    struct dem_body_batch *const batch = &work->batch;
    const int whole = rows/4*4;

    for (int c = 0; c < whole; c += 4)
    {
        gather_four(work,
                    (const struct dem_particle *const[4]){record + c, record + c + 1,
                                                          record + c + 2, record + c + 3},
                    c);
    }
    if (whole < rows)
    {
        const struct dem_particle *const from = record + whole, *const last = record + rows - 1;

        gather_four(work,
                    (const struct dem_particle *const[4]){from, from + 1 < last ? from + 1 : last,
                                                          from + 2 < last ? from + 2 : last, last},
                    whole);
    }
    for (int c = 0; c < batch->n; c++)
    {
        batch->volume[c] = dem_sphere_volume(batch->radius[c]);
        batch->drag[c] = batch->drag_ux[c] = batch->drag_uy[c] = batch->drag_uz[c] = 0.0;
    }
}

static void gather_spins(struct dem_body_batch *batch, const struct dem_particle *record, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        batch->wx[c] = record[c].w[0];
        batch->wy[c] = record[c].w[1];
        batch->wz[c] = record[c].w[2];
    }
}

/* All rows are spheres; clump_batch.c changes the rows of clumps. */
static void set_forms(struct dem_body_batch *batch)
{
    for (int c = 0; c < batch->n; c++)
    {
        batch->sphericity[c] = batch->crosswise[c] = batch->lengthwise[c] = 1.0;
    }
}

/* Split a column of vectors into three columns of components. */
DEM_KERNEL
static void split(const double *restrict from, int rows, double *restrict x, double *restrict y,
                  double *restrict z)
{
    for (int c = 0; c < rows; c++)
    {
        x[c] = from[3*c];
        y[c] = from[3*c + 1];
        z[c] = from[3*c + 2];
    }
}

/* The same, multiplied by `factor` and added. */
DEM_KERNEL
static void split_add(const double *restrict from, int rows, double factor, double *restrict x,
                      double *restrict y, double *restrict z)
{
    for (int c = 0; c < rows; c++)
    {
        x[c] += factor*from[3*c];
        y[c] += factor*from[3*c + 1];
        z[c] += factor*from[3*c + 2];
    }
}

void dem_body_batch_load_forces(struct dem_body_workspace *work,
                                const struct dem_particles *particles, size_t first, int rows)
{
    const double *const force = dem_column(particles, DEM_COLUMN_FORCE) + 3*first,
                 *const torque = dem_column(particles, DEM_COLUMN_TORQUE) + 3*first;

    for (int c = 0; c < rows; c++)
    {
        memcpy(work->contacts[c].force, force + 3*c, 3*sizeof *force);
        memcpy(work->contacts[c].torque, torque + 3*c, 3*sizeof *torque);
        work->contacts[c].torque[3] = 0.0;
    }
}

DEM_KERNEL
static void gather_forces(struct dem_body_workspace *restrict work, int rows)
{
    for (int c = 0; c < rows; c += 4)
    {
        const struct dem_contact_sum *const s = work->contacts + c;
        dem_vec4 f[4] = {DEM_VEC4(s[0].force), DEM_VEC4(s[1].force), DEM_VEC4(s[2].force),
                         DEM_VEC4(s[3].force)};

        dem_transpose4(f);
        DEM_VEC4_AT(work->batch.fx + c) = f[0];
        DEM_VEC4_AT(work->batch.fy + c) = f[1];
        DEM_VEC4_AT(work->batch.fz + c) = f[2];
    }
}

void dem_body_batch_gather(struct dem_body_workspace *work, const struct dem_particles *particles,
                           size_t first, int rows, unsigned needs)
{
    struct dem_body_batch *const batch = &work->batch;

    batch->n = (rows + 7)/8*8;
    gather_records(work, particles->record + first, rows);
    if (needs & DEM_NEEDS_SPIN)
    {
        gather_spins(batch, particles->record + first, rows);
    }
    if (needs & DEM_NEEDS_FORM)
    {
        set_forms(batch);
    }
    if (dem_column(particles, DEM_COLUMN_OTHER_IMPULSE))
    {
        memset(batch->rx, 0, 3*sizeof batch->rx);
    }
    if (dem_column(particles, DEM_COLUMN_ANGULAR_IMPULSE))
    {
        memset(batch->spin_drag, 0, 4*sizeof batch->spin_drag);
    }
    gather_forces(work, rows);
}

static void subtract_own_wake(struct dem_body_batch *batch, const double *wake, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        batch->ux[c] -= wake[DEM_OWN_WAKE_WIDTH*c];
        batch->uy[c] -= wake[DEM_OWN_WAKE_WIDTH*c + 1];
        batch->uz[c] -= wake[DEM_OWN_WAKE_WIDTH*c + 2];
    }
}

/* The fluid's velocity at a particle is the mean flow's plus the velocity of the eddy around it. */
static void add_fluctuations(struct dem_body_batch *batch, const struct dem_particles *particles,
                             size_t first, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        double u[3];

        dem_eddies_velocity(particles, first + (size_t)c, u);
        batch->ux[c] += u[0];
        batch->uy[c] += u[1];
        batch->uz[c] += u[2];
    }
}

void dem_body_batch_gather_fluid(struct dem_body_workspace *work,
                                 const struct dem_particles *particles,
                                 size_t first, int rows, double over_window)
{
    struct dem_body_batch *const batch = &work->batch;
    const size_t size = (size_t)rows*sizeof(double);

    for (size_t k = 0; k < sizeof vectors/sizeof vectors[0]; k++)
    {
        const double *const from = dem_column(particles, vectors[k].column);
        double *const to = column_at(batch, vectors[k].offset);

        if (from)
        {
            split(from + 3*first, rows, to, to + DEM_BATCH_ROWS, to + 2*DEM_BATCH_ROWS);
        }
    }
    if (dem_column(particles, DEM_COLUMN_OWN_WAKE))
    {
        subtract_own_wake(batch, dem_column(particles, DEM_COLUMN_OWN_WAKE) + DEM_OWN_WAKE_WIDTH*first, rows);
    }
    for (size_t k = 0; k < sizeof scalars/sizeof scalars[0]; k++)
    {
        const double *const from = dem_column(particles, scalars[k].column);

        if (from)
        {
            memcpy(column_at(batch, scalars[k].offset), from + first, size);
        }
    }
    for (int k = 0; k < particles->batch.n; k++)
    {
        memcpy(column_at(batch, particles->batch.at[k].to->body),
               particles->column[particles->batch.at[k].column].data + first, size);
    }
    if (dem_column(particles, DEM_COLUMN_EDDY))
    {
        add_fluctuations(batch, particles, first, rows);
    }
    split_add(dem_column(particles, DEM_COLUMN_CARRIED_OVER_IMPULSE) + 3*first, rows, over_window,
              batch->fx, batch->fy, batch->fz);
    for (int k = 0; k < DEM_VOIDAGE_FACTORS && dem_column(particles, voidage_columns[k]); k++)
    {
        memcpy(batch->voidage_factor[k], dem_column(particles, voidage_columns[k]) + first, size);
    }
}

void dem_body_batch_store_voidage_factors(const struct dem_body_workspace *work,
                                          struct dem_particles *particles, size_t first, int rows)
{
    for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++)
    {
        memcpy(dem_column(particles, voidage_columns[k]) + first, work->batch.voidage_factor[k],
               (size_t)rows*sizeof(double));
    }
}

void dem_body_batch_store_added_mass(const struct dem_body_workspace *work,
                                     struct dem_particles *particles, size_t first, int rows)
{
    double *const added = dem_column(particles, DEM_COLUMN_ADDED_MASS) + first;

    for (int c = 0; c < rows; c++)
    {
        struct dem_particle *const r = &particles->record[first + (size_t)c];

        added[c] = work->batch.added_mass[c];
        r->inverse_mass = r->inverse_mass > 0.0 ? 1.0/(r->mass + added[c]) : 0.0;
    }
}

/* ---- scatter --------------------------------------------------------------------------------- */

/* Four particles: velocities from columns into records, spins by the torques; the rows of v are those
   of the records then. */
__attribute__((always_inline)) static inline void
scatter_four(const struct dem_body_workspace *work, struct dem_particle *record, int c, int rows,
             double h, dem_vec4 v[4])
{
    dem_transpose4(v);
    for (int k = 0; k < 4 && c + k < rows; k++)
    {
        struct dem_particle *const i = &record[c + k];
        const double factor = h*i->inverse_inertia;

        DEM_VEC4_AT(i->v) = v[k];
        DEM_VEC4_AT(i->w) += factor*DEM_VEC4(work->contacts[c + k].torque);
    }
}

#define VELOCITIES(c)                                                                          \
    {DEM_VEC4(work->batch.vx + (c)), DEM_VEC4(work->batch.vy + (c)),                           \
     DEM_VEC4(work->batch.vz + (c)), DEM_VEC4(work->inverse_mass + (c))}

DEM_KERNEL
static void scatter_records(const struct dem_body_workspace *restrict work,
                            struct dem_particle *restrict record, int first, int rows, double h)
{
    for (int c = first; c < rows; c += 4)
    {
        dem_vec4 v[4] = VELOCITIES(c);

        scatter_four(work, record, c, rows, h, v);
    }
}

DEM_KERNEL
static void scatter_and_drift(const struct dem_body_workspace *restrict work,
                              struct dem_particle *restrict record, int rows, double h,
                              const double round[4], struct dem_drift_speeds *speeds)
{
    for (int c = 0; c < rows; c += 4)
    {
        dem_vec4 v[4] = VELOCITIES(c);
        const dem_vec4 square = v[0]*v[0] + v[1]*v[1] + v[2]*v[2];

        scatter_four(work, record, c, rows, h, v);
        dem_drift_four(record + c, v, h, round);
        dem_drift_count_speeds(speeds, &square);
    }
}

void dem_body_batch_scatter(const struct dem_body_workspace *work, struct dem_particles *particles,
                            size_t first, int rows, double h)
{
    scatter_records(work, particles->record + first, 0, rows, h);
}

void dem_body_batch_scatter_and_drift(const struct dem_body_workspace *work,
                                      struct dem_particles *particles,
                                      size_t first, int rows, double h, const double round[4],
                                      struct dem_drift_speeds *speeds)
{
    struct dem_particle *const record = particles->record + first;
    const int whole = rows/4*4;

    scatter_and_drift(work, record, whole, h, round, speeds);
    scatter_records(work, record, whole, rows, h);
    dem_drift_particles(record + whole, (size_t)(rows - whole), h, round, speeds);
}
