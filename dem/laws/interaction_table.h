/*
 * interaction_table.h -- the interaction table: which effects act on which pair of materials, in
 * which order, with which settings.
 *
 * Order of use: add materials, choose effects, set numbers and words (for all contacts or for one
 * pair of materials), freeze. After that the table is read only: class_of gives the pair class of a
 * contact, list[class] the list of effects that act on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "laws/effect.h"
#include "laws/fused/fused.h"
#include "laws/parcels.h"

enum
{
    DEM_MATERIALS = 32,          /* limit of a scene */
    DEM_EFFECT_LIST_LIMIT = 16,  /* limit of the effects of one pair class */
    DEM_HISTORY_COLUMNS = 32,    /* limit of the history columns of all effects */
    DEM_OVERRIDES = 256          /* limit of the settings for one pair of materials */
};

/* the other side of a contact: first index of class_of */
enum dem_partner
{
    DEM_PARTNER_PARTICLE,
    DEM_PARTNER_WALL,
    DEM_PARTNER_FRICTIONLESS,    /* a wall with the normal force and its damping only */
    DEM_PARTNERS
};

struct dem_effect_entry           /* entry of an effect list */
{
    const struct dem_effect *effect;
    void *settings;               /* prepared, owned by the interaction table */
    int first_column;             /* first of its history columns */
    short scalars;                /* number of its particle scalars */
    short grains;                 /* 1: acts on the grains of parcels (step/parcel_forces.h) */
    int scalar[DEM_EFFECT_SCALARS];  /* indices of its scalars in dem_interaction_table.scalar */
};

struct dem_parcels_entry          /* the entry parcels of a scene */
{
    int used;
    int scalar;                   /* index of parcelRatio */
    double ratio;                 /* 1  of particles without an own */
    double min, max;              /* 1  smallest and largest of the run; 0: none yet */
};

/* effects of one pair class, in the order of stages */
struct dem_effect_list
{
    int entries;
    struct dem_effect_entry entry[DEM_EFFECT_LIST_LIMIT];
    /* computes the first `fused` of them in one loop; NULL: none */
    const struct dem_fused_kernel *kernel;
    int fused;
    struct dem_pair_class pair;
    /* enum dem_needs, or-ed */
    unsigned needs;
    /* 1: has effects of MOMENT or BOND; effects that act across a gap */
    int moments, past_touching;
    /* 1: has effects with particle scalars */
    int scalars;
    /* 1: has effects on the grains of parcels; the scalar that is their ratio */
    int grains, parcel_scalar;
    /* bodies; 1: drag is divided by the void fraction, see dem_fluid_whole_drag */
    int whole_drag;
};

/* a setting for one pair of materials only */
struct dem_override;

struct dem_interaction_table
{
    int materials;
    struct dem_material material[DEM_MATERIALS];
    /* m, of the particles of a material; 0: none present */
    double min_radius[DEM_MATERIALS];
    /* m */
    double max_radius[DEM_MATERIALS];
    /* m3, of clumps of a material for the limit of the time step (particles/clump_shape.h); 0: none */
    double body_volume[DEM_MATERIALS];
    /* m, of clumps for the limit of bonds; 0: none */
    double bond_radius;
    /* number of effects, in the order of stages */
    int chosen;
    const struct dem_effect *effect[DEM_EFFECT_LIST_LIMIT];
    /* as set for all pairs */
    void *settings[DEM_EFFECT_LIST_LIMIT];
    /* kg/m3, of the run; 0: none, not uniform */
    double fluid_density;
    int overrides;
    struct dem_override *override;
    /* 1: all particles are frozen: only effects with scalars limit the time step */
    int motionless;
    /* number of particle scalars */
    int scalars;
    /* so many, the first ones, are in lists of effects; the others fill columns of batches */
    int listed;
    const struct dem_scalar *scalar[DEM_SCALARS];
    /* 1: with a fluid or the program */
    int exchanged[DEM_SCALARS];
    struct dem_parcels_entry parcels;

    /* after freeze */
    /* pair classes first, wall classes last */
    int classes;
    struct dem_effect_list *list;
    struct dem_effect_list bodies;
    /* [enum dem_partner][particle material][other material], -1: none */
    int class_of[DEM_PARTNERS][DEM_MATERIALS][DEM_MATERIALS];
    int history_columns;
    /* names of the history columns */
    const char *history_name[DEM_HISTORY_COLUMNS];
    /* of all effect lists, or-ed */
    unsigned needs;
    /* C of a scalar per mass; 0: C is 1 */
    double capacity[DEM_SCALARS][DEM_MATERIALS];
    /* 1: some effect list has it */
    int moments, past_touching;
    /* 1: some list of contact effects has scalars */
    int contact_scalars;
    /* m past touching, the largest of all effects */
    double reach;
    /* s: limit of the time step */
    double step_limit;
    /* the criterion that gives it */
    char why[160];
    /* s: second smallest limit */
    double next_limit;
    /* the criterion that gives it */
    char next_why[160];
};

void dem_interaction_table_init(struct dem_interaction_table *);
void dem_interaction_table_free(struct dem_interaction_table *);

