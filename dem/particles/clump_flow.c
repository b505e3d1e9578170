/*
 * clump_flow.c -- moves rigid bodies of several spheres in a fluid (formulas: clump_flow.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump_flow.h"
#include "core/error.h"
#include "core/math.h"
#include "core/memory.h"
#include "core/vec.h"
#include <math.h>

int dem_clump_flow_begin(struct dem_clump_flow *f, const struct dem_clump_shapes *shapes, int areas)
{
    f->shapes = shapes;
    DEM_TRY(DEM_NEW(f->form, shapes->n));
    for (size_t k = 0; k < shapes->n; k++)
    {
        dem_clump_form_make(&f->form[k], &shapes->shape[k], areas);
    }
    return DEM_OK;
}

void dem_clump_flow_free(struct dem_clump_flow *f)
{
    dem_memory_free(f->form);
    dem_memory_free(f->row);
    dem_memory_free(f->own);
    dem_memory_free(f->before);
    *f = (struct dem_clump_flow){.form = NULL};
}

int dem_clump_flow_reserve(struct dem_clump_flow *f, size_t n)
{
    return DEM_GROW(f->row, f->capacity, n + 1);
}

/* ---- shapes ---------------------------------------------------------------------------------- */

/* Several shapes may have the same volume: they differ in inertia or in the place of a sphere. */
const struct dem_clump_form *dem_clump_flow_form(const struct dem_clump_flow *f,
                                                 const struct dem_particles *p, size_t i)
{
    const struct dem_clump *const b = dem_clump_at(p, i);
    const size_t k = (size_t)(p->record[i].id - (p->record[i].body - 1));
    size_t nearest = 0;
    double least = INFINITY;

    for (size_t s = 0; s < f->shapes->n && f->shapes->n > 1; s++)
    {
        const struct dem_clump_shape *const shape = &f->shapes->shape[s];
        double off = k < shape->n ? 0.0 : INFINITY;

        for (size_t a = 0; k < shape->n && a < 3; a++)
        {
            off += fabs(b->inertia[a]/b->mass - shape->inertia[a]/shape->volume) +
                   fabs(b->offset[a] - shape->offset[k][a])*shape->bound;
        }
        nearest = off < least ? s : nearest;
        least = fmin(off, least);
    }
    return &f->form[nearest];
}

/* ---- motion ---------------------------------------------------------------------------------- */

void dem_clump_flow_sum(const struct dem_clump_flow *f, const struct dem_clumps *c, size_t body,
                        const struct dem_particles *p, double h, struct dem_clump_flow_sums *s)
{
    const struct dem_clump *const b = dem_clump_at(p, c->member[c->start[body]]);
    const double least = fmin(b->inertia[0], fmin(b->inertia[1], b->inertia[2]));

    *s = (struct dem_clump_flow_sums){.drag = 0.0};
    dem_clump_contact_sums(c, body, p, s->force, s->torque);
    for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
    {
        const size_t i = c->member[k];
        const struct dem_clump_flow_row *const r = &f->row[i];
        const double *const arm = c->arm[k];
        double moment[3], all[3];

        for (int a = 0; a < 3; a++)
        {
            s->force[a] += r->force[a];
            s->slip_force[a] += r->slip_force[a];
            all[a] = r->force[a] + r->slip_force[a];
        }
        dem_vec_cross(arm, all, moment);
        for (int a = 0; a < 3; a++)
        {
            s->torque[a] += moment[a] + r->spin_torque[a];
        }
        s->drag += r->drag;
        s->spin_drag += r->drag*dem_vec_dot(arm, arm) + r->spin_drag;
    }
    s->moves = !dem_clumps_frozen(c, body, p);
    s->z = s->moves ? s->drag*h/b->mass : 0.0;
    s->phi = dem_phi(s->z);
    s->phi_spin = s->moves ? dem_phi(s->spin_drag*h/least) : 1.0;
}

void dem_clump_flow_drag(const struct dem_clump_flow_row *r, const struct dem_clump_flow_sums *s, double h,
                         double J[3])
{
    const double part = s->drag > 0.0 ? r->drag/s->drag : 0.0;

    for (int a = 0; a < 3; a++)
    {
        J[a] = h*(s->phi*r->slip_force[a] - (1.0 - s->phi)*part*s->force[a]);
    }
}

/* What a sphere of the body adds to the columns that the fluid reads. */
static void add_impulses(const struct dem_clump_flow_row *r, const struct dem_clump_flow_sums *s,
                         struct dem_particles *p, size_t i, double h)
{
    double *const other = dem_column(p, DEM_COLUMN_OTHER_IMPULSE),
           *const angular = dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE);
    double J[3];

    dem_clump_flow_drag(r, s, h, J);
    for (size_t a = 0; a < 3; a++)
    {
        dem_column(p, DEM_COLUMN_DRAG_IMPULSE)[3*i + a] += J[a];
        if (other)
        {
            other[3*i + a] += h*r->reaction[a];
        }
        if (angular)
        {
            angular[3*i + a] += h*s->phi_spin*r->spin_torque[a];
        }
    }
    dem_column(p, DEM_COLUMN_DECAY_FACTOR)[i] *= 1.0 - s->z*s->phi;
    dem_column(p, DEM_COLUMN_DRAG_TIME)[i] += r->particle_drag*h;
}

void dem_clump_flow_kick(const struct dem_clump_flow *f, const struct dem_clumps *c,
                         struct dem_particles *p, double h)
{
    for (size_t body = 0; body < c->n; body++)
    {
        struct dem_clump *const b = dem_clump_at(p, c->member[c->start[body]]);
        struct dem_clump_flow_sums s;

        dem_clump_flow_sum(f, c, body, p, h, &s);
        for (int a = 0; a < 3 && s.moves; a++)
        {
            b->v[a] += s.phi*h/b->mass*(s.force[a] + s.slip_force[a]);
            b->momentum[a] += h*s.phi_spin*s.torque[a];
        }
        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            add_impulses(&f->row[c->member[k]], &s, p, c->member[k], h);
        }
        dem_clump_spread(c, body, p);
    }
}

void dem_clump_share_decay(const struct dem_clumps *c, const struct dem_particles *p, const double *time,
                           double *decay, int per_mass)
{
    for (size_t body = 0; body < c->n; body++)
    {
        double sum = 0.0;

        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            sum += time[c->member[k]];
        }
        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            const size_t i = c->member[k];
            const double masses = per_mass ? dem_clump_at(p, i)->mass/p->record[i].mass : 1.0;

            decay[i] = sum > 0.0 ? 1.0 - masses*time[i]/sum*(1.0 - decay[i]) : 1.0;
        }
    }
}

void dem_clump_flow_end_window(const struct dem_clumps *c, struct dem_particles *p)
{
    double *const decay = dem_column(p, DEM_COLUMN_DECAY_FACTOR);

    if (decay)
    {
        dem_clump_share_decay(c, p, dem_column(p, DEM_COLUMN_DRAG_TIME), decay, 0);
    }
}
