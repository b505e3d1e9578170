/*
 * look.c -- what a program may see of a run: step, tallies, books, walls, bonds, particles, means.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "door.h"
#include "base/error.h"
#include "plan/marginal.h"
#include "plan/profile.h"
#include "step/measure.h"
#include "step/profile.h"
#include "step/virial.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct dem_step_limit dem_step_limit(const struct dem *d)
{
    struct dem_step_limit s = {.limit = d->parts.recipe.step_limit, .used = d->step};

    snprintf(s.why, sizeof s.why, "%s", d->parts.recipe.why);
    return s;
}

int dem_tally(struct dem *d, struct dem_tally *t)
{
    dem_measure_tally(&d->parts, t);
    return DEM_OK;
}

int dem_profile(struct dem *d, struct dem_profile *profile)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_profile comes after dem_ready");
    dem_profile_take(&d->parts, profile);
    return DEM_OK;
}

int dem_profile_text(struct dem *d, const char **text)
{
    struct dem_profile profile;

    DEM_TRY(dem_profile(d, &profile));
    dem_text_free(&d->profile);
    DEM_TRY(dem_profile_write(&d->profile, &profile));
    *text = d->profile.text;
    return DEM_OK;
}

int dem_contacts_watch(struct dem *d)
{
    DEM_TRY(dem_door_early(d, "dem_contacts_watch"));
    d->parts.durations.asked = 1;
    return DEM_OK;
}

int dem_orientation_watch(struct dem *d)
{
    DEM_TRY(dem_door_early(d, "dem_orientation_watch"));
    d->turned = 1;
    return DEM_OK;
}

int dem_energy_watch(struct dem *d)
{
    DEM_TRY(dem_door_early(d, "dem_energy_watch"));
    d->energy = 1;
    return DEM_OK;
}

int dem_energy(struct dem *d, double *since, int *n, const struct dem_energy_item **item)
{
    DEM_REQUIRE(d->ready && d->energy, DEM_ERROR_STATE, "dem_energy comes after dem_ready, and dem_energy_watch before it");
    dem_ledger_tell(&d->parts);
    *since = d->parts.ledger.since;
    *n = d->parts.ledger.items;
    *item = d->parts.ledger.item;
    return DEM_OK;
}

int dem_moving(struct dem *d, double energy, int64_t *n)
{
    *n = dem_measure_moving(&d->parts, energy);
    return DEM_OK;
}

int dem_hash(struct dem *d, uint64_t *hash)
{
    *hash = dem_measure_hash(&d->parts);
    return DEM_OK;
}

int dem_wall_count(const struct dem *d)
{
    return d->parts.walls.walls;
}

const char *dem_wall_name(const struct dem *d, int wall)
{
    return d->parts.walls.wall[wall].name;
}

int dem_wall_load(struct dem *d, int wall, double force[3], double torque[3])
{
    DEM_REQUIRE(wall >= 0 && wall < d->parts.walls.walls, DEM_ERROR_INPUT, "wall %d; there are %d", wall, d->parts.walls.walls);
    dem_measure_wall(&d->parts, wall, force, torque);
    return DEM_OK;
}

int dem_lost(struct dem *d, int64_t *n, const struct dem_loss **loss)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_lost comes after dem_ready");
    DEM_TRY(dem_losses_tell(&d->parts.losses, &d->parts.pieces, n));
    *loss = d->parts.losses.all;
    return DEM_OK;
}

/* Kilograms that wait are so many particles of mean mass; no more wait than may still come. */
static int64_t waiting(const struct dem *d, int k)
{
    const struct dem_stream *const s = &d->scene.streams.stream[k];
    const struct dem_snapshot_flow *const row = &d->parts.flows.flow[k];
    const double owed = d->parts.flows.waiting[k], each = dem_stream_mean_mass(s, &d->parts.recipe);
    const double most = fmin((double)(s->count - row->count), (s->mass - row->mass)/each + 0.5);

    return (int64_t)floor(fmax(0.0, fmin(s->by_mass ? owed/each : owed, fmin(most, 0x1p62))) + 1e-9);
}

int dem_flows(struct dem *d, int *n, const struct dem_flow **flow)
{
    const struct dem_flows *const f = &d->parts.flows;

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_flows comes after dem_ready");
    *n = f->n > 0 && !d->parts.domain.remove ? f->n - 1 : f->n;
    for (int k = 0; k < *n; k++)
    {
        const struct dem_snapshot_flow *const row = &f->flow[k];

        d->flow[k] = (struct dem_flow){.name = row->name, .enters = row->kind != DEM_FLOW_OUTLET, .particles = row->count, .mass = row->mass,
                                       .momentum = {row->momentum[0], row->momentum[1], row->momentum[2]}, .energy = row->energy};
        d->flow[k].waiting = d->flow[k].enters ? waiting(d, k) : 0;
    }
    *flow = d->flow;
    return DEM_OK;
}

