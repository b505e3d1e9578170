/*
 * effect.h -- the descriptor of an effect (physical model); each effect includes this header.
 *
 * An effect is one file and one row in effects.h. Its descriptor
 * declares the name, one sentence, the source, settings with units and ranges, and history columns.
 * Input, error messages, the manual, restart, search distance and the limit of the time step follow
 * from it. docs/adding-an-effect.md has an example.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_LAWS_EFFECT_H
#define DEM_LAWS_EFFECT_H

#include "core/error.h"
#include "core/settings_table.h"
#include "laws/batch.h"
#include "laws/fluid/eddy.h"
#include "dem_numbers.h"
#include "laws/scalar.h"
#include <stddef.h>

/* A kernel is compiled for any x86-64, for AVX2 and for AVX-512; one of them is chosen at load
   time. Contraction to FMA is off, so all give the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && !defined(DEM_NO_CLONES)
#define DEM_KERNEL __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define DEM_KERNEL
#endif

/* order in which effects are applied; one NORMAL and one DAMP for each pair class */
enum dem_stage
{
    DEM_STAGE_NORMAL,
    DEM_STAGE_DAMP,
    DEM_STAGE_TANGENT,
    DEM_STAGE_MOMENT,
    /* from here on contact effects may act across a gap */
    DEM_STAGE_BOND,
    DEM_STAGE_FILM,
    /* contact effects that exchange scalars; all forces are known. Across a gap: those with a reach */
    DEM_STAGE_SCALAR,
    /* from here on effects act on single particles */
    DEM_STAGE_BODY,
    DEM_STAGE_FLUID,
    DEM_STAGES
};

enum dem_needs                                            /* optional columns of a batch */
{
    DEM_NEEDS_SPIN = 1,                                   /* wx wy wz */
    /* contact: viscosity of the coupled fluid */
    DEM_NEEDS_VISCOSITY = 2,
    DEM_NEEDS_FLUID = 4,                                  /* body: the fluid columns */
    DEM_NEEDS_RANDOM = 8,                                 /* contact: pair_random */
    /* contact: swing, by which slider.h rotates history vectors */
    DEM_NEEDS_NORMAL_SPIN = 16,
    DEM_NEEDS_ACCELERATION = 32,                          /* body: ax ay az of the fluid */
    DEM_NEEDS_VORTICITY = 64,                             /* body: ox oy oz */
    DEM_NEEDS_STRESS = 128,                               /* body: sx sy sz */
    DEM_NEEDS_MEAN_DIAMETER = 256,                        /* body: mean_diameter */
    DEM_NEEDS_TURBULENCE = 512,                           /* body: the fluid's fluctuation in u */
    DEM_NEEDS_RADII = 1024,                               /* contact with scalars: radii of both */
    DEM_NEEDS_DISSIPATION = 2048,                         /* contact: dissipated */
    DEM_NEEDS_FORM = 4096,                                /* body: sphericity crosswise lengthwise */
    DEM_NEEDS_INTERFACE = 8192                            /* body: tension_x y z, interface_distance */
};

/* how a law acts on parcels (laws/parcels.h) of the ratio l */
enum dem_parcels
{
    DEM_PARCELS_REFUSED,    /* it has no rule */
    DEM_PARCELS_SAME,       /* as on any particle: similar by itself, or by mass or volume */
    DEM_PARCELS_SETTINGS,   /* contact: prepare multiplies settings by powers of l */
    DEM_PARCELS_GRAINS      /* fluid: l^3 times as on a grain of 1/l of the diameter */
};

struct dem_material
{
    char name[48];
    double density;                                       /* kg/m3 */
    double youngs_modulus;                                /* Pa    */
    double poissons_ratio;                                /* 1     */
    /* Pa  0: not given. Used by `dem plan` only, by no law */
    double yield_strength;
    struct                                                /* 0: not given */
    {
        double conductivity;                              /* W/(m K)    */
        double heat_capacity;                             /* J/(kg K)  specific */
        double emissivity;                                /* 1          */
        double real_modulus;                              /* Pa  Young's modulus of the real
                                                             material, where that above is softer */
    } thermal;
};

