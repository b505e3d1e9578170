/*
 * test_settings_table.c -- a table of settings gives a struct its defaults, accepts only values in
 * range, and explains every refusal.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/settings_table.h"

#include <string.h>

struct glue
{
    double restitution, stiffness, strength, layers;
    double axis[3], shift[3];
    int law, on;
    double after;
};

enum
{
    LINEAR,
    POWER
};

static const char *const laws[] = {"linear", "power", NULL};

static const struct dem_setting fields[] = {
    DEM_SETTING(glue, restitution, "1", DEM_SETTING_REQUIRED, 0.0, 1.0,
                "speed after over speed before"),
    DEM_SETTING_AS(glue, stiffness, "youngsModulus", "Pa", 1e7, DEM_ABOVE_ZERO, INFINITY,
                   "of the glue"),
    DEM_SETTING(glue, strength, "Pa", 1e3, 0.0, INFINITY, "stress at which it breaks"),
    DEM_SETTING_COUNT(glue, layers, "layers", 1.0, 1.0, 10.0, "coats of glue"),
    DEM_SETTING_VECTOR(glue, axis, "1", 0.0, -1.0, 1.0, "direction of the fibres"),
    DEM_SETTING_VECTOR_AS(glue, shift, "offset", "m", DEM_SETTING_REQUIRED, -INFINITY, INFINITY,
                          "from the centre"),
    DEM_SETTING_CHOICE(glue, law, "law", POWER, laws, "how it hardens"),
    DEM_SETTING_SWITCH(glue, on, "active", 1, "whether it holds"),
    {0},
};

static int set(struct glue *g, const char *name, double value)
{
    return dem_settings_set_number(fields, g, "glue", name, &value, 1);
}

static int error_is(const char *sentence)
{
    return strcmp(dem_error_text(), sentence) == 0;
}

static void defaults(void)
{
    struct glue g = {.after = 7.0};

    dem_settings_set_defaults(fields, &g);
    TAP_OK(isnan(g.restitution) && isnan(g.shift[0]) && isnan(g.shift[2]),
           "a required setting starts as a not-a-number");
    TAP_OK(g.stiffness == 1e7 && g.strength == 1e3 && g.layers == 1.0 && g.axis[2] == 0.0,
           "numbers get their defaults");
    TAP_OK(g.law == POWER && g.on == 1, "choices and switches too");
    TAP_OK(g.after == 7.0, "members without a setting are not changed");

    TAP_OK(dem_settings_check_complete(fields, &g, "glue") == DEM_ERROR_INPUT,
           "missing settings are reported");
    TAP_OK(
        error_is(
            "glue: no value for restitution (speed after over speed before), offset (from the "
            "centre, m); "
            "these have no default, give them"),
        "%s", dem_error_text());
    set(&g, "restitution", 0.5);
    TAP_OK(dem_settings_check_complete(fields, &g, "glue") == DEM_ERROR_INPUT
           && !strstr(dem_error_text(), "restitution"),
           "only what is still missing: %s", dem_error_text());
    dem_settings_set_number(fields, &g, "glue", "offset", (const double[]){0.0, 0.0, 1.0}, 3);
    TAP_OK(dem_settings_check_complete(fields, &g, "glue") == DEM_OK,
           "no refusal once all are given");
}

static void numbers(void)
{
    struct glue g = {.after = 7.0};

    dem_settings_set_defaults(fields, &g);
    TAP_OK(set(&g, "restitution", 0.9) == DEM_OK && g.restitution == 0.9, "a number is set");
    TAP_OK(set(&g, "restitution", 0.0) == DEM_OK && set(&g, "restitution", 1.0) == DEM_OK,
           "limits are in range");
    TAP_OK(set(&g, "youngsModulus", 5e6) == DEM_OK && g.stiffness == 5e6,
           "set by the user's name of the setting");
    TAP_OK(set(&g, "stiffness", 5e6) == DEM_ERROR_INPUT, "not by the name of the member");

    TAP_OK(set(&g, "restitution", 1.2) == DEM_ERROR_INPUT && g.restitution == 1.0,
           "a number out of range changes nothing");
    TAP_OK(
        error_is(
            "glue: restitution 1.2 is out of range; "
            "give a value from 0 to 1 (speed after over speed before)"),
        "%s", dem_error_text());
    TAP_OK(set(&g, "youngsModulus", 0.0) == DEM_ERROR_INPUT,
           "zero is refused where it is excluded");
    TAP_OK(
        error_is("glue: youngsModulus 0 Pa is out of range; give a value above 0 Pa (of the glue)"),
        "%s", dem_error_text());
    TAP_OK(set(&g, "strength", 0.0) == DEM_OK, "zero is accepted where it is not excluded");
    TAP_OK(set(&g, "strength", -1.0) == DEM_ERROR_INPUT, "a negative strength is refused");
    TAP_OK(
        error_is(
            "glue: strength -1 Pa is out of range; "
            "give a value of 0 Pa or more (stress at which it breaks)"),
        "%s", dem_error_text());
    TAP_OK(set(&g, "strength", INFINITY) == DEM_ERROR_INPUT &&
               set(&g, "strength", NAN) == DEM_ERROR_INPUT && g.strength == 0.0,
           "neither an infinite value nor a not-a-number is accepted: %s", dem_error_text());
    TAP_OK(set(&g, "layers", 3.0) == DEM_OK && g.layers == 3.0 &&
               set(&g, "layers", 2.5) == DEM_ERROR_INPUT,
           "a count is a whole number");
    TAP_OK(
        error_is(
            "glue: layers 2.5 is not a whole number; "
            "give a value that is whole, from 1 to 10 (coats of glue)"),
        "%s", dem_error_text());
    TAP_OK(g.after == 7.0, "no other member was changed");
}

static void vectors(void)
{
    const double along[3] = {0.0, 0.6, 0.8}, outside[3] = {0.5, 0.5, -2.0};
    struct glue g;

    dem_settings_set_defaults(fields, &g);
    TAP_OK(dem_settings_set_number(fields, &g, "glue", "axis", along, 3) == DEM_OK
           && memcmp(g.axis, along, sizeof along) == 0,
           "a vector is set");
    TAP_OK(dem_settings_set_number(fields, &g, "glue", "axis", outside, 3) == DEM_ERROR_INPUT
           && memcmp(g.axis, along, sizeof along) == 0,
           "one component out of range changes none: %s", dem_error_text());
    TAP_OK(dem_settings_set_number(fields, &g, "glue", "axis", along, 1) == DEM_ERROR_INPUT,
           "a vector needs three numbers");
    TAP_OK(error_is("glue: axis has 1 number; give three, as (x y z) (direction of the fibres)"),
           "%s", dem_error_text());
    TAP_OK(dem_settings_set_number(fields, &g, "glue", "strength", along, 3) == DEM_ERROR_INPUT,
           "a number needs one number");
    TAP_OK(error_is("glue: strength has 3 numbers; give one (stress at which it breaks)"), "%s",
           dem_error_text());
}

static void words(void)
{
    struct glue g;

    dem_settings_set_defaults(fields, &g);
    TAP_OK(dem_settings_set_word(fields, &g, "glue", "law", "linear") == DEM_OK && g.law == LINEAR,
           "a choice is set by its word");
    TAP_OK(dem_settings_set_word(fields, &g, "glue", "law", "pwoer") == DEM_ERROR_INPUT &&
               g.law == LINEAR,
           "an unknown word changes nothing");
    TAP_OK(error_is(
               "unknown word for law of glue, \"pwoer\"; did you mean power? known: power, linear"),
           "%s", dem_error_text());
    for (int i = 0; i < 3; i++)
    {
        static const char *const yes[] = {"yes", "on", "true"}, *const no[] = {"no", "off",
                                                                               "false"};

        TAP_OK(dem_settings_set_word(fields, &g, "glue", "active", no[i]) == DEM_OK && g.on == 0 &&
                   dem_settings_set_word(fields, &g, "glue", "active", yes[i]) == DEM_OK &&
                   g.on == 1,
               "a switch takes %s and %s", yes[i], no[i]);
    }
    TAP_OK(dem_settings_set_word(fields, &g, "glue", "active", "maybe") == DEM_ERROR_INPUT &&
               g.on == 1,
           "a switch refuses maybe: %s", dem_error_text());
    TAP_OK(dem_settings_set_word(fields, &g, "glue", "strength", "high") == DEM_ERROR_INPUT,
           "a number refuses a word");
    TAP_OK(error_is(
               "glue: strength takes a number, not the word \"high\" (stress at which it breaks)"),
           "%s", dem_error_text());
    TAP_OK(set(&g, "law", 1.0) == DEM_ERROR_INPUT, "a choice refuses a number");
    TAP_OK(error_is("glue: law takes a word, not a number (how it hardens)"), "%s",
           dem_error_text());
    TAP_OK(
        set(&g, "restituton", 1.0) == DEM_ERROR_INPUT &&
            strstr(
                dem_error_text(),
                "unknown setting of glue, \"restituton\"; "
                "did you mean restitution? known: restitution, ") ==
                dem_error_text(),
        "an unknown setting gets the nearest name: %s", dem_error_text());
    TAP_OK(dem_settings_set_word(fields, &g, "glue", "lwa", "linear") == DEM_ERROR_INPUT &&
               strstr(dem_error_text(), "did you mean law?"),
           "an unknown setting with a word, too: %s", dem_error_text());
    TAP_OK(dem_settings_find(fields, "layers") == fields + 3 && !dem_settings_find(fields, "layer"),
           "fields are found by name");
}

int main(void)
{
    TAP_TRAPS;
    defaults();
    numbers();
    vectors();
    words();
    TAP_DONE;
}
