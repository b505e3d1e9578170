/*
 * fused_kernel.h -- what the template fused_loop.h and the tables of kernels need.
 *
 * To add a kernel, include the template with its laws and add a row to the table, as in
 * fused_hertz.c; its laws need a header with the row function (laws/row.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/batch_row.h"
#include "laws/contact/dry.h"
#include "laws/contact/hertz.h"
#include "laws/contact/hooke.h"
#include "laws/contact/hooke_hysteresis.h"
#include "laws/contact/impact_speed.h"
#include "laws/contact/jkr.h"
#include "laws/contact/linear.h"
#include "laws/contact/mindlin.h"
#include "laws/contact/rolling_constant.h"
#include "laws/contact/rolling_spring.h"
#include "laws/contact/slider_columns.h"
#include "laws/contact/stokes_damping.h"
#include "laws/contact/viscous.h"
#include "laws/effects.h"
#include "laws/fused/fused.h"

/* clang warns of each loop that it leaves scalar; the results are the same */
#ifdef __clang__
#pragma clang diagnostic ignored "-Wpass-failed"
#endif

/* in the place of a law that a kernel does not have */
struct dem_none
{
    char unused;
};

enum
{
    /* history columns of laws without history */
    dem_none_columns = 0,
    dem_hertz_columns = 0,
    dem_hooke_columns = 0,
    dem_dry_columns = 0,
    dem_viscous_columns = 0,
    dem_rolling_constant_columns = 0,
    dem_none_sets = 0,
    dem_jkr_sets = DEM_SETS_FN | DEM_SETS_STORED | DEM_SETS_LOST
};

DEM_MATH void dem_none_row(const struct dem_none *l, struct dem_contact_row *r, double *history)
{
    (void)l, (void)r, (void)history;
}

#define dem_none_adhesion_row dem_none_row

/* A linear spring gets its stiffness in a loop of its own (impact_speed.h). */
#define dem_hertz_before(l, b) (void)0
#define dem_hertz_force_row dem_hertz_row
#define dem_hooke_before(l, b) dem_impact_stiffnesses(&(l)->spring, b)
#define dem_hooke_hysteresis_before dem_hooke_before

/* A resistance to rolling without a spring has all of its moment in the first loop of a kernel. */
#define dem_none_begin(l, r, t, c, h) dem_none_row(l, r, h)
#define dem_none_limit(t, n) (void)(t)
#define dem_none_end(t, c, r, h) (void)0
#define dem_rolling_constant_begin(l, r, t, c, h) dem_rolling_constant_row(l, r, h)
#define dem_rolling_constant_limit dem_none_limit
#define dem_rolling_constant_end dem_none_end

/* The spring of rolling in the loops of a kernel; history: theta. */
DEM_MATH void dem_rolling_spring_begin(const struct dem_rolling_spring *l,
                                       const struct dem_contact_row *r,
                                       struct dem_slider_columns *t, int c, double *theta)
{
    dem_slider_begin(r, dem_rolling_slider(l, r, theta), t, c, theta);
}

#define dem_rolling_spring_limit dem_slider_limit_forces

DEM_MATH void dem_rolling_spring_end(const struct dem_slider_columns *t, int c,
                                     struct dem_contact_row *r, double *theta)
{
    const struct dem_slider s = dem_slider_end(t, c, theta);

    dem_slider_keep(&s, theta);
    dem_rolling_spring_add(&s, r);
}

/* What normal law and damping add to or set, except kn, which may have been set before. */
DEM_MATH void dem_fused_begin(struct dem_contact_row *r)
{
    r->eta = r->fn = r->adhesive_force = 0.0;
}

/* the laws of a kernel by their place in LAWS, with a suffix */
#define DEM_FUSED_NORMAL(suffix, ...) DEM_FUSED_NORMAL_(suffix, __VA_ARGS__)
#define DEM_FUSED_DAMPING(suffix, ...) DEM_FUSED_DAMPING_(suffix, __VA_ARGS__)
#define DEM_FUSED_FRICTION(suffix, ...) DEM_FUSED_FRICTION_(suffix, __VA_ARGS__)
#define DEM_FUSED_ROLLING(suffix, ...) DEM_FUSED_ROLLING_(suffix, __VA_ARGS__)
#define DEM_FUSED_FILM(suffix, ...) DEM_FUSED_FILM_(suffix, __VA_ARGS__)
#define DEM_FUSED_NORMAL_(suffix, normal, damping, friction, rolling, film) dem_##normal##suffix
#define DEM_FUSED_DAMPING_(suffix, normal, damping, friction, rolling, film) dem_##damping##suffix
#define DEM_FUSED_FRICTION_(suffix, normal, damping, friction, rolling, film) dem_##friction##suffix
#define DEM_FUSED_ROLLING_(suffix, normal, damping, friction, rolling, film) dem_##rolling##suffix
#define DEM_FUSED_FILM_(suffix, normal, damping, friction, rolling, film) dem_##film##suffix

/* the function that the template defines */
#define DEM_FUSED_NAME(...) DEM_FUSED_NAME_(__VA_ARGS__)
#define DEM_FUSED_NAME_(normal, damping, friction, rolling, film)                              \
    normal##_##damping##_##friction##_##rolling##_##film

/* a row of a table of kernels */
#define DEM_FUSED_ROW(normal, damping, friction, rolling, film)                                \
    {                                                                                          \
        {&dem_##normal, &dem_##damping, &dem_##friction, &dem_##rolling, &dem_##film},         \
            DEM_FUSED_NAME_(normal, damping, friction, rolling, film)                          \
    }
