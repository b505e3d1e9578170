/*
 * sweep_bodies.c -- evaluate the body effects batch by batch, kick velocities and spins, and sum
 * the impulses that are passed to the fluid.
 *
 * The kick. With all explicit forces F (contacts, gravity, pressure gradient, carried-over impulse)
 * and the drag b (u - v) with b and u constant over the kick h, the exact solution of m dv/dt = F +
 * b u - b v is
 *
 *     v' = v + phi(z) h/m (F + b u - b v)        z = b h/m,  phi(z) = (1 - exp(-z))/z,  phi(0) = 1
 *
 * It needs no special case for b = 0 and is bounded for any h: a strong drag brings v to u and
 * never past it. The part of the impulse that is due to drag is J = m (v' - v) - F h = h [phi (b u
 * - b v) - (1 - phi) F]. In this form it also holds for a frozen particle (1/m = 0, phi = 1), which
 * passes h b (u - v) on to the fluid. In a backward kick (particles that enter by a stream) the
 * slip grows as exp(-z). Where this factor exceeds e = 2.718, drag is left out of the kick, and the
 * next kick brings v to u.
 *
 * Added mass. The added mass a (column addedMass) is part of the inertia m in these formulas;
 * weight and momentum of the particle are without it. Forces whose reaction acts on the fluid
 * (lift, and a Du/Dt), with sum r, are part of F. The fluid receives the opposite of
 *
 *     J_other = r h - a (v' - v)
 *
 * so that J + J_other is the change of the particle's momentum by the fluid to the last digit,
 * whatever a becomes in the next window. Rotational drag is integrated on the spin in the same way
 * as b.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/sweep_bodies.h"
#include "core/math.h"
#include "step/body_batch.h"
#include "step/clump_batch.h"
#include "step/clump_energy.h"
#include "step/clump_heat.h"
#include "step/parcel_forces.h"
#include "step/sum_contacts.h"
#include <string.h>

/* ---- the kick -------------------------------------------------------------------------------- */

DEM_KERNEL
static void kick_with_drag(struct dem_body_workspace *restrict work, double h)
{
    struct dem_body_batch *const batch = &work->batch;

    for (int c = 0; c < batch->n; c++)
    {
        const double z = batch->drag[c]*h*work->inverse_mass[c], phi = dem_phi(z);
        const double step = phi*h*work->inverse_mass[c];
        const double dx = batch->drag_ux[c] - batch->drag[c]*batch->vx[c];
        const double dy = batch->drag_uy[c] - batch->drag[c]*batch->vy[c];
        const double dz = batch->drag_uz[c] - batch->drag[c]*batch->vz[c];

        batch->vx[c] += step*(batch->fx[c] + dx);
        batch->vy[c] += step*(batch->fy[c] + dy);
        batch->vz[c] += step*(batch->fz[c] + dz);
        work->drag_impulse_x[c] = h*(phi*dx - (1.0 - phi)*batch->fx[c]);
        work->drag_impulse_y[c] = h*(phi*dy - (1.0 - phi)*batch->fy[c]);
        work->drag_impulse_z[c] = h*(phi*dz - (1.0 - phi)*batch->fz[c]);
        work->decay_factor[c] = 1.0 - z*phi;
    }
}

DEM_KERNEL
static void kick_without_drag(struct dem_body_workspace *restrict work, double h)
{
    struct dem_body_batch *const batch = &work->batch;

    for (int c = 0; c < batch->n; c++)
    {
        const double step = h*work->inverse_mass[c];

        batch->vx[c] += step*batch->fx[c];
        batch->vy[c] += step*batch->fy[c];
        batch->vz[c] += step*batch->fz[c];
    }
}

/* 1/s */
static double over_window(const struct dem_body_sweep *s)
{
    return s->window > 0.0 ? 1.0/s->window : 0.0;
}

/* The kick with drag, and the impulses that are passed to the fluid. */
static void kick_in_fluid(struct dem_body_workspace *work, struct dem_particles *particles,
                          const struct dem_body_sweep *s, size_t first, int rows)
{
    const double h = s->kick;
    const int reacts = dem_column(particles, DEM_COLUMN_OTHER_IMPULSE) != NULL;

    if (reacts)
    {
        dem_body_batch_add_reacting_forces(work);
    }
    dem_body_batch_apply_slip_factor(work, particles, first, rows);
    if (h < 0.0)
    {
        dem_body_batch_limit_backward_drag(work, particles, first, rows, h);
    }
    if (s->clump_flow)
    {
        dem_clump_batch_take(s->clump_flow, work, particles, first, rows, over_window(s));
    }
    kick_with_drag(work, h);
    dem_body_batch_sum_drag(work, particles, first, rows, h);
    if (reacts)
    {
        dem_body_batch_sum_reactions(work, particles, first, rows, h);
    }
    if (dem_column(particles, DEM_COLUMN_ANGULAR_IMPULSE))
    {
        dem_body_batch_kick_spins(work, particles, first, rows, h);
    }
}