/* constants of all contacts between two materials */
struct dem_pair_class
{
    /* b is the material of the wall where with_wall */
    const struct dem_material *a, *b;
    int with_wall;
    double reduced_modulus;  /* Pa   E*, 1/E* = sum (1 - nu^2)/E */
    double reduced_shear;    /* Pa   G*, 1/G* = sum 2 (2 - nu)(1 + nu)/E */
    /* 1  p of the normal law F ~ d^p: 1 linear, 3/2 Hertz */
    double exponent;
    double min_radius;       /* m    smallest reduced radius present */
    double min_mass;         /* kg   smallest reduced mass present, with added_density */
    double bond_radius;      /* m, kg  the same for bonds: clumps count with the radius of the sphere that */
    double bond_mass;        /*        bonds on all their spheres limit alike (particles/clump_shape.h) */
    double max_radius_sum;   /* m    largest R_i + R_j present; R_i at a wall */
    double fluid_density;    /* kg/m3  of the run's fluid; 0: none, or not uniform */
    /* 1: an effect that has_added_mass acts: reduced masses of contacts contain it */
    int inertia_has_added_mass;
    /* kg/m3  least added mass over volume of a particle, C rho of the fluid, for limits of the step;
       0: none, unknown, or contacts turn particles, whose moment of inertia contains none */
    double added_density;
    /* 1  smallest and largest ratio of the parcels of the run (laws/parcels.h); 0: none */
    double min_parcel_ratio, max_parcel_ratio;
};

struct dem_effect
{
    /* keyword in the scene */
    const char *name;
    /* a shorter keyword that scenes may use, too; or NULL */
    const char *short_name;
    /* words of other DEM codes for it, separated by blanks, for "did you mean"; or NULL */
    const char *aliases;
    /* one sentence */
    const char *summary;
    /* the paper */
    const char *source;
    /* a sentence: what the law does not do though users may expect it; or NULL */
    const char *limitation;
    enum dem_stage stage;
    /* its rule for parcels */
    enum dem_parcels parcels;
    /* enum dem_needs, or-ed */
    unsigned needs;
    /* NORMAL only: p of F ~ d^p */
    double exponent;
    /* FLUID only: a drag law, and what it is valid for; a scene has at most one */
    enum dem_drag drag;
    /* FLUID only: a law of transfer: the scalar that it exchanges with the fluid; a scene has at most
       one law for each scalar */
    const struct dem_scalar *transfers;
    /* FLUID only: 1: the opposite of its explicit force (rx ry rz) acts on the fluid */
    int has_reaction;
    /* FLUID only: 1: prepare_bodies sets an added mass */
    int has_added_mass;
    /* FLUID only: 1: it sets a rotational drag (spin_drag) */
    int has_rotational_drag;
    /* FLUID only: 1: the force of the full pressure gradient, which contains buoyancy */
    int has_pressure_gradient;
    /* names of effects that model the same thing and cannot be combined with this one, separated by
       blanks; NULL: none */
    const char *excludes;
    /* values for its required settings, as text of a scene, with which tests try it out; NULL: none
       are required */
    const char *example;
    /* bytes of the settings struct; 0 for none */
    size_t size;
    /* descriptors of the settings, ended by a row of zeros; or NULL */
    const struct dem_setting *settings;
    /* names of the history columns, ended by NULL; or NULL */
    const char *const *history;
    /* the particle scalars that it reads or changes, ended by NULL; or NULL */
    const struct dem_scalar *const *scalars;
    /* BOND only: the history column that is 1 for pairs listed in the scene's entry `bonds`; or
       NULL */
    const char *listed_column;
    /* 1: `apply` itself sets them to +0 where overlap and touching are 0, so the caller need not
       clear them */
    int clears_history;

    /* Further columns that it needs with these settings: enum dem_needs, or-ed. May be NULL. */
    unsigned (*extra_needs)(const void *settings);

    /* Derive constants, check settings against each other and against the pair class.
       Returns DEM_OK or an error. The class is NULL for body effects. May be NULL. */
    int (*prepare)(void *settings, const struct dem_pair_class *);

    /* BOND, FILM and SCALAR: the largest gap across which it acts [m]. NULL: acts in contact only. */
    double (*reach)(const void *settings, const struct dem_pair_class *);

    /* The largest stable time step [s]; *why: its name in a few words, not to be freed.
       NULL: no limit. */
    double (*time_limit)(const void *settings, const struct dem_pair_class *, const char **why);

    /* BOND and FILM: called before the first stage; may clear overlap and touching, so that the
       contact laws do not act. May be NULL. */
    void (*replace_contact)(const void *settings, struct dem_contact_batch *restrict, double *const *history);

