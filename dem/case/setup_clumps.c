/*
 * setup_clumps.c -- what a scene with rigid bodies of several spheres (particles/clump.h) cannot have
 * yet, and what the set-up has to know of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "core/error.h"
#include "core/memory.h"
#include "particles/clump_flow.h"
#include "ranks/collect.h"
#include "step/clump_heat.h"
#include <math.h>

/* Gravity, drag, heat transfer, pressure gradient, viscous stress and viscous torque act on bodies. */
static int acts_on_bodies(const struct dem_effect *e)
{
    const int lift = e->has_reaction && !(e->needs & DEM_NEEDS_STRESS);

    return e->stage == DEM_STAGE_BODY ? e->uniform_acceleration != NULL
                                      : !e->has_added_mass && !e->eddies && !lift &&
                                            !(e->needs & DEM_NEEDS_INTERFACE);
}

/* Only the temperature has a value of the whole body (step/clump_heat.h). */
static int refuse_scalars(const struct dem_effect *e)
{
    for (int k = 0; e->scalars && e->scalars[k]; k++)
    {
        DEM_REQUIRE(!(e->scalars[k]->flags & DEM_SCALAR_RATE) || e->scalars[k]->flags & DEM_SCALAR_HEAT,
                    DEM_ERROR_INPUT, "shapes: effects/%s changes %s, which clumps do not have yet; leave out one "
                    "of the two", e->name, e->scalars[k]->name);
    }
    return DEM_OK;
}

static int refuse_effects(const struct dem_interaction_table *r)
{
    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        DEM_REQUIRE((e->stage != DEM_STAGE_BODY && e->stage != DEM_STAGE_FLUID) || acts_on_bodies(e),
                    DEM_ERROR_INPUT,
                    "shapes: effects/%s acts on single spheres; on clumps act gravity, laws of drag and "
                    "heat transfer, pressureGradient, viscousStress and viscousTorque; leave out one of the two",
                    e->name);
        /* springs are not bounded by the inertia of one sphere */
        DEM_REQUIRE(e->stage != DEM_STAGE_MOMENT || e->history, DEM_ERROR_INPUT,
                    "shapes: effects/%s resists the rotation of single spheres and is wrong for clumps, whose "
                    "form resists rolling; leave it out, or take rollingSpring", e->name);
        DEM_REQUIRE(e->stage != DEM_STAGE_SCALAR || !e->reach, DEM_ERROR_INPUT,
                    "shapes: effects/%s exchanges heat over gaps between whole spheres, but the spheres of a clump "
                    "overlap; leave out one of the two", e->name);
        DEM_TRY(refuse_scalars(e));
    }
    return DEM_OK;
}

/* Entries and calls, and whether they are in use. */
static int refuse_entries(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const struct dem_domain *const box = &d->state.domain;
    const struct
    {
        const char *name;
        int used;
    } entries[] = {
        {"domain/flat", box->flat[0] || box->flat[1] || box->flat[2]},
        {"parcels", d->state.interaction_table.parcels.used},
        {"start/frozen", d->scene.start_frozen >= 0 && d->scene.snapshot != NULL},
        {"a drag law with the mean diameter around a particle",
          (dem_interaction_table_needs(&d->state.interaction_table) & DEM_NEEDS_MEAN_DIAMETER) != 0},
        {"coupling/ownWake or coupling/lawWidth", c->own_wake},
    };

    for (size_t k = 0; k < sizeof entries/sizeof *entries; k++)
    {
        DEM_REQUIRE(!entries[k].used, DEM_ERROR_INPUT,
                    "shapes: %s cannot be used with clumps yet; leave out one of the two",
                    entries[k].name);
    }
    return DEM_OK;
}

/* A body must not reach its own periodic image. */
static int check_width(const struct dem *d, const struct dem_clump_shape *s)
{
    const struct dem_domain *const box = &d->state.domain;

    for (int k = 0; k < 3; k++)
    {
        const double least = 3.0*s->bound + d->state.interaction_table.reach;

        DEM_REQUIRE(!box->periodic[k] || box->length[k] >= least, DEM_ERROR_INPUT,
                    "shapes/%s: the domain is periodic along %c and %g m wide, so that a clump of %g m "
                    "reaches its own image; make the domain at least %g m wide", s->name, "xyz"[k],
                    box->length[k], 2.0*s->bound, least);
    }
    return DEM_OK;
}

