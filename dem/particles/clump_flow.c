/*
 * clump_flow.c -- moves rigid bodies of several spheres in a fluid, several at a time (formulas: clump_flow.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/clump_flow.h"
#include "core/error.h"
#include "core/math.h"
#include "core/memory.h"
#include "laws/effect.h"
#include "particles/clump_lanes.h"
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
    dem_memory_free(f->rest);
    dem_memory_free(f->part);
    dem_memory_free(f->sums);
    dem_memory_free(f->own);
    dem_memory_free(f->before);
    *f = (struct dem_clump_flow){.form = NULL};
}

/* ---- shapes ---------------------------------------------------------------------------------- */

/* Several shapes may have the same volume: they differ in inertia or in the place of a sphere. */
static const struct dem_clump_form *form_of(const struct dem_clump_flow *f, const struct dem_particles *p, size_t i)
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

int dem_clump_flow_index(struct dem_clump_flow *f, const struct dem_clumps *c, const struct dem_particles *p)
{
    DEM_TRY(DEM_GROW(f->row, f->capacity, p->n + 1));
    DEM_TRY(DEM_GROW(f->rest, f->rest_capacity, p->n + 1));
    DEM_TRY(DEM_GROW(f->part, f->part_capacity, p->n + 1));
    for (size_t i = 0; i < p->n; i++)
    {
        f->part[i] = (struct dem_clump_part){.which = -1};
    }
    for (size_t body = 0; body < c->n; body++)
    {
        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            const size_t i = c->member[k];
            const struct dem_clump_form *const form = form_of(f, p, i);
            const double mass = dem_clump_at(p, i)->mass, share = p->record[i].mass/mass;

            f->part[i] = (struct dem_clump_part){
                .form = form, .which = (int)(form - f->form), .share = share, .mass = mass,
                .surface = share/form->sphericity,
                .q = c->group[c->place[body]/DEM_CLUMP_LANES].turned[c->place[body]%DEM_CLUMP_LANES]};
        }
    }
    return DEM_OK;
}

/* ---- kick ------------------------------------------------------------------------------------ */

struct sums    /* struct dem_clump_flow_sums of the bodies of a group */
{
    _Alignas(64) double force[3][DEM_CLUMP_LANES];
    double torque[3][DEM_CLUMP_LANES], slip_force[3][DEM_CLUMP_LANES];
    double drag[DEM_CLUMP_LANES], spin_drag[DEM_CLUMP_LANES];
    double z[DEM_CLUMP_LANES], phi[DEM_CLUMP_LANES], phi_spin[DEM_CLUMP_LANES];
};

_Static_assert(sizeof(struct dem_clump_flow_row) == 64 && sizeof(struct dem_clump_flow_rest) == 64,
               "dem_clump_gather_rows takes eight numbers");

DEM_MATH void add_rows(const struct dem_clump_slot *s, double row[4][4][DEM_CLUMP_LANES], struct sums *sum)
{
    _Alignas(64) double all[3][DEM_CLUMP_LANES], moment[3][DEM_CLUMP_LANES];

    for (int a = 0; a < 3; a++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            sum->force[a][c] += row[0][a][c];
            sum->slip_force[a][c] += row[1][a][c];
            all[a][c] = row[0][a][c] + row[1][a][c];
        }
    }
    dem_clump_moment(s, all, moment);
    for (int a = 0; a < 3; a++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            sum->torque[a][c] += moment[a][c] + row[3][a][c];
        }
    }
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double square = s->arm[0][c]*s->arm[0][c] + s->arm[1][c]*s->arm[1][c] + s->arm[2][c]*s->arm[2][c];

        sum->drag[c] += row[0][3][c];
        sum->spin_drag[c] += row[0][3][c]*square + row[2][3][c];
    }
}

/* Sum over the spheres, and kick the bodies. */
DEM_KERNEL
static void kick_group(struct dem_clump_group *restrict g, const struct dem_clump_slot *restrict slot,
                       const struct dem_clump_flow *restrict f, const double (*contact)[8], int rest, double h,
                       struct sums *restrict s)
{
    _Alignas(64) double row[4][4][DEM_CLUMP_LANES] = {{{0.0}}};

    memset(s, 0, sizeof *s);
    for (size_t k = g->first; k < g->end; k++)
    {
        dem_clump_add_contacts(&slot[k], contact, s->force, s->torque);
    }
    for (size_t k = g->first; k < g->end; k++)
    {
        dem_clump_gather_rows(&slot[k], f->row, row);
        if (rest)
        {
            dem_clump_gather_rows(&slot[k], f->rest, row + 2);
        }
        add_rows(&slot[k], row, s);
    }
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double two = g->inertia[1][c] < g->inertia[2][c] ? g->inertia[1][c] : g->inertia[2][c],
                     least = g->inertia[0][c] < two ? g->inertia[0][c] : two;

        s->z[c] = g->moves ? s->drag[c]*h/g->mass[c] : 0.0;
        s->phi[c] = dem_phi(s->z[c]);
        s->phi_spin[c] = dem_phi(g->moves ? s->spin_drag[c]*h/least : 0.0);
    }
    for (int a = 0; a < 3 && g->moves; a++)
    {
        for (int c = 0; c < DEM_CLUMP_LANES; c++)
        {
            g->v[a][c] += s->phi[c]*h/g->mass[c]*(s->force[a][c] + s->slip_force[a][c]);
            g->momentum[a][c] += h*s->phi_spin[c]*s->torque[a][c];
        }
    }
}

