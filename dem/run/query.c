/*
 * query.c -- public queries: version, time step, totals, energy, walls, losses, flows, bonds,
 * particles, averages.
 *
 * Queries change no result of the simulation.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "dem_tables.h"
#include "device/device_steps.h"
#include "core/error.h"
#include "core/memory.h"
#include "records/cell_stress.h"
#include "records/totals.h"
#include "records/virial.h"
#include "run/effects_table.h"
#include "ranks/collect.h"
#include "sources/residence.h"
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

const char *dem_version(void)
{
    return DEM_VERSION;
}

struct dem_step_limit dem_step_limit(const struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

    if (d->step <= 0.0)
    {
        return (struct dem_step_limit){.why = ""};
    }
    struct dem_step_limit s = {.limit = r->step_limit, .used = d->step};

    snprintf(s.why, sizeof s.why, "%s", r->why);
    return s;
}

static int way_of(const struct dem_snapshot_flow *f)
{
    return f->kind == DEM_FLOW_OUTLET ? DEM_FLOW_WAY_OUT
         : f->kind == DEM_FLOW_FORTH  ? DEM_FLOW_WAY_FORTH
         : f->kind == DEM_FLOW_BACK   ? DEM_FLOW_WAY_BACK
                                      : DEM_FLOW_WAY_IN;
}

int dem_totals(struct dem *d, struct dem_totals *t)
{
    const struct dem_flows *const f = d->state.flows;
    fenv_t caller;

    feholdexcept(&caller);    /* a number that is not finite is for the caller to find, not a trap */
    dem_totals_tally(&d->state, t);
    fesetenv(&caller);
    for (int k = 0; k < f->n; k++)
    {
        const int way = way_of(&f->flow[k]);

        t->inserted += way == DEM_FLOW_WAY_IN ? f->flow[k].count : 0;
        t->removed += way == DEM_FLOW_WAY_OUT ? f->flow[k].count : 0;
    }
    return dem_collect_status(&d->state.decomposition);
}

void dem_start_overlap(const struct dem *d, struct dem_start_overlap *s)
{
    const struct dem_overlap *const wall = &d->start_wall;

    *s = (struct dem_start_overlap){.particles = d->start_pair.fraction,
                                    .wall = wall->fraction,
                                    .id = wall->id,
                                    .name = ""};
    if (wall->fraction > 0.0)
    {
        memcpy(s->position, wall->x, sizeof s->position);
        s->name = dem_wall_name(d, (int)wall->partner);
    }
}

int dem_energy(struct dem *d, double *since, int *n, const struct dem_energy_item **item)
{
    DEM_REQUIRE(d->state.energy_balance->open, DEM_ERROR_STATE,
                "dem_energy: the run keeps no energy balance; call dem_case_enable_energy before "
                "dem_start");
    dem_energy_balance_report(&d->state);
    *since = d->state.energy_balance->since;
    *n = d->state.energy_balance->items;
    *item = d->state.energy_balance->item;
    return dem_collect_status(&d->state.decomposition);
}

const struct dem_residence *dem_residence(const struct dem *d, int k)
{
    return k >= 0 && k < d->state.flows->n ? dem_residence_of(d->state.flows, k) : NULL;
}

int dem_has_cell(const struct dem *d)
{
    return d->state.cell.active;
}

int dem_cell(struct dem *d, struct dem_cell_now *now)
{
    struct dem_cell_measured m;

    DEM_REQUIRE(d->state.cell.active, DEM_ERROR_STATE,
                "dem_cell: the scene has no cell that deforms; add domain/cell");
    dem_cell_measure(&d->state, &m);
    *now = (struct dem_cell_now){.solid = m.solid/m.volume, .contacts = m.contacts};
    memcpy(now->length, d->state.domain.length, sizeof now->length);
    memcpy(now->rate, d->state.cell.flow, sizeof now->rate);
    now->shear_rate = d->state.cell.shear_flow;
    now->shear = d->state.cell.strain;
    memcpy(now->stress, m.stress, sizeof now->stress);
    memcpy(now->fabric, m.fabric, sizeof now->fabric);
    memcpy(now->modulus, m.modulus, sizeof now->modulus);
    return dem_collect_status(&d->state.decomposition);
}

int dem_count_moving(struct dem *d, double energy, int64_t *n)
{
    *n = dem_totals_moving(&d->state, energy);
    return dem_collect_status(&d->state.decomposition);
}