int dem_sim_check_clumps(struct dem_case *c)
{
    const struct dem_clump_shapes *const s = &c->d->scene.shapes;

    c->d->state.interaction_table.bond_radius = dem_clump_shapes_bond_radius(s);

    for (size_t k = 0; k < s->n; k++)
    {
        DEM_TRY(check_width(c->d, &s->shape[k]));
    }
    DEM_TRY(s->n > 0 ? refuse_effects(&c->d->state.interaction_table) : DEM_OK);
    return s->n > 0 ? refuse_entries(c) : DEM_OK;
}

/* A snapshot may be damaged, or of a scene with other shapes or densities; a spin may be too large for the
   step. */
static int check_body(const struct dem *d, size_t i)
{
    const struct dem_particles *const p = &d->state.particles;
    const struct dem_clump *const b = dem_clump_of(p, i);
    const struct dem_material *const m =
        &d->state.interaction_table.material[p->record[i].material];

    DEM_REQUIRE(!b || (b->mass > 0.0 && b->inertia[0] > 0.0 && b->inertia[1] > 0.0 &&
                       b->inertia[2] > 0.0 &&
                       fabs(b->q[0]*b->q[0] + b->q[1]*b->q[1] + b->q[2]*b->q[2] + b->q[3]*b->q[3] -
                            1.0) < 1e-9),
                DEM_ERROR_FILE,
                "particle %lld belongs to a clump without mass or orientation: the snapshot is damaged; "
                "use another one", (long long)p->record[i].id);
    DEM_REQUIRE(!b || dem_clump_shapes_with_volume(&d->scene.shapes, b->mass/m->density), DEM_ERROR_INPUT,
                "particle %lld belongs to a clump of %.9g kg, which no shape of the scene has with the "
                "density of %s, %g kg/m3; keep the shapes and densities of the run that wrote the "
                "snapshot, and add others under new names", (long long)p->record[i].id, b->mass,
                m->name, m->density);
    return b ? dem_clump_check_spin(b, &p->record[i], d->step, DEM_ERROR_INPUT) : DEM_OK;
}

/* In a fluid. */
static int begin_flow(struct dem *d)
{
    struct dem_clumps *const c = &d->state.clumps;
    const unsigned needs = d->state.interaction_table.bodies.needs;

    if (d->scene.shapes.n == 0 || !dem_column(&d->state.particles, DEM_COLUMN_FLUID_VELOCITY))
    {
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(c->flow, 1));
    return dem_clump_flow_begin(c->flow, &d->scene.shapes, (needs & DEM_NEEDS_FORM) != 0);
}

/* One temperature a body. */
static int begin_heat(struct dem *d)
{
    const struct dem_interaction_table *const t = &d->state.interaction_table;

    for (int k = 0; k < t->listed && d->scene.shapes.n > 0 && !d->state.clumps.heat; k++)
    {
        if (t->scalar[k]->flags & DEM_SCALAR_HEAT)
        {
            DEM_TRY(DEM_NEW(d->state.clumps.heat, 1));
            d->state.clumps.heat->scalar = k;
        }
    }
    return DEM_OK;
}

/* Bodies of a snapshot come with their state, and need the column of it. */
int dem_sim_begin_clumps(struct dem *d)
{
    struct dem_state *const state = &d->state;
    const int column = dem_column(&state->particles, DEM_COLUMN_CLUMP) != NULL;
    double reach = column ? dem_clumps_reach(&state->particles) : 0.0;

    for (size_t i = 0; i < state->particles.n && column; i++)
    {
        DEM_TRY(check_body(d, i));
    }
    for (size_t i = 0; i < state->particles.n && !column; i++)
    {
        DEM_REQUIRE(state->particles.record[i].body == 0, DEM_ERROR_INPUT,
                    "particle %lld of the snapshot is a sphere of a clump, but the scene has no shapes; "
                    "add the shapes of the run that wrote it", (long long)state->particles.record[i].id);
    }
    for (size_t k = 0; k < d->scene.shapes.n; k++)
    {
        reach = fmax(reach, d->scene.shapes.shape[k].reach);    /* of streams, too */
    }
    if (column)
    {
        dem_collect_max_double(&state->decomposition, &reach, 1);
        state->halo.clump_reach = reach;
    }
    DEM_TRY(begin_flow(d));
    DEM_TRY(begin_heat(d));
    return dem_collect_status(&state->decomposition);
}
