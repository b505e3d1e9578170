/*
 * hot_chain.c -- one loop over the rows, then their forces by fours.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/hot_chain.h"
#include "effects/dry.h"
#include "effects/effects.h"
#include "effects/hertz.h"
#include "effects/mindlin.h"
#include "step/geometry.h"
#include "step/push.h"

struct laws                                               /* the numbers of the three, out of their settings */
{
    double modulus, alpha, least, shear;
    struct dem_rubbing rubs;
    double looks;                                         /* an overlap of this share of the lesser radius is to be looked at */
};

int dem_hot_chain_is(const struct dem_chain *chain)
{
    return chain->links == DEM_HOT_LINKS && !chain->past_touching && !chain->pair.with_wall
        && chain->link[DEM_HOT_NORMAL].effect == &dem_hertz && chain->link[DEM_HOT_DAMPING].effect == &dem_dry
        && chain->link[DEM_HOT_FRICTION].effect == &dem_mindlin;
}

DEM_KERNEL
static void pairs(struct dem_block *restrict b, const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r;

        dem_geometry_pair(g, c, b->dt, &r);
        b->nx[c] = r.nx;
        b->ny[c] = r.ny;
        b->nz[c] = r.nz;
        b->hx[c] = r.hx;
        b->hy[c] = r.hy;
        b->hz[c] = r.hz;
        b->overlap[c] = r.overlap;
        b->reduced_radius[c] = r.reduced_radius;
        b->reduced_mass[c] = r.reduced_mass;
    }
}

DEM_KERNEL
static void presses(struct laws l, struct dem_block *restrict b, const struct dem_gathered *restrict g)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = dem_row_at(b, c);

        dem_geometry_motion(g, c, 1.0, &r);
        dem_hertz_row(l.modulus, &r);
        dem_dry_row(l.alpha, l.least, &r);
        b->kt[c] = dem_mindlin_stiffness(l.shear, &r);
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
static void slides(struct laws l, struct dem_block *restrict b, double *restrict x, double *restrict y, double *restrict z)
{
    for (int c = 0; c < b->n; c++)
    {
        struct dem_row r = dem_row_at(b, c);

        r.grip = 0.0;
        const struct dem_slider s = dem_mindlin_row(l.rubs, &r, x[c], y[c], z[c]);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_cuts(b);
}

/* The columns fx, fy, fz get the whole force, mx, my, mz n x F. 0 when no row is to be looked at. */
DEM_KERNEL
static uint64_t pushes(struct laws l, struct dem_block *restrict b, double *restrict x, double *restrict y, double *restrict z)
{
    uint64_t look = 0;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slider s = dem_slider_end(b, c, x[c], y[c], z[c]);
        const double on = b->touching[c], nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
        const double fn = on*b->fn[c], fx = on*s.fx, fy = on*s.fy, fz = on*s.fz;
        const double sum = b->fn[c] + (fx + fy + fz);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        b->fx[c] = fn*nx + fx;
        b->fy[c] = fn*ny + fy;
        b->fz[c] = fn*nz + fz;
        b->mx[c] = ny*fz - nz*fy;
        b->my[c] = nz*fx - nx*fz;
        b->mz[c] = nx*fy - ny*fx;
        look |= (uint64_t)((b->overlap[c] >= l.looks*b->least_radius[c]) | (sum*0.0 != 0.0));
    }
    return look;
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

int dem_hot_chain_act(const struct dem_chain *chain, struct dem_tray *t, double worst, double *const *memory, struct dem_push *push)
{
    const struct dem_hertz *const hertz = chain->link[DEM_HOT_NORMAL].settings;
    const struct dem_dry *const dry = chain->link[DEM_HOT_DAMPING].settings;
    const struct dem_mindlin *const mindlin = chain->link[DEM_HOT_FRICTION].settings;
    const struct laws laws = {.modulus = hertz->modulus, .alpha = dry->alpha, .least = dem_attraction_least(dry->attraction),
                              .shear = mindlin->modulus, .rubs = dem_mindlin_rubs(mindlin), .looks = 2.0*worst*(1.0 - 0x1p-50)};

    pairs(&t->block, &t->g);
    presses(laws, &t->block, &t->g);
    slides(laws, &t->block, memory[0], memory[1], memory[2]);
    const uint64_t look = pushes(laws, &t->block, memory[0], memory[1], memory[2]);

    put(&t->block, push);
    return look != 0;
}