int dem_hash(struct dem *d, uint64_t *hash)
{
    DEM_TRY(dem_device_return_contacts(&d->state, 1));
    *hash = dem_totals_fingerprint(&d->state);
    return dem_collect_status(&d->state.decomposition);
}

int dem_snapshot_hash(const char *path, uint64_t *hash)
{
    return dem_snapshot_fingerprint(path, hash);
}

int dem_wall_count(const struct dem *d)
{
    return d->state.walls.walls;
}

static int is_wall(const struct dem *d, int wall)
{
    return wall >= 0 && wall < d->state.walls.walls;
}

const char *dem_wall_name(const struct dem *d, int wall)
{
    return is_wall(d, wall) ? d->state.walls.wall[wall].name : "";
}

/* A number from outside; `call` needs it. */
static int require_wall(const struct dem *d, int wall, const char *call)
{
    DEM_REQUIRE(is_wall(d, wall), DEM_ERROR_INPUT,
                "%s: there is no wall %d; the scene has %d, numbered from 0", call, wall,
                d->state.walls.walls);
    return DEM_OK;
}

int dem_wall_load(struct dem *d, int wall, double force[3], double torque[3])
{
    DEM_TRY(require_wall(d, wall, "dem_wall_load"));
    DEM_TRY(d->state.contacts_on_device ? dem_sim_agree(d, dem_device_save_wall_forces(&d->state)) : DEM_OK);
    dem_totals_wall_force(&d->state, wall, force, torque);
    return dem_collect_status(&d->state.decomposition);
}

int dem_lost(struct dem *d, int64_t *n, const struct dem_loss **loss)
{
    DEM_TRY(dem_lost_particles_collect(d->state.lost_particles, &d->state.decomposition, n));
    *loss = d->state.lost_particles->all;
    return DEM_OK;
}

/* The number of particles of a stream that are due. What a stream by mass is behind, in kg, is
   counted in particles of mean mass. The limit is what its total count and mass still allow. */
static int64_t count_waiting(const struct dem *d, int k)
{
    const struct dem_stream *const s = &d->scene.streams.stream[k];
    const struct dem_snapshot_flow *const row = &d->state.flows->flow[k];
    const double due = d->state.flows->waiting[k];
    const double each = dem_stream_mean_mass(s, &d->state.interaction_table);
    const double max = fmin((double)(s->count - row->count), (s->mass - row->mass)/each + 0.5);

    return (int64_t)floor(fmax(0.0, fmin(s->by_mass ? due/each : due, fmin(max, 0x1p62))) + 1e-9);
}

int dem_flows(struct dem *d, int *n, const struct dem_flow **flow)
{
    const struct dem_flows *const f = d->state.flows;

    *n = f->n > 0 && !d->state.domain.remove ? f->n - 1 : f->n;
    for (int k = 0; k < *n; k++)
    {
        const struct dem_snapshot_flow *const row = &f->flow[k];

        d->flow[k] =
            (struct dem_flow){.name = row->name,
                              .enters = way_of(row),
                              .particles = row->count,
                              .mass = row->mass,
                              .momentum = {row->momentum[0], row->momentum[1], row->momentum[2]},
                              .energy = row->energy};
        d->flow[k].waiting = d->flow[k].enters == DEM_FLOW_WAY_IN ? count_waiting(d, k) : 0;
    }
    *flow = d->flow;
    return DEM_OK;
}

int dem_has_bonds(const struct dem *d)
{
    const struct dem_interaction_table *const r = &d->state.interaction_table;

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
    /* after a load or restore there are no lists before the first step */
    if (d->state.lists_state == DEM_NEIGHBORS_NONE)
    {
        *n = 0;
        *bond = NULL;
        return DEM_OK;
    }
    DEM_TRY(dem_bonds_list(&d->state, n));
    *bond = d->state.bonds->intact;
    return DEM_OK;
}

int dem_broken_bonds(struct dem *d, int64_t *n, const struct dem_broken_bond **broken)
{
    DEM_TRY(dem_bonds_collect(d->state.bonds, &d->state.decomposition, n));
    *broken = d->state.bonds->all;
    return DEM_OK;
}

const char *dem_broken_bond_cause(int cause)
{
    static const char *const causes[] = {"unknown", "tension", "shear", "distance"};

    return causes[cause > 0 && cause < (int)(sizeof causes/sizeof causes[0]) ? cause : 0];
}

