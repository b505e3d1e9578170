/*
 * watch.c -- block by block the largest overlap, and numbers that are none; at the end of the sweep a sentence, if need be.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/watch.h"
#include "base/error.h"
#include "base/math.h"
#include "effects/effect.h"
#include <stdio.h>
#include <string.h>

/* Largest overlap of the smaller diameter; a force that is not a number comes out above every limit. */
DEM_KERNEL
static double worst_of(const struct dem_block *restrict b)
{
    double most[DEM_LANES] = {0.0}, bad[DEM_LANES] = {0.0}, worst = 0.0;

    for (int c = 0; c < b->n; c += DEM_LANES)
    {
        for (int k = 0; k < DEM_LANES; k++)
        {
            const double share = 0.5*b->overlap[c + k]/b->least_radius[c + k];

            most[k] = dem_pick(share > most[k], share, most[k]);
            bad[k] += (b->fn[c + k] + b->fx[c + k] + b->fy[c + k] + b->fz[c + k])*0.0;
        }
    }
    for (int k = 0; k < DEM_LANES; k++)
    {
        worst = most[k] > worst ? most[k] : worst;
        worst = bad[k] == 0.0 ? worst : 1e30;
    }
    return worst;
}

void dem_watch_note(struct dem_parts *p, const struct dem_tray *t, uint32_t row, int rows)
{
    const double worst = worst_of(&t->block);
    int lane = 0;

    if (worst <= p->watch.overlap)
    {
        return;
    }
    for (int c = 0; c < t->block.n; c++)
    {
        const double force = t->block.fn[c] + t->block.fx[c] + t->block.fy[c] + t->block.fz[c];

        lane = force*0.0 != 0.0 || 0.5*t->block.overlap[c]/t->block.least_radius[c] == worst ? c : lane;
    }
    const struct dem_pair *const q = &p->contacts.pair[p->contacts.row_pair[row + (uint32_t)(lane < rows ? lane : rows - 1)]];
    const struct dem_particle *const i = &p->particles.record[q->i];

    p->watch.overlap = worst;
    p->watch.i = i->id;
    p->watch.j = q->wall ? -1 - p->pairs.wall_region[q->j] : p->particles.record[q->j].id;
    memcpy(p->watch.x, i->x, sizeof i->x);
}

/* Who touches whom, in words. */
static void culprits(const struct dem_parts *p, char *text, size_t size)
{
    const struct dem_watch *const w = &p->watch;

    if (w->j < 0)
    {
        snprintf(text, size, "particle %lld and wall %s", (long long)w->i, p->walls.wall[p->walls.region[-1 - w->j].wall].name);
    }
    else
    {
        snprintf(text, size, "particles %lld and %lld", (long long)w->i, (long long)w->j);
    }
}

int dem_watch_judge(const struct dem_parts *p)
{
    const struct dem_watch *const w = &p->watch;
    char who[160];

    if (w->overlap <= w->limit)
    {
        return DEM_OK;
    }
    culprits(p, who, sizeof who);
    DEM_REQUIRE(w->overlap < 1e29, DEM_ERROR_NUMBER,
                "the force between %s near (%g %g %g) m is not a number at step %lld; look at their input, or at the fluid "
                "around them", who, w->x[0], w->x[1], w->x[2], (long long)p->steps);
    return dem_error(DEM_ERROR_NUMBER, "%s near (%g %g %g) m overlap by %.3g of a diameter at step %lld, the limit is %g; use a "
                     "smaller step or a stiffer material, or raise time/maxOverlap", who, w->x[0], w->x[1], w->x[2], w->overlap,
                     (long long)p->steps, w->limit);
}
