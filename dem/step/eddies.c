/*
 * eddies.c -- the turbulent eddies that particles are in: laws/fluid/eddy.h for all particles.
 *
 * Time in an eddy passes once a step, before its forces. A new particle has none left, so it enters
 * an eddy in its first step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/eddies.h"
#include "laws/effect.h"
#include <math.h>

void dem_eddies_velocity(const struct dem_particles *particles, size_t i, double u[3])
{
    const double *const eddy = dem_column(particles, DEM_COLUMN_EDDY);
    const double speed =
        eddy ? dem_eddy_speed(dem_column(particles, DEM_COLUMN_TURBULENCE)[2*i]) : 0.0;

    for (size_t k = 0; k < 3; k++)
    {
        u[k] = eddy ? speed*eddy[4*i + k] : 0.0;
    }
}

/* Speed of the particle relative to the fluid around it. */
static double slip(const struct dem_particles *particles, size_t i)
{
    const double *const u = dem_column(particles, DEM_COLUMN_FLUID_VELOCITY) + 3*i,
                 *const v = particles->record[i].v;
    double w[3];

    dem_eddies_velocity(particles, i, w);
    for (int k = 0; k < 3; k++)
    {
        w[k] += u[k] - v[k];
    }
    return sqrt(w[0]*w[0] + w[1]*w[1] + w[2]*w[2]);
}

void dem_eddies_advance(struct dem_particles *particles, const struct dem_effect_list *effects,
                        double dt, int64_t step)
{
    const double *const turbulence = dem_column(particles, DEM_COLUMN_TURBULENCE);
    struct dem_eddies model = {0};

    if (!dem_column(particles, DEM_COLUMN_EDDY))
    {
        return;
    }
    for (int k = 0; k < effects->entries; k++)
    {
        if (effects->entry[k].effect->eddies)
        {
            effects->entry[k].effect->eddies(effects->entry[k].settings, &model);
        }
    }
    for (size_t i = 0; i < particles->n; i++)
    {
        double *const eddy = dem_column(particles, DEM_COLUMN_EDDY) + 4*i;

        eddy[3] -= dt*dem_eddy_rate(&model, turbulence[2*i], turbulence[2*i + 1],
                                    slip(particles, i));
        if (eddy[3] <= 0.0)
        {
            dem_eddy_begin(&model, (uint64_t)particles->record[i].id, (uint64_t)step, eddy);
        }
    }
}
