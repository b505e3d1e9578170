/*
 * gidaspow.h -- row function of gidaspow.c, which has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/fluid/drag.h"

struct dem_gidaspow
{
    int blend;
};

enum    /* `blend` */
{
    DEM_GIDASPOW_SMOOTH,
    DEM_GIDASPOW_SWITCH
};

/* atan x: |x| > 1 by pi/2 - atan(1/x); the angle is halved twice, so that its tangent is below
   0.2 and 11 terms of the series suffice: the next is below 0.2^22/23 = 2e-17 of the first */
DEM_MATH double dem_gidaspow_arctangent(double x)
{
    const double size = fabs(x);
    const double z = dem_select(size > 1.0, 1.0/dem_select(size > 1.0, size, 1.0), size);
    const double once = z/(1.0 + sqrt(1.0 + z*z));
    const double t = once/(1.0 + sqrt(1.0 + once*once));
    const double w = t*t;
    const double sum =
        1.0 -
        w*(1.0/3.0 -
             w*(1.0/5.0 -
                  w*(1.0/7.0 -
                       w*(1.0/9.0 -
                            w*(1.0/11.0 -
                                 w*(1.0/13.0 -
                                      w*(1.0/15.0 -
                                           w*(1.0/17.0 - w*(1.0/19.0 - w/21.0)))))))));
    const double angle = 4.0*t*sum;
    const double y = dem_select(size > 1.0, 1.57079632679489662 - angle, angle);

    return dem_select(x < 0.0, -y, y);
}

/* e^-2.65 and phi */
DEM_MATH void dem_gidaspow_prepare_row(const struct dem_gidaspow *l, struct dem_body_row *r)
{
    const double pi = 3.14159265358979324;
    const double e = dem_drag_void_fraction(r->void_fraction), s = 1.0 - e;
    const double transition = 0.5 + dem_gidaspow_arctangent(150.0*1.75*(0.2 - s))/pi;

    r->voidage_factor[0] = dem_drag_voidage_factor(e);
    r->voidage_factor[1] = dem_select(l->blend == DEM_GIDASPOW_SMOOTH, transition,
                                      dem_select(e < 0.8, 0.0, 1.0));
}

DEM_MATH void dem_gidaspow_row(const struct dem_gidaspow *l, struct dem_body_row *r)
{
    const double e = dem_drag_void_fraction(r->void_fraction), re = dem_drag_reynolds(r, e);
    const double phi = r->voidage_factor[1],
                 wen_yu = r->voidage_factor[0]*dem_drag_single_sphere(re);

    (void)l;
    dem_drag_add(r, (1.0 - phi)*dem_drag_ergun(e, re) + phi*wen_yu);
}
