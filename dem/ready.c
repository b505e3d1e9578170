/*
 * ready.c -- how a scene becomes a running state: words, walls, physics (check.c), particles, owners, in this order; particles of
 * a snapshot come before physics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "base/memory.h"
#include "io/snapshot.h"
#include "step/bond_pairs.h"
#include "step/measure.h"
#include "step/orientation.h"
#include "step/step.h"
#include "step/sum_contacts.h"
#include "step/sweep_contacts.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* More initial overlap than this share of a diameter is a slip in the input, not a contact. */
static const double most_initial_overlap = 0.05;

/* Corners from all ranks, in their order. */
static int gather_corners(const struct dem_parts *p, size_t n, const double *mine, double **corners, size_t *triangles)
{
    const int count = (int)(9*n);
    int *counts, *start, total = 0;
    double *all;

    if (p->pieces.ranks == 1)
    {
        DEM_TRY(DEM_NEW(all, 9*n + 1));
        memcpy(all, mine, 9*n*sizeof *all);
        *corners = all;
        *triangles = n;
        return DEM_OK;
    }
    DEM_TRY(DEM_NEW(counts, p->pieces.ranks));
    DEM_TRY(DEM_NEW(start, p->pieces.ranks));
    MPI_Allgather(&count, 1, MPI_INT, counts, 1, MPI_INT, p->pieces.comm);
    for (int k = 0; k < p->pieces.ranks; k++)
    {
        start[k] = total;
        total += counts[k];
    }
    DEM_TRY(DEM_NEW(all, total + 1));
    MPI_Allgatherv(mine, count, MPI_DOUBLE, all, counts, start, MPI_DOUBLE, p->pieces.comm);
    dem_memory_free(counts);
    dem_memory_free(start);
    *corners = all;
    *triangles = (size_t)total/9;
    return DEM_OK;
}

/* walls.c sorts them, so who brought which does not matter. */
static int gather_wall(struct dem_parts *p, int wall, const struct dem_mesh_wall *m)
{
    double *corners;
    size_t n;

    DEM_TRY(gather_corners(p, m->n, m->triangles, &corners, &n));
    const int status = dem_walls_add_triangles(&p->walls, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

int dem_door_tell_wall(struct dem *d, const struct dem_mesh_wall *m, int now)
{
    struct dem_walls *const w = &d->parts.walls;
    double *corners;
    int wall = 0;
    size_t n;

    while (wall < w->walls && strcmp(w->wall[wall].name, m->name) != 0)
    {
        wall++;
    }
    DEM_TRY(gather_corners(&d->parts, m->n, m->now, &corners, &n));
    const int status = now ? dem_walls_place(w, wall, n, corners) : dem_walls_tell(w, wall, n, corners);

    dem_memory_free(corners);
    return status;
}

static int place_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        if (d->mesh_wall[k].now)
        {
            DEM_TRY(dem_door_tell_wall(d, &d->mesh_wall[k], 1));
        }
    }
    return DEM_OK;
}

static int take_walls(struct dem *d)
{
    for (size_t k = 0; k < d->mesh_walls; k++)
    {
        const struct dem_mesh_wall *const m = &d->mesh_wall[k];
        int material, wall;

        DEM_TRY(dem_recipe_material(&d->parts.recipe, m->material, m->name, &material));
        DEM_TRY(dem_walls_add(&d->parts.walls, m->name, material, &wall));
        DEM_TRY(gather_wall(&d->parts, wall, m));
    }
    return DEM_OK;
}

/* What the program handed in joins what the scene inserts. */
static int take_crowd(struct dem *d)
{
    if (d->crowd.n > 0)
    {
        DEM_TRY(dem_crowd_begin(&d->scene.crowd, "dem_add_particles"));
    }
    for (size_t k = 0; k < d->crowd.n; k++)
    {
        struct dem_particle p = d->crowd.particle[k], whole;
        int material;

        DEM_TRY(dem_recipe_material(&d->parts.recipe, d->crowd_material[k], "dem_add_particles", &material));
        whole = dem_particle_sphere(p.id, p.x, 2.0*p.radius, d->parts.recipe.material[material].density, material);
        memcpy(whole.v, p.v, sizeof p.v);
        memcpy(whole.w, p.w, sizeof p.w);
        if (p.flags & DEM_PARTICLE_FROZEN)
        {
            whole.flags = DEM_PARTICLE_FROZEN;
            whole.inverse_mass = whole.inverse_inertia = 0.0;
        }
        DEM_TRY(dem_crowd_add(&d->scene.crowd, whole, "dem_add_particles"));
    }
    return DEM_OK;
}

