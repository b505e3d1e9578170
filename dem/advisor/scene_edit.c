/*
 * scene_edit.c -- edits of the text of a scene: finds dictionaries by their braces.
 *
 * Comments and strings are skipped. An effect is in `effects { WORD { } }` and with other settings
 * in `pairs { NAME { WORD { } } }`: both are edited. All other text stays the same, byte by byte.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "advisor/plan_rewrite.h"
#include <string.h>

enum
{
    MAX_DEPTH = 64, MAX_POSITIONS = 64
};

/* position of `WORD { ... }` in the text */
struct position
{
    size_t name, name_end, end;                           /* end: after the closing brace */
};

struct walk
{
    const char *text;
    size_t at;
    struct position open[MAX_DEPTH];
    int depth;
    /* the last word; equal: none since the last brace or semicolon */
    size_t word, word_end;
};

/* ---- finding --------------------------------------------------------------------------------------------------- */

static size_t line_end(const char *text, size_t at)
{
    return at + strcspn(text + at, "\n");
}

/* End of the comment or string that begins at `at`; `at` if none does. */
static size_t after_comment(const char *text, size_t at)
{
    if (text[at] == '/' && text[at + 1] == '/')
    {
        return line_end(text, at);
    }
    if (text[at] == '/' && text[at + 1] == '*')
    {
        const char *const close = strstr(text + at + 2, "*/");

        return close ? (size_t)(close + 2 - text) : at + strlen(text + at);
    }
    if (text[at] == '"')
    {
        for (at++; text[at] && text[at] != '"'; at++)
        {
            at += text[at] == '\\' && text[at + 1];
        }
        return at + (text[at] == '"');
    }
    return at;
}

static void take_word(struct walk *w)
{
    w->word = w->at;
    while (w->text[w->at] && !strchr(" \t\r\n\f\v{};\"", w->text[w->at]) &&
           after_comment(w->text, w->at) == w->at)
    {
        w->at++;
    }
    w->word_end = w->at;
}

/* Moves on to the end of the next dictionary. Returns 1, and the dictionary is open[depth]; 0 at
   the end of the text. */
static int next_closed(struct walk *w)
{
    while (w->text[w->at])
    {
        const char sign = w->text[w->at];
        const size_t over = after_comment(w->text, w->at);

        if (over > w->at)
        {
            w->at = over;
        }
        else if (sign == '{')
        {
            if (w->depth < MAX_DEPTH)
            {
                w->open[w->depth] = (struct position){w->word, w->word_end, 0};
            }
            w->depth++;
            w->word = w->word_end = ++w->at;
        }
        else if (sign == '}')
        {
            w->word = w->word_end = ++w->at;
            w->depth -= w->depth > 0;
            if (w->depth < MAX_DEPTH)
            {
                w->open[w->depth].end = w->at;
                return 1;
            }
        }
        else if (sign == ';')
        {
            w->word = w->word_end = ++w->at;
        }
        else if (strchr(" \t\r\n\f\v", sign))
        {
            w->at++;
        }
        else
        {
            take_word(w);
        }
    }
    return 0;
}

static int is(const char *text, struct position p, const char *word)
{
    return p.name_end - p.name == strlen(word) && memcmp(text + p.name, word, strlen(word)) == 0;
}

/* The dictionaries of an effect, in the order of the text; returns their number. */
static int find(const char *text, const char *effect, struct position position[MAX_POSITIONS])
{
    struct walk w = {.text = text};
    int n = 0;

    while (next_closed(&w))
    {
        const int for_all = w.depth == 1 && is(text, w.open[0], "effects"),
                  for_pair = w.depth == 2 && is(text, w.open[0], "pairs");

        if ((for_all || for_pair) && is(text, w.open[w.depth], effect) && n < MAX_POSITIONS)
        {
            position[n++] = w.open[w.depth];
        }
    }
    return n;
}

/* The last top-level dictionary of that name; returns 0 if there is none. */
static int find_top(const char *text, const char *name, struct position *top)
{
    struct walk w = {.text = text};
    int found = 0;

    while (next_closed(&w))
    {
        if (w.depth == 0 && is(text, w.open[0], name))
        {
            *top = w.open[0];
            found = 1;
        }
    }
    return found;
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
    struct position top;

    if (!find_top(text, "effects", &top))
    {
        dem_text_add(to, "%s\neffects\n{\n    %s {}    // dem plan: %s\n}\n", text, effect, why);
        return 1;
    }
    const size_t brace = top.end - 1, start = line_start(text, brace);
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
    const int n = find(text, effect, position);
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
    const int n = find(text, effect, position);
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
