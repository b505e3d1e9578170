/*
 * stages_check.c -- what is refused of stages before the run: rest without gravity, and loads on walls
 * that the stage can never meet.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "case/dem_case.h"
#include "case/stages.h"
#include "core/error.h"
#include "core/vec.h"
#include <math.h>

/* Stages follow each other: what begins with a later one than stage k is not there before k has ended,
   what ends with k or an earlier one is gone. */
static int check_load(const struct dem *d, int k)
{
    const struct dem_run_stages *const s = &d->scene.stages;
    const struct dem_run_stage *const now = &s->stage[k];
    const struct dem_wall *const w = &d->state.walls.wall[now->wall_index];
    const struct dem_wall_body *const b = dem_walls_body(&d->state.walls, now->wall_index);
    const int from = w->there_stage[0], until = w->there_stage[1], number = k + 1;
    /* its own force is waited for, which only the servo itself can bring about */
    const int servo = b && b->kind == DEM_WALL_BODY_SERVO && !b->table
                   && now->load == fabs(b->force[0]*b->area);

    DEM_REQUIRE(from <= number, DEM_ERROR_INPUT,
                "stages/%s waits for a force on wall %s, which comes only with stages/%s, so that it never "
                "ends; let the wall come earlier, or give atMost", now->name, w->name, s->stage[from - 1].name);
    DEM_REQUIRE(until == 0 || until > number, DEM_ERROR_INPUT,
                "stages/%s waits for a force on wall %s, which goes with stages/%s, so that it never ends; let "
                "the wall go later, or give atMost", now->name, w->name, s->stage[until - 1].name);
    DEM_REQUIRE(!servo || b->stage[0] <= number, DEM_ERROR_INPUT,
                "stages/%s waits for a force on wall %s, whose servo starts only with stages/%s, so that it "
                "never ends; let the servo start earlier, or give atMost", now->name, w->name,
                s->stage[b->stage[0] - 1].name);
    return DEM_OK;
}

int dem_stages_check(const struct dem *d)
{
    const struct dem_run_stages *const s = &d->scene.stages;
    double g[3];

    dem_interaction_table_gravity(&d->state.interaction_table, g);
    for (int k = 0; k < s->n; k++)
    {
        const struct dem_quiet *const q = &s->stage[k].quiet;

        DEM_REQUIRE(s->stage[k].until != DEM_UNTIL_QUIET || dem_vec_norm(g) > 0.0
                        || (q->speed > 0.0 && q->lasting > 0.0), DEM_ERROR_INPUT,
                    "stages/%s: rest is compared with the energy of falling by a diameter, but there "
                    "is no gravity; give until { speed; lasting; }, or add gravity", s->stage[k].name);
    }
    for (int k = 0; k < s->n; k++)
    {
        DEM_TRY(s->stage[k].until == DEM_UNTIL_LOAD && !isfinite(s->stage[k].at_most) ? check_load(d, k)
                                                                                      : DEM_OK);
    }
    return DEM_OK;
}
