/*
 * rolling_spring.h -- rolling torque of one contact, the row function of rolling_spring.c, which
 * has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_ROLLING_SPRING_H
#define DEM_LAWS_ROLLING_SPRING_H

#include "laws/contact/slider.h"

struct dem_rolling_spring
{
    double friction;
    double stiffness;
    double damping;
    double ratio;                                         /* 1    K, derived */
};

enum
{
    dem_rolling_spring_columns = 3    /* theta */
};

DEM_MATH struct dem_slider dem_rolling_slider(const struct dem_rolling_spring *l,
                                              const struct dem_contact_row *r, const double *theta)
{
    const double hx = r->hx, hy = r->hy, hz = r->hz, R = r->reduced_radius;
    const double twist = r->wx*hx + r->wy*hy + r->wz*hz;
    const double stiffness = l->ratio*r->kn*R*R;
    const double damping = 2.0*l->damping*R*sqrt(1.4*r->reduced_mass*stiffness);

    return (struct dem_slider){.stiffness = stiffness,
                               .damping = damping,
                               .limit = dem_select(r->fn > 0.0, l->friction*R*r->fn, 0.0),
                               .inverse_dt = r->inverse_dt,
                               .sx = r->wx - twist*hx,
                               .sy = r->wy - twist*hy,
                               .sz = r->wz - twist*hz,
                               .xi_x = theta[0],
                               .xi_y = theta[1],
                               .xi_z = theta[2]};
}

DEM_MATH void dem_rolling_spring_row(const struct dem_rolling_spring *l, struct dem_contact_row *r,
                                     double *theta)
{
    dem_slider_row(r, dem_rolling_slider(l, r, theta), (double *[3]){&r->mx, &r->my, &r->mz},
                   theta);
}

/* in two parts, for fused kernels */
DEM_MATH void dem_rolling_spring_begin(const struct dem_rolling_spring *l,
                                       struct dem_contact_row *r, struct dem_slider_columns *t,
                                       int c, double *theta)
{
    dem_slider_begin(r, dem_rolling_slider(l, r, theta), t, c, theta);
}

#define dem_rolling_spring_limit dem_slider_limit_forces

DEM_MATH void dem_rolling_spring_end(const struct dem_slider_columns *t, int c,
                                     struct dem_contact_row *r, double *theta)
{
    dem_slider_end(t, c, (double *[3]){&r->mx, &r->my, &r->mz}, theta);
}

#endif
