/*
 * settings_table.c -- write values into a struct through its table of settings, checked against
 * their ranges.
 *
 * A required setting without a value is a quiet NaN, recognised by its bits so that floating-point
 * traps stay silent, or the choice -1.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/settings_table.h"
#include "core/error.h"

#include <stdio.h>
#include <string.h>

enum
{
    MAX_NAMES = 64,    /* settings or choices listed in a message */
    PHRASE_SIZE = 160  /* bytes for "from 0 to 1 Pa" */
};

static int components(const struct dem_setting *f)
{
    return f->kind == DEM_SETTING_VECTOR ? 3 : 1;
}

static int takes_numbers(const struct dem_setting *f)
{
    return f->kind == DEM_SETTING_NUMBER || f->kind == DEM_SETTING_VECTOR;
}

void dem_settings_set_defaults(const struct dem_setting *table, void *settings)
{
    for (const struct dem_setting *f = table; f && f->name; f++)
    {
        char *to = (char *)settings + f->offset;

        if (takes_numbers(f))
        {
            for (int i = 0; i < components(f); i++)
            {
                memcpy(to + (size_t)i*sizeof f->default_value, &f->default_value,
                       sizeof f->default_value);
            }
        }
        else
        {
            const int choice = isnan(f->default_value) ? -1 : (int)f->default_value;

            memcpy(to, &choice, sizeof choice);
        }
    }
}

const struct dem_setting *dem_settings_find(const struct dem_setting *table, const char *name)
{
    for (const struct dem_setting *f = table; f && f->name; f++)
    {
        if (strcmp(f->name, name) == 0)
        {
            return f;
        }
    }
    return NULL;
}

double dem_settings_number(const struct dem_setting *table, const void *settings, const char *name)
{
    const struct dem_setting *const f = dem_settings_find(table, name);

    return f ? *(const double *)(const void *)((const char *)settings + f->offset) : DEM_SETTING_REQUIRED;
}

static int unknown_name(const struct dem_setting *table, const char *owner, const char *name)
{
    const char *known[MAX_NAMES];
    char what[PHRASE_SIZE];
    int n = 0;

    for (const struct dem_setting *f = table; f && f->name && n < MAX_NAMES; f++)
    {
        known[n++] = f->name;
    }
    snprintf(what, sizeof what, "setting of %s,", owner);
    return dem_did_you_mean_error(what, name, known, n);
}

/* " Pa", or empty for a pure number. */
static const char *unit_of(const struct dem_setting *f, char *text, size_t size)
{
    const int pure = !f->unit || f->unit[0] == '\0' || strcmp(f->unit, "1") == 0;

    snprintf(text, size, "%s%s", pure ? "" : " ", pure ? "" : f->unit);
    return text;
}

/* The allowed range, to follow "give a value": "from 0 to 1", "above 0 Pa", "of 0 Pa or more". */
static const char *range_of(const struct dem_setting *f, char *text, size_t size)
{
    const int above_zero = f->min == DEM_ABOVE_ZERO, has_min = f->min > -DBL_MAX;
    const int has_max = f->max < DBL_MAX;
    const char *whole = f->flags & DEM_SETTING_WHOLE ? "that is whole, " : "";
    char unit[PHRASE_SIZE];

    unit_of(f, unit, sizeof unit);
    if (above_zero && has_max)
    {
        snprintf(text, size, "%sabove 0 and at most %.10g%s", whole, f->max, unit);
    }
    else if (above_zero)
    {
        snprintf(text, size, "%sabove 0%s", whole, unit);
    }
    else if (has_min && has_max)
    {
        snprintf(text, size, "%sfrom %.10g to %.10g%s", whole, f->min, f->max, unit);
    }
    else if (has_min || has_max)
    {
        snprintf(text, size, "%sof %.10g%s or %s", whole, has_min ? f->min : f->max, unit,
                 has_min ? "more" : "less");
    }
    else
    {
        snprintf(text, size, "%sthat is finite", whole);
    }
    return text;
}