/* Does anything need the fluid of a run, and is there one source for each of its numbers? */
static int decide_fluid(struct dem *d)
{
    const struct dem_effect *has_own = NULL;
    double viscosity = 0.0;

    for (int k = 0; k < d->parts.recipe.chosen; k++)
    {
        const struct dem_effect *const effect = d->parts.recipe.effect[k];
        const double own = effect->needs & DEM_NEEDS_VISCOSITY ? dem_recipe_number(&d->parts.recipe, effect->name, "viscosity") : 0.0;

        d->with_fluid |= (effect->needs & DEM_NEEDS_FLUID) || (effect->needs & DEM_NEEDS_VISCOSITY && own == 0.0);
        d->feels_gradient |= strcmp(effect->name, "pressureGradient") == 0;
        viscosity = own > 0.0 ? own : viscosity;
        has_own = own > 0.0 ? effect : has_own;
    }
    DEM_REQUIRE(!(has_own && (d->with_fluid || d->scene.fluid.given)), DEM_ERROR_INPUT,
                "effects/%s gives viscosity %g Pa s, but the fluid of the run has one too; remove viscosity from %s", has_own->name,
                viscosity, has_own->name);
    return DEM_OK;
}

static int compare_ids(const void *a, const void *b)
{
    const int64_t p = *(const int64_t *)a, q = *(const int64_t *)b;

    return (p > q) - (p < q);
}

static int refuse_twins(const struct dem_crowd *c)
{
    int64_t *id, twin = -1;

    DEM_TRY(DEM_NEW(id, c->n + 1));
    for (size_t k = 0; k < c->n; k++)
    {
        id[k] = c->particle[k].id;
    }
    qsort(id, c->n, sizeof *id, compare_ids);
    for (size_t k = 1; k < c->n; k++)
    {
        twin = id[k] == id[k - 1] ? id[k] : twin;
    }
    dem_memory_free(id);
    DEM_REQUIRE(twin < 0, DEM_ERROR_INPUT, "two particles have id %lld; give each its own, or -1 for the next free one",
                (long long)twin);
    return DEM_OK;
}

/* Each rank takes every ranks-th particle of the common list; the first balance hands them over. */
static int spread_crowd(struct dem *d)
{
    const struct dem_crowd *const c = &d->scene.crowd;
    struct dem_particles *const p = &d->parts.particles;

    DEM_TRY(refuse_twins(c));
    DEM_TRY(dem_particles_grow(p, c->n/(size_t)d->parts.pieces.ranks + 1));
    for (size_t k = 0; k < c->n; k++)
    {
        DEM_REQUIRE(dem_domain_holds(&d->parts.domain, c->particle[k].x), DEM_ERROR_INPUT,
                    "particle %lld at (%g %g %g) m is outside the domain; move it, or enlarge the domain",
                    (long long)c->particle[k].id, c->particle[k].x[0], c->particle[k].x[1], c->particle[k].x[2]);
        if (k%(size_t)d->parts.pieces.ranks == (size_t)d->parts.pieces.rank)
        {
            DEM_TRY(dem_particles_grow(p, p->n + 1));
            memset(&p->record[p->n], 0, sizeof p->record[p->n]);
            p->record[p->n++] = c->particle[k];
        }
    }
    return DEM_OK;
}

/* Radii of all ranks: smallest and largest by material for the recipe. */
static void survey_radii(struct dem_parts *p)
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

static int prepare_physics(struct dem *d)
{
    struct dem_parts *const p = &d->parts;

    if (d->load[0])
    {
        survey_radii(p);
        DEM_TRY(dem_door_settle_physics(d));
    }
    const double radius = dem_door_most_radius(d), skin[2] = {2.0*radius*d->scene.outer_skin, 2.0*radius*d->scene.inner_skin};

    DEM_TRY(dem_contacts_init(&p->contacts, &p->recipe));
    DEM_TRY(place_walls(d));
    dem_pairs_init(&p->pairs, &p->domain, skin, p->recipe.reach, radius);
    return dem_wall_search_prepare(&p->pairs.search, &p->walls, radius > 0.0 ? radius : 1.0);
}

