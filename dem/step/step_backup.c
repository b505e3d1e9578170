/*
 * step_backup.c -- copy the state into the backup.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "step/step_backup.h"
#include "particles/domain.h"
#include "ranks/agree.h"
#include "sources/flows.h"
#include <math.h>

/* 1 when a position, a velocity, a spin, a force or a torque is not a number. */
static int has_invalid_number(const struct dem_particles *p)
{
    const double *const force = dem_column(p, DEM_COLUMN_FORCE);
    const double *const torque = dem_column(p, DEM_COLUMN_TORQUE);
    double sum = 0.0;

    for (size_t i = 0; i < p->n; i++)
    {
        for (size_t k = 0; k < 3; k++)
        {
            sum += 0.0*(p->record[i].x[k] + p->record[i].v[k] + p->record[i].w[k] +
                          force[3*i + k] + torque[3*i + k]);
        }
    }
    return isnan(sum);
}

int dem_step_backup_ahead(struct dem_state *p, int status, const struct dem_body_sweep *half_kick)
{
    struct dem_backup *const backup = &p->backup;
    double invalid = has_invalid_number(&p->particles);

    DEM_TRY(dem_agree_max(p, status, &invalid, 1));
    if (invalid > 0.0)
    {
        return DEM_OK;
    }
    DEM_TRY(dem_backup_save(backup, &p->particles, &p->contacts, p->pairs.wall_facet));
    dem_flows_backup(p->flows);
    backup->time = p->time;
    backup->steps = p->steps;
    if (half_kick)
    {
        dem_sweep_bodies(&backup->particles, &p->interaction_table.bodies, half_kick);
        dem_domain_constrain(&p->domain, &backup->particles);
    }
    return DEM_OK;
}

int dem_step_backup(struct dem_state *p)
{
    if (p->window.half_step_ahead)
    {
        p->backup.steps = p->backup.valid ? p->backup.steps : p->steps - p->backup.every;
        return DEM_OK;
    }
    return dem_step_backup_ahead(p, DEM_OK, NULL);
}
