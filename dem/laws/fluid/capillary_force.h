/*
 * capillary_force.h -- row function of capillary_force.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_CAPILLARY_FORCE_H
#define DEM_LAWS_CAPILLARY_FORCE_H

#include "laws/row.h"

struct dem_capillary_force
{
    double contact_angle;    /* degree */
    double cosine, sine;     /* of it */
};

DEM_MATH void dem_capillary_force_row(const struct dem_capillary_force *l, struct dem_body_row *r)
{
    const double R = r->radius,
                 z = dem_select(fabs(r->interface_distance) < R, r->interface_distance, R),
                 square = (R - z)*(R + z), root = sqrt(square);
    const double force =
        -6.28318530717958648*(square*l->cosine + z*root*l->sine)/dem_select(R > 0.0, R, 1.0);

    r->fx += force*r->tension_x;
    r->fy += force*r->tension_y;
    r->fz += force*r->tension_z;
}

#endif
