/*
 * did_you_mean.c -- sort known words by edit distance from an unknown one and build the error
 * message.
 *
 * The distance is computed with three rows of the dynamic-programming table. A known word that is
 * an alias of the unknown one (core/aliases.h, or given by the caller) has distance 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "core/did_you_mean.h"
#include "core/error.h"
#include "core/aliases.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum
{
    MAX_LETTERS = 63,  /* letters of a word that are compared */
    LIST_SIZE = 2048   /* bytes for the list of known words */
};

static int min_of(int a, int b)
{
    return a < b ? a : b;
}

static int lower_case(const char *word, int i)
{
    return tolower((unsigned char)word[i]);
}

static int length(const char *word)
{
    const char *end = memchr(word, '\0', MAX_LETTERS);

    return end ? (int)(end - word) : MAX_LETTERS;
}

/* Restricted Damerau distance: insertions, deletions, substitutions and swaps of neighbours. */
static int distance(const char *a, const char *b)
{
    int row[3][MAX_LETTERS + 1];
    const int na = length(a), nb = length(b);

    for (int j = 0; j <= nb; j++)
    {
        row[0][j] = j;
    }
    for (int i = 1; i <= na; i++)
    {
        int *now = row[i%3];
        const int *last = row[(i + 2)%3], *before = row[(i + 1)%3];

        now[0] = i;
        for (int j = 1; j <= nb; j++)
        {
            const int same = lower_case(a, i - 1) == lower_case(b, j - 1);

            now[j] = min_of(last[j - 1] + !same, min_of(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && lower_case(a, i - 1) == lower_case(b, j - 2)
                && lower_case(a, i - 2) == lower_case(b, j - 1))
            {
                now[j] = min_of(now[j], before[j - 2] + 1);
            }
        }
    }
    return row[na%3][nb];
}

struct known_words
{
    const char *const *word, *const
                                 *aliases;    /* aliases: NULL, or for each word NULL or its aliases */
    int n;
};

/* Edit distance to known word i; 0 when one word is an alias of the other. */
static int edits(const char *word, const struct known_words *k, int i)
{
    const char *const known = k->word[i], *const aliases = k->aliases ? k->aliases[i] : NULL;

    return dem_alias_note(word, known) || dem_alias_note(known, word) ||
                   (aliases && dem_alias_is_among(aliases, word))
               ? 0
               : distance(word, known);
}

/* Index in `known` of the word that follows `after` in order of (distance, index); -1 past the
   last. */
static int next_in_order(const char *word, const struct known_words *known, int after)
{
    const int from = after < 0 ? -1 : edits(word, known, after);
    int best = -1, best_distance = 0;

    for (int i = 0; i < known->n; i++)
    {
        const int d = edits(word, known, i);

        if ((d > from || (d == from && i > after)) && (best < 0 || d < best_distance))
        {
            best = i;
            best_distance = d;
        }
    }
    return best;
}

static const char *nearest_of(const char *word, const struct known_words *known)
{
    const int best = next_in_order(word, known, -1);

    /* a misspelling has up to a third of its letters wrong, rounded up; more is another word */
    if (best < 0 ||
        3*edits(word, known, best) > min_of(length(word), length(known->word[best])) + 2)
    {
        return NULL;
    }
    return known->word[best];
}

const char *dem_did_you_mean_nearest(const char *word, const char *const *known, int n)
{
    return nearest_of(word, &(const struct known_words){.word = known, .n = n});
}

int dem_did_you_mean_error(const char *what, const char *word, const char *const *known, int n)
{
    return dem_did_you_mean_alias_error(what, word, known, NULL, n);
}

int dem_did_you_mean_alias_error(const char *what, const char *word, const char *const *known,
                                 const char *const *aliases, int n)
{
    const struct known_words all = {.word = known, .aliases = aliases, .n = n};
    const char *nearest = nearest_of(word, &all);
    char list[LIST_SIZE] = "";
    size_t used = 0;

    for (int i = next_in_order(word, &all, -1); i >= 0; i = next_in_order(word, &all, i))
    {
        const size_t left = sizeof list - used;
        const int wanted = snprintf(list + used, left, "%s%s", used > 0 ? ", " : "", known[i]);

        if (wanted < 0 || (size_t)wanted >= left)
        {
            memcpy(list + used - (left < 4 ? 4 - left : 0), "...", 4);
            break;
        }
        used += (size_t)wanted;
    }
    if (n <= 0)
    {
        return dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; none is known here, so leave it out",
                         what, word);
    }
    const char *note = nearest ? dem_alias_note(word, nearest) : NULL;

    return nearest ? dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; did you mean %s%s? known: %s",
                               what, word, nearest, note ? note : "", list)
                   : dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; known: %s", what, word, list);
}
