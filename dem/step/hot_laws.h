/*
 * hot_laws.h -- the four loops of hot_chain.h, in the precision that who includes it has chosen (DEM_REAL).
 *
 * Memory stays in double precision, and so does what positions say (geometry.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/dry.h"
#include "effects/effect.h"
#include "effects/hertz.h"
#include "effects/mindlin.h"
#include "step/geometry.h"
#include "step/hot_chain.h"

DEM_KERNEL
static void pairs(struct dem_block *restrict b, const struct dem_gathered *restrict g, double dt)
{
    dem_geometry_pairs(b, g, dt);
}

DEM_KERNEL
static void presses(const struct dem_hot_laws *l, struct dem_block *restrict b, const struct dem_gathered *restrict g)
{
    const dem_real modulus = (dem_real)l->modulus, alpha = (dem_real)l->alpha, least = (dem_real)l->least, shear = (dem_real)l->shear;

    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = dem_row_at(b, c);

        dem_geometry_motion(g, c, 1, &r);
        dem_hertz_row(modulus, &r);
        dem_dry_row(alpha, least, &r);
        b->kt[c] = dem_mindlin_stiffness(shear, &r);
        b->overlap[c] = r.overlap;
        b->touching[c] = r.touching;
        b->sx[c] = r.sx;
        b->sy[c] = r.sy;
        b->sz[c] = r.sz;
        b->swing[c] = r.swing;
        b->eta[c] = r.eta;
        b->fn[c] = r.fn;
    }
}

DEM_KERNEL
static void slides(const struct dem_hot_laws *l, struct dem_block *restrict b, double *restrict x, double *restrict y, double *restrict z)
{
    const struct dem_rubbing rubs = dem_mindlin_rubs(l->mindlin, b);

    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = dem_row_at(b, c);

        r.grip = 0;
        const struct dem_slider s = dem_mindlin_row(rubs, &r, (dem_real)x[c], (dem_real)y[c], (dem_real)z[c]);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_cuts(b);
}

/* The columns fx, fy, fz get the whole force, mx, my, mz n x F. 0 when no row is to be looked at. */
DEM_KERNEL
static dem_mask pushes(const struct dem_hot_laws *l, struct dem_block *restrict b, double *restrict x, double *restrict y, double *restrict z)
{
    const dem_real looks = (dem_real)l->looks;
    dem_mask look = 0;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slider s = dem_slider_end(b, c, (dem_real)x[c], (dem_real)y[c], (dem_real)z[c]);
        const dem_real on = b->touching[c], nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
        const dem_real fn = on*b->fn[c], fx = on*s.fx, fy = on*s.fy, fz = on*s.fz;
        const dem_real sum = b->fn[c] + (fx + fy + fz);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        b->fx[c] = fn*nx + fx;
        b->fy[c] = fn*ny + fy;
        b->fz[c] = fn*nz + fz;
        b->mx[c] = ny*fz - nz*fy;
        b->my[c] = nz*fx - nx*fz;
        b->mz[c] = nx*fy - ny*fx;
        look |= (dem_mask)((b->overlap[c] >= looks*b->least_radius[c]) | (sum*0 != 0));
    }
    return look;
}

/* All but the records of the pushes. */
static int act(const struct dem_hot_laws *l, struct dem_block *b, const struct dem_gathered *g, double dt, double *const *memory)
{
    pairs(b, g, dt);
    presses(l, b, g);
    slides(l, b, memory[0], memory[1], memory[2]);
    return pushes(l, b, memory[0], memory[1], memory[2]) != 0;
}