/* An effect in a scene with particle scalars; not inlined, so that scenes
   without scalars do not carry its instructions. */
__attribute__((noinline)) static void apply_with_scalars(const struct dem_effect_entry *e,
                                                         struct dem_body_batch *batch,
                                                         const struct dem_effect_list *effects,
                                                         struct dem_body_scalars *scalars)
{
    dem_body_scalars_select(scalars, batch, e);
    if (e->grains)
    {
        dem_parcels_apply(e, batch, scalars->value[effects->parcel_scalar]);
    }
    else
    {
        e->effect->apply_to_bodies(e->settings, batch);
    }
}

/* All body effects on a batch, with the energy balance if there is one. */
static void apply_effects(struct dem_body_workspace *work, const struct dem_effect_list *effects,
                          struct dem_energy_balance *energy, struct dem_body_scalars *scalars)
{
    for (int k = 0; k < effects->entries; k++)
    {
        if (energy)
        {
            dem_energy_balance_before_body_effect(energy, &work->batch);
        }
        if (scalars)
        {
            apply_with_scalars(&effects->entry[k], &work->batch, effects, scalars);
        }
        else
        {
            effects->entry[k].effect->apply_to_bodies(effects->entry[k].settings, &work->batch);
        }
        if (energy)
        {
            dem_energy_balance_after_body_effect(energy, &work->batch, k);
        }
    }
}

/* ---- forces of the scene on chosen particles ------------------------------------------------- */

struct applied    /* on the particles of a batch */
{
    double force[DEM_BATCH_ROWS][3], torque[DEM_BATCH_ROWS][3];
    double v[DEM_BATCH_ROWS][3], w[DEM_BATCH_ROWS][3];    /* m/s, 1/s  before the kick */
    int any[DEM_BATCH_ROWS];
};

/* Forces join the forces of body effects, before the kick. */
static void add_applied(struct applied *a, struct dem_body_batch *batch,
                        const struct dem_body_sweep *s, const struct dem_particles *particles,
                        size_t first, int rows)
{
    const struct dem_particle *const record = particles->record + first;

    for (int c = 0; c < rows; c++)
    {
        a->any[c] = dem_applied_forces_at(s->applied, s->domain, particles, first + (size_t)c,
                                          s->time, a->force[c], a->torque[c]);
        memcpy(a->v[c], record[c].v, sizeof a->v[c]);
        memcpy(a->w[c], record[c].w, sizeof a->w[c]);
        batch->fx[c] += a->force[c][0];
        batch->fy[c] += a->force[c][1];
        batch->fz[c] += a->force[c][2];
    }
}

/* After the kick: the spins by the torques, and the work by the mean velocities. */
static void finish_applied(const struct applied *a, const struct dem_body_sweep *s,
                           struct dem_particle *record, int rows)
{
    for (int c = 0; c < rows; c++)
    {
        struct dem_particle *const r = &record[c];
        double work = 0.0;

        for (int k = 0; k < 3 && a->any[c]; k++)
        {
            r->w[k] += a->torque[c][k]*r->inverse_inertia*s->kick;
            work += 0.5*s->kick*(a->force[c][k]*(a->v[c][k] + r->v[k]) +
                                 a->torque[c][k]*(a->w[c][k] + r->w[k]));
        }
        if (a->any[c] && s->energy_balance)
        {
            dem_energy_balance_add(&s->energy_balance->sum[DEM_ENERGY_BALANCE_APPLIED], work);
        }
    }
}

/* Contact forces of a batch: summed now, and stored unless nothing reads them, or as summed
   before. */
static void forces_of_contacts(struct dem_body_pass *pass, size_t first, int rows)
{
    const struct dem_sum_slice part = {.first = first,
                                       .end = first + (size_t)rows,
                                       .sum = pass->workspace.contacts};

    if (pass->work == DEM_BODIES_KICK)
    {
        dem_body_batch_load_forces(&pass->workspace, pass->particles, first, rows);
    }
    else
    {
        dem_sum_slice(pass->particles, pass->sweep->contacts, &part);
        if (pass->work == DEM_BODIES_SUM || !pass->unobserved)
        {
            dem_sum_store(pass->particles, &part);
        }
    }
    if (pass->sweep->clumps)
    {
        dem_clump_batch_contacts(pass->sweep->clumps, part.sum, first, rows);
    }
}

