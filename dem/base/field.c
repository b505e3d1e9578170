/*
 * field.c -- values go into a struct only through its table of fields, checked against their ranges.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What is required and not yet given is a quiet not-a-number, recognised by its bits so that floating-point
 * traps stay silent, or the choice -1.
 */
#include "base/field.h"
#include "base/error.h"

#include <stdio.h>
#include <string.h>

enum
{
    NAMES = 64,     /* fields or choices listed in an error */
    PHRASE = 160    /* bytes for "from 0 to 1 Pa"           */
};

static int components(const struct dem_field *f)
{
    return f->kind == DEM_FIELD_VECTOR ? 3 : 1;
}

static int takes_numbers(const struct dem_field *f)
{
    return f->kind == DEM_FIELD_NUMBER || f->kind == DEM_FIELD_VECTOR;
}

void dem_field_defaults(const struct dem_field *fields, void *settings)
{
    for (const struct dem_field *f = fields; f->name; f++)
    {
        char *to = (char *)settings + f->offset;

        if (takes_numbers(f))
        {
            for (int i = 0; i < components(f); i++)
            {
                memcpy(to + (size_t)i*sizeof f->def, &f->def, sizeof f->def);
            }
        }
        else
        {
            const int choice = isnan(f->def) ? -1 : (int)f->def;

            memcpy(to, &choice, sizeof choice);
        }
    }
}

const struct dem_field *dem_field_find(const struct dem_field *fields, const char *name)
{
    for (const struct dem_field *f = fields; f->name; f++)
    {
        if (strcmp(f->name, name) == 0)
        {
            return f;
        }
    }
    return NULL;
}

static int unknown_name(const struct dem_field *fields, const char *owner, const char *name)
{
    const char *known[NAMES];
    char what[PHRASE];
    int n = 0;

    for (const struct dem_field *f = fields; f->name && n < NAMES; f++)
    {
        known[n++] = f->name;
    }
    snprintf(what, sizeof what, "setting of %s,", owner);
    return dem_unknown_word(what, name, known, n);
}

/* " Pa", or nothing for a pure number */
static const char *unit_of(const struct dem_field *f, char *text, size_t size)
{
    const int pure = !f->unit || f->unit[0] == '\0' || strcmp(f->unit, "1") == 0;

    snprintf(text, size, "%s%s", pure ? "" : " ", pure ? "" : f->unit);
    return text;
}

/* what a value must be, to follow "give a value": "from 0 to 1", "above 0 Pa", "of 0 Pa or more" */
static const char *range_of(const struct dem_field *f, char *text, size_t size)
{
    const int above_zero = f->least == DEM_ABOVE_ZERO, low = f->least > -DBL_MAX, high = f->most < DBL_MAX;
    const char *whole = f->flags & DEM_FIELD_WHOLE ? "that is whole, " : "";
    char unit[PHRASE];

    unit_of(f, unit, sizeof unit);
    if (above_zero && high)
    {
        snprintf(text, size, "%sabove 0 and at most %.10g%s", whole, f->most, unit);
    }
    else if (above_zero)
    {
        snprintf(text, size, "%sabove 0%s", whole, unit);
    }
    else if (low && high)
    {
        snprintf(text, size, "%sfrom %.10g to %.10g%s", whole, f->least, f->most, unit);
    }
    else if (low || high)
    {
        snprintf(text, size, "%sof %.10g%s or %s", whole, low ? f->least : f->most, unit,
                 low ? "more" : "less");
    }
    else
    {
        snprintf(text, size, "%sthat is finite", whole);
    }
    return text;
}

