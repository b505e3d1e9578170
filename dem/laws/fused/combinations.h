/*
 * combinations.h -- the combinations of contact laws that are computed in one loop.
 *
 * A row is a kernel: the laws of the stages NORMAL, DAMP, TANGENT and MOMENT by their names, none where
 * there is none. An effect list that begins with these laws takes the kernel for them, whatever
 * follows; all others take the loops of their effects, one after the other, with the same bits. To add
 * a kernel: add a row; its laws need a header with the row function (laws/row.h).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_COMBINATIONS_H
#define DEM_LAWS_COMBINATIONS_H

/* compiled in fused_hertz.c */
#define DEM_FUSED_HERTZ(KERNEL)                                                                \
    KERNEL(hertz, dry, mindlin, none)                                                          \
    KERNEL(hertz, dry, mindlin, rolling_spring)                                                \
    KERNEL(hertz, dry, mindlin, rolling_constant)                                              \
    KERNEL(hertz, dry, linear, none)                                                           \
    KERNEL(hertz, dry, linear, rolling_spring)                                                 \
    KERNEL(hertz, viscous, mindlin, none)                                                      \
    KERNEL(hertz, viscous, mindlin, rolling_spring)                                            \
    KERNEL(hertz, viscous, linear, none)                                                       \
    KERNEL(hertz, viscous, linear, rolling_spring)                                             \
    KERNEL(hertz, stokes, mindlin, none)                                                       \
    KERNEL(hertz, stokes, mindlin, rolling_spring)                                             \
    KERNEL(hertz, stokes, mindlin, rolling_constant)                                           \
    KERNEL(hertz, stokes, linear, none)                                                        \
    KERNEL(hertz, stokes, linear, rolling_spring)

/* in fused_hooke.c */
#define DEM_FUSED_HOOKE(KERNEL)                                                                \
    KERNEL(hooke, none, linear, none)                                                          \
    KERNEL(hooke, dry, linear, none)                                                           \
    KERNEL(hooke, dry, linear, rolling_spring)                                                 \
    KERNEL(hooke, dry, linear, rolling_constant)                                               \
    KERNEL(hooke, dry, mindlin, none)                                                          \
    KERNEL(hooke, dry, mindlin, rolling_spring)                                                \
    KERNEL(hooke, viscous, linear, none)                                                       \
    KERNEL(hooke, viscous, linear, rolling_spring)                                             \
    KERNEL(hooke, viscous, mindlin, none)                                                      \
    KERNEL(hooke, viscous, mindlin, rolling_spring)                                            \
    KERNEL(hooke, stokes, linear, none)                                                        \
    KERNEL(hooke, stokes, linear, rolling_spring)                                              \
    KERNEL(hooke, stokes, mindlin, none)                                                       \
    KERNEL(hooke, stokes, mindlin, rolling_spring)                                             \
    KERNEL(hooke_hysteresis, dry, linear, none)                                                \
    KERNEL(hooke_hysteresis, dry, linear, rolling_spring)

/* and with an adhesive film, whose force counts in the friction limit: in fused_adhesive.c */
#define DEM_FUSED_ADHESIVE(KERNEL) KERNEL(hertz, dry, mindlin, none, jkr)

#endif
