/*
 * impact_spring.h -- stiffness of a linear spring on a row, given or from an impact speed.
 *
 * Formulas: impact_speed.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/row.h"

struct dem_impact_spring    /* a linear spring, given or from the materials */
{
    double stiffness;  /* N/m  k; 0: from the materials and the speed */
    double speed;      /* m/s  v */
    double scale;      /* K, derived; 0 with a given k */
};

/* k [N/m], 0 where the partners are apart */
DEM_MATH double dem_impact_given_stiffness(const struct dem_impact_spring *s, double touching)
{
    return touching*s->stiffness;
}

/* K (R*^2 m*)^(1/5) [N/m], likewise; R: R* [m], m: m* [kg] */
DEM_MATH double dem_impact_derived_stiffness(const struct dem_impact_spring *s, double touching,
                                             double R, double m)
{
    return touching*s->scale*dem_pow(R*R*m, 0.2);
}

/* kn of a row: one of the two */
DEM_MATH void dem_impact_stiffness_row(const struct dem_impact_spring *s, struct dem_contact_row *r)
{
    r->kn = s->scale > 0.0 ? dem_impact_derived_stiffness(s, r->touching, r->reduced_radius,
                                                          r->reduced_mass)
                           : dem_impact_given_stiffness(s, r->touching);
}
