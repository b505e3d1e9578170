/*
 * rolling_spring.h -- rolling torque of one contact, the row function of rolling_spring.c, which
 * has the formula and its source.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/contact/slider_energy.h"

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

/* The moment of a slider into the row. */
DEM_MATH void dem_rolling_spring_add(const struct dem_slider *s, struct dem_contact_row *r)
{
    r->mx += s->fx;
    r->my += s->fy;
    r->mz += s->fz;
}

DEM_MATH void dem_rolling_spring_row(const struct dem_rolling_spring *l, struct dem_contact_row *r,
                                     double *theta)
{
    const struct dem_slider s = dem_slider_step(r, dem_rolling_slider(l, r, theta));

    dem_slider_keep(&s, theta);
    dem_rolling_spring_add(&s, r);
}

DEM_MATH void dem_rolling_spring_energy_row(const struct dem_rolling_spring *l, const struct dem_contact_row *r,
    const double *before, const double *after, struct dem_energy_row *e)
{
    struct dem_slider s = dem_rolling_slider(l, r, before);

    (void)after;
    s.mass = e->inertia;
    s.previous_stiffness = l->ratio*e->previous_kn*r->reduced_radius*r->reduced_radius;
    dem_slider_energy(r, s, e);
}
