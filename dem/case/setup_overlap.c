/*
 * setup_overlap.c -- overlaps at the start: a large one is an error in the input, not a contact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "case/restart.h"
#include "core/error.h"
#include "core/memory.h"
#include "ranks/collect.h"
#include "records/totals.h"
#include "step/neighbor_rebuild.h"
#include <math.h>

static const char of_group[] = "place its group by \"inside walls;\", ";

/* `flags`: of particles with one of them only; 0: of all. `cure`: one more, for particles of a group. */
static int refuse(struct dem_state *state, double limit, unsigned flags, const char *cure)
{
    struct dem_overlap pair, wall;

    dem_totals_max_overlap(state, flags, NULL, &pair, &wall);
    DEM_REQUIRE(wall.fraction <= limit || wall.fraction <= pair.fraction,
                DEM_ERROR_INPUT,
                "particle %lld at (%g %g %g) m overlaps wall %s by %.3g of a diameter at the "
                "start, the limit is %g; move it, %sor raise time/maxStartOverlap",
                (long long)wall.id, wall.x[0], wall.x[1], wall.x[2],
                state->walls.wall[wall.partner].name, wall.fraction, limit, cure);
    DEM_REQUIRE(pair.fraction <= limit, DEM_ERROR_INPUT,
                "particles %lld and %lld at (%g %g %g) m overlap by %.3g of a diameter at the "
                "start, the limit is %g; move them apart, or raise time/maxStartOverlap",
                (long long)pair.id, (long long)pair.partner, pair.x[0], pair.x[1], pair.x[2],
                pair.fraction, limit);
    return DEM_OK;
}

int dem_sim_refuse_overlap(struct dem *d)
{
    return refuse(&d->state, d->scene.max_start_overlap, 0, of_group);
}

/* A snapshot that was made in other walls may overlap the walls of this run. A soft bed that
   has settled in the same walls overlaps them too, but not more than its particles overlap each
   other; in a state in motion it may be twice as much. */
static int refuse_other_walls(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const struct dem_overlap *const wall = &d->start_wall, *const pair = &d->start_pair;
    const double limit = fmax(d->scene.max_start_overlap, 2.0*pair->fraction);

    DEM_REQUIRE(wall->fraction <= limit, DEM_ERROR_INPUT,
                "%s: particle %lld at (%g %g %g) m overlaps wall %s by %.3g of a diameter at the "
                "start, the limit is %.3g; the snapshot was made in other walls: settle the "
                "particles in the walls of this run (in an OpenFOAM case: demPimpleFoam -settle) "
                "and start from that snapshot",
                c->load_path, (long long)wall->id, wall->x[0], wall->x[1], wall->x[2],
                d->state.walls.wall[wall->partner].name, wall->fraction, limit);
    return DEM_OK;
}

int dem_sim_with_lists(struct dem *d, int (*look)(struct dem *))
{
    struct dem_state *const state = &d->state;
    const int64_t rebuilds = state->rebuilds, prunes = state->prunes;
    const size_t losses = state->lost_particles->n, broke = state->bonds->n;
    struct dem_backup backup = {.valid = 0};

    dem_flows_backup(state->flows);
    int status = dem_sim_agree(d, dem_backup_save(&backup, &state->particles, &state->contacts,
                                                  state->pairs.wall_facet));

    if (status)
    {
        dem_backup_free(&backup);
        return status;
    }
    status = dem_neighbor_rebuild(state);
    status = dem_collect_agree(&state->decomposition, status ? status : look(d));
    const int restored = dem_backup_restore(&backup, &state->particles, &state->contacts);

    status = status ? status : restored;
    dem_backup_free(&backup);
    state->lists_state = DEM_NEIGHBORS_NONE;
    state->limits.overlap = 0.0;
    dem_flows_restore(state->flows);
    state->lost_particles->n = losses;
    state->bonds->n = broke;
    state->rebuilds = rebuilds;
    state->prunes = prunes;
    return status;
}

static int measure_overlap(struct dem *d)
{
    return dem_totals_max_overlap_over_ranks(&d->state, d->start_walls, &d->start_pair, &d->start_wall);
}

static int refuse_inserted_overlap(struct dem *d)
{
    return refuse(&d->state, d->scene.max_start_overlap, DEM_PARTICLE_NEW, of_group);
}

int dem_sim_refuse_new_overlap(struct dem *d)
{
    return refuse(&d->state, d->scene.max_start_overlap, DEM_PARTICLE_NEW, "");
}

int dem_sim_check_inserted(struct dem_case *c)
{
    struct dem_particles *const p = &c->d->state.particles;

    if (!c->inserts || !c->load_path[0])
    {
        return DEM_OK;
    }
    DEM_TRY(dem_sim_with_lists(c->d, refuse_inserted_overlap));
    for (size_t i = 0; i < p->n; i++)
    {
        p->record[i].flags &= (uint16_t)~DEM_PARTICLE_NEW;
    }
    return DEM_OK;
}

/* Refuse a wall that is new at a restart, or has another form, in the place of particles; only such walls have been
   measured. */
static int refuse_new_walls(const struct dem_case *c)
{
    const struct dem *const d = c->d;
    const struct dem_overlap *const wall = &d->start_wall;
    const double limit = fmax(d->scene.max_start_overlap, 2.0*d->start_pair.fraction);

    DEM_REQUIRE(wall->fraction <= limit, DEM_ERROR_INPUT,
                "wall %s is new in the scene of the restart, or has another form or place, and overlaps particle %lld at "
                "(%g %g %g) m by %.3g of a diameter, the limit is %.3g; move the wall",
                d->state.walls.wall[wall->partner].name, (long long)wall->id, wall->x[0], wall->x[1], wall->x[2],
                wall->fraction, limit);
    return DEM_OK;
}

int dem_sim_check_start(struct dem_case *c)
{
    const int walls = c->d->state.walls.walls;
    int count = 0, status = DEM_OK;
    char *others;

    DEM_TRY(dem_sim_agree(c->d, DEM_NEW(others, walls)));
    for (int k = 0; k < walls; k++)
    {
        others[k] = c->new_run || (c->load_path[0] && !dem_sim_wall_goes_on(c, k));
        count += others[k];
    }
    if (count > 0)
    {
        c->d->start_walls = others;
        status = dem_sim_with_lists(c->d, measure_overlap);
        c->d->start_walls = NULL;
        status = status ? status : c->new_run ? refuse_other_walls(c) : refuse_new_walls(c);
    }
    dem_memory_free(others);
    return status;
}
