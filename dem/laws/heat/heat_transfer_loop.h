/*
 * heat_transfer_loop.h -- template: the loop of a law of heat transfer over a batch, from its
 * formula. A law defines
 *
 *   DEM_MATH double nusselt(const struct dem_drag_row *r, double prandtl_root)
 *
 * with Pr^(1/3) as prandtl_root, and includes this file, which defines apply_to_bodies.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
DEM_KERNEL
static void apply_to_bodies(const void *of, struct dem_body_batch *restrict b)
{
    const struct dem_heat_transfer t = dem_heat_transfer_of(b);

    for (int c = 0; c < b->n; c++)
    {
        const struct dem_drag_row r = dem_drag_row_load(of, b, c);
        const double B = 3.14159265358979324*r.diameter*t.conductivity[c]*    /* pi d k_f Nu */
                         nusselt(&r, dem_heat_prandtl_root(b, &t, c));

        t.coefficient[c] += B;
        t.to_target[c] += B*t.fluid_temperature[c];
    }
}
