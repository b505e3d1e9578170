/*
 * dictionary.c -- read single values of a dictionary by name; error messages for missing and wrong
 * values.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary.h"

#include "core/error.h"
#include "core/aliases.h"
#include "core/did_you_mean.h"
#include "input/dictionary_tree.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
    MAX_CANDIDATES = 64  /* entries compared with a missing name */
};

static bool has_unit(const char *unit)
{
    return unit && *unit && strcmp(unit, "1") != 0;
}

/* An unread entry of d whose name looks like a misspelling of `name`, or null. */
const struct dem_entry *dem_dict_find_misspelt(const struct dem_dict *d, const char *name)
{
    const char *names[MAX_CANDIDATES], *near;
    int n = 0;

    for (size_t i = 0; i < d->count && n < MAX_CANDIDATES; i++)
    {
        if (!d->entries[i]->used)
        {
            names[n++] = d->entries[i]->name;
        }
    }
    near = n > 0 ? dem_did_you_mean_nearest(name, names, n) : NULL;
    return near ? dem_dict_find(d, near, strlen(near)) : NULL;
}

/* Index of the first token of e that is this word (null: any word), is not the first token of the
   value and stands outside brackets; e->count when there is none. */
static size_t find_inside(const struct dem_entry *e, const char *word)
{
    int depth = 0;

    for (size_t i = 0; i < e->count; i++)
    {
        const struct dem_token *t = &e->tokens[i];

        if (i > 0 && depth == 0 && t->kind == DEM_TOKEN_WORD
            && (!word || strcmp(t->text, word) == 0))
        {
            return i;
        }
        if (t->kind == DEM_TOKEN_SIGN)
        {
            depth += strchr("([", t->text[0]) ? 1 : -1;
        }
    }
    return e->count;
}

/* The name read here of which the unread entry e is another code's word, or NULL. */
static const char *meant_by(const struct dem_entry *e)
{
    const struct dem_dict_known_names *const q = e->parent->known_names;

    for (size_t k = 0; k < q->count; k++)
    {
        if (dem_alias_note(e->name, q->names[k]))
        {
            return q->names[k];
        }
    }
    return NULL;
}

/* Why an entry is missing: an unread one is misspelt or a word of another code, or the entry before it has no semicolon,
   so that its value contains this one. */
static void explain_absence(const struct dem_dict *d, const char *name, char *hint, size_t size)
{
    const struct dem_entry *const misspelt = dem_dict_find_misspelt(d, name);
    const char *const note = misspelt ? dem_alias_note(misspelt->name, name) : NULL;

    hint[0] = '\0';
    if (misspelt)
    {
        snprintf(hint, size, "; is \"%.60s\" in line %d meant to be it%s?", misspelt->name,
                 misspelt->line, note ? note : "");
    }
    for (size_t i = 0; i < d->count; i++)
    {
        const struct dem_entry *const e = d->entries[i];
        const char *const meant = misspelt || e->used ? NULL : meant_by(e);
        const size_t at = find_inside(e, name);

        if (meant)
        {
            snprintf(hint, size, "; is \"%.60s\" in line %d meant to be %.60s?", e->name, e->line, meant);
        }
        if (at < e->count)
        {
            snprintf(hint, size,
                     "; it is part of the value of %.60s: is a ; missing at the end of line %d?",
                     e->name, e->tokens[at - 1].line);
        }
    }
}

int dem_dict_require(const struct dem_dict *d, const char *name, const char *unit,
                     const struct dem_entry **e)
{
    struct dem_entry *found = dem_dict_find(d, name, strlen(name));
    char hint[192];

    dem_dict_add_known_name(d, name);
    if (found)
    {
        found->used = true;
        *e = found;
        return dem_dict_check_dimensions(found, unit);
    }
    explain_absence(d, name, hint, sizeof hint);
    return dem_error(DEM_ERROR_INPUT, "%s: %s%sneeds %s%s%s%s%s", dem_dict_where(d),
                     dem_dict_path(d), *dem_dict_path(d) ? " " : "", name,
                     has_unit(unit) ? " (" : "", has_unit(unit) ? unit : "",
                     has_unit(unit) ? ")" : "", hint);
}

/* The line at whose end a semicolon may be missing, or 0: after the first token of the value
   there is a word followed by a value, or a token on a later line. */
static int broken_line(const struct dem_entry *e)
{
    const size_t at = find_inside(e, NULL);
    double number;

    if (at < e->count
        && (e->tokens[at].line > e->tokens[at - 1].line
            || (at + 1 < e->count && !dem_dict_is_number(e->tokens[at].text, &number))))
    {
        return e->tokens[at - 1].line;
    }
    return 0;
}

int dem_dict_refuse_value(const struct dem_entry *e, const char *expected, const char *unit)
{
    const char *path = dem_dict_path(e->parent);
    const int broken = broken_line(e);
    char found[96], hint[64] = "";

    if (e->dict || e->count == 0)
    {
        snprintf(found, sizeof found, "found %s", e->dict ? "a dictionary" : "nothing");
    }
    else
    {
        char value[80];

        dem_dict_print(e->tokens, e->count, value, sizeof value);
        snprintf(found, sizeof found, "found \"%s\"", value);
    }
    if (broken > 0)
    {
        snprintf(hint, sizeof hint, "; is a ; missing at the end of line %d?", broken);
    }
    return dem_error(DEM_ERROR_INPUT, "%s: %s%s%s takes %s%s%s%s, %s%s", dem_entry_where(e), path,
                     *path ? "/" : "", e->name, expected, has_unit(unit) ? " (" : "",
                     has_unit(unit) ? unit : "", has_unit(unit) ? ")" : "", found, hint);
}

