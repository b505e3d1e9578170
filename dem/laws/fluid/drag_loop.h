/*
 * drag_loop.h -- template: the loop of a drag law over a batch, from its formula. A law defines
 *
 *   DEM_MATH double drag_over_stokes(const struct dem_drag_row *r)           G of drag.h
 *
 * and includes this file, which defines apply_to_bodies. A law with voidage factors also defines
 *
 *   DEM_MATH void voidage_factors(const void *settings, double e, double *factor)
 *   #define HAS_VOIDAGE_FACTORS
 *
 * before, and gets prepare_bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifdef HAS_VOIDAGE_FACTORS
DEM_KERNEL
static void prepare_bodies(const void *of, struct dem_body_batch *restrict b)
{
    for (int c = 0; c < b->n; c++)
    {
        double factor[DEM_VOIDAGE_FACTORS] = {0.0};

        voidage_factors(of, dem_drag_void_fraction(b->void_fraction[c]), factor);
        for (int k = 0; k < DEM_VOIDAGE_FACTORS; k++)
        {
            b->voidage_factor[k][c] = factor[k];
        }
    }
}
#endif

DEM_KERNEL
static void apply_to_bodies(const void *of, struct dem_body_batch *restrict b)
{
    for (int c = 0; c < b->n; c++)
    {
        const struct dem_drag_row r = dem_drag_row_load(of, b, c);
        const double drag = 9.42477796076937971*b->viscosity[c]*r.diameter*    /* 3 pi mu d G */
                            drag_over_stokes(&r);

        b->drag[c] += drag;
        b->drag_ux[c] += drag*b->ux[c];
        b->drag_uy[c] += drag*b->uy[c];
        b->drag_uz[c] += drag*b->uz[c];
    }
}
