/*
 * check.c -- what can be told of a scene before its particles are placed, which may take long: words that nobody reads,
 * effects that lack something, walls without an area, a time step that is too long, groups outside the domain.
 *
 * The radii are known from the words, and with them the recipe is frozen and the walls are finished. A snapshot brings radii
 * of its own: then both wait until it has been read (ready.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include <float.h>
#include <math.h>

static int choose_step(struct dem *d)
{
    const struct dem_recipe *const r = &d->parts.recipe;

    d->step = d->parts.longest_step = d->scene.step > 0.0 ? d->scene.step : r->step_limit;
    DEM_REQUIRE(d->scene.step <= r->step_limit || d->scene.force, DEM_ERROR_INPUT,
                "time step %g s exceeds %.3g s (%s); use at most that, a softer material, or time/force yes", d->scene.step,
                r->step_limit, r->why);
    DEM_REQUIRE(d->step > DBL_MIN, DEM_ERROR_INPUT, "the time step is %g s (%s); look at materials, diameters and settings, one of "
                "which is far from any real one", d->step, d->scene.step > 0.0 ? "time/step" : r->why);
    DEM_REQUIRE(d->step < DBL_MAX, DEM_ERROR_INPUT, "no effect bounds the time step; give time/step");
    return DEM_OK;
}

/* Who is wider than a periodic domain lets him would reach himself (space/pairs.c refuses it in a snapshot). */
static int check_widths(const struct dem *d, double radius)
{
    const struct dem_domain *const box = &d->parts.domain;
    const double least = 2.0*radius*(1.0 + d->scene.outer_skin) + d->parts.recipe.reach;

    for (int k = 0; k < 3; k++)
    {
        DEM_REQUIRE(!box->periodic[k] || box->length[k] >= least, DEM_ERROR_INPUT,
                    "domain: periodic along %c and %g m wide, so that a particle of %g m reaches its own periodic image; make the domain at "
                    "least two diameters and a skin wide", "xyz"[k], box->length[k], 2.0*radius);
    }
    return DEM_OK;
}

int dem_door_settle_physics(struct dem *d)
{
    struct dem_parts *const p = &d->parts;
    int wall_materials[DEM_MATERIALS] = {0};
    const double radius = dem_door_most_radius(d);

    for (int w = 0; w < p->walls.walls; w++)
    {
        wall_materials[p->walls.wall[w].material] = 1;
    }
    DEM_TRY(dem_recipe_freeze(&p->recipe, wall_materials));
    DEM_TRY(choose_step(d));
    DEM_TRY(check_widths(d, radius));
    DEM_TRY(dem_walls_finish(&p->walls, radius > 0.0 ? radius : 1.0));
    return dem_domain_check_walls(&p->domain, &p->walls, radius);
}

double dem_door_most_radius(const struct dem *d)
{
    double most = 0.0;

    for (int m = 0; m < DEM_MATERIALS; m++)
    {
        most = fmax(most, d->parts.recipe.most_radius[m]);
    }
    return most;
}

/* Those that the scene inserts, and those that were handed in. */
static int learn_radii(struct dem *d)
{
    struct dem_recipe *const r = &d->parts.recipe;
    int m;

    dem_insert_radii(&d->scene.insertion, r->least_radius, r->most_radius);
    dem_streams_radii(&d->scene.streams, r->least_radius, r->most_radius);
    for (size_t k = 0; k < d->crowd.n; k++)
    {
        const double radius = d->crowd.particle[k].radius;

        DEM_TRY(dem_recipe_material(r, d->crowd_material[k], "dem_add_particles", &m));
        r->least_radius[m] = r->least_radius[m] > 0.0 ? fmin(r->least_radius[m], radius) : radius;
        r->most_radius[m] = fmax(r->most_radius[m], radius);
    }
    return DEM_OK;
}

/* Without particles from elsewhere the ids are those of the text. */
static int check_bonds(const struct dem *d)
{
    const int64_t *const id = d->scene.bond_ids, n = dem_insert_next_id(&d->scene.insertion);

    for (size_t k = 0; k + 1 < d->scene.bond_id_count && d->crowd.n == 0; k += 2)
    {
        DEM_REQUIRE(id[k] < n && id[k + 1] < n, DEM_ERROR_INPUT, "bonds/pairs: %lld and %lld, but the scene has ids below %lld only; "
                    "correct the list", (long long)id[k], (long long)id[k + 1], (long long)n);
    }
    return DEM_OK;
}

int dem_door_examine(struct dem *d)
{
    DEM_TRY(dem_dict_refuse_unread(d->dict));
    DEM_REQUIRE(!d->energy || !d->parts.recipe.mixed, DEM_ERROR_INPUT, "the ledger of energy counts what single precision loses as lost or "
                "gained; use time/precision double, or no ledger (write/energy)");
    DEM_TRY(dem_streams_inside(&d->scene.streams, &d->parts.domain));
    if (d->load[0])
    {
        return DEM_OK;
    }
    DEM_TRY(check_bonds(d));
    DEM_TRY(dem_insert_inside(&d->scene.insertion, &d->parts.domain));
    DEM_TRY(learn_radii(d));
    return dem_door_settle_physics(d);
}
