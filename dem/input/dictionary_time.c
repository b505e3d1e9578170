/*
 * dictionary_time.c -- a time of the scene: a number in seconds, or the name of a stage, which means
 * the beginning of that stage.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/did_you_mean.h"
#include "core/error.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    MAX_SUGGESTED = 64    /* names among which a message looks for a similar one */
};

/* The entry `stages` of the scene that d belongs to, or null. */
static const struct dem_dict *stages_of(const struct dem_dict *d)
{
    while (d->parent)
    {
        d = d->parent;
    }
    const struct dem_entry *const e = dem_dict_find(d, "stages", 6);

    return e && dem_entry_is_dict(e) ? e->dict : NULL;
}

static int find_stage(const struct dem_dict *stages, const struct dem_entry *e, const char *name,
                      int *stage)
{
    const char *known[MAX_SUGGESTED];
    int n = 0;

    for (size_t k = 0; k < dem_dict_count(stages); k++)
    {
        const char *const other = dem_entry_name(dem_dict_entry(stages, k));

        if (strcmp(other, name) == 0)
        {
            *stage = (int)k + 1;
            return DEM_OK;
        }
        if (n < MAX_SUGGESTED)
        {
            known[n++] = other;
        }
    }
    return dem_error_prefix(dem_did_you_mean_error("stage", name, known, n), "%s: %s: ",
                            dem_entry_where(e), e->name);
}

/* inf and nan are numbers, too */
static bool is_number(const char *word)
{
    char *end;

    (void)strtod(word, &end);
    return *end == '\0';
}

int dem_dict_time_or(const struct dem_dict *d, const char *name, double fallback, double *value,
                     int *stage)
{
    const struct dem_entry *const e = dem_dict_find(d, name, strlen(name));
    const struct dem_dict *const stages = stages_of(d);
    const char *word = e && dem_entry_tokens(e) == 1 ? e->tokens[0].text : "";

    *stage = 0;
    DEM_REQUIRE(stages || !isalpha((unsigned char)word[0]) || is_number(word), DEM_ERROR_INPUT,
                "%s: %s: stage %s, but the scene has no stages; give a time in s, or add stages { %s { duration 1; } }",
                dem_entry_where(e), name, word, word);
    if (!stages || !isalpha((unsigned char)word[0]))
    {
        return dem_dict_number_or(d, name, "s", fallback, value);
    }
    DEM_TRY(dem_dict_word(d, name, &word));
    *value = INFINITY;
    return find_stage(stages, e, word, stage);
}

/* As it stands in the scene: a stage, or a number. */
static void print_time(const struct dem_dict *d, const char *name, double time, int stage, char text[64])
{
    const struct dem_entry *const e = dem_dict_find(d, name, strlen(name));

    if (stage && e)
    {
        snprintf(text, 64, "%.60s", e->tokens[0].text);
    }
    else
    {
        snprintf(text, 64, "%g s", time);
    }
}

int dem_dict_check_times(const struct dem_dict *d, const char *first, const char *last,
                         const double time[2], const int stage[2])
{
    char begin[64], end[64];

    print_time(d, first, time[0], stage[0], begin);
    print_time(d, last, time[1], stage[1], end);
    DEM_REQUIRE(stage[1] ? stage[0] < stage[1] : stage[0] || time[0] < time[1], DEM_ERROR_INPUT,
                "%s: %s: %s %s is not after %s %s; give a later one", dem_dict_where(d), dem_dict_path(d),
                last, end, first, begin);
    return DEM_OK;
}