/* A uniform fluid fills the columns once; a coupled one marks every particle as not yet placed. */
static void fill_fluid(struct dem *d)
{
    struct dem_particles *const p = &d->parts.particles;
    const struct dem_uniform_fluid *const f = &d->scene.fluid;

    for (size_t i = 0; d->with_fluid && i < p->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            dem_column(p, DEM_COLUMN_FLUID_VELOCITY)[3*i + k] = f->velocity[k];
            dem_column(p, DEM_COLUMN_PRESSURE_GRADIENT)[3*i + k] = f->pressure_gradient[k];
        }
        dem_column(p, DEM_COLUMN_VOID_FRACTION)[i] = f->given ? f->void_fraction : 1.0;
        dem_column(p, DEM_COLUMN_FLUID_DENSITY)[i] = f->given ? f->density : 1.0;
        dem_column(p, DEM_COLUMN_FLUID_VISCOSITY)[i] = f->given ? f->viscosity : 1.0;
        dem_column(p, DEM_COLUMN_COUNTERFLOW)[i] = 1.0;
        dem_column(p, DEM_COLUMN_PLACE)[2*i] = dem_column(p, DEM_COLUMN_PLACE)[2*i + 1] = -1.0;
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

static int opens_laws(const struct dem_recipe *r)
{
    int some = 0;

    for (int k = 0; k < r->chosen; k++)
    {
        some |= r->effect[k]->open_bodies != NULL;
    }
    return some;
}

static int start_particles(struct dem *d)
{
    struct dem_parts *const p = &d->parts;
    struct dem_snapshot s;

    dem_particles_init(&p->particles, (d->with_fluid ? DEM_GROUP_FLUID : 0) | (keeps_books(&p->recipe) ? DEM_GROUP_BOOKS : 0)
                       | (opens_laws(&p->recipe) ? DEM_GROUP_SWARM : 0) | (d->turned ? DEM_GROUP_TURNED : 0));
    DEM_TRY(dem_particles_grow(&p->particles, 1));
    if (d->load[0])
    {
        DEM_TRY(dem_snapshot_read_particles(d->load, &s, &p->pieces, &p->recipe, &p->particles));
        p->time = s.time;
        p->steps = s.steps;
        return DEM_OK;
    }
    DEM_TRY(dem_insert_place(&d->scene.crowd, &d->scene.insertion, &p->recipe));
    dem_insert_free(&d->scene.insertion);
    DEM_TRY(take_crowd(d));
    DEM_TRY(spread_crowd(d));
    dem_crowd_disperse(&d->scene.crowd);
    dem_crowd_disperse(&d->crowd);
    return DEM_OK;
}

static int refuse_overlap(struct dem_parts *p)
{
    int64_t i = 0, j = 0;
    double x[3] = {0.0, 0.0, 0.0};
    const double worst = dem_measure_overlap(p, &i, &j, x);

    DEM_REQUIRE(worst <= most_initial_overlap || j >= 0, DEM_ERROR_INPUT,
                "particle %lld at (%g %g %g) m overlaps wall %s by %.3g of a diameter at the start, the limit is %g; move it",
                (long long)i, x[0], x[1], x[2], p->walls.wall[p->walls.region[-1 - j].wall].name, worst, most_initial_overlap);
    DEM_REQUIRE(worst <= most_initial_overlap, DEM_ERROR_INPUT,
                "particles %lld and %lld at (%g %g %g) m overlap by %.3g of a diameter at the start, the limit is %g; move them apart",
                (long long)i, (long long)j, x[0], x[1], x[2], worst, most_initial_overlap);
    return DEM_OK;
}

/* All ranks fail when one does: the smallest of what they report. */
static int together(const struct dem_parts *p, int status)
{
    int worst = status;

    if (p->pieces.ranks > 1)
    {
        MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, p->pieces.comm);
    }
    return worst == DEM_OK || status != DEM_OK ? status : dem_error(worst, "another rank failed; its message tells why");
}

/* Hand particles to their owners; a fresh start also gets its first lists, to look for overlaps, and the forces with
   which the first half kick begins (a snapshot brings them along). */
