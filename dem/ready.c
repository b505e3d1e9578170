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
#include "step/sweep_bodies.h"
#include "step/sweep_contacts.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* More initial overlap than this share of a diameter is a slip in the input, not a contact. */
static const double most_initial_overlap = 0.05;

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
    const double counted = dem_recipe_number(&d->parts.recipe, "stokes", "addedMass");

    DEM_REQUIRE(!(counted > 0.0 && dem_recipe_acts(&d->parts.recipe, "virtualMass")), DEM_ERROR_INPUT,
                "effects/stokes counts addedMass %g, and virtualMass adds it to the inertia, which stokes sees; leave addedMass out", counted);
    return DEM_OK;
}

/* Skins to begin with [m], thin as in a bed at rest: who moves fast makes them thicker at once. The most that they may become: a
   diameter, and less where somebody would find his own image. */
static void begin_skins(const struct dem_parts *p, double radius, double skin[2], double *most)
{
    double least = radius;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        least = p->recipe.least_radius[m] > 0.0 ? fmin(least, p->recipe.least_radius[m]) : least;
    }
    *most = 2.0*radius;
    for (int k = 0; k < 3; k++)
    {
        *most = p->domain.periodic[k] ? fmin(*most, 0.99*(p->domain.length[k] - 2.0*radius - p->recipe.reach)) : *most;
    }
    least = fmax(least, 0.05*radius);
    skin[0] = fmin(0.15*2.0*least, *most);
    skin[1] = fmin(0.02*2.0*least, skin[0]);
}

/* A run that goes on has the skins that it had: they decide when particles are put in order anew, and in that order a fluid hears of
   them. Other particles, or a scene that fixes them, begin anew. */
static void resume_skins(struct dem_skins *s, const struct dem_skins *learnt)
{
    _Static_assert(sizeof *s <= DEM_SNAPSHOT_LEARNT*sizeof(int64_t), "a snapshot has room for what lists have learnt");

    if (learnt->tuned == 1 && learnt->least == s->least && learnt->most == s->most && dem_skins_are_sound(learnt))
    {
        *s = *learnt;
    }
}

static int prepare_physics(struct dem *d)
{
    struct dem_parts *const p = &d->parts;

    if (d->load[0])
    {
        dem_door_survey_radii(p);
        dem_streams_radii(&d->scene.streams, p->recipe.least_radius, p->recipe.most_radius);
        DEM_TRY(dem_door_settle_physics(d));
    }
    const double radius = dem_door_most_radius(d);
    double skin[2] = {2.0*radius*d->scene.outer_skin, 2.0*radius*d->scene.inner_skin}, most = 2.0*radius;

    if (d->scene.tuned_skins)
    {
        begin_skins(p, radius, skin, &most);
    }

    DEM_TRY(dem_contacts_init(&p->contacts, &p->recipe));
    DEM_TRY(dem_door_place_walls(d));
    dem_pairs_init(&p->pairs, &p->domain, skin, p->recipe.reach, radius);
    if (d->scene.tuned_skins && radius > 0.0)
    {
        dem_pairs_tune(&p->pairs, most);
        resume_skins(&p->pairs.skins, &d->learnt);
    }
    return dem_wall_search_prepare(&p->pairs.search, &p->walls, radius > 0.0 ? radius : 1.0);
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

    DEM_TRY(together(p, dem_domain_lay_all(&p->domain, &p->particles)));
    DEM_TRY(dem_pieces_balance(&p->pieces, &p->particles, NULL));
    DEM_TRY(dem_halo_migrate(&p->halo, &p->particles, &p->contacts));
    p->stale = 2;
    dem_walls_move(&p->walls, p->time, 0.0);
    if (d->load[0])
    {
        return dem_snapshot_read_rows(d->load, &p->pieces, &p->recipe, &p->particles, &p->contacts);
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

    dem_flows_keep(&p->flows);

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
    dem_flows_go_back(&p->flows);
    p->losses.n = losses;
    p->bonds.n = broke;
    p->rebuilds = rebuilds;
    p->prunes = prunes;
    return status;
}

static void name(char *list, size_t room, const char *word)
{
    const size_t length = strlen(list);

    snprintf(list + length, room - length, "%s%s", length > 0 ? " " : "", word);
}

static void name_effects(struct dem *d)
{
    const struct dem_recipe *const r = &d->parts.recipe;

    memcpy(d->heading, "effects: ", DEM_HEADING + 1);
    d->in_fluid[0] = '\0';
    for (int k = 0; k < r->chosen; k++)
    {
        name(d->heading + DEM_HEADING, sizeof d->heading - DEM_HEADING, r->effect[k]->name);
        if (r->effect[k]->stage == DEM_STAGE_FLUID)
        {
            name(d->in_fluid, sizeof d->in_fluid, r->effect[k]->name);
        }
    }
}

static int read_scene(struct dem *d)
{
    struct dem_parts *const p = &d->parts;

    DEM_TRY(dem_scene_read_materials(d->dict, &p->recipe));
    DEM_TRY(dem_door_take_walls(d));
    DEM_TRY(dem_scene_read(&d->scene, d->dict, &p->recipe, &p->walls, &p->domain));
    DEM_TRY(dem_door_take_patches(d));
    if (d->scene.snapshot && !d->load[0])
    {
        DEM_TRY(dem_load(d, d->scene.snapshot));
        d->new = 1;
    }
    p->watch.limit = d->scene.most_overlap;
    p->watch.most_speed = d->scene.most_speed;
    DEM_TRY(decide_fluid(d));
    name_effects(d);
    return dem_door_examine(d);
}

int dem_door_together(const struct dem *d, int status)
{
    return together(&d->parts, status);
}

/* What had been sampled when the snapshot was written; particles that a scene starts with bring no means. */
static int resume_means(struct dem *d)
{
    void *bytes;
    size_t size;

    if (!d->load[0] || d->new || d->parts.averages.grids == 0 || d->parts.pieces.rank > 0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_snapshot_read_beside(d->load, &bytes, &size));
    const int status = dem_averages_resume(&d->parts.averages, d->load, bytes, size);

    dem_memory_free(bytes);
    return status;
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
    DEM_TRY(together(&d->parts, dem_door_start_particles(d)));
    dem_orientation_begin(&d->parts.particles);
    DEM_TRY(together(&d->parts, prepare_physics(d)));
    if (d->scene.fluid.given || !d->load[0])
    {
        dem_door_fill_fluid(d);
    }
    if (d->energy)
    {
        DEM_TRY(dem_ledger_open(&d->parts.ledger, &d->parts.recipe));
    }
    DEM_TRY(together(&d->parts, dem_door_begin_flows(d)));
    DEM_TRY(together(&d->parts, settle_in(d)));
    if (d->energy)
    {
        DEM_TRY(together(&d->parts, begin_ledger(d)));
    }
    if (d->parts.open)                                    /* laws of drag see the fluid of now */
    {
        dem_bodies_open_laws(&d->parts.particles, &d->parts.recipe.bodies);
    }
    for (int k = 0; k < d->scene.averages; k++)
    {
        d->scene.average[k].says = d->heading;
    }
    DEM_TRY(dem_averages_init(&d->parts.averages, d->scene.average, d->scene.averages, d->parts.time, d->parts.pieces.rank == 0));
    DEM_TRY(together(&d->parts, resume_means(d)));
    dem_phases_begin(&d->parts.phases, d->parts.rebuilds, d->parts.prunes);
    d->parts.halo.refreshed = d->parts.halo.in.sent = (struct dem_traffic){0, 0};
    d->ready = 1;
    return DEM_OK;
}
