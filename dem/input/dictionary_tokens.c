/*
 * dictionary_tokens.c -- convert tokens to numbers, vectors and words, skip dimensions, print
 * tokens.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* strtod also accepts hexadecimal, inf and nan, and its overflow would trigger OpenFOAM's
   floating-point traps. */
bool dem_dict_is_number(const char *text, double *value)
{
    char *end = NULL;
    fenv_t traps;

    if (*text == '\0' || strspn(text, "+-.0123456789eE") != strlen(text)
        || !strpbrk(text, "0123456789"))
    {
        return false;
    }
    feholdexcept(&traps);
    *value = strtod(text, &end);
    fesetenv(&traps);
    return *end == '\0' && fabs(*value) <= DBL_MAX;
}

/* Plain digits are read exactly; 1e6 is a whole number too, up to 2^53. */
bool dem_dict_is_whole(const char *text, int64_t *value)
{
    char *end;
    double number;

    errno = 0;
    *value = strtoll(text, &end, 10);
    if (*end == '\0' && end != text)
    {
        return errno == 0;
    }
    if (!dem_dict_is_number(text, &number) || fabs(number) > 0x1p53 || floor(number) != number)
    {
        return false;
    }
    *value = (int64_t)number;
    return true;
}

bool dem_dict_is_sign(const struct dem_token *t, char sign)
{
    return t->kind == DEM_TOKEN_SIGN && t->text[0] == sign;
}

bool dem_dict_is_name(const struct dem_token *t)
{
    return t->kind == DEM_TOKEN_STRING
        || (t->kind == DEM_TOKEN_WORD && t->text[0] != '$' && t->text[0] != '#');
}

bool dem_dict_take_sign(struct dem_cursor *c, char sign)
{
    const bool there = c->at < c->end && c->at->kind == DEM_TOKEN_SIGN && c->at->text[0] == sign;

    c->at += there;
    return there;
}

bool dem_dict_take_number(struct dem_cursor *c, double *value)
{
    const bool there =
        c->at < c->end && c->at->kind == DEM_TOKEN_WORD && dem_dict_is_number(c->at->text, value);

    c->at += there;
    return there;
}

bool dem_dict_take_word(struct dem_cursor *c, const char **word)
{
    const bool there =
        c->at < c->end && (c->at->kind == DEM_TOKEN_WORD || c->at->kind == DEM_TOKEN_STRING);

    if (there)
    {
        *word = c->at->text;
    }
    c->at += there;
    return there;
}

bool dem_dict_take_row(struct dem_cursor *c, int n, double *value)
{
    struct dem_cursor ahead = *c;
    double length = n;
    bool good;

    dem_dict_take_number(&ahead, &length);    /* OpenFOAM may write 3 ( ... ) */
    good = length == (double)n && dem_dict_take_sign(&ahead, '(');
    for (int i = 0; i < n; i++)
    {
        good = good && dem_dict_take_number(&ahead, &value[i]);
    }
    good = good && dem_dict_take_sign(&ahead, ')');
    *c = good ? ahead : *c;
    return good;
}

bool dem_dict_take_vector(struct dem_cursor *c, double value[3])
{
    return dem_dict_take_row(c, 3, value);
}

void dem_dict_skip_dimensions(struct dem_cursor *c)
{
    struct dem_cursor ahead = *c;
    const char *name;
    double number;

    if (!dem_dict_take_number(&ahead, &number))
    {
        dem_dict_take_word(&ahead, &name);
    }
    if (dem_dict_take_sign(&ahead, '[') || (ahead = *c, dem_dict_take_sign(&ahead, '[')))
    {
        while (ahead.at < ahead.end && !dem_dict_take_sign(&ahead, ']'))
        {
            ahead.at++;
        }
        *c = ahead;
    }
}

void dem_dict_print(const struct dem_token *tokens, size_t count, char *out, size_t size)
{
    size_t used = 0;

    for (size_t i = 0; i < count; i++)
    {
        const char *text = tokens[i].text;
        const size_t length = strlen(text) + (i > 0);

        if (used + length + sizeof " ..." > size)
        {
            memcpy(out + used, " ...", sizeof " ...");
            return;
        }
        if (i > 0)
        {
            out[used++] = ' ';
        }
        memcpy(out + used, text, strlen(text));
        used += strlen(text);
    }
    out[used] = '\0';
}
