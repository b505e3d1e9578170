/*
 * fused_hooke.c -- the fused kernels with the normal laws hooke and hookeHysteresis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "laws/fused/fused_kernel.h"

#define LAWS hooke, none, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, dry, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, dry, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, dry, linear, rolling_constant, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, dry, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, dry, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, viscous, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, viscous, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, viscous, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, viscous, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, stokes_damping, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, stokes_damping, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, stokes_damping, mindlin, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke, stokes_damping, mindlin, rolling_spring, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke_hysteresis, dry, linear, none, none
#include "laws/fused/fused_loop.h"
#define LAWS hooke_hysteresis, dry, linear, rolling_spring, none
#include "laws/fused/fused_loop.h"

const struct dem_fused_kernel dem_fused_hooke[] = {
    DEM_FUSED_ROW(hooke, none, linear, none, none),
    DEM_FUSED_ROW(hooke, dry, linear, none, none),
    DEM_FUSED_ROW(hooke, dry, linear, rolling_spring, none),
    DEM_FUSED_ROW(hooke, dry, linear, rolling_constant, none),
    DEM_FUSED_ROW(hooke, dry, mindlin, none, none),
    DEM_FUSED_ROW(hooke, dry, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hooke, viscous, linear, none, none),
    DEM_FUSED_ROW(hooke, viscous, linear, rolling_spring, none),
    DEM_FUSED_ROW(hooke, viscous, mindlin, none, none),
    DEM_FUSED_ROW(hooke, viscous, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hooke, stokes_damping, linear, none, none),
    DEM_FUSED_ROW(hooke, stokes_damping, linear, rolling_spring, none),
    DEM_FUSED_ROW(hooke, stokes_damping, mindlin, none, none),
    DEM_FUSED_ROW(hooke, stokes_damping, mindlin, rolling_spring, none),
    DEM_FUSED_ROW(hooke_hysteresis, dry, linear, none, none),
    DEM_FUSED_ROW(hooke_hysteresis, dry, linear, rolling_spring, none),
    {.apply = NULL}};
