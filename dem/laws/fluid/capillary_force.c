/*
 * capillary_force.c -- surface tension of the interface of two fluids on a sphere that it crosses.
 *
 *   F = -2 pi sigma R sin(p) sin(p + theta) n,   cos(p) = z/R,   0 where |z| >= R
 *     = -2 pi sigma (s^2 cos(theta) + z s sin(theta))/R n,   s^2 = R^2 - z^2
 *
 *   sigma   surface tension                                        [N/m]
 *   R       radius; s: radius of the contact line                  [m]
 *   z       height of the centre above the interface, along n      [m]
 *   n       unit normal of the interface, from phase 1 to phase 2  [1]
 *   p       angle of the contact line from the pole in phase 1     [1]
 *   theta   contact angle, measured in phase 1                     [1]
 *
 * The interface meets the sphere at its contact angle and pulls along itself: the force of a contact
 * line of the length 2 pi s. It is zero at z = -R cos(theta), where a plane interface meets the
 * sphere at that angle, with the stiffness 2 pi sigma. It holds at most 2 pi sigma R sin^2(theta/2)
 * against a pull into phase 1, at z = -R cos(theta/2), and 2 pi sigma R cos^2(theta/2) against a
 * pull into phase 2. Buoyancy of the sphere at the interface is a part of pressureGradient.
 *
 * z and n are taken from the volume fraction a of phase 1 as the kernel of the coupling sees it,
 * n = - grad a/|grad a|, z = (1/2 - a)/|grad a|. So the interface is the one that the mesh resolves,
 * without the meniscus around the particle. A meniscus would reach farther than |z| = R: the work to
 * pull the sphere out is 2/3 of the surface energy sigma pi R^2 (1 -+ cos(theta))^2. The largest load
 * is exact for spheres small against the capillary length.
 *
 * The interface gets the opposite force (demCapillaryForce.H), in the cells that the kernel reaches.
 * Force and interface are constant in a step of the fluid.
 *
 * Source: Scheludko, Toshev, Bojadjiev, J. Chem. Soc. Faraday Trans. 1 72 (1976) 2815; the same force in
 * Rapacchietta, Neumann, J. Colloid Interface Sci. 59 (1977) 555.
 * Not here: hysteresis of the contact angle, the torque of a contact line that it pins, forces
 * between particles by their menisci.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/effect.h"
#include "laws/fluid/capillary_force.h"
#include <math.h>

static const struct dem_setting settings[] = {
    DEM_SETTING_AS(dem_capillary_force, contact_angle, "contactAngle", "degree",
                   DEM_SETTING_REQUIRED, 0.0, 180.0, "between the interface and the particle, in phase 1"),
    {0},
};

static int prepare(void *of, const struct dem_pair_class *none)
{
    struct dem_capillary_force *const l = of;
    const double angle = l->contact_angle*(3.14159265358979324/180.0);

    (void)none;
    l->cosine = cos(angle);
    l->sine = sin(angle);
    return DEM_OK;
}

#define LAW dem_capillary_force
#define SETS DEM_SETS_FORCE
#include "laws/body_loop.h"

const struct dem_effect dem_capillary_force = {
    .name = "capillaryForce",
    .summary = "surface tension on a particle that the interface of two fluids crosses (demInterFoam)",
    .source = "Scheludko, Toshev, Bojadjiev 1976; Rapacchietta, Neumann 1977",
    .limitation = "capillaryForce knows the interface that the mesh resolves, without the meniscus around a particle",
    .stage = DEM_STAGE_FLUID,
    .needs = DEM_NEEDS_FLUID | DEM_NEEDS_INTERFACE,
    .example = "contactAngle 60;",
    .size = sizeof(struct dem_capillary_force),
    .settings = settings,
    .prepare = prepare,
    .apply_to_bodies = apply_to_bodies,
};
