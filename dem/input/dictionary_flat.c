/*
 * dictionary_flat.c -- the entries of a dictionary as lines of text, "path value", to be stored and
 * compared.
 *
 *     walls/floor {}
 *     walls/floor/type plane
 *     insert/a/positions #0f3a... (3000 words)
 *
 * A dictionary has a line of its own, so that an empty one is there, too. A long value is its hash.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary.h"

#include "core/hash.h"
#include "core/text.h"
#include "input/dictionary_tree.h"

#include <stdio.h>
#include <string.h>

enum
{
    LONG = 160,  /* bytes of a value that stands in the text */
    PATH = 512
};

struct value
{
    struct dem_hash hash;
    char text[LONG + 1];
    size_t length;  /* of the whole value */
};

static void add_word(struct value *v, const char *word)
{
    const size_t n = strlen(word);
    const int joins = v->length == 0 || strchr("([", v->text[v->length - 1]) || strchr(")]", word[0]);

    dem_hash_bytes(&v->hash, word, n + 1);
    if (v->length < LONG && v->length + n + 1 < LONG)
    {
        v->length += (size_t)snprintf(v->text + v->length, LONG - v->length, "%s%s",
                                      joins ? "" : " ", word);
    }
    else
    {
        v->length = LONG;
    }
}

/* No line may end within a value. */
static void blank_controls(char *text)
{
    for (; *text; text++)
    {
        *text = (unsigned char)*text < ' ' ? ' ' : *text;
    }
}

static void add_dict(struct value *v, const struct dem_dict *d);

static void add_tokens(struct value *v, const struct dem_entry *e)
{
    for (size_t k = 0; k < e->count; k++)
    {
        if (e->tokens[k].dict)
        {
            add_dict(v, e->tokens[k].dict);
        }
        else
        {
            add_word(v, e->tokens[k].text);
        }
    }
}

/* A dictionary in a list is part of the value. */
static void add_dict(struct value *v, const struct dem_dict *d)
{
    add_word(v, d->name);
    add_word(v, "{");
    for (size_t k = 0; k < d->count; k++)
    {
        add_word(v, d->entries[k]->name);
        if (d->entries[k]->dict)
        {
            add_dict(v, d->entries[k]->dict);
        }
        else
        {
            add_tokens(v, d->entries[k]);
        }
        add_word(v, ";");
    }
    add_word(v, "}");
}

static void flatten(const struct dem_entry *e, const char *within, struct dem_text *t)
{
    char path[PATH];

    snprintf(path, sizeof path, "%s%s%s", within, *within ? "/" : "", e->name);
    blank_controls(path);
    for (char *c = path; *c; c++)
    {
        *c = *c == ' ' ? '_' : *c;
    }
    if (e->dict)
    {
        dem_text_add(t, "%s {}\n", path);
        for (size_t k = 0; k < e->dict->count; k++)
        {
            flatten(e->dict->entries[k], path, t);
        }
        return;
    }
    struct value v = {.length = 0};

    dem_hash_start(&v.hash, 'e');
    add_tokens(&v, e);
    blank_controls(v.text);
    if (v.length < LONG)
    {
        dem_text_add(t, "%s %s\n", path, v.text);
    }
    else
    {
        dem_text_add(t, "%s #%016llx (%zu words)\n", path,
                     (unsigned long long)dem_hash_value(&v.hash), e->count);
    }
}

void dem_dict_flatten(const struct dem_dict *d, const char *const *section, int sections,
                      struct dem_text *t)
{
    for (int k = 0; k < sections; k++)
    {
        const struct dem_entry *const e = dem_dict_find(d, section[k], strlen(section[k]));

        if (e)
        {
            flatten(e, "", t);
        }
    }
}
