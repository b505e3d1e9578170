/*
 * fused_laws.h -- the four loops of fused_kernel.h. To be included after the definition of dem_mask, an
 * unsigned integer of the size of a double.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "effects/contact/dry.h"
#include "effects/effect.h"
#include "effects/contact/hertz.h"
#include "effects/contact/mindlin.h"
#include "step/geometry.h"
#include "step/fused_kernel.h"

DEM_KERNEL
static void geometry(struct dem_contact_batch *restrict b, const struct dem_gathered *restrict g,
                     double dt)
{
    dem_geometry_pairs(b, g, dt);
}

DEM_KERNEL
static void normal_forces(const struct dem_fused_constants *l, struct dem_contact_batch *restrict b,
                          const struct dem_gathered *restrict g)
{
    const double modulus = l->modulus, alpha = l->alpha;
    const double min_force = l->min_force, shear = l->shear;

    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c);

        dem_geometry_motion(g, c, 1, &r);
        dem_hertz_row(modulus, &r);
        dem_dry_row(alpha, min_force, &r);
        b->kt[c] = dem_mindlin_stiffness(shear, &r);
        b->overlap[c] = r.overlap;
        b->touching[c] = r.touching;
        b->sx[c] = r.sx;
        b->sy[c] = r.sy;
        b->sz[c] = r.sz;
        b->normal_spin[c] = r.normal_spin;
        b->eta[c] = r.eta;
        b->fn[c] = r.fn;
    }
}

DEM_KERNEL
static void friction_springs(const struct dem_fused_constants *l,
                             struct dem_contact_batch *restrict b, double *restrict x,
                             double *restrict y, double *restrict z)
{
    const struct dem_friction friction = dem_friction_of(&l->mindlin->common, b);

    for (int c = 0; c < b->n; c++)
    {
        struct dem_contact_row r = dem_contact_row_load(b, c);

        r.adhesive_force = 0;
        const struct dem_slider s =
            dem_friction_row(friction, &r, r.kt, x[c], y[c], z[c]);

        x[c] = s.xi_x;
        y[c] = s.xi_y;
        z[c] = s.xi_z;
        dem_slider_begin(b, c, &s);
    }
    dem_slider_limit_forces(b);
}

/* The columns fx, fy, fz get the total force, mx, my, mz n x F. Returns 0 when no row has to be
   checked against the limits. */
DEM_KERNEL
static dem_mask contact_forces(const struct dem_fused_constants *l,
                               struct dem_contact_batch *restrict b, double *restrict x,
                               double *restrict y, double *restrict z)
{
    const double limit = l->check_overlap;
    dem_mask check = 0;

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_slider s =
            dem_slider_end(b, c, x[c], y[c], z[c]);
        const double mask = b->touching[c], nx = b->nx[c], ny = b->ny[c], nz = b->nz[c];
        const double fn = mask*b->fn[c], fx = mask*s.fx, fy = mask*s.fy, fz = mask*s.fz;
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
        check |= (dem_mask)((b->overlap[c] >= limit*b->min_radius[c]) | (sum*0 != 0));
    }
    return check;
}

/* All four loops; the forces are then in columns. `history`: the history columns of mindlin.
   Returns 1 when a row has to be checked. */
static int evaluate(const struct dem_fused_constants *l, struct dem_contact_batch *b,
                    const struct dem_gathered *g, double dt, double *const *history)
{
    geometry(b, g, dt);
    normal_forces(l, b, g);
    friction_springs(l, b, history[0], history[1], history[2]);
    return contact_forces(l, b, history[0], history[1], history[2]) != 0;
}
