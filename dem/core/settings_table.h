/*
 * settings_table.h -- a table that declares the settings of a struct: name, unit, default, range,
 * help.
 *
 * The reader of scenes, the error messages and the manual work from the same table.
 *
 *     struct hertz { double restitution, direction[3]; int law; };
 *     static const char *const laws[] = {"tsuji", "none", NULL};
 *     static const struct dem_setting settings[] = {
 *         DEM_SETTING(hertz, restitution, "1", DEM_SETTING_REQUIRED, 0.0, 1.0, "speeds, out/in"),
 *         DEM_SETTING_VECTOR(hertz, direction, "1", 0.0, -1.0, 1.0, "..."),
 *         DEM_SETTING_CHOICE(hertz, law, "law", 0, laws, "damping law"),
 *         {0},
 *     };
 *
 * The first argument is the tag of the struct. A table ends in {0}; NULL is an empty one. Limits are inclusive;
 * DEM_ABOVE_ZERO as the minimum excludes zero; INFINITY (or -INFINITY) means no limit. NaN and
 * infinite values are always refused. A member of the wrong type does not compile: numbers and
 * counts are double, vectors double[3], choices and switches int.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#pragma once

#include "core/did_you_mean.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum dem_setting_kind
{
    DEM_SETTING_NUMBER,  /* double */
    DEM_SETTING_VECTOR,  /* double[3]; default and range per component */
    DEM_SETTING_CHOICE,  /* int: the index of the word in choices */
    DEM_SETTING_SWITCH   /* int: 0 or 1 */
};

enum
{
    DEM_SETTING_WHOLE = 1  /* flag: the number must be whole (it is stored as double) */
};

struct dem_setting
{
    const char *name;                /* the word in a scene; null ends a table */
    enum dem_setting_kind kind;
    size_t offset;                   /* of the member in its struct [byte] */
    const char *unit;                /* SI, "1" for a pure number; "" for choices and switches */
    double default_value, min, max;  /* default (or DEM_SETTING_REQUIRED), smallest and largest
                                        value */
    const char *help;
    const char *const *choices;      /* null-terminated; only for choices */
    unsigned flags;
};

#define DEM_SETTING_REQUIRED ((double)NAN)    /* as a default: the scene must give the value */
#define DEM_ABOVE_ZERO DBL_MIN                /* as a minimum: zero is excluded, "above 0" */

#define DEM_SETTING_OF_TYPE_(type, member, wanted) \
    _Generic(&((struct type *)0)->member, wanted: offsetof(struct type, member))

#define DEM_SETTING_AS(type, member, word, unit, default_value, min, max, help) \
    {(word), DEM_SETTING_NUMBER, DEM_SETTING_OF_TYPE_(type, member, double *), (unit), \
     (default_value), (min), (max), (help), NULL, 0}
#define DEM_SETTING(type, member, unit, default_value, min, max, help) \
    DEM_SETTING_AS(type, member, #member, unit, default_value, min, max, help)

#define DEM_SETTING_COUNT(type, member, word, default_value, min, max, help) \
    {(word), DEM_SETTING_NUMBER, DEM_SETTING_OF_TYPE_(type, member, double *), "1", \
     (default_value), (min), (max), (help), NULL, DEM_SETTING_WHOLE}

#define DEM_SETTING_VECTOR_AS(type, member, word, unit, default_value, min, max, help) \
    {(word), DEM_SETTING_VECTOR, DEM_SETTING_OF_TYPE_(type, member, double(*)[3]), (unit), \
     (default_value), (min), (max), (help), NULL, 0}
#define DEM_SETTING_VECTOR(type, member, unit, default_value, min, max, help) \
    DEM_SETTING_VECTOR_AS(type, member, #member, unit, default_value, min, max, help)

#define DEM_SETTING_CHOICE(type, member, word, default_value, choices, help) \
    {(word), DEM_SETTING_CHOICE, DEM_SETTING_OF_TYPE_(type, member, int *), "", \
     (default_value), 0.0, 0.0, (help), (choices), 0}

#define DEM_SETTING_SWITCH(type, member, word, default_value, help) \
    {(word), DEM_SETTING_SWITCH, DEM_SETTING_OF_TYPE_(type, member, int *), "", \
     (default_value), 0.0, 1.0, (help), NULL, 0}

/* Write every default; a required number becomes NaN, a required choice or switch -1. */
void dem_settings_set_defaults(const struct dem_setting *table, void *settings);

/* The setting of that name, or null. */
const struct dem_setting *dem_settings_find(const struct dem_setting *table, const char *name);

/* The number of that name; not a number without such a setting, or without a table. */
double dem_settings_number(const struct dem_setting *table, const void *settings, const char *name);

/* Set a number (count 1) or vector (count 3). `owner` names the thing in messages: "hertz",
   "material glass". DEM_ERROR_INPUT for an unknown name, a wrong kind or a value out of range. */
int dem_settings_set_number(const struct dem_setting *table, void *settings, const char *owner,
                            const char *name, const double *values, int count);

/* Set a choice, or a switch by yes, no, on, off, true, false. Errors as above. */
int dem_settings_set_word(const struct dem_setting *table, void *settings, const char *owner,
                          const char *name, const char *word);

/* DEM_ERROR_INPUT with the names of all required settings that have no value. */
int dem_settings_check_complete(const struct dem_setting *table, const void *settings,
                                const char *owner);
