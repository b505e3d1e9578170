/*
 * slider_energy.h -- energy of spring, dashpot and slider.
 *
 * Energy stored and dissipated by a row in the step that dem_slider_step makes of s. With e the
 * trial elongation, xi and xi' the elongation before (in the new plane) and after, k and k' the
 * stiffness before and after, and m the effective mass,
 *
 *   stored   k' xi'^2/2
 *   slipped  (k xi + k' xi')/2 . (e - xi')      mean spring force times the slip distance
 *   damped   -(F + k' xi').(s + dt F/2 m) dt    work of the dashpot, with the velocity in the
 *                                               middle of the kick as far as F alone changes it
 *   rubbed   -F.(s + dt F/2 m) dt               friction where there is no spring
 *   changed  -(k' - k) xi.xi'/2                 a spring that becomes stiffer at constant
 *                                               elongation gains energy that nothing has put in:
 *                                               < 0
 *
 * Where the partners are apart, or a bond replaces the contact, the spring is reset: k', xi' and F
 * are 0. The energy k xi^2/2 of the last step is dissipated, less the work of the last drift, which
 * ended with no force: half of k xi.s dt.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/slider.h"
#include "laws/energy_row.h"

DEM_MATH void dem_slider_energy(const struct dem_contact_row *r, struct dem_slider s,
                                struct dem_energy_row *e)
{
    struct dem_slider at_rest = s;

    at_rest.sx = at_rest.sy = at_rest.sz = 0;
    const struct dem_slider from = dem_slider_load(r, at_rest), loaded = dem_slider_load(r, s),
                            to = dem_slider_step(r, s);
    const double on = r->touching, k = on*s.stiffness, was = s.previous_stiffness, dt = r->dt;
    const double xi_x = on*to.xi_x, xi_y = on*to.xi_y, xi_z = on*to.xi_z, fx = on*to.fx,
                   fy = on*to.fy, fz = on*to.fz;
    const double gx = loaded.xi_x - xi_x, gy = loaded.xi_y - xi_y, gz = loaded.xi_z - xi_z;
    const double along = from.xi_x*gx + from.xi_y*gy + from.xi_z*gz,
                   ahead = xi_x*gx + xi_y*gy + xi_z*gz;
    const double both = from.xi_x*xi_x + from.xi_y*xi_y + from.xi_z*xi_z;

    const double gain = dt/(2*s.mass), ux = to.sx + gain*fx, uy = to.sy + gain*fy,
                   uz = to.sz + gain*fz;
    const double damped = -((fx + k*xi_x)*ux + (fy + k*xi_y)*uy + (fz + k*xi_z)*uz)*dt;
    const double rubbed = -(fx*ux + fy*uy + fz*uz)*dt;
    const double lost = damped + (was*along + k*ahead)/2 - (k - was)/2*both;

    e->stored = k/2*(xi_x*xi_x + xi_y*xi_y + xi_z*xi_z);
    e->lost = dem_select((on > 0) & !(k > 0), rubbed, lost);
}
