/*
 * ready_particles.c -- particles of the start: inserted by the scene, handed in by the program or read from a snapshot; their first
 * columns. Each rank takes its share; the owners of their places get them later (ready.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/snapshot.h"
#include "step/uniform.h"
#include "step/measure.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* One that the program handed in, as the scene knows it. */
static int resolve(const struct dem *d, size_t k, struct dem_particle *whole)
{
    const struct dem_particle *const p = &d->crowd.particle[k];
    int material;

    DEM_TRY(dem_recipe_material(&d->parts.recipe, d->crowd_material[k], "dem_add_particles", &material));
    *whole = dem_particle_sphere(p->id, p->x, 2.0*p->radius, d->parts.recipe.material[material].density, material);
    memcpy(whole->v, p->v, sizeof p->v);
    memcpy(whole->w, p->w, sizeof p->w);
    if (p->flags & DEM_PARTICLE_FROZEN)
    {
        whole->flags = DEM_PARTICLE_FROZEN;
        whole->inverse_mass = whole->inverse_inertia = 0.0;
    }
    return DEM_OK;
}

/* What the program handed in joins what the scene inserts: all ranks have the whole list, each takes every ranks-th. */
static int take_crowd(struct dem *d)
{
    struct dem_crowd *const c = &d->scene.crowd;
    int64_t next = c->next_id, *id;

    if (d->crowd.n == 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_crowd_begin(c, "dem_add_particles"));
    DEM_TRY(DEM_NEW(id, d->crowd.n));
    for (size_t k = 0; k < d->crowd.n; k++)
    {
        struct dem_particle whole;

        DEM_TRY(resolve(d, k, &whole));
        whole.id = id[k] = whole.id < 0 ? next : whole.id;
        next = id[k] >= next ? id[k] + 1 : next;
        dem_crowd_count(c, 1, 2.0*whole.radius, whole.mass, whole.material);
        if (k%(size_t)d->parts.pieces.ranks == (size_t)d->parts.pieces.rank)
        {
            DEM_TRY(dem_crowd_add(c, whole, "dem_add_particles"));
        }
    }
    const int status = dem_insert_refuse_twins(&d->scene.insertion, d->crowd.n, id);

    dem_memory_free(id);
    return status;
}

/* This rank's share becomes its own; the first balance hands them to the owners of their places. */
static int settle_crowd(struct dem *d)
{
    const struct dem_crowd *const c = &d->scene.crowd;
    struct dem_particles *const p = &d->parts.particles;

    DEM_TRY(dem_particles_grow(p, c->n + 1));
    for (size_t k = 0; k < c->n; k++)
    {
        DEM_REQUIRE(dem_domain_holds(&d->parts.domain, c->particle[k].x), DEM_ERROR_INPUT,
                    "particle %lld at (%g %g %g) m is outside the domain; move it, or enlarge the domain",
                    (long long)c->particle[k].id, c->particle[k].x[0], c->particle[k].x[1], c->particle[k].x[2]);
        p->record[p->n++] = c->particle[k];
    }
    return DEM_OK;
}

/* Radii of all ranks: smallest and largest by material for the recipe. */
void dem_door_survey_radii(struct dem_parts *p)
{
    double least[2*DEM_MATERIALS];                        /* smallest radii, then the negative of the largest */

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        least[m] = DBL_MAX;
        least[DEM_MATERIALS + m] = 0.0;
    }
    for (size_t i = 0; i < p->particles.n; i++)
    {
        const struct dem_particle *const r = &p->particles.record[i];

        least[r->material] = fmin(least[r->material], r->radius);
        least[DEM_MATERIALS + r->material] = fmin(least[DEM_MATERIALS + r->material], -r->radius);
    }
    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, least, 2*DEM_MATERIALS, MPI_DOUBLE, MPI_MIN, p->pieces.comm);
    }
    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        p->recipe.least_radius[m] = least[m] < DBL_MAX ? least[m] : 0.0;
        p->recipe.most_radius[m] = -least[DEM_MATERIALS + m];
    }
}

/* A uniform fluid fills the columns once; a coupled one marks every particle as not yet placed. */
void dem_door_fill_fluid(struct dem *d)
{
    struct dem_particles *const p = &d->parts.particles;
    const double mean = dem_column(p, DEM_COLUMN_MEAN_DIAMETER) ? dem_measure_sauter(&d->parts) : 0.0;

    for (size_t i = 0; d->with_fluid && i < p->n; i++)
    {
        dem_uniform_fill(p, i, &d->scene.fluid, mean);
    }
}

