/*
 * field.h -- the numbers of a struct, declared once: name, unit, default, range, help; for reader and manual.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 *     struct hertz { double restitution, direction[3]; int law; };
 *     static const char *const laws[] = {"tsuji", "none", NULL};
 *     static const struct dem_field settings[] = {
 *         DEM_FIELD(hertz, restitution, "1", DEM_FIELD_REQUIRED, 0.0, 1.0, "speed after over speed before"),
 *         DEM_FIELD_VECTOR(hertz, direction, "1", 0.0, -1.0, 1.0, "..."),
 *         DEM_FIELD_CHOICE(hertz, law, "law", 0, laws, "damping law"),
 *         {0},
 *     };
 *
 * The first argument is the struct's tag. A table ends in {0}. Limits are inclusive; DEM_ABOVE_ZERO as least
 * excludes zero; INFINITY (or -INFINITY) is no limit. A not-a-number or infinite value is always refused.
 * A member of the wrong type does not compile: numbers and counts are double, vectors double[3], choices and
 * switches int.
 */
#ifndef DEM_BASE_FIELD_H
#define DEM_BASE_FIELD_H

#include "base/unknown.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum dem_field_kind
{
    DEM_FIELD_NUMBER,    /* double                                     */
    DEM_FIELD_VECTOR,    /* double[3]; default and range per component */
    DEM_FIELD_CHOICE,    /* int: the word's place in choices           */
    DEM_FIELD_SWITCH     /* int: 0 or 1                                */
};

enum
{
    DEM_FIELD_WHOLE = 1    /* flag: a number that must be whole (it is still a double) */
};

struct dem_field
{
    const char *name;           /* the word the user writes; null ends a table                        */
    enum dem_field_kind kind;
    size_t offset;              /* of the member in its struct [byte]                                 */
    const char *unit;           /* SI, "1" for a pure number; "" for choices and switches             */
    double def, least, most;    /* default (DEM_FIELD_REQUIRED: none), least and most allowed value   */
    const char *help;
    const char *const *choices; /* null-ended; only for choices                                       */
    unsigned flags;
};

#define DEM_FIELD_REQUIRED ((double)NAN)    /* as a default: the user must give the value           */
#define DEM_ABOVE_ZERO DBL_MIN              /* as least: zero is excluded; shown as "above 0"       */

#define DEM_FIELD_OF_TYPE_(type, member, wanted) \
    _Generic(&((struct type *)0)->member, wanted: offsetof(struct type, member))

#define DEM_FIELD_AS(type, member, word, unit, def, least, most, help)                                  \
    {(word), DEM_FIELD_NUMBER, DEM_FIELD_OF_TYPE_(type, member, double *), (unit), (def), (least), (most), \
     (help), NULL, 0}
#define DEM_FIELD(type, member, unit, def, least, most, help) \
    DEM_FIELD_AS(type, member, #member, unit, def, least, most, help)

#define DEM_FIELD_COUNT(type, member, word, def, least, most, help)                                    \
    {(word), DEM_FIELD_NUMBER, DEM_FIELD_OF_TYPE_(type, member, double *), "1", (def), (least), (most), \
     (help), NULL, DEM_FIELD_WHOLE}

#define DEM_FIELD_VECTOR_AS(type, member, word, unit, def, least, most, help)                                \
    {(word), DEM_FIELD_VECTOR, DEM_FIELD_OF_TYPE_(type, member, double(*)[3]), (unit), (def), (least), (most), \
     (help), NULL, 0}
#define DEM_FIELD_VECTOR(type, member, unit, def, least, most, help) \
    DEM_FIELD_VECTOR_AS(type, member, #member, unit, def, least, most, help)

#define DEM_FIELD_CHOICE(type, member, word, def, choices, help)                                      \
    {(word), DEM_FIELD_CHOICE, DEM_FIELD_OF_TYPE_(type, member, int *), "", (def), 0.0, 0.0, (help), \
     (choices), 0}

#define DEM_FIELD_SWITCH(type, member, word, def, help) \
    {(word), DEM_FIELD_SWITCH, DEM_FIELD_OF_TYPE_(type, member, int *), "", (def), 0.0, 1.0, (help), NULL, 0}

/* Write every default; what is required becomes a not-a-number, a required choice or switch -1. */
void dem_field_defaults(const struct dem_field *fields, void *settings);

/* The field of that name, or null. */
const struct dem_field *dem_field_find(const struct dem_field *fields, const char *name);

/* Set a number (count 1) or vector (count 3). owner names the thing in errors: "hertz", "material glass". */
int dem_field_set_number(const struct dem_field *fields, void *settings, const char *owner, const char *name,
                         const double *values, int count);

/* Set a choice, or a switch by yes, no, on, off, true, false. */
int dem_field_set_word(const struct dem_field *fields, void *settings, const char *owner, const char *name,
                       const char *word);

/* Fail with the names of all required fields that were not set. */
int dem_field_missing(const struct dem_field *fields, const void *settings, const char *owner);

#endif
