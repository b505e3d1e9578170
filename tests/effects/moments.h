/*
 * moments.h -- a contact row for laws of rolling and twisting, and the claims common to them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "law_rows.h"

static const struct dem_material moments_bead = {"bead", 2500.0, 1e6, .poissons_ratio = 0.25};
static const double moments_pi = 3.14159265358979324;

/* one row by hand: normal z, R* = 4 mm, m* = 1 g, k_n = 1e4 N/m, overlap 1 um, pressed with 10 N */
static inline struct rows_effect *moments_row(struct law_rows *w, const struct dem_effect *effect,
                                                 const char *name, double value)
{
    rows_wall(w, &moments_bead, &moments_bead, 0.004);
    w->pair.exponent = 1.5;
    struct rows_effect *const l = rows_add(w, effect, name, value);

    w->b.n = 1;
    w->b.dt = 1e-6;
    w->b.nz[0] = w->b.hz[0] = 1.0;
    w->b.touching[0] = 1.0;
    w->b.overlap[0] = 1e-6;
    w->b.kn[0] = 1e4;
    w->b.reduced_radius[0] = 0.004;
    w->b.reduced_mass[0] = 1e-3;
    w->b.fn[0] = 10.0;
    return l;
}

static inline void moments_evaluate(struct law_rows *w, struct rows_effect *l)
{
    w->b.mx[0] = w->b.my[0] = w->b.mz[0] = 0.0;
    l->effect->apply(l->settings, &w->b, l->history);
}

static inline double moments_size(const struct law_rows *w)
{
    return sqrt(w->b.mx[0]*w->b.mx[0] + w->b.my[0]*w->b.my[0] + w->b.mz[0]*w->b.mz[0]);
}

/* common claims: no moment at rest, apart or under attraction; refused without a normal law */
static inline void moments_common(struct law_rows *w, const struct dem_effect *effect,
                                const char *name, double value)
{
    struct rows_effect *l = moments_row(w, effect, name, value);

    moments_evaluate(w, l);
    TAP_OK(moments_size(w) == 0.0, "at rest: no moment");
    w->b.wx[0] = 3.0, w->b.wz[0] = 2.0;
    w->b.fn[0] = -10.0;
    moments_evaluate(w, l);
    TAP_OK(moments_size(w) == 0.0, "under attraction: no moment");
    for (int m = 0; effect->history && effect->history[m]; m++)
    {
        TAP_OK(l->column[m][0] == 0.0, "under attraction: the history is zero");
    }
    l = moments_row(w, effect, name, 0.0);
    w->b.wx[0] = 3.0, w->b.wz[0] = 2.0;
    moments_evaluate(w, l);
    TAP_OK(moments_size(w) == 0.0, "%s 0: no moment", name);
    TAP_OK(apply_setting(effect, l->settings, &w->pair, name, -0.1) == DEM_ERROR_INPUT, "%s",
           dem_error_text());
    w->pair.exponent = 0.0;
    TAP_OK(dem_effect_prepare(effect, l->settings, &w->pair) == DEM_ERROR_INPUT, "%s", dem_error_text());
    TAP_OK(effect->stage == DEM_STAGE_MOMENT && (effect->needs & DEM_NEEDS_SPIN),
           "it is declared as a law of moments that needs the spin");
}
