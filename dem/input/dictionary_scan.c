/*
 * dictionary_scan.c -- scanner of dictionaries: text becomes words, strings and signs with their
 * lines.
 *
 * As in OpenFOAM a word may contain parentheses that follow it directly and close before any white
 * space: div(phi,U) is one word; points (0 1) and 3(0 1 2) are a word and a list. Unlike in
 * OpenFOAM a word may contain a slash, so a path needs no quotes; // and the opening of a C comment
 * still begin a comment.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "input/dictionary_tree.h"

#include "core/error.h"

#include <string.h>

static bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

static bool is_sign(char c)
{
    return c != '\0' && strchr("(){}[];", c) != NULL;
}

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool starts(const struct dem_scan *s, const char *at, const char *mark)
{
    const size_t n = strlen(mark);

    return (size_t)(s->end - at) >= n && memcmp(at, mark, n) == 0;
}

void dem_dict_scan_start(struct dem_scan *s, const char *text, size_t length, const char *file,
                         struct dem_dict_pool *pool)
{
    *s = (struct dem_scan){.at = text, .end = text + length, .file = file, .line = 1, .pool = pool};
    if (starts(s, s->at, "\xef\xbb\xbf"))    /* the byte order mark that some editors write */
    {
        s->at += 3;
    }
}

static void skip_rest_of_line(struct dem_scan *s)
{
    while (s->at < s->end && *s->at != '\n')
    {
        s->at++;
    }
}

static int skip_comment(struct dem_scan *s)
{
    const int begun = s->line;

    for (s->at += 2; s->at < s->end; s->at++)
    {
        if (starts(s, s->at, "*/"))
        {
            s->at += 2;
            return DEM_OK;
        }
        s->line += *s->at == '\n';
    }
    return dem_error(DEM_ERROR_INPUT,
                     "%s, line %d: the comment /* that begins here is never closed; add */",
                     s->file, begun);
}

static int skip_blank(struct dem_scan *s)
{
    while (s->at < s->end)
    {
        if (is_space(*s->at))
        {
            s->line += *s->at == '\n';
            s->at++;
        }
        else if (starts(s, s->at, "//"))
        {
            skip_rest_of_line(s);
        }
        else if (starts(s, s->at, "/*"))
        {
            DEM_TRY(skip_comment(s));
        }
        else
        {
            break;
        }
    }
    return DEM_OK;
}

/* "..." on one line; \" is a quote, \\ a backslash; a backslash at the end of a line continues
   the string. */
static int scan_string(struct dem_scan *s, struct dem_token *token)
{
    const char *from = s->at + 1, *to = from;
    const int begun = s->line;
    size_t n = 0;
    char *out;
    void *p;

    while (to < s->end && *to != '"' && *to != '\n' && *to != '\0')
    {
        to += *to == '\\' && to + 1 < s->end ? 2 : 1;
    }
    DEM_REQUIRE(to < s->end && *to == '"', DEM_ERROR_INPUT,
                "%s, line %d: the string that begins here is not closed on its line; add \"",
                s->file, begun);
    DEM_TRY(dem_dict_pool_alloc(s->pool, (size_t)(to - from) + 1, &p));
    for (out = p; from < to; from++)
    {
        const bool escape = *from == '\\' && (from[1] == '"' || from[1] == '\\' || from[1] == '\n');

        from += escape;
        s->line += *from == '\n';
        if (!(escape && *from == '\n'))
        {
            out[n++] = *from;
        }
    }
    s->at = to + 1;
    *token = (struct dem_token){.text = p, .line = begun, .kind = DEM_TOKEN_STRING};
    return DEM_OK;
}

/* Length of "(phi,U)" at `at` when it can be part of a word, else 0. */
static size_t balanced(const struct dem_scan *s, const char *at)
{
    int depth = 0;

    for (const char *c = at; c < s->end && !is_space(*c) && strchr("\";{}[]", *c) == NULL; c++)
    {
        depth += (*c == '(') - (*c == ')');
        if (depth == 0)
        {
            return (size_t)(c + 1 - at);
        }
    }
    return 0;
}

static const char *word_end(const struct dem_scan *s)
{
    const char *c = s->at;

    while (c < s->end && *c != '\0' && *c != '"' && !is_space(*c) && !starts(s, c, "//")
           && !starts(s, c, "/*"))
    {
        if (is_sign(*c))
        {
            const size_t more = *c == '(' && is_letter(*s->at) ? balanced(s, c) : 0;

            if (more == 0)
            {
                break;
            }
            c += more;
        }
        else
        {
            c++;
        }
    }
    return c;
}

/* ${name} becomes the token $name. */
static int scan_braced_macro(struct dem_scan *s, struct dem_token *token)
{
    const char *from = s->at + 2, *to = from;
    char *text;
    void *p;

    while (to < s->end && !is_space(*to) && *to != '}' && *to != ';' && *to != '\0')
    {
        to++;
    }
    DEM_REQUIRE(to < s->end && *to == '}', DEM_ERROR_INPUT,
                "%s, line %d: expected } to close ${%.*s", s->file, s->line,
                (int)(to - from < 40 ? to - from : 40), from);
    DEM_TRY(dem_dict_pool_alloc(s->pool, (size_t)(to - from) + 2, &p));
    text = p;
    text[0] = '$';
    memcpy(text + 1, from, (size_t)(to - from));
    s->at = to + 1;
    *token = (struct dem_token){.text = text, .line = s->line, .kind = DEM_TOKEN_WORD};
    return DEM_OK;
}

int dem_dict_scan(struct dem_scan *s, struct dem_token *token)
{
    DEM_TRY(skip_blank(s));
    *token = (struct dem_token){.text = "end of file", .line = s->line, .kind = DEM_TOKEN_END};
    if (s->at >= s->end)
    {
        return DEM_OK;
    }
    DEM_REQUIRE(*s->at != '\0', DEM_ERROR_INPUT,
                "%s, line %d: found a zero byte; a dictionary is plain text, is this the right "
                "file?",
                s->file, s->line);
    if (*s->at == '"')
    {
        return scan_string(s, token);
    }
    if (starts(s, s->at, "${"))
    {
        return scan_braced_macro(s, token);
    }

    const char *end = is_sign(*s->at) ? s->at + 1 : word_end(s);

    token->kind = is_sign(*s->at) ? DEM_TOKEN_SIGN : DEM_TOKEN_WORD;
    DEM_TRY(dem_dict_pool_copy(s->pool, s->at, (size_t)(end - s->at), &token->text));
    s->at = end;
    return DEM_OK;
}

int dem_dict_scan_line_mark(struct dem_scan *s)
{
    const char *from = s->at, *end;
    long line = 0;
    int digits = 0;

    skip_rest_of_line(s);
    for (end = s->at; from < end && (*from == ' ' || *from == '\t'); from++)
    {
    }
    for (; from < end && *from >= '0' && *from <= '9' && digits < 9; from++, digits++)
    {
        line = 10*line + (*from - '0');
    }
    DEM_REQUIRE(digits > 0 && line > 0, DEM_ERROR_INPUT,
                "%s, line %d: write #line <number> \"file\"", s->file, s->line);

    const char *open = memchr(from, '"', (size_t)(end - from));
    const char *close = open ? memchr(open + 1, '"', (size_t)(end - open - 1)) : NULL;

    if (close)
    {
        DEM_TRY(dem_dict_pool_copy(s->pool, open + 1, (size_t)(close - open - 1), &s->file));
    }
    s->line = (int)line - 1;    /* the end of the #line line itself counts one */
    return DEM_OK;
}