/* The value of an entry after its dimensions. */
static struct dem_cursor value_of(const struct dem_entry *e)
{
    struct dem_cursor c = {e->tokens, e->tokens + e->count};

    dem_dict_skip_dimensions(&c);
    return c;
}

bool dem_dict_has(const struct dem_dict *d, const char *name)
{
    dem_dict_add_known_name(d, name);
    return dem_dict_find(d, name, strlen(name)) != NULL;
}

bool dem_dict_has_dict(const struct dem_dict *d, const char *name)
{
    const struct dem_entry *const e = dem_dict_has(d, name) ? dem_dict_find(d, name, strlen(name)) : NULL;

    return e && e->dict;
}

int dem_dict_sub(const struct dem_dict *d, const char *name, const struct dem_dict **sub)
{
    const struct dem_entry *e;

    DEM_TRY(dem_dict_require(d, name, "a dictionary", &e));
    *sub = e->dict;
    return e->dict ? DEM_OK : dem_dict_refuse_value(e, "a dictionary { ... }", "");
}

int dem_dict_sub_if(const struct dem_dict *d, const char *name, const struct dem_dict **sub)
{
    *sub = NULL;
    return dem_dict_has(d, name) ? dem_dict_sub(d, name, sub) : DEM_OK;
}

int dem_dict_number(const struct dem_dict *d, const char *name, const char *unit, double *value)
{
    const struct dem_entry *e;
    struct dem_cursor c;

    DEM_TRY(dem_dict_require(d, name, unit, &e));
    c = value_of(e);
    return dem_dict_take_number(&c, value) && c.at == c.end
             ? DEM_OK
             : dem_dict_refuse_value(e, "one number", unit);
}

int dem_dict_number_or(const struct dem_dict *d, const char *name, const char *unit,
                       double fallback, double *value)
{
    *value = fallback;
    return dem_dict_has(d, name) ? dem_dict_number(d, name, unit, value) : DEM_OK;
}

int dem_dict_vector(const struct dem_dict *d, const char *name, const char *unit, double value[3])
{
    const struct dem_entry *e;
    struct dem_cursor c;

    DEM_TRY(dem_dict_require(d, name, unit, &e));
    c = value_of(e);
    return dem_dict_take_vector(&c, value) && c.at == c.end
             ? DEM_OK
             : dem_dict_refuse_value(e, "a vector (x y z)", unit);
}

int dem_dict_vector_or(const struct dem_dict *d, const char *name, const char *unit,
                       const double fallback[3], double value[3])
{
    if (dem_dict_has(d, name))
    {
        return dem_dict_vector(d, name, unit, value);
    }
    memcpy(value, fallback, 3*sizeof *value);
    return DEM_OK;
}

int dem_dict_int64(const struct dem_dict *d, const char *name, int64_t *value)
{
    const struct dem_entry *e;
    struct dem_cursor c;

    DEM_TRY(dem_dict_require(d, name, "", &e));
    c = value_of(e);
    return c.end - c.at == 1 && c.at->kind == DEM_TOKEN_WORD && dem_dict_is_whole(c.at->text, value)
               ? DEM_OK
               : dem_dict_refuse_value(e, "one whole number", "");
}

int dem_dict_int64_or(const struct dem_dict *d, const char *name, int64_t fallback, int64_t *value)
{
    *value = fallback;
    return dem_dict_has(d, name) ? dem_dict_int64(d, name, value) : DEM_OK;
}

int dem_dict_text(const struct dem_dict *d, const char *name, const char **text)
{
    const struct dem_entry *e;
    struct dem_cursor c;

    DEM_TRY(dem_dict_require(d, name, "", &e));
    c = value_of(e);
    return dem_dict_take_word(&c, text) && c.at == c.end
             ? DEM_OK
             : dem_dict_refuse_value(e, "one word or \"text\"", "");
}

int dem_dict_text_or(const struct dem_dict *d, const char *name, const char *fallback,
                     const char **text)
{
    *text = fallback;
    return dem_dict_has(d, name) ? dem_dict_text(d, name, text) : DEM_OK;
}

int dem_dict_word(const struct dem_dict *d, const char *name, const char **word)
{
    const struct dem_entry *e;
    struct dem_cursor c;

    DEM_TRY(dem_dict_require(d, name, "", &e));
    c = value_of(e);
    return dem_dict_take_word(&c, word) && c.at == c.end && **word && !strpbrk(*word, " \t\n")
               ? DEM_OK
               : dem_dict_refuse_value(e, "one word", "");
}

int dem_dict_word_or(const struct dem_dict *d, const char *name, const char *fallback,
                     const char **word)
{
    *word = fallback;
    return dem_dict_has(d, name) ? dem_dict_word(d, name, word) : DEM_OK;
}

int dem_dict_switch(const struct dem_dict *d, const char *name, bool *value)
{
    static const char *const words[] = {"no", "yes", "off", "on", "false", "true"};
    const struct dem_entry *e;

    DEM_TRY(dem_dict_require(d, name, "", &e));
    for (size_t i = 0; i < sizeof words/sizeof *words; i++)
    {
        if (e->count == 1 && strcmp(e->tokens[0].text, words[i]) == 0)
        {
            *value = i%2 == 1;
            return DEM_OK;
        }
    }
    return dem_dict_refuse_value(e, "yes or no (on, off, true, false)", "");
}

int dem_dict_switch_or(const struct dem_dict *d, const char *name, bool fallback, bool *value)
{
    *value = fallback;
    return dem_dict_has(d, name) ? dem_dict_switch(d, name, value) : DEM_OK;
}
