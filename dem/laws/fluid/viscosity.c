/*
 * viscosity.c -- the row of the fluid's viscosity in the table of particle scalars.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fluid/viscosity.h"
#include "laws/effect.h"
#include <math.h>
#include <stddef.h>

const struct dem_scalar dem_fluid_viscosity = {
    .name = "fluidViscosity",
    .unit = "Pa s",
    .default_value = 1.0,    /* until the coupled program gives it */
    .max = INFINITY,
    .help = "viscosity of the fluid at the particle",
    .fluid_entry = "viscosity",
    .batch = {.contact = offsetof(struct dem_contact_batch, viscosity),
              .contact_needs = DEM_NEEDS_VISCOSITY,
              .body = offsetof(struct dem_body_batch, viscosity)},
};