    /* FILM: called between DAMP and TANGENT; sets the adhesive force (adhesive_force), which the friction
       limit needs before `apply`, and its own column (scratch). May be NULL. */
    void (*set_adhesion)(const void *settings, struct dem_contact_batch *restrict, double *const *history);

    /* Duration of an elastic impact of the smallest bodies [s] at the speed that bounds the time
       step; for the contact table of `dem plan`. NORMAL only, may be NULL. */
    double (*contact_time)(const void *settings, const struct dem_pair_class *);

    /* Contact effects: add to the results of the batch. history[k] is the k-th history column at
       the rows of the batch; the caller clears it where partners do not touch (stages before
       BOND). */
    void (*apply)(const void *settings, struct dem_contact_batch *restrict, double *const *history);

    /* Contact effects: energy stored and dissipated by this effect, for each row. Called right
       after `apply`, only in runs with an energy balance. `before` are the history columns before
       `apply`, `history` after it. NULL: the energy balance takes stored and lost of the batch
       (stages BOND and FILM), or else measures the work done by the effect. */
    void (*energy)(const void *settings, const struct dem_contact_batch *restrict, double *const *before, double *const *history,
                   struct dem_energy *restrict);

    /* What depends on radius, mass, void fraction, density and viscosity only: drag laws fill the
       voidage factors (`voidage_factor`), effects of inertia add to `added_mass`. Called once for each coupling
       window, in which these are constant; apply_to_bodies is called in each step. May be NULL. */
    void (*prepare_bodies)(const void *settings, struct dem_body_batch *restrict);

    /* Body effects: add to the results of the body batch. */
    void (*apply_to_bodies)(const void *settings, struct dem_body_batch *restrict);

    /* Whether a scene needs the effect, for `dem plan`: fills in the relevance and returns 1, or
       returns 0 if the numbers do not tell. settings NULL: the effect is not in use. `mechanism`
       sets the order. Drag laws have none: they are judged by their range. May be NULL:
       nothing is said, for example of friction, which depends on surfaces. */
    int (*relevance)(const void *settings, const struct dem_regime *, struct dem_relevance *);
    enum dem_mechanism mechanism;

    /* A line on the scene in dimensionless numbers of this effect, which is in use, for `dem plan`.
       Returns 0 for none. May be NULL. */
    int (*describe)(const void *settings, const struct dem_regime *, char *line, size_t size);

    /* Contact effects: what follows from the settings for the smallest partners of a pair class, for
       the contact table of `dem plan`: ", NAME VALUE UNIT, ...". May be NULL. */
    void (*describe_pair)(const void *settings, const struct dem_pair_class *, char *line,
                          size_t size);

    /* Contact effects: 1 if with these settings it holds particles together: adhesion, cohesion,
       bonds. NULL: never. */
    int (*adhesive)(const void *settings);

    /* BOND only: 1 if these settings make bonds of the pairs that the scene lists in its entry
       `bonds`, else 0. NULL: the effect does not read the list. */
    int (*makes_listed)(const void *settings);

    /* DAMP only: the added mass coefficient that the law itself counts with these settings [1]; 0:
       none. Cannot be combined with an effect that has_added_mass. May be NULL. */
    double (*own_added_mass)(const void *settings);
    /* FLUID with has_added_mass: smallest C, whatever the void fraction; NULL: 0 is counted on */
    double (*least_added_mass)(const void *settings);

    /* FLUID only: sets the model of the eddies that the particles are in (DEM_NEEDS_TURBULENCE).
       May be NULL. */
    void (*eddies)(const void *settings, struct dem_eddies *);

    /* BODY only: sets g to the acceleration [m/s2] that it gives to all particles alike: gravity.
       The energy balance counts its work as potential energy, beds and hydrostatic pressure are
       related to it. NULL: none. See dem_interaction_table_gravity. */
    void (*uniform_acceleration)(const void *settings, double g[3]);
};

/* For `adhesive`: with any settings. */
static inline int dem_effect_always(const void *settings)
{
    (void)settings;
    return 1;
}

/* 1 when a contact effect may act across a gap. */
static inline int dem_effect_acts_past_touching(const struct dem_effect *e)
{
    return e->stage == DEM_STAGE_BOND || e->stage == DEM_STAGE_FILM || e->reach != NULL;
}

#endif