static int check(const struct dem_setting *f, const char *owner, double value)
{
    char unit[PHRASE_SIZE], range[2*PHRASE_SIZE];
    const int finite = isfinite(value);
    const int in_range = finite && value >= f->min && value <= f->max;
    const int whole = !(f->flags & DEM_SETTING_WHOLE) || (finite && value == floor(value));

    DEM_REQUIRE(in_range && whole, DEM_ERROR_INPUT, "%s: %s %.10g%s %s; give a value %s (%s)",
                owner, f->name, value, unit_of(f, unit, sizeof unit),
                !finite ? "is not a finite number"
                : in_range ? "is not a whole number"
                           : "is out of range",
                range_of(f, range, sizeof range), f->help);
    return DEM_OK;
}

int dem_settings_set_number(const struct dem_setting *table, void *settings, const char *owner,
                            const char *name, const double *values, int count)
{
    const struct dem_setting *f = dem_settings_find(table, name);

    if (!f)
    {
        return unknown_name(table, owner, name);
    }
    DEM_REQUIRE(takes_numbers(f), DEM_ERROR_INPUT, "%s: %s takes a word, not a number (%s)", owner,
                name, f->help);
    DEM_REQUIRE(count == components(f), DEM_ERROR_INPUT, "%s: %s has %d number%s; give %s (%s)",
                owner, name, count, count == 1 ? "" : "s",
                components(f) == 3 ? "three, as (x y z)" : "one", f->help);
    for (int i = 0; i < count; i++)
    {
        DEM_TRY(check(f, owner, values[i]));
    }
    memcpy((char *)settings + f->offset, values, (size_t)count*sizeof *values);
    return DEM_OK;
}

/* Index of a word in a list of n words; -1 if it is not in the list. */
static int index_of(const char *word, const char *const *list, int n)
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

int dem_settings_set_word(const struct dem_setting *table, void *settings, const char *owner,
                          const char *name, const char *word)
{
    static const char *const switches[] = {"no", "yes", "off", "on", "false", "true"};
    const struct dem_setting *f = dem_settings_find(table, name);
    char what[PHRASE_SIZE];
    int n = 0;

    if (!f)
    {
        return unknown_name(table, owner, name);
    }
    DEM_REQUIRE(!takes_numbers(f), DEM_ERROR_INPUT, "%s: %s takes %s, not the word \"%s\" (%s)",
                owner, name, components(f) == 3 ? "three numbers" : "a number", word, f->help);

    const int is_switch = f->kind == DEM_SETTING_SWITCH;
    const char *const *words = is_switch ? switches : f->choices;

    while (is_switch ? n < 6 : words[n] != NULL)
    {
        n++;
    }

    const int index = index_of(word, words, n);
    const int value = is_switch ? index%2 : index;

    if (index < 0)
    {
        snprintf(what, sizeof what, "word for %s of %s,", name, owner);
        return dem_did_you_mean_error(what, word, words, n);
    }
    memcpy((char *)settings + f->offset, &value, sizeof value);
    return DEM_OK;
}

static int is_missing(const struct dem_setting *f, const void *settings)
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

int dem_settings_check_complete(const struct dem_setting *table, const void *settings,
                                const char *owner)
{
    char list[1024] = "", unit[PHRASE_SIZE];
    size_t used = 0;

    for (const struct dem_setting *f = table; f && f->name && used < sizeof list; f++)
    {
        if (is_missing(f, settings))
        {
            const int wanted =
                snprintf(list + used, sizeof list - used, "%s%s (%s%s%s)", used ? ", " : "",
                         f->name, f->help, unit_of(f, unit, sizeof unit)[0] ? "," : "", unit);

            used += wanted > 0 ? (size_t)wanted : 0;
        }
    }
    DEM_REQUIRE(used == 0, DEM_ERROR_INPUT, "%s: no value for %s; these have no default, give them",
                owner, list);
    return DEM_OK;
}
