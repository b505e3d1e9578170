/*
 * unknown.c -- the known words sorted by how few slips of the pen lead to them; first what is meant by habit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "base/unknown.h"
#include "base/error.h"
#include "base/habits.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum
{
    LONGEST = 63,     /* letters of a word that are looked at */
    SENTENCE = 2048   /* bytes for the list of known words    */
};

static int least(int a, int b)
{
    return a < b ? a : b;
}

static int letter(const char *word, int i)
{
    return tolower((unsigned char)word[i]);
}

static int length(const char *word)
{
    const char *end = memchr(word, '\0', LONGEST);

    return end ? (int)(end - word) : LONGEST;
}

/* insertions, removals, changes and swaps of neighbours that make b of a; three rows of the table are kept */
static int distance(const char *a, const char *b)
{
    int row[3][LONGEST + 1];
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
            const int same = letter(a, i - 1) == letter(b, j - 1);

            now[j] = least(last[j - 1] + !same, least(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && letter(a, i - 1) == letter(b, j - 2)
                && letter(a, i - 2) == letter(b, j - 1))
            {
                now[j] = least(now[j], before[j - 2] + 1);
            }
        }
    }
    return row[na%3][nb];
}

/* slips that lead from one to the other; none when one is another code's word for it */
static int slips(const char *word, const char *known)
{
    return dem_habit(word, known) || dem_habit(known, word) ? 0 : distance(word, known);
}

/* place in known of the next word in order of (distance, place) after the one given; -1 past the last */
static int next_in_order(const char *word, const char *const *known, int n, int after)
{
    const int from = after < 0 ? -1 : slips(word, known[after]);
    int best = -1, best_distance = 0;

    for (int i = 0; i < n; i++)
    {
        const int d = slips(word, known[i]);

        if ((d > from || (d == from && i > after)) && (best < 0 || d < best_distance))
        {
            best = i;
            best_distance = d;
        }
    }
    return best;
}

const char *dem_unknown_nearest(const char *word, const char *const *known, int n)
{
    const int best = next_in_order(word, known, n, -1);

    /* up to a third of the letters wrong, rounded up, is a slip; more is another word */
    if (best < 0 || 3*slips(word, known[best]) > least(length(word), length(known[best])) + 2)
    {
        return NULL;
    }
    return known[best];
}

int dem_unknown_word(const char *what, const char *word, const char *const *known, int n)
{
    const char *nearest = dem_unknown_nearest(word, known, n);
    char list[SENTENCE] = "";
    size_t used = 0;

    for (int i = next_in_order(word, known, n, -1); i >= 0; i = next_in_order(word, known, n, i))
    {
        const size_t room = sizeof list - used;
        const int wanted = snprintf(list + used, room, "%s%s", used > 0 ? ", " : "", known[i]);

        if (wanted < 0 || (size_t)wanted >= room)
        {
            memcpy(list + used - (room < 4 ? 4 - room : 0), "...", 4);
            break;
        }
        used += (size_t)wanted;
    }
    if (n <= 0)
    {
        return dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; none is known here, so leave it out", what,
                         word);
    }
    const char *note = nearest ? dem_habit(word, nearest) : NULL;

    return nearest ? dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; did you mean %s%s? known: %s", what, word, nearest,
                               note ? note : "", list)
                   : dem_error(DEM_ERROR_INPUT, "unknown %s \"%s\"; known: %s", what, word, list);
}
