/*
 * fused_kernel.h -- the loop of a fused kernel, made of the row functions of its laws.
 *
 * History is cleared where partners are apart, as step/sweep_contacts.c does after an effect.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_FUSED_KERNEL_H
#define DEM_EFFECTS_FUSED_KERNEL_H

#include "effects/contact/dry.h"
#include "effects/contact/hertz.h"
#include "effects/contact/hooke.h"
#include "effects/contact/hooke_hysteresis.h"
#include "effects/contact/jkr.h"
#include "effects/contact/linear.h"
#include "effects/contact/mindlin.h"
#include "effects/contact/rolling_constant.h"
#include "effects/contact/rolling_spring.h"
#include "effects/contact/stokes.h"
#include "effects/contact/viscous.h"
#include "effects/effects.h"
#include "effects/fused/combinations.h"
#include "effects/fused/fused.h"

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

/* What the laws of a row add to or set, except kn, which may have been set before. */
DEM_MATH void dem_fused_begin(struct dem_contact_row *r)
{
    r->kt = r->eta = r->adhesive_force = 0.0;
    r->fn = r->fx = r->fy = r->fz = 0.0;
    r->mx = r->my = r->mz = 0.0;
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
                                                                                               \
        dem_##normal##_before(&a, b);                                                          \
        DEM_INDEPENDENT_ROWS                                                                   \
        for (int c = 0; c < b->n; c++)                                                         \
        {                                                                                      \
            struct dem_contact_row r = dem_contact_row_load(b, c, inverse_dt);                 \
            double h[DEM_LAW_HISTORY];                                                         \
                                                                                               \
            dem_history_load(history, COLUMNS, c, h);                                          \
            dem_fused_begin(&r);                                                               \
            dem_##normal##_row(&a, &r, h);                                                     \
            dem_##damping##_row(&d, &r, h + DAMPING);                                          \
            dem_##film##_adhesion_row(&g, &r, h + FILM);                                       \
            dem_##friction##_row(&f, &r, h + FRICTION);                                        \
            dem_##rolling##_row(&m, &r, h + ROLLING);                                          \
            dem_history_clear_apart(&r, FILM, h);                                              \
            dem_##film##_row(&g, &r, h + FILM);                                                \
            dem_history_store(h, COLUMNS, c, history);                                         \
            DEM_STORE(__VA_ARGS__)                                                             \
        }                                                                                      \
    }

/* kernels without and with a film */
#define DEM_FUSED_DEFINE(normal, damping, friction, rolling)                                   \
    DEM_FUSED_LOOP(normal, damping, friction, rolling, none, kn, fn, fx, fy, fz, mx, my, mz)
#define DEM_FUSED_DEFINE_FILM(normal, damping, friction, rolling, film)                        \
    DEM_FUSED_LOOP(normal, damping, friction, rolling, film, kn, fn, fx, fy, fz, mx, my, mz,   \
                   stored, lost)

/* rows of a table of kernels */
#define DEM_FUSED_ROW(normal, damping, friction, rolling)                                      \
    DEM_FUSED_ROW_FILM(normal, damping, friction, rolling, none)
#define DEM_FUSED_ROW_FILM(normal, damping, friction, rolling, film)                           \
    {{&dem_##normal, &dem_##damping, &dem_##friction, &dem_##rolling, &dem_##film},            \
     DEM_FUSED_NAME(normal, damping, friction, rolling, film)},

#endif