static int settle_in(struct dem *d)
{
    struct dem_parts *const p = &d->parts;

    DEM_TRY(dem_pieces_balance(&p->pieces, &p->particles));
    DEM_TRY(dem_halo_migrate(&p->halo, &p->particles, &p->contacts));
    p->stale = 2;
    dem_walls_move(&p->walls, p->time, 0.0);
    if (d->load[0])
    {
        return dem_snapshot_read_rows(d->load, &p->recipe, &p->particles, &p->contacts);
    }
    DEM_TRY(dem_step_renew(p));
    p->stale = 1;
    DEM_TRY(together(p, refuse_overlap(p)));
    DEM_TRY(dem_bond_pairs_ask(p, d->scene.bond_ids, d->scene.bond_id_count));
    DEM_TRY(dem_sweep_contacts(p, 0.0, (const double[2]){-INFINITY, p->time}));
    dem_sum_contacts(&p->particles, &p->contacts);
    dem_sum_books(&p->particles, &p->contacts);
    p->watch.overlap = 0.0;
    return DEM_OK;
}

/* What contacts hold at the start: the first sweep has told. A snapshot's rows are looked at aside, with lists of their own,
   and everything is put back: the run goes on with the same bits. */
static int begin_ledger(struct dem *d)
{
    struct dem_parts *const p = &d->parts;
    const int64_t rebuilds = p->rebuilds, prunes = p->prunes;
    const size_t losses = p->losses.n, broke = p->bonds.n;
    struct dem_kept aside = {.held = 0};

    if (!d->load[0])
    {
        dem_ledger_begin(p);
        return DEM_OK;
    }
    int status = dem_kept_take(&aside, &p->particles, &p->contacts, p->pairs.wall_region);

    status = status ? status : dem_step_renew(p);
    status = status ? status : dem_sweep_contacts(p, 0.0, (const double[2]){p->time, p->time});
    DEM_TRY(together(p, status));
    dem_ledger_begin(p);
    status = dem_kept_give(&aside, &p->particles, &p->contacts);
    dem_kept_free(&aside);
    p->stale = 2;
    p->watch.overlap = 0.0;
    p->losses.n = losses;
    p->bonds.n = broke;
    p->rebuilds = rebuilds;
    p->prunes = prunes;
    return status;
}

static int read_scene(struct dem *d)
{
    struct dem_parts *const p = &d->parts;

    DEM_TRY(dem_scene_read_materials(d->dict, &p->recipe));
    DEM_TRY(take_walls(d));
    DEM_TRY(dem_scene_read(&d->scene, d->dict, &p->recipe, &p->walls, &p->domain));
    if (d->scene.snapshot && !d->load[0])
    {
        DEM_TRY(dem_load(d, d->scene.snapshot));
        d->new = 1;
    }
    p->watch.limit = d->scene.most_overlap;
    DEM_TRY(decide_fluid(d));
    return dem_door_examine(d);
}

int dem_door_together(const struct dem *d, int status)
{
    return together(&d->parts, status);
}

/* What had been sampled when the snapshot was written; particles that a scene starts with bring no means. */
static int resume_means(struct dem *d)
{
    char beside[sizeof d->load + sizeof DEM_MEANS];

    if (!d->load[0] || d->new || d->parts.averages.grids == 0 || d->parts.pieces.rank > 0)
    {
        return DEM_OK;
    }
    snprintf(beside, sizeof beside, "%s" DEM_MEANS, d->load);
    return dem_averages_resume(&d->parts.averages, d->parts.time, beside);
}

int dem_door_read(struct dem *d)
{
    const int status = together(&d->parts, read_scene(d));

    d->checked = status ? -1 : 1;
    return status;
}

/* Ranks read different parts of a snapshot, so each may fail alone. */
int dem_door_get_ready(struct dem *d)
{
    if (!d->checked)
    {
        DEM_TRY(dem_door_read(d));
    }
    DEM_TRY(together(&d->parts, start_particles(d)));
    dem_orientation_begin(&d->parts.particles);
    DEM_TRY(together(&d->parts, prepare_physics(d)));
    if (d->scene.fluid.given || !d->load[0])
    {
        fill_fluid(d);
    }
    if (d->energy)
    {
        DEM_TRY(dem_ledger_open(&d->parts.ledger, &d->parts.recipe));
    }
    DEM_TRY(together(&d->parts, settle_in(d)));
    if (d->energy)
    {
        DEM_TRY(together(&d->parts, begin_ledger(d)));
    }
    DEM_TRY(dem_averages_init(&d->parts.averages, d->scene.average, d->scene.averages, d->parts.time, d->parts.pieces.rank == 0));
    DEM_TRY(together(&d->parts, resume_means(d)));
    d->ready = 1;
    return DEM_OK;
}