/* `where`: location in the input, the beginning of error messages. `material`: the index found. */
int dem_interaction_table_add_material(struct dem_interaction_table *, const struct dem_material *,
                                       const char *where);
int dem_interaction_table_find_material(const struct dem_interaction_table *, const char *name,
                                        const char *where, int *material);
int dem_interaction_table_add_effect(struct dem_interaction_table *, const char *effect,
                                     const char *where);

/* Set an entry of a chosen effect. pair: NULL for all contacts, else the indices of two
   materials. */
int dem_interaction_table_set_number(struct dem_interaction_table *, const int pair[2],
                                     const char *effect, const char *entry, const double *values,
                                     int count, const char *where);
int dem_interaction_table_set_word(struct dem_interaction_table *, const int pair[2],
                                   const char *effect, const char *entry, const char *word,
                                   const char *where);

/* A number of a chosen effect as set for all pairs; not-a-number when the effect was not chosen. */
double dem_interaction_table_get_number(const struct dem_interaction_table *, const char *effect,
                                        const char *entry);

/* Sets g to the sum of the uniform accelerations of the chosen effects [m/s2], zero without one.
   Returns the first such effect, or NULL. */
const struct dem_effect *dem_interaction_table_gravity(const struct dem_interaction_table *,
                                                       double g[3]);

/* 1 when a chosen effect models the same thing, so that this one cannot be added (`excludes` of
   either). */
int dem_interaction_table_excludes(const struct dem_interaction_table *, const struct dem_effect *);

/* 1 when a normal law acts. */
int dem_effect_list_has_law(const struct dem_effect_list *);

/* After freeze. 0 when particles of some material have no normal law at walls of this material and
   kind. */
int dem_interaction_table_wall_has_law(const struct dem_interaction_table *, enum dem_partner,
                                       int wall_material);

/* 1 when an effect of the full pressure gradient was chosen, which contains buoyancy. */
int dem_interaction_table_has_pressure_gradient(const struct dem_interaction_table *);

/* What the chosen effects need with their present settings: enum dem_needs, or-ed. */
unsigned dem_interaction_table_needs(const struct dem_interaction_table *);

/* The last effect that takes its values from a fluid, or NULL. An effect that reads the viscosity and
   has a setting of it does not. */
const struct dem_effect *dem_interaction_table_fluid_user(const struct dem_interaction_table *);

/* After all effects: add the scalars that fill columns of batches, if an effect takes values from a
   fluid. */
int dem_interaction_table_add_fluid_scalars(struct dem_interaction_table *, const char *where);

/* The setting `viscosity` of an effect that reads the viscosity; 0 when it takes the fluid's
   viscosity, or reads none. */
double dem_interaction_table_own_viscosity(const struct dem_interaction_table *,
                                           const struct dem_effect *);

/* Let particles be parcels (laws/parcels.h). */
int dem_interaction_table_use_parcels(struct dem_interaction_table *, double ratio,
                                      const char *where);

/* Extend the range of ratios by the ratio of a particle. */
void dem_interaction_table_add_parcel(struct dem_interaction_table *, double ratio);

/* The value of a scalar for particles without an own; not a number where there is none. */
static inline double dem_interaction_table_default(const struct dem_interaction_table *r,
                                                   int scalar)
{
    return r->parcels.used && scalar == r->parcels.scalar ? r->parcels.ratio
                                                          : r->scalar[scalar]->default_value;
}

/* Index of the particle scalar of this name, or -1. */
int dem_interaction_table_find_scalar(const struct dem_interaction_table *, const char *name);

/* C of a scalar of a particle of this material and mass [kg], see laws/scalar.h. */
static inline double dem_interaction_table_capacity(const struct dem_interaction_table *r,
                                                    int scalar, int material, double mass)
{
    const double each = r->capacity[scalar][material];

    return each > 0.0 ? each*mass : 1.0;
}

/* 1 when that effect was chosen. */
int dem_interaction_table_has_effect(const struct dem_interaction_table *, const char *effect);

/* Build and prepare all effect lists. Reads the smallest and largest radii; walls[partner][m] is 1
   when a wall of this kind is made of material m. DEM_ERROR_INPUT when a setting is missing. */
int dem_interaction_table_freeze(struct dem_interaction_table *,
                                 int walls[DEM_PARTNERS][DEM_MATERIALS]);

/* Bound the time step of a frozen table by a limit [s] that is not an effect's. `why`, followed by
   `suffix`, names it. */
void dem_interaction_table_limit_step(struct dem_interaction_table *, double limit,
                                      const char *why, const char *suffix);

/* A shallow copy of a frozen table, for a second state: effect lists of its own, settings shared
   with the original, which must outlive the copy. The copy is freed with the second function. */
int dem_interaction_table_share(const struct dem_interaction_table *,
                                struct dem_interaction_table *to);
void dem_interaction_table_unshare(struct dem_interaction_table *);

/* `prepare` of an effect for a pair class, or for bodies (NULL); damping, friction and resistance to
   rolling need a normal law. */
int dem_effect_prepare(const struct dem_effect *, void *settings, const struct dem_pair_class *);

/* Number of history columns of an effect. */
int dem_effect_history_columns(const struct dem_effect *);
