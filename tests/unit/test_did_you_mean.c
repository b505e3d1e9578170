/*
 * test_did_you_mean.c -- suggestions for unknown words.
 *
 * A mistyped word gets the nearest known word, a word of another code its name here, any other word
 * no guess; all get the list of known words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "tap.h"

#include "core/error.h"
#include "core/did_you_mean.h"

#include <stdlib.h>
#include <string.h>

static const char *const effects[] = {"mindlin", "hooke", "hertz", "rollingSpring", "gravity"};

static int means(const char *word, const char *expected)
{
    const char *nearest = dem_did_you_mean_nearest(word, effects, 5);

    return expected ? nearest && strcmp(nearest, expected) == 0 : !nearest;
}

static void long_lists(void)
{
    enum
    {
        MANY = 300
    };
    static char word[MANY][32];
    const char *known[MANY];

    for (int i = 0; i < MANY; i++)
    {
        snprintf(word[i], sizeof word[i], "particleNumber%d", i);
        known[i] = word[i];
    }
    TAP_OK(dem_did_you_mean_error("particle", "particelNumber123", known, MANY) == DEM_ERROR_INPUT
           && strstr(dem_error_text(), "did you mean particleNumber123? known: particleNumber123, ")
           && strcmp(dem_error_text() + strlen(dem_error_text()) - 3, "...") == 0,
           "a list too long for a sentence keeps the nearest and ends with three dots");
}

static void long_words(void)
{
    char word[1000];

    memset(word, 'h', sizeof word - 1);
    word[sizeof word - 1] = '\0';
    TAP_OK(dem_did_you_mean_error("effect", word, effects, 5) == DEM_ERROR_INPUT
           && !strstr(dem_error_text(), "did you mean"),
           "no suggestion for a thousand letters");
}

/* Words of other codes. */
static void aliases(void)
{
    static const char *const ours[] = {"restitution", "friction", "youngsModulus",
                                       "density", "diameter", "poissonsRatio"};
    static const char *const pairs[][2] = {{"coefficientOfRestitution", "restitution"},
                                           {"e", "restitution"},
                                           {"mu", "friction"},
                                           {"frictionCoefficient", "friction"},
                                           {"E", "youngsModulus"},
                                           {"youngModulus", "youngsModulus"},
                                           {"rho", "density"},
                                           {"rho0", "density"},
                                           {"d0", "diameter"},
                                           {"radius", "diameter"},
                                           {"nu", "poissonsRatio"}};

    for (size_t k = 0; k < sizeof pairs/sizeof *pairs; k++)
    {
        const char *const nearest = dem_did_you_mean_nearest(pairs[k][0], ours, 6);

        TAP_OK(nearest && strcmp(nearest, pairs[k][1]) == 0, "alias %s of %s", pairs[k][0],
               pairs[k][1]);
    }
    TAP_OK(strcmp(dem_did_you_mean_nearest("density", (const char *const[]){"temperature", "rho"},
                                           2),
                  "rho") == 0,
           "in reverse: rho is suggested for density");
    TAP_OK(!dem_did_you_mean_nearest("Rho", ours, 6) && !dem_did_you_mean_nearest("ef", ours, 6) &&
               !dem_did_you_mean_nearest(" ", ours, 6),
           "no alias for parts of a word or another case");
    TAP_OK(dem_did_you_mean_error("setting", "radius", ours, 6) &&
               strstr(dem_error_text(), "did you mean diameter, twice the radius?"),
           "a radius is not a diameter: %s", dem_error_text());
}

int main(void)
{
    TAP_TRAPS;
    TAP_OK(means("hertzz", "hertz")
           && means("herz", "hertz") && means("hartz", "hertz") && means("hretz", "hertz"),
           "one letter too many, too few, wrong, or two swapped");
    TAP_OK(means("Hertz", "hertz") && means("rollingspring", "rollingSpring"), "the wrong case");
    TAP_OK(means("rolingSprnig", "rollingSpring"), "two errors in a long word");
    TAP_OK(dem_did_you_mean_nearest("lwa", (const char *const[]){"law"}, 1)
           && !dem_did_you_mean_nearest("lxy", (const char *const[]){"law"}, 1),
           "in three letters a swap is one error, two changes are another word");
    TAP_OK(means("magnetism", NULL) && means("", NULL) && means("h", NULL),
           "no guess for an unrelated word");

    TAP_OK(dem_did_you_mean_error("effect", "hertzz", effects, 5) == DEM_ERROR_INPUT,
           "an unknown word is an input error");
    TAP_OK(
        strcmp(dem_error_text(), "unknown effect \"hertzz\"; did you mean hertz? "
                                 "known: hertz, hooke, mindlin, gravity, rollingSpring") == 0,
        "known words are listed nearest first (1, 5, 7, 7 and 12 letters off), equals as listed: "
        "%s",
        dem_error_text());
    TAP_OK(dem_did_you_mean_error("effect", "magnetism", effects, 5) == DEM_ERROR_INPUT
           && strstr(dem_error_text(), "unknown effect \"magnetism\"; known: ") == dem_error_text(),
           "without a guess: %s", dem_error_text());
    TAP_OK(dem_did_you_mean_error("effect", "any", effects, 0) == DEM_ERROR_INPUT
           && strcmp(dem_error_text(),
                     "unknown effect \"any\"; none is known here, so leave it out") == 0, "%s",
           dem_error_text());
    aliases();
    long_lists();
    long_words();
    TAP_DONE;
}
