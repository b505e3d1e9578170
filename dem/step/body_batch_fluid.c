/*
 * body_batch_fluid.c -- particles in a fluid, batch by batch: factors of the drag, the kick of
 * spins by rotational drag, and the impulses on the fluid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/math.h"
#include "laws/effect.h"
#include "laws/fluid/drag.h"
#include "step/body_batch.h"

/* ---- drag ------------------------------------------------------------------------------------ */

/* drag/e, with the lower limit of the void fraction that the drag laws use; lift likewise. */
DEM_KERNEL
static void divide_by_void_fraction(struct dem_body_batch *restrict batch)
{
    for (int c = 0; c < batch->n; c++)
    {
        const double over = 1.0/dem_drag_void_fraction(batch->void_fraction[c]);

        batch->drag[c] *= over;
        batch->drag_ux[c] *= over;
        batch->drag_uy[c] *= over;
        batch->drag_uz[c] *= over;
        batch->rx[c] *= over;
        batch->ry[c] *= over;
        batch->rz[c] *= over;
    }
}

void dem_body_batch_divide_by_void_fraction(struct dem_body_workspace *work)
{
    divide_by_void_fraction(&work->batch);
}

void dem_body_batch_scale_drag(struct dem_body_workspace *work,
                               const struct dem_particles *particles, size_t first, int rows)
{
    struct dem_body_batch *const batch = &work->batch;
    const double *const own =
        dem_column(particles, DEM_COLUMN_OWN_WAKE) + DEM_OWN_WAKE_WIDTH*first;

    for (int c = 0; c < rows; c++)
    {
        const double factor = 1.0 + own[DEM_OWN_WAKE_WIDTH*c + DEM_OWN_WAKE_DRAG];

        batch->drag[c] *= factor;
        batch->drag_ux[c] *= factor;
        batch->drag_uy[c] *= factor;
        batch->drag_uz[c] *= factor;
    }
}

/* Slip u - v(start) - gamma (v - v(start)): with the drag coefficient b, b becomes gamma b, and
   b u becomes b u + (gamma - 1) b v(start). */
DEM_KERNEL
static void apply_slip_factor(struct dem_body_workspace *restrict work,
                              const double *restrict slip_factor, const double *restrict start,
                              int rows)
{
    struct dem_body_batch *const batch = &work->batch;

    for (int c = 0; c < rows; c++)
    {
        const double extra = (slip_factor[c] - 1.0)*batch->drag[c];

        work->particle_drag[c] = batch->drag[c];
        batch->drag[c] += extra;
        batch->drag_ux[c] += extra*start[3*c];
        batch->drag_uy[c] += extra*start[3*c + 1];
        batch->drag_uz[c] += extra*start[3*c + 2];
    }
}

void dem_body_batch_apply_slip_factor(struct dem_body_workspace *work,
                                      const struct dem_particles *particles, size_t first, int rows)
{
    apply_slip_factor(work, dem_column(particles, DEM_COLUMN_SLIP_FACTOR) + first,
                      dem_column(particles, DEM_COLUMN_START_VELOCITY) + 3*first, rows);
}

void dem_body_batch_limit_backward_drag(struct dem_body_workspace *work,
                                        const struct dem_particles *particles,
                                        size_t first, int rows, double h)
{
    struct dem_body_batch *const batch = &work->batch;

    for (int c = 0; c < rows; c++)
    {
        const double moves = batch->drag[c]*h*work->inverse_mass[c] < -1.0 ? 0.0 : 1.0;
        const double over = particles->record[first + (size_t)c].inverse_inertia;
        const double turns = batch->spin_drag[c]*h*over < -1.0 ? 0.0 : 1.0;

        work->particle_drag[c] *= moves;
        batch->drag[c] *= moves;
        batch->drag_ux[c] *= moves;
        batch->drag_uy[c] *= moves;
        batch->drag_uz[c] *= moves;
        batch->spin_drag[c] *= turns;
        batch->spin_drag_wx[c] *= turns;
        batch->spin_drag_wy[c] *= turns;
        batch->spin_drag_wz[c] *= turns;
    }
}