static int check(const struct dem_field *f, const char *owner, double value)
{
    char unit[PHRASE], range[2*PHRASE];
    const int finite = isfinite(value);
    const int in_range = finite && value >= f->least && value <= f->most;
    const int whole = !(f->flags & DEM_FIELD_WHOLE) || (finite && value == floor(value));

    DEM_REQUIRE(in_range && whole, DEM_ERROR_INPUT, "%s: %s %.10g%s %s; give a value %s (%s)", owner,
                f->name, value, unit_of(f, unit, sizeof unit),
                !finite ? "is not a finite number" : in_range ? "is not a whole number" : "is out of range",
                range_of(f, range, sizeof range), f->help);
    return DEM_OK;
}

int dem_field_set_number(const struct dem_field *fields, void *settings, const char *owner, const char *name,
                         const double *values, int count)
{
    const struct dem_field *f = dem_field_find(fields, name);

    if (!f)
    {
        return unknown_name(fields, owner, name);
    }
    DEM_REQUIRE(takes_numbers(f), DEM_ERROR_INPUT, "%s: %s takes a word, not a number (%s)", owner, name,
                f->help);
    DEM_REQUIRE(count == components(f), DEM_ERROR_INPUT, "%s: %s has %d number%s; give %s (%s)", owner, name,
                count, count == 1 ? "" : "s", components(f) == 3 ? "three, as (x y z)" : "one", f->help);
    for (int i = 0; i < count; i++)
    {
        DEM_TRY(check(f, owner, values[i]));
    }
    memcpy((char *)settings + f->offset, values, (size_t)count*sizeof *values);
    return DEM_OK;
}

/* place of a word in a list with n words; -1 if it is not there */
static int place_of(const char *word, const char *const *list, int n)
{
    for (int i = 0; i < n; i++)
    {
        if (strcmp(word, list[i]) == 0)
        {
            return i;
        }
    }
    return -1;
}

int dem_field_set_word(const struct dem_field *fields, void *settings, const char *owner, const char *name,
                       const char *word)
{
    static const char *const switches[] = {"no", "yes", "off", "on", "false", "true"};
    const struct dem_field *f = dem_field_find(fields, name);
    char what[PHRASE];
    int n = 0;

    if (!f)
    {
        return unknown_name(fields, owner, name);
    }
    DEM_REQUIRE(!takes_numbers(f), DEM_ERROR_INPUT, "%s: %s takes %s, not the word \"%s\" (%s)", owner, name,
                components(f) == 3 ? "three numbers" : "a number", word, f->help);

    const int is_switch = f->kind == DEM_FIELD_SWITCH;
    const char *const *words = is_switch ? switches : f->choices;

    while (is_switch ? n < 6 : words[n] != NULL)
    {
        n++;
    }

    const int place = place_of(word, words, n);
    const int value = is_switch ? place%2 : place;

    if (place < 0)
    {
        snprintf(what, sizeof what, "word for %s of %s,", name, owner);
        return dem_unknown_word(what, word, words, n);
    }
    memcpy((char *)settings + f->offset, &value, sizeof value);
    return DEM_OK;
}

static int is_missing(const struct dem_field *f, const void *settings)
{
    const char *from = (const char *)settings + f->offset;
    double number;
    int choice;

    if (takes_numbers(f))
    {
        memcpy(&number, from, sizeof number);
        return isnan(number);
    }
    memcpy(&choice, from, sizeof choice);
    return choice < 0;
}

int dem_field_missing(const struct dem_field *fields, const void *settings, const char *owner)
{
    char list[1024] = "", unit[PHRASE];
    size_t used = 0;

    for (const struct dem_field *f = fields; f->name && used < sizeof list; f++)
    {
        if (is_missing(f, settings))
        {
            const int wanted = snprintf(list + used, sizeof list - used, "%s%s (%s%s%s)", used ? ", " : "",
                                        f->name, f->help, unit_of(f, unit, sizeof unit)[0] ? "," : "", unit);

            used += wanted > 0 ? (size_t)wanted : 0;
        }
    }
    DEM_REQUIRE(used == 0, DEM_ERROR_INPUT, "%s: no value for %s; these have no default, give them", owner,
                list);
    return DEM_OK;
}
