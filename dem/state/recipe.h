/*
 * recipe.h -- which effects act on which materials, in which order, with which numbers: built from the scene's words,
 * checked, and frozen before the first step.
 *
 * Order of use: add_material, choose (an effect for all), set_number/set_word (for all or for one pair of materials),
 * then freeze. After that it is read only: class_of gives a contact's class, chain[class] what acts on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#ifndef DEM_STATE_RECIPE_H
#define DEM_STATE_RECIPE_H

#include "effects/effect.h"
#include <stddef.h>

enum
{
    DEM_MATERIALS = 32,                                   /* of one scene   */
    DEM_CHAIN = 16,                                       /* effects acting on one class */
    DEM_MEMORY_COLUMNS = 32,                              /* of all effects together */
    DEM_CHOICES = 256                                     /* settings changed for one pair of materials */
};

struct dem_link                                           /* one effect in a chain */
{
    const struct dem_effect *effect;
    void *settings;                                       /* prepared, owned by the recipe */
    int memory;                                           /* first of its remembered columns */
};

struct dem_chain                                          /* what acts on one pair class, in the order of stages */
{
    int links;
    struct dem_link link[DEM_CHAIN];
    struct dem_pair_class pair;
    unsigned needs;
    int moments, past_touching;                           /* 1: has MOMENT or BOND links; has BOND or FILM links */
    int whole_drag;                                       /* bodies: 1: drag over the void fraction, see dem_fluid_whole_drag */
};

struct dem_override;                                      /* a setting for one pair of materials only */

struct dem_recipe
{
    int materials;
    struct dem_material material[DEM_MATERIALS];
    double least_radius[DEM_MATERIALS];                   /* m, of the particles of a material; 0: none present */
    double most_radius[DEM_MATERIALS];
    int chosen;                                           /* effects, in the order of stages after freeze */
    const struct dem_effect *effect[DEM_CHAIN];
    void *settings[DEM_CHAIN];                            /* as set for all pairs */
    int mixed;                                            /* 1: laws and forces in single precision where they can be */
    int overrides;
    struct dem_override *override;

    /* after freeze */
    int classes;                                          /* pair classes first, wall classes last */
    struct dem_chain *chain;
    struct dem_chain bodies;
    int class_of[2][DEM_MATERIALS][DEM_MATERIALS];        /* [with wall][particle material][other material], -1: none */
    int memories;
    const char *memory[DEM_MEMORY_COLUMNS];               /* names of the remembered columns */
    unsigned needs;                                       /* of all chains together */
    int moments, past_touching;                           /* 1: some chain has such links */
    double reach;                                         /* m past touching, the largest of all */
    double step_limit;                                    /* s */
    char why[160];                                        /* what bounds it */
    double next_limit;                                    /* s: what would bound it if that were not there */
    char next_why[160];
};

void dem_recipe_init(struct dem_recipe *);
void dem_recipe_free(struct dem_recipe *);

/* `where` is the place in the input that messages start with. */
int dem_recipe_add_material(struct dem_recipe *, const struct dem_material *, const char *where);
int dem_recipe_material(const struct dem_recipe *, const char *name, const char *where, int *material);
int dem_recipe_choose(struct dem_recipe *, const char *effect, const char *where);

/* pair: NULL for all contacts, else two materials' indices. */
int dem_recipe_set_number(struct dem_recipe *, const int pair[2], const char *effect, const char *entry,
                          const double *values, int count, const char *where);
int dem_recipe_set_word(struct dem_recipe *, const int pair[2], const char *effect, const char *entry,
                        const char *word, const char *where);

/* A number or a vector of a chosen effect as set for all pairs; not-a-number, or zero, when it was not chosen. */
double dem_recipe_number(const struct dem_recipe *, const char *effect, const char *entry);
/* 1 when a choice of a chosen effect is set to that word for all pairs, 0 when to another, -1 when it was not chosen. */
int dem_recipe_word(const struct dem_recipe *, const char *effect, const char *entry, const char *word);

void dem_recipe_vector(const struct dem_recipe *, const char *effect, const char *entry, double value[3]);

/* What all chosen effects need with their settings: enum dem_needs, or-ed. */
unsigned dem_recipe_asks(const struct dem_recipe *);

/* 1 when that effect was chosen. */
int dem_recipe_acts(const struct dem_recipe *, const char *effect);

/* Build and prepare all chains. Reads least_radius and most_radius; wall_materials[m] is 1 when a wall is made of material m. */
int dem_recipe_freeze(struct dem_recipe *, const int wall_materials[DEM_MATERIALS]);

/* A second hand on a frozen recipe, for a state of its own: settings are shared, so it must go before the first does. */
int dem_recipe_lend(const struct dem_recipe *, struct dem_recipe *to);
void dem_recipe_give_back(struct dem_recipe *);

/* Take an effect out of all chains of a second hand. Columns that it remembered stay. */
void dem_recipe_leave(struct dem_recipe *lent, const char *effect);

/* Columns an effect remembers. */
int dem_effect_memories(const struct dem_effect *);

#endif
