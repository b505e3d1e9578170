/*
 * gravity.h -- row function of gravity.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_gravity
{
    double acceleration[3];
};

DEM_MATH void dem_gravity_row(const struct dem_gravity *l, struct dem_body_row *r)
{
    r->fx += r->mass*l->acceleration[0];
    r->fy += r->mass*l->acceleration[1];
    r->fz += r->mass*l->acceleration[2];
}
