/*
 * fused_kernel.h -- the loops of a fused kernel, made of the row functions of its laws.
 *
 * 1. Normal law, damping and the stiffness of friction, which shares a root with hertz.
 * 2. Trial forces of the springs of friction and rolling.
 * 3. The limits of these (slider.h).
 * 4. Forces and moments.
 *
 * In one long loop the latencies of square roots and divisions would add up; in short ones the
 * latencies of several rows overlap.
 *
 * History is cleared where partners are apart, as step/sweep_contacts.c does after an effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_FUSED_KERNEL_H
#define DEM_LAWS_FUSED_KERNEL_H

#include "laws/contact/dry.h"
#include "laws/contact/hertz.h"
#include "laws/contact/hooke.h"
#include "laws/contact/hooke_hysteresis.h"
#include "laws/contact/jkr.h"
#include "laws/contact/linear.h"
#include "laws/contact/mindlin.h"
#include "laws/contact/rolling_constant.h"
#include "laws/contact/rolling_spring.h"
#include "laws/contact/stokes.h"
#include "laws/contact/viscous.h"
#include "laws/effects.h"
#include "laws/fused/combinations.h"
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
    dem_none_columns = 0
};

DEM_MATH void dem_none_row(const struct dem_none *l, struct dem_contact_row *r, double *history)
{
    (void)l, (void)r, (void)history;
}

#define dem_none_adhesion_row dem_none_row

/* A resistance to rolling without a spring has all of its moment in the first loop of a kernel. */
#define dem_none_begin(l, r, t, c, h) dem_none_row(l, r, h)
#define dem_none_limit(t, n) (void)(t)
#define dem_none_end(t, c, r, h) (void)0
#define dem_rolling_constant_begin(l, r, t, c, h) dem_rolling_constant_row(l, r, h)
#define dem_rolling_constant_limit dem_none_limit
#define dem_rolling_constant_end dem_none_end

/* What normal law and damping add to or set, except kn, which may have been set before. */
DEM_MATH void dem_fused_begin(struct dem_contact_row *r)
{
    r->eta = r->fn = r->adhesive_force = 0.0;
}

#define DEM_FUSED_NAME(normal, damping, friction, rolling, film)                               \
    normal##_##damping##_##friction##_##rolling##_##film

#define DEM_FUSED_LOOP(normal, damping, friction, rolling, film, ...)                          \
    DEM_KERNEL                                                                                 \
    static void DEM_FUSED_NAME(normal, damping, friction, rolling, film)(                      \
        const void *const settings[DEM_FUSED_LAWS], struct dem_contact_batch *restrict b,      \
        double *const *history)                                                                \
    {                                                                                          \
        enum                                                                                   \
        {                                                                                      \
            DAMPING = dem_##normal##_columns,                                                  \
            FRICTION = DAMPING + dem_##damping##_columns,                                      \
            ROLLING = FRICTION + dem_##friction##_columns,                                     \
            FILM = ROLLING + dem_##rolling##_columns,                                          \
            COLUMNS = FILM + dem_##film##_columns                                              \
        };                                                                                     \
        const struct dem_##normal a = *(const struct dem_##normal *)settings[0];               \
        const struct dem_##damping d = *(const struct dem_##damping *)settings[1];             \
        const struct dem_##friction f = *(const struct dem_##friction *)settings[2];           \
        const struct dem_##rolling m = *(const struct dem_##rolling *)settings[3];             \
        const struct dem_##film g = *(const struct dem_##film *)settings[4];                   \
        const double inverse_dt = dem_contact_batch_inverse_dt(b);                             \
        struct dem_slider_columns slips, rolls;                                                \
                                                                                               \
        dem_##normal##_before(&a, b);                                                          \
        DEM_INDEPENDENT_ROWS                                                                   \
        for (int c = 0; c < b->n; c++)                                                         \
        {                                                                                      \
            struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);                 \
            double h[DEM_LAW_HISTORY];                                                         \
                                                                                               \
            dem_history_load(history, FRICTION, c, h);                                         \
            dem_history_load(history + FILM, COLUMNS - FILM, c, h + FILM);                     \
            dem_fused_begin(&r);                                                               \
            dem_##normal##_row(&a, &r, h);                                                     \
            dem_##damping##_row(&d, &r, h + DAMPING);                                          \
            dem_##film##_adhesion_row(&g, &r, h + FILM);                                       \
            r.kt = dem_##friction##_stiffness(&f, &r);                                         \
            dem_history_clear_apart(&r, FRICTION, h);                                          \
            dem_history_store(h, FRICTION, c, history);                                        \
            DEM_STORE(kn, kt, eta, fn, adhesive_force, scratch)                                \
        }                                                                                      \
        DEM_INDEPENDENT_ROWS                                                                   \
        for (int c = 0; c < b->n; c++)                                                         \
        {                                                                                      \
            struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);                 \
            double h[DEM_LAW_HISTORY];                                                         \
                                                                                               \
            dem_history_load(history + FRICTION, FILM - FRICTION, c, h + FRICTION);            \
            r.mx = r.my = r.mz = 0.0;                                                          \
            dem_slider_begin(&r, dem_friction_slider(&f.common, &r, h + FRICTION), &slips, c,  \
                             h + FRICTION);                                                    \
            dem_##rolling##_begin(&m, &r, &rolls, c, h + ROLLING);                             \
            dem_history_store(h + FRICTION, FILM - FRICTION, c, history + FRICTION);           \
            DEM_STORE(mx, my, mz)                                                              \
        }                                                                                      \
        dem_slider_limit_forces(&slips, b->n);                                                 \
        dem_##rolling##_limit(&rolls, b->n);                                                   \
        DEM_INDEPENDENT_ROWS                                                                   \
        for (int c = 0; c < b->n; c++)                                                         \
        {                                                                                      \
            struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);                 \
            double h[DEM_LAW_HISTORY];                                                         \
                                                                                               \
            dem_history_load(history + FRICTION, COLUMNS - FRICTION, c, h + FRICTION);         \
            r.fx = r.fy = r.fz = 0.0;                                                          \
            dem_slider_end(&slips, c, (double *[3]){&r.fx, &r.fy, &r.fz}, h + FRICTION);       \
            dem_##rolling##_end(&rolls, c, &r, h + ROLLING);                                   \
            dem_history_clear_apart(&r, FILM - FRICTION, h + FRICTION);                        \
            dem_##film##_row(&g, &r, h + FILM);                                                \
            dem_history_store(h + FRICTION, COLUMNS - FRICTION, c, history + FRICTION);        \
            DEM_STORE(fx, fy, fz, __VA_ARGS__)                                                 \
        }                                                                                      \
    }

/* kernels without and with a film */
#define DEM_FUSED_DEFINE(normal, damping, friction, rolling)                                   \
    DEM_FUSED_LOOP(normal, damping, friction, rolling, none, mx, my, mz)
#define DEM_FUSED_DEFINE_FILM(normal, damping, friction, rolling, film)                        \
    DEM_FUSED_LOOP(normal, damping, friction, rolling, film, mx, my, mz, fn, stored, lost)

/* rows of a table of kernels */
#define DEM_FUSED_ROW(normal, damping, friction, rolling)                                      \
    DEM_FUSED_ROW_FILM(normal, damping, friction, rolling, none)
#define DEM_FUSED_ROW_FILM(normal, damping, friction, rolling, film)                           \
    {{&dem_##normal, &dem_##damping, &dem_##friction, &dem_##rolling, &dem_##film},            \
     DEM_FUSED_NAME(normal, damping, friction, rolling, film)},

#endif
