/*
 * slider_columns.h -- a step of the slider in three loops over a batch, for fused kernels.
 *
 * In one long loop the latencies of square roots and divisions add up, in short ones they overlap.
 * The first loop is the kernel's and calls dem_slider_begin, the last one dem_slider_end. The
 * results have the bits of dem_slider_step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch.h"
#include "laws/contact/slider.h"

struct dem_slider_columns
{
    _Alignas(64) double x[DEM_BATCH_ROWS], y[DEM_BATCH_ROWS], z[DEM_BATCH_ROWS];    /* T */
    /* limit and effective stiffness; after dem_slider_limit_forces force_factor and spring_factor */
    _Alignas(64) double limit[DEM_BATCH_ROWS], stiffness[DEM_BATCH_ROWS];
};

/* xi: the spring; out, its trial elongation */
DEM_MATH void dem_slider_begin(const struct dem_contact_row *r, struct dem_slider s,
                               struct dem_slider_columns *to, int c, double *xi)
{
    double t[3];

    s = dem_slider_load(r, s);
    dem_slider_trial_force(&s, t);
    dem_slider_keep(&s, xi);
    to->x[c] = t[0];
    to->y[c] = t[1];
    to->z[c] = t[2];
    to->limit[c] = s.limit;
    to->stiffness[c] = dem_slider_effective_stiffness(&s);
}

DEM_MATH void dem_slider_limit_forces(struct dem_slider_columns *t, int n)
{
    for (int c = 0; c < n; c++)
    {
        const struct dem_slider_limited l =
            dem_slider_limit_force(t->x[c]*t->x[c] + t->y[c]*t->y[c] + t->z[c]*t->z[c],
                                   t->limit[c], t->stiffness[c]);

        t->limit[c] = l.force_factor;
        t->stiffness[c] = l.spring_factor;
    }
}

/* xi: the trial elongation. Returns the slider with F and the spring. */
DEM_MATH struct dem_slider dem_slider_end(const struct dem_slider_columns *t, int c,
                                          const double *xi)
{
    const struct dem_slider e = {.xi_x = xi[0], .xi_y = xi[1], .xi_z = xi[2]};

    return dem_slider_apply_limit(e, (const double[3]){t->x[c], t->y[c], t->z[c]},
                                  (struct dem_slider_limited){.force_factor = t->limit[c],
                                                              .spring_factor = t->stiffness[c]});
}
