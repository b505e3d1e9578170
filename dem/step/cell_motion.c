/*
 * cell_motion.c -- drift of the particles of a deforming periodic domain: see particles/cell.h.
 *
 * The term -D u acts half before and half after the drift, each a factor 1/(1 + dt D/2). The flow carries a
 * particle by dt D times its position in the middle of the step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/cell_motion.h"
#include "contacts/geometry.h"
#include "core/error.h"
#include "core/vec.h"
#include "ranks/dem_state.h"
#include "records/cell_stress.h"
#include "records/energy_balance.h"
#include <math.h>
#include <string.h>

/* The rate of an axis over the step that ends at `time` [s]. */
static double rate_of(const struct dem_cell_axis *a, double held, double time, double dt)
{
    const double middle = time - 0.5*dt;

    return !a->deforms || middle < a->start || middle > a->end ? 0.0 : a->held ? held : a->rate;
}

/* The shear since the list was made. */
static void set_slant(struct dem_state *state, int list)
{
    struct dem_displacement *const m = &state->pairs.displacement[list];
    const double height = state->cell.list_length[list][1];

    m->slant[0] = m->slant[1] = 0.0;
    if (state->cell.shear.deforms)
    {
        m->slant[0] = state->domain.offset/state->domain.length[1];
        m->slant[1] = height > 0.0 ? state->cell.list_offset[list]/height : m->slant[0];
        m->strain += fabs(m->slant[0] - m->slant[1]);
    }
}

void dem_cell_reduce_offset(struct dem_state *state)
{
    struct dem_domain *const d = &state->domain;
    const double turns = dem_domain_offset_turns(d);

    if (turns != 0.0)
    {
        d->offset -= turns*d->length[0];
        dem_domain_shifts(d, state->pairs.shift);
        dem_contacts_turn_images(&state->contacts, (int)turns);
        for (size_t i = 0; i < state->particles.n; i++)
        {
            uint32_t *const image = &state->particles.record[i].image;

            *image = dem_image_add(*image, 0, (int)turns*(int)dem_image_part(*image, 1));
        }
    }
}

void dem_cell_set_lengths(struct dem_state *state, const double length[3], double offset)
{
    struct dem_domain *const d = &state->domain;

    for (int k = 0; k < 3; k++)
    {
        if (state->cell.axis[k].deforms)
        {
            d->length[k] = length[k];
            d->max[k] = d->min[k] + length[k];
        }
    }
    d->offset = offset;
    dem_domain_shifts(d, state->pairs.shift);
    for (int list = 0; list < DEM_CELL_LISTS; list++)
    {
        struct dem_displacement *const m = &state->pairs.displacement[list];

        m->deforms = 1;
        m->strain = 0.0;
        for (int k = 0; k < 3; k++)
        {
            const double then = state->cell.list_length[list][k];
            const double back = d->periodic[k] && then > 0.0 ? then/d->length[k] : 1.0;

            m->back[k] = back;
            m->origin[k] = d->periodic[k] ? d->min[k] : 0.0;
            m->strain = fmax(m->strain, fmax(fabs(1.0/back - 1.0), fabs(back - 1.0)));
        }
        set_slant(state, list);
    }
}

void dem_cell_list_made(struct dem_state *state, int list)
{
    struct dem_displacement *const m = &state->pairs.displacement[list];

    memcpy(state->cell.list_length[list], state->domain.length, sizeof state->domain.length);
    state->cell.list_offset[list] = state->domain.offset;
    set_slant(state, list);
    m->strain = 0.0;
    for (int k = 0; k < 3; k++)
    {
        m->back[k] = 1.0;
    }
}

/* Lengths outside of the domain: 0 inside. Exact, since lengths and positions are multiples of a unit. */
static double lengths_outside(double x, double min, double length)
{
    double n = floor((x - min)/length);

    n -= x - n*length < min ? 1.0 : 0.0;
    n += x - n*length >= min + length ? 1.0 : 0.0;
    return n;
}

/* The change of the lengths, and half of the term -D u over a step. */
struct change
{
    double rate[3], length[3], factor[3];    /* 1/s, m, 1 */
    double shear, offset, turn;              /* 1/s, m; 1: half of the step times the shear */
    int sheared;
};

static void drift_particle(const struct dem_domain *d, const struct change *c, double dt,
                           struct dem_particle *p)
{
    /* lengths outside across y, whose images have another x */
    const double across = c->sheared ? lengths_outside(p->x[1], d->min[1], d->length[1]) : 0.0;
    const double aside = across*d->offset, height = p->x[1] - across*d->length[1] - d->min[1];

    p->v[0] -= c->turn*p->v[1];
    for (int k = 0; k < 3; k++)
    {
        const double round = d->round[k], from = k == 0 ? p->x[k] - aside : p->x[k];

        p->v[k] *= c->factor[k];
        if (d->periodic[k])
        {
            const double n = lengths_outside(from, d->min[k], d->length[k]);
            const double inside = from - n*d->length[k] - d->min[k], middle = inside + 0.5*dt*p->v[k];

            p->x[k] += ((dt*c->rate[k]*middle + round) - round) + n*c->length[k];
        }
        if (k == 0 && c->sheared)
        {
            const double middle = height + 0.5*dt*p->v[1];

            p->x[0] += ((dt*c->shear*middle + round) - round) + across*c->offset;
        }
        p->x[k] += (dt*p->v[k] + round) - round;
        p->v[k] *= c->factor[k];
    }
    p->v[0] -= c->turn*p->v[1];
}

