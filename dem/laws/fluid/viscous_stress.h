/*
 * viscous_stress.h -- row function of viscous_stress.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

DEM_MATH void dem_viscous_stress_row(const void *none, struct dem_body_row *r)
{
    (void)none;
    r->rx += r->volume*r->sx;
    r->ry += r->volume*r->sy;
    r->rz += r->volume*r->sz;
}
