/*
 * scene_edit.c -- edits of the text of a scene: finds dictionaries by their braces, with the scanner of
 * input.
 *
 * An effect is in `effects { WORD { } }` and with other settings
 * in `pairs { NAME { WORD { } } }`: both are edited. All other text stays the same, byte by byte.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan_rewrite.h"
#include "input/dictionary_tree.h"
#include <string.h>

enum
{
    MAX_POSITIONS = 64
};

/* position of `WORD { ... }` in the text */
struct position
{
    size_t name, name_end, end;                           /* end: after the closing brace */
};

/* ---- finding --------------------------------------------------------------------------------------------------- */

static size_t line_end(const char *text, size_t at)
{
    return at + strcspn(text + at, "\n");
}

static int is(const char *text, struct position p, const char *word)
{
    return p.name_end - p.name == strlen(word) && memcmp(text + p.name, word, strlen(word)) == 0;
}

/* Is the dictionary open[depth] an effect, of all contacts or of a pair? */
static int is_effect(const char *text, const struct position *open, int depth)
{
    return (depth == 1 && is(text, open[0], "effects")) || (depth == 2 && is(text, open[0], "pairs"));
}

/* The dictionaries of this name, in the order of the text: effects or, with `top`, sections of the
   scene. Returns their number. The text has been read as a scene before. */
static int find(const char *text, const char *name, int top, struct position found[MAX_POSITIONS])
{
    /* last: the word before a brace */
    struct position open[DEM_DICT_MAX_DEPTH] = {{0}}, last = {0};
    struct dem_dict *memory;
    struct dem_token token;
    struct dem_scan scan;
    int depth = 0, n = 0;

    if (dem_dict_new_top(&memory, ""))
    {
        return 0;
    }
    dem_dict_scan_start(&scan, text, strlen(text), "", memory->pool);
    while (!dem_dict_scan(&scan, &token) && token.kind != DEM_TOKEN_END)
    {
        const size_t end = (size_t)(scan.at - text);

        if (token.kind == DEM_TOKEN_WORD)
        {
            last = (struct position){end - strlen(token.text), end, 0};
        }
        else if (dem_dict_is_sign(&token, '{') && depth < DEM_DICT_MAX_DEPTH)
        {
            open[depth++] = last;
        }
        else if (dem_dict_is_sign(&token, '}') && depth > 0)
        {
            open[--depth].end = end;
            if (n < MAX_POSITIONS && is(text, open[depth], name) &&
                (top ? depth == 0 : is_effect(text, open, depth)))
            {
                found[n++] = open[depth];
            }
        }
        if (dem_dict_is_sign(&token, '{') || dem_dict_is_sign(&token, '}') ||
            dem_dict_is_sign(&token, ';'))
        {
            last = (struct position){0};
        }
    }
    dem_dict_free(memory);
    return n;
}

/* ---- writing --------------------------------------------------------------------------------------------------- */

static void copy(struct dem_text *to, const char *text, size_t from, size_t end)
{
    dem_text_add(to, "%.*s", (int)(end - from), text + from);
}

static int blank(const char *text, size_t from, size_t end)
{
    return from + strspn(text + from, " \t\r\f\v") >= end;
}

/* Start of the line that contains `at`. */
static size_t line_start(const char *text, size_t at)
{
    while (at > 0 && text[at - 1] != '\n')
    {
        at--;
    }
    return at;
}

int dem_edit_add(struct dem_text *to, const char *text, const char *effect, const char *why)
{
    struct position found[MAX_POSITIONS];
    const int n = find(text, "effects", 1, found);

    if (n == 0)
    {
        dem_text_add(to, "%s\neffects\n{\n    %s {}    // dem plan: %s\n}\n", text, effect, why);
        return 1;
    }
    const size_t brace = found[n - 1].end - 1, start = line_start(text, brace);
    const int alone = blank(text, start, brace);

    copy(to, text, 0, alone ? start : brace);
    dem_text_add(to, alone ? "" : "\n");
    copy(to, text, start, alone ? brace : start);
    dem_text_add(to, "    %s {}    // dem plan: %s\n", effect, why);
    dem_text_add(to, "%s", text + (alone ? start : brace));
    return 1;
}

int dem_edit_rename(struct dem_text *to, const char *text, const char *effect, const char *other,
                    const char *why)
{
    struct position position[MAX_POSITIONS];
    const int n = find(text, effect, 0, position);
    size_t done = 0;

    for (int k = 0; k < n; k++)
    {
        copy(to, text, done, position[k].name);
        dem_text_add(to, "%s", other);
        copy(to, text, position[k].name_end, position[k].end);
        done = position[k].end;
        dem_text_add(to,
                     blank(text, done, line_end(text, done)) ? "    // dem plan: %s; it was %s"
                                                             : " /* dem plan: %s; it was %s */",
                     why, effect);
    }
    dem_text_add(to, "%s", text + done);
    return n;
}

/* Comments out line by line, so that comments inside remain valid. The first line keeps its
   indentation. */
static void comment_out(struct dem_text *to, const char *text, struct position p, size_t start)
{
    copy(to, text, start, p.name);
    for (size_t at = p.name, end; at < p.end; at = end + 1)
    {
        end = line_end(text, at);
        end = end < p.end ? end : p.end;
        dem_text_add(to, "// ");
        copy(to, text, at, end);
        dem_text_add(to, end < p.end ? "\n" : "");
    }
}

int dem_edit_comment_out(struct dem_text *to, const char *text, const char *effect, const char *why)
{
    struct position position[MAX_POSITIONS];
    const int n = find(text, effect, 0, position);
    size_t done = 0;

    for (int k = 0; k < n; k++)
    {
        const size_t start = line_start(text, position[k].name);
        const int first = start >= done && blank(text, start, position[k].name);

        copy(to, text, done, position[k].name);
        dem_text_add(to,
                     first ? "// dem plan: without %s: %s\n"
                           : "\n    // dem plan: without %s: %s\n    ",
                     effect, why);
        comment_out(to, text, position[k], first ? start : position[k].name);
        done = position[k].end;
        dem_text_add(to, blank(text, done, line_end(text, done)) ? "" : "\n");
    }
    dem_text_add(to, "%s", text + done);
    return n;
}
