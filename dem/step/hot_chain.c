/*
 * hot_chain.c -- which chain is hot, and its laws in double precision.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>

typedef uint64_t dem_mask;

#include "effects/effects.h"
#include "step/hot_laws.h"
#include "step/push.h"

int dem_hot_chain_is(const struct dem_chain *chain)
{
    return chain->links == DEM_HOT_LINKS && !chain->past_touching && !chain->pair.with_wall
        && chain->link[DEM_HOT_NORMAL].effect == &dem_hertz && chain->link[DEM_HOT_DAMPING].effect == &dem_dry
        && chain->link[DEM_HOT_FRICTION].effect == &dem_mindlin;
}

struct dem_hot_laws dem_hot_chain_laws(const struct dem_chain *chain, double worst)
{
    const struct dem_hertz *const hertz = chain->link[DEM_HOT_NORMAL].settings;
    const struct dem_dry *const dry = chain->link[DEM_HOT_DAMPING].settings;
    const struct dem_mindlin *const mindlin = chain->link[DEM_HOT_FRICTION].settings;

    /* a few roundings, of single precision, on the safe side */
    return (struct dem_hot_laws){.modulus = hertz->modulus, .alpha = dry->alpha, .least = dem_attraction_least(dry->attraction),
                                 .shear = mindlin->modulus, .mindlin = mindlin, .looks = 2.0*worst*(1.0 - 0x1p-20)};
}

DEM_KERNEL
static void put(const struct dem_block *restrict b, struct dem_push *restrict push)
{
    for (int c = 0; c < b->n; c += 4)
    {
        dem_quad f[4] = {DEM_QUAD(b->fx + c), DEM_QUAD(b->fy + c), DEM_QUAD(b->fz + c), 0.5*DEM_QUAD(b->overlap + c)};
        dem_quad t[4] = {DEM_QUAD(b->mx + c), DEM_QUAD(b->my + c), DEM_QUAD(b->mz + c), {0.0, 0.0, 0.0, 0.0}};

        dem_push_put(push + c, f, t);
    }
}

int dem_hot_chain_act(const struct dem_hot_laws *l, struct dem_block *b, const struct dem_gathered *g, double *const *memory,
                      struct dem_push *push)
{
    const int look = act(l, b, g, b->dt, memory);

    put(b, push);
    return look;
}
