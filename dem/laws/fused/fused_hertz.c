/*
 * fused_hertz.c -- the fused kernels with the normal law hertz.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

#define LAWS hertz, dry, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, dry, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, dry, mindlin, rolling_constant, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, dry, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, dry, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, viscous, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, viscous, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, viscous, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, viscous, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, stokes_damping, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, stokes_damping, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, stokes_damping, mindlin, rolling_constant, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, stokes_damping, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hertz, stokes_damping, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"

const struct dem_fused_kernel dem_fused_hertz[] = {
    DEM_FUSED_ROW(hertz, dry, mindlin, none, none),
    DEM_FUSED_ROW(hertz, dry, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hertz, dry, mindlin, rolling_constant, none),
    DEM_FUSED_ROW(hertz, dry, linear, none, none),
    DEM_FUSED_ROW(hertz, dry, linear, rolling_spring, none),
    DEM_FUSED_ROW(hertz, viscous, mindlin, none, none),
    DEM_FUSED_ROW(hertz, viscous, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hertz, viscous, linear, none, none),
    DEM_FUSED_ROW(hertz, viscous, linear, rolling_spring, none),
    DEM_FUSED_ROW(hertz, stokes_damping, mindlin, none, none),
    DEM_FUSED_ROW(hertz, stokes_damping, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hertz, stokes_damping, mindlin, rolling_constant, none),
    DEM_FUSED_ROW(hertz, stokes_damping, linear, none, none),
    DEM_FUSED_ROW(hertz, stokes_damping, linear, rolling_spring, none),
    {.apply = NULL}};