/* What the term -D u has taken, as work of the cell. */
static void add_kinetic_work(struct dem_state *state, const struct dem_particle *p, const double was[3])
{
    dem_energy_balance_add(&state->energy_balance->sum[DEM_ENERGY_BALANCE_CELL],
                           0.5*p->mass*(dem_vec_dot(p->v, p->v) - dem_vec_dot(was, was)));
}

static void begin_shear(struct dem_state *state, double dt, struct change *c)
{
    const struct dem_domain *const d = &state->domain;

    c->turn = 0.5*dt*c->shear;
    c->offset = d->unit[0]*rint(dt*(c->shear*d->length[1] + c->rate[0]*d->offset)/d->unit[0]);
    state->cell.shear_flow = c->shear;
    state->cell.strain += dt*c->shear;
}

double dem_cell_drift(struct dem_state *state, double dt)
{
    struct dem_cell *const cell = &state->cell;
    const struct dem_domain *const d = &state->domain;
    double square = 0.0, invalid = 0.0, length[3];
    struct change c = {.shear = rate_of(&cell->shear, 0.0, state->time, dt), .sheared = cell->shear.deforms};

    for (int k = 0; k < 3; k++)
    {
        c.rate[k] = rate_of(&cell->axis[k], cell->rate[k], state->time, dt);
        c.length[k] = cell->axis[k].deforms
                          ? d->unit[k]*rint(dt*c.rate[k]*d->length[k]/d->unit[k])
                          : 0.0;
        c.factor[k] = 1.0/(1.0 + 0.5*dt*c.rate[k]);
        length[k] = d->length[k] + c.length[k];
        cell->rate[k] = cell->axis[k].held ? cell->rate[k] : c.rate[k];
        cell->flow[k] = c.rate[k];
    }
    if (c.sheared)
    {
        begin_shear(state, dt, &c);
    }
    /* before the particles move: ghosts do not move with them */
    if (state->energy_balance->open)
    {
        dem_cell_add_work(state, 0.5*dt);
    }
    for (size_t i = 0; i < state->particles.n; i++)
    {
        struct dem_particle *const p = &state->particles.record[i];
        const double was[3] = {p->v[0], p->v[1], p->v[2]};

        drift_particle(d, &c, dt, p);
        if (state->energy_balance->open)
        {
            add_kinetic_work(state, p, was);
        }
        const double here = dem_vec_dot(p->v, p->v);

        square = here > square ? here : square;
        invalid += 0.0*here;
    }
    dem_cell_set_lengths(state, length, d->offset + c.offset);
    /* a multiple of the length of x is taken off while lists are made */
    if (dem_domain_offset_turns(d) != 0.0)
    {
        dem_request_rebuild(state);
    }
    return invalid == 0.0 ? sqrt(square) : INFINITY;
}

int dem_cell_check(const struct dem_state *state)
{
    const struct dem_domain *const d = &state->domain;
    const double least = 2.0*state->pairs.max_radius + state->pairs.outer + state->interaction_table.reach;

    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(!state->cell.axis[k].deforms || d->length[k] >= least, DEM_ERROR_INPUT,
                    "the cell is only %g m wide along %c at %g s, so that a particle reaches its own "
                    "periodic image; the limit is %g m, a diameter, the skin and the reach of films and "
                    "bonds: end the compression before, or begin with a wider cell", d->length[k], "xyz"[k],
                    state->time, least);
        DEM_REQUIRE(!state->cell.axis[k].deforms
                        || fmax(fabs(d->min[k]), fabs(d->max[k])) + 2.0*d->length[k] <= state->cell.farthest[k],
                    DEM_ERROR_INPUT,
                    "the cell is %g m wide along %c at %g s; coordinates up to %g m have an exact unit of "
                    "length: end the extension before, or begin with a wider cell", d->length[k], "xyz"[k],
                    state->time, state->cell.farthest[k]);
    }
    return DEM_OK;
}

void dem_cell_add_velocities(const struct dem_state *state, int n, struct dem_gathered *g)
{
    const double *const rate = state->cell.flow;

    for (int c = 0; c < n; c++)
    {
        g->vx[c] += rate[0]*g->rx[c] + state->cell.shear_flow*g->ry[c];
        g->vy[c] += rate[1]*g->ry[c];
        g->vz[c] += rate[2]*g->rz[c];
    }
}

void dem_cell_backup(struct dem_state *state)
{
    struct dem_cell *const c = &state->cell;

    memcpy(c->backup[0], state->domain.length, sizeof state->domain.length);
    memcpy(c->backup[1], c->rate, sizeof c->rate);
    memcpy(c->backup[2], c->integral, sizeof c->integral);
    c->backup[3][0] = state->domain.offset;
    c->backup[3][1] = c->strain;
}

void dem_cell_restore(struct dem_state *state)
{
    struct dem_cell *const c = &state->cell;

    if (c->active)
    {
        memcpy(c->rate, c->backup[1], sizeof c->rate);
        memcpy(c->integral, c->backup[2], sizeof c->integral);
        c->strain = c->backup[3][1];
        dem_cell_set_lengths(state, c->backup[0], c->backup[3][0]);
    }
}