/* J_k of the spheres of a slot; `particle_drag` times h. */
DEM_KERNEL
static void find_drag(const struct dem_clump_slot *restrict slot, const struct dem_clump_flow_row *restrict rows,
                      const struct sums *restrict s, double h, double J[4][DEM_CLUMP_LANES])
{
    _Alignas(64) double row[2][4][DEM_CLUMP_LANES];

    dem_clump_gather_rows(slot, rows, row);
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const double part =
            dem_select(s->drag[c] > 0.0, row[0][3][c]/dem_select(s->drag[c] > 0.0, s->drag[c], 1.0), 0.0);

        for (int a = 0; a < 3; a++)
        {
            J[a][c] = h*(s->phi[c]*row[1][a][c] - (1.0 - s->phi[c])*part*s->force[a][c]);
        }
        J[3][c] = row[1][3][c]*h;
    }
}

/* What a sphere adds of forces other than drag. */
static void add_rest(const struct dem_clump_flow_rest *r, double h, double phi_spin, struct dem_particles *p, size_t i)
{
    double *const other = dem_column(p, DEM_COLUMN_OTHER_IMPULSE),
           *const angular = dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE);

    for (size_t a = 0; a < 3 && other; a++)
    {
        other[3*i + a] += h*r->reaction[a];
    }
    for (size_t a = 0; a < 3 && angular; a++)
    {
        angular[3*i + a] += h*phi_spin*r->spin_torque[a];
    }
}

/* What the spheres of a slot add to the columns that the fluid reads. */
static void add_impulses(const struct dem_clump_slot *slot, const struct dem_clump_flow *f, const struct sums *s,
                         struct dem_particles *p, int rest, double h)
{
    double *const impulse = dem_column(p, DEM_COLUMN_DRAG_IMPULSE),
           *const decay = dem_column(p, DEM_COLUMN_DECAY_FACTOR),
           *const drag_integral = dem_column(p, DEM_COLUMN_DRAG_INTEGRAL);
    _Alignas(64) double J[4][DEM_CLUMP_LANES];

    find_drag(slot, f->row, s, h, J);
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        const size_t i = slot->particle[c];

        if (i == DEM_CLUMP_NO_SPHERE)
        {
            continue;
        }
        impulse[3*i] += J[0][c];
        impulse[3*i + 1] += J[1][c];
        impulse[3*i + 2] += J[2][c];
        decay[i] *= 1.0 - s->z[c]*s->phi[c];
        drag_integral[i] += J[3][c];
        if (rest)
        {
            add_rest(&f->rest[i], h, s->phi_spin[c], p, i);
        }
    }
}

DEM_KERNEL
static void spread(const struct dem_clump_group *restrict g, const struct dem_clump_slot *restrict slot,
                   struct dem_particle *restrict record)
{
    dem_clump_spread(g, slot, record);
}

/* For the energy balance. */
static void keep_sums(const struct sums *s, struct dem_clump_flow_sums *to)
{
    for (int c = 0; c < DEM_CLUMP_LANES; c++)
    {
        to[c] = (struct dem_clump_flow_sums){.force = DEM_CLUMP_LANE3(s->force), .torque = DEM_CLUMP_LANE3(s->torque),
                                             .slip_force = DEM_CLUMP_LANE3(s->slip_force), .drag = s->drag[c],
                                             .phi = s->phi[c], .phi_spin = s->phi_spin[c]};
    }
}

void dem_clump_flow_kick(struct dem_clump_flow *f, struct dem_clumps *c, struct dem_particles *p, double h)
{
    const int rest = dem_column(p, DEM_COLUMN_OTHER_IMPULSE) || dem_column(p, DEM_COLUMN_ANGULAR_IMPULSE);
    struct sums s;

    c->ahead = 1;
    for (size_t k = 0; k < c->groups; k++)
    {
        struct dem_clump_group *const g = &c->group[k];

        if (k + 1 < c->groups)
        {
            dem_clump_prefetch(g + 1, c->slot, c->contact, sizeof *c->contact, 1);
            dem_clump_prefetch(g + 1, c->slot, f->row, sizeof *f->row, 1);
            dem_clump_prefetch(g + 1, c->slot, p->record, sizeof *p->record, 2);
        }
        kick_group(g, c->slot, f, (const double (*)[8])c->contact, rest, h, &s);
        for (size_t m = g->first; m < g->end; m++)
        {
            add_impulses(&c->slot[m], f, &s, p, rest, h);
        }
        spread(g, c->slot, p->record);
        if (f->sums)
        {
            keep_sums(&s, f->sums + k*DEM_CLUMP_LANES);
        }
    }
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

void dem_clump_share_decay(const struct dem_clumps *c, const struct dem_particles *p, const double *integral,
                           double *decay, int per_mass)
{
    for (size_t body = 0; body < c->n; body++)
    {
        double sum = 0.0;

        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            sum += integral[c->member[k]];
        }
        for (size_t k = c->start[body]; k < c->start[body + 1]; k++)
        {
            const size_t i = c->member[k];
            const double masses = per_mass ? dem_clump_at(p, i)->mass/p->record[i].mass : 1.0;

            decay[i] = sum > 0.0 ? 1.0 - masses*integral[i]/sum*(1.0 - decay[i]) : 1.0;
        }
    }
}

void dem_clump_flow_end_window(const struct dem_clumps *c, struct dem_particles *p)
{
    double *const decay = dem_column(p, DEM_COLUMN_DECAY_FACTOR);

    if (decay)
    {
        dem_clump_share_decay(c, p, dem_column(p, DEM_COLUMN_DRAG_INTEGRAL), decay, 0);
    }
}