int dem_bonds_draw(struct dem *d, const char *folder, const char *file, double time)
{
    return dem_sim_agree(d, dem_bonds_write_lines(&d->state, d->heading, folder, file, time));
}

int dem_wall_impulse_reset(struct dem *d)
{
    return dem_wall_statistics_begin(d->state.wall_statistics, d->state.walls.walls);
}

int dem_wall_impulse(struct dem *d, int wall, double impulse[3], double angular_impulse[3])
{
    DEM_TRY(require_wall(d, wall, "dem_wall_impulse"));
    DEM_REQUIRE(d->state.wall_statistics->sum, DEM_ERROR_STATE,
                "dem_wall_impulse comes after dem_wall_impulse_reset");
    dem_totals_wall_impulse(&d->state, wall, impulse, angular_impulse);
    return dem_collect_status(&d->state.decomposition);
}

void dem_wall_info(const struct dem *d, int wall, struct dem_wall_info *f)
{
    *f = (struct dem_wall_info){0};
    if (!is_wall(d, wall))
    {
        return;
    }
    const struct dem_wall *const w = &d->state.walls.wall[wall];

    *f = (struct dem_wall_info){.triangles = (int64_t)w->triangles,
                                .flat = (int64_t)w->flat,
                                .repeats = (int64_t)w->repeats,
                                .moves = w->frame >= 0,
                                .passes = w->there[0] > -INFINITY || w->there[1] < INFINITY
                                       || w->there_stage[1] > 0,
                                .absent = w->absent};
}

int dem_wall_corners(struct dem *d, int wall, double *corners)
{
    DEM_TRY(require_wall(d, wall, "dem_wall_corners"));
    return dem_wall_store_corners(&d->state.wall_store, &d->state.walls, wall, corners);
}

void dem_view(const struct dem *d, struct dem_view *v)
{
    const struct dem_material *const m = d->state.interaction_table.material;

    dem_particles_view(&d->state.particles, d->state.domain.length, v);
    v->density = v->clump ? &m->density : NULL;
    v->density_stride = sizeof *m;
}

int dem_view_leave(struct dem *d, struct dem_view_arrays *was)
{
    *was = (struct dem_view_arrays){NULL, NULL, NULL, NULL};
    return d->state.particles.record ? dem_particles_leave(&d->state.particles, was) : DEM_OK;
}

void dem_view_free(void *array)
{
    dem_memory_free(array);
}

int dem_virial(struct dem *d, double *virial)
{
    DEM_REQUIRE(d->state.contacts.forces.all_rows, DEM_ERROR_STATE,
                "dem_virial: the run keeps no contact forces; call dem_case_enable_virial before "
                "dem_start");
    memset(virial, 0, 6*d->state.particles.n*sizeof *virial);
    /* after a load, a restore or a step that failed there are no lists */
    if (d->state.lists_state != DEM_NEIGHBORS_NONE && d->state.contacts.rows.n > 0)
    {
        dem_virial_sum(&d->state, virial);
    }
    return DEM_OK;
}

const char *dem_material_name(const struct dem *d, int material)
{
    return material >= 0 && material < d->state.interaction_table.materials
             ? d->state.interaction_table.material[material].name
             : "";
}

int dem_averages_count(const struct dem *d)
{
    return d->scene.averages;
}

int dem_effects_record(const struct dem *d, const char *folder, double start)
{
    return dem_effects_table_begin(folder, start, dem_effect_names(d));
}

int dem_averages(struct dem *d, const char *folder)
{
    fenv_t caller;

    feholdexcept(&caller);    /* squares of samples may overflow */
    const int status = dem_grid_averages_write(d->state.averages, &d->state, folder);

    fesetenv(&caller);
    return status;
}

const struct dem_dict *dem_scene_dict(const struct dem *d)
{
    return d->dict;
}

const char *dem_heading(const struct dem *d)
{
    return d->heading;
}

const char *dem_effect_names(const struct dem *d)
{
    return d->heading + DEM_HEADING;
}

const char *dem_fluid_effect_names(const struct dem *d)
{
    return d->fluid_effects;
}

int dem_gravity_acceleration(const struct dem *d, double g[3])
{
    return dem_interaction_table_gravity(&d->state.interaction_table, g) != NULL;
}
