/*
 * effect.h -- the contract between the house and one effect. An effect file includes this header only.
 *
 * An effect is one file and one row: it describes itself once (word, sentence, source, numbers with units, remembered
 * columns) and the house derives input, errors, tables, restart, search distance and time step from that.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_EFFECTS_EFFECT_H
#define DEM_EFFECTS_EFFECT_H

#include "base/error.h"
#include "base/field.h"
#include "effects/block.h"
#include <stddef.h>

/* A kernel is compiled for any x86-64, for AVX2 and for AVX-512, chosen at load time; contraction is off, so all give the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && !defined(DEM_NO_CLONES)
#define DEM_KERNEL __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define DEM_KERNEL
#endif

enum dem_stage                                            /* the order in which effects act; one NORMAL and one DAMP per pair */
{
    DEM_STAGE_NORMAL,
    DEM_STAGE_DAMP,
    DEM_STAGE_TANGENT,
    DEM_STAGE_MOMENT,
    DEM_STAGE_BOND,                                       /* from here on a contact effect may act past touching */
    DEM_STAGE_FILM,
    DEM_STAGE_BODY,                                       /* from here on an effect acts on bodies */
    DEM_STAGE_FLUID,
    DEM_STAGES
};

enum dem_needs                                            /* optional columns of a tray */
{
    DEM_NEEDS_SPIN = 1,                                   /* wx wy wz */
    DEM_NEEDS_VISCOSITY = 2,                              /* contact: viscosity of the running fluid */
    DEM_NEEDS_FLUID = 4,                                  /* body: the fluid columns */
    DEM_NEEDS_CHANCE = 8,                                 /* contact: chance */
    DEM_NEEDS_SWING = 16,                                 /* contact: swing, for what slider.h turns with the pair */
    DEM_NEEDS_ACCELERATION = 32,                          /* body: ax ay az of the fluid */
    DEM_NEEDS_VORTICITY = 64,                             /* body: ox oy oz */
    DEM_NEEDS_STRESS = 128,                               /* body: sx sy sz */
    DEM_NEEDS_MEAN_DIAMETER = 256                         /* body: mean_diameter */
};

struct dem_material
{
    char name[48];
    double density;                                       /* kg/m3 */
    double youngs_modulus;                                /* Pa    */
    double poissons_ratio;                                /* 1     */
    double yield_strength;                                /* Pa    0: not told. No law takes it, the plan does */
};

struct dem_pair_class                                     /* what all contacts of two materials share */
{
    const struct dem_material *a, *b;                     /* b is the wall's where with_wall */
    int with_wall;
    double reduced_modulus;                               /* Pa   E*, 1/E* = sum (1 - nu^2)/E */
    double reduced_shear;                                 /* Pa   G*, 1/G* = sum 2 (2 - nu)(1 + nu)/E */
    double exponent;                                      /* 1    of the normal law in the overlap: 1 linear, 3/2 Hertz */
    double least_radius;                                  /* m    smallest reduced radius present */
    double least_mass;                                    /* kg   smallest reduced mass present */
    double widest;                                        /* m    largest R_i + R_j present; R_i at a wall */
};

struct dem_effect
{
    const char *name;                                     /* the user's word */
    const char *says;                                     /* one sentence */
    const char *source;                                   /* the paper */
    enum dem_stage stage;
    unsigned needs;                                       /* enum dem_needs, or-ed */
    double exponent;                                      /* NORMAL only: of the force in the overlap */
    int drag;                                             /* FLUID only: 1 for a law of drag, of which a scene takes one */
    int reacts;                                           /* FLUID only: 1: the fluid gets the opposite of its explicit force, in r of the tray */
    int inertia;                                          /* FLUID only: 1: open_bodies tells an added mass */
    int turns;                                            /* FLUID only: 1: it has a rotational drag, t of the tray */
    const char *excludes;                                 /* word of an effect whose work it would do again; NULL: none */
    size_t size;                                          /* bytes of the settings struct; 0 for none */
    const struct dem_field *settings;                     /* its numbers, ended by a row of zeros; NULL for none */
    const char *const *memory;                            /* names of remembered columns, ended by NULL; NULL for none */
    int forgets;                                          /* 1: act itself leaves +0 in them where overlap and touching are 0 */

    /* What it needs besides, with these settings: enum dem_needs, or-ed. May be NULL. */
    unsigned (*asks)(const void *settings);

    /* Derive constants and refuse nonsense. The class is NULL for body effects. May be NULL. */
    int (*prepare)(void *settings, const struct dem_pair_class *);

    /* BOND and FILM: the largest gap at which it acts [m]. NULL: acts in contact only. */
    double (*reach)(const void *settings, const struct dem_pair_class *);

    /* The longest time step it stands [s], and why in a few words. NULL: any. */
    double (*time_limit)(const void *settings, const struct dem_pair_class *, const char **why);

    /* BOND and FILM: called before the first stage, may take overlap and touch from the laws of contact. May be NULL. */
    void (*shield)(const void *settings, struct dem_block *restrict, dem_real *const *memory);

    /* FILM: called between DAMP and TANGENT, sets grip of the tray, and its own note: what friction must know before act. May be NULL. */
    void (*adhere)(const void *settings, struct dem_block *restrict, dem_real *const *memory);

    /* How long an elastic impact of the smallest bodies lasts [s], at the speed that bounds the step; for the plan's
       table of contacts. NORMAL only, may be NULL. */
    double (*contact_time)(const void *settings, const struct dem_pair_class *);

    /* Contact effects: add to the tray. memory[k] is the k-th remembered column at the tray's rows; the house clears
       it where partners do not touch (stages before BOND). */
    void (*act)(const void *settings, struct dem_block *restrict, dem_real *const *memory);

    /* Contact effects: what rows hold and lose by this effect; called right after act, only in runs that keep a ledger of
       energy. `before` are the remembered columns as act found them, `memory` as it left them. NULL: the ledger takes the
       books of stages BOND and FILM, and otherwise measures the work that the effect has done. */
    void (*energy)(const void *settings, const struct dem_block *restrict, dem_real *const *before, dem_real *const *memory,
                   struct dem_energy *restrict);

    /* What follows from radius, mass, void fraction, density and viscosity alone: laws of drag fill the tray's `swarm`, effects of
       inertia add to `added`. These stay as they are in a window of the fluid; only then is it called, and act_on_bodies in each
       step. May be NULL. */
    void (*open_bodies)(const void *settings, struct dem_body_block *restrict);

    /* Body effects: add to the tray of bodies. */
    void (*act_on_bodies)(const void *settings, struct dem_body_block *restrict);
};

#endif
