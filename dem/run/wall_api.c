/*
 * wall_api.c -- public calls for walls that move: where they are, and the loads of those that are moved
 * by force.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/simulation.h"
#include "core/error.h"
#include "dem_query.h"
#include "ranks/collect.h"
#include "records/totals.h"
#include "records/wall_wear.h"
#include "walls/wall_rotation.h"
#include <math.h>
#include <string.h>

void dem_wall_position(const struct dem *d, int wall, struct dem_wall_position *p)
{
    const struct dem_walls *const w = &d->state.walls;
    struct dem_pose pose = dem_pose_identity;

    *p = (struct dem_wall_position){.axes = 0};
    if (wall < 0 || wall >= w->walls)
    {
        return;
    }
    const struct dem_wall_body *const b = dem_walls_body(w, wall);

    if (w->wall[wall].frame >= 0)
    {
        dem_wall_frame_pose(&w->frame[w->wall[wall].frame], d->state.time, &pose);
    }
    memcpy(p->rotation, pose.rotation, sizeof p->rotation);
    memcpy(p->shift, pose.shift, sizeof p->shift);
    p->axes = b ? b->axes : 0;
    for (int k = 0; k < p->axes; k++)
    {
        p->moved[k] = b->state.q[k];
        p->velocity[k] = b->state.v[k];
    }
    if (b && b->rotation.axes > 0)
    {
        dem_wall_rotation_spin(b, p->spin);
    }
}

int dem_wall_set_load(struct dem *d, const char *name, const double load[3])
{
    const struct dem_walls *const w = &d->state.walls;
    const int wall = dem_walls_named(w, name);
    struct dem_wall_body *const b = wall < w->walls ? dem_walls_body(w, wall) : NULL;

    DEM_REQUIRE(b, DEM_ERROR_INPUT,
                "dem_wall_set_load: there is no wall %s that is moved by force; give it a motion of type "
                "free, hinge or servo", name);
    if (!load)
    {
        b->state.loaded = 0.0;
        return DEM_OK;
    }
    DEM_REQUIRE(isfinite(load[0]) && isfinite(load[1]) && isfinite(load[2]), DEM_ERROR_NUMBER,
                "dem_wall_set_load: the load (%g %g %g) of wall %s is not a number", load[0], load[1],
                load[2], name);
    memcpy(b->state.load, load, sizeof b->state.load);
    b->state.loaded = 1.0;
    return DEM_OK;
}

static int require(const struct dem *d, int wall, const char *call)
{
    DEM_REQUIRE(wall >= 0 && wall < d->state.walls.walls, DEM_ERROR_INPUT,
                "%s: wall %d, but there are %d; numbers begin at 0", call, wall, d->state.walls.walls);
    return DEM_OK;
}

int dem_wall_work(struct dem *d, int wall, double *work)
{
    DEM_TRY(require(d, wall, "dem_wall_work"));
    DEM_REQUIRE(d->state.wall_statistics->sum, DEM_ERROR_STATE,
                "dem_wall_work comes after dem_wall_impulse_reset");
    *work = dem_totals_wall_work(&d->state, wall);
    return dem_collect_status(&d->state.decomposition);
}

int dem_wall_axis(const struct dem *d, int wall, double origin[3], double axis[3])
{
    const int known = wall >= 0 && wall < d->state.walls.walls;

    memset(origin, 0, 3*sizeof *origin);
    memset(axis, 0, 3*sizeof *axis);
    axis[2] = 1.0;
    return known && dem_walls_axis(&d->state.walls, wall, origin, axis);
}

int dem_wall_wears(const struct dem *d, int wall)
{
    return wall >= 0 && wall < d->state.walls.walls && d->state.walls.wall[wall].wear > 0.0;
}

int dem_wall_wear(struct dem *d, int wall, double *volume)
{
    DEM_TRY(require(d, wall, "dem_wall_wear"));
    return dem_wall_wear_volumes(&d->state, wall, volume);
}
