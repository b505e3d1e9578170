/*
 * edit.c -- edits of a scene's text: dictionaries are found by their braces, comments and strings stepped over.
 *
 * An effect stands in `effects { WORD { } }` and with other settings in `pairs { NAME { WORD { } } }`: both are edited. What else is in the
 * text stays as it is, byte by byte.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "plan/rewrite.h"
#include <string.h>

enum
{
    DEPTH = 64, MOST_PLACES = 64
};

struct place                                              /* of `WORD { ... }` in the text */
{
    size_t name, name_end, end;                           /* end: behind the closing brace */
};

struct walk
{
    const char *text;
    size_t at;
    struct place open[DEPTH];
    int depth;
    size_t word, word_end;                                /* the last one; equal: none since the last sign */
};

/* ---- finding --------------------------------------------------------------------------------------------------- */

static size_t line_end(const char *text, size_t at)
{
    return at + strcspn(text + at, "\n");
}

/* Behind a comment or string that begins here; `at` where none does. */
static size_t behind(const char *text, size_t at)
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
    while (w->text[w->at] && !strchr(" \t\r\n\f\v{};\"", w->text[w->at]) && behind(w->text, w->at) == w->at)
    {
        w->at++;
    }
    w->word_end = w->at;
}

/* On to the end of the next dictionary: 1, and it is open[depth], which the caller may look at; 0 at the end of the text. */
static int next_closed(struct walk *w)
{
    while (w->text[w->at])
    {
        const char sign = w->text[w->at];
        const size_t over = behind(w->text, w->at);

        if (over > w->at)
        {
            w->at = over;
        }
        else if (sign == '{')
        {
            if (w->depth < DEPTH)
            {
                w->open[w->depth] = (struct place){w->word, w->word_end, 0};
            }
            w->depth++;
            w->word = w->word_end = ++w->at;
        }
        else if (sign == '}')
        {
            w->word = w->word_end = ++w->at;
            w->depth -= w->depth > 0;
            if (w->depth < DEPTH)
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

static int is(const char *text, struct place p, const char *word)
{
    return p.name_end - p.name == strlen(word) && memcmp(text + p.name, word, strlen(word)) == 0;
}

/* Where the effect has its settings, in the order of the text. */
static int find(const char *text, const char *effect, struct place place[MOST_PLACES])
{
    struct walk w = {.text = text};
    int n = 0;

    while (next_closed(&w))
    {
        const int for_all = w.depth == 1 && is(text, w.open[0], "effects"), for_pair = w.depth == 2 && is(text, w.open[0], "pairs");

        if ((for_all || for_pair) && is(text, w.open[w.depth], effect) && n < MOST_PLACES)
        {
            place[n++] = w.open[w.depth];
        }
    }
    return n;
}

/* The last dictionary of that name at the top; 0: there is none. */
static int find_top(const char *text, const char *name, struct place *top)
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

/* Where the line of this place begins. */
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
    struct place top;

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

int dem_edit_rename(struct dem_text *to, const char *text, const char *effect, const char *other, const char *why)
{
    struct place place[MOST_PLACES];
    const int n = find(text, effect, place);
    size_t done = 0;

    for (int k = 0; k < n; k++)
    {
        copy(to, text, done, place[k].name);
        dem_text_add(to, "%s", other);
        copy(to, text, place[k].name_end, place[k].end);
        done = place[k].end;
        dem_text_add(to, blank(text, done, line_end(text, done)) ? "    // dem plan: %s; it was %s" : " /* dem plan: %s; it was %s */", why, effect);
    }
    dem_text_add(to, "%s", text + done);
    return n;
}

/* Line by line, so that comments in it stay what they are. The first one stands as far in as the text did. */
static void comment_out(struct dem_text *to, const char *text, struct place p, size_t start)
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

int dem_edit_leave_out(struct dem_text *to, const char *text, const char *effect, const char *why)
{
    struct place place[MOST_PLACES];
    const int n = find(text, effect, place);
    size_t done = 0;

    for (int k = 0; k < n; k++)
    {
        const size_t start = line_start(text, place[k].name);
        const int first = start >= done && blank(text, start, place[k].name);

        copy(to, text, done, place[k].name);
        dem_text_add(to, first ? "// dem plan: without %s: %s\n" : "\n    // dem plan: without %s: %s\n    ", effect, why);
        comment_out(to, text, place[k], first ? start : place[k].name);
        done = place[k].end;
        dem_text_add(to, blank(text, done, line_end(text, done)) ? "" : "\n");
    }
    dem_text_add(to, "%s", text + done);
    return n;
}