DEM_KERNEL
static void sum_drag(const struct dem_body_workspace *restrict work, int rows, double h,
                     double *restrict impulse, double *restrict decay, double *restrict time)
{
    for (int c = 0; c < rows; c++)
    {
        impulse[3*c] += work->drag_impulse_x[c];
        impulse[3*c + 1] += work->drag_impulse_y[c];
        impulse[3*c + 2] += work->drag_impulse_z[c];
    }
    for (int c = 0; c < rows; c++)
    {
        decay[c] *= work->decay_factor[c];
        time[c] += work->particle_drag[c]*h;
    }
}

void dem_body_batch_sum_drag(const struct dem_body_workspace *work, struct dem_particles *particles,
                             size_t first, int rows, double h)
{
    sum_drag(work, rows, h, dem_column(particles, DEM_COLUMN_DRAG_IMPULSE) + 3*first,
             dem_column(particles, DEM_COLUMN_DECAY_FACTOR) + first,
             dem_column(particles, DEM_COLUMN_DRAG_INTEGRAL) + first);
}

/* ---- reacting forces, added mass, rotational drag -------------------------------------------- */

DEM_KERNEL
static void add_reacting(struct dem_body_batch *restrict batch)
{
    for (int c = 0; c < batch->n; c++)
    {
        batch->fx[c] += batch->rx[c];
        batch->fy[c] += batch->ry[c];
        batch->fz[c] += batch->rz[c];
    }
}

void dem_body_batch_add_reacting_forces(struct dem_body_workspace *work)
{
    add_reacting(&work->batch);
}

/* Of every change of velocity dv the added mass a takes the impulse a dv. */
void dem_body_batch_sum_reactions(const struct dem_body_workspace *work,
                                  struct dem_particles *particles, size_t first, int rows, double h)
{
    const struct dem_body_batch *const batch = &work->batch;
    double *const impulse = dem_column(particles, DEM_COLUMN_OTHER_IMPULSE) + 3*first;

    for (int c = 0; c < rows; c++)
    {
        const double *const before = particles->record[first + (size_t)c].v;

        impulse[3*c] += h*batch->rx[c] - batch->added_mass[c]*(batch->vx[c] - before[0]);
        impulse[3*c + 1] += h*batch->ry[c] - batch->added_mass[c]*(batch->vy[c] - before[1]);
        impulse[3*c + 2] += h*batch->rz[c] - batch->added_mass[c]*(batch->vz[c] - before[2]);
    }
}

/* Like the kick with drag: I dw/dt = M + t o - t w with the contact torque M and the rotational
   drag t constant over h. */
void dem_body_batch_kick_spins(struct dem_body_workspace *work,
                               const struct dem_particles *particles,
                               size_t first, int rows, double h)
{
    struct dem_body_batch *const batch = &work->batch;
    double *const spin[3] = {batch->wx, batch->wy, batch->wz};
    double *const target[3] = {batch->spin_drag_wx, batch->spin_drag_wy, batch->spin_drag_wz};

    for (int c = 0; c < rows; c++)
    {
        const double over = particles->record[first + (size_t)c].inverse_inertia;
        const double z = batch->spin_drag[c]*h*over, phi = dem_phi(z), step = phi*h*over;

        for (int k = 0; k < 3; k++)
        {
            const double M = work->contacts[c].torque[k];
            const double drag = target[k][c] - batch->spin_drag[c]*spin[k][c];

            work->spin_impulse[k][c] = h*(phi*drag - (1.0 - phi)*M);
            spin[k][c] += step*(M + drag);
        }
    }
}

void dem_body_batch_scatter_spins(const struct dem_body_workspace *work,
                                  struct dem_particles *particles, size_t first, int rows)
{
    const double *const spin[3] = {work->batch.wx, work->batch.wy, work->batch.wz};
    double *const impulse = dem_column(particles, DEM_COLUMN_ANGULAR_IMPULSE) + 3*first;

    for (int c = 0; c < rows; c++)
    {
        for (int k = 0; k < 3; k++)
        {
            particles->record[first + (size_t)c].w[k] = spin[k][c];
            impulse[3*c + k] += work->spin_impulse[k][c];
        }
    }
}
