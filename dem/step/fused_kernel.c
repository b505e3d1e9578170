/*
 * fused_kernel.c -- decide whether the fused kernel applies to a pair class, and evaluate it in
 * double precision.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <stdint.h>

typedef uint64_t dem_mask;

#include "effects/effects.h"
#include "step/fused_laws.h"
#include "step/contact_force.h"

int dem_fused_kernel_applies(const struct dem_effect_list *effects)
{
    return effects->entries == DEM_FUSED_EFFECTS && !effects->past_touching &&
           !effects->pair.with_wall && effects->entry[DEM_FUSED_NORMAL].effect == &dem_hertz &&
           effects->entry[DEM_FUSED_DAMPING].effect == &dem_dry &&
           effects->entry[DEM_FUSED_FRICTION].effect == &dem_mindlin;
}

struct dem_fused_constants dem_fused_kernel_constants(const struct dem_effect_list *effects,
                                                      double max_overlap)
{
    const struct dem_hertz *const hertz = effects->entry[DEM_FUSED_NORMAL].settings;
    const struct dem_dry *const dry = effects->entry[DEM_FUSED_DAMPING].settings;
    const struct dem_mindlin *const mindlin = effects->entry[DEM_FUSED_FRICTION].settings;

    /* 2^-20: a margin for the rounding errors of single precision */
    return (struct dem_fused_constants){.modulus = hertz->modulus,
                                        .alpha = dry->alpha,
                                        .min_force = dem_attraction_min_force(dry->attraction),
                                        .shear = mindlin->modulus,
                                        .mindlin = mindlin,
                                        .check_overlap = 2.0*max_overlap*(1.0 - 0x1p-20)};
}

DEM_KERNEL
static void store(const struct dem_contact_batch *restrict b, struct dem_contact_force *restrict to)
{
    for (int c = 0; c < b->n; c += 4)
    {
        dem_vec4 f[4] = {DEM_VEC4(b->fx + c), DEM_VEC4(b->fy + c), DEM_VEC4(b->fz + c),
                         0.5*DEM_VEC4(b->overlap + c)};
        dem_vec4 t[4] = {DEM_VEC4(b->mx + c),
                         DEM_VEC4(b->my + c),
                         DEM_VEC4(b->mz + c),
                         {0.0, 0.0, 0.0, 0.0}};

        dem_contact_force_store(to + c, f, t);
    }
}

int dem_fused_kernel_run(const struct dem_fused_constants *l, struct dem_contact_batch *b,
                         const struct dem_gathered *g, double *const *history,
                         struct dem_contact_force *to)
{
    const int check = evaluate(l, b, g, b->dt, history);

    store(b, to);
    return check;
}
