/*
 * uniform_fluid.c -- fills the fluid columns of particles with the values of the uniform fluid.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "particles/uniform_fluid.h"
#include "particles/scalars.h"
#include <string.h>

static void fill_vector(struct dem_particles *p, enum dem_column_name column, size_t i,
                        const double value[3])
{
    if (dem_column(p, column))
    {
        memcpy(dem_column(p, column) + 3*i, value, 3*sizeof *value);
    }
}

void dem_uniform_fluid_fill(struct dem_particles *p, size_t i, const struct dem_uniform_fluid *f,
                      double mean)
{
    for (int k = 0; k < f->scalars; k++)
    {
        dem_scalar_values(p, f->scalar[k])[i] = f->value[k];
    }
    if (!dem_column(p, DEM_COLUMN_FLUID_VELOCITY))    /* no effect needs more */
    {
        return;
    }
    fill_vector(p, DEM_COLUMN_FLUID_ACCELERATION, i, f->acceleration);
    fill_vector(p, DEM_COLUMN_VORTICITY, i, f->vorticity);
    fill_vector(p, DEM_COLUMN_STRESS, i, f->stress);
    fill_vector(p, DEM_COLUMN_FLUID_VELOCITY, i, f->velocity);
    fill_vector(p, DEM_COLUMN_PRESSURE_GRADIENT, i, f->pressure_gradient);
    if (dem_column(p, DEM_COLUMN_TURBULENCE))
    {
        memcpy(dem_column(p, DEM_COLUMN_TURBULENCE) + 2*i, f->turbulence, sizeof f->turbulence);
    }
    if (dem_column(p, DEM_COLUMN_MEAN_DIAMETER))
    {
        dem_column(p, DEM_COLUMN_MEAN_DIAMETER)[i] = mean;
    }
    dem_column(p, DEM_COLUMN_VOID_FRACTION)[i] = f->given ? f->void_fraction : 1.0;
    dem_column(p, DEM_COLUMN_FLUID_DENSITY)[i] = f->given ? f->density : 1.0;
    dem_column(p, DEM_COLUMN_SLIP_FACTOR)[i] = 1.0;
    dem_column(p, DEM_COLUMN_COUPLING_INDEX)[2*i] =
        dem_column(p, DEM_COLUMN_COUPLING_INDEX)[2*i + 1] = -1.0;
}
