/*
 * dictionary_lists.c -- read lists of a dictionary (numbers, vectors, words) and whole structs by
 * their settings table.
 *
 * A list is ( ... ); OpenFOAM may write it with its type and length in front, List<scalar> 3 ( ...
 * ). A length that differs from the number of items is refused, because a part of the list was lost
 * or added by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary.h"

#include "core/error.h"
#include "input/dictionary_tree.h"

#include <string.h>

/* Set the cursor to the first item of a list; `claimed` is the length in front of it, or -1. */
static bool open_list(const struct dem_entry *e, struct dem_cursor *c, double *claimed)
{
    *c = (struct dem_cursor){e->tokens, e->tokens + e->count};
    *claimed = -1.0;
    if (c->at < c->end && c->at->kind == DEM_TOKEN_WORD && strncmp(c->at->text, "List<", 5) == 0)
    {
        c->at++;
    }
    dem_dict_skip_dimensions(c);
    dem_dict_take_number(c, claimed);
    return dem_dict_take_sign(c, '(');
}

static int check_length(const struct dem_entry *e, double claimed, size_t n)
{
    DEM_REQUIRE(claimed < 0.0 || claimed == (double)n, DEM_ERROR_INPUT,
                "%s: the list %s is declared with length %g and has %zu items; correct the length "
                "or leave it out",
                dem_entry_where(e), e->name, claimed, n);
    return DEM_OK;
}

static bool take_number(struct dem_cursor *c, void *items, size_t i)
{
    return dem_dict_take_number(c, (double *)items + i);
}

static bool take_whole(struct dem_cursor *c, void *items, size_t i)
{
    const bool there = c->at < c->end && c->at->kind == DEM_TOKEN_WORD
                    && dem_dict_is_whole(c->at->text, (int64_t *)items + i);

    c->at += there;
    return there;
}

static bool take_vector(struct dem_cursor *c, void *items, size_t i)
{
    return dem_dict_take_vector(c, ((double(*)[3])items)[i]);
}

static bool take_four(struct dem_cursor *c, void *items, size_t i)
{
    return dem_dict_take_row(c, 4, ((double(*)[4])items)[i]);
}

static bool take_word(struct dem_cursor *c, void *items, size_t i)
{
    return dem_dict_take_word(c, (const char **)items + i);
}

/* The properties of a kind of list. */
struct kind
{
    const char *expected;
    bool (*take)(struct dem_cursor *c, void *items, size_t i);
    size_t size;
};

/* `values`: where the pointer to the array goes. It has the capacity for the largest possible number of
   items: each takes at least one token. */
static int read_list(const struct dem_dict *d, const char *name, const struct kind *kind,
                     const char *unit, void *values, size_t *n)
{
    const struct dem_entry *e;
    struct dem_cursor c;
    double claimed;
    void *items;

    *n = 0;
    DEM_TRY(dem_dict_require(d, name, unit, &e));
    DEM_TRY(dem_dict_pool_alloc(e->parent->pool, (e->count + 1)*kind->size, &items));
    if (!open_list(e, &c, &claimed))
    {
        return dem_dict_refuse_value(e, kind->expected, unit);
    }
    while (kind->take(&c, items, *n))
    {
        (*n)++;
    }
    if (!dem_dict_take_sign(&c, ')') || c.at != c.end)
    {
        return dem_dict_refuse_value(e, kind->expected, unit);
    }
    memcpy(values, &items, sizeof items);
    return check_length(e, claimed, *n);
}

int dem_dict_numbers(const struct dem_dict *d, const char *name, const char *unit,
                     const double **values, size_t *n)
{
    static const struct kind numbers = {"a list of numbers ( ... )", take_number, sizeof(double)};

    return read_list(d, name, &numbers, unit, values, n);
}

int dem_dict_int64s(const struct dem_dict *d, const char *name, const int64_t **values, size_t *n)
{
    static const struct kind wholes = {"a list of whole numbers ( ... )", take_whole,
                                       sizeof(int64_t)};

    return read_list(d, name, &wholes, "", values, n);
}

int dem_dict_vectors(const struct dem_dict *d, const char *name, const char *unit,
                     const double (**values)[3], size_t *n)
{
    static const struct kind vectors = {"a list of vectors ( (x y z) ... )", take_vector,
                                        sizeof(double[3])};

    return read_list(d, name, &vectors, unit, values, n);
}

int dem_dict_fours(const struct dem_dict *d, const char *name, const char *unit,
                   const double (**values)[4], size_t *n)
{
    static const struct kind fours = {"a list of four numbers each ( (x y z r) ... )", take_four,
                                      sizeof(double[4])};

    return read_list(d, name, &fours, unit, values, n);
}

int dem_dict_words(const struct dem_dict *d, const char *name, const char *const **words, size_t *n)
{
    static const struct kind kind = {"a list of words ( ... )", take_word, sizeof(char *)};

    return read_list(d, name, &kind, "", words, n);
}

/* The name of this dictionary in messages of the settings table. */
static const char *owner_of(const struct dem_dict *d)
{
    const char *path = dem_dict_path(d);

    return *path ? path : "top level";
}

/* Messages of the dictionary have the location; it is added to messages of the settings table. */
static int read_setting(const struct dem_dict *d, const struct dem_setting *table,
                        const struct dem_setting *f, void *settings)
{
    const bool is_word = f->kind == DEM_SETTING_CHOICE || f->kind == DEM_SETTING_SWITCH;
    const struct dem_entry *e;
    const char *word;
    double value[3];
    int status;

    DEM_TRY(dem_dict_require(d, f->name, f->unit, &e));
    if (is_word)
    {
        DEM_TRY(dem_dict_word(d, f->name, &word));
        status = dem_settings_set_word(table, settings, owner_of(d), f->name, word);
    }
    else
    {
        DEM_TRY(f->kind == DEM_SETTING_VECTOR ? dem_dict_vector(d, f->name, f->unit, value)
                                            : dem_dict_number(d, f->name, f->unit, value));
        status = dem_settings_set_number(table, settings, owner_of(d), f->name, value,
                                      f->kind == DEM_SETTING_VECTOR ? 3 : 1);
    }
    return status == DEM_OK ? DEM_OK : dem_error_prefix(status, "%s: ", dem_entry_where(e));
}

/* A required setting has no value. If one was misspelt, the message says so. */
static int refuse_missing(const struct dem_dict *d, const struct dem_setting *table,
                          const void *settings)
{
    const struct dem_entry *e;

    for (const struct dem_setting *f = table; f->name; f++)
    {
        if (!dem_dict_has(d, f->name) && dem_dict_find_misspelt(d, f->name))
        {
            return dem_dict_require(d, f->name, f->unit, &e);
        }
    }
    return dem_error_prefix(dem_settings_check_complete(table, settings, owner_of(d)),
                            "%s: ", dem_dict_where(d));
}

int dem_dict_settings(const struct dem_dict *d, const struct dem_setting *table, void *settings)
{
    dem_settings_set_defaults(table, settings);
    for (const struct dem_setting *f = table; f->name; f++)
    {
        if (dem_dict_has(d, f->name))
        {
            DEM_TRY(read_setting(d, table, f, settings));
        }
    }
    return dem_settings_check_complete(table, settings, owner_of(d)) == DEM_OK
             ? DEM_OK
             : refuse_missing(d, table, settings);
}