/* The recipe is not frozen yet when particles come. */
static int keeps_books(const struct dem_recipe *r)
{
    int books = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        books |= r->effect[k]->stage == DEM_STAGE_BOND || r->effect[k]->stage == DEM_STAGE_FILM;
    }
    return books;
}

/* Columns that are there because an effect asks for them, or writes them. */
static unsigned groups(const struct dem *d)
{
    static const struct
    {
        unsigned needs, group;
    } asked[] = {
        {DEM_NEEDS_ACCELERATION, DEM_GROUP_ACCELERATION},
        {DEM_NEEDS_VORTICITY, DEM_GROUP_VORTICITY},
        {DEM_NEEDS_STRESS, DEM_GROUP_STRESS},
        {DEM_NEEDS_MEAN_DIAMETER, DEM_GROUP_MEAN_DIAMETER},
    };
    const struct dem_recipe *const r = &d->parts.recipe;
    const unsigned needs = dem_recipe_asks(r);
    unsigned some = (d->with_fluid ? DEM_GROUP_FLUID : 0) | (keeps_books(r) ? DEM_GROUP_BOOKS : 0) | (d->turned ? DEM_GROUP_TURNED : 0);

    for (size_t k = 0; k < sizeof asked/sizeof asked[0]; k++)
    {
        some |= needs & asked[k].needs ? asked[k].group : 0;
    }
    for (int k = 0; k < r->chosen; k++)
    {
        const struct dem_effect *const e = r->effect[k];

        some |= (e->drag && e->open_bodies ? DEM_GROUP_SWARM : 0) | (e->reacts ? DEM_GROUP_REACTS : 0)
              | (e->inertia ? DEM_GROUP_ADDED : 0) | (e->turns ? DEM_GROUP_TURNS : 0);
    }
    return some;
}

/* A file may come from a run with added mass; a window of this one adds its own. */
static void take_off_added_mass(struct dem_particles *p)
{
    for (size_t i = 0; i < p->n; i++)
    {
        p->record[i].inverse_mass = p->record[i].inverse_mass > 0.0 ? 1.0/p->record[i].mass : 0.0;
    }
}

/* A snapshot from the middle of a window. */
static void open_window(struct dem_parts *p, const struct dem_snapshot_window *w)
{
    p->open = w->ahead > 0;
    p->ahead = w->ahead;
    p->before = p->steps - w->done;
    p->opened = w->opened;
    p->dt = w->dt;
    p->window = w->dt*(double)w->ahead;
}

/* A scene that starts from a file has streams of its own; ids of the file's go on. */
int dem_door_begin_flows(struct dem *d)
{
    d->parts.flows.fluid = &d->scene.fluid;
    d->parts.flows.asked = d->between;
    d->flowed.flows = d->new ? 0 : d->flowed.flows;
    return dem_flows_begin(&d->parts, &d->scene.streams, d->load[0] ? &d->flowed : NULL);
}

int dem_door_start_particles(struct dem *d)
{
    struct dem_parts *const p = &d->parts;
    struct dem_snapshot s;

    dem_particles_init(&p->particles, groups(d));
    DEM_TRY(dem_particles_grow(&p->particles, 1));
    if (d->load[0])
    {
        DEM_TRY(dem_snapshot_read_particles(d->load, &s, &p->pieces, &p->recipe, &p->particles));
        p->time = s.time;
        p->steps = s.steps;
        open_window(p, &s.window);
        take_off_added_mass(&p->particles);
        memcpy(&d->learnt, s.learnt, sizeof d->learnt);
        d->flowed = s;
        return DEM_OK;
    }
    DEM_TRY(dem_insert_place(&d->scene.crowd, &d->scene.insertion, &p->recipe, &p->pieces));
    DEM_TRY(take_crowd(d));
    dem_insert_free(&d->scene.insertion);
    DEM_TRY(settle_crowd(d));
    dem_crowd_disperse(&d->scene.crowd);
    dem_crowd_disperse(&d->crowd);
    dem_memory_free(d->crowd_material);
    d->crowd_material = NULL;
    d->crowd_room = 0;
    return DEM_OK;
}