int dem_has_bonds(const struct dem *d)
{
    const struct dem_recipe *const r = &d->parts.recipe;

    for (int k = 0; k < r->chosen; k++)
    {
        if (r->effect[k]->stage == DEM_STAGE_BOND)
        {
            return 1;
        }
    }
    return 0;
}

int dem_bonds(struct dem *d, int64_t *n, const struct dem_bond **bond)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_bonds comes after dem_ready");
    if (d->parts.stale == 2)                              /* a snapshot just read: no lists yet */
    {
        *n = 0;
        return DEM_OK;
    }
    DEM_TRY(dem_bonds_list(&d->parts, n));
    *bond = d->parts.bonds.hold;
    return DEM_OK;
}

int dem_broken_bonds(struct dem *d, int64_t *n, const struct dem_break **broke)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_broken_bonds comes after dem_ready");
    DEM_TRY(dem_bonds_tell(&d->parts.bonds, &d->parts.pieces, n));
    *broke = d->parts.bonds.all;
    return DEM_OK;
}

const char *dem_break_cause(int cause)
{
    static const char *const causes[] = {"unknown", "tension", "shear", "distance"};

    return causes[cause > 0 && cause < (int)(sizeof causes/sizeof causes[0]) ? cause : 0];
}

int dem_bonds_draw(struct dem *d, const char *folder, const char *file, double time)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_bonds_draw comes after dem_ready");
    return dem_door_together(d, dem_bonds_lines(&d->parts, d->heading, folder, file, time));
}

int dem_wall_watch(struct dem *d)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_wall_watch comes after dem_ready");
    return dem_wall_books_open(&d->parts.books, d->parts.walls.walls);
}

int dem_wall_impulse(struct dem *d, int wall, double impulse[3], double twist[3])
{
    DEM_REQUIRE(d->parts.books.sum, DEM_ERROR_STATE, "dem_wall_impulse comes after dem_wall_watch");
    DEM_REQUIRE(wall >= 0 && wall < d->parts.walls.walls, DEM_ERROR_INPUT, "wall %d; there are %d", wall, d->parts.walls.walls);
    dem_measure_impulse(&d->parts, wall, impulse, twist);
    return DEM_OK;
}

void dem_wall_facts(const struct dem *d, int wall, struct dem_wall_facts *f)
{
    const struct dem_wall *const w = &d->parts.walls.wall[wall];

    *f = (struct dem_wall_facts){.triangles = (int64_t)w->triangles, .flat = (int64_t)w->flat, .repeats = (int64_t)w->repeats,
                                 .moves = w->moving >= 0};
}

void dem_wall_corners(const struct dem *d, int wall, double *corners)
{
    const struct dem_walls *const w = &d->parts.walls;
    const int moving = w->wall[wall].moving;

    for (size_t t = 0; t < w->triangles; t++)
    {
        for (int k = 0; k < 3 && w->triangle[t].wall == wall; k++, corners += 3)
        {
            memcpy(corners, w->triangle[t].corner[k], 3*sizeof *corners);
            if (moving >= 0)
            {
                dem_pose_point(&w->moving[moving].pose, w->triangle[t].corner[k], corners);
            }
        }
    }
}

void dem_view(const struct dem *d, struct dem_view *v)
{
    const struct dem_particles *const p = &d->parts.particles;
    const struct dem_particle *const r = p->record;

    *v = (struct dem_view){.n = p->n, .stride = sizeof *r, .position = r->x, .velocity = r->v, .spin = r->w, .radius = &r->radius,
                           .mass = &r->mass, .id = &r->id, .material = &r->material, .flags = &r->flags,
                           .force = dem_column(p, DEM_COLUMN_FORCE), .torque = dem_column(p, DEM_COLUMN_TORQUE),
                           .orientation = dem_column(p, DEM_COLUMN_ORIENTATION)};
}

int dem_virial(struct dem *d, double *virial)
{
    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_virial comes after dem_ready");
    memset(virial, 0, 6*d->parts.particles.n*sizeof *virial);
    if (d->parts.stale < 2)                               /* a loaded state has no rows until its first step */
    {
        dem_virial_sum(&d->parts, virial);
    }
    return DEM_OK;
}

const char *dem_material_name(const struct dem *d, int material)
{
    return material >= 0 && material < d->parts.recipe.materials ? d->parts.recipe.material[material].name : "";
}

int dem_averages_count(const struct dem *d)
{
    return d->scene.averages;
}

int dem_averages(struct dem *d, const char *folder)
{
    fenv_t caller;

    feholdexcept(&caller);                                /* squares of what the caller's particles did may be past the largest number */
    const int status = dem_averages_save(&d->parts.averages, &d->parts, folder);

    fesetenv(&caller);
    return status;
}

/* ---- what an effect takes -------------------------------------------------------------------------------------- */

int dem_marginal(struct dem *d, const char *effect, double seconds, struct dem_marginal *m)
{
    struct dem_survey survey;

    DEM_REQUIRE(d->ready, DEM_ERROR_STATE, "dem_marginal comes after dem_ready");
    dem_survey_take(&d->parts, &survey);
    return dem_marginal_take(&d->parts, &survey, d->step, effect, seconds, m);
}