__attribute__((noinline)) static void sweep_batch(struct dem_body_pass *pass, size_t first,
                                                  int rows)
{
    struct dem_particles *const particles = pass->particles;
    struct dem_body_workspace *const work = &pass->workspace;
    const struct dem_body_sweep *const s = pass->sweep;
    const int fluid = dem_column(particles, DEM_COLUMN_FLUID_VELOCITY) != NULL;
    struct applied applied;

    forces_of_contacts(pass, first, rows);
    dem_body_batch_gather(work, particles, first, rows, pass->effects->needs);
    if (fluid)
    {
        dem_body_batch_gather_fluid(work, particles, first, rows, over_window(s));
    }
    if (s->clump_flow)
    {
        dem_clump_batch_begin(s->clump_flow, work, first, rows, (pass->effects->needs & DEM_NEEDS_FORM) != 0);
    }
    apply_effects(work, pass->effects, s->energy_balance, pass->scalars);
    if (s->applied)
    {
        add_applied(&applied, &work->batch, s, particles, first, rows);
    }
    if (fluid && pass->effects->whole_drag)
    {
        dem_body_batch_divide_by_void_fraction(work);
    }
    else if (fluid && dem_column(particles, DEM_COLUMN_OWN_WAKE))
    {
        dem_body_batch_scale_drag(work, particles, first, rows);
    }
    if (fluid)
    {
        kick_in_fluid(work, particles, s, first, rows);
    }
    else
    {
        kick_without_drag(work, s->kick);
    }
    if (s->energy_balance)
    {
        const struct dem_energy_balance_kick k = {
            .effects = pass->effects,
            .batch = &work->batch,
            .j = {work->drag_impulse_x, work->drag_impulse_y, work->drag_impulse_z},
            .first = first,
            .spin_impulse = {work->spin_impulse[0],
                             work->spin_impulse[1],
                             work->spin_impulse[2]},
            .rows = rows,
            .h = s->kick,
            .window = s->window};

        dem_energy_balance_after_kick(s->energy_balance, particles, &k);
        if (s->clump_flow && s->kick > 0.0)
        {
            dem_clump_energy_take(s->clump_flow, s->energy_balance, pass->effects, first, rows);
        }
    }
    if (pass->unobserved && s->round)
    {
        dem_body_batch_scatter_and_drift(work, particles, first, rows, s->kick, s->round,
                                         &pass->speeds);
    }
    else
    {
        dem_body_batch_scatter(work, particles, first, rows, s->kick);
    }
    if (dem_column(particles, DEM_COLUMN_ANGULAR_IMPULSE))
    {
        dem_body_batch_scatter_spins(work, particles, first, rows);
    }
    if (s->applied)
    {
        finish_applied(&applied, s, particles->record + first, rows);
    }
}

/* The same with particle scalars. Contact rows that are computed later read none of these particles, so
   their values may change. */
static void sweep_batch_with_scalars(struct dem_body_pass *pass, size_t first, int rows)
{
    const struct dem_scalar_step *const step = &pass->sweep->scalars;
    struct dem_body_scalars scalars;

    dem_body_scalars_gather(&scalars, step, pass->particles, first, rows);
    if (step->clump_heat && step->h > 0.0)
    {
        dem_clump_heat_begin(step->clump_heat, &scalars, pass->particles, first, rows);
    }
    pass->scalars = &scalars;
    sweep_batch(pass, first, rows);
    pass->scalars = NULL;
    if (step->clump_heat && step->h > 0.0)
    {
        dem_clump_heat_take(step->clump_heat, pass->sweep->clump_flow, &scalars, pass->particles, first, rows);
    }
    if (step->h > 0.0)
    {
        pass->bad_scalars +=
            dem_body_scalars_integrate(&scalars, step, pass->particles, first, rows);
    }
}

void dem_bodies_begin_pass(struct dem_body_pass *pass, struct dem_particles *particles,
                           const struct dem_effect_list *effects, const struct dem_body_sweep *s)
{
    pass->work = !s->contacts    ? DEM_BODIES_KICK
                 : s->sums_first ? DEM_BODIES_SUM
                                 : DEM_BODIES_SUM_AND_KICK;
    pass->particles = particles;
    pass->effects = effects;
    pass->sweep = s;
    pass->next = 0;
    pass->unobserved = s->unobserved;
    pass->scalars = NULL;
    pass->bad_scalars = 0;
    memset(&pass->speeds, 0, sizeof pass->speeds);
    memset(&pass->workspace, 0, sizeof pass->workspace);
    pass->workspace.batch.dt = s->kick;
}

void dem_bodies_work_until(struct dem_body_pass *pass, size_t end)
{
    void (*const work)(struct dem_body_pass *, size_t, int) =
        pass->work == DEM_BODIES_SUM      ? forces_of_contacts
        : pass->sweep->scalars.table      ? sweep_batch_with_scalars
                                          : sweep_batch;

    for (; pass->next < end; pass->next += DEM_BATCH_ROWS)
    {
        work(pass, pass->next, dem_body_batch_rows(pass->particles, pass->next));
    }
}

void dem_bodies_finish_sums(struct dem_body_pass *pass)
{
    if (pass->work == DEM_BODIES_SUM)
    {
        dem_bodies_work_until(pass, pass->particles->n);
        pass->work = DEM_BODIES_KICK;
        pass->next = 0;
    }
}

void dem_sweep_bodies(struct dem_particles *particles, const struct dem_effect_list *effects,
                      const struct dem_body_sweep *s)
{
    struct dem_body_pass pass;

    dem_bodies_begin_pass(&pass, particles, effects, s);
    dem_bodies_work_until(&pass, particles->n);
}
