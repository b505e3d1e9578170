/*
 * dem_plan.h -- advice on a run before and while it runs: plan and warnings; and the library's list
 * of effects as text.
 *
 * dem.h has the rules for return values, ownership and collective calls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_PLAN_H
#define DEM_PLAN_H

#include "dem_types.h"

#ifdef __cplusplus
extern "C" {
#endif

struct dem;

/* ---- plan ------------------------------------------------------------------------------------ */

/* 1  largest void fraction of a bed: particles that touch. Random loose packings of spheres have
   0.44 (Onoda and Liniger, Phys. Rev. Lett. 64 (1990) 2727), of cohesive ones up to this. */
#define DEM_BED_VOID_FRACTION 0.6

/* what the program knows of the run ahead, for dem_plan; 0 where unknown */
struct dem_run_info
{
    double duration;       /* s  from now on */
    double window;         /* s  time step of a coupled fluid */
    const char *why;       /* what limits the window, in a few words */
    double cross_section;  /* m2 of the bed, mean over dem_bed_slab; 0: estimated from the walls */
    double reached_window; /* s  time step that an adjusted one grows to; 0: `window` */
    const char *reached_why;  /* what limits that */
    double inflow;         /* m/s  superficial velocity of the fluid that enters, against gravity */

    /* of a mesh and its fluid */
    double volume, cell;      /* m3 of all cells; m  cube root of the smallest cell */
    double speed, vorticity;  /* m/s, 1/s  largest */
    int one_way;              /* 1: particles do not act on the fluid */
    double patch_speed;       /* m/s  largest speed of the fluid on a patch */
    double resolution;        /* m  length that a particle should not cross in half a window: the
                                 smallest cell, or half the kernel's width */
    int inflow_varies;        /* 1: `inflow` is the start's and may change with time */
};

/* Collective; in coupled runs after the fluid columns have been written. A report on the run ahead:
   effects, walls, particles, time step, bed, fluid, memory and run time, as lines of text, the same
   on all ranks, valid until the next dem_plan of this thread. Measures steps and lists of as many
   particles as a rank has, at most 250000, for 0.02 s each, at least 10 steps. No particle moves; views
   stay valid. */
int dem_plan(struct dem *, const struct dem_run_info *, const char **text);

/* Collective, as dem_plan. What of the scene is likely to be a mistake or cannot work, as a
   numbered list under the line WARNINGS, each item with the entry to change; *text is "" when there
   is nothing. `own`: n sentences of the program, which come first. Valid until the next call of this
   thread. */
int dem_warnings(struct dem *, const struct dem_run_info *, int n, const char *const *own,
                 const char **text);

/* Collective, between two advances, with the largest overlap that dem_totals has returned since the
   last call. *text: a sentence when contacts overlap by more than 10 %, or when a particle is
   faster than impactSpeed so that its impacts will overlap by more than 5 %, with the settings to
   take; "" otherwise, and when it was said before, unless it has grown by half. */
int dem_impact_warning(struct dem *, double overlap, const char **text);

/* Collective. The slab of the bed between 10 and 90 % of the volume of the particles
   that move: heights x . up [m], up against gravity. Returns 0, and zeros, without gravity or such
   particles. */
int dem_bed_slab(const struct dem *, double up[3], double *low, double *high);

/* m/s: speed at which one sphere settles or rises in a fluid at rest, by the drag law of Schiller and Naumann; diameter [m],
   densities [kg/m3], viscosity [Pa s], gravity [m/s2]. */
double dem_sphere_terminal_velocity(double diameter, double density, double fluid_density, double viscosity,
                                    double gravity);

/* ---- effects of the library ------------------------------------------------------------------ */

/* None of these needs a case or a run. */

/* An effect as text: name, stage, what it does, source, limitation; each setting with unit,
   default, range and meaning. All effects with NULL. DEM_ERROR_INPUT for a name that no effect has.
   *text is valid until the next call of this thread. */
int dem_effect_text(const char *effect, const char **text);

/* what an effect takes from the fluid or gives to the particles, or-ed: dem_effect_traits */
enum dem_effect_trait
{
    DEM_TRAIT_PRESSURE_GRADIENT = 1,   /* the force of the full pressure gradient */
    DEM_TRAIT_FLUID_ACCELERATION = 2,  /* reads Du/Dt of the fluid: added mass */
    DEM_TRAIT_FLUID_STRESS = 4,        /* reads div tau of the fluid */
    DEM_TRAIT_FLUID = 8,               /* acts in a fluid only */
    DEM_TRAIT_TURBULENCE = 32,         /* reads k and epsilon of the fluid */
    DEM_TRAIT_INTERFACE = 64,          /* reads the interface of two fluids */
    DEM_TRAIT_VISCOSITY = 16           /* reads the viscosity, unless it has a setting of its own */
};

/* The traits of the effect with this name; 0 without any, and for a name that no effect has. */
unsigned dem_effect_traits(const char *effect);

#ifdef __cplusplus
}
#endif
#endif
